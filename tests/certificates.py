"""Every certificate of the reports, run with SymPy: it prints zeros, and no longer does when its claim is edited.

Usage: python tests/certificates.py FOLDER [MOST SECONDS]. Exit code 1 if a certificate does not prove what it says, or proves
something else as well.
"""

import ast
import contextlib
import io
import pathlib
import sys
import time


def equations(path):
    """The function that checks, and the arguments of each equation."""
    tree = ast.parse(path.read_text())
    calls = [n.value for n in tree.body if isinstance(n, ast.Expr) and isinstance(n.value, ast.Call)]
    calls = [c for c in calls if getattr(c.func, "id", "") == "check"]
    tree.body = [n for n in tree.body if not (isinstance(n, ast.Expr) and getattr(n, "value", None) in calls)]
    room = {"__name__": "certificate"}
    exec(compile(tree, str(path), "exec"), room)
    return room["check"], [{k.arg: ast.literal_eval(k.value) for k in c.keywords} for c in calls]


def holds(check, arguments):
    """Whether the program ends well, printing one 0."""
    out = io.StringIO()
    try:
        with contextlib.redirect_stdout(out):
            check(**arguments)
    except SystemExit as end:
        return not end.code
    except (ValueError, ZeroDivisionError):
        return False
    return out.getvalue() == "0\n"


def edits(arguments):
    """Other claims, each false wherever the claim is true."""
    left, right = arguments["left"], arguments["right"]
    yield {**arguments, "right": f"({right}) + 1"}
    yield {**arguments, "left": f"({left}) - 1/1000"}
    yield {**arguments, "right": f"({left}) - 7"}
    if arguments["names"]:
        # A name that is defined would do, too; the first is a variable of the polynomials.
        yield {**arguments, "left": f"({left}) + {arguments['names'][0]}**2 + 1"}


def main():
    folder = pathlib.Path(sys.argv[1])
    most = float(sys.argv[2]) if len(sys.argv) > 2 else float("inf")
    started, files, found, edited, wrong = time.time(), 0, 0, 0, []
    for path in sorted(folder.rglob("certificates/*.py")):
        check, all_equations = equations(path)
        files += 1
        if not all_equations:
            wrong.append(f"{path}: no equation")
        for at, arguments in enumerate(all_equations):
            if time.time() - started > most:
                break
            found += 1
            if not holds(check, arguments):
                wrong.append(f"{path}, equation {at + 1}: does not print 0")
            for other in edits(arguments):
                edited += 1
                if holds(check, other):
                    wrong.append(f"{path}, equation {at + 1}: prints 0 for {other['left']} = {other['right']}, too")
    print(f"{files} files, {found} equations, {edited} edits, {time.time() - started:.0f} s")
    if not found:
        wrong.append("there is no certificate")
    for line in wrong:
        print(line)
    sys.exit(bool(wrong))


main()

"""Reports, results and proofs as people see them: text, and HTML for notebooks.

The HTML is one piece, needs no network and no script, and follows the colours of the notebook, light or dark. Nothing of a
file acts in it: every text is escaped.
"""

from __future__ import annotations

import html
import math
from typing import TYPE_CHECKING, Callable, Iterable, Optional

if TYPE_CHECKING:
    from .paper import Lint, Relation
    from .proof import Proof
    from .report import Correction, Report, Result, Rows, Side, Witness

SHOWN = 12
"""The most curves, and the most columns of a matrix."""
# The words of a paper as the style has them.
TONE = {"follows_proved": "holds", "holds_in_numbers": "holds", "wrong_refuted_by_a_point": "fails", "not_followed": "undecided"}
MARK = {"holds": "H", "fails": "F", "not-applicable": "–", "undecided": "?"}

STYLE = """<style>
.rederive{--hold:#1a7f37;--fail:#c4321c;--open:#9a6700;--quiet:#6e7781;--line:#8884;font-size:.95em}
@media (prefers-color-scheme:dark){.rederive{--hold:#4ac26b;--fail:#ff7b72;--open:#d4a72c;--quiet:#9198a1}}
[data-jp-theme-light=true] .rederive{--hold:#1a7f37;--fail:#c4321c;--open:#9a6700;--quiet:#6e7781}
[data-jp-theme-light=false] .rederive{--hold:#4ac26b;--fail:#ff7b72;--open:#d4a72c;--quiet:#9198a1}
.rederive table{border-collapse:collapse;margin:.5em 0}.rederive td,.rederive th{text-align:left;padding:.15em .6em;border-bottom:1px solid var(--line)}
.rederive .holds,.rederive .proved{color:var(--hold)}.rederive .fails,.rederive .refuted{color:var(--fail)}
.rederive .undecided,.rederive .except{color:var(--open)}.rederive .not-applicable,.rederive .quiet{color:var(--quiet)}
.rederive .wrong{font-weight:bold;text-decoration:underline}.rederive svg{display:block}.rederive pre{margin:.3em 0;white-space:pre-wrap}
</style>"""


def _page(body: str) -> str:
    return f'{STYLE}<div class="rederive">{body}</div>'


def _number(x: Side) -> str:
    if x is None:
        return "no value"
    return f"[{x[0]:.9g}, {x[1]:.9g}]" if isinstance(x, tuple) else f"{x:.12g}"


def _on(result: Result) -> str:
    if result.family is not None:
        return f"{result.claim} on the family {result.family}"
    return f"{result.claim} on {result.trajectory}" if result.trajectory is not None else f"{result.claim} over its ranges"


def _said(result: Result) -> str:
    return str(result.verdict) + (f" ({result.strength})" if result.strength is not None else "")


def witness_text(witness: Witness) -> str:
    """A point with both sides, as the command line shows it."""
    at = "" if witness.t is None else f" at t = {witness.t:.10g}"
    lines = [f"{witness.formula}{at}", f"  left   {_number(witness.left)}", f"  right  {_number(witness.right)}"]
    if isinstance(witness.left, float) and isinstance(witness.right, float) and witness.bound is not None:
        lines.append(f"  difference {abs(witness.left - witness.right):.2g}, error bound {witness.bound:.2g}")
    if witness.values:
        lines.append("  at " + "; ".join(f"{name} = {value:.12g}" for name, value in witness.values.items()))
    return "\n".join(lines)


def correction_text(correction: Correction) -> str:
    """What holds instead of a formula, how it is known, and what was edited."""
    on = f", holds on {correction.holds_on} {'trajectory' if correction.holds_on == 1 else 'trajectories'}" if correction.holds_on else ""
    return f"holds instead: {correction.formula}, {correction.strength}{on} ({', '.join(correction.edits)})"


def result_text(result: Result) -> str:
    """What was found of one claim on one motion."""
    lines = [f"{_on(result)}: {_said(result)}"]
    if result.unexpected:
        lines[0] += f", expected: {result.expected}" if result.expected is not None else ", which nothing expects"
    if result.reason:
        lines.append(f"  {result.reason}")
    if (m := result.members) is not None:
        lines.append(f"  of {m.count} members {m.holds} hold, {m.fails} fail, {m.not_applicable} do not apply, {m.undecided} undecided")
    if result.witness is not None:
        lines += ["  " + line for line in witness_text(result.witness).splitlines()]
    return "\n".join(lines)


def report_text(report: Report) -> str:
    """The title, what is not as expected, and how much there is of each."""
    s = report.summary
    lines = [report.title, ""]
    lines += [line for result in report.unexpected for line in (result_text(result), "")]
    lines.append(f"{s.holds} hold, {s.fails} fail, {s.not_applicable} do not apply, {s.undecided} undecided")
    lines.append(f"{s.unexpected} not as expected")
    return "\n".join(lines)


def _span(word: str, text: str, more: str = "") -> str:
    return f'<span class="{html.escape(word)} {more}">{html.escape(text)}</span>'


def _matrix(report: Report) -> str:
    motions: list[Optional[str]] = []
    for result in report.results:
        if result.on not in motions:
            motions.append(result.on)
    shown = motions[:SHOWN]
    head = "".join(f"<th>{html.escape(m or 'ranges')}</th>" for m in shown)
    rows = []
    for claim in report.claims:
        found = {result.on: result for result in claim.results}
        cells = []
        for motion in shown:
            if motion not in found:
                cells.append("<td></td>")
                continue
            result = found[motion]
            word = str(result.verdict)
            title = html.escape(result_text(result), quote=True)
            wrong = "wrong" if result.unexpected else ""
            cells.append(f'<td title="{title}">{_span(word, MARK[word], wrong)}</td>')
        rows.append(f"<tr><td>{html.escape(claim.name)}</td><td>{html.escape(claim.says)}</td>{''.join(cells)}</tr>")
    more = f'<p class="quiet">and {len(motions) - SHOWN} more motions</p>' if len(motions) > SHOWN else ""
    key = '<p class="quiet">H holds, F fails, – does not apply, ? undecided; underlined: not as expected</p>'
    return f"<table><tr><th>claim</th><th>says</th>{head}</tr>{''.join(rows)}</table>{more}{key}"


def _curve(rows: list[list[float]]) -> str:
    """Both sides along a motion, with axes."""
    width, height, left_edge, foot = 380.0, 150.0, 64.0, 22.0
    points = [(t, left, right) for t, left, right, *_ in rows if all(map(math.isfinite, (t, left, right)))]
    if len(points) < 2:
        return ""
    times = [t for t, _, _ in points]
    values = [v for _, left, right in points for v in (left, right)]
    low, high = min(values), max(values)
    flat = high - low <= 1e-12 * max(abs(low), abs(high), 1e-300)
    low, high = (low - 1, high + 1) if flat else (low, high)
    across, down = width - left_edge - 8, height - foot - 8

    def line(column: int, style: str) -> str:
        x = [left_edge + across * (t - times[0]) / ((times[-1] - times[0]) or 1) for t in times]
        y = [8 + down * (high - point[column]) / (high - low) for point in points]
        path = " ".join(f"{a:.1f},{b:.1f}" for a, b in zip(x, y))
        return f'<polyline points="{path}" fill="none" {style}/>'

    def text(x: float, y: float, anchor: str, words: str) -> str:
        return f'<text x="{x:.0f}" y="{y:.0f}" text-anchor="{anchor}" font-size="11" fill="currentColor">{words}</text>'

    left = line(1, 'stroke="currentColor" stroke-width="1.5"')
    right = line(2, 'stroke="var(--fail)" stroke-width="1.5" stroke-dasharray="5 3"')
    axes = f'<path d="M{left_edge:.0f} 8V{8 + down:.0f}H{width - 8:.0f}" fill="none" stroke="var(--quiet)"/>'
    below, beside = height - 6, left_edge - 5
    axes += text(left_edge, below, "middle", f"{times[0]:.4g}") + text(width - 8, below, "end", f"{times[-1]:.4g}")
    axes += text(left_edge + across / 2, below, "middle", "t")
    axes += text(beside, 16, "end", f"{high:.4g}") + text(beside, 8 + down, "end", f"{low:.4g}")
    return (
        f'<svg viewBox="0 0 {width:.0f} {height:.0f}" width="{width:.0f}" height="{height:.0f}" role="img" '
        f'aria-label="left side and right side from t = {times[0]:.6g} to {times[-1]:.6g}, values from {low:.6g} to {high:.6g}">'
        f"{axes}{left}{right}</svg>"
    )


def report_html(report: Report, rows: Callable[[str, str], Rows]) -> str:
    """The matrix of verdicts, then what is not as expected, with curves."""
    body = [f"<b>{html.escape(report.title)}</b>", _matrix(report)]
    for result in report.unexpected[:SHOWN]:
        body.append(f"<pre>{html.escape(result_text(result))}</pre>")
        try:
            picture = _curve(rows(result.claim, result.trajectory)[1]) if result.trajectory is not None else ""
        except KeyError:
            picture = ""
        if picture:
            body.append(picture + '<p class="quiet">left side, and dashed the right side, along the motion</p>')
    s = report.summary
    body.append(
        f"<p>{s.holds} hold, {s.fails} fail, {s.not_applicable} do not apply, {s.undecided} undecided; "
        f"{s.unexpected} not as expected</p>"
    )
    return _page("".join(body))


def result_html(result: Result) -> str:
    """One verdict."""
    return _page(f'<pre class="{result.verdict}">{html.escape(result_text(result))}</pre>')


def latex(formula: str) -> str:
    """LaTeX as notebooks typeset it: what could end the formula, or act in a page, is taken out."""
    return f"$\\displaystyle {formula.replace('$', '')}$"


def _formula(proof: Proof) -> str:
    """The formula as it was read; as it is written, where it was not."""
    return proof.mathml or f"<code>{html.escape(proof.formula)}</code>"


def proof_html(proof: Proof) -> str:
    """The verdict, the formula and what the proof needs."""
    body = [f"<p>{_span(str(proof.verdict).split()[-1], str(proof.verdict), 'wrong')}: {_formula(proof)}</p>"]
    body.append(f'<pre class="quiet">{html.escape(proof.text)}</pre>')
    return _page("".join(body))


def proofs_html(proofs: Iterable[Proof]) -> str:
    """A row for each formula, with the point at which it fails, or why it is open."""

    def row(proof: Proof) -> str:
        found = proof.counterexample
        point = ", ".join(f"{name} = {value}" for name, value in found.point.items()) if found else ""
        more = f"{point}: {found.left} ≠ {found.right}" if found else "; ".join(proof.exceptions) or proof.reason or ""
        verdict = _span(str(proof.verdict).split()[-1], str(proof.verdict))
        return f"<tr><td>{verdict}</td><td>{_formula(proof)}</td><td>{html.escape(more)}</td></tr>"

    return _page(f"<table><tr><th>verdict</th><th>formula</th><th>but</th></tr>{''.join(map(row, proofs))}</table>")


def lint_words(lint: Lint) -> str:
    """How often each word is said."""
    return ", ".join(f"{count} {word}" for word, count in lint.words.items() if count) or "no formula"


def _why(relation: Relation) -> str:
    return relation.message or relation.why


def lint_text(lint: Lint) -> str:
    """A line for each relation; under a wrong one what holds."""
    lines = []
    for one in lint:
        lines.append(f"{one.line:6}  {one.verdict:24}  {one.formula}" + (f" ({_why(one)})" if _why(one) else ""))
        if one.instead is not None:
            lines.append(f"{'':34}holds, and is proved: {one.instead}")
    return "\n".join([*lines, lint_words(lint)])


def lint_html(lint: Lint) -> str:
    """A row for each relation; what a browser typesets is made by the library, and nothing of a text acts in it."""

    def row(one: Relation) -> str:
        tone = TONE.get(one.verdict, "quiet")
        holds = f"<br>holds, and is proved: <code>{html.escape(one.instead)}</code>" if one.instead is not None else ""
        verdict = _span(tone, one.verdict.replace("_", " "), "wrong" if tone == "fails" else "")
        return f"<tr><td>{one.line}</td><td>{verdict}</td><td>{one.markup}</td><td>{html.escape(_why(one))}{holds}</td></tr>"

    head = "<tr><th>line</th><th>verdict</th><th>formula</th><th>why</th></tr>"
    return _page(f"<b>{html.escape(lint.name)}</b><table>{head}{''.join(map(row, lint))}</table><p>{html.escape(lint_words(lint))}</p>")

"""Proofs: of texts and of expressions of SymPy."""

import pickle
from typing import Any

import pytest

import rederive
from rederive import Decision


def test_an_identity_is_proved() -> None:
    proof = rederive.prove(r"\sin 2x=2\sin x\cos x", symbols=["x"], given=[])
    assert proof.verdict is Decision.PROVED and proof.counterexample is None
    assert "proved" in str(proof) and "proved" in proof._repr_html_()
    assert pickle.loads(pickle.dumps(proof)) == proof == rederive.prove(r"\sin 2x=2\sin x\cos x", "x")
    with pytest.raises(TypeError, match="neither true nor false"):
        bool(proof)


def test_a_mistake_is_refuted() -> None:
    proof = rederive.prove(r"\sqrt{x^2}=x", symbols="x")
    assert proof.verdict is Decision.REFUTED and proof.counterexample is not None
    assert proof.counterexample.point["x"].startswith("-"), proof.counterexample
    assert rederive.prove(r"\sqrt{x^2}=x", "x", given=["x>0"]).verdict is Decision.PROVED


def test_problems_have_places_and_hints() -> None:
    with pytest.raises(rederive.DerivationError) as e:
        rederive.prove(r"\sin x=y", symbols=["x"])
    problem = e.value.problems[0]
    assert problem.code == "latex::unknown-symbol" and (problem.line, problem.column) == (1, 8)
    assert problem.text.splitlines()[-3].strip(" |") == "^" or "^" in problem.text
    assert problem.hint is not None and "symbols=" in problem.hint and "symbols=" in str(e.value)


def test_expressions_of_sympy_are_walked() -> None:
    sympy = pytest.importorskip("sympy")
    x, y = sympy.symbols("x y", real=True)
    a = sympy.Symbol("alpha_1", positive=True)
    identities = [
        sympy.Eq(sympy.sin(2 * x), 2 * sympy.sin(x) * sympy.cos(x)),
        sympy.Eq((x + y) ** 3, sympy.expand((x + y) ** 3)),
        sympy.Eq(sympy.cos(2 * x), 1 - 2 * sympy.sin(x) ** 2),
        sympy.Eq((x**2 - y**2) / (x - y), x + y),
        sympy.Eq(a ** sympy.Rational(3, 2), a * sympy.sqrt(a), evaluate=False),
        sympy.Eq(1 / (x * sympy.sqrt(a)), a ** sympy.Rational(-1, 2) / x, evaluate=False),
        sympy.Eq(-x / 2 + sympy.Rational(2, 3) - sympy.pi, (4 - 3 * x) / 6 - sympy.pi, evaluate=False),
        sympy.Eq(sympy.tanh(x), (sympy.exp(x) - sympy.exp(-x)) / (sympy.exp(x) + sympy.exp(-x))),
        sympy.Eq(sympy.Abs(x) ** 2, x**2, evaluate=False),
    ]
    for identity in identities:
        proof = rederive.prove(identity)
        assert proof.verdict in (Decision.PROVED, Decision.PROVED_EXCEPT), (identity, proof.formula, proof.text)
        broken = sympy.Eq(identity.lhs, identity.rhs + sympy.Rational(1, 7), evaluate=False)
        assert rederive.prove(broken).verdict is Decision.REFUTED, broken


def test_what_sympy_has_rewritten_is_refused() -> None:
    sympy = pytest.importorskip("sympy")
    x, a = sympy.Symbol("x"), sympy.Symbol("a", positive=True)
    z = sympy.Symbol("z", imaginary=True)
    for wrong, words in [
        (sympy.Eq(x, x), "evaluate=False"),
        (sympy.Eq(sympy.gamma(x), x), "gamma"),
        (sympy.Eq(sympy.Symbol("foo"), x), "latex="),
        (sympy.Eq(sympy.Symbol("a_b_c"), x), "two underscores"),
        (sympy.Eq(z, x), "not real"),
        (sympy.Eq(sympy.Integral(x, x), x), "Integral"),
    ]:
        with pytest.raises(rederive.NoCounterpart, match=words):
            rederive.prove(wrong)
    assert rederive.prove(sympy.Eq(sympy.sqrt(a**2), a, evaluate=False)).verdict is Decision.PROVED


def test_assumptions_are_taken_over() -> None:
    sympy = pytest.importorskip("sympy")
    free, negative = sympy.Symbol("x", real=True), sympy.Symbol("x", negative=True)
    assert rederive.prove(sympy.Eq(sympy.Abs(free), -free)).verdict is Decision.REFUTED
    proof = rederive.prove(sympy.Eq(sympy.Abs(negative), -negative, evaluate=False))
    assert proof.verdict is Decision.PROVED
    given = rederive.prove(sympy.Eq(sympy.sqrt(free**2), free, evaluate=False), given=[free > 0])
    assert given.verdict is Decision.PROVED and given.given == ("x>0",)


def test_complex_symbols_of_sympy() -> None:
    sp = pytest.importorskip("sympy")
    z, w = sp.symbols("z w", complex=True)
    x = sp.Symbol("x", real=True)
    true = [
        sp.Eq(sp.exp(sp.I * x), sp.cos(x) + sp.I * sp.sin(x), evaluate=False),
        sp.Eq(sp.Abs(z * w, evaluate=False), sp.Abs(z) * sp.Abs(w), evaluate=False),
        sp.Eq(sp.re(z) ** 2 + sp.im(z) ** 2, z * sp.conjugate(z)),
    ]
    for equation in true:
        assert rederive.prove(equation).verdict is Decision.PROVED, equation
    for equation in [sp.Eq(sp.log(z * w), sp.log(z) + sp.log(w)), sp.Eq(sp.sqrt(z * w), sp.sqrt(z) * sp.sqrt(w))]:
        proof = rederive.prove(equation)
        assert proof.verdict is Decision.REFUTED and proof.counterexample is not None
    amplitude = sp.Function("c", complex=True)(sp.Symbol("t"))
    rabi = rederive.Derivation("Rabi", concerns="A textbook of quantum mechanics").symbol(amplitude)
    assert rabi.data["symbols"]["c"] == {"role": "state", "complex": True}
    with pytest.raises(rederive.NoCounterpart, match="not real"):
        rederive.prove(sp.Eq(sp.Symbol("y", imaginary=True), z))


def test_functions_of_sympy_are_fields() -> None:
    sp = pytest.importorskip("sympy")
    x, y, t = sp.symbols("x y t", real=True)
    c = sp.Symbol("c", positive=True)
    f, g = sp.Function("f", real=True), sp.Function("g", real=True)
    u, psi = g(x, t), sp.Function("psi", complex=True)(x, t)
    d = sp.Derivative
    transport = sp.Eq(d(u, t), c * d(u, x))
    held = sp.Eq(g(0, t), 0)
    true: list[tuple[object, list[Any]]] = [
        (sp.Eq(d(u, t, t), c**2 * d(u, x, x)), [transport]),
        (sp.Eq(d(f(x - c * t), t), -c * d(f(x - c * t), x)), []),
        (sp.Eq(d(f(x - c * t), t).doit(), -c * d(f(x - c * t), x).doit(), evaluate=False), []),
        (sp.Eq(d(x * u, x), u + x * d(u, x)), []),
        (sp.Eq(d(u, x, 2, t), d(u, t, x, x), evaluate=False), []),
        (sp.Eq(d(u, t).subs(x, 0), 0), [held]),
        (sp.Eq(d(psi * sp.conjugate(psi), x), psi * d(sp.conjugate(psi), x) + sp.conjugate(psi) * d(psi, x)), []),
        (sp.Eq(d(sp.sin(c * x), x), c * sp.cos(c * x)), []),
        (sp.Eq(d(f(t) ** 2, t), 2 * f(t) * d(f(t), t)), []),
        (sp.Eq(d(g(x + y, t), x), d(g(x + y, t), y)), []),
    ]
    for equation, given in true:
        proof = rederive.prove(equation, given=given)
        assert proof.verdict in (Decision.PROVED, Decision.PROVED_UNREPLAYED), (equation, proof.formula, proof.text)
    false: list[tuple[object, list[Any]]] = [
        (sp.Eq(d(u, t, t), -(c**2) * d(u, x, x)), [transport]),
        (sp.Eq(d(u, x), d(u, t)), []),
        (sp.Eq(d(x * u, x), x * d(u, x)), []),
        (sp.Eq(g(t, x), g(x, t)), []),
        (sp.Eq(d(u, x).subs(x, y**2), 0), []),
    ]
    for equation, given in false:
        assert rederive.prove(equation, given=given).verdict is Decision.REFUTED, equation
    n = sp.Symbol("n", integer=True, positive=True)
    for wrong, words in [
        (sp.Eq(d(u, (x, n)), 0), "order"),
        (sp.Eq(d(f(x) ** 2, f(x)), f(x)), "by functions"),
        (sp.Eq(f(x) + f(x, t), 0), "arguments"),
    ]:
        with pytest.raises(rederive.NoCounterpart, match=words):
            rederive.prove(wrong)


def test_what_is_no_formula() -> None:
    sp = pytest.importorskip("sympy")
    x = sp.Symbol("x")
    with pytest.raises(TypeError, match="Eq"):
        rederive.prove(x + x == 2 * x)
    with pytest.raises(TypeError, match="text in LaTeX"):
        rederive.prove(3)


def test_names_as_sympy_spells_them() -> None:
    sp = pytest.importorskip("sympy")
    hbar, lamda = sp.symbols("hbar lamda")
    assert rederive.prove(sp.Eq(hbar * lamda, lamda * hbar, evaluate=False)).formula == r"\hbar\cdot \lambda=\hbar\cdot \lambda"


def test_what_log_is_the_configuration_says(tmp_path: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    decimal, natural = r"\log 100=2", r"\log e^x=x"
    with pytest.raises(rederive.DerivationError):
        rederive.prove(decimal)
    assert rederive.prove(natural, "x", log="natural").verdict is Decision.PROVED
    assert rederive.prove(decimal, log="natural").verdict is Decision.REFUTED
    (tmp_path / "rederive.toml").write_text('log = "decimal"\n')
    proved = (Decision.PROVED, Decision.PROVED_UNREPLAYED)
    assert rederive.prove(decimal).verdict in proved
    assert rederive.prove(decimal, log="natural").verdict is Decision.REFUTED
    assert rederive.lint(text=decimal).relations[0].verdict == "follows_proved"
    session = rederive.Session()
    assert session.prove(decimal).verdict in proved
    with pytest.raises(ValueError, match="natural"):
        rederive.prove(decimal, log="binary")
    with pytest.raises(TypeError, match="conventions"):
        rederive.Session(text="", log="natural")
    (tmp_path / "rederive.toml").write_text('log = "binary"\n')
    with pytest.raises(rederive.DerivationError):
        rederive.prove(decimal)

"""Derivations that are written in Python."""

import pickle
from pathlib import Path

import pytest

import rederive
from rederive import Derivation, Strength, Verdict


def test_files_are_read_and_written_without_loss(derivations: Path) -> None:
    files = sorted(derivations.glob("*.toml"))
    assert len(files) >= 3
    for file in files:
        read = Derivation.from_toml(file.read_text(encoding="utf-8"))
        again = Derivation.from_toml(read.to_toml())
        assert again == read and again.data == read.data and hash(again) == hash(read), file
        assert list(again.data) == list(read.data)
        # The program reads both alike.
        assert rederive.Session(read).pairs == rederive.Session(file).pairs


def test_every_text_survives() -> None:
    for text in ["a'b", 'a"b', "a\nb", "\nb", "'''", "a'", "tab\t", "nul\x00", "\\", "", "é\r\n", "'''\"\\"]:
        made = Derivation("t").convention("x", text).convention(text or "empty", "y")
        assert Derivation.from_toml(made.to_toml()) == made, repr(text)
    numbers = [0.1, -3, 1e-300, 1e22, True, [1, 2.5, "x"], {"a b": {"c": 1}}]
    made = Derivation("t").table("measure", id="m", values=numbers)
    assert Derivation.from_toml(made.to_toml()) == made
    with pytest.raises(TypeError, match="object"):
        Derivation("t", remark=object()).to_toml()


def test_a_pendulum_in_latex() -> None:
    made = (
        Derivation("A pendulum", "A textbook")
        .symbol("t", "time")
        .symbol(r"\omega", positive=True)
        .symbol("q", "state")
        .system("pendulum", "q", r"\ddot q=-\omega^2\sin q")
        .trajectory("wide", system="pendulum", parameters={r"\omega": 1.3}, initial={"q": 2, r"\dot q": 0}, span=[0, 5])
        .claim("energy", "The energy does not change", first_integral=r"\frac12\dot q^2-\omega^2\cos q")
        .claim("small", "It is harmonic", always=r"\ddot q=-\omega^2q", expect="fails")
        .reading("x", "in words", always=["q<4"])
    )
    report = rederive.check(made)
    assert report["energy", "wide"].verdict is Verdict.HOLDS and report["energy", "wide"].strength is not Strength.SAMPLED
    assert report["small/x", "wide"].verdict is Verdict.HOLDS
    assert pickle.loads(pickle.dumps(made)) == made
    with pytest.raises(ValueError, match="claim before it"):
        Derivation("t").reading("x", "y")


def test_fields() -> None:
    wave = r"\frac{\partial^2u}{\partial t^2}=c^2\frac{\partial^2u}{\partial x^2}"
    made = (
        Derivation("A string", "A textbook")
        .symbol("t", "time")
        .symbol("x", "coordinate")
        .symbol("c", positive=True)
        .symbol("u(x,t)", "field")
        .system("string", None, wave, fields=["u"])
        .table("domain", id="runs", ranges={"x": [-1, 1], "t": [0, 1], "c": 2, "u": r"\sin(x-ct)"})
        .claim("runs", "It runs", domain="runs", always=wave)
        .claim("slope", "So does its slope", follows_from=["string"], always=r"u_{xtt}=c^2u_{xxx}")
        .claim("wrong", "It rests", follows_from=["string"], always="u_t=0", expect="fails")
    )
    found = {r.claim: (r.verdict, r.strength) for r in rederive.check(made).results}
    assert found["runs"] == found["slope"] == (Verdict.HOLDS, Strength.PROVED)
    assert found["wrong"][0] is Verdict.FAILS and found["wrong"][1] is not Strength.SAMPLED
    assert rederive.prove("u_{xt}=u_{tx}", symbols=["u(x,t): field"]).verdict.value == "proved"
    assert Derivation.from_toml(made.to_toml()) == made


def test_a_pendulum_in_sympy() -> None:
    sympy = pytest.importorskip("sympy")
    t = sympy.Symbol("t")
    omega = sympy.Symbol("omega_0", positive=True)
    q = sympy.Function("q")(t)
    rate = q.diff(t)
    energy = rate**2 / 2 - omega**2 * sympy.cos(q)
    made = Derivation("A pendulum").symbol("t", "time").symbol(omega).symbol(q)
    made.system("pendulum", q, sympy.Eq(q.diff(t, 2), -(omega**2) * sympy.sin(q)))
    made.trajectory("wide", system="pendulum", parameters={omega: 1.3}, initial={q: 2, rate: 0}, span=[0, 5])
    made.claim("energy", "The energy does not change", first_integral=energy)
    made.claim("start", "as it was", always=sympy.Eq(energy, energy.subs(q, q.func(0)).subs(q.func(0).diff(t), 0), evaluate=False))
    made.claim("wrong", "It is harmonic", always=sympy.Eq(q.diff(t, 2), -(omega**2) * q), expect="fails")
    assert made.data["symbols"][r"\omega_0"] == {"role": "parameter", "positive": True}
    assert made.data["symbols"]["q"] == {"role": "state"}
    assert made.data["trajectory"][0]["initial"] == {"q": 2, r"\dot{q}": 0}
    report = rederive.check(made, claims=["energy", "wrong"])
    assert report["energy", "wide"].verdict is Verdict.HOLDS and report["wrong", "wide"].verdict is Verdict.FAILS
    with pytest.raises(rederive.NoCounterpart, match="not declared"):
        made.claim("x", "y", always=sympy.Eq(sympy.Symbol("k"), 1))
    with pytest.raises(rederive.NoCounterpart, match="another `latex=`"):
        made.symbol(sympy.Symbol("omega_0"))
    assert made.symbol(sympy.Symbol("foo"), latex="F").latex(sympy.Symbol("foo") ** 2) == "F^{2}"


def test_complex_amplitudes_and_families_in_sympy() -> None:
    sp = pytest.importorskip("sympy")
    t, omega = sp.Symbol("t"), sp.Symbol("omega", positive=True)
    z = sp.Function("z", complex=True)
    rotation = (
        rederive.Derivation("A complex amplitude", concerns="A textbook")
        .symbol("t", "time")
        .symbol(omega)
        .symbol(z(t))
        .system("rotation", z(t), sp.Eq(z(t).diff(t), -sp.I * omega * z(t)))
        .trajectory("one", system="rotation", parameters={omega: 1.3}, initial={z(t): r"1+2\mathrm{i}"}, span=[0, 3])
        .table("family", id="row", of="one", vary={omega: {"from": 0.5, "to": 2, "count": 4}})
        .table("family", id="drawn", of="one", vary={omega: {"uniform": [0.5, 2]}}, draws=5, seed=3)
        .claim("size", "The size stays", trajectories="one", families=["row", "drawn"], first_integral=sp.Abs(z(t)) ** 2)
        .claim("sign", "The wrong sign", trajectories="one", families="row", always=sp.Eq(z(t), z(0) * sp.exp(sp.I * omega * t)))
    )
    report = rederive.check(rotation)
    assert [(r.claim, r.on, str(r.verdict)) for r in report.results] == [
        ("size", "one", "holds"),
        ("size", "row", "holds"),
        ("size", "drawn", "holds"),
        ("sign", "one", "fails"),
        ("sign", "row", "fails"),
    ]
    wrong = report["sign", "row"]
    assert wrong in report.unexpected and wrong.family == "row" and wrong.trajectory is None
    assert wrong.members is not None and (wrong.members.count, wrong.members.fails) == (4, 4)
    assert wrong.witness is not None and wrong.witness.left != wrong.witness.right
    assert "sign on the family row: fails" in str(report) and "of 4 members 0 hold, 4 fail" in str(report)
    drawn = report["size", "drawn"].members
    assert drawn is not None and drawn.failing_at_most is not None and 0 < drawn.failing_at_most < 1
    assert pickle.loads(pickle.dumps(report)) == report
    assert '<th>row</th>' in report._repr_html_()
    with pytest.raises(rederive.UnknownName, match="no curve of `sign` on `row`"):
        report.curve("sign", "row")
    assert rederive.Session(rotation).pairs == (("size", "one"), ("size", "row"), ("size", "drawn"), ("sign", "one"), ("sign", "row"))
    assert len(rederive.check(rotation, claims="size", trajectories="row").results) == 1


def test_words_of_python_are_keys_too() -> None:
    made = rederive.Derivation("x").trajectory("seen", from_="one", initial_time=1).claim("c", "y", rests_on="d")
    assert made.data["trajectory"] == [{"id": "seen", "from": "one", "initial-time": 1}]
    assert made.data["claim"] == [{"id": "c", "says": "y", "rests-on": ["d"]}]


def test_fields_of_sympy() -> None:
    sp = pytest.importorskip("sympy")
    x, t = sp.symbols("x t", real=True)
    c = sp.Symbol("c", positive=True)
    u = sp.Function("u", real=True)(x, t)
    made = rederive.Derivation("A string", concerns="A textbook").symbol("t", "time").symbol(x, "coordinate").symbol(c)
    made.symbol(u).system("string", None, sp.Eq(u.diff(t, 2), c**2 * u.diff(x, 2)), fields=[u])
    made.claim("flow", "What is gained has flowed", follows_from=["string"], always=sp.Eq(u.diff(t, 3), c**2 * u.diff(x, x, t)))
    assert made.data["symbols"]["u(x,t)"] == {"role": "field"}
    assert rederive.check(made).claims[0].decision is rederive.Decision.PROVED
    with pytest.raises(rederive.NoCounterpart, match="coordinate y"):
        made.symbol(sp.Function("v")(sp.Symbol("y"), t))

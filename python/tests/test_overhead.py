"""What a call costs beside the work that it asks for: under 0.2 ms.

That is the time in Python, measured with answers that are at hand, and the time to hand work to the threads of the library
and to wait for it, measured with work that ends at once. The least of many counts: other programs only add to it.
"""

import timeit
from typing import Any, Callable, Optional

import pytest

import rederive
from rederive import _rederive

BOUND = 0.2e-3
TINY = r"""
[derivation]
title = 'Growth'
concerns = 'A textbook'
[symbols]
't' = { role = 'time' }
'x' = { role = 'state' }
[system.growth]
states = ['x']
equations = ['\dot x=x']
[[trajectory]]
id = 'one'
system = 'growth'
initial = { 'x' = 1 }
span = [0, 1]
[[claim]]
id = 'equation'
says = 'It grows'
always = ['\dot x=x']
"""
EMPTY = _rederive.Session()


def least(call: Callable[[], object]) -> float:
    """Seconds."""
    return min(timeit.repeat(call, number=1, repeat=2000))


def crossing() -> float:
    """To the library and back, where nothing is to be done: without a text there are no claims."""
    return least(lambda: EMPTY.check([], [], True, True))


class Answers:
    """In the place of the library: it has every answer already."""

    def __init__(self, found: _rederive.Findings, proof: tuple[str, str, Optional[str]]) -> None:
        self.found, self.proof, self.document_ = found, proof, found.document("json")

    def check(self, *_: object) -> Any:
        return self

    def document(self, _: str) -> str:
        return self.document_

    def prove(self, *_: object) -> tuple[str, str, Optional[str]]:
        return self.proof


@pytest.fixture
def answers(monkeypatch: pytest.MonkeyPatch) -> Answers:
    read = _rederive.Session("tiny", TINY)
    proof = _rederive.Session().prove("x=x", ["x"], [], False)
    at_hand = Answers(read.check([], [], False, False), proof)

    def session(name: str = "", text: Optional[str] = None, log: Optional[str] = None) -> Answers:
        return at_hand

    monkeypatch.setattr("rederive.session._rederive.Session", session)
    return at_hand


def test_a_proof_costs_little_beside_the_work(answers: Answers) -> None:
    assert rederive.prove("x=x", "x").verdict is rederive.Decision.PROVED
    python, over = least(lambda: rederive.prove("x=x", "x")), crossing()
    print(f"prove: {1e6 * python:.0f} µs in Python, {1e6 * over:.0f} µs to the library and back")
    assert python + over < BOUND


def test_a_check_costs_little_beside_the_work(answers: Answers) -> None:
    report = rederive.check(text=TINY)
    assert report["equation", "one"].verdict is rederive.Verdict.HOLDS
    # The text is read, it is checked, and the document is written.
    python, over = least(lambda: rederive.check(text=TINY)), 3 * crossing()
    print(f"check: {1e6 * python:.0f} µs in Python, {1e6 * over:.0f} µs to the library and back")
    assert python + over < BOUND

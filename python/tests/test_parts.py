"""A family in parts: joined in any order, they say what one machine says."""

import pickle
from pathlib import Path

import pytest

import rederive


@pytest.fixture
def session(derivations: Path) -> rederive.Session:
    return rederive.Session(derivations.parent / "tests" / "corpus" / "families.toml")


def test_parts_in_any_order(session: rederive.Session) -> None:
    parts = [session.sweep("amplitudes", (k, 4)) for k in (3, 1, 4, 2)]
    found = session.merge(parts)
    assert found.json() == session.check(trajectories="amplitudes", only_verdicts=True).json()
    assert pickle.loads(pickle.dumps(found)).json() == found.json()


def test_what_is_missing_or_double_is_refused(session: rederive.Session) -> None:
    first = session.sweep("amplitudes", (1, 2))
    with pytest.raises(rederive.PartError, match="1 of the parts are missing: 2"):
        session.merge([first])
    with pytest.raises(rederive.PartError, match="given already"):
        session.merge([first, first])
    with pytest.raises(rederive.PartError, match="there is no part 3 of 2"):
        session.sweep("amplitudes", (3, 2))
    with pytest.raises(rederive.DerivationError, match="no family `gird`"):
        session.sweep("gird")

"""What is kept of a check: where, whether, and that it changes nothing."""

import hashlib
from pathlib import Path

import pytest

import rederive
from rederive import _rederive


def kept(folder: Path) -> dict[str, bytes]:
    return {path.name: path.read_bytes() for path in folder.iterdir()} if folder.exists() else {}


def test_a_check_is_recalled(tmp_path: Path, derivations: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    named, usual = tmp_path / "named", tmp_path / "usual"
    monkeypatch.setenv("REDERIVE_CACHE", str(usual))
    path = derivations / "kepler.toml"
    fresh = rederive.check(path, cache=False)
    assert not usual.exists(), "nothing is kept"
    first = rederive.check(path, cache=named)
    records = kept(named)
    assert first.json() == fresh.json() and len(records) == 4 and not usual.exists()
    again = rederive.Session(path).check(cache=str(named))
    assert again.json() == fresh.json() and again.page() == fresh.page() and kept(named) == records
    claim = again.claims[0].id
    assert again.explain(claim) == fresh.explain(claim)

    rederive.check(path)
    assert len(kept(usual)) == 4
    monkeypatch.setenv("REDERIVE_CACHE", "")
    assert rederive.check(path).json() == fresh.json()


def test_records_are_those_of_the_module(
    tmp_path: Path, derivations: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Not of the interpreter, which another version of the package may have, too; keyed by the secret of the user."""
    for variable in ("HOME", "XDG_CACHE_HOME", "LOCALAPPDATA"):
        monkeypatch.setenv(variable, str(tmp_path / "home"))
    rederive.check(derivations / "kepler.toml", cache=tmp_path / "kept")
    (secret,) = (tmp_path / "home").rglob("secret")
    module = hashlib.sha256(Path(_rederive.__file__).read_bytes()).digest()
    records = kept(tmp_path / "kept")
    assert records
    for name, record in records.items():
        name = name.removesuffix(".record")
        whole = module + len(name).to_bytes(8, "little") + name.encode() + record[32:]
        inner = hashlib.sha256(whole).digest()
        assert record[:32] == hashlib.sha256(secret.read_bytes() + inner).digest()


def test_a_record_of_something_else_is_not_read(tmp_path: Path, derivations: Path) -> None:
    path = derivations / "kepler.toml"
    first = rederive.check(path, cache=tmp_path)
    for record in tmp_path.iterdir():
        record.write_bytes(bytes([record.read_bytes()[0] ^ 1]) + record.read_bytes()[1:])
    assert rederive.check(path, cache=tmp_path).json() == first.json()


def test_what_is_no_folder_is_refused(spring: str) -> None:
    with pytest.raises(TypeError):
        rederive.check(text=spring, cache=True)  # type: ignore[arg-type]

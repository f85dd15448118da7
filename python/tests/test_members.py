"""The members of a family as a table, in the way that docs/scale.md offers: read by pandas, written as Parquet, read again."""

import csv
import subprocess
import sys
from pathlib import Path

import pytest

pandas = pytest.importorskip("pandas")
pytest.importorskip("pyarrow")


def test_a_table_in_parquet_has_every_bit(derivations: Path, tmp_path: Path) -> None:
    table = tmp_path / "members.csv"
    file = derivations / "pendulum.toml"
    sweep = ["sweep", str(file), "--family", "amplitudes", "--output", str(tmp_path / "part.jsonl"), "--members", str(table)]
    subprocess.run([sys.executable, "-m", "rederive", *sweep], check=True, capture_output=True)
    pandas.read_csv(table).to_parquet(tmp_path / "members.parquet")
    again = pandas.read_parquet(tmp_path / "members.parquet")
    with table.open(encoding="utf-8", newline="") as lines:
        rows = list(csv.DictReader(lines))
    assert len(rows) == len(again) == 30
    for name in rows[0]:
        cells = [row[name] for row in rows]
        if again[name].dtype == "float64":
            assert [float(cell) for cell in cells] == list(again[name]), name
        else:
            assert cells == [str(value) for value in again[name]], name

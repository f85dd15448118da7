"""The command that the wheel brings."""

import subprocess
import sys
from pathlib import Path

import rederive


def run(*words: str) -> "subprocess.CompletedProcess[str]":
    return subprocess.run([str(Path(sys.executable).with_name("rederive")), *words], capture_output=True, text=True)


def test_the_command_is_the_program(tmp_path: Path, spring: str) -> None:
    assert run("--version").stdout == f"rederive {rederive.__version__}\n"
    file = tmp_path / "spring.toml"
    file.write_text(spring, encoding="utf-8")
    found = run("check", str(file), "--no-reports")
    assert found.returncode == 1 and "rest/begin" in found.stdout, found
    assert run("prove", "x=x", "--symbol", "x").returncode == 0
    assert run("nonsense").returncode == 2
    module = subprocess.run([sys.executable, "-m", "rederive", "--version"], capture_output=True, text=True)
    assert module.stdout == run("--version").stdout

"""A family on a Dask cluster of two worker processes, of which one is killed: the same bytes, nothing lost."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Iterator

import pytest

import rederive

distributed = pytest.importorskip("distributed")
PARTS = 20


def family(derivations: Path) -> str:
    """The families of the tests, with members enough that a part takes a moment."""
    text = (derivations.parent / "tests" / "corpus" / "families.toml").read_text(encoding="utf-8")
    values = "values = [0.1, 0.5, 1, 1.5, 2, 2.5, 2.9, 3.01, 3.1]"
    assert values in text
    return text.replace(values, "from = 0.1, to = 3.1, count = 1600")


@pytest.fixture
def cluster(tmp_path: Path) -> Iterator[tuple[str, list[subprocess.Popen[bytes]]]]:
    file = tmp_path / "scheduler.json"
    environment = {**os.environ, "RAYON_NUM_THREADS": "1", "DASK_DISTRIBUTED__COMM__TIMEOUTS__CONNECT": "10s"}
    with (tmp_path / "log").open("wb") as log:

        def start(*arguments: str) -> subprocess.Popen[bytes]:
            line = [sys.executable, "-m", "distributed.cli." + arguments[0], *arguments[1:]]
            return subprocess.Popen(line, env=environment, stdout=log, stderr=log, cwd=tmp_path)

        local = ["--host", "127.0.0.1", "--no-dashboard", "--scheduler-file", str(file)]
        started = [start("dask_scheduler", "--port", "0", *local)]
        worker = ["--nthreads", "1", "--no-nanny", "--no-dashboard", "--scheduler-file", str(file), "--host", "127.0.0.1"]
        started += [start("dask_worker", *worker) for _ in range(2)]
        try:
            deadline = time.monotonic() + 60
            while not file.exists() and time.monotonic() < deadline:
                time.sleep(0.1)
            yield json.loads(file.read_text(encoding="utf-8"))["address"], started[1:]
        finally:
            for process in reversed(started):
                process.kill()
                process.wait(30)


def test_a_worker_that_dies_loses_nothing(
    derivations: Path, cluster: tuple[str, list[subprocess.Popen[bytes]]]
) -> None:
    from rederive.dask import sweep

    address, workers = cluster
    text = family(derivations)
    told = []

    def progress(done: int, of: int) -> None:
        told.append((done, of))
        if done == 6:
            os.kill(workers[0].pid, signal.SIGKILL)
            workers[0].wait(10)

    with distributed.Client(address) as client:
        client.wait_for_workers(2, timeout=60)
        found = sweep(client, rederive.Session(text=text), "amplitudes", PARTS, progress=progress)
        assert len(client.scheduler_info()["workers"]) == 1
    assert told == [(done, PARTS) for done in range(1, PARTS + 1)]
    alone = rederive.check(text=text, trajectories="amplitudes", only_verdicts=True)
    assert found.json() == alone.json()


def test_problems_come_from_the_worker(derivations: Path) -> None:
    from rederive.dask import sweep

    with distributed.Client(n_workers=1, threads_per_worker=1, processes=False, dashboard_address=None) as client:
        with pytest.raises(rederive.DerivationError, match="not divided into 9999 parts"):
            sweep(client, rederive.Session(text=family(derivations)), "amplitudes", 9999, retries=0)
        with pytest.raises(rederive.PartError):
            sweep(client, rederive.Session(text=family(derivations)), "amplitudes", 0)

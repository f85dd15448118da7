"""A call that is interrupted, and other threads while one computes."""

import os
import signal
import subprocess
import sys
import textwrap
import threading
import time
from pathlib import Path

import pytest

import rederive

LONG = textwrap.dedent(
    """
    import signal, sys, time, rederive
    # What runs in the background of a shell ignores it, and its children with it.
    signal.signal(signal.SIGINT, signal.default_int_handler)
    print("begin", flush=True)
    try:
        rederive.check(sys.argv[1])
    except KeyboardInterrupt:
        print("interrupted", time.time(), flush=True)
        # The library still answers.
        print(rederive.prove("x=x", "x").verdict, flush=True)
    else:
        print("done", flush=True)
    """
)


@pytest.mark.skipif(os.name != "posix", reason="signals")
def test_an_interrupt_comes_back_within_a_tenth_of_a_second(derivations: Path) -> None:
    process = subprocess.Popen(
        [sys.executable, "-c", LONG, str(derivations / "deriglazov-comment.toml")], stdout=subprocess.PIPE, text=True
    )
    assert process.stdout is not None and process.stdout.readline() == "begin\n"
    time.sleep(1)
    sent = time.time()
    process.send_signal(signal.SIGINT)
    word, at = process.stdout.readline().split()
    assert word == "interrupted"
    # Where many processes share few processors, a thread may wait for its turn.
    assert float(at) - sent < (0.1 if os.getloadavg()[0] < (os.cpu_count() or 1) else 0.5)
    assert process.stdout.readline() == "proved\n"
    ended = time.time()
    assert process.wait(60) == 0 and time.time() - ended < 30


def test_other_threads_go_on(derivations: Path) -> None:
    counted, done = 0, threading.Event()

    def work() -> None:
        rederive.check(derivations / "pendulum.toml")
        done.set()

    thread = threading.Thread(target=work)
    thread.start()
    while not done.wait(0.001):
        counted += 1
    thread.join()
    assert counted > 20, counted


def test_a_proof_has_a_deadline() -> None:
    # Half a second of work: more than a thread waits for its turn.
    letters = "abcdfghjklmnop"
    power = rf"\left({'+'.join(letters)}\right)"
    many = ", ".join(f"{power}^{{{n}}}={power}^{{{n - 6}}}{power}^6" for n in range(10, 2500))
    with pytest.raises(rederive.DeadlineReached) as e:
        rederive.prove(many, ", ".join(letters), deadline=0)
    assert isinstance(e.value, TimeoutError)
    # What is left of a time may be less than nothing.
    with pytest.raises(rederive.DeadlineReached):
        rederive.prove(many, ", ".join(letters), deadline=-1)
    with pytest.raises(ValueError, match="not a number"):
        rederive.prove(many, ", ".join(letters), deadline=float("nan"))
    assert rederive.prove(many, ", ".join(letters), deadline=60).verdict is rederive.Decision.PROVED

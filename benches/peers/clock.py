"""Processor time: of a process with its start, and of a call.

Other work on the machine makes both longer; so everything is measured several times, and the least counts.
"""

import os
import subprocess
import sys
import time

ROUNDS = 5
# What is measured is a check, not what an earlier one left.
os.environ["REDERIVE_CACHE"] = ""


def process(command, rounds=ROUNDS, good=(0,)):
    """Seconds of the processor and peak MB of a command, the least of several runs; nothing where it does not end well."""
    seconds, megabytes = [], []
    for _ in range(rounds):
        try:
            child = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        except OSError:
            return None
        _, status, usage = os.wait4(child.pid, 0)
        child.returncode = code = os.waitstatus_to_exitcode(status)
        if code not in good:
            return None
        seconds.append(usage.ru_utime + usage.ru_stime)
        megabytes.append(usage.ru_maxrss / 1024)
    return min(seconds), min(megabytes)


def call(work, rounds=ROUNDS):
    """Seconds of the processor of a call, the least of several."""
    def once():
        begun = time.process_time()
        work()
        return time.process_time() - begun

    return min(once() for _ in range(rounds))


def python(code, rounds=ROUNDS):
    """The same as `process`, of this Python with a program."""
    return process([sys.executable, "-c", code], rounds)


def row(name, found):
    """One line of a table."""
    told = "not at hand" if found is None else f"{found[0] * 1e3:10.1f} ms  {found[1]:7.1f} MB"
    print(f"  {name:58} {told}")

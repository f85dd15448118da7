"""Enclosures of the free rigid body: ours, beside CAPD where it is installed.

    python benches/peers/enclosures.py CARGO

Runs `cargo bench --bench enclosure`, whose rows are those of [enclosure.md](../../docs/enclosure.md); CAPD's figures there are of
another machine. CAPD is a C++ library that no index of packages has; where `capd-config` is found, its version is told, so
that its examples can be run by hand.
"""

import shutil
import subprocess
import sys


def main():
    found = subprocess.run([sys.argv[1], "bench", "--bench", "enclosure"], capture_output=True, text=True, check=False)
    print(found.stdout or found.stderr[-2000:])
    capd = shutil.which("capd-config")
    if capd is None:
        print("CAPD is not at hand: its column is the one of docs/enclosure.md")
    else:
        print("CAPD " + subprocess.run([capd, "--version"], capture_output=True, text=True, check=False).stdout.strip())


if __name__ == "__main__":
    main()

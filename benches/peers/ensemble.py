"""Integration of rigid bodies with 12 unknowns: heyoka, one by one and in batches, SciPy, and a family of this program.

    python benches/peers/ensemble.py [REDERIVE]

I = (1, 2, 3), R(0) = 1, Ω(0) = (τ, 1, 0.01), to 1e-15. Of many bodies, τ goes from 0.001 to 0.1 in equal steps. With REDERIVE, the
same bodies are a family with one claim, that the energy does not change, sampled, on one thread: start of the process, error
estimate and claim are in it, which the others do not do. `cargo bench --bench flow` has the integrations alone. Figures are
processor time, the least of several runs.
"""

import os
import subprocess
import sys
import tempfile
import time

import numpy as np

MANY = 10_000
# So many of them are integrated by those for whom all would take long, and so many by the slowest.
SOME = 2_000
FEW = 100
FAMILY = r"""
[derivation]
title = "Rigid bodies"
concerns = "a comparison of speed"

[symbols]
't' = { role = "time" }
'I' = { role = "parameter", shape = "diagonal 3", positive = true }
'\tau' = { role = "parameter" }
'R' = { role = "state", shape = "3x3" }
'\Omega' = { role = "state", shape = "3" }
'E' = { role = "observable", formula = '\frac12 I_i\Omega_i^2' }

[system.euler-poisson]
states = ['R', '\Omega']
equations = ['\dot R_{ij}=-\epsilon_{jkp}\Omega_k R_{ip}', 'I\dot{\boldsymbol\Omega}=[I{\boldsymbol\Omega},{\boldsymbol\Omega}]']

[[trajectory]]
id = "body"
system = "euler-poisson"
parameters = { 'I' = [1, 2, 3], '\tau' = 0.01 }
initial = { 'R' = [[1, 0, 0], [0, 1, 0], [0, 0, 1]], '\Omega' = ['\tau', 1, 0.01] }
span = [0, 20]

[[family]]
id = "bodies"
of = "body"
vary = { '\tau' = { from = 0.001, to = 0.1, count = COUNT } }

[[claim]]
id = "energy"
says = "The kinetic energy does not change."
always = ['E=E(0)']
families = ["bodies"]
"""


# What is measured is a check, not what an earlier one left.
os.environ["REDERIVE_CACHE"] = ""


def least(work, rounds):
    def once():
        begun = time.process_time()
        work()
        return time.process_time() - begun

    return min(once() for _ in range(rounds))


def row(name, seconds, more=""):
    print(f"  {name:52} {seconds * 1e3:12.3f} ms  {more}")


def start(tilt):
    return [1.0, 0, 0, 0, 1, 0, 0, 0, 1, tilt, 1, 0.01]


def tilts(count):
    return np.linspace(0.001, 0.1, count)


def of_heyoka():
    try:
        import heyoka as hy
    except ImportError:
        print("  heyoka is not at hand")
        return
    names = [f"R{i}{j}" for i in (1, 2, 3) for j in (1, 2, 3)] + ["O1", "O2", "O3"]
    v = hy.make_vars(*names)
    inertia = [hy.par[0], hy.par[1], hy.par[2]]
    system = []
    for i in range(3):
        for j in range(3):
            k, p = (j + 1) % 3, (j + 2) % 3
            system.append((v[3 * i + j], v[9 + p] * v[3 * i + k] - v[9 + k] * v[3 * i + p]))
    for j in range(3):
        k, p = (j + 1) % 3, (j + 2) % 3
        system.append((v[9 + j], (inertia[k] - inertia[p]) / inertia[j] * v[9 + k] * v[9 + p]))
    one = hy.taylor_adaptive(system, start(0.01), pars=[1.0, 2.0, 3.0])

    def alone(end):
        one.time = 0.0
        one.state[:] = start(0.01)
        one.propagate_until(end)

    for end in (20.0, 100.0):
        row(f"one body to t = {end:.0f}, heyoka", least(lambda end=end: alone(end), 200))
    def one_by_one():
        for tilt in tilts(SOME):
            one.time = 0.0
            one.state[:] = start(tilt)
            one.propagate_until(20.0)

    row(f"{MANY} bodies to t = 20, heyoka, one by one", least(one_by_one, 5) * MANY / SOME, f"from {SOME}")
    for size in (4, 8):
        pars = np.array([[1.0] * size, [2.0] * size, [3.0] * size])
        batch = hy.taylor_adaptive_batch(system, np.array([start(0.01)] * size).T.copy(), pars=pars)

        def together():
            all_tilts = tilts(SOME)
            for first in range(0, SOME, size):
                batch.set_time(0.0)
                batch.state[:] = np.array([start(t) for t in all_tilts[first : first + size]]).T
                batch.propagate_until(20.0)

        seconds = least(together, 5) * MANY / SOME
        row(f"{MANY} bodies to t = 20, heyoka, batches of {size}", seconds, f"from {SOME}")


def of_scipy():
    try:
        from scipy.integrate import solve_ivp
    except ImportError:
        print("  SciPy is not at hand")
        return

    def rates(_, x):
        r, o = x[:9].reshape(3, 3), x[9:]
        turned = np.stack([o[2] * r[:, 1] - o[1] * r[:, 2], o[0] * r[:, 2] - o[2] * r[:, 0], o[1] * r[:, 0] - o[0] * r[:, 1]], 1)
        return np.concatenate([turned.ravel(), [-o[1] * o[2], o[2] * o[0], -o[0] * o[1] / 3]])

    def each():
        for tilt in tilts(FEW):
            solve_ivp(rates, (0, 20), start(tilt), "DOP853", rtol=1e-13, atol=1e-15)

    row(f"{MANY} bodies to t = 20, SciPy, DOP853 at 1e-13", least(each, 2) * MANY / FEW, f"from {FEW}")


def of_family(program):
    for count in (SOME, MANY, 10 * MANY):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "bodies.toml")
            with open(path, "w", encoding="utf-8") as file:
                file.write(FAMILY.replace("COUNT", str(count)))
            command = [program, "check", path, "--jobs", "1", "--only-verdicts", "--rigor", "sampled"]
            found = []
            for _ in range(3 if count <= MANY else 1):
                child = subprocess.Popen(command, stdout=subprocess.DEVNULL, cwd=folder)
                _, status, usage = os.wait4(child.pid, 0)
                child.returncode = os.waitstatus_to_exitcode(status)
                if child.returncode != 0:
                    print("  the family was not checked")
                    return
                found.append((usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024))
        row(f"a family of {count} bodies with one claim", min(found)[0], f"{max(f[1] for f in found):.0f} MB")


def main():
    of_heyoka()
    of_scipy()
    if len(sys.argv) > 1:
        of_family(os.path.abspath(sys.argv[1]))


if __name__ == "__main__":
    main()

"""What several tests need."""

from pathlib import Path

import pytest

pytest_plugins = ["pytester"]

SPRING = r"""
[derivation]
title = 'A spring'
concerns = 'A textbook'

[symbols]
't' = { role = 'time' }
'\omega' = { role = 'parameter', positive = true }
'x' = { role = 'state' }
'v' = { role = 'state' }

[system.spring]
states = ['x', 'v']
equations = ['\dot x=v, \quad \dot v=-\omega^2x']

[[trajectory]]
id = 'pulled'
system = 'spring'
parameters = { '\omega' = 1.3 }
initial = { 'x' = 1, 'v' = 0 }
span = [0, 10]

[[trajectory]]
id = 'pushed'
system = 'spring'
parameters = { '\omega' = 0.7 }
initial = { 'x' = 0, 'v' = 1 }
span = [0, 10]

[[claim]]
id = 'energy'
says = 'The energy is what it was'
always = ['v^2+\omega^2x^2=v(0)^2+\omega^2x(0)^2']

[[claim]]
id = 'rest'
says = 'It begins at rest'

[[claim.reading]]
id = 'at-once'
says = 'and stays so'
always = ['v=0']
expect = { fails = 'all' }

[[claim.reading]]
id = 'begin'
says = 'at the start'
always = ['v(0)=0']
"""


@pytest.fixture(scope="session")
def spring() -> str:
    return SPRING


@pytest.fixture(scope="session")
def derivations() -> Path:
    return Path(__file__).resolve().parents[2] / "derivations"

"""Checks the derivations of physics and mathematics papers: which claims hold along which motions, and how strongly.

>>> import rederive
>>> rederive.prove(r"\\sin 2x=2\\sin x\\cos x", symbols=["x"]).verdict
<Decision.PROVED: 'proved'>

:func:`lint` looks through a paper as it is; :func:`check` tries the claims of a derivation file on its motions;
:class:`Session` answers several questions about one; :class:`Derivation` writes such a file in Python, with formulas in
LaTeX or of SymPy.
"""

from __future__ import annotations

from ._rederive import __version__
from .derivation import Derivation
from .errors import (
    Cancelled,
    DeadlineReached,
    Defect,
    DerivationError,
    Error,
    NoCounterpart,
    PartError,
    Problem,
    UnknownName,
)
from .notebook import load_ipython_extension
from .paper import Lint, Relation, lint
from .proof import Counterexample, Proof, Proofs
from .report import Claim, Correction, Curve, Exclusion, Members, Report, Residual, Result, Summary, Witness
from .session import Session, check, prove
from .verdict import Decision, Strength, Verdict

__all__ = [
    "Cancelled",
    "Claim",
    "Correction",
    "Counterexample",
    "Curve",
    "DeadlineReached",
    "Decision",
    "Defect",
    "Derivation",
    "DerivationError",
    "Error",
    "Exclusion",
    "Lint",
    "Members",
    "NoCounterpart",
    "PartError",
    "Problem",
    "Proof",
    "Proofs",
    "Relation",
    "Report",
    "Residual",
    "Result",
    "Session",
    "Strength",
    "Summary",
    "UnknownName",
    "Verdict",
    "Witness",
    "__version__",
    "check",
    "lint",
    "load_ipython_extension",
    "prove",
]

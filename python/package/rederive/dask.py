"""A family of motions on a Dask cluster: each part is a task, and a part whose worker dies is done by another.

Needs ``dask`` and ``distributed`` where the client is, and this package, in the same version, on every worker. The text of the
derivation goes to the workers and the texts of the parts come back, so that no folder need be shared. A task uses as many
threads as its process may: start workers with ``RAYON_NUM_THREADS=1`` where there is one for each processor.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any, Union

from .errors import PartError
from .progress import Progress, shown
from .report import Report
from .session import Session, Where

__all__ = ["sweep"]


def _part(number: int, of: int, text: str, name: str, family: str) -> str:
    """One part; a function of its own, so that a worker finds it by its name."""
    return Session(text=text, name=name).sweep(family, (number, of), progress=False)


def sweep(
    client: Any,
    derivation: Union[Where, Session],
    family: str,
    parts: int,
    *,
    retries: int = 3,
    progress: Progress = None,
) -> Report:
    """Tries the claims on a family of motions, in parts, on the workers of a Dask cluster.

    ``client``: a ``distributed.Client``.
    ``derivation``: a path, a :class:`Derivation`, or a :class:`Session` that has read one.
    ``parts``: how many; several for each worker, so that none waits long for the last.
    ``retries``: how often a part is begun again after an exception; one whose worker died is begun again in any case.

    The report has the same bytes as that of one machine: ``check(derivation, trajectories=family, only_verdicts=True)``.
    Raises :class:`DerivationError`, and what a part raised on its worker.
    """
    # It has no types, and need not be installed where this package is looked at.
    distributed: Any = import_module("distributed")
    session = derivation if isinstance(derivation, Session) else Session(derivation)
    text, name = session.source
    # Of unknown purity, since another version may be on the workers: the parts say which, and are refused then.
    futures: list[Any] = client.map(
        _part, range(1, parts + 1), of=parts, text=text, name=name, family=family, pure=False, retries=retries
    )
    found: list[str] = []
    try:
        with shown(progress, family) as tell:
            for future in distributed.as_completed(futures):
                found.append(future.result())
                if tell is not None:
                    tell(len(found), parts)
    finally:
        client.cancel([future for future in futures if not future.done()])
    if not found:
        raise PartError("a family is divided into one part or more")
    return session.merge(found)

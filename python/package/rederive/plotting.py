"""A curve with matplotlib, where that is installed."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from .report import Curve

__all__ = ["draw"]


def draw(curve: Curve, title: str, axes: Optional[Axes] = None) -> Axes:
    """Both sides; the band around the right side is the error bound of their difference."""
    if axes is None:
        import matplotlib.pyplot

        axes = matplotlib.pyplot.subplots()[1]
    axes.plot(curve.t, curve.left, label="left side")
    axes.plot(curve.t, curve.right, "--", label="right side")
    axes.fill_between(curve.t, curve.right - curve.bound, curve.right + curve.bound, alpha=0.3)
    axes.set_xlabel("t")
    axes.set_ylabel("value of each side")
    axes.set_title(title)
    axes.legend()
    return axes

"""A number with its unit, and with what it came to in every drawing of a hand."""

from __future__ import annotations

from typing import Any

import numpy as np

from graphic_tmm.board.values import Reals


class Quantity(float):
    """A figure of a drawing: a float like any other, that knows its unit.

    Parameters
    ----------
    value : float
        The figure, of several drawings that of the first; NaN where it could not be drawn.
    unit : str
        Its unit, in English: ``"kg·m²"``; ``""`` of a bare number.
    trials : array, optional
        What it came to in each drawing, (trial,); left out, the one figure.

    Examples
    --------
    >>> from graphic_tmm import Quantity
    >>> inertia = Quantity(1.5, "kg·m²")
    >>> inertia, 2 * inertia, inertia.unit
    (1.5 kg·m², 3.0, 'kg·m²')
    """

    unit: str
    trials: Reals

    def __new__(cls, value: float, unit: str = "", trials: Reals | None = None) -> Quantity:
        """Return the figure with its unit."""
        made = super().__new__(cls, value)
        made.unit = unit
        made.trials = np.array([float(value)]) if trials is None else trials
        return made

    @property
    def value(self) -> float:
        """The bare figure."""
        return float(self)

    def __repr__(self) -> str:
        return f"{float(self):.6g} {self.unit}".rstrip()

    __str__ = __repr__

    def __format__(self, spec: str) -> str:
        return f"{float(self):{spec}} {self.unit}".rstrip() if spec else repr(self)

    def __reduce__(self) -> tuple[Any, ...]:
        return type(self), (float(self), self.unit, self.trials)

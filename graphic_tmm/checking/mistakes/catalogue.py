"""The catalogue of mistakes: each an entry of a few lines.

To add one, write a function from a scene as drawn to what its figures would then be (`alterations` holds those
there are), and enter it with a name and a sentence.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import NamedTuple

import numpy as np

from graphic_tmm.checking.mistakes.alterations import (
    Figures,
    at_the_end,
    backwards,
    cellwise,
    decimal,
    degrees,
    further,
    half_way,
    inverted,
    not_reversed,
    numbered,
    of_another_plan,
    opposite,
    other_assembly,
    running,
    speed_by,
    turned,
    wrong_end,
    wrong_link,
)
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.said import said

EVERYWHERE, POSITION, READING = "everywhere", "position", "reading"


class Mistake(NamedTuple):
    """A mistake: its name, what it says, what figures it leads to, by variant.

    ``reach``: whether it befalls the whole drawing, one position or another, or single readings.
    """

    name: str
    says: str
    figures: Callable[[DrawnScene], Iterator[Figures]]
    reach: str = POSITION


CATALOGUE = (
    Mistake(
        said("Coriolis left out"),
        said("the Coriolis acceleration is left out"),
        running("coriolis", lambda right, *v: 0.0 * right),
    ),
    Mistake(
        said("Coriolis turned"),
        said("the Coriolis acceleration points the wrong way"),
        running("coriolis", lambda right, *v: -right),
    ),
    Mistake(
        said("normal of the wrong link"),
        said("a normal component is divided by the length of another link"),
        wrong_link,
    ),
    Mistake(
        said("normal from the wrong end"),
        said("a normal component points away from the centre of rotation"),
        wrong_end,
    ),
    Mistake(
        said("ω/r for ω·r"),
        said("ω/l is calculated for ω·l"),
        running("product", lambda right, omega, length: omega / length),
    ),
    Mistake(
        said("v/l inverted"),
        said("an angular velocity is calculated as l/v"),
        running("rate", lambda right, *v: 1.0 / np.where(right == 0.0, np.nan, right)),
    ),
    Mistake(
        said("degrees for radians"),
        said("degrees are written for radians"),
        cellwise(degrees),
        READING,
    ),
    Mistake(
        said("rpm for rad/s"),
        said("revolutions a minute are taken for rad/s"),
        speed_by(30.0 / math.pi),
    ),
    Mistake(
        said("μ inverted"),
        said("a length is divided by μ instead of multiplied"),
        cellwise(inverted),
        READING,
    ),
    Mistake(
        said("μ of another plan"),
        said("a length is multiplied by the scale factor of another plan"),
        of_another_plan,
        READING,
    ),
    Mistake(
        said("decimal point slipped"),
        said("a decimal point has slipped"),
        decimal,
        READING,
    ),
    Mistake(
        said("numbering reversed"),
        said("the positions are numbered backwards"),
        numbered(backwards),
        EVERYWHERE,
    ),
    Mistake(
        said("numbering shifted"),
        said("the positions are numbered one further"),
        numbered(further(1)),
        EVERYWHERE,
    ),
    Mistake(
        said("numbering shifted back"),
        said("the positions are numbered one too few"),
        numbered(further(-1)),
        EVERYWHERE,
    ),
    Mistake(
        said("numbering from the opposite position"),
        said(
            "the positions are counted from half a turn further on, as from the other dead centre"
        ),
        half_way,
        EVERYWHERE,
    ),
    Mistake(
        said("sense reversed"),
        said("the sense is the opposite one"),
        opposite,
        READING,
    ),
    Mistake(
        said("plan not turned"),
        said("the plan of velocities is turned by a quarter"),
        turned,
    ),
    Mistake(
        said("other assembly"),
        said("a group is assembled the other way"),
        other_assembly,
    ),
    Mistake(
        said("inertia not reversed"),
        said("an inertia force points along the acceleration"),
        not_reversed,
    ),
    Mistake(
        said("chord's value at the end"),
        said("the value of a chord stands at the end of its interval"),
        at_the_end,
    ),
)
"""All mistakes that change figures by themselves; those of single readings are in `mistakes`."""

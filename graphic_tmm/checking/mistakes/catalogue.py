"""The catalogue of mistakes: each an entry of a few lines.

To add one, write a function from a scene as drawn to what its figures would then be (`alterations` holds those
there are), and enter it with a name and a sentence in both languages.
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

EVERYWHERE, POSITION, READING = "everywhere", "position", "reading"


class Mistake(NamedTuple):
    """A mistake: its name, what it says in English and Russian, what figures it leads to, by variant.

    ``reach``: whether it befalls the whole drawing, one position or another, or single readings.
    """

    name: str
    en: str
    ru: str
    figures: Callable[[DrawnScene], Iterator[Figures]]
    reach: str = POSITION


CATALOGUE = (
    Mistake(
        "Coriolis left out",
        "the Coriolis acceleration is left out",
        "не учтено ускорение Кориолиса",
        running("coriolis", lambda right, *v: 0.0 * right),
    ),
    Mistake(
        "Coriolis turned",
        "the Coriolis acceleration points the wrong way",
        "ускорение Кориолиса направлено в обратную сторону",
        running("coriolis", lambda right, *v: -right),
    ),
    Mistake(
        "normal of the wrong link",
        "a normal component is divided by the length of another link",
        "нормальная составляющая разделена на длину другого звена",
        wrong_link,
    ),
    Mistake(
        "normal from the wrong end",
        "a normal component points away from the centre of rotation",
        "нормальная составляющая направлена от центра вращения",
        wrong_end,
    ),
    Mistake(
        "ω/r for ω·r",
        "ω/l is calculated for ω·l",
        "вместо ω·l вычислено ω/l",
        running("product", lambda right, omega, length: omega / length),
    ),
    Mistake(
        "v/l inverted",
        "an angular velocity is calculated as l/v",
        "угловая скорость вычислена как l/v",
        running("rate", lambda right, *v: 1.0 / np.where(right == 0.0, np.nan, right)),
    ),
    Mistake(
        "degrees for radians",
        "degrees are written for radians",
        "вместо радиан записаны градусы",
        cellwise(degrees),
        READING,
    ),
    Mistake(
        "rpm for rad/s",
        "revolutions a minute are taken for rad/s",
        "обороты в минуту приняты за рад/с",
        speed_by(30.0 / math.pi),
    ),
    Mistake(
        "μ inverted",
        "a length is divided by μ instead of multiplied",
        "длина разделена на μ, а не умножена",
        cellwise(inverted),
        READING,
    ),
    Mistake(
        "μ of another plan",
        "a length is multiplied by the scale factor of another plan",
        "длина умножена на масштабный коэффициент другого плана",
        of_another_plan,
        READING,
    ),
    Mistake(
        "decimal point slipped",
        "a decimal point has slipped",
        "сдвинута десятичная запятая",
        decimal,
        READING,
    ),
    Mistake(
        "numbering reversed",
        "the positions are numbered backwards",
        "положения пронумерованы в обратную сторону",
        numbered(backwards),
        EVERYWHERE,
    ),
    Mistake(
        "numbering shifted",
        "the positions are numbered one further",
        "нумерация положений сдвинута на одно вперёд",
        numbered(further(1)),
        EVERYWHERE,
    ),
    Mistake(
        "numbering shifted back",
        "the positions are numbered one too few",
        "нумерация положений сдвинута на одно назад",
        numbered(further(-1)),
        EVERYWHERE,
    ),
    Mistake(
        "numbering from the opposite position",
        "the positions are counted from half a turn further on, as from the other dead centre",
        "положения отсчитаны через пол-оборота, как от другого крайнего положения",
        half_way,
        EVERYWHERE,
    ),
    Mistake(
        "sense reversed",
        "the sense is the opposite one",
        "направление противоположное",
        opposite,
        READING,
    ),
    Mistake(
        "plan not turned",
        "the plan of velocities is turned by a quarter",
        "план скоростей повёрнут на четверть оборота",
        turned,
    ),
    Mistake(
        "other assembly",
        "a group is assembled the other way",
        "группа собрана иначе",
        other_assembly,
    ),
    Mistake(
        "inertia not reversed",
        "an inertia force points along the acceleration",
        "сила инерции направлена по ускорению",
        not_reversed,
    ),
    Mistake(
        "chord's value at the end",
        "the value of a chord stands at the end of its interval",
        "значение хорды отложено на конце интервала",
        at_the_end,
    ),
)
"""All mistakes that change figures by themselves; those of single readings are in `mistakes`."""

"""Scale factors that somebody states: a row of the readings, an option; the scene's where it prescribes one."""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Mapping, Sequence
from typing import NamedTuple

from graphic_tmm.checking.cells import Cell, taken_figure
from graphic_tmm.checking.congruence.lengths import Group
from graphic_tmm.checking.congruence.moves import Move
from graphic_tmm.checking.congruence.witnesses import EXACT
from graphic_tmm.checking.readings.names import plan_meant
from graphic_tmm.checking.records import Taken
from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.language.said import said

SCENE = 0.0
"""Stands for the scale factor of the scene."""
WORDS = ("μ", "µ", "mu", "масштаб", "масштабный коэффициент", "scale", "scale factor")
"""What people write for a scale factor, Greek letter or the sign of micro."""
PER_MM = re.compile(r"^\(?(.*?)\)?\s*/\s*(мм|mm)$")
TURNS = {0: 0, 90: 1, 180: 2, 270: 3, -90: 3}


class Stated(NamedTuple):
    """A scale factor that somebody states: of what group, SI a mm, `SCENE` for the scene's; its line."""

    group: Group
    mu: float
    line: int = 0

    @property
    def due(self) -> bool:
        """Whether it is the number that the scene has for its group."""
        return self.mu != SCENE and abs(math.log(self.mu / self.group.mu)) < EXACT


def is_scale_row(taken: Taken) -> bool:
    """Whether a reading states a scale factor."""
    name = taken.segment.casefold().strip()
    return name in WORDS or name[:1] in "μµ" or name.startswith("mu_")


def stated_in(
    rows: Iterable[Taken], groups: Mapping[str, Mapping[str, Group]]
) -> tuple[list[Stated], list[Fault]]:
    """Return the scale factors that rows state, and what cannot be understood.

    ``groups``: by plan and symbol what is drawn to each scale factor.
    """
    found, faults = [], []
    for taken in rows:
        plan = plan_meant(taken.plan, tuple(groups)).only
        some = _groups(taken.segment, groups.get(plan, {}))
        if len(some) != 1:
            faults.append(
                Fault("", taken.line, _which(taken.plan, taken.segment, groups.get(plan, {})))
            )
            continue
        if taken.value is None:
            continue
        unit = PER_MM.match(taken.unit.strip())
        bare = taken._replace(unit=unit[1] if unit else taken.unit, mm=None, x=None, y=None)
        try:
            mu = taken_figure(bare, Cell(1.0, 1.0, some[0].unit))
        except ValueError as error:
            faults.append(Fault("", taken.line, error.args[0]))
            continue
        if mu > 0.0:
            found.append(Stated(some[0], mu, taken.line))
        else:
            says = said("a scale factor is more than 0; it is {mu:g}", mu=mu)
            faults.append(Fault("", taken.line, says))
    return found, faults


def _groups(name: str, symbols: Mapping[str, Group]) -> list[Group]:
    """Return which scale factors a name means: that of a symbol, or the only one."""
    folded = _letters(name)
    exact = [group for symbol, group in symbols.items() if _letters(symbol) == folded]
    return exact or (
        list(symbols.values()) if folded in map(_letters, WORDS) or len(symbols) == 1 else []
    )


def _letters(name: str) -> str:
    return re.sub(r"[\s_{}]", "", name.casefold()).replace("µ", "μ").replace("mu", "μ")


def _which(plan: str, typed: str, symbols: Mapping[str, Group]) -> str:
    if not symbols:
        return said("no scale factor is known of plan {plan}", plan=plan[:30])
    return said(
        '"{typed}" of plan {plan}: which scale factor is it? There are {known}',
        typed=typed[:20],
        plan=plan[:30],
        known=", ".join(symbols),
    )


def stated_by(
    options: Sequence[str], groups: Mapping[str, Mapping[str, Group]], source: str
) -> list[Stated]:
    """Return the scale factors of options, each PLAN=VALUE (SI a mm), PLAN:μ_S=VALUE or PLAN=scene.

    Raises
    ------
    SceneError
        If one is not understood.
    """
    found, faults = [], []
    for option in options:
        name, sign, value = option.partition("=")
        plan_typed, _, symbol = name.partition(":")
        plan = plan_meant(plan_typed.strip(), tuple(groups)).only
        some = _groups(symbol or "μ", groups.get(plan, {}))
        mu = SCENE if value.strip().casefold() in ("scene", "сцена") else _number(value)
        if not sign or mu is None:
            says = said(
                '--mu {typed}: write a plan and its μ, "velocities=0.02", or "=scene"',
                typed=option[:40],
            )
            faults.append(Fault("", 0, says))
        elif len(some) != 1:
            faults.append(Fault("", 0, _which(plan_typed, symbol or "μ", groups.get(plan, {}))))
        else:
            found.append(Stated(some[0], mu))
    if faults:
        raise SceneError(source, tuple(faults))
    return found


def _number(text: str) -> float | None:
    try:
        value = float(text.replace(",", "."))
    except ValueError:
        return None
    return value if 0.0 < value < float("inf") else None


def turns_by(options: Sequence[str], plans: Sequence[str], source: str) -> dict[str, Move]:
    """Return the turns of options, each PLAN=DEGREES by quarters; raises as `stated_by`."""
    found, faults = {}, []
    for option in options:
        name, _, value = option.partition("=")
        plan = plan_meant(name.strip(), plans).only
        turn = TURNS.get(int(value)) if re.fullmatch(r"[-+]?\d{1,3}", value.strip()) else None
        if not plan or turn is None:
            says = said(
                '--turn {typed}: write a plan and 90, 180, 270 or 0: "velocities=90"',
                typed=option[:40],
            )
            faults.append(Fault("", 0, says))
        else:
            found[plan] = Move(turn)
    if faults:
        raise SceneError(source, tuple(faults))
    return found

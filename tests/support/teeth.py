"""The teeth of a drawn gear pair as polygons in real millimetres, wheel by wheel: what shapely judges."""

from __future__ import annotations

from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
import shapely
from shapely import affinity

from graphic_tmm.board.doubt import Doubts
from graphic_tmm.board.execute import Reading, execute
from graphic_tmm.board.hand import EXACT
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.values import Curve
from graphic_tmm.chapters.gears.contact import Verdict, verdicts
from graphic_tmm.chapters.gears.plan import GEARS_PLAN, Gear, gear_scales
from graphic_tmm.chapters.gears.table import gear_results
from graphic_tmm.chapters.gears.task import GEARS, GearTask
from graphic_tmm.chapters.gears.teeth import Flank
from graphic_tmm.drawn import Drawn, Numbers, single, view_scales
from graphic_tmm.fitting.scales import Fitting
from graphic_tmm.project import Project, record
from graphic_tmm.scene.records import Scene

FINE = 32
"""Chords to an arc of a curve, at most 1/8 mm long on the gears of the tests."""


class Pair(NamedTuple):
    """A gear pair drawn and executed."""

    project: Project
    given: dict[Mark, Any]
    reading: Reading

    @property
    def gear(self) -> Gear:
        return GEARS_PLAN.on(self.project)

    @property
    def log(self) -> Construction:
        return self.project.construction

    @property
    def drawn(self) -> Drawn:
        """The same as readers have it."""
        numbers = Numbers(self.reading, {}, self.reading)
        bare = Drawn(self.project, self.given, {}, numbers, EXACT, Doubts((), {}), (), {}, {})
        return replace(bare, scales=view_scales(self.project, self.reading))

    def results(self) -> dict[str, tuple[float, str]]:
        """The results as a table tells them."""
        return single(gear_results(self.drawn))

    def one(self, mark: Mark) -> complex:
        return complex(self.reading[mark][0, 0])

    def real(self, mark: Mark) -> float:
        return float(self.reading[mark][0, 0])

    def row(self, mark: Mark, count: int) -> np.ndarray:
        return np.asarray(self.reading[mark][0, :count])

    @property
    def mm(self) -> float:
        """Real millimetres to one of the drawing."""
        return 1000.0 * self.real(self.gear.line.mu)

    def failed(self) -> set[tuple[str, int]]:
        return {(v.name, v.wheel) for v in self.verdicts() if not v.holds}

    def verdicts(self) -> tuple[Verdict, ...]:
        return verdicts(self.gear.checks, self.reading)


def pair(order: GearTask, **options: Any) -> Pair:
    project = record(Scene("", "T", "en").asking(gears=order), GEARS)
    fitting = Fitting(project, {GEARS: 1.0}, {}, dict(project.given))
    given = {**project.given, **gear_scales(fitting)}
    return Pair(project, given, execute(project.construction, given, **options))


def dense(curve: Curve, trial: int = 0) -> np.ndarray:
    """Points along a curve of the board, by its definition: cubics with these ends and end tangents."""
    p, m = curve.knots[trial], curve.tangents[trial]
    u = np.linspace(0.0, 1.0, FINE, endpoint=False)[None, :]
    a, b, c, d = (2 * u + 1) * (u - 1) ** 2, u * (u - 1) ** 2, u**2 * (3 - 2 * u), u**2 * (u - 1)
    spots = a * p[:-1, None] + b * m[:-1, None] + c * p[1:, None] + d * m[1:, None]
    return np.append(spots.ravel(), p[-1])


def between(spots: np.ndarray, start: complex, end: complex) -> np.ndarray:
    """The points from the one nearest to ``start`` to the one nearest to ``end``, both put in for them."""
    i, j = (int(np.argmin(np.abs(spots - z))) for z in (start, end))
    inner = spots[i + 1 : j] if i < j else spots[j + 1 : i][::-1]
    return np.concatenate([[start], inner, [end]])


def flank(of: Pair, side: Flank) -> np.ndarray:
    """A flank from its beginning to its tip, about the centre of the drawing, mm of the sheet."""
    return between(dense(of.reading[side.flank]), of.one(side.start), of.one(side.tip))


def profile(of: Pair, side: Flank) -> np.ndarray:
    """A side of a tooth from the root to the tip."""
    fillet = dense(of.reading[side.fillet])
    return np.concatenate(
        [between(fillet, complex(fillet[-1]), of.one(side.start)), flank(of, side)[1:]]
    )


def wheel(of: Pair, k: int) -> shapely.Polygon:
    """Three teeth of a wheel on its body, real mm, its centre in the origin."""
    drawn = of.gear.wheels[k]
    centre = of.one(drawn.circles.centre)
    spots: list[np.ndarray] = []
    for tooth in drawn.teeth:
        left, right = profile(of, tooth.left), profile(of, tooth.right)
        tip = _arc(left[-1], right[-1], centre) if left[-1] != right[-1] else right[:0]
        if spots:
            spots.append(_arc(spots[-1][-1], left[0], centre))
        spots += [left, tip, right[::-1]]
    outline = (np.concatenate([*spots, [centre]]) - centre) * of.mm
    return shapely.Polygon([(z.real, z.imag) for z in outline]).buffer(0.0)


def _arc(start: complex, end: complex, centre: complex) -> np.ndarray:
    a, b = start - centre, end - centre
    share = np.linspace(0.0, 1.0, FINE)[1:-1]
    return np.asarray(centre + a * np.exp(1j * np.angle(b / a) * share))


def meshing(of: Pair, turn: float, wheels: tuple[shapely.Polygon, shapely.Polygon]) -> Any:
    """Both wheels when wheel 1 has turned clockwise by ``turn`` (radians): polygons, real mm."""
    z1, z2 = of.gear.order.z1, of.gear.order.z2
    first = affinity.rotate(wheels[0], -turn, origin=(0, 0), use_radians=True)
    second = affinity.rotate(wheels[1], turn * z1 / z2, origin=(0, 0), use_radians=True)
    return first, affinity.translate(second, 0.0, 1000.0 * of.real(of.gear.sizes.a_w))

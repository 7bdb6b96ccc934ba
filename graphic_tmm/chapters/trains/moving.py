"""A train seen along its axis as its members turn: on every pitch circle a stroke for each tooth.

Strokes of two wheels in mesh meet on the line of their centres: so it is seen that they roll.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

import numpy as np

from graphic_tmm.chapters.trains.ink import VIEWS
from graphic_tmm.chapters.trains.ink_scheme import TrainInk
from graphic_tmm.chapters.trains.plan import PLANETARY_PLAN, Planetary
from graphic_tmm.chapters.trains.task import Mesh
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject
from graphic_tmm.page.turning import (
    RigidBody,
    Rotation,
    TurningPicture,
    TurningPictures,
    TurningValue,
)
from graphic_tmm.paper.arithmetic import polar
from graphic_tmm.paper.drawing import Drawing, Ink, Label, circle, line
from graphic_tmm.paper.symbols.kinematic import (
    CENTRE_BEYOND,
    HATCH_DEPTH,
    RIM,
    ring_ground,
    turning_pair,
)
from graphic_tmm.paper.views import mu_text
from graphic_tmm.scene.captions import captions

TOOTH = 1.2
"""How far the stroke of a tooth goes on both sides of its pitch circle, mm, or a quarter of a pitch."""
INSIDE = 5.0
"""How far from a circle the number of its wheel stands, mm."""
APART = 24.0
"""So far apart stand the numbers of wheels about one centre, degrees."""
ALONG = 0.8
"""Where on its arm the letter of the carrier stands."""
UP, FULL = 90.0, 360.0
"""The first satellite stands over the centre; a turn; degrees."""


def pictures(drawn: Drawn) -> Iterator[TurningPicture]:
    """Yield the train; what drives it turns as its speed says."""
    made = PLANETARY_PLAN.of(drawn)
    # bevel wheels are seen from the side, where none turns
    if made is None or made.train.scheme.bevel:
        return
    language = drawn.scene.language
    on = subject(drawn, captions(language)["planetary"], "planetary")
    ink = TrainInk(on.seen(VIEWS, range(made.train.satellites)), made, on.heights)
    teeth = {wheel: round(drawn.value(z)) for wheel, z in made.sizes.teeth.items()}
    if (rates := _rates(drawn, made)) is None:
        return
    train = _Train(ink, rates, teeth)
    reach, c = ink.reach + HATCH_DEPTH + CENTRE_BEYOND, ink.centre
    yield TurningPicture(
        on.title,
        mu_text(drawn.scales["planetary"], language),
        Drawing("", on.title, tuple(train.stands())),
        (*train.wheels(), *train.satellites(), *train.carrier()),
        tuple(
            TurningValue(f"φ_{{{name}}}", "°", 1, rates[name])
            for name in sorted(rates)
            if rates[name]
        ),
        (c.real - reach, c.imag - reach, c.real + reach, c.imag + reach),
    )


def _rates(drawn: Drawn, made: Planetary) -> dict[str, float] | None:
    """Return how fast bodies turn, by their names, over the faster of those that drive (of its size).

    As the plan of angular velocities has it, drawn exactly; None of a train that does not move so.
    """
    found = {body: drawn.value(mark) for body, mark in made.rates.values.items()}
    per = max(abs(found[body]) for body in made.motion.driving)
    if not per or not np.isfinite([*found.values()]).all():
        return None
    still = {made.motion.fixed: 0.0} if made.motion.fixed else {}
    return still | {body: omega / per for body, omega in found.items()}


class _Train:
    """A train while its bodies are drawn.

    ``starts``: where the first stroke of a tooth stands on each wheel (degrees), of the rims by satellite.
    """

    def __init__(self, ink: TrainInk, rates: Mapping[str, float], teeth: Mapping[str, int]) -> None:
        self.ink, self.rates, self.teeth, self.centre = ink, rates, teeth, ink.centre
        count = len(ink.axes)
        self.ways = [UP + FULL * k / count for k in range(count)]
        self.starts: dict[str, list[float]] = {}
        for mesh in ink.scheme.scheme.meshes:
            self._fit(mesh)

    def _fit(self, mesh: Mesh) -> None:
        """Let the teeth of a wheel and of its rims meet, those of the first satellite at any rate."""
        wheel, rim, sense, _ = mesh
        toward = [way + (FULL / 2 if sense > 0 else 0.0) for way in self.ways]
        share = sense * self.teeth[wheel] / self.teeth[rim]
        if rim in self.starts:
            off = (self.starts[rim][0] - toward[0]) % (FULL / self.teeth[rim])
            self.starts[wheel] = [self.ways[0] - off / share]
            return
        (own,) = self.starts.setdefault(wheel, [self.ways[0]])
        offs = [(own - way) % (FULL / self.teeth[wheel]) for way in self.ways]
        self.starts[rim] = [at - off * share for at, off in zip(toward, offs, strict=True)]

    def stands(self) -> Iterator[Ink]:
        """The centre lines, the circle of the satellites' axes, the ground of a ring."""
        ink, c = self.ink, self.centre
        for way in (1 + 0j, 1j):
            yield line("centre", c - ink.beyond * way, c + ink.beyond * way)
        yield circle("centre", c, ink.radius("H"))
        if ink.fixed in ink.central and ink.ring(ink.fixed):
            yield from ring_ground(c, ink.radius(ink.fixed) + RIM)

    def wheels(self) -> Iterator[RigidBody]:
        """The central wheels; the one that stands among them."""
        between = self.ways[0] - FULL / 2 / len(self.ways)
        for k, wheel in enumerate(self.ink.central):
            moves = (Rotation(self.centre, self.rates[wheel]),) if self.rates[wheel] else ()
            strokes, out = list[Ink](), -INSIDE
            if self.ink.ring(wheel):
                out = RIM + INSIDE + (HATCH_DEPTH if wheel == self.ink.fixed else 0.0)
                strokes = [circle("main", self.centre, self.ink.radius(wheel) + RIM)]
            spot = polar(self.ink.radius(wheel) + out, between - APART * k)
            letters = (self._letter(wheel, self.centre + spot),)
            yield from self._wheel(
                wheel, self.centre, self.starts[wheel][0], moves, strokes, letters
            )

    def satellites(self) -> Iterator[RigidBody]:
        """The rims of the satellites: carried round, they turn against the carrier."""
        own, carried = self.rates["2"] - self.rates["H"], Rotation(self.centre, self.rates["H"])
        for k, axis in enumerate(self.ink.axes):
            moves = (Rotation(axis, own), carried)
            for n, rim in enumerate(self.ink.rims):
                start = self.starts[rim][k]
                at = axis + polar(self.ink.radius(rim) - INSIDE, start + APART * (n + 2))
                yield from self._wheel(rim, axis, start, moves, (), (self._letter(rim, at),))

    def carrier(self) -> Iterator[RigidBody]:
        """The carrier; the main axis."""
        strokes: list[Ink] = [line("rod", self.centre, axis) for axis in self.ink.axes]
        for axis in self.ink.axes:
            strokes += turning_pair(axis)
        arm = self.ink.axes[-1] - self.centre
        letter = self._letter("H", self.centre + arm * (ALONG + 1j * INSIDE / abs(arm)))
        yield RigidBody(
            tuple(strokes), (Rotation(self.centre, self.rates["H"]),), letters=(letter,)
        )
        yield RigidBody(turning_pair(self.centre))

    def _letter(self, name: str, at: complex) -> Label:
        size = self.ink.heights.point
        return Label(name, at - 0.5j * size, size, "middle")

    def _wheel(
        self,
        name: str,
        centre: complex,
        start: float,
        moves: tuple[Rotation, ...],
        strokes: Sequence[Ink],
        letters: tuple[Label, ...],
    ) -> Iterator[RigidBody]:
        """A wheel on its centre: its pitch circle, a line by which its turns are seen, its teeth."""
        radius, way = self.ink.radius(name), polar(1.0, start)
        inner = radius if self.ink.ring(name) else 0.0
        outer = radius + (RIM if self.ink.ring(name) else 0.0)
        own = (circle("main", centre, radius), *strokes)
        seen = line("medium", centre + inner * way, centre + outer * way)
        yield RigidBody((*own, seen), moves, letters=letters)
        half = min(TOOTH, math.pi * radius / self.teeth[name] / 2)
        tooth = line("thin", centre + (radius - half) * way, centre + (radius + half) * way)
        yield RigidBody((tooth,), moves, self.teeth[name], centre)


PICTURES = TurningPictures(pictures)

"""The meshing as the wheels turn: both whole, or a rack that runs on; all that is constructed stands."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.gears.ink import MeshInk, draw_gear_ink
from graphic_tmm.chapters.gears.ink_rack import RackInk, rack_bodies
from graphic_tmm.chapters.gears.outline import outline, pitch_outline
from graphic_tmm.chapters.gears.plan import GEARS_PLAN
from graphic_tmm.chapters.gears.teeth import Wheel
from graphic_tmm.chapters.gears.toothed_rack import TEETH
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject
from graphic_tmm.page.turning import (
    WHOLE,
    RigidBody,
    Rotation,
    Shift,
    TurningPicture,
    TurningPictures,
    TurningValue,
)
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.views import mu_text
from graphic_tmm.scene.captions import captions

AROUND = 16.0
"""What is seen about the teeth that are drawn of both wheels, mm."""


def pictures(drawn: Drawn) -> Iterator[TurningPicture]:
    """Yield the meshing; wheel 1 drives, as its arrow says."""
    if (made := GEARS_PLAN.of(drawn)) is None:
        return
    language, ink = drawn.scene.language, MeshInk(drawn.reading, made)
    on = subject(drawn, captions(language)["gear"], "gears")
    shown = draw_gear_ink(on, made)
    stands = [stroke for stroke in shown.strokes if stroke.part not in ("tooth", "hatching")]
    first = ink.real(made.wheels[0].sizes.z)
    rates = [
        side * first / ink.real(wheel.sizes.z)
        for side, wheel in zip(ink.sides, made.wheels, strict=True)
    ]
    wheels = zip(made.wheels, rates, strict=True)
    bodies = [body for wheel, rate in wheels for body in _wheel(ink, wheel, rate, shown)]
    teeth = [stroke for wheel in made.wheels for stroke in outline(drawn.reading, wheel)]
    if not teeth:
        return
    values = [TurningValue(f"φ_{{{k}}}", "°", 1, abs(rate)) for k, rate in enumerate(rates, 1)]
    if ink.teeth is not None:
        teeth += rack_bodies(ink.teeth)
        far = first * abs(ink.teeth.pitch) / WHOLE
        bodies += _rack(ink.teeth, round(first), far, shown)
        values.append(TurningValue("s_{2}", "mm", 1, far * 1000 * ink.real(made.line.mu)))
    left, low, right, top = bounds(Drawing("", on.title, tuple(teeth)))
    yield TurningPicture(
        on.title,
        mu_text(drawn.scales["gear"], language),
        shown._replace(strokes=tuple(stands)),
        tuple(body for body in bodies if body.strokes),
        tuple(values),
        (left - AROUND, low - AROUND, right + AROUND, top + AROUND),
    )


def _wheel(ink: MeshInk, wheel: Wheel, rate: float, shown: Drawing) -> Iterator[RigidBody]:
    """Yield a whole wheel, one pitch of it as often as it has teeth; the band along its working flank."""
    centre = ink.at(wheel.circles.centre)
    moves = (Rotation(centre, rate),)
    teeth = round(ink.real(wheel.sizes.z))
    yield RigidBody(tuple(pitch_outline(ink.reading, wheel)), moves, teeth, centre)
    band = (one for one in shown.strokes if one.part == "hatching" and wheel.flank.slot in one.of)
    yield RigidBody(tuple(band), moves)


def _rack(rack: RackInk, teeth: int, far: float, shown: Drawing) -> Iterator[RigidBody]:
    """Yield a rack so long that its teeth are in mesh over a whole turn; the band along its working flank."""
    moves = (Shift(1 + 0j, far),)
    yield RigidBody(tuple(rack.toothed(-teeth - TEETH, TEETH)), moves)
    slot = rack.made.flank.slot
    band = (one for one in shown.strokes if one.part == "hatching" and slot in one.of)
    yield RigidBody(tuple(band), moves)


PICTURES = TurningPictures(pictures)

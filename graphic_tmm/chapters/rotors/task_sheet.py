"""What a task gives of a rotor, and what it asks for."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.rotors.task import ASKED, ROTOR
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.units import small, unit
from graphic_tmm.readers.task_sheet import SIZE, Given, Listed, TaskSheet, given_figure, given_speed
from graphic_tmm.scene.records import Scene


def given(scene: Scene) -> Iterator[Given]:
    """Yield planes and counterweights, bearings, the speed; the unbalances have a table of their own."""
    order = ASKED.of(scene)
    if order is None:
        return
    names = ("I", "II") if order.dynamic else ("k",)
    for name, place in zip(names, order.planes, strict=False):
        yield Given(f"x_{{{name}}}", place, SIZE)
    for letter, row, of in (("r", order.radius, SIZE), ("m", order.mass, "kg")):
        for k, name in enumerate(names if row else ()):
            yield Given(f"{letter}_{{{name}}}", row[min(k, len(row) - 1)], of)
    for name, place in zip("AB", order.bearings, strict=False):
        yield Given(f"x_{name}", place, SIZE)
    if order.speed:
        yield given_speed("1", order.speed)


def listed(scene: Scene, language: str) -> Iterator[Listed]:
    """Yield the unbalances, a row each."""
    order = ASKED.of(scene)
    if order is None:
        return
    _ = speaking(language)
    mm, rows = unit(small(1.0, language)[1], language), []
    for k, one in enumerate(order.unbalances, 1):
        size = one.D if one.D is not None else (one.mass or 0.0) * (one.radius or 0.0)
        lengths = (one.radius, one.at)
        radius, place = (
            "—" if x is None else given_figure(small(x, language)[0], language) for x in lengths
        )
        mass = "—" if one.mass is None else given_figure(one.mass, language)
        told = given_figure(size, language) if one.mass is None else "—"
        rows.append((str(k), mass, radius, told, given_figure(one.angle, language), place))
    heads = (
        _("No.", context="heading"), f"m, {unit('kg', language)}", f"r, {mm}",
        f"D, {unit('kg·m', language)}", "α, °", f"x, {mm}",
    )  # fmt: skip
    empty = [k for k in range(len(heads)) if rows and all(row[k] == "—" for row in rows)]
    kept = [k for k in range(len(heads)) if k not in empty]
    yield Listed(
        "unbalances",
        _(_TITLE),
        tuple(heads[k] for k in kept),
        tuple(tuple(row[k] for k in kept) for row in rows),
    )


def asks(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the polygons, the counterweights, the reactions of the bearings."""
    order = ASKED.of(scene)
    if order is None:
        return
    _ = speaking(language)
    yield _(_IN_MOTION if order.dynamic else _AT_REST)
    yield _(_MASSES if order.radius else _RADII)
    if order.bearings:
        yield _(_REACTIONS)


_TITLE = said("Unbalances of the rotor")
_AT_REST = said("The rotor is balanced at rest: draw the polygon of m·r and close it.")
_IN_MOTION = said(
    "The rotor is balanced in motion: draw the polygon of m·r·z about plane I, then that of m·r."
)
_MASSES = said("Find the mass of each counterweight, and read its angle off the drawing.")
_RADII = said("Find the radius of each counterweight, and read its angle off the drawing.")
_REACTIONS = said("Find the reactions of the bearings without counterweights.")

TASK_SHEET = TaskSheet(given=given, listed=listed, wanted={ROTOR: asks})

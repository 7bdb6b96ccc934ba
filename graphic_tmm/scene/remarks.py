"""What a scene says that comes to nothing, and defaults that matter: told, and not refused."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.forces.task import GRAVITY
from graphic_tmm.mechanism.masses import shared
from graphic_tmm.scene.checks import centres_of
from graphic_tmm.scene.quantities import KGF, in_kgf
from graphic_tmm.scene.records import SECTIONS, Scene
from graphic_tmm.scene.sections import Document, Parts

TABLES = {
    "accelerations": ("accelerations", "acceleration table", "results", "equations", "diagrams")
}
"""Places that show what is asked for elsewhere than in a section of its own."""


def remarks(doc: Document, parts: Parts) -> tuple[str, ...]:
    """Return, one line each, the sections that nothing reads, and the defaults that matter."""
    return (*_idle(doc, parts), *_defaults(doc, parts))


def _idle(doc: Document, parts: Parts) -> Iterator[str]:
    effects = parts.effects
    for key, name in (("load", "[[load]]"), ("effects", "[effects]"), ("friction", "[friction]")):
        if doc.get(key) and "forces" not in doc:
            yield f"{key}: nothing is computed of {name} without a section [forces]; add it, or take {name} out"
    if "friction" in doc and "forces" in doc and not (effects is not None and effects.friction):
        yield "friction: it does not act; write friction = true in [effects], or take [friction] out"
    gas = effects is not None and effects.gas and "forces" in doc
    if "indicator" in doc and not (gas or "flywheel" in doc or "engine" in doc):
        yield (
            "indicator: nothing asks for the gas; add [flywheel] or [engine], or gas = true in [effects] with "
            "[forces], or take [indicator] out"
        )


def _defaults(doc: Document, parts: Parts) -> Iterator[str]:
    effects = parts.effects
    weights = parts.forces is not None and effects is not None and effects.gravity
    if weights and effects is not None and effects.g is None and in_kgf(doc):
        yield (
            f"effects.g: it is left out, so weights are taken with {GRAVITY} m/s², while a kgf is {KGF} N; "
            f'write g = "{KGF} m/s^2", or the one that is meant'
        )
    if parts.forces is not None or parts.flywheel is not None:
        yield from _centres(parts)
    if parts.flywheel is not None and "constant" not in doc.get("flywheel", {}):
        yield (
            f"flywheel.constant: it is left out, so the {parts.flywheel.constant} moment is taken as constant; "
            'write constant = "resisting" for an engine, constant = "driving" for a machine that a motor drives'
        )


def _centres(parts: Parts) -> Iterator[str]:
    pins = shared(body.points for body in (parts.frame, *parts.links) if body is not None)
    bare = [link for link in parts.links if link is not None and link.centre is None]
    lone = {link.number: found[0] for link in bare if len(found := centres_of(link, pins)) == 1}
    if lone:
        first, letter = next(iter(lone.items()))
        numbers, letters = ", ".join(map(str, lone)), ", ".join(lone.values())
        yield (
            f"centre: it is left out of link {numbers}, so the link's only point in no pair is taken for its "
            f'mass centre: {letters}; write centre = "{letter}" in link {first}'
        )


def unplaced(scene: Scene) -> tuple[str, ...]:
    """Return, one line each, what the scene calls for and no sheet of it shows."""
    return tuple(_unplaced(scene))


def _unplaced(scene: Scene) -> Iterator[str]:
    by_loads = scene.flywheel is not None and scene.flywheel.indicator is None
    for section, places in SECTIONS.items():
        if not getattr(scene, section) or scene.shown & set(places):
            continue
        if section == "forces" and by_loads and "flywheel" in scene.shown:
            continue  # the flywheel is found by them
        listed = " or ".join(f'"{place}"' for place in places)
        yield f"{section}: no sheet shows it (table does); add {listed} to the place of a [[sheet]]"
    if scene.row.accelerations and not scene.shown & set(TABLES["accelerations"]):
        yield (
            'drive.accelerations: no sheet shows them (table does); add "accelerations" to the place of a '
            "[[sheet]]"
        )

"""What a scene says that comes to nothing, and defaults that matter: told, and not refused."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.language.said import joined, said
from graphic_tmm.mechanism.records import shared
from graphic_tmm.scene.chapter import chapters, places
from graphic_tmm.scene.checks import centres_of
from graphic_tmm.scene.places import called, of_section
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.registry import sections
from graphic_tmm.scene.sections import Parts

GAINED = "accelerations"
"""The plans that [drive] calls for at the positions that it names."""


def remarks(parts: Parts) -> tuple[str, ...]:
    """Return, one line each, the sections that nothing reads, and the defaults that matter."""
    there = list(parts.asked)
    idle = [line for section, told in there for line in section.idle(told, parts)]
    centres = _centres(parts) if any(section.weighs for section, _ in there) else ()
    defaults = [line for section, told in there for line in section.defaults(told, parts)]
    return (*idle, *_unsaid(parts), *centres, *defaults)


def _unsaid(parts: Parts) -> Iterator[str]:
    """Tell of words for chapters that the scene does not call for."""
    note = parts.said["note"]
    asked = {section.name for section, _ in parts.asked}
    there = [one for one in chapters() if called(one, asked, mechanism=parts.drive is not None)]
    names = {one.name for one in there} | {name for one in there for name in one.builds_on}
    for name in note.remarks if note is not None else ():
        if name not in names:
            yield said(
                "note.remarks.{name}: the scene asks for nothing of this chapter, so the note has no "
                "section for it",
                name=name,
            )


def _centres(parts: Parts) -> Iterator[str]:
    pins = shared(body.points for body in (parts.frame, *parts.links) if body is not None)
    bare = [link for link in parts.links if link is not None and link.centre is None]
    lone = {link.number: found[0] for link in bare if len(found := centres_of(link, pins)) == 1}
    if lone:
        first, letter = next(iter(lone.items()))
        numbers, letters = ", ".join(map(str, lone)), ", ".join(lone.values())
        yield said(
            "centre: it is left out of link {numbers}, so the link's only point in no pair is taken for its "
            'mass centre: {letters}; write centre = "{letter}" in link {first}',
            numbers=numbers,
            letters=letters,
            letter=letter,
            first=first,
        )


def unplaced(scene: Scene) -> tuple[str, ...]:
    """Return, one line each, what the scene calls for and no sheet of it shows."""
    return tuple(_unplaced(scene))


def _unplaced(scene: Scene) -> Iterator[str]:
    there = [section for section in sections() if section.name in scene.tasks]
    seen = [section for section in there if scene.shown & set(of_section(section))]
    shown = {name for section in seen for name in section.shows(scene.tasks[section.name])}
    for section in there:
        if section in seen or section.name in shown or not of_section(section):
            continue
        yield said(
            "{section}: no sheet shows it (table does); add {listed} to the place of a [[sheet]]",
            section=section.name,
            listed=joined(said(" or "), (f'"{place}"' for place in of_section(section))),
        )
    there_too = {name: one for name, (_, one) in places().items()}
    gained = {name for name, one in there_too.items() if GAINED in (*one.shows, *one.beside)}
    if scene.row.accelerations and not scene.shown & {GAINED, *gained}:
        yield said(
            'drive.{plans}: no sheet shows them (table does); add "{plans}" to the place of a [[sheet]]',
            plans=GAINED,
        )
    # other places show more than these plans
    only = {GAINED, *(name for name, one in there_too.items() if one.shows == (GAINED,))}
    if not scene.row.accelerations and (empty := sorted(scene.shown & only)):
        yield said(
            "{places}: nothing is there to be shown, for no position has a plan of accelerations; add "
            'accelerations = "all" to [drive], or the positions that are to have one',
            places=", ".join(empty),
        )

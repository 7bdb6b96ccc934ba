"""The file section by section: what each holds, and all that is wrong with it.

Sections are checked one by one, so that a fault in one hides none in another. A section whose only
fault is a key that it does not know is understood nevertheless.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import dataclass
from functools import cached_property
from typing import Any

from graphic_tmm.board.bounds import INTERVALS
from graphic_tmm.errors import StructureError, TmmError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism import synthesis
from graphic_tmm.scene import (
    author,
    drawing,
    length_task,
    lengths,
    letters,
    mechanism,
    quantities,
    registry,
)
from graphic_tmm.scene.bare import taken
from graphic_tmm.scene.declare import Flaw, Path, Section, build, keys_of
from graphic_tmm.scene.document import Document, as_table, raw_links
from graphic_tmm.scene.references import Outline, outline
from graphic_tmm.scene.registry import of_section, without_mechanism
from graphic_tmm.scene.tables import MOST, understood, unknown_key
from graphic_tmm.scene.units import SI, SYSTEMS, UNITS

FIRST = (
    Section("task", length_task.Task, "lengths found from a task"),
    Section("frame", mechanism.Frame, "the fixed link", always=True),
    Section("joints", mechanism.Joints, "joints of links in one position, by which links are told"),
    Section("link", mechanism.Link, "the moving links, in order", several=True),
    Section("mesh", mechanism.Mesh, "wheels on links, two in mesh each", several=True),
    Section(
        "drive", mechanism.Drive, "the driving link and its motion", further=mechanism.FurtherDrive
    ),
    Section("plans", drawing.Plans, always=True),
)
"""The sections of every scene that stand before those of chapters."""
LAST = (
    Section("scales", drawing.Scales, always=True),
    Section("hand", drawing.Hand, always=True),
    Section("sheet", drawing.SheetOrder, "the sheets", several=True),
    Section("title_block", drawing.TitleBlock, always=True),
    Section("note", author.Author, always=True),
)
"""Those that stand behind them."""
LENGTHS = "lengths"
"""The section that names lengths; it stands before all others."""

_EXAMPLES = {
    "frame": said("a section [frame] with the fixed points, O = [0, 0]"),
    "link": said("a section [[link]] for each moving link, with its number and points"),
    "drive": said('a section [drive] with link = 1 and speed = "380 rpm"'),
}


def declared() -> dict[str, Section]:
    """Return all sections of a scene, by name, in order."""
    return {one.name: one for one in (*FIRST, *registry.sections(), *LAST)}


@dataclass
class Parts:
    """What could be understood of a document.

    ``said``: what a section says, by name: None for one that could not be understood, or is not there; of those
    that may be there several times a list. ``head``: the keys before the first section. ``further``: what
    tables behind the first say, of sections that may be a list.
    """

    doc: Document
    head: drawing.Head | None
    said: Mapping[str, Any]
    further: Mapping[str, list[Any]]

    def record(self, name: str) -> Any:
        """Return the record of a section that no other has a part in; a list where there may be several."""
        record, said = declared()[name].record, self.said[name]
        if isinstance(said, list):
            return [None if one is None else build(record, one) for one in said]
        return None if said is None else build(record, said)

    @cached_property
    def frame(self) -> mechanism.Frame | None:
        """The fixed link."""
        found: mechanism.Frame | None = self.record("frame")
        return found

    @cached_property
    def links(self) -> list[mechanism.Link | None]:
        """The moving links, in order."""
        found: list[mechanism.Link | None] = self.record("link")
        return found

    @cached_property
    def drive(self) -> mechanism.Drive | None:
        """The driving link and its motion."""
        found: mechanism.Drive | None = self.record("drive")
        return found

    @cached_property
    def meshes(self) -> list[mechanism.Mesh | None]:
        """The wheels in mesh, two by two."""
        found: list[mechanism.Mesh | None] = self.record("mesh")
        return found

    @cached_property
    def further_drives(self) -> list[mechanism.FurtherDrive]:
        """The drives besides the first."""
        there = self.further.get("drive", [])
        return [build(mechanism.FurtherDrive, one) for one in there if one is not None]

    @cached_property
    def names(self) -> Outline:
        """The names of the file, whatever else is wrong."""
        return outline(self.doc)

    @property
    def chapter_sections(self) -> Iterator[tuple[Section, Any]]:
        """The sections of chapters that are there and could be understood, with what they say."""
        for section in registry.sections():
            said = self.said[section.name]
            if section.several:
                said = pairing(said, section.name)
            elif section.together is not None and said is not None:
                lone = not isinstance(self.doc[section.name], list)
                said = [((section.name,), *said)] if lone else pairing(said, section.name)
            if said is not None and (said or section.name in self.doc):
                yield section, said

    def moves(self, path: Path, letter: str) -> Iterator[Flaw]:
        """Tell of a letter that is no point of a moving link."""
        there = [name for _, link in raw_links(self.doc) for name in as_table(link.get("points"))]
        if there and letter not in there:
            says = said('"{letter}" is no point of a moving link', letter=letter[:20])
            what = said("points of moving links")
            yield Flaw(path, letters.unknown(says, letter, there, what))

    def intervals(self, section: str) -> Iterator[Flaw]:
        """Tell of a row that is too short for a diagram of a section."""
        if self.drive is not None and not INTERVALS.holds(self.drive.count):
            says = said(
                "a diagram needs {least} positions at least, there are {there}; write positions = 12 in "
                "[drive]",
                least=INTERVALS.least,
                there=self.drive.count,
            )
            yield Flaw((section,), says)


def measures(doc: Document) -> quantities.Measures:
    """Return what quantities of a document are kept in, and its g; the usual where it says nothing sound."""
    system = SYSTEMS.get(str(doc.get("units")), SYSTEMS[SI])
    with suppress(ValueError, StopIteration):
        own = next(one["g"] for one in map(as_table, doc.values()) if "g" in one)
        if (g := quantities.in_si(own, "acceleration")) > 0:
            return quantities.Measures(system, g)
    return quantities.Measures(system)


def understand(doc: Document) -> tuple[Parts, list[Flaw]]:
    """Check every section of a parsed document.

    Returns
    -------
    Parts
        What could be understood.
    list of Found
        What is wrong, in no particular order.
    """
    found = _top_level(doc)
    task, given = _task(doc, found)
    names = _named_lengths(doc, given, found)
    written = {key: doc[key] for key in keys_of(drawing.Head) if key in doc}
    head = understood(drawing.Head, written, (), names, found)
    said: dict[str, Any] = {"task": task}
    further: dict[str, list[Any]] = {}
    for name, section in declared().items():
        if section.several:
            said[name] = _several(section, doc.get(name, []), names, found)
        elif section.together is not None:
            said[name] = _one_or_several(section, doc.get(name), names, found)
        elif section.further is not None and isinstance(doc.get(name), list) and doc[name]:
            first, *rest = doc[name]
            said[name] = understood(section.record, first, (name, 0), names, found)
            further[name] = [
                understood(section.further, one, (name, k), names, found)
                for k, one in enumerate(rest, start=1)
            ]
        elif name not in said:
            there = section.always or name in doc
            raw, at = doc.get(name, {}), (name,)
            said[name] = understood(section.record, raw, at, names, found) if there else None
    return Parts(doc, build(drawing.Head, head) if head is not None else None, said, further), found


def _several(
    section: Section, items: object, names: Mapping[str, float], found: list[Flaw]
) -> list[Any]:
    name = section.name
    if not isinstance(items, list):
        says = said("write [[{name}]] in double brackets: there can be several", name=name)
        found.append(Flaw((name,), says))
        return []
    return [
        understood(section.record, item, (name, i), names, found) for i, item in enumerate(items)
    ]


def _one_or_several(
    section: Section, raw: object, names: Mapping[str, float], found: list[Flaw]
) -> list[Any] | None:
    """Return what a table says, or a list of them; None if there is none, or one could not be understood."""
    if raw is None:
        return None
    if isinstance(raw, list) and raw:
        several = _several(section, raw, names, found)
        return None if any(one is None for one in several) else several
    one = understood(section.record, raw, (section.name,), names, found)
    return None if one is None else [one]


def _top_level(doc: Document) -> list[Flaw]:
    known = [*keys_of(drawing.Head), LENGTHS, *declared()]
    strange = [key for key in doc if key not in known]
    found = [Flaw((key,), unknown_key(key, known)) for key in strange[:MOST]]
    for key, example in _EXAMPLES.items():
        if needs_mechanism(doc) and (key not in doc or doc[key] == []):
            found.append(Flaw((key,), said("it is missing; write {example}", example=example)))
    return found


def needs_mechanism(doc: Document) -> bool:
    """Whether a document asks for anything that cannot stand without a mechanism."""
    raw = doc.get("sheet")
    sheets = [as_table(sheet) for sheet in raw] if isinstance(raw, list) and raw else [{}]
    places = [place for s in sheets for place in _listed(s.get("place", []))]
    asked = any(key in doc for key in _EXAMPLES)
    asked = asked or any(s.name in doc and not s.alone for s in registry.sections())
    parts = any(s.name in doc and s.alone and of_section(s) for s in registry.sections())
    nothing = any("place" not in s for s in sheets) and not parts
    return asked or nothing or any(p not in without_mechanism() for p in places)


def _listed(value: object) -> list[object]:
    return list(value) if isinstance(value, (list, tuple)) else [value]


def _task(doc: Document, found: list[Flaw]) -> tuple[Any, dict[str, float]]:
    """Return what the task says, and the lengths it gives (NaN where they cannot be told)."""
    if "task" not in doc:
        return None, {}
    task = understood(length_task.Task, doc["task"], ("task",), {}, found)
    if task is None:
        kind = as_table(doc["task"]).get("kind")
        return None, _unknown(kind if isinstance(kind, str) else "")
    given = length_task.given_by(task.kind, lambda name: getattr(task, name))
    if flaws := list(length_task.task_flaws(task.kind, given)):
        found += flaws
        return task, _unknown(task.kind)
    try:
        return task, synthesis.lengths_found(task.kind, given)
    except StructureError as error:
        at = error.keys[0].split(".") if error.keys else ["task"]
        found.append(Flaw(tuple(at), error.says))
    except (ValueError, TmmError) as error:
        found.append(Flaw(("task",), error.args[0]))
    return task, _unknown(task.kind)


def _unknown(kind: str) -> dict[str, float]:
    """Return the lengths that a kind of task finds, none of which is known."""
    kinds = synthesis.KINDS
    return dict.fromkeys(kinds.get(kind, kinds["rocker"]).finds, math.nan)


def lengths_of(doc: Document) -> dict[str, float]:
    """Return the lengths that a document names, m; NaN for one that is faulty."""
    return _named_lengths(doc, _task(doc, [])[1], [])


def _named_lengths(
    doc: Document, given: Mapping[str, float], found: list[Flaw]
) -> dict[str, float]:
    """Return the lengths named by ``[lengths]`` and the task, m; NaN for one that is faulty."""
    raw = doc.get("lengths", {})
    if not isinstance(raw, dict):
        found.append(
            Flaw(("lengths",), said('write a section [lengths] with, for example, r = "0.3 m"'))
        )
        return dict(given)
    names = dict(given)
    for name, value in raw.items():
        if message := _name_fault(name, given):
            found.append(Flaw(("lengths", name), message))
        try:
            names[name] = quantities.parse(value, "length")
            found.extend(
                Flaw(("lengths", name), line, fault=False) for line in taken(value, "length")
            )
        except ValueError as error:
            names[name] = math.nan
            found.append(Flaw(("lengths", name), error.args[0]))
    return names


def _name_fault(name: str, given: Mapping[str, float]) -> str:
    if name in given:
        return said(
            '"{name}" is found by [task] already; take it out of [lengths], or the task', name=name
        )
    if not lengths.NAME.fullmatch(name) or len(name) > 40:
        return said(
            '"{name}" cannot name a length: letters and digits, first a letter, such as l2',
            name=name[:40],
        )
    if name in UNITS and UNITS[name].dimension == "length":
        return said(
            '"{name}" is a unit of length; choose another name, such as "l_{name}"', name=name
        )
    return ""


def pairing(items: list[Any], section: str) -> list[tuple[Path, Any]]:
    """Return the items of a list of tables that could be understood, each with its path."""
    return [((section, i), item) for i, item in enumerate(items) if item is not None]

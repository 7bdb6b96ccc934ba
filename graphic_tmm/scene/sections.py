"""The file section by section: what each holds, and all that is wrong with it.

Sections are checked one by one, so that a fault in one hides none in another. A section whose only
fault is a key that it does not know is understood nevertheless.
"""

from __future__ import annotations

import copy
import math
from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, TypeVar

from pydantic import BaseModel, ValidationError
from pydantic_core import ErrorDetails

from graphic_tmm.errors import TmmError
from graphic_tmm.scene import lengths, quantities
from graphic_tmm.scene import models as m
from graphic_tmm.scene.cam_tables import CamTable
from graphic_tmm.scene.document import Document as Document
from graphic_tmm.scene.faults import Found, from_pydantic, unknown_key
from graphic_tmm.scene.force_tables import (
    EffectsTable,
    EngineTable,
    ForcesTable,
    FrictionTable,
    LoadTable,
)
from graphic_tmm.scene.lines import Path
from graphic_tmm.scene.order_tables import DiagramsTable, FlywheelTable, IndicatorTable
from graphic_tmm.scene.records import FREE_PLACES, PART_PLACES
from graphic_tmm.scene.wheel_tables import GearsTable, PlanetaryTable

M = TypeVar("M", bound=BaseModel)

_EXAMPLES = {
    "frame": "a section [frame] with the fixed points, O = [0, 0]",
    "link": "a section [[link]] for each moving link, with its number and points",
    "drive": 'a section [drive] with link = 1 and speed = "380 rpm"',
}
_OF_MECHANISM = (
    "drive",
    "frame",
    "link",
    "diagrams",
    "flywheel",
    "forces",
    "engine",
    "load",
    "friction",
)
MOST = 100
"""So many faults of one table are put into words."""
_FOUND_BY_TASK = ("OA", "BC", "OB")


@dataclass
class Parts:
    """The sections that could be understood; None for one that could not."""

    head: m.Head | None
    task: m.TaskTable | None
    frame: m.FrameTable | None
    links: list[m.LinkTable | None]
    drive: m.DriveTable | None
    plans: m.PlansTable | None
    diagrams: DiagramsTable | None
    indicator: IndicatorTable | None
    flywheel: FlywheelTable | None
    effects: EffectsTable | None
    loads: list[LoadTable | None]
    forces: ForcesTable | None
    friction: FrictionTable | None
    engine: EngineTable | None
    cam: CamTable | None
    gears: GearsTable | None
    planetary: PlanetaryTable | None
    scales: m.ScalesTable | None
    hand: m.HandTable | None
    sheets: list[m.SheetTable | None]
    title_block: m.TitleBlockTable | None


def understand(doc: Document) -> tuple[Parts, list[Found]]:
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
    head = {key: doc[key] for key in m.Head.model_fields if key in doc}

    def section(model: type[M], key: str) -> M | None:
        return _one(model, doc.get(key, {}), (key,), names, found)

    def sections(model: type[M], key: str) -> list[M | None]:
        items = doc.get(key, [])
        if not isinstance(items, list):
            found.append(Found((key,), f"write [[{key}]] in double brackets: there can be several"))
            return []
        return [_one(model, item, (key, i), names, found) for i, item in enumerate(items)]

    def optional(model: type[M], key: str) -> M | None:
        return section(model, key) if key in doc else None

    parts = Parts(
        head=_one(m.Head, head, (), names, found),
        task=task,
        frame=section(m.FrameTable, "frame"),
        links=sections(m.LinkTable, "link"),
        drive=optional(m.DriveTable, "drive"),
        plans=section(m.PlansTable, "plans"),
        diagrams=optional(DiagramsTable, "diagrams"),
        indicator=optional(IndicatorTable, "indicator"),
        flywheel=optional(FlywheelTable, "flywheel"),
        effects=section(EffectsTable, "effects"),
        loads=sections(LoadTable, "load"),
        forces=optional(ForcesTable, "forces"),
        friction=optional(FrictionTable, "friction"),
        engine=optional(EngineTable, "engine"),
        cam=optional(CamTable, "cam"),
        gears=optional(GearsTable, "gears"),
        planetary=optional(PlanetaryTable, "planetary"),
        scales=section(m.ScalesTable, "scales"),
        hand=section(m.HandTable, "hand"),
        sheets=sections(m.SheetTable, "sheet"),
        title_block=section(m.TitleBlockTable, "title_block"),
    )
    return parts, found


def _top_level(doc: Document) -> list[Found]:
    known = list(m.SceneFile.model_fields)
    strange = [key for key in doc if key not in known]
    found = [Found((key,), unknown_key(key, known)) for key in strange[:MOST]]
    for key, example in _EXAMPLES.items():
        if needs_mechanism(doc) and (key not in doc or doc[key] == []):
            found.append(Found((key,), f"it is missing; write {example}"))
    return found


def needs_mechanism(doc: Document) -> bool:
    """Whether a document asks for anything that cannot stand without a mechanism."""
    raw = doc.get("sheet")
    sheets = [table(sheet) for sheet in raw] if isinstance(raw, list) and raw else [{}]
    places = [place for s in sheets for place in _listed(s.get("place", []))]
    asked = any(key in doc for key in _OF_MECHANISM)
    nothing = any("place" not in s for s in sheets) and not any(key in doc for key in PART_PLACES)
    return asked or nothing or any(p not in (*FREE_PLACES, *PART_PLACES) for p in places)


def _listed(value: object) -> list[object]:
    return list(value) if isinstance(value, (list, tuple)) else [value]


def _one(
    model: type[M], raw: object, root: Path, names: Mapping[str, float], found: list[Found]
) -> M | None:
    """One table as its model; None if it has faults other than keys that it does not know."""
    try:
        return model.model_validate(raw, context=names)
    except ValidationError as error:
        details = _without_echoes(error.errors(include_url=False), root)
    found.extend(from_pydantic(detail, root) for detail in details[:MOST])
    if any(detail["type"] != "extra_forbidden" for detail in details):
        return None
    known = copy.deepcopy(raw)
    for detail in details:
        _take_out(known, _path(detail))
    try:
        return model.model_validate(known, context=names)
    except ValidationError:  # a key that was asked for stands there misspelt
        return None


def _without_echoes(details: list[ErrorDetails], root: Path) -> list[ErrorDetails]:
    """Leave out a key that is missing only because it stands there misspelt."""
    misspelt = {
        (*path[:-1], quantities.near(str(path[-1]), m.keys_of((*root, *path[:-1])), 0.6))
        for path in (_path(d) for d in details[:MOST] if d["type"] == "extra_forbidden")
    }
    return [d for d in details if d["type"] != "missing" or _path(d) not in misspelt]


def _path(detail: ErrorDetails) -> Path:
    return tuple(part for part in detail["loc"] if part not in m.TAGS)


def _take_out(raw: Any, path: Path) -> None:
    for part in path[:-1]:
        raw = raw[part]
    del raw[path[-1]]


def _task(doc: Document, found: list[Found]) -> tuple[m.TaskTable | None, dict[str, float]]:
    """Return the task, and the lengths it gives (NaN where they cannot be told)."""
    if "task" not in doc:
        return None, {}
    task = _one(m.TaskTable, doc["task"], ("task",), {}, found)
    if task is None:
        return None, dict.fromkeys(_FOUND_BY_TASK, math.nan)
    from graphic_tmm.mechanism.synthesis import rocker_lengths

    try:
        return task, dict(rocker_lengths(task.K_v, task.stroke, task.OB))
    except (ValueError, TmmError) as error:
        found.append(Found(("task",), str(error)))
        return task, dict.fromkeys(_FOUND_BY_TASK, math.nan)


def _named_lengths(
    doc: Document, given: Mapping[str, float], found: list[Found]
) -> dict[str, float]:
    """Return the lengths named by ``[lengths]`` and the task, m; NaN for one that is faulty."""
    raw = doc.get("lengths", {})
    if not isinstance(raw, dict):
        found.append(
            Found(("lengths",), 'write a section [lengths] with, for example, r = "0.3 m"')
        )
        return dict(given)
    names = dict(given)
    for name, value in raw.items():
        if message := _name_fault(name, given):
            found.append(Found(("lengths", name), message))
        try:
            names[name] = quantities.parse(value, "length")
        except ValueError as error:
            names[name] = math.nan
            found.append(Found(("lengths", name), str(error)))
    return names


def _name_fault(name: str, given: Mapping[str, float]) -> str:
    if name in given:
        return f'"{name}" is found by [task] already; take it out of [lengths], or the task'
    if not lengths.NAME.fullmatch(name) or len(name) > 40:
        return f'"{name[:40]}" cannot name a length: letters and digits, first a letter, such as l2'
    if name in quantities.UNITS and quantities.UNITS[name].dimension == "length":
        return f'"{name}" is a unit of length; choose another name, such as "l_{name}"'
    return ""


def pairing(items: list[M | None], section: str) -> list[tuple[Path, M]]:
    """Return the items of a list of tables that could be understood, each with its path."""
    return [((section, i), item) for i, item in enumerate(items) if item is not None]


def texts(doc: Document) -> list[tuple[Path, str]]:
    """Every text of a document that is drawn, with its path: titles, names, letters."""
    drawn: list[tuple[Path, str]] = [(("title",), doc.get("title", ""))]
    for key, value in table(doc.get("title_block")).items():
        drawn.append((("title_block", key), value))
    drawn.extend((("frame", key), key) for key in table(doc.get("frame")) if key != "number")
    for path, link in raw_links(doc):
        drawn.append(((*path, "name"), link.get("name", "")))
        for part in ("points", "guides"):
            drawn.extend(((*path, part, key), key) for key in table(link.get(part)))
    return [(path, value) for path, value in drawn if isinstance(value, str)]


def raw_links(doc: Document) -> list[tuple[Path, Document]]:
    """Return the links as they stand in the document, understood or not."""
    links = doc.get("link")
    if not isinstance(links, list):
        return []
    return [(("link", i), link) for i, link in enumerate(links) if isinstance(link, dict)]


def table(value: object) -> Document:
    """Return a value of the document if it is a table, else an empty one."""
    return value if isinstance(value, dict) else {}

"""The drives of a scene that is drawn: which links are driven, where they stand, as its tables say it."""

from __future__ import annotations

import math
from collections.abc import Mapping, Sequence
from typing import Any

from graphic_tmm.mechanism.records import Drive, Mechanism
from graphic_tmm.scene.coordinates import OTHER_EXTREME
from graphic_tmm.scene.document import Document, as_table
from graphic_tmm.scene.quantities import in_si
from graphic_tmm.scene.records import Scene

SAME = 1e-9
"""A drive that stands nearer to where it stood, m or degrees, has not moved."""
STEP = 1e-3
"""Where a sliding drive begins is written so fine, m; one that turns in whole degrees."""
TURN = 360.0
OF_ROW = ("positions", "first", "accelerations")
"""What the first drive says of the row of positions, whichever link it drives."""
OF_MOTION = ("speed", "acceleration", "turns")
"""What any drive says of its motion."""


def drive_tables(
    doc: Document,
    links: Sequence[int],
    way: Mapping[str, Any] | None = None,
    starts: Mapping[int, str] | None = None,
) -> Any:
    """Return the drives of a scene, of the links that are driven now: a table, or a list of them.

    ``way``: what is new of the row of the first; ``starts``: where those behind it begin, by link.
    """
    tables = tables_of_drives(doc)
    known = {one.get("link"): one for one in tables}
    first, *further = links
    made = [{**first_table(doc, first), **(way or {})}]
    for link in further:
        kept = {key: one for key, one in known.get(link, {}).items() if key in (*OF_MOTION, "at")}
        plain = {key: one for key, one in kept.items() if not isinstance(one, list)}
        start = {"at": (starts or {})[link]} if link in (starts or {}) else {}
        made.append({"link": link, "speed": 0, **plain, **start})
    if further:
        made[0] = _without_extremes(made[0])
    return made if len(made) > 1 or isinstance(doc.get("drive"), list) else made[0]


def _without_extremes(first: Document) -> Document:
    """Return the first of several drives without extremes of a point: these hang on all drives."""
    extra = [one for one in first.get("extra", []) if not _is_extreme(one)]
    rest = {key: one for key, one in first.items() if key != "extra" and not _is_extreme(one)}
    return {**rest, "extra": extra} if extra else rest


def _is_extreme(told: object) -> bool:
    return isinstance(told, dict) or told == OTHER_EXTREME


def first_table(doc: Document, link: int) -> Document:
    """Return the table of the drive whose row a scene has, of the link that it drives now."""
    was, *further = tables_of_drives(doc)
    known = next((one for one in further if one.get("link") == link), None)
    if known is None:
        return {"link": link, **{key: one for key, one in was.items() if key != "link"}}
    row = {key: was[key] for key in OF_ROW if not isinstance(was.get(key, []), list)}
    return {"link": link, **{k: one for k, one in known.items() if k in OF_MOTION}, **row}


def tables_of_drives(doc: Document) -> list[Document]:
    """Return the tables of a scene's drives; of one that has none that of a drive that stands."""
    told = doc.get("drive", {"speed": 0})
    return [as_table(one) for one in told] if isinstance(told, list) else [as_table(told)]


def starts_of(
    drives: Sequence[Drive], at: Sequence[float], zero: float, before: Mechanism | None
) -> dict[int, str]:
    """Return where the drives behind the first begin, by link, as a scene says it; none that has not moved.

    ``at``: where all stand now; ``zero``: where the first begins; ``before``: the mechanism that the scene had.
    """
    first, *further = drives
    gone = at[0] - zero if first.slides else math.radians(at[0] - zero)
    known = {one.link: one for one in before.further} if before is not None else {}
    found = {}
    for one, there in zip(further, at[1:], strict=True):
        by = one.speed / first.speed * gone if first.speed else 0.0
        start = there - (by if one.slides else math.degrees(by))
        was = known.get(one.link)
        if was is not None and _apart(start, was.start, turns=not one.slides) < SAME:
            continue
        found[one.link] = (
            f"{round(start / STEP)} mm" if one.slides else f"{round(start % TURN)} deg"
        )
    return found


def zero_of(scene: Scene | None, first: int, way: Mapping[str, str]) -> float:
    """Return where the first of several drives begins, degrees or m; ``way``: what is new of its row."""
    if "from" in way:
        return in_si(way["from"], "length")
    before = scene.mechanism if scene is not None else None
    if scene is None or before is None or any(one.link == first for one in before.further):
        return 0.0
    row = scene.row
    ends = row.ends or row.places
    return ends[0] if ends else row.zero if isinstance(row.zero, float) else 0.0


def _apart(one: float, other: float, *, turns: bool) -> float:
    off = abs(one - other)
    return min(off % TURN, -off % TURN) if turns else off

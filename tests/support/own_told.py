"""What a report tells of a drawing of the own student, against what is wrong with it; words by hand."""

from __future__ import annotations

import re
import tempfile
from collections.abc import Iterator, Mapping
from functools import cache
from typing import NamedTuple

from graphic_tmm.checking.check import Checker
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import WRONG, Judged, Likely, Report
from graphic_tmm.errors import SceneError
from graphic_tmm.language.reader import hear
from graphic_tmm.scene.read import read

from .own_student.machines import MACHINES
from .own_student.mistakes import KINDS, Kind
from .own_student.student import Drawing, due_factors, student

SURE = 0.8
NAMED = ("mistake", "slip", "instrument")
FAMILIES = {
    "direction": "direction turn operand parallel perpendicular across",
    "factor": "factor power scale table times given",
    "ratio": "ratio factor operand end",
    "mirror": "mirror sense side meeting end operand",
    "position": "position before operand table",
    "operand": "operand given",
    "table": "table factor slip amiss",
    "sign": "sign sense table",
    "sense": "sense sign end direction",
    "power": "power factor",
    "left out": "left out omission zero missing factor",
    "start": "start operand end",
    "given": "given length start factor",
    "meeting": "meeting side mirror",
    "count": "start count crank position sense given",
    "instrument": "instrument ruler",
    "unit": "unit scale table",
    "copy": "copy scale instrument",
}
"""Which words of a family, as the report calls it, are right for ours: by hand."""
WHERE = re.compile(r"Plan of positions|, step \d+|,? at position \S+ only|,? in every such step")
"""What a sentence says of the place, which is no part of the name."""
TITLES = {
    "positions": "Plan of positions",
    "velocities": "Velocity plan",
    "accelerations": "Acceleration plan",
    "forces": "Group",
    "diagrams": "diagram",
}


class Told(NamedTuple):
    """What a report says of a drawing first: whether it is named, and what of that is right."""

    named: bool
    place: bool
    family: bool
    name: bool
    sure: bool
    says: str


@cache
def checker(name: str) -> Checker:
    """Return the checker of a machine's scene, in English; the hand draws once for all drawings."""
    hear("en")
    return Checker(read(MACHINES[name].scene).spoken_in("en"))


def report_of(drawing: Drawing) -> Report | str:
    """Return the report on a drawing, or why there is none."""
    with tempfile.NamedTemporaryFile("w", suffix=".csv", encoding="utf-8") as file:
        file.write(drawing.csv)
        file.flush()
        try:
            return checker(drawing.machine.name).of(read_readings(file.name), file.name).report
        except SceneError as error:
            return f"refused: {error}"
        except (ValueError, IndexError, KeyError, TypeError, AssertionError) as error:
            return f"crashed: {type(error).__name__}: {error}"


def with_mistake(
    kind: Kind,
    turn: int,
    first: int = 0,
    *,
    own: bool = True,
    mu_rows: bool = True,
    ways: tuple[str, ...] = (),
) -> Drawing:
    """Return a drawing with a mistake that can be seen on it; ``turn`` picks the machine and the way."""
    machine = MACHINES[kind.machines[turn % len(kind.machines)]]
    ways = ways or kind.ways
    way = ways[(turn + turn // len(kind.machines)) % len(ways)]
    mu = None if own else due_factors(machine)
    start = first + turn + 20_000 * KINDS.index(kind)  # another student for each kind
    for seed in range(start, start + 20_000, 1000):
        try:
            return student(machine, seed, kind, way=way, mu=mu, mu_rows=mu_rows)
        except ValueError:
            continue
    raise ValueError(f"{kind.name} shows nowhere on {machine.name}")


def kind_of(name: str) -> Kind:
    """Return the kind of mistake that has a name."""
    return next(kind for kind in KINDS if kind.name == name)


def _place(one: Likely, drawing: Drawing) -> bool:
    """Whether a finding stands at the plan, segment and position of the mistake, or its sentence says so."""
    truth = drawing.truth
    assert truth is not None
    if truth.family in ("copy", "unit", "instrument"):
        return True
    if truth.plan != "forces" and one.position != (
        "" if truth.position is None else str(truth.position)
    ):
        return truth.family == "position" and not one.position
    if truth.family in ("position", "count"):
        return True
    says = " ".join((one.says, *one.like))
    plan = one.plan in (truth.plan, "") or TITLES[truth.plan] in says or truth.family == "given"
    words = re.findall(r"[\w^]+", says)
    names = {one.segment, one.step.strip("()"), *words, *(word.partition("_")[2] for word in words)}
    return plan and (not truth.segments or bool(names & set(truth.segments)))


def _blamed(report: Report, drawing: Drawing) -> bool:
    """Whether most readings that are wrong by themselves are those of the mistake."""
    truth = drawing.truth
    assert truth is not None
    own = [one for one in report.readings if one.verdict == WRONG and one.follows is None]
    right = [one for one in own if _of(one, drawing)]
    return bool(right) and 2 * len(right) >= len(own)


def _of(one: Judged, drawing: Drawing) -> bool:
    truth = drawing.truth
    assert truth is not None
    here = truth.position is None or one.taken.position == str(truth.position)
    segment = not truth.segments or bool(
        {one.taken.segment, one.step.strip("()")} & set(truth.segments)
    )
    return one.taken.plan == truth.plan and here and segment


def told(report: Report, drawing: Drawing) -> Told:
    """Compare what is told first with the truth; of several that nothing tells apart any may be right."""
    truth = drawing.truth
    assert truth is not None
    first = next((one for one in report.mistakes if one.kind in NAMED), None)
    if first is None and any(re.search(truth.words, says) for says in report.head):
        return Told(True, True, True, True, False, report.head[0])
    if first is None:
        text = "; ".join(f"{one.kind}: {one.name}" for one in report.mistakes[:2])
        says = text or f"nothing ({report.wrong} wrong)"
        return Told(False, _blamed(report, drawing), False, False, False, says)
    words = WHERE.sub("", " | ".join((first.name, first.says, *first.like)))
    place = _place(first, drawing)
    allowed = FAMILIES[truth.family].split()
    name = place and re.search(truth.words, words) is not None
    family = name or (
        place and any(word in f"{first.family} {first.kind} {words}" for word in allowed)
    )
    where = f"{first.plan} {first.segment}/{first.step} {first.position}".strip()
    says = f"{first.kind}/{first.family} {where} {first.chance:.2f}: {'; or '.join((first.says, *first.like))}"
    return Told(True, place, family, name, first.chance >= SURE, says)


def scales(report: Report, drawing: Drawing) -> Iterator[tuple[str, str]]:
    """Yield of each plan whether the student's own scale factor was told right, not at all, or falsely."""
    entries: Mapping[str, object] = {one.plan: one for one in getattr(report, "scales", ())}
    for plan, ratio in drawing.ratios.items():
        if f"\n{plan}" not in drawing.csv:
            continue
        one = entries.get(plan)
        mu, due = getattr(one, "mu", None), getattr(one, "due", None)
        said = mu / due if mu and due else 1.0
        if abs(said / ratio - 1) < 0.02:
            yield plan, "due" if abs(ratio - 1) < 0.02 else "right"
        else:
            yield plan, "not told" if abs(said - 1) < 0.02 else "false"

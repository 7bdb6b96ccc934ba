"""A bound is stated once: what the schema tells, what a scene may say and what a plan takes are the same."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any, NamedTuple

import pytest
from support.each import each

from graphic_tmm.board.bounds import Bound, TaskError
from graphic_tmm.chapters.cam.kinds_spring import SpringTask
from graphic_tmm.chapters.cam.refusals import refuse
from graphic_tmm.chapters.cam.task import CamTask
from graphic_tmm.chapters.gears.refusals import refuse_order
from graphic_tmm.chapters.gears.task import GearTask
from graphic_tmm.chapters.trains.refusals import scheme_of
from graphic_tmm.chapters.trains.task import Limits, PlanetaryTask
from graphic_tmm.errors import SceneError
from graphic_tmm.scene.declare import Kind, keys_of
from graphic_tmm.scene.new import schema
from graphic_tmm.scene.read import read
from graphic_tmm.scene.values import follows

GOOD: Mapping[str, dict[str, Any]] = {
    "cam": {"stroke": "20 mm", "rise": 90, "fall": 100, "upper_dwell": 30, "pressure": 30},
    "gears": {"z1": 21, "z2": 34, "m": "5 mm"},
    "planetary": {"module": "4 mm", "speed": "100 1/s", "ratio": 4.6, "satellites": 3},
}
RECORDS = {"cam": CamTask, "gears": GearTask, "planetary": PlanetaryTask}
TABLES = {"cam": "CamTable", "gears": "GearsTable", "planetary": "PlanetaryTable"}
LISTED = {"stations", "behind", "before", "closed", "teeth"}
SLIGHT = 1e-6


class Case(NamedTuple):
    section: str
    key: str
    value: float
    fine: bool


def _beside(end: float, whole: bool) -> Iterator[float]:
    yield from (end - 1, end, end + 1) if whole else (end - SLIGHT, end, end + SLIGHT)


def _cases() -> Iterator[Case]:
    """At each end of each bound that the schema of a section tells, and just beyond it on both sides."""
    definitions = schema()["$defs"]
    for section, name in TABLES.items():
        for key, told in definitions[name]["properties"].items():
            for end, whole in _ends(told):
                for value in _beside(end, whole):
                    yield Case(section, key, int(value) if whole else value, _told(told, value))


def _numbers(told: dict[str, Any]) -> Iterator[dict[str, Any]]:
    """Every description of a number in that of a key, in lists too."""
    if told.get("type") in ("number", "integer"):
        yield told
    for other in (*told.get("anyOf", []), *([told["items"]] if "items" in told else [])):
        if isinstance(other, dict):
            yield from _numbers(other)


def _ends(told: dict[str, Any]) -> set[tuple[float, bool]]:
    names = ("minimum", "maximum", "exclusiveMinimum", "exclusiveMaximum")
    return {
        (one[name], one["type"] == "integer")
        for one in _numbers(told)
        for name in names
        if name in one
    }


def _told(told: dict[str, Any], value: float) -> bool:
    """Whether a schema takes a number, read here by hand."""
    return any(
        value >= one.get("minimum", -math.inf)
        and value <= one.get("maximum", math.inf)
        and value > one.get("exclusiveMinimum", -math.inf)
        and value < one.get("exclusiveMaximum", math.inf)
        for one in _numbers(told)
    )


CASES = list(_cases())


def _written(folder: Path, section: str, changes: Mapping[str, object]) -> Path:
    keys = GOOD[section] | dict(changes)
    if "transmission" in changes:
        del keys["pressure"]
    if "closed" in changes:
        del keys["ratio"]
        keys["teeth"] = [24, 24, 72]
    lines = [f"{k} = {v!r}".replace("'", '"') for k, v in keys.items()]
    path = folder / "scene.toml"
    head = 'title = "T"\nlanguage = "en"\n[[sheet]]\nplace = ["{}"]\n[{}]\n'
    path.write_text(head.format(section, section) + "\n".join(lines) + "\n", encoding="utf-8")
    return path


PHASES = ("rise", "fall", "upper_dwell", "lower_dwell")


def _together(case: Case) -> dict[str, float]:
    """Return the other keys with which a value makes sense: phases make a turn, limits stand in order."""
    if case.section == "cam" and case.key in PHASES:
        others = [key for key in PHASES if key != case.key]
        rest = max(360.0 - case.value, 3e-7)
        return dict.fromkeys(others, rest / 3)
    if case.section == "planetary" and case.key in ("least", "most", "ring_most"):
        return {"least": 1, "most": 1000, "ring_most": 1000}
    return {}


def _accepted(folder: Path, case: Case) -> bool:
    """Whether a scene with the value is read; a refusal has to name the key and its line."""
    value: object = [case.value] if case.key in ("stations",) else case.value
    value = [case.value, 20] if case.key in ("behind", "before") else value
    value = [case.value, "?", "?"] if case.key == "teeth" else value
    value = [["H", case.value, 20], ["3", 60, 30]] if case.key == "closed" else value
    path = _written(folder, case.section, {**_together(case), case.key: value})
    faults = _faults(path)
    text = path.read_text(encoding="utf-8").splitlines()
    own = 1 + next(k for k, line in enumerate(text) if line.startswith(f"{case.key} = "))
    assert set(faults) <= {(f"{case.section}.{case.key}", own)}
    return not faults


def _faults(path: Path) -> list[tuple[str, int]]:
    try:
        read(path)
    except SceneError as error:
        return [(fault.key, fault.line) for fault in error.faults]
    return []


def test_there_is_a_bound_for_whatever_the_plans_bound() -> None:
    found = {(case.section, case.key) for case in CASES}
    for section, record in RECORDS.items():
        kinds = {key: one.kind for key, one in keys_of(record).items()}
        for key, kind in kinds.items():
            # a length, a moment, a scale, a speed has a unit: no schema tells its bounds
            if (
                isinstance(kind, Kind)
                and kind.bound
                and not kind.unit.startswith(("len", "scale", "mom", "angular speed"))
            ):
                assert (section, key) in found


@pytest.mark.parametrize("case", CASES, ids=lambda c: f"{c.section}.{c.key}={c.value:.10g}")
def test_what_the_schema_tells_the_scene_takes(case: Case, tmp_path: Path) -> None:
    fine = case.fine and (case.section, case.key, case.value) != ("planetary", "ratio", 0.0)
    assert _accepted(tmp_path, case) == fine, case


def _order(folder: Path, section: str) -> Any:
    return read(_written(folder, section, {})).tasks[section]


PLANS = {"cam": refuse, "gears": refuse_order, "planetary": scheme_of}
FIELDS = {
    "parts": "divisions",
    "transmission": "pressure",
    "mu_dS": "mu_V",
    "mu_ddS": "mu_A",
}


OWN = ("mu_theta", "mu_l")
"""Keys of no field of an order that its refusals look at."""
PLANNED = [case for case in CASES if case.key not in OWN]


@pytest.mark.parametrize("case", PLANNED, ids=lambda c: f"{c.section}.{c.key}={c.value:.10g}")
def test_what_the_schema_tells_the_plan_takes(case: Case, tmp_path: Path) -> None:
    order, key, value = _order(tmp_path, case.section), FIELDS.get(case.key, case.key), case.value
    if key in ("least", "most", "ring_most"):
        limits = Limits(**_together(case) | {key: int(value)})  # type: ignore[arg-type]
        changed = replace(order, limits=limits)
    elif key == "reserve":
        changed = replace(order, spring=SpringTask(0.5, reserve=value), speed=30.0)
    elif key in ("teeth", "satellites", "stations", "behind", "before"):
        listed = {"teeth": (value, None, None), "satellites": (value,), "stations": (value,)}
        listed |= dict.fromkeys(("behind", "before"), ((value, 20),))
        changed = replace(order, **{key: listed[key]})
    elif key == "closed":
        closed = (("H", (value, 20)), ("3", (60, 30)))
        changed = replace(order, ratio=None, teeth=(24, 24, 72), closed=closed)  # type: ignore[arg-type]
    else:
        changed = replace(order, **_together(case) | {key: value})
    refused = _refused(case.section, changed)
    assert refused in (None, (case.section, case.key), (case.section, key))
    assert (refused is None) == case.fine, case


def _refused(section: str, order: Any) -> tuple[str, str] | None:
    try:
        PLANS[section](order)
    except TaskError as error:
        return error.key
    return None


@pytest.mark.parametrize(
    ("bound", "inside", "outside"),
    [
        (Bound(4, 360, whole=True), (4, 360, 5.0), (3, 361, 4.5, True, "4", None)),
        (Bound(0, 1, above=True, below=True), (0.5, 1e-9), (0, 1, math.nan, math.inf)),
        (Bound(0, above=True), (1e-300, 1e300), (0, -0.0, -1, math.inf)),
        (Bound(-5, 5), (-5, 5, 0), (-5.1, 5.1)),
    ],
)
def test_a_bound_holds_what_it_says(bound: Bound, inside: tuple, outside: tuple) -> None:
    assert all(bound.holds(x) for x in inside)
    assert not any(bound.holds(x) for x in outside)
    for x in outside:
        with pytest.raises(TaskError, match=r"^gears: z1 = .* is wanted$") as caught:
            bound.refuse("gears", "z1", x)
        assert caught.value.key == ("gears", "z1")


def test_a_refusal_of_the_plan_has_its_key_and_line_in_the_scene(tmp_path: Path) -> None:
    for section, changes, key, says in (
        ("cam", {"lower_dwell": 10}, "cam.lower_dwell", "change the lower dwell to 140"),
        ("cam", {"rise": 300}, "cam.rise", "shorten them"),
        ("cam", {"stroke": "-2 mm"}, "cam.stroke", "a number greater than 0 is wanted"),
        (
            "cam",
            {"least_curvature": "-1 mm", "follower": "flat"},
            "cam.least_curvature",
            "not less than 0",
        ),
        ("gears", {"stations": ["-3 mm"]}, "gears.stations", "positive"),
        ("planetary", {"least": 60, "most": 50}, "planetary.least", "from 60 to 50"),
        ("planetary", {"module_2": "5 mm"}, "planetary.module_2", "a single row has one module"),
    ):
        with pytest.raises(SceneError) as caught:
            read(_written(tmp_path, section, changes))
        (fault,) = caught.value.faults
        assert fault.key == key
        assert says in fault.message
        assert fault.line > 5


@each(
    "places, in_order",
    [
        ((0.0, 0.4, 1.0), True),
        ((0.0, 0.4, 0.4, 1.0), True),
        ((0.0, 0.0, 1.0, 1.0), True),
        ((0.0, 0.4, 0.4, 0.4, 1.0), False),
        ((0.0, 0.4, 0.3), False),
        ((0.4, 0.3), False),
    ],
)
def test_places_of_a_table_ascend_and_two_alike_are_a_jump(
    places: tuple[float, ...], in_order: bool
) -> None:
    assert follows(places) is in_order

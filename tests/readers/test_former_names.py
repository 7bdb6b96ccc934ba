"""One name for one segment, by the letters of its plan; the names of earlier versions are read for ever."""

from __future__ import annotations

import csv
from collections import defaultdict
from pathlib import Path

import pytest
from click.testing import CliRunner
from support import asked, gallery
from support.gallery import CASES
from support.scenes import written

import graphic_tmm as tmm
from graphic_tmm.__main__ import main
from graphic_tmm.chapters.kinematics.views import acceleration_table, acceleration_views
from graphic_tmm.checking.readings.names import segment_meant, segments_of
from graphic_tmm.checking.readings.writing import result_columns
from graphic_tmm.checking.template import rows_of
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.readers.columns import FORMER
from graphic_tmm.readers.protocol import protocol
from graphic_tmm.readers.table import scene_columns, scene_results
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

pytestmark = pytest.mark.every

NOW = {
    "accelerating-crank": {"nab": "an2", "tab": "n2b", "na": "πn1", "ta": "n1a", "noa": "πn1", "toa": "n1a"},
    "lever": {"nab": "an2", "tab": "n2b", "ncb": "πn3", "tcb": "n3b", "nde": "dn4", "tde": "n4e"},
    "scotch-yoke": {"raa3": "aa3"},
    "windrower": {"kaa3": "ak2", "raa3": "k2a3", "nba3": "πn3", "tba3": "n3a3", "ncd": "cn4", "tcd": "n4d"},
}  # fmt: skip
"""The names that versions before 0.13 printed for components of accelerations, and what stands on the sheet."""
CRANK = """
title = "T"
[frame]
C = [0, 0]
E = ["210 mm", "-30 mm"]
[[link]]
number = 1
points = { C = [0, 0], B = ["60 mm", 0] }
[[link]]
number = 2
points = { B = [0, 0], D = ["200 mm", 0] }
[[link]]
number = 3
points = { E = [0, 0], D = ["150 mm", 0] }
side = "left of BE"
[drive]
link = 1
speed = "60 rpm"
acceleration = "12 1/s^2"
positions = 6
zero = "40 deg"
accelerations = [0, 2]
[[sheet]]
place = ["positions", "velocities", "accelerations"]
"""
"""A four-bar linkage that speeds up; what its crank turns about is called C, its pin B."""
OLD = {
    "ncb": "πn1",
    "tcb": "n1b",
    "nb": "πn1",
    "tb": "n1b",
    "nbd": "bn2",
    "tbd": "n2d",
    "ned": "πn3",
    "ted": "n3d",
}


def printed() -> dict[str, dict[str, list[str]]]:
    """The names that the versions 0.3 to 0.12 printed, by scene and plan: taken from what they wrote."""
    found: dict[str, dict[str, list[str]]] = defaultdict(lambda: defaultdict(list))
    text = (CASES / "names" / "printed.csv").read_text(encoding="utf-8")
    for row in csv.DictReader(text.splitlines()):
        found[row["scene"]][row["plan"]].append(row["segment"])
    return found


@pytest.fixture(scope="module")
def crank(tmp_path_factory: pytest.TempPathFactory) -> DrawnScene:
    return make(read(written(tmp_path_factory.mktemp("crank"), CRANK)))


@pytest.mark.parametrize(
    "name",
    [
        "accelerating-crank",
        "scotch-yoke",
        *(pytest.param(k, marks=pytest.mark.slow) for k in ("lever", "windrower")),
    ],
)
def test_every_name_that_a_version_printed_is_read(name: str) -> None:
    made = gallery.made(name)
    known = segments_of((*scene_columns(made), *result_columns(scene_results(made))))
    for plan, segments in printed()[name].items():
        for segment in segments:
            due = NOW[name].get(segment, segment) if plan == "accelerations" else segment
            assert segment_meant(segment, plan, known[plan]).names == (due,), (plan, segment)


@pytest.mark.parametrize("name", NOW)
def test_no_name_of_today_meant_another_segment_before(name: str) -> None:
    before = {old for old, now in NOW[name].items() if old != now}
    assert before.isdisjoint(NOW[name].values())
    assert len(FORMER) == len({(row.until, row.then) for row in FORMER})


def test_a_pivot_in_the_name_does_not_hide_the_crank(crank: DrawnScene) -> None:
    known = segments_of(scene_columns(crank))["accelerations"]
    assert set(OLD.values()) <= set(known)
    assert {old: segment_meant(old, "accelerations", known).names for old in OLD} == {
        old: (now,) for old, now in OLD.items()
    }


def test_a_way_without_a_sign_is_read_without_its_bars(tmp_path: Path) -> None:
    """Where a diagram lays off a way with its sign, the bare letter is that one."""
    both = make(read(written(tmp_path, asked.mechanism("slider", 6, [("A1", ("positions",))]))))
    for drawn, due in ((gallery.made("engine"), "|sB|"), (both, "sB")):
        known = segments_of(scene_columns(drawn))["positions"]
        for typed in ("sB", "s_B"):
            assert segment_meant(typed, "positions", known).names == (due,)


def test_a_file_of_old_names_is_judged_as_one_of_new_names(tmp_path: Path) -> None:
    file = written(tmp_path, CRANK)
    table = tmm.draw(file).table("accelerations")
    said = []
    for names in (list(OLD), list(OLD.values())):
        unique = {OLD.get(name, name): name for name in names}
        rows = [
            f"accelerations,2,{typed},{table[now].mm[0, 2]:.2f}" for now, typed in unique.items()
        ]
        readings = tmp_path / "readings.csv"
        readings.write_text("plan,position,segment,mm\n" + "\n".join(rows) + "\n", encoding="utf-8")
        ended = CliRunner().invoke(main, ["check", str(file), str(readings), "--format", "json"])
        said.append((ended.exit_code, ended.stdout))
    assert said[0] == said[1]
    assert said[0][0] == 0


def test_python_understands_a_name_of_an_earlier_version(tmp_path: Path) -> None:
    table = tmm.draw(written(tmp_path, CRANK)).table("accelerations")
    for old, now in OLD.items():
        assert table[old] is table[now]
        assert old not in table.columns
    with pytest.raises(KeyError, match="n1b"):
        table["txb1"]


def test_a_segment_has_one_name_wherever_it_is_named(crank: DrawnScene) -> None:
    """In the table and its CSV, in the template, on the sheet's plan and table, in the protocol."""
    work = crank.mechanism
    assert work is not None
    segments = {c.segment for c in scene_columns(crank) if c.plan == "accelerations" and c.drawn}
    assert set(OLD.values()) < segments
    assert (
        segments
        == {row.segment for row in rows_of(crank.scene) if row.plan == "accelerations"} & segments
    )
    (table,) = acceleration_table(work, True)
    assert {markup(segment) for segment in segments} <= {label.text for label in table.labels}
    strokes = [stroke for view in acceleration_views(work, True) for stroke in view.strokes]
    drawn = {dict(getattr(stroke, "data", ())).get("segment") for stroke in strokes} - {None}
    assert drawn == segments
    lines = [line.strip() for line in protocol(work, ("accelerations",), "2", "en")]
    assert segments <= {line.partition(" = ")[0] for line in lines}

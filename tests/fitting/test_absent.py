"""What has no result is not drawn: its chapter is left out by name, the rest is drawn, by every command."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from support.command import invoke
from support.scenes import slider_crank, written

CAM = """title = "T"
language = "{language}"
[cam]
stroke = "25 deg"
rise = 70
upper_dwell = 10
fall = 70
law = "constant acceleration"
follower = "rocker"
lever = "130 mm"
centres = "160 mm"
pressure = 40
"""
GEARS = '[gears]\nz1 = 20\nz2 = 31\nm = "4 mm"\n'
SHORT = """speed = "10 rad/s"
positions = 12
[effects]
inertia = false
gravity = false
[[load]]
link = 3
point = "B"
force = "100 N"
"""
SECTIONS = {
    "diagrams": '[diagrams]\npoint = "B"\n',
    "flywheel": '[forces]\n[flywheel]\ndelta = 0.05\nconstant = "driving"\n',
    "engine": '[indicator]\npoint = "B"\nbore = "0.1 m"\ncover = '
    + str([4e5, 3e5, 2e5, 1e5, 8e4, 7e4] * 2)
    + '\n[engine]\npoint = "B"\nmass = "4 kg"\nshare = 0.3\n',
}
NAMES = {
    "en": {"cam": "Cam", "diagrams": "Diagrams", "flywheel": "Flywheel", "engine": "Forces"},
    "ru": {"cam": "Кулачковый", "diagrams": "Диаграммы", "flywheel": "Маховик", "engine": "Силы"},
}
OUT = {"en": "it is left out; ", "ru": "раздел опущен; "}
REMEDY = {"en": "change its lengths", "ru": "измените длины"}


def scene(folder: Path, chapter: str, language: str, *, more: bool) -> Path:
    if chapter == "cam":
        text = CAM.format(language=language) + (GEARS if more else "")
        places = ["cam", "gears"] if more else ["cam"]
    else:
        of = 'mass = "5 kg"\ncentre = "B"\n'
        text = slider_crank(SHORT, rod=0.08, of_slider=of, language=language) + SECTIONS[chapter]
        places = ["positions", chapter] if more else [chapter]
    return written(folder, f'{text}[[sheet]]\nformat = "A1"\nplace = {json.dumps(places)}\n')


def ran(*words: object) -> tuple[int, str, str]:
    done = invoke(*words)
    return done.exit_code, done.stdout, done.stderr


@pytest.mark.slow
@pytest.mark.turns(1)
@pytest.mark.parametrize(
    ("chapter", "language"),
    [("cam", "ru"), ("diagrams", "en"), ("flywheel", "ru"), ("engine", "en")],
)
def test_the_rest_is_drawn_and_the_chapter_is_named(
    tmp_path: Path, chapter: str, language: str
) -> None:
    file = scene(tmp_path, chapter, language, more=True)
    status, _, told = ran("draw", file, "-o", tmp_path / "out")
    assert status == 0
    assert OUT[language] in told
    sheet = "".join(one.read_text("utf-8") for one in (tmp_path / "out").glob("*.svg"))
    assert NAMES[language][chapter] in sheet
    assert "left-out" in sheet
    for view in ("cam profile", "diagram a", "flywheel-graphs", "engine M"):
        assert f'"{view}"' not in sheet
    status, table, _ = ran("table", file)
    assert status == 0
    assert OUT[language] in table
    assert NAMES[language][chapter] in table
    status, *_ = ran("note", file, "-o", tmp_path / "note", "-f", "md")
    assert status == 0
    note = next((tmp_path / "note").glob("*.md")).read_text("utf-8")
    assert OUT[language] in note.replace("\n", " ")
    assert "—°" not in note


@pytest.mark.slow
def test_what_is_left_out_keeps_its_place_in_the_note(tmp_path: Path) -> None:
    """Not before the structure of the mechanism, where nothing of it has been told yet."""
    file = scene(tmp_path, "diagrams", "en", more=True)
    status, *_ = ran("note", file, "-o", tmp_path, "-f", "md")
    assert status == 0
    note = next(tmp_path.glob("*.md")).read_text("utf-8")
    heads = [line for line in note.splitlines() if line.startswith("# ")]
    places = [k for k, line in enumerate(heads) if "Diagrams" in line]
    before = [k for k, line in enumerate(heads) if "Structure" in line or "Kinematics" in line]
    assert places == [max(before) + 1]


@pytest.mark.slow
@pytest.mark.turns(2)
@pytest.mark.parametrize(
    ("chapter", "command"),
    [
        ("cam", "draw"),
        ("cam", "note"),
        ("diagrams", "table"),
        ("flywheel", "draw"),
        ("engine", "table"),
    ],
)
def test_where_nothing_else_is_asked_it_is_refused(
    tmp_path: Path, chapter: str, command: str
) -> None:
    file = scene(tmp_path, chapter, "en", more=False)
    where = () if command == "table" else ("-o", tmp_path / "out")
    status, out, told = ran(command, file, *where)
    assert status == 2
    assert not out
    assert not (tmp_path / "out").exists()
    assert OUT["en"] in told
    assert chapter == "cam" or REMEDY["en"] in told


@pytest.mark.slow
def test_machines_are_told_by_chapter(tmp_path: Path) -> None:
    _, table, _ = ran("table", scene(tmp_path, "flywheel", "en", more=True), "-f", "json")
    told = json.loads(table)
    assert list(told["results"]["left_out"]) == ["flywheel"]
    assert "J_fly" not in told["results"]
    assert {one["plan"] for one in told["columns"]} >= {"velocities", "forces"}


@pytest.mark.slow
def test_a_remedy_that_is_followed_helps(tmp_path: Path) -> None:
    file = scene(tmp_path, "cam", "en", more=False)
    written(
        tmp_path,
        file.read_text("utf-8")
        .replace("rise = 70", "rise = 150")
        .replace("fall = 70", "fall = 150"),
    )
    status, *_ = ran("draw", file, "-o", tmp_path / "out")
    assert status == 0


@pytest.mark.slow
def test_no_sheet_is_drawn_for_what_has_no_result(tmp_path: Path) -> None:
    apart = (
        '[[sheet]]\nformat = "A3"\nplace = ["gears"]\n[[sheet]]\nformat = "A3"\nplace = ["cam"]\n'
    )
    file = written(tmp_path, CAM.format(language="en") + GEARS + apart)
    status, _, told = ran("draw", file, "-o", tmp_path / "out")
    assert status == 0
    assert OUT["en"] in told
    drawn = list((tmp_path / "out").glob("*.svg"))
    assert drawn
    assert all("There is no result" not in one.read_text("utf-8") for one in drawn)
    assert len(drawn) == 1

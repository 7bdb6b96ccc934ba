"""What a scene calls for is checked and tabulated whether or not a sheet shows it; nothing idles in silence."""

from __future__ import annotations

import re
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest
from support import asked
from support.boards import parts
from support.command import invoke, printed, rows, warned
from support.found_once import found_once as found_once
from support.gallery import FOLDERS
from support.scenes import MECHANISM, SECTIONS, calling, written

from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.project import record
from graphic_tmm.scene.checks import unplaced
from graphic_tmm.scene.read import judged, read
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make, sheets

PLANS = {
    "diagrams": {"diagrams"},
    "forces": {"forces"},
    "flywheel": {"flywheel"},
    "engine": {"engine"},
    "cam": {"cam"},
    "gears": {"gear", "sliding"},
    "planetary": {"planetary", "planetary-velocities", "planetary-rates"},
}
ONLY_VELOCITIES = '[[sheet]]\nplace = ["velocities"]\n'
"""Nothing stands beside plans of velocities unasked, as the diagrams of loads do beside that of positions."""
NEEDS = {"forces": ("load",), "flywheel": ("forces", "load"), "engine": ("indicator",)}


LATER = pytest.mark.slow
SLOW = [pytest.param(k, marks=LATER) if k in ("cam", "engine") else k for k in PLANS]
"""Of the long ones one of the parts in the everyday run."""


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.usefixtures("found_once")
@pytest.mark.parametrize("section", SLOW)
def test_the_table_gives_what_no_sheet_shows_and_drawing_says_so(
    section: str, tmp_path: Path
) -> None:
    path = calling(tmp_path, *NEEDS.get(section, ()), section, sheet=ONLY_VELOCITIES)
    done = invoke("table", path, "-f", "csv")
    assert done.exit_code == 0, done.output
    plans = {row["plan"] for row in rows(done.stdout)}
    assert PLANS[section] <= plans
    assert not [line for line in warned(done) if line.startswith(section)]
    done = invoke("draw", path, "-o", tmp_path / "out")
    assert done.exit_code == 0
    lines = [line for line in warned(done) if line.startswith(f"{section}: no sheet shows it")]
    assert len(lines) == 1
    assert "[[sheet]]" in lines[0]
    place = re.search(r'add "([^"]+)"', lines[0])
    assert place
    sheet = f'[[sheet]]\nplace = ["positions", "{place[1]}"]\n'  # the remedy helps
    path = calling(tmp_path, *NEEDS.get(section, ()), section, sheet=sheet)
    assert unplaced(read(path)) == ()


@cache
def bare() -> frozenset[str]:
    """The views of the mechanism alone."""
    return drawn(judged(MECHANISM.encode(), Path("scene.toml")))


def drawn(scene: Scene) -> frozenset[str]:
    """The views of a scene but for headings: a row that is broken has two."""
    names = (view.name for sheet in sheets(scene)[1] for view in sheet.drawings)
    return frozenset(name for name in names if not name.startswith("heading-"))


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize("section", SLOW)
def test_without_a_sheet_all_that_the_scene_calls_for_is_drawn(
    section: str, tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    """It is called for; it is drawn: a part, diagrams and forces, or each when measured."""
    scene = read(calling(tmp_path, *NEEDS.get(section, ()), section, sheet=""))
    if section in ("cam", "diagrams", "forces") or many(1, 0):
        assert bare() < drawn(scene)
    assert section in scene.shown_places
    assert scene.called == scene.shown_places
    unnamed = read(
        calling(tmp_path, *NEEDS.get(section, ()), section, sheet='[[sheet]]\nformat = "A1"\n')
    )
    assert unnamed.sheets == scene.sheets


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize("section", ["cam", "gears", "planetary"])
def test_a_part_alone_needs_no_sheet_either(section: str, tmp_path: Path) -> None:
    head = 'title = "T"\nlanguage = "ru"\n'
    made, paper = sheets(read(calling(tmp_path, section, sheet="", head=head)))
    assert made.mechanism is None
    assert paper


@pytest.mark.turns(2)
@pytest.mark.parametrize(
    ("sections", "key", "remedy"),
    [
        pytest.param(("load",), "load", "without a section [forces]", marks=LATER),
        pytest.param(("effects",), "effects", "without a section [forces]", marks=LATER),
        (("friction",), "friction", "without a section [forces]"),
        pytest.param(
            ("friction", "forces"),
            "friction",
            "friction = true in [effects]",
            marks=LATER,
        ),
        (("indicator",), "indicator", "add [flywheel] or [engine], or gas = true"),
        pytest.param(
            ("indicator", "forces", "effects"),
            "indicator",
            "gas = true in [effects]",
            marks=LATER,
        ),
    ],
)
def test_a_section_that_nothing_reads_is_told_in_one_line(
    sections: tuple[str, ...], key: str, remedy: str, tmp_path: Path
) -> None:
    path = calling(tmp_path, *sections)
    for command in (("draw", path, "-o", tmp_path / "out"), ("table", path), ("steps", path)):
        done = invoke(*command)
        assert done.exit_code == 0
        lines = [line for line in warned(done) if line.startswith(f"{key}: ")]
        assert len(lines) == 1, command
        assert remedy in lines[0]


@pytest.mark.parametrize(
    ("section", "says"),
    [
        ("[forces]\nsingle = [9]\n", "there is no link 9"),
        ('[[load]]\nlink = 1\nmoment = "2 N"\n', "moment"),
        ('[diagrams]\npoint = "A"\n', "A"),
        ('[cam]\nstroke = "20 mm"\nrise = 90\nfall = 100\nr0 = "0.001 mm"\nroller = "30 mm"\n', ""),
        ('[gears]\nz1 = 21\nz2 = 34\nm = "5 mm"\nx1 = -3.0\n', "wheel 1|working angle|tip circle"),
        (
            '[planetary]\nmodule = "4 mm"\nspeed = 1\nratio = 4.6\nteeth = [25, 32, 90]\n',
            "coaxial|teeth",
        ),
    ],
)
def test_a_section_that_no_sheet_shows_is_checked_all_the_same(
    section: str, says: str, tmp_path: Path
) -> None:
    path = calling(tmp_path, section)
    done = invoke("draw", path, "-o", tmp_path / "out")
    other = invoke("table", path)
    assert done.exit_code == other.exit_code
    if says:
        assert done.exit_code == 2
        assert re.search(says, done.stderr), done.stderr
        assert not (tmp_path / "out").exists()


def test_an_effect_that_is_not_called_for_records_no_step(tmp_path: Path) -> None:
    views = {s.it.view for s in record(read(calling(tmp_path))).construction.steps}
    assert views <= {"extremes", "positions"}
    scene = read(calling(tmp_path, "forces", "load", sheet=ONLY_VELOCITIES))
    whole = {s.it.view for s in record(scene).construction.steps}
    shown = {s.it.view for s in record(scene, wanted=scene.shown_places).construction.steps}
    assert "loads" in whole
    assert "velocities" in shown
    assert shown <= {"extremes", "positions", "velocities"}


def test_drawing_executes_nothing_that_no_sheet_shows(tmp_path: Path) -> None:
    scene = read(calling(tmp_path, "forces", "load", "gears", sheet=ONLY_VELOCITIES))
    made = make(scene, wanted=scene.shown_places)
    assert made.mechanism is not None
    assert FORCES_PLAN.of(made.mechanism) is None
    assert parts(made) == ()
    assert FORCES_PLAN.of(make(scene).mechanism) is not None  # type: ignore[union-attr]
    assert [part.board for part in parts(make(scene))] == ["gears"]


def test_a_table_speaks_of_the_scales_that_the_sheet_has(tmp_path: Path) -> None:
    sheet = '[[sheet]]\nplace = ["positions", "velocities"]\n'
    scene = read(calling(tmp_path, "forces", "load", "effects", sheet=sheet))
    drawn, tabled = make(scene, wanted=scene.shown_places), make(scene)
    assert drawn.mechanism is not None
    assert tabled.mechanism is not None
    for plan in ("positions", "velocities"):
        assert drawn.mechanism.scales[plan] == tabled.mechanism.scales[plan]


def test_positions_named_for_accelerations_reach_the_table(tmp_path: Path) -> None:
    head = MECHANISM + "accelerations = [1, 3]\n"
    path = calling(tmp_path, head=head)
    done = invoke("draw", path, "-o", tmp_path / "out")
    assert [line.partition(":")[0] for line in warned(done)] == ["drive.accelerations"]
    found = rows(printed("table", path, "-f", "csv"))
    assert {row["position"] for row in found if row["plan"] == "accelerations"} == {"1", "3"}


@pytest.mark.parametrize("place", ["velocity table", "acceleration table", "results", "equations"])
def test_a_table_of_a_plan_needs_no_plan_beside_it(place: str, tmp_path: Path) -> None:
    sheet = f'[[sheet]]\nplace = ["positions", "{place}"]\n'
    head = MECHANISM + "accelerations = [1, 3]\n"
    (paper,) = sheets(read(calling(tmp_path, head=head, sheet=sheet)))[1]
    assert (
        len([v for v in paper.drawings if v.labels]) > 2
    )  # the frame, the positions, and what was asked for


@pytest.mark.slow
def test_the_constant_moment_of_a_flywheel_is_told_when_it_is_left_out(tmp_path: Path) -> None:
    bare = SECTIONS["flywheel"].replace('constant = "driving"\n', "")
    sheet = '[[sheet]]\nplace = ["positions", "flywheel"]\n'
    path = calling(tmp_path, "forces", "load", bare, sheet=sheet)
    for command in (("draw", path, "-o", tmp_path / "out"), ("table", path), ("steps", path)):
        line, cost = warned(invoke(*command))
        assert line.startswith("flywheel.constant: it is left out, so the resisting moment")
        assert cost.startswith("With 8 positions: J_F is too small by ")
        assert 'constant = "driving"' in line
    path = calling(tmp_path, "forces", "load", "flywheel", sheet=sheet)
    assert warned(invoke("table", path)) == [cost]


def test_the_packaged_scenes_leave_nothing_unsaid() -> None:
    for folder in FOLDERS:
        scene = read(folder)
        assert (folder.name, scene.remarks, unplaced(scene)) == (folder.name, (), ())


@pytest.mark.slow
@pytest.mark.parametrize("place", ["accelerations", "acceleration table"])
def test_a_sheet_without_the_plans_that_it_names_says_so(place: str, tmp_path: Path) -> None:
    text = asked.mechanism("slider", 6, [("A1", ("positions", "velocities"))])
    text = text.replace('"velocities"]', f'"velocities", "{place}"]')
    text = text[: text.index("[effects]")] + text[text.index("[[sheet]]") :]
    for none in (True, False):
        said = text.replace(
            "accelerations = [0, 2, 4]\n", "" if none else 'accelerations = "all"\n'
        )
        done = invoke("draw", written(tmp_path, said), "-o", tmp_path / "out")
        lines = [line for line in warned(done) if line.startswith(f"{place}: ")]
        assert done.exit_code == 0
        assert [bool(re.search('accelerations = "all"', line)) for line in lines] == [True] * none


@pytest.mark.turns(1)
@pytest.mark.parametrize(
    ("there", "hidden"), [("", "0, 2, 4"), ("accelerations = [2, 3]\n", "0, 4"), (None, "")]
)
@pytest.mark.slow
def test_inertia_from_plans_that_are_not_drawn_says_so(
    there: str | None, hidden: str, tmp_path: Path
) -> None:
    text = asked.mechanism("slider", 6, [("A1", ("positions", "forces"))])
    if there is not None:
        text = text.replace("accelerations = [0, 2, 4]\n", there)
    done = invoke("table", written(tmp_path, text), "-f", "csv")
    lines = [line for line in warned(done) if "plans of accelerations" in line or "планам" in line]
    assert done.exit_code == 0
    assert [f" {hidden} " in line for line in lines] == [True] * bool(hidden)


def test_what_stands_asks_for_no_accelerations(tmp_path: Path) -> None:
    """Nor is it said that a sheet has none; one that wishes them is answered."""
    for drive, says in (
        ("", "nothing is there to be shown"),
        ("speed = 0", ""),
        ('speed = 0\naccelerations = "all"', "it stands, and nothing has an acceleration"),
        ("speed = 0\nacceleration = 2", "nothing is there to be shown"),
    ):
        head = re.sub("(?m)^speed.*", drive or r"\g<0>", MECHANISM)
        told = [
            line
            for line in unplaced(read(calling(tmp_path, sheet="", head=head)))
            if "accelerat" in line
        ]
        assert len(told) == bool(says)
        assert not says or says in told[0]

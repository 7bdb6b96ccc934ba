"""Poles as they are clicked; the points of a photograph as readings that can be corrected."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from support.command import invoke
from support.own_boards import A, V
from support.own_plans import HIGH, own_plans
from support.own_sheets import Kind

from graphic_tmm.checking.judging.scatter import Limits
from graphic_tmm.checking.own_sheet.clicked import ClickedScale, plans_of
from graphic_tmm.checking.pencil.points import SEEN, UNSEEN, UNSURE
from graphic_tmm.checking.pencil.reading import PhotoPoints, Point, readings
from graphic_tmm.checking.photographed import (
    Photographed,
    judged,
    points_drawing,
    poles_of,
    sight_of,
    write_seen,
)
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import FINE, WRONG, Judged, PlanSight, Report, Sight, Taken
from graphic_tmm.checking.report.findings import headline
from graphic_tmm.commands.shared.judging import end_with
from graphic_tmm.errors import SheetError
from graphic_tmm.paper.drawing import Drawing, Label, Sheet
from graphic_tmm.paper.formats import PAPERS
from graphic_tmm.paper.shapes import box
from graphic_tmm.scene.read import read


def test_poles_are_read_as_they_are_clicked() -> None:
    given = ["velocities:3=1200.5,840", "accelerations:7*=10,20"]
    assert poles_of(given) == {
        ("velocities", "3"): 1200.5 + 840j,
        ("accelerations", "7*"): 10 + 20j,
    }


@pytest.mark.parametrize(
    "text", ["", "velocities", "velocities=1,2", "velocities:3", "velocities:3=1", ":3=1,2"]
)
def test_a_pole_that_says_too_little_is_refused(text: str) -> None:
    with pytest.raises(SheetError, match="write plan, position and where its pole is"):
        poles_of([text])


@pytest.mark.parametrize("language", ["en", "ru"])
def test_points_seen_come_back_from_their_file(language: str, tmp_path: Path) -> None:
    points = tuple(
        Point(("velocities", letter, "3"), z, z - 10, SEEN, z)
        for letter, z in (("a", 12.344 + 5.678j), ("b", -3.5 - 0.25j))
    )
    seen = Photographed(PhotoPoints(points, ()), readings(points))
    (file,) = write_seen(str(tmp_path / "seen.csv"), seen, language)
    back = read_readings(file)
    assert [one._replace(last=seen.taken[0].last) for one in back] == list(seen.taken)


def test_every_point_seen_is_shown_with_its_letter_and_error() -> None:
    points = tuple(
        Point(("velocities", letter, "3"), z, z, how, z)
        for letter, z, how in (
            ("a", 30 + 40j, SEEN),
            ("b", 70 + 80j, "unsure"),
            ("c", 0j, "unseen"),
        )
    )
    seen = Photographed(PhotoPoints(points, ()), readings(points))
    judged = Judged(seen.taken[0], 50.0, 51.0, 1.26, 2.0, 0.5, FINE, own=0.84)
    report = Report("scene", "", "en", "student", (judged,), ())
    drawing = points_drawing(seen, report, Sheet("s", "", "A4", 210.0, 297.0, ()))
    assert [label.text for label in drawing.labels] == ["a: 0.8", "b?"]
    middles = [sum(complex(x, y) for x, y, _ in one.path) / 2 for one in drawing.strokes]
    assert middles == pytest.approx([30 + 40j, 30 + 40j, 70 + 80j])


def test_letters_of_points_that_lie_together_keep_off_each_other_and_off_the_sheet() -> None:
    letters = ("c", "d", "s3", "b", "e", "s4")
    points = tuple(
        Point(("velocities", letter, "3"), z, z, SEEN, z)
        for letter, z in zip(letters, (50 + 50j, 50.4 + 50j, 51 + 50.5j) * 2, strict=True)
    )
    seen = Photographed(PhotoPoints(points, ()), readings(points))
    own = Label("c", 52 + 46j, 5.0)
    sheet = Sheet("s", "", "A4", 210.0, 297.0, (Drawing("plan", "", (), (own,)),))
    drawing = points_drawing(seen, Report("scene", "", "en", "student", (), ()), sheet)
    assert [label.text for label in drawing.labels] == list(letters)
    boxes = [box(label) for label in (own, *drawing.labels)]
    met = [(a.intersects(b), k, j) for k, a in enumerate(boxes) for j, b in enumerate(boxes[:k])]
    assert not any(hit for hit, *_ in met), met


@pytest.fixture
def photo(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> tuple[object, ...]:
    """A photograph of an empty sheet, as the command is told of it."""
    image = pytest.importorskip("PIL.Image")
    monkeypatch.chdir(tmp_path)
    image.new("L", (260, 340), 240).save("photo.png")
    corners = ("--corners", "20,292 205,292 205,5 20,5", "--overlay", "o.svg")
    return ("--photo", "photo.png", *corners, "-l", "en")


@pytest.mark.turns(1)
@pytest.mark.parametrize("place", ["1e300,-1e300", "-1,5", "100,340", "250,100"])
@pytest.mark.slow
def test_a_pole_beside_the_sheet_is_refused(photo: tuple[object, ...], place: str) -> None:
    done = invoke("check", "crank-rocker", *photo, "--sheet", 2, "--pole", f"velocities:1={place}")
    assert (done.exit_code, done.stdout, Path("o.svg").exists()) == (2, "", False), done.output
    assert "--pole velocities:1: " in done.stderr
    assert "is not on the sheet in the photograph: give x and y in its dots" in done.stderr


@pytest.mark.parametrize("file", ["o.svg", "./o.svg", "o-flat.png"])
def test_points_never_take_the_place_of_the_drawing(photo: tuple[object, ...], file: str) -> None:
    done = invoke("check", "crank-rocker", *photo, "--readings-out", file)
    assert (done.exit_code, Path("o.svg").exists()) == (2, False), done.output
    assert f"--readings-out: {file}: the drawing is written there; name another" in done.stderr


@pytest.mark.parametrize("option", [("--pole", "velocities:1=5,5"), ("--readings-out", "r.csv")])
def test_what_is_for_points_seen_is_not_passed_over_with_readings(
    photo: tuple[object, ...], option: tuple[str, str]
) -> None:
    done = invoke("check", "crank-rocker", "readings.csv", *photo, *option)
    assert done.exit_code == 2, done.output
    assert "leave out READINGS" in done.stderr


@pytest.mark.slow
def test_a_sheet_without_plans_has_no_file_of_points(photo: tuple[object, ...]) -> None:
    done = invoke("check", "slider-diagrams", *photo, "--sheet", 2, "--readings-out", "r.csv")
    assert (done.exit_code, Path("r.csv").exists()) == (0, False), done.output
    assert "warning: no plan on this sheet: no file for --readings-out" in done.stderr


def seen_plans(*hows: str, off: float = 0.0) -> PhotoPoints:
    """Points of a velocity plan at positions 1, 2, …: a and b of each, b as told and so far from its due."""
    rows = [
        (("velocities", letter, str(n)), z, how)
        for n, told in enumerate(hows, 1)
        for letter, z, how in (("a", 30j, SEEN), ("b", 20 + off + 0j, told))
    ]
    return PhotoPoints(tuple(Point(name, z, z, how, z) for name, z, how in rows), ())


DUE = {("velocities", letter, n): z for n in "123" for letter, z in (("a", 30j), ("b", 20 + 0j))}
ASKED = [("velocities", n) for n in "123"]


@pytest.mark.parametrize(
    ("how", "off", "partly"),
    [
        (SEEN, 0.0, ()),
        (SEEN, 9.0, ()),
        (UNSURE, 1.0, ()),
        (UNSURE, 9.0, ("1", "2")),
        (UNSEEN, 0.0, ("1", "2")),
    ],
)
def test_a_plan_is_seen_if_no_point_of_it_may_be_elsewhere(
    how: str, off: float, partly: tuple[str, ...]
) -> None:
    sight = sight_of(seen_plans(how, how, off=off), DUE, ASKED)
    assert sight.plans == (PlanSight("velocities", 3, ("3",), partly),)
    assert (sight.points, sight.of) == (4 if how == SEEN else 2, 6)
    assert not sight.whole


def test_all_is_seen_where_every_plan_is() -> None:
    assert sight_of(seen_plans(SEEN, SEEN, UNSURE), DUE, ASKED).whole


def test_nothing_wrong_is_never_said_with_a_plan_unseen() -> None:
    fine = Judged(Taken("velocities", "1", "a", x=0.0, y=30.0), 0.0, 0.0, 0.0, 0.0, 0.5, FINE)
    plans = (PlanSight("velocities", 8, ()), PlanSight("accelerations", 3, ("1", "3", "5")))
    report = Report("s", "", "en", "student", (fine,), (), sight=Sight(34, 60, plans))
    assert headline(report) == (
        "What was seen is right as far as it goes, but not every plan was seen. Seen: 34 of 60 points. "
        "Velocity plan: 8 of 8; Acceleration plan: 0 of 3, nothing is said about them."
    )
    some = PlanSight("velocities", 8, ("2",), ("4", "6"))
    told = headline(report._replace(sight=Sight(20, 24, (some,))))
    assert told.endswith("Velocity plan: 5 of 8, not 2, in part 4, 6.")
    with pytest.raises(SystemExit) as ended:
        end_with(report, "json", None)
    assert ended.value.code == 3
    whole = report._replace(sight=Sight(34, 34, plans[:1]))
    assert headline(whole).startswith("Nothing is wrong")
    end_with(whole, "json", None)


@pytest.mark.turns(1)
@pytest.mark.parametrize("plan", ["positions:99=50,50", "velocities:99=50,50", "forces:1=50,50"])
@pytest.mark.slow
def test_a_plan_that_cannot_be_clicked_is_refused(photo: tuple[object, ...], plan: str) -> None:
    done = invoke("check", "crank-rocker", *photo, "--sheet", 2, "--plan", plan)
    assert (done.exit_code, done.stdout) == (2, ""), done.output
    assert "--plan: there is no plan" in done.stderr


@pytest.mark.slow
def test_a_clicked_plan_that_is_not_drawn_is_said_to_be_unseen(photo: tuple[object, ...]) -> None:
    plan = ("--plan", "velocities:1=100,150,140,120", "--paper", "A4")
    done = invoke("check", "crank-rocker", *photo, *plan)
    assert done.exit_code == 3, done.output
    assert "Velocity plan: 0 of 1, nothing is said about them" in done.stdout


@pytest.mark.slow
def test_plans_are_proposed_as_they_can_be_clicked_and_nothing_is_judged(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    image = pytest.importorskip("PIL.Image")
    monkeypatch.chdir(tmp_path)
    drawn = own_plans(Kind("sc", mu={V: 1.0, A: 1.25}))
    # a sheet of A3, plans at its top, upon a dark table
    paper = np.full((297 * HIGH, 420 * HIGH), 235, np.uint8)
    paper[: len(drawn.grey)] = drawn.grey
    image.fromarray(np.pad(paper, 60, constant_values=40)).save("own.png")
    scene = str(Path(__file__).parents[1] / "cases" / "check" / "sc.toml")
    asked = ("photo", scene, "own.png", "--paper", "A3", "--overlay", "o.svg", "-l", "en")
    done = invoke(*asked, "--propose")
    assert done.exit_code == 0, done.output
    options = done.stdout.split()
    assert options[::2] == ["--plan"] * 3
    top = 200 * 1j
    for one, own in zip(plans_of(options[1::2]), drawn.clicked, strict=True):
        assert (one.plan, one.position) == (own.plan, own.position)
        assert own.first is not None
        for seen, there in ((one.pole, own.pole), (one.first, own.first)):
            assert seen == pytest.approx(
                60 + 60j + HIGH * (top + there.conjugate()), abs=2.5 * HIGH
            )
    assert "Velocity plan, 1" in Path("o.svg").read_text(encoding="utf-8")
    judged = invoke(*asked, *options)
    assert judged.exit_code == 0, judged.output
    assert "Nothing is wrong" in judged.stdout


@pytest.mark.slow
def test_where_no_plan_is_recognised_clicks_are_asked_for(photo: tuple[object, ...]) -> None:
    done = invoke("check", "crank-rocker", *photo, "--propose", "--paper", "A4")
    assert (done.exit_code, done.stdout) == (0, ""), done.output
    assert (
        "no plan is recognised in the photograph: give p and a of each with --plan" in done.stderr
    )


@pytest.mark.parametrize("option", [("--pole", "velocities:1=5,5"), ("--plan", "velocities:1=5,5")])
def test_what_is_clicked_already_is_not_proposed(
    photo: tuple[object, ...], option: tuple[str, str]
) -> None:
    done = invoke("check", "crank-rocker", *photo, "--propose", *option)
    assert done.exit_code == 2, done.output
    assert "--propose goes before --plan and --pole" in done.stderr


@pytest.mark.slow
def test_every_format_of_own_paper_that_is_offered_is_known(photo: tuple[object, ...]) -> None:
    for paper in PAPERS:
        done = invoke("check", "crank-rocker", *photo, "--paper", paper)
        assert done.exit_code == 0, done.output


REVERSED = {
    "a": 26.63 + 26.89j,
    "k2": 35.2 + 25.31j,
    "n3": -1.75 - 5.83j,
    "a3": 29.04 - 11.37j,
    "c": 38.09 - 15.07j,
}
"""An acceleration plan whose first vector was drawn outwards."""


def test_clicked_plans_are_judged_in_the_scale_factor_that_they_were_read_in() -> None:
    scene = read(Path(__file__).parents[1] / "cases" / "check" / "rpr.toml")
    scale = ClickedScale("accelerations", 0.317, 0.2, "m/s²/mm")
    taken = [
        Taken("accelerations", "1", letter, x=z.real, y=z.imag, line=n)
        for n, (letter, z) in enumerate(REVERSED.items(), 2)
    ]
    seen = Photographed(PhotoPoints((), ()), tuple(taken), (scale,))
    report = judged(scene, seen, hand="student", trials=60, limits=Limits(), source="own.jpg")
    assert [one.taken.segment for one in report.readings if one.verdict == WRONG] == ["a"]
    assert report.readings[0].due == pytest.approx(37.85, abs=0.01)
    (says,) = report.head
    assert "0.317" in says
    assert {one.due for one in report.scales} == {0.2}
    assert [one.family for one in report.mistakes] == ["sense"]

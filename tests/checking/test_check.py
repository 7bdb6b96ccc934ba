"""Honest drawings are fine; planted mistakes are named; a slip is blamed on its step, not on what follows."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from click.testing import CliRunner
from gallery import SHEETS

from graphic_tmm.__main__ import main
from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking import judge as judging
from graphic_tmm.checking import usual as usual_errors
from graphic_tmm.checking.alterations import Figures
from graphic_tmm.checking.catalogue import CATALOGUE
from graphic_tmm.checking.cells import Cell, Key, cells, points
from graphic_tmm.checking.check import check
from graphic_tmm.checking.judge import judge
from graphic_tmm.checking.mistakes import likely
from graphic_tmm.checking.own import OwnErrors
from graphic_tmm.checking.records import DOUBTFUL, FINE, WRONG, Taken
from graphic_tmm.checking.scatter import Limits, Scatter, scatter
from graphic_tmm.errors import SceneError
from graphic_tmm.paper.frame import drawing_area
from graphic_tmm.scene.read import read
from graphic_tmm.studio import Made, drawings, make

SCENES = ("engine", "crank-rocker", "shaper", "offset-slider", "accelerating-crank", "lever")
Spread = dict[tuple[Key, bool], Scatter]


@cache
def made(name: str) -> Made:
    return make(read(SHEETS / name), exact=True)


@cache
def usual(name: str, hand: str = "student") -> Spread:
    due = cells(made(name))
    wanted = {key: {cell.mm is not None} for key, cell in due.items()}
    return scatter(made(name), HANDS[hand]._replace(trials=300), wanted, Limits())


def readings(found: Figures, due: Figures) -> list[Taken]:
    rows = []
    for line, (key, cell) in enumerate(due.items(), start=2):
        own = found.get(key)
        if own is None:
            continue
        plan, segment, position = key
        if cell.mm is not None and own.mm is not None:
            rows.append(Taken(plan, position, segment, mm=abs(own.mm), line=line))
        elif cell.mm is None and own.value is not None:
            rows.append(Taken(plan, position, segment, value=own.value, unit=cell.unit, line=line))
    return rows


@pytest.fixture(autouse=True)
def _own_is_quick(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(usual_errors, "TRIALS", 25)


@pytest.mark.parametrize("hand", ["student", "careful"])
@pytest.mark.parametrize("name", SCENES[:3])
def test_honest_drawings_are_fine(name: str, hand: str, monkeypatch: pytest.MonkeyPatch) -> None:
    due, spread = cells(made(name)), usual(name, hand)
    monkeypatch.setattr(judging, "scatter", lambda *_: spread)
    monkeypatch.setattr(judging, "usual_errors", lambda *_: {})
    count = doubtful = broken = 0
    trials = 28
    for drawn in drawings(made(name), HANDS[hand]._replace(trials=trials, seed=4711)):
        judged, _ = judge(made(name), readings(cells(drawn), due), HANDS[hand], Limits(), "x")
        count += len(judged)
        doubtful += sum(one.verdict == DOUBTFUL for one in judged)
        broken += any(one.verdict == WRONG for one in judged)
    assert doubtful <= 0.05 * count
    assert broken <= 1


@pytest.mark.parametrize("name", SCENES)
def test_a_perfect_drawing_has_no_error(name: str) -> None:
    due = cells(made(name))
    rows = readings(due, due)
    own = OwnErrors(made(name), rows)
    for taken in rows:
        assert all(abs(one.error) < 1e-9 for one in own.of(taken))
    spots = points(made(name))
    again = [Taken(p, n, s, x=z.real, y=z.imag) for (p, s, n), z in spots.items()]
    own = OwnErrors(made(name), again)
    assert all(own.of(taken) for taken in again)
    assert all(abs(one.error) < 1e-9 for taken in again for one in own.of(taken))


def planted(name: str) -> Iterator[tuple[str, Figures]]:
    for mistake in CATALOGUE:
        for figures in mistake.figures(made(name)):
            yield mistake.name, figures


def noisy(figures: Figures, drawn: Figures, due: Figures) -> dict[Key, Cell]:
    """What a hand reads whose figures are those of a mistake: with its own deviations from what is due."""

    def plus(a: float | None, b: float | None, c: float | None) -> float | None:
        return None if a is None or b is None or c is None else a + (b - c)

    found = {}
    for key, cell in due.items():
        own, slipped = figures.get(key), drawn.get(key)
        if own is not None and slipped is not None:
            mm = plus(own.mm, slipped.mm, cell.mm)
            found[key] = Cell(mm, plus(own.value, slipped.value, cell.value), cell.unit)
    return found


@pytest.mark.parametrize("name", SCENES)
def test_a_planted_mistake_is_named_first(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    due, spread = cells(made(name)), usual(name)
    monkeypatch.setattr(judging, "scatter", lambda *_: spread)
    monkeypatch.setattr(judging, "usual_errors", lambda *_: {})
    honest = [cells(d) for d in drawings(made(name), HANDS["student"]._replace(trials=2, seed=9))]
    seen = first = some = 0
    for mistake, figures in planted(name):
        for drawn in honest:
            rows = readings(noisy(figures, drawn, due), due)
            judged, _ = judge(made(name), rows, HANDS["student"], Limits(), "x")
            if not any(one.verdict == WRONG for one in judged):
                continue
            told = likely(made(name), judged, spread, "en")
            seen += 1
            some += bool(told)
            first += bool(told) and mistake in (told[0].name, *told[0].like)
    assert seen > 5
    assert first >= 0.9 * seen
    assert some >= 0.97 * seen


def test_honest_wrong_readings_are_not_explained_by_force() -> None:
    due = cells(made("engine"))
    rows = [t for t in readings(due, due) if t.plan == "velocities" and t.mm is not None]
    off = [
        t._replace(mm=(t.mm or 0.0) + 17.3 + 3.1 * k) if k % 9 == 0 else t
        for k, t in enumerate(rows)
    ]
    judged, spread = judge(made("engine"), off, HANDS["student"]._replace(trials=60), Limits(), "x")
    told = likely(made("engine"), judged, spread, "en")
    count = sum(one.verdict == WRONG for one in judged)
    assert count > 3
    assert all(len(one.lines) < count for one in told if one.name != "another segment")


def test_what_follows_from_a_slip_is_not_punished() -> None:
    """ab is read 6 mm too long; the normal component calculated from it is right for that reading."""
    name = "engine"
    due = cells(made(name))
    ab, pb = due["velocities", "ab", "2"].mm, due["velocities", "pb", "2"].mm
    nab = due["accelerations", "nab", "2"].mm
    assert ab is not None
    assert pb is not None
    assert nab is not None
    found = abs(ab) - 12.0
    rows = [
        Taken("velocities", "2", "ab", mm=found, line=2),
        Taken("velocities", "2", "pb", mm=pb, line=3),
        Taken("accelerations", "2", "nab", mm=abs(nab) * (found / abs(ab)) ** 2, line=4),
    ]
    report = check(read(SHEETS / name), rows, trials=80)
    verdicts = {one.taken.segment: one.verdict for one in report.readings}
    assert verdicts["ab"] == WRONG
    assert verdicts["pb"] == FINE
    assert verdicts["nab"] == FINE


def test_a_ray_that_slipped_is_blamed() -> None:
    """Point b stands on the line pb, off the line ab: that line was drawn wrong."""
    spots = points(made("engine"))
    a, b = spots["velocities", "a", "3"], spots["velocities", "b", "3"]
    wrong = b * (1.0 - 7.0 / abs(b))
    rows = [
        Taken("velocities", "3", "a", x=a.real, y=a.imag, line=2),
        Taken("velocities", "3", "b", x=wrong.real, y=wrong.imag, line=3),
    ]
    report = check(read(SHEETS / "engine"), rows, trials=80)
    one = next(o for o in report.readings if o.taken.segment == "b")
    assert one.verdict != FINE
    assert "(ab)" in one.step


def test_an_unknown_segment_is_named_with_its_line() -> None:
    rows = [
        Taken("velocities", "1", "pq", mm=3.0, line=7),
        Taken("forces", "1", "R12", mm=1.0, line=9),
    ]
    with pytest.raises(SceneError) as error:
        check(read(SHEETS / "engine"), rows, source="r.csv")
    assert "pq" in str(error.value)
    assert "r.csv:7" in str(error.value)
    assert "forces" in str(error.value)


def test_the_command(tmp_path: Path) -> None:
    template = CliRunner().invoke(main, ["check", "engine", "--template"])
    assert template.exit_code == 0
    assert (
        "velocities,2,pb" in template.stdout.replace("скоростей", "velocities")
        or "pb" in template.stdout
    )
    path = tmp_path / "r.csv"
    path.write_text("plan;position;segment;mm\nvelocities;2;pb;42,5\nvelocities;3;pb;15\n", "utf-8")
    done = CliRunner().invoke(main, ["check", "engine", str(path), "-f", "json", "--trials", "40"])
    assert done.exit_code == 1, done.output
    assert '"verdict": "wrong"' in done.stdout
    for form in ("text", "md", "html"):
        done = CliRunner().invoke(
            main, ["check", "engine", str(path), "-f", form, "--trials", "40"]
        )
        assert done.exit_code == 1
        assert done.stdout
    missing = CliRunner().invoke(main, ["check", "engine", str(tmp_path / "none.csv")])
    assert missing.exit_code == 2
    assert "Traceback" not in missing.stderr


def test_the_overlay_shows_what_was_read(tmp_path: Path) -> None:
    spots = points(made("engine"))
    lines = ["plan,position,segment,x,y"]
    for (plan, letter, position), z in spots.items():
        if plan == "velocities" and position in ("2", "3"):
            lines.append(f"{plan},{position},{letter},{z.real + 1.0},{z.imag}")
    path, out = tmp_path / "r.csv", tmp_path / "o.svg"
    path.write_text("\n".join(lines) + "\n", "utf-8")
    arguments = [
        "check",
        "engine",
        str(path),
        "--overlay",
        str(out),
        "--enlarge",
        "5",
        "--trials",
        "40",
    ]
    done = CliRunner().invoke(main, arguments)
    assert done.exit_code in (0, 1), done.output
    assert out.read_text("utf-8").startswith("<?xml") or "<svg" in out.read_text("utf-8")


def test_scatter_goes_to_zero_with_the_hand() -> None:
    due = cells(made("engine"))
    key = ("velocities", "ab", "2")
    wide = []
    for share in (1.0, 0.1, 0.01):
        hand = HANDS["student"]._replace(
            ruler=None, digits=None, prick=0.15 * share, compass=0.15 * share,
            swing=0.6 * share, reading=0.75 * share, trials=200,
        )  # fmt: skip
        found = scatter(made("engine"), hand, {key: {True}}, Limits())
        wide.append(float(np.sqrt(np.mean(found[key, True].sorted ** 2))))
    assert wide[1] == pytest.approx(0.1 * wide[0], rel=0.05)
    assert wide[2] == pytest.approx(0.01 * wide[0], rel=0.05)
    assert math.isfinite(due[key].mm or math.nan)


def test_the_same_seed_is_the_same_hand() -> None:
    scene = replace(read(SHEETS / "lever"), hand="student", seed=7, ruler=0.5)
    one, other = make(scene), make(scene)
    assert cells(one) == cells(other)
    assert cells(make(replace(scene, seed=8))) != cells(one)
    first = next(iter(drawings(one, HANDS["student"]._replace(ruler=0.5, seed=7, trials=3))))
    assert cells(first).keys() == cells(one).keys()


def test_a_photograph_is_laid_under_its_sheet(tmp_path: Path) -> None:
    pytest.importorskip("typst")
    image = pytest.importorskip("PIL.Image")
    drawn = CliRunner().invoke(main, ["draw", "crank-rocker", "-f", "png", "-o", str(tmp_path)])
    assert drawn.exit_code == 0
    photo = tmp_path / "crank-rocker-1.png"
    with image.open(photo) as opened:
        dots = opened.size[0] / 210.0
    left, bottom, right, top = drawing_area("A4", "en", True).inner
    ends = ((left, bottom), (right, bottom), (right, top), (left, top))
    corners = " ".join(f"{x * dots:.1f},{(297 - y) * dots:.1f}" for x, y in ends)
    out = tmp_path / "under.svg"
    arguments = ["check", "crank-rocker", "--photo", str(photo), "--corners", corners]
    done = CliRunner().invoke(main, [*arguments, "--overlay", str(out)])
    assert done.exit_code == 0, done.output
    assert 'href="under.png"' in out.read_text("utf-8")
    with image.open(tmp_path / "under.png") as flat:
        assert flat.size[0] == pytest.approx(210 * 4, abs=2)
    bad = CliRunner().invoke(main, [*arguments[:-1], "1,2 3,4"])
    assert bad.exit_code == 2
    assert "four corners" in bad.stderr

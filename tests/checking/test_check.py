"""Readings to a report: what is wrong is named with its line; by the command as by the function."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.command import invoke
from support.gallery import SHEETS, exact
from support.scenes import source, written

from graphic_tmm.checking.cells import points as spots
from graphic_tmm.checking.check import check
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.checking.records import Taken
from graphic_tmm.errors import SceneError
from graphic_tmm.paper.sheet_frame import drawing_area
from graphic_tmm.scene.read import read


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


@pytest.mark.turns(1, "command")
@pytest.mark.slow
def test_the_command(tmp_path: Path) -> None:
    template = invoke("check", "crank-rocker", "--template")
    assert template.exit_code == 0
    assert "velocities,2,pb" in template.stdout
    path = tmp_path / "r.csv"
    path.write_text("plan;position;segment;mm\nvelocities;2;pb;42,5\nvelocities;3;pb;5\n", "utf-8")
    done = invoke("check", "crank-rocker", path, "-f", "json", "--trials", "40")
    assert done.exit_code == 1, done.output
    assert '"verdict": "wrong"' in done.stdout
    for form in ("text", "md", "html"):
        done = invoke("check", "crank-rocker", path, "-f", form, "--trials", "40")
        assert done.exit_code == 1
        assert done.stdout
    spot = spots(exact("crank-rocker"))["velocities", "a", "1"]
    spot -= 1.5 * spot / abs(spot)
    row = f"velocities,1,a,{spot.real:.1f},{spot.imag:.1f}"
    path.write_text(f"plan,position,segment,x,y\n{row}\n", "utf-8")
    for points, status in (("paper", 0), ("screen", 1)):
        arguments = ["check", "crank-rocker", str(path), "--points", points, "--trials", "40"]
        assert invoke(*arguments).exit_code == status
    missing = invoke("check", "crank-rocker", tmp_path / "none.csv")
    assert missing.exit_code == 2
    assert "Traceback" not in missing.stderr


@pytest.mark.turns(1, "command")
@pytest.mark.slow
def test_a_photograph_is_laid_under_its_sheet(tmp_path: Path) -> None:
    pytest.importorskip("typst")
    image = pytest.importorskip("PIL.Image")
    drawn = invoke("draw", "crank-rocker", "-f", "png", "-o", tmp_path)
    assert drawn.exit_code == 0
    photo = tmp_path / "crank-rocker-1.png"
    with image.open(photo) as opened:
        dots = opened.size[0] / 210.0
    left, bottom, right, top = drawing_area("A4", "en", True).inner
    ends = ((left, bottom), (right, bottom), (right, top), (left, top))
    corners = " ".join(f"{x * dots:.1f},{(297 - y) * dots:.1f}" for x, y in ends)
    out = tmp_path / "under.svg"
    arguments = ["check", "crank-rocker", "--photo", str(photo), "--corners", corners]
    done = invoke(*arguments, "--overlay", out)
    assert done.exit_code == 3, done.output  # nothing is wrong, but no plan is seen whole
    assert 'href="under-flat.png"' in out.read_text("utf-8")
    with image.open(tmp_path / "under-flat.png") as flat:
        assert flat.size[0] == pytest.approx(210 * 8, abs=4)
    bad = invoke(*arguments[:-1], "1,2 3,4")
    assert bad.exit_code == 2
    assert "four corners" in bad.stderr


def test_a_reading_of_what_has_no_figure_is_noted_and_not_judged(tmp_path: Path) -> None:
    """Teeth 80 km large are drawn to no scale that leaves a digit of the ratio; of 8 km two are left."""
    text = source("planetary")
    huge = written(tmp_path, text.replace('"8 mm"', '"80000000.0 mm"'))
    rows = tmp_path / "readings.csv"
    rows.write_text("plan,position,segment,mm,value,unit\nresults,,planetary_ratio_drawn,,4.56,1\n")
    found = check(read(huge), read_readings(rows), trials=20)
    assert not found.readings
    assert any("planetary_ratio_drawn" in note for note in found.notes)

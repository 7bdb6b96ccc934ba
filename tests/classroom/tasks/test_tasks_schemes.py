"""What tasks without a mechanism show: what is given, to scale or as a sign; nothing that is to be found."""

from __future__ import annotations

import re
from xml.etree import ElementTree

import pytest
from support import sheet_reader
from support.gallery import SHEETS
from support.scenes import slider_crank

from graphic_tmm.classroom.batch.work import done
from graphic_tmm.classroom.tasks.work import works
from graphic_tmm.classroom.variants.variant import base
from graphic_tmm.errors import StructureError

SVG = "{http://www.w3.org/2000/svg}"


def task(text: str, tmp: object) -> str:
    """The only sheet of the task of a scene."""
    file = tmp / "scene.toml"  # type: ignore[operator]
    file.write_text(text, encoding="utf-8")
    (work,) = works(base(file), (), keys=(), language="en")
    (svg,) = done(work).files.values()
    return str(svg)


def scene(name: str) -> str:
    return (SHEETS / name / "scene.toml").read_text(encoding="utf-8")


@pytest.mark.parametrize(
    ("name", "old", "new"),
    [
        ("planetary", 'teeth      = [25, "?", "?"]', 'teeth      = [24, "?", "?"]'),
        ("planetary", "ratio      = 4.55", "ratio      = 4.7"),
        ("cam", 'law          = "sine"', 'law          = "cosine"'),
    ],
)
def test_the_scheme_tells_nothing_of_what_is_found(
    name: str, old: str, new: str, tmp_path: object
) -> None:
    text = scene(name)
    assert old in text
    first, second = (
        circles_and_lines(task(one, tmp_path)) for one in (text, text.replace(old, new))
    )
    assert len(first) == len(second)
    for one, other in zip(first, second, strict=True):
        assert one == pytest.approx(other, abs=2e-3)


def circles_and_lines(svg: str) -> list[tuple[float, ...]]:
    """The heavy lines of a scheme, as shares of its width, from where its first begins."""
    bare = [re.sub(r"A\S+ \S+ \S+ \S+ \S+", "L", d) for d in heavy(svg)]
    found = [[float(n) for n in re.findall(r"-?\d+\.?\d*", d)] for d in bare]
    x, y = found[0][:2]
    wide = max(n for row in found for n in row[::2]) - min(n for row in found for n in row[::2])
    return [
        tuple((n - (x, y)[k % 2]) / (wide, 1.0)[k % 2] for k, n in enumerate(row)) for row in found
    ]


def heavy(svg: str) -> list[str]:
    root = ElementTree.fromstring(svg)
    (group,) = (g for g in root.iter(f"{SVG}g") if g.get("class") == "drawing scheme")
    pens = [g for g in group.iter(f"{SVG}g") if g.get("class") == "pen main"]
    return [path.get("d", "") for pen in pens for path in pen.iter(f"{SVG}path")]


def test_the_cam_of_arcs_has_the_radii_that_are_given(tmp_path: object) -> None:
    svg = task(scene("arc-cam"), tmp_path)
    told = " ".join(sheet_reader.views(svg)["scheme"].words)
    (mu,) = (float(one) for one in re.findall(r"μ_l = ([\d.]+) m/mm", told))
    radii = {round(float(r), 2) for d in heavy(svg) for r in re.findall(r"A([\d.]+)", d)}
    for given in (0.020, 0.007, 0.010):
        assert round(given / mu, 2) in radii
    assert {"O", "C", "d", "r₁", "r₂", "r"} <= set(
        sheet_reader.views(svg)["scheme"].words
    ) | lowered(svg)


def lowered(svg: str) -> set[str]:
    root = ElementTree.fromstring(svg)
    return {g.get("aria-label", "") for g in root.iter(f"{SVG}g")}


@pytest.mark.parametrize("follower", ['"flat"', '"rocker"\nlever = "60 mm"\ncentres = "70 mm"'])
@pytest.mark.parametrize("turns", ["clockwise", "counterclockwise"])
def test_a_cam_of_arcs_shows_any_follower(follower: str, turns: str, tmp_path: object) -> None:
    text = scene("arc-cam").replace('flank    = "straight"', 'flank    = "60 mm"')
    told = f'follower = {follower}\nturns = "{turns}"'
    text = text.replace('follower = "roller"', told)
    if "flat" in follower:
        text = re.sub(r"roller   = .*", "", text)
    words = lowered(task(text, tmp_path))
    assert "r₃" in words
    assert ("l" in words) == ("rocker" in follower)


@pytest.mark.parametrize("kind", ["external-internal", "external-external", "internal-internal"])
@pytest.mark.parametrize("driving", ["1", "H"])
def test_every_train_has_its_scheme(kind: str, driving: str, tmp_path: object) -> None:
    text = scene("planetary").replace('"ring" ', f'"{kind}"')
    text = re.sub(r"teeth      = .*", "", text).replace(
        'driving    = "1"', f'driving = "{driving}"'
    )
    text = re.sub(r"ratio      = .*", f"ratio = {-12 if kind.endswith('external') else 12}", text)
    words = sheet_reader.views(task(text, tmp_path))["scheme"].words
    assert {"1", "2", "3", "4", "5", "6", "H"} <= set(words)


@pytest.mark.parametrize(("zero", "positions"), [(10, 1), (170, 2), (3, 40)])
def test_what_assembles_over_a_part_of_the_turn_is_shown_where_it_does(
    zero: int, positions: int, tmp_path: object
) -> None:
    """A rod of a third of the crank reaches the guide within 19.47° of dead centres: half-way angles do not."""
    drive = f'speed = "3 1/s"\npositions = {positions}\nzero = {zero}\n'
    text = task(slider_crank(drive, crank=0.3, rod=0.1), tmp_path)
    assert "nan" not in text
    assert circles_and_lines(text)


def test_what_assembles_almost_nowhere_is_refused(tmp_path: object) -> None:
    drive = 'speed = "3 1/s"\npositions = 1\nzero = 92.5\n'
    with pytest.raises(StructureError, match="none of the positions can be drawn"):
        task(slider_crank(drive, crank=3.0, rod=0.1), tmp_path)

"""No output of any command is written over a file that the command was given, under whatever name it goes."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path

import pytest
from support.command import invoke
from support.gallery import SHEETS

from graphic_tmm.errors import SheetError
from graphic_tmm.files import Kind, call, read, write

ONE_SHEET = (SHEETS / "scotch-yoke" / "scene.toml").read_bytes()
SCENE = (SHEETS / "crank-rocker" / "scene.toml").read_bytes()
ENDS = "20,292 205,292 205,5 20,5"
MINUTES = b"R1 = 0.1\n"
READINGS = b"plan,position,segment,mm\nvelocities,1,pa,50\n"


def picture() -> bytes:
    import io

    image = pytest.importorskip("PIL.Image")
    made = io.BytesIO()
    image.new("RGB", (210, 297), "white").save(made, "PNG")
    return made.getvalue()


def link(target: str) -> Callable[[Path], None]:
    return lambda place: place.symlink_to(target)


def hard(target: str) -> Callable[[Path], None]:
    return lambda place: os.link(place.parent / target, place)


def folder(path: Path) -> None:
    path.mkdir()


PHOTO = ("photo", "plan.svg", "p.png", "--corners", ENDS, "--overlay")
ACCURACY = ("accuracy", "cam", "--trials", "10", "--no-time", "-o", ".", "--minutes")
CASES = {
    "a scene that is named like its sheet": ({"x.svg": ONE_SHEET}, ("draw", "x.svg", "-o", ".")),
    "a link to the scene where a sheet shall stand": (
        {"plan.toml": SCENE, "plan-2.svg": link("plan.toml")},
        ("draw", "plan.toml", "-o", "."),
    ),
    "a second name of the scene where a sheet shall stand": (
        {"plan.toml": SCENE, "plan-3.svg": hard("plan.toml")},
        ("draw", "plan.toml", "-o", "."),
    ),
    "a scene that is a link": (
        {"real.svg": ONE_SHEET, "plan.toml": link("real.svg")},
        ("draw", "plan.toml", "-o", "."),
    ),
    "a way with dots": (
        {"d": folder, "plan.svg": SCENE},
        ("check", "d/../plan.svg", "r.csv", "--trials", "20", "--overlay", "plan.svg"),
    ),
    "the scene as overlay": (
        {"plan.svg": SCENE},
        ("check", "plan.svg", "r.csv", "--trials", "20", "--overlay", "plan.svg"),
    ),
    "the readings as overlay": (
        {"plan.toml": SCENE, "r.svg": READINGS},
        ("check", "plan.toml", "r.svg", "--trials", "20", "--overlay", "./r.svg"),
    ),
    "the overlay in other letters": (
        {"plan.toml": SCENE, "R.SVG": READINGS},
        ("check", "plan.toml", "R.SVG", "--trials", "20", "--overlay", "r.svg"),
    ),
    "the photograph named like the picture": (
        {"plan.svg": SCENE, "o-flat.png": picture, "p.png": link("o-flat.png")},
        (*PHOTO, "o.svg"),
    ),
    "the scene under the photograph's drawing": (
        {"plan.svg": SCENE, "p.png": picture},
        (*PHOTO, "PLAN.svg"),
    ),
    "readings that are read after the photograph": (
        {"plan.svg": SCENE, "p.png": picture, "o.svg": READINGS},
        (*PHOTO, "o.svg", "o.svg", "--trials", "20"),
    ),
    "minutes named like the figure": (
        {"cam-accuracy.svg": MINUTES},
        (*ACCURACY, "cam-accuracy.svg"),
    ),
    "minutes named like the other figure": (
        {"CAM-Accuracy.PNG": MINUTES},
        (*ACCURACY, "CAM-Accuracy.PNG"),
    ),
}


@pytest.mark.turns(4)
@pytest.mark.slow
@pytest.mark.parametrize("what", CASES)
def test_an_input_is_kept(what: str, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    files, arguments = CASES[what]
    points = b"plan,position,segment,x,y\nvelocities,1,a,5,5\n"
    for name, stands in {"r.csv": points, **files}.items():
        place = tmp_path / name
        if isinstance(stands, bytes):
            place.write_bytes(points if stands is READINGS else stands)
        elif stands is picture:
            place.write_bytes(picture())
        else:
            stands(place)
    before = {p.name: p.is_dir() or p.read_bytes() for p in tmp_path.iterdir()}
    done = invoke(*arguments, "-l", "en")
    assert done.exit_code == 2, done.output
    assert "this file was read; it is not written over: name another" in done.stderr
    assert {p.name: p.is_dir() or p.read_bytes() for p in tmp_path.iterdir()} == before


def test_an_output_beside_an_input_is_written(tmp_path: Path) -> None:
    kind = Kind("a thing", "name a thing", 100)
    with call():
        (tmp_path / "a.txt").write_text("mine")
        read(tmp_path / "a.txt", kind)
        write(tmp_path, {"b.txt": "new"})
        with pytest.raises(SheetError, match=r"a\.txt: this file was read"):
            write(tmp_path, {"c.txt": "new", "a.txt": "new"})
        assert sorted(os.listdir(tmp_path)) == ["a.txt", "b.txt"]
    write(tmp_path, {"a.txt": "another call"})
    assert (tmp_path / "a.txt").read_text() == "another call"

"""A note holds on scenes that are not the package's: its figures give its results, nothing hollow is said."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from support import asked, linkages, parts, sheets_of_random
from support import hard_mechanisms as hard
from support.command import invoke
from support.gallery import CASES, scene
from support.note_judge import faults, formulas, sum_of
from support.rewritten import text_of
from support.scenes import written
from support.tex_sums import Unread, sides_of, worked_out

from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import TmmError
from graphic_tmm.fitting.auto import formatted
from graphic_tmm.fitting.composition import Composition
from graphic_tmm.fitting.sizes import usual
from graphic_tmm.note.note import note, wanted
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make

LANGUAGES = ["ru", "en"]
TAIL = (
    "accelerations = [0, 1, 3]\n[[sheet]]\n"
    'place = ["positions", "velocities", "accelerations", "structure", "results"]\n'
)
NASTY = {
    "a dead centre": linkages.slider_crank(1.0, 3.0),
    "a crank that cannot turn": linkages.slider_crank(2.0, 1.5),
    "a crank longer than its centres": linkages.coulisse(2.0, 1 + 0j),
}
SIZES = {"": 1.0, ", of microns": 1e-6, ", of kilometres": 1e6}


def _text(what: str) -> str:
    """The scene of a case by its name."""
    kind, _, name = what.partition(": ")
    if kind == "part":
        section, text = parts.PARTS[name]
        return parts.HEAD.format(kind=section) + text
    if kind == "asked":
        machine, count = name.split()
        places = [p for p in asked.PLACES if asked.can(machine, p, int(count))]
        return asked.mechanism(machine, int(count), [("A1", places)], extra=True)
    if kind == "random":
        number = int(name)
        return list(sheets_of_random.scenes(number + 1, seed=77))[number]
    name, _, size = name.partition(", ")
    frame = hard.Frame(SIZES[f", {size}" if size else ""])
    return text_of(hard.put(NASTY[name], frame), 0.0, 8, TAIL)


EVERYDAY = ["part: a rocker", "random: 1", "nasty: a dead centre, of microns"]
RARE = [
    *(f"part: {name}" for name in parts.PARTS if name != "a rocker"),
    *("asked: slider 3", "asked: slider 12", "asked: six 8"),
    *(
        f"nasty: {name}{size}"
        for name in NASTY
        for size in SIZES
        if f"{name}{size}" not in EVERYDAY[2]
    ),
]
OUTSIDE = [*EVERYDAY, *(pytest.param(name, marks=pytest.mark.slow) for name in RARE)]
OWN = [
    "crank-press",
    *(
        pytest.param(name, marks=pytest.mark.slow)
        for name in ("lever", "cam", "windrower", "project")
    ),
]


@cache
def _kept(what: str, folder: Path) -> DrawnScene:
    return _made(read(written(folder, _text(what))), searched=what in EVERYDAY)


def _made(task: Scene, *, searched: bool = True) -> DrawnScene:
    """In the sizes that its sheets have room for, or in the usual ones: its figures are true in any."""
    given = None if searched else Composition(usual(formatted(task)), ())
    return make(task, wanted=wanted(task), given=given)


def _told(made: DrawnScene, language: str) -> DrawnScene:
    told = replace(made.scene, language=language)
    boards = (replace(one, project=replace(one.project, scene=told)) for one in made.boards)
    return DrawnScene(told, tuple(boards))


@pytest.fixture(scope="module")
def folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("scenes")


def _right(what: str, language: str, folder: Path) -> None:
    made = _told(_kept(what, folder), language)
    told = note(made)
    assert not list(faults(made, told))
    assert sum(len(sum_of(one)[0]) > 1 for one in formulas(told)) >= 5


@pytest.mark.turns(4)
@pytest.mark.parametrize("what", OUTSIDE)
@pytest.mark.slow
def test_a_note_of_any_scene_is_right(
    what: str, folder: Path, many: Callable[[int, int], int]
) -> None:
    """The rare ones in one language each, by turns; in both when measured."""
    both = what in EVERYDAY or many(1, 0)
    for language in LANGUAGES if both else LANGUAGES[RARE.index(what) % 2 :][:1]:
        _right(what, language, folder)


@pytest.mark.slow
def test_notes_of_random_scenes_are_right(folder: Path, many: Callable[[int, int], int]) -> None:
    for number in range(12) if many(1, 0) else (0,):
        _right(f"random: {number}", LANGUAGES[number % 4 // 2], folder)


@pytest.mark.turns(2)
@pytest.mark.parametrize("name", OWN)
@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.slow
def test_a_note_of_the_package_is_right(name: str, language: str) -> None:
    made = _told(_made(scene(name)), language)
    assert not list(faults(made, note(made)))


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.parametrize("path", sorted(CASES.glob("sheets/*.toml")), ids=lambda path: path.stem)
def test_a_note_of_a_case_is_right(path: Path) -> None:
    try:
        made = _told(_made(read(path), searched=False), "ru")
    except TmmError:
        return  # it is refused, with its remedy, elsewhere
    assert not list(faults(made, note(made)))


@pytest.mark.parametrize("command", [("draw", "-o", "out"), ("note", "-f", "md"), ("table",)])
def test_what_cannot_be_drawn_is_refused_whatever_its_sheet(
    command: tuple[str, ...], tmp_path: Path
) -> None:
    """No format can be chosen for a mechanism that has no views: what is wrong with it is said."""
    folded = hard.put(linkages.four_bar(1.0, 2.0, 1.0, 2 + 0j), hard.Frame())
    auto = TAIL.replace("[[sheet]]", '[[sheet]]\nformat = "auto"')
    path = written(tmp_path, text_of(folded, 0.0, 8, auto))
    done = invoke(command[0], path, *command[1:])
    assert done.exit_code == 2
    assert "flips_at" in done.stderr
    assert "a fault of the program" not in done.stderr


# The judge can fail.


@pytest.mark.parametrize(
    ("formula", "right"),
    [
        (r"v_{A} = \omega _{1} \cdot l = 39{,}79 \cdot 0{,}1366 = 5{,}435\ \text{м/с}", True),
        (r"v_{A} = 39{,}79 \cdot 0{,}1366 = 5{,}445\ \text{м/с}", False),
        (r"l = 0{,}48 \cdot \sin \left(\frac{\text{33,06°}}{2}\right) = 0{,}1366\ \text{м}", True),
        (r"l = 0{,}48 \cdot \cos \left(\frac{\text{33,06°}}{2}\right) = 0{,}1366\ \text{м}", False),
        (
            r"n = \frac{{\left(-19.3 \cdot 0.015\right)}^{2}}{120 \cdot 0.002 \cdot 0.05} = 6.984",
            True,
        ),
        (r"a = 2 \cdot 10^{-6}/2.5 \cdot 10^{-8} = 80\ \text{mm}", False),
        (r"a = 2 \cdot 10^{-6}/(2.5 \cdot 10^{-8}) = 80\ \text{mm}", True),
        (
            r"\Delta = \frac{100 \cdot \left| 254 - 250 \right|}{\left| 250 \right|} = \text{1.6%}",
            True,
        ),
    ],
)
def test_the_judge_of_sums_works_them_out(formula: str, right: bool) -> None:
    assert sum_of(formula)[1] == right
    assert len(sum_of(formula)[0]) == 2


def test_the_judge_leaves_letters_alone() -> None:
    with pytest.raises(Unread):
        worked_out(sides_of(r"v_{A} = \omega _{1} \cdot l_{OA}")[1])

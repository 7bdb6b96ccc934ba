"""What is stated, put into the equations that are stated, gives what is stated: notes, sheets, protocols.

A person reads from the beginning, with a calculator: `support.stated`. Letters whose value was stated with its
sign keep it. So a minus that stands in a value and before its letter, too, is seen.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from functools import cache
from pathlib import Path

import pytest
from support import asked, sheets_of_random
from support.force_views import LOADED
from support.gallery import NAMES, scene
from support.note_judge import formulas_of
from support.stated import Equations, Stated, letters_of

from graphic_tmm.chapters.forces.ink_balances import driver_rows, group_rows, lever_rows
from graphic_tmm.chapters.forces.ink_writer import Writer
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.forces.views import EXACTLY
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.fitting.auto import formatted
from graphic_tmm.fitting.composition import Composition
from graphic_tmm.fitting.sizes import usual
from graphic_tmm.note.document import Table, walk
from graphic_tmm.note.note import note, wanted
from graphic_tmm.paper.seen import Seen
from graphic_tmm.readers.protocol import protocol
from graphic_tmm.readers.writing import decimals_of
from graphic_tmm.scene.read import judged
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make

pytestmark = pytest.mark.every

LANGUAGES = ("en", "ru")
PLACES = ("positions", "velocities", "accelerations", "forces", "lever", "force table")
PLANS = ("positions", "velocities", "accelerations", "forces")
COUPLE = '[[load]]\nlink = 3\nmoment = "{} N*m"\n'
OUTSIDE = {
    "six": ("six", 8, "counterclockwise", -40.0),
    "six clockwise": ("six", 8, "clockwise", -25.0),
    "slider": ("slider", 6, "counterclockwise", 0.0),
    "slider clockwise": ("slider", 3, "clockwise", 0.0),
}
"""Mechanisms of nobody: forces in three positions, a couple of the load that turns clockwise."""


def _read(text: str) -> Scene:
    return judged(text.encode(), Path("scene.toml"))


@cache
def made(name: str) -> DrawnScene:
    """A scene by its name, drawn once, in the sizes that its sheets would have on empty paper."""
    if name in NAMES:
        task = scene(name)
    elif name in OUTSIDE:
        kind, positions, turns, couple = OUTSIDE[name]
        text = asked.mechanism(kind, positions, [("A1", PLACES)])
        text = text.replace('speed = "300 rpm"', f'speed = "300 rpm"\nturns = "{turns}"')
        task = _read(text.replace("[drive]", f"{COUPLE.format(couple)}[drive]") if couple else text)
    else:
        task = _read(list(sheets_of_random.scenes(int(name) + 1, seed=77))[int(name)])
    return make(task, wanted=wanted(task), given=Composition(usual(formatted(task)), ()))


def spoken(name: str, language: str) -> DrawnScene:
    """The same in a language."""
    told: Scene = replace(made(name).scene, language=language)
    boards = (replace(one, project=replace(one.project, scene=told)) for one in made(name).boards)
    return DrawnScene(told, tuple(boards))


def of_note(name: str, language: str) -> Iterator[Equations]:
    """The formulas of a note; the table of the lever tells sizes and arms with their signs."""
    found, document = Equations(), note(spoken(name, language))
    for block in walk(document.blocks):
        for row in block.rows if isinstance(block, Table) and block.id == "table-lever" else ():
            letter, size, _, arm, _ = (cell[0] for cell in row)
            found.state(letters_of(letter.markup)[0], size.text)
            (of,) = letters_of(f"h_{{{''.join(c for c in letter.markup if c not in '_{}')}}}")
            found.state(of, arm.text)
        found.read(formulas_of(block, language))
    yield found


def of_sheets(name: str, language: str) -> Iterator[Equations]:
    """The equations beside groups and lever as they are lettered, position by position."""
    work = spoken(name, language).mechanism
    assert work is not None
    made_ = FORCES_PLAN.on(work)
    decimals = EXACTLY if work.hand.ruler is None else decimals_of(work.hand.ruler)
    for place in (k for k in made_.places if k not in work.undrawn):
        writer = Writer(
            Seen(work.construction, work.reading, (), [place]), place, language, decimals
        )
        alone = [one for one in made_.driven if one.alone is not None]
        rows = [row for one in alone for row in driver_rows(writer, made_, one)]
        for one in made_.balanced:
            rows += lever_rows(writer, one.lever, made_.tool)
        for solved in made_.groups:
            rows += group_rows(writer, made_, solved)
        found = Equations()
        found.read(" ".join(row.parts) for row in rows)
        yield found


def of_protocols(name: str, language: str) -> Iterator[Equations]:
    """The lines of the protocol of all plans, position by position."""
    work = spoken(name, language).mechanism
    assert work is not None
    for place in work.row("accelerations"):
        found = Equations()
        lines = protocol(work, PLANS, work.names[place], language)
        found.read(line.strip() for line in lines if " = " in line and ";" not in line)
        yield found


def held(some: Iterable[Equations], least: int) -> tuple[int, int]:
    """Hold that no equation is wrong; return how many were evaluated, and how many bear a minus."""
    found = list(some)
    assert [one for each_ in found for one in each_.wrong] == []
    counts = sum(one.evaluated for one in found), sum(one.signed for one in found)
    left_out = sum(len(one.left_out) for one in found)
    print(f"evaluated {counts[0]}, with a minus {counts[1]}, not to be read {left_out}")
    assert counts[0] >= max(least, 8 * left_out)
    return counts


def test_the_judge_sees_a_sign_that_stands_twice() -> None:
    """A couple told as −33846, − M′ in the equation, + 33846 in the line of figures."""
    lines = [
        "M' = M \\cdot ab = -16.33 \\cdot 2072.6 = -33846",
        "S = F \\cdot h - M' - P \\cdot pa = 0",
    ]
    for equation, right in (
        (lines[1], False),
        (lines[1].replace("- M'", r"- \left| M' \right|"), True),
    ):
        found = Equations(
            {"F": Stated(1500.0, 0.0), "h": Stated(90.0, 0.0), "pa": Stated(69.0, 0.0)}
        )
        found.read([lines[0], equation, r"P = \frac{1500 \cdot 90 - 33846}{69} = 1466.0"])
        assert (found.wrong == []) == right
        assert (found.evaluated, found.signed) == (2, 2)


EVERYDAY = ["lever", "six clockwise"]
RARE = [
    *(name for name in LOADED if name not in EVERYDAY),
    "six",
    "slider",
    "slider clockwise",
    "3",
]
SCENES = [*EVERYDAY, *(pytest.param(name, marks=pytest.mark.slow) for name in RARE)]
by_scene = pytest.mark.parametrize("name", SCENES)
Many = Callable[[int, int], int]


def in_languages(name: str, many: Many) -> tuple[str, ...]:
    """The languages of a scene: both of an everyday one or when measured, else one by turns."""
    both = name in EVERYDAY or many(1, 0)
    return LANGUAGES if both else LANGUAGES[sorted((*NAMES, *RARE)).index(name) % 2 :][:1]


@pytest.mark.turns(2)
@by_scene
@pytest.mark.slow
def test_the_equations_of_a_note_hold_with_what_it_states(name: str, many: Many) -> None:
    for language in in_languages(name, many):
        held(of_note(name, language), 20)


@pytest.mark.turns(2)
@by_scene
def test_the_equations_of_sheets_hold_with_what_they_state(name: str, many: Many) -> None:
    for language in in_languages(name, many):
        held(of_sheets(name, language), 3)  # a cylinder that drives needs no more


@pytest.mark.turns(2)
@by_scene
def test_the_equations_of_protocols_hold_with_what_they_state(name: str, many: Many) -> None:
    for language in in_languages(name, many):
        held(of_protocols(name, language), 20)


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.parametrize("name", [name for name in NAMES if name not in LOADED])
def test_the_equations_of_a_note_without_forces_hold(name: str, many: Many) -> None:
    for language in in_languages(name, many):
        held(of_note(name, language), 0)

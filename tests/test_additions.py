"""What one touches to add something: done in a copy, in so many files as the architecture says."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from support.copies import copied
from support.gallery import SHEETS

SHEET = """
import sys
from graphic_tmm.scene.read import read
from graphic_tmm.studio import sheet_files
text = open(sys.argv[1]).read().replace('format = "A4"', 'format = "A3"')
open("scene.toml", "w").write(text)
(first, *_) = sheet_files(read("scene.toml"))[1].values()
print(first[:400])
"""
FORMULA = """
import numpy as np
from graphic_tmm.board.grammar import OPERATIONS
from graphic_tmm.chapters.gears import formulas
print(OPERATIONS["whole_depth"].run(np.array([[2.0]]), np.array([[0.25]])), OPERATIONS["whole_depth"].sentence)
"""
OPERATION = """
from graphic_tmm.board.grammar import OPERATIONS
from graphic_tmm.accuracy.geometrography import symbol
from graphic_tmm.board.operations import instruments
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.paper.rules import traceless
new = OPERATIONS["mark_off"]
print(new.sentence, speaking("ru")(new.sentence), symbol(new), traceless(new), sep=" | ")
"""
KERNEL_KEY = """
import sys
from graphic_tmm.scene.read import read
text = open(sys.argv[1]).read().replace("[plans]", "[plans]\\nheavy = true")
open("scene.toml", "w").write(text)
print(read("scene.toml").heavy, read(sys.argv[1]).heavy)
"""
LAW_FILE = '''"""The law 4-5-6-7: the acceleration begins and ends without a bend."""

from __future__ import annotations

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.formula import formula
from graphic_tmm.board.operations.instruments import lay_off
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number
from graphic_tmm.chapters.cam.laws.ground import DrawnLaw, Ground, uprights


@formula
def smooth_S(u: Number, height: Length) -> Length:
    """{height}·(35·{u}⁴ − 84·{u}⁵ + 70·{u}⁶ − 20·{u}⁷)"""


@formula
def smooth_V(u: Number, stroke: Number, phase: Number, mu: Number) -> Length:
    """{stroke}·(140·{u}³ − 420·{u}⁴ + 420·{u}⁵ − 140·{u}⁶)/({phase}·{mu})"""


@formula
def smooth_A(u: Number, stroke: Number, phase: Number, mu: Number) -> Length:
    """{stroke}·(420·{u}² − 1680·{u}³ + 2100·{u}⁴ − 840·{u}⁵)/({phase}²·{mu})"""


def _points(draft: Draft, ground: Ground, which: str, height: Mark) -> tuple[Mark, ...]:
    (u,) = ground.shares
    op = {"S": smooth_S, "V": smooth_V, "A": smooth_A}[which]
    given = (height,) if which == "S" else (ground.stroke, ground.phase)
    over = uprights(draft, ground, up=which != "V" or ground.of.sign > 0)
    return (draft.draw(lay_off, which.lower(), over, draft.draw(op, "y", u, *given), free=True),)


LAW = DrawnLaw("4-5-6-7", 5, _points, (2.1875, 84.0 * 5.0**0.5 / 25.0))
'''
LAW = """
import sys
from graphic_tmm.readers.table import scene_columns
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make
text = open(sys.argv[1]).read().replace('"sine"', '"4-5-6-7"')
open("scene.toml", "w").write(text)
columns = {one.segment: one for one in scene_columns(make(read("scene.toml"), exact=True))}
print(*columns["S"].value[0, :13])
"""
MISTAKE = """
import sys
from graphic_tmm.checking.mutations.grammar import mutations
from graphic_tmm.checking.mutations.mutation import measured_last
from graphic_tmm.checking.mutations.words import name_of
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make
(board,) = make(read(sys.argv[1]), exact=True).boards
found = [one for one in mutations(measured_last(board.construction)) if name_of(one) == "rate by half"]
print(*sorted({one.at.it.letter for one in found}))
"""

KEY = """
import sys
from graphic_tmm.chapters.gears.plan import GEARS_PLAN
from graphic_tmm.scene.read import read
from graphic_tmm.studio import sheets
text = open(sys.argv[1]).read().replace("[gears]", '[gears]\\nhub = "40 mm"')
open("scene.toml", "w").write(text)
made, paper = sheets(read("scene.toml"))
(board,) = made.boards
(view,) = (one for sheet in paper for one in sheet.drawings if one.name == "hub")
gear = GEARS_PLAN.on(board)
print(float((board.reading[gear.hub].radius * board.reading[gear.line.mu])[0, 0]), view.title)
"""


def added(
    folder: Path,
    edits: dict[str, tuple[str, str]] | list[tuple[str, str, str]],
    code: str,
    *arguments: str,
) -> str:
    """Return what a program prints with a copy of the package in which files (old, new) were edited."""
    copy = copied(folder)
    rows = edits if isinstance(edits, list) else [(name, *both) for name, both in edits.items()]
    for name, old, new in rows:
        text = (copy / name).read_text(encoding="utf-8") if old else ""
        assert old in text
        (copy / name).write_text(text.replace(old, new, 1), encoding="utf-8")
    done = subprocess.run(
        [sys.executable, "-c", code, *arguments],
        cwd=folder,
        env={"PYTHONPATH": str(folder), "PYTHONIOENCODING": "utf-8"},
        capture_output=True,
        encoding="utf-8",
        check=False,
    )
    assert done.returncode == 0, done.stderr
    return done.stdout


@pytest.mark.slow
def test_a_format_is_one_file(tmp_path: Path) -> None:
    line = '        "A1 portrait": Format('
    new = f'        "A3": Format(420.0, 297.0, 0.6, 0.58, 60.0, 1.0),\n{line}'
    scene = str(SHEETS / "slider-diagrams" / "scene.toml")
    told = added(tmp_path, {"paper/formats.py": (line, new)}, SHEET, scene)
    assert 'width="420mm"' in told
    assert 'viewBox="0 0 420 297"' in told


@pytest.mark.slow
def test_a_formula_is_one_file(tmp_path: Path) -> None:
    line = '@formula(\n    why=said(\n        "The base circles stay the same'
    new = (
        "@formula\ndef whole_depth(m: Number, c: Number) -> Number:\n"
        f'    """2·{{m}} + {{c}}·{{m}}"""\n\n\n{line}'
    )
    told = added(tmp_path, {"chapters/gears/formulas.py": (line, new)}, FORMULA)
    assert told.split() == ["[[4.5]]", "2·{m}", "+", "{c}·{m}"]


@pytest.mark.slow
def test_an_instrument_operation_is_one_file_and_its_words(tmp_path: Path) -> None:
    """Its work and its slips stand with it; other languages have a line each."""
    line = '@operation(symbol=JOIN, fails=_NO_LINE, why=said("A line is fixed'
    new = (
        '@operation(symbol="C1")\ndef mark_off(on: Line) -> Point:\n'
        f'    """Mark off the beginning {{it}} of {{on}}."""\n    return Point(on.at)\n\n\n{line}'
    )
    entry = 'msgid "Draw the line {it} through {start} and {end}."'
    word = 'msgid "Mark off the beginning {it} of {on}."\nmsgstr "Отметить начало {it} прямой {on}."\n\n'
    edits = {
        "board/operations/instruments.py": (line, new),
        "language/ru.po": (entry, word + entry),
    }
    told = added(tmp_path, edits, OPERATION)
    assert (
        "Mark off the beginning {it} of {on}. | Отметить начало {it} прямой {on}. | C1 | False"
        in told
    )


@pytest.mark.slow
def test_a_key_with_a_view_is_three_files(tmp_path: Path) -> None:
    """And a line of the catalogue, if its title is new; the reference of keys and the schema are printed."""
    field = "    c: float = key(v.CLEARANCE,"
    own = '    hub: float | None = key(v.POSITIVE_LENGTH, "diameter of a hub", "40 mm", None)\n'
    made = "    return Gear(order,"
    steps = (
        "    hub = None\n    if order.hub is not None:\n"
        '        draft.open("hub")\n        draft.mu_l = line.mu\n        centre = draft.take(Point, "O", 0j)\n'
        '        hub = draft.draw(strike, "(h)", centre, draft.length("r_h", order.hub / 2))\n'
    )
    done, shown = (
        "contact, sliding, checks, rack)",
        "    return [*found, _checks(drawn, made, high)]",
    )
    head = "from __future__ import annotations\n"
    wanted = (
        "\nfrom graphic_tmm.board.operations.instruments import strike\n"
        "from graphic_tmm.board.values import Point\n"
    )
    view = (
        "    if made.hub is not None:\n        radius = float(drawn.reading[made.hub].radius[0, 0])\n"
        '        found.append(Drawing("hub", "hub", (circle("main", 0j, radius),)))\n'
    )
    last = "    rack: RackTeeth | None\n"
    edits = [
        ("chapters/gears/task.py", field, own + field),
        ("chapters/gears/plan.py", made, steps + made),
        ("chapters/gears/plan.py", done, done.replace(")", ", hub)")),
        ("chapters/gears/plan.py", last, last + "    hub: Mark | None = None\n"),
        ("chapters/gears/plan.py", head, head + wanted),
        ("chapters/gears/views.py", shown, view + shown),
        ("chapters/gears/views.py", "import Drawing", "import Drawing, circle"),
    ]
    assert len({name for name, *_ in edits}) == 3
    scene = str(SHEETS / "gear-pair" / "scene.toml")
    assert added(tmp_path, edits, KEY, scene).split() == ["0.02", "hub"]


@pytest.mark.slow
def test_a_key_of_the_kernel_is_one_file_and_its_reader(tmp_path: Path) -> None:
    """What ``[plans]`` and ``[hand]`` declare is a field of the scene."""
    line = '    main: str | None = key(v.POSITION, "the position drawn'
    new = f'    heavy: bool = key(v.SWITCH, "all of it in heavy lines", True, False)\n{line}'
    scene = str(SHEETS / "engine" / "scene.toml")
    told = added(tmp_path, {"scene/drawing.py": (line, new)}, KERNEL_KEY, scene)
    assert told.split() == ["True", "False"]


@pytest.mark.slow
def test_the_name_of_a_mistake_is_one_file(tmp_path: Path) -> None:
    line = "BY_OPERATION: dict[tuple[str, str], Said] = {\n"
    entry = f'{line}    (mutation.FACTOR, "rate"): said("rate by half"),\n'
    edits = {"checking/mutations/words.py": (line, entry)}
    found = added(tmp_path, edits, MISTAKE, str(SHEETS / "crank-rocker" / "scene.toml")).split()
    assert "ω_2" in found
    assert "pa" not in found


@pytest.mark.slow
def test_a_law_of_a_cam_is_one_file(tmp_path: Path) -> None:
    scene = str(SHEETS / "cam" / "scene.toml")
    new = {"chapters/cam/laws/smooth.py": ("", LAW_FILE)}
    drawn = [float(one) for one in added(tmp_path, new, LAW, scene).split()]
    u = [k / 12 for k in range(13)]
    due = [0.028 * (35 * x**4 - 84 * x**5 + 70 * x**6 - 20 * x**7) for x in u]
    assert drawn == pytest.approx(due, abs=1e-12)

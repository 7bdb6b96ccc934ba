"""Words of a note as an examiner wants them: references, captions, positions; no cell or line of nothing."""

from __future__ import annotations

import re
from functools import cache

import pytest
from support.laid_out import case_file
from support.notes import noted, parts

from graphic_tmm.board.formula_text import FUNCTIONS, tree_of
from graphic_tmm.note.document import Formula, Heading, Symbol, Table, Text, Tree, runs_of, walk
from graphic_tmm.note.figures import going_on
from graphic_tmm.note.widths import broken


@cache
def _lines() -> list[str]:
    return case_file("slotting", "md").decode().splitlines()


RESISTS = "Момент сопротивления отложен выше оси"


@pytest.mark.slow
def test_figures_that_are_told_together_are_named_once() -> None:
    """«рис. 9, 10», not «рис. 9, рис. 10»; a figure whose parts are all meant has no letters."""
    told = [line for line in _lines() if "показано на рис." in line]
    assert any(re.search(r"рис\.\s\d+, \d+\.", line) for line in told)
    assert not [line for line in told if line.count("рис.") > 1]
    assert not [line for line in told if re.search(r"рис\.\s\d+, а, б", line)]


def test_captions_go_on_with_small_letters() -> None:
    captions = [line for line in _lines() if line.startswith("Рисунок ")]
    assert any("; " in line for line in captions)
    assert any(" а) " in line for line in captions)
    assert not [line for line in captions if re.search(r"(?:[аб]\)|;) [А-Я][а-я]{2}", line)]


@pytest.mark.parametrize("title", ["Zhukovsky's lever", "ΔT of links", "S, V", "T–J"])
def test_names_and_symbols_keep_their_capitals(title: str) -> None:
    assert going_on(title) == title


def test_no_cell_of_the_scales_is_empty() -> None:
    tables = (one for one in walk(noted("cam").blocks) if isinstance(one, Table))
    (scales,) = (one for one in tables if one.id == "table-scales")
    assert all(cell for row in scales.rows for cell in row[:2])


@pytest.mark.parametrize("count", range(2, 16))
def test_nothing_stands_on_a_line_without_what_it_is_equal_to(count: int) -> None:
    """= 0 goes with the last term of its sum, wherever the sum is broken."""
    names = [f"t{k}" for k in range(count)]
    tree = tree_of(" + ".join(f"{{{name}}}" for name in names), FUNCTIONS)
    put = {name: Symbol(f"F_{{{k}}}lmnop") for k, name in enumerate(names)}
    zero = Tree(tree_of("0", FUNCTIONS), {})
    for more in ("", "MM", "MMMM", "MMMMMM"):
        lines = broken(Formula((Symbol(f"M{more}"), Tree(tree, put), zero)))
        assert lines[-1].sides != (zero,)
        assert lines[-1].sides[-1] == zero


def test_a_moment_drives_in_one_position_or_in_several() -> None:
    told = [line for line in _lines() if line.startswith(RESISTS)]
    for line in told:
        assert not re.search(r"положениях \d+\*?[;.,]? *(?:движ|$)", line)
        assert not re.search(r"положении \d+\*?, \d", line)
    assert told


def test_what_stands_above_the_axis_is_told_of_the_positions_where_it_does() -> None:
    """Where the driving moment is constant it is the resisting one that stands above."""
    lines = _lines()
    (told,) = (line for line in lines if line.startswith(RESISTS))
    above, below = (re.findall(r"\d+\*?", part) for part in told.split("движущий"))
    k = next(k for k, line in enumerate(lines) if re.match(r"\| \$`M`\$ +\| +мм", line))
    names, ordinates = (_cells(line) for line in (lines[k - 2], lines[k]))
    signs = {name.strip("\\*"): told for name, told in zip(names, ordinates, strict=True)}
    assert not [at for at in above if "-" in _sign(signs, at)]
    assert not [at for at in below if "-" not in _sign(signs, at)]
    assert above
    assert below


def _cells(line: str) -> list[str]:
    return [cell.strip() for cell in line.strip("|").split("|")][2:]


def _sign(signs: dict[str, str], at: str) -> str:
    return signs[at.strip("*")].replace("−", "-")


def test_a_scale_factor_of_moments_has_one_unit_throughout() -> None:
    text = "\n".join(_lines())
    assert "(Н·м)/мм" in text
    assert not re.search(r"(?<!\()Н·м/мм", text)


def test_a_point_that_lines_go_through_is_laid_off_before() -> None:
    """n₃ of an acceleration plan: its line is not told with the lines that are parallel to it."""
    words = "\n".join(_lines())
    assert re.search(r"отложить на ней \$`\\pi n_\{3\}`\$ до \$`n_\{3\}`\$", words)


STIFF = (
    "there are none",
    "of an A1 (",
    "the sheet is white",
    "Besides:",
    "Taken is",
    "what is given stands",
    "is worked step by step",
    "so many millimetres long",
)


@pytest.mark.slow
def test_english_is_plain() -> None:
    document = noted("cam", "en"), noted("slider-diagrams", "en")
    words = " ".join(
        run.text
        for one in document
        for block in walk(one.blocks)
        for run in runs_of(block)
        if isinstance(run, Text)
    )
    assert "on an A1 sheet" in words
    assert [phrase for phrase in STIFF if phrase in words] == []


@pytest.mark.slow
def test_a_docx_does_not_end_in_a_page_of_two_lines() -> None:
    """The literature stands on one page with its heading."""
    text = parts(case_file("slotting", "docx"))["word/document.xml"].decode()
    _heading, *kept, last = text[text.rfind('w:val="Heading1"') :].split("<w:p>")
    assert len(kept) > 3
    assert all("<w:keepNext />" in one for one in kept)
    assert "<w:keepNext />" not in last


def test_the_direction_of_what_slides_is_a_formula() -> None:
    """«v_B ∥ x» keeps its small letter: no heading of a group."""
    shown = [one for block in walk(noted("gripper").blocks) for one in runs_of(block)]
    assert any(isinstance(one, Formula) and one.sides == (Symbol("v_B ∥ x"),) for one in shown)
    assert not [one for one in shown if isinstance(one, Text) and "∥" in one.text]


def test_an_open_row_has_no_extreme_positions() -> None:
    blocks = [one for one in noted("hand-clamp", "en").blocks if isinstance(one, Heading)]
    headings = [run.text for one in blocks for run in one.runs if isinstance(run, Text)]
    assert "Plan of positions" in headings
    assert "Extreme positions" not in headings

"""Letters of a note as on the drawing; what is calculated stands behind what it needs."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

import pytest
from support.laid_out import note_of_case
from support.notes import noted

from graphic_tmm.board.formula_text import Node
from graphic_tmm.note.document import (
    Document,
    Formula,
    Run,
    Symbol,
    Table,
    Tree,
    ends_apart,
    leaves,
    lettered,
    runs_of,
    walk,
)
from graphic_tmm.note.tex import tex
from graphic_tmm.note.widths import width


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("c_1d_1", "c_{1}d_1"),
        ("N_2P", "N_{2}P"),
        ("O_2O'_2", "O_{2}O'_2"),
        ("F_3max", "F_3max"),
        ("ϑ_2a", "ϑ_2a"),
        ("h_G4", "h_G4"),
    ],
)
def test_the_ends_of_a_segment_have_indices_of_their_own(name: str, told: str) -> None:
    assert ends_apart(name) == told


@pytest.mark.parametrize(
    ("letter", "told"),
    [
        ("F_{3max}", r"F_{3\mathrm{max}}"),
        ("x_{min1}", r"x_{\mathrm{min}1}"),
        ("r*", r"r^{\ast}"),
        ("O*B", r"O^{\ast}B"),
    ],
)
def test_words_of_indices_stand_upright_and_stars_are_raised(letter: str, told: str) -> None:
    assert tex(Symbol(letter), "ru").replace(" ", "") == told


def test_a_format_of_paper_is_no_letter() -> None:
    assert not [run for run in lettered("270 mm of an A1 sheet") if isinstance(run, Symbol)]


def _formulas(document: Document) -> list[Formula]:
    return [run for b in walk(document.blocks) for run in runs_of(b) if isinstance(run, Formula)]


@pytest.mark.parametrize("language", ["ru", "en"])
@pytest.mark.slow
def test_no_letter_is_told_by_its_own_text(language: str) -> None:
    """OA + AB = OA + AB; OA − AB = |OA − AB| is false."""
    for name in ("engine", "project"):
        for one in _formulas(noted(name, language)):
            first = tex(one.sides[0], language)
            for side in one.sides[1:]:
                if isinstance(side, Tree) and isinstance(one.sides[0], Symbol):
                    again = re.sub(r"\\left|\\right|[\s{}|]", "", tex(side, language))
                    assert again != re.sub(r"[\s{}|]", "", first)


def test_in_a_table_what_is_calculated_stands_behind_what_it_needs() -> None:
    """The angle where a tooth is pointed follows from its involute function, which comes first."""
    tables = [b for b in walk(noted("gear-pair").blocks) if isinstance(b, Table) and b.long]
    assert tables
    for table in tables:
        found: dict[Symbol, int] = {}
        told = [
            run for row in table.rows for cell in row for run in cell if isinstance(run, Formula)
        ]
        for k, one in enumerate(told):
            if isinstance(one.sides[0], Symbol):
                found.setdefault(one.sides[0], k)
        for k, one in enumerate(told):
            used = [leaf for side in one.sides[1:] for leaf in leaves(side)]
            letters = [leaf for leaf in used if isinstance(leaf, Symbol)]
            assert all(found.get(leaf, k) <= k for leaf in letters), tex(one, "ru")


def test_no_sentence_calls_a_ray_as_its_axis() -> None:
    for name in ("slotting", "engine"):
        document = note_of_case(name) if name == "slotting" else noted(name)
        for block in walk(document.blocks):
            if isinstance(block, Table) and block.long:
                for _, cell, *_ in block.rows:
                    words = "".join(
                        getattr(run, "text", "") or getattr(run, "markup", "") for run in cell
                    )
                    assert "под углом 0° к оси" not in words
                    assert not re.search(r"провести луч \S+ под углом [^;.]*на ней", words)
                    assert not re.search(r"к оси x, \S+ до", words)


def test_a_minus_before_a_sum_counts_for_one_sign() -> None:
    """Else its first term would not stand behind ΣM, which would be left alone on its line."""
    plus = Node("name", (), "a")
    put = {"a": Symbol("F")}
    assert width(Tree(Node("neg", (plus,)), put)) <= width(Tree(plus, put)) + 1


def test_what_stands_behind_an_index_is_as_wide_as_on_the_line() -> None:
    """П_{y1-y1}(3,6) was cut off in a table: its brackets counted as a part of the index."""
    whole, index = width(Symbol("П_{y1-y1}(3,6)")), width(Symbol("П_{y1-y1}"))
    assert whole - index >= len("(3,6)")


def _markups(runs: Iterable[Run]) -> Iterator[str]:
    for run in runs:
        if isinstance(run, Symbol):
            yield run.markup
        elif isinstance(run, Formula):
            yield from (
                one.markup for side in run.sides for one in leaves(side) if isinstance(one, Symbol)
            )


def test_what_is_given_is_called_so_where_it_is_calculated_with() -> None:
    document = note_of_case("slotting")
    tables = [one for one in walk(document.blocks) if isinstance(one, Table)]
    given = {
        letter.replace("{", "").replace("}", "")
        for one in tables
        if one.id.startswith("table-given")
        for letter in _markups(runs_of(one))
    }
    used = {
        letter.replace("{", "").replace("}", "")
        for block in walk(document.blocks)
        if not (isinstance(block, Table) and block.id.startswith("table-given"))
        for run in runs_of(block)
        if isinstance(run, Formula)
        for letter in _markups([run])
    }
    inertias = {letter for letter in used if re.fullmatch(r"J_([A-EO]|S?\d)", letter)}
    assert inertias
    assert inertias <= given


def test_the_addendum_of_a_reduction_gear_has_its_star() -> None:
    letters = {
        letter.replace("{", "").replace("}", "")
        for block in walk(noted("planetary").blocks)
        for letter in _markups(runs_of(block))
    }
    assert "h_a^*" in letters
    assert "h_a" not in letters

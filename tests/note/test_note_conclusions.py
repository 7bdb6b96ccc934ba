"""What a note concludes: sizes without signs, nothing twice, letters that stand in it."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest
from support.laid_out import NOTES, note_of_case
from support.notes import noted
from support.scenes import written

from graphic_tmm.fitting.auto import formatted
from graphic_tmm.fitting.composition import Composition
from graphic_tmm.fitting.sizes import usual
from graphic_tmm.note.document import (
    Document,
    Heading,
    Listed,
    Number,
    Paragraph,
    Runs,
    Symbol,
    Table,
    Text,
    walk,
)
from graphic_tmm.note.note import note, wanted
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make


def _document(name: str) -> Document:
    return note_of_case(name) if name == "slotting" else noted(name)


def _plain(runs: Runs) -> str:
    words = (
        run.text if isinstance(run, Text | Number) else getattr(run, "markup", "") for run in runs
    )
    return "".join(words).replace("{", "").replace("}", "")


def _concluded(document: Document) -> list[Runs]:
    blocks = list(document.blocks)
    start = next(
        k
        for k, one in enumerate(blocks)
        if isinstance(one, Heading) and _plain(one.runs) == "Заключение"
    )
    behind = blocks[start + 1]
    assert isinstance(behind, Listed)
    paragraphs = (item.blocks[0] for item in behind.items)
    return [one.runs for one in paragraphs if isinstance(one, Paragraph)]


@pytest.mark.parametrize("name", ["slotting", "project"])
def test_nothing_is_concluded_twice(name: str) -> None:
    told = Counter(map(_plain, _concluded(_document(name))))
    assert len(told) > 5
    assert max(told.values()) == 1


@pytest.mark.parametrize("name", ["slotting", "project", "engine"])
def test_what_differs_at_most_differs_by_a_size_to_hundredths(name: str) -> None:
    """«не более чем на −3,1 %», «0,06764 %»: nobody writes so."""
    shares = [
        run
        for runs in _concluded(_document(name))
        for run in runs
        if isinstance(run, Number) and run.unit == "%"
    ]
    assert shares
    assert all(len(run.text.partition(",")[2]) <= 2 for run in shares)
    apart = [runs for runs in _concluded(_document(name)) if "расходится" in _plain(runs)]
    assert all("−" not in run.text for runs in apart for run in runs if isinstance(run, Number))


@pytest.mark.parametrize(("name", "count"), [("slotting", 0), ("engine", 1)])
def test_an_index_that_is_a_word_is_listed_where_it_is_used(name: str, count: int) -> None:
    """A pressure stands in the list of symbols where there is gas: a pole p is none."""
    tables = [b for b in walk(_document(name).blocks) if isinstance(b, Table)]
    listed = next(one for one in tables if one.id == "table-symbols")
    letters = [
        run for row in listed.rows for cell in row for run in cell if isinstance(run, Symbol)
    ]
    assert sum(one.markup.startswith("p_") for one in letters) == count


@pytest.mark.parametrize(("first", "last"), [(0, "11–12"), (1, "12–13")])
@pytest.mark.slow
def test_the_last_interval_ends_at_the_number_that_goes_on(
    first: int, last: str, tmp_path: Path
) -> None:
    """Numbered from 1, the turn ends at 13: no interval begins and ends at 12."""
    text = (NOTES / "slotting.toml").read_text("utf-8")
    text = text.replace("[drive]\n", f"[drive]\nfirst = {first}\n")
    task = read(written(tmp_path, text))
    drawn = make(task, wanted=wanted(task), given=Composition(usual(formatted(task)), ()))
    tables = [b for b in walk(note(drawn).blocks) if isinstance(b, Table)]
    middles = [one for one in tables if one.id.startswith("table-middles")]
    assert {_plain(one.heads[-1]) for one in middles} == {last}

"""The section of a note on how exact the constructions are: sentences, sources, the front, the figure."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.accuracy.answer import Answer
from graphic_tmm.accuracy.answer_text import costs, most, parts, table_cells, table_columns
from graphic_tmm.accuracy.figure_inline import inline_figure
from graphic_tmm.accuracy.words import WORDS
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.note.bricks import referred
from graphic_tmm.note.document import Block, Heading, ReadyPicture, Runs, Table, paragraph, text

ACCURACY = said("Accuracy of the constructions")
SEE = said("What was tried at the board, and where the error comes from, is shown in {}.")
SOURCES = said("Where the error comes from: shares of the mean square error, %")
BY_STUDENT = said(
    "Where the error would come from by a student's hand: shares of the mean square error, %"
)
FIGURE = said("Error and work at the board; where the error comes from")
SOURCE, SETTING = said("Source of the error"), said("Setting")
LETTERS = said(
    "An error is what nine readings of ten keep within, in % of the largest value of the turn; × is how many "
    "times as large the drawing is; min are minutes at the board for all that the sheets show."
)


def accuracy_section(answer: Answer) -> Iterator[Block]:
    """Yield the blocks of the section, in the language of the scene."""
    language = answer.scene.language
    _ = speaking(language)
    yield Heading(1, text(_(ACCURACY)))
    yield from (paragraph(one) for one in costs(answer))
    yield paragraph(_(LETTERS))
    yield from _sources(answer)
    yield _front(answer)
    drawn = inline_figure(answer)
    figure = ReadyPicture(
        "fig-accuracy",
        text(_(FIGURE)),
        drawn.svg,
        drawn.width,
        drawn.height,
        f"{answer.scene.title}. {_(FIGURE)}",
    )
    yield referred((figure,), language, SEE)
    yield figure


def _sources(answer: Answer) -> Iterator[Block]:
    """Yield the sources of the quantity that errs most and of the main one, and the steps that bring most."""
    language, names = answer.scene.language, dict.fromkeys((answer.worst, answer.main))
    words, _ = WORDS[language], speaking(language)
    origins = {name: one for name in names if (one := answer.origin(name)) is not None}
    shares = {name: dict(parts(one.of[name])) for name, one in origins.items()}
    every = dict.fromkeys(source for of in shares.values() for source in of)
    rows = [
        (
            text(words[f"from {source}"]),
            *(_share(of.get(source), language) for of in shares.values()),
        )
        for source in every
    ]
    if not rows:
        return
    heads = text(_(SOURCE)), *(text(words[name]) for name in shares)
    title = text(_(SOURCES if answer.printed is None else BY_STUDENT))
    yield Table("table-error-sources", title, heads, tuple(rows), f"l{'c' * len(shares)}")
    for name, origin in origins.items():
        if step := most(origin, origin.of[name], language):
            yield paragraph(f"{words[name]}: {step[:1].lower()}{step[1:]}")


def _share(share: float | None, language: str) -> Runs:
    return text("—" if share is None else number(100.0 * share, language, 2))


def _front(answer: Answer) -> Table:
    """Return the table of the front; the scene itself and the knee are named."""
    language = answer.scene.language
    words = WORDS[language]
    rows = []
    for row in answer.rows:
        own, knee = row.way is answer.own.way, row is answer.knee
        named = (words["figure own"] if own else "", words["figure knee"] if knee else "")
        cells = (", ".join(one for one in named if one), *table_cells(answer, row, language))
        rows.append(tuple(map(text, cells)))
    heads = tuple(map(text, (speaking(language)(SETTING), *table_columns(answer))))
    align = f"l{'c' * (len(heads) - 1)}"
    return Table("table-accuracy", text(words["answer table"]), heads, tuple(rows), align)

"""Series of pictures on sheets of A4: pictures with their sentences, in the order in which one reads."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from itertools import groupby
from typing import NamedTuple

from graphic_tmm.handout.ink import FORMAT, times
from graphic_tmm.handout.series import COLUMN, FULL, GAP, Picture, Series, smaller
from graphic_tmm.handout.words import LetteringRow, broken, rows
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Drawing, Ink, Label, Sheet, shifted
from graphic_tmm.paper.formats import size_of
from graphic_tmm.paper.lettering.letters import letter
from graphic_tmm.paper.ruled import PITCH
from graphic_tmm.paper.sheet_frame import drawing_area, frame, standard

EDGE = 5.0
"""White within the frame, mm."""
BETWEEN = 6.0
"""Between pictures one below the other, mm."""
LEAST = 38.0
"""The least width of a picture of another position, for its sentence, mm."""
LINES = 0.4
"""Clear between lines of lettering that reach far, of their height."""
NUMBER, TITLE, CAPTION = 5.0, 5.0, 3.5
"""Heights of the numbers of pictures, of titles, of what else stands at the head of a sheet, mm."""
HEAD = 7.5
"""Above a picture, for its number, mm."""
TEXT = 3.0
"""Clear between a picture and its sentences, mm."""
SCALE = said("scale of the pictures {scale}; mm in the sentences as at 1:1")
FURTHER = said("{number}, continued")
SIZE = said("scale of the pictures 1:1")


class Standing(NamedTuple):
    """How a picture stands on its sheet.

    ``factor``: how many times as large as the others; ``room``, ``text``: its width and that of its sentences,
    mm; ``beside``: whether these stand beside it.
    """

    factor: float
    room: float
    text: float
    beside: bool


class Cell(NamedTuple):
    """A picture with its sentences: the rows of these, how it stands, its height with them, mm."""

    picture: Picture
    rows: tuple[LetteringRow, ...]
    stand: Standing
    height: float


def ratio(factor: float, language: str) -> str:
    """Return a factor as scales are written.

    >>> ratio(0.4, "en"), ratio(2.5, "ru"), ratio(1.0, "en")
    ('1:2.5', '2,5:1', '1:1')
    """
    if factor < 1.0:
        return f"1:{number(1 / factor, language)}"
    return f"{number(factor, language)}:1"


def head(one: Series, *, first: bool) -> list[LetteringRow]:
    """Return the lines at the head of a sheet of a series: on the ``first`` one its caption, too."""
    _, width = speaking(one.language), _head_width(one.language)
    title = one.title.replace(" ", "")
    told = [row for row in one.told if row.replace(" ", "") not in title] if first else []
    scale = SIZE if one.factor == 1.0 else SCALE
    told.append(_(scale, scale=ratio(one.factor, one.language)))
    lines = [row for text in told for row in broken(text, CAPTION, width)]
    return [*broken(one.title, TITLE, width), *lines]


class Paper(NamedTuple):
    """A sheet's room, mm: left and right edge, lower edge, upper edge; where a head begins."""

    left: float
    right: float
    bottom: float
    top: float
    head: complex


def paper(language: str, *, opens: bool = False) -> Paper:
    """Return the room of a sheet; its head stands beside what the frame has at the upper edge.

    ``opens``: whether it is the first of a text, for which ГОСТ 2.104 has a form of its own.
    """
    opens = opens and standard(language) == "GOST"
    inner, occupied = drawing_area(FORMAT, language, opens, text=True)
    above = [box for box in occupied if box.top >= inner.top - 1e-9]
    below = [box.top for box in occupied if box not in above]
    return Paper(
        inner.left + EDGE,
        inner.right - EDGE,
        max([inner.bottom, *below]) + EDGE,
        inner.top - EDGE,
        complex(max([inner.left, *(box.right for box in above)]) + EDGE, inner.top - EDGE),
    )


def _head_width(language: str) -> float:
    room = paper(language)
    return room.right - room.head.real


def cells(one: Series, most: float) -> Iterator[Cell]:
    """Yield the pictures with their sentences; what a sheet does not hold goes on in a cell of its own.

    ``most``: the height of a sheet, mm.
    """
    known = set[str]()
    for picture in one.pictures:
        stand = standing(one, picture)
        high = stand.factor * (one.box[3] - one.box[1])
        left, taken = list[LetteringRow](), HEAD + (0.0 if stand.beside else high + TEXT)
        least = HEAD + high
        for some in rows(picture.lines, stand.text, one.letters, one.language, known):
            step = sum(map(advance, some))
            if taken + step > most:
                yield Cell(picture, tuple(left), stand, max(taken, least))
                picture = picture._replace(ink=(), letters=())
                left, taken, least = [], HEAD, 0.0
            left += some
            taken += step
        yield Cell(picture, tuple(left), stand, max(taken, least))


def standing(one: Series, picture: Picture) -> Standing:
    """Return how a picture stands: one of another position small, as many in a row as there is room for."""
    if not picture.again:
        return Standing(1.0, one.manner.width, one.manner.text, one.manner.beside)
    factor = smaller(one.factor) / one.factor
    wide = max(factor * (one.box[2] - one.box[0]), LEAST)
    count = max(1, int((FULL + GAP) // (wide + GAP)))
    room = (FULL + GAP) / count - GAP
    return Standing(factor, room, room, False)


def advance(row: LetteringRow) -> float:
    """Return how high a line of lettering is with what is clear above it, mm."""
    made = letter(row.text, size=row.size)
    return max(PITCH * row.size, made.ascent + made.descent + LINES * row.size)


def set_rows(some: Sequence[LetteringRow], at: complex) -> Iterator[Label]:
    """Yield lines of lettering one below the other; ``at``: the upper left corner, mm."""
    down = at.imag
    for row in some:
        made = letter(row.text, size=row.size)
        down -= advance(row)
        foot = max((PITCH - 1.0) * row.size / 2, made.descent)
        yield Label(row.text, complex(at.real - min(made.left, 0.0), down + foot), row.size)


def laid_picture(cell: Cell, one: Series, at: complex) -> Drawing:
    """Return a picture with its sentences on the sheet; ``at``: the upper left corner, mm."""
    picture, stand = cell.picture, cell.stand
    number = str(picture.number)
    if not picture.ink:
        number = speaking(one.language)(FURTHER, number=number)
    labels = [Label(number, at - 1j * NUMBER, NUMBER)]
    x0, y0, x1, y1 = (stand.factor * edge for edge in one.box)
    text, strokes = at - 1j * HEAD, list[Ink]()
    if picture.ink:
        by = text + (stand.room - (x1 - x0)) / 2 - complex(x0, y1)
        if stand.factor == 1.0:
            strokes = [shifted(stroke, by) for stroke in picture.ink]
            labels += [label._replace(at=label.at + by) for label in picture.letters]
        else:  # letters so small could not be read
            strokes = [shifted(times(stroke, stand.factor), by) for stroke in picture.ink]
            told = f"({ratio(stand.factor * one.factor, one.language)})"
            end = at + stand.room - 1j * NUMBER
            labels.append(Label(told, end, CAPTION, "end"))
        text += stand.room + GAP if stand.beside else -1j * (y1 - y0 + TEXT)
    labels += set_rows(cell.rows, text)
    title = f"{one.title}: {picture.number}"
    return Drawing(f"{one.name} {picture.number}", title, tuple(strokes), tuple(labels))


def pages(one: Series) -> list[list[Drawing]]:
    """Return what stands on the sheets of a series, a list a sheet, without their frames.

    Pictures follow one another down a column, then down the next one; those of other positions stand in rows.
    """
    room = paper(one.language)
    heads = [head(one, first=first) for first in (True, False)]
    titles = [_title(one, rows, room) for rows in heads]
    starts = [room.top - sum(map(advance, rows)) - BETWEEN for rows in heads]
    found: list[list[Drawing]] = []
    place = NextSpot(room, one.manner.columns, starts)
    for again, group in groupby(cells(one, starts[0] - room.bottom), lambda c: c.picture.again):
        for cell, at, sheet in place.rows(group) if again else place.columns(group):
            if sheet == len(found):
                found.append([titles[sheet > 0]])
            found[sheet].append(laid_picture(cell, one, at))
    return found


def _title(one: Series, rows: Sequence[LetteringRow], room: Paper) -> Drawing:
    return Drawing(f"{one.name} title", one.title, (), tuple(set_rows(rows, room.head)))


Stood = Iterator[tuple[Cell, complex, int]]
"""Pictures, their upper left corners, mm, the index of their sheet."""


class NextSpot:
    """Where the next picture of a series may stand: the sheet, its upper edge."""

    def __init__(self, room: Paper, count: int, starts: Sequence[float]) -> None:
        self.room, self.count, self.starts = room, count, starts
        self.sheet, self.top = 0, starts[0]

    def turn(self) -> None:
        """Begin a new sheet."""
        self.sheet += 1
        self.top = self.starts[1]

    def columns(self, some: Iterable[Cell]) -> Stood:
        """Yield pictures down columns; the next one begins as high as the first on its sheet."""
        begin, low, column = self.top, self.top, 0
        for cell in some:
            if self.top - cell.height < self.room.bottom:
                column, self.top = column + 1, begin
            if column >= self.count or self.top - cell.height < self.room.bottom:
                self.turn()
                begin, low, column = self.top, self.top, 0
            yield cell, complex(self.room.left + column * (COLUMN + GAP), self.top), self.sheet
            self.top -= cell.height + BETWEEN
            low = min(low, self.top)
        self.top = low

    def rows(self, some: Iterable[Cell]) -> Stood:
        """Yield pictures in rows, all of them alike."""
        there = list(some)
        across = max(1, round((FULL + GAP) / (there[0].stand.room + GAP)))
        for k in range(0, len(there), across):
            row = there[k : k + across]
            height = max(cell.height for cell in row)
            if self.top - height < self.room.bottom:
                self.turn()
            for n, cell in enumerate(row):
                at = complex(self.room.left + n * (cell.stand.room + GAP), self.top)
                yield cell, at, self.sheet
            self.top -= height + BETWEEN


def framed(
    made: Sequence[tuple[str, Sequence[Drawing]]],
    fields: Mapping[str, str],
    title: str,
    language: str,
    *,
    check: bool,
    stem: str = "steps",
    opens: bool = False,
) -> list[Sheet]:
    """Return sheets in their frames; each is told by what it is called and what stands on it.

    ``stem``: what they are called besides their numbers; ``opens``: whether the first bears the form of one.
    """
    width, height = size_of(FORMAT)
    opens = opens and standard(language) == "GOST"
    found = []
    for n, (called, drawings) in enumerate(made, 1):
        edge = frame(
            FORMAT,
            language=language,
            first=opens and n == 1,
            text=True,
            number=n,
            count=len(made),
            fields={**fields, "name": called},
            check=check,
        )
        found.append(
            Sheet(f"{stem}-{n}", title, FORMAT, width, height, (edge, *drawings), language)
        )
    return found

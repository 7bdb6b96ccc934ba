"""Views as figures of a note: the same ink as on a sheet, without its title, each on paper of its size."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from typing import NamedTuple

from graphic_tmm.drawn import Drawn
from graphic_tmm.note.document import Document, Picture, ReadyPicture, SideBySide, letter_of, text
from graphic_tmm.paper.drawing import EQUATIONS, TABLE, Drawing, Label, Sheet
from graphic_tmm.paper.formats import HEIGHTS, Heights
from graphic_tmm.paper.lettering.letters import plain
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.views import alone
from graphic_tmm.paper.write.svg import clean, svg

FORMAT = "A4"
"""The format whose pens figures are drawn with: a note is held in the hand."""
LETTERED = (1.0, 1.4, 1.8, 2.2, 2.8)
"""How many times larger than on that format letters are drawn, the least of these in which they can be read."""
USUAL = 1.8
"""Of 150 sets of figures of the gallery's notes two in three are read in these first."""
LEGIBLE, SPARE = 2.5, 1.1
"""The least letter of a figure on the page, mm; how much larger it is drawn, for what stands beside another."""
WIDTH, HEIGHT, WHOLE = 165.0, 66.0, 120.0
"""Room for a figure on a page, mm: its width, its usual height, the height of a page."""
SMALLEST, LEAST = 0.45, 0.3
"""A figure takes more of a page than usual before it is made smaller than this, and than the second in any
case. Chosen by eye."""
LARGEST = 1.25
"""How many times a figure may be enlarged: its letters would shout else. Chosen by eye."""
LETTER = 3.5
"""How large the letter of a part of a figure is on the page, mm."""
GAP = 5.0
"""What is between parts beside one another, mm."""
LESS, ALIKE = 0.72, 0.55
"""Parts beside one another are made smaller than this times no view; the lowest is so high of the highest."""
AT_MOST = 1.7
"""No part is shown larger than so many times the smallest one beside it: their letters are of a size."""
EDGE = 1.5
"""White about a figure, mm: half of its thickest line, and a little."""


def in_hand(drawn: Drawn, times: float = 1.0) -> Drawn:
    """Return a board whose views are lettered as those of a sheet held in the hand, or larger."""
    scene = drawn.scene
    orders = tuple(replace(order, format=FORMAT) for order in scene.sheets)
    letters = Heights(*scene.letters) if scene.letters else HEIGHTS[FORMAT]
    scene = replace(scene, sheets=orders, letters=letters.times(times))
    return replace(drawn, project=replace(drawn.project, scene=scene))


def readable(drawn: Drawn, *draws: Callable[[Drawn], Iterable[Drawing]]) -> list[Drawing]:
    """Return views that are figures, each in the least letters that can be read on the page.

    If none can, in those that are largest there. ``draws``: what is drawn again in other letters is all of one.
    """
    return [view for draw in draws for view in _readable(drawn, draw)]


def _readable(drawn: Drawn, draw: Callable[[Drawn], Iterable[Drawing]]) -> Iterator[Drawing]:
    tried: dict[str, dict[float, Drawing]] = {}
    wanted: float | None = USUAL
    while wanted is not None:
        for view in filter(is_figure, draw(in_hand(drawn, wanted))):
            tried.setdefault(view.name, {})[wanted] = view
        wanted = min(filter(None, map(_wanted, tried.values())), default=None)
    for sizes in tried.values():
        least = {times: least_letter([view]) for times, view in sorted(sizes.items())}
        read = (times for times, high in least.items() if high >= SPARE * LEGIBLE)
        yield sizes[next(read, max(least, key=lambda times: least[times]))]


def _wanted(tried: Mapping[float, Drawing]) -> float | None:
    """Return in which letters a view has to be drawn, too, before the least are known; None if they are.

    What cannot be read in any is drawn in all.
    """
    read = [times for times, one in tried.items() if least_letter([one]) >= SPARE * LEGIBLE]
    left = [
        times for times in LETTERED if times not in tried and times < min(read, default=math.inf)
    ]
    if read:
        return next((t for t in left if _at_most(tried, t) >= SPARE * LEGIBLE - TOUCH), None)
    return next((times for times in left if times > max(tried)), next(iter(left), None))


def _at_most(tried: Mapping[float, Drawing], times: float) -> float:
    """Return how high the least letter is at most on the page if a view is drawn in smaller letters, mm.

    Nothing of it shrinks more than they do; what is lettered in one size only is no worse in larger letters.
    """
    known = min(one for one in tried if one > times)
    view, share = _untitled(tried[known]), times / known
    ((width, height),) = paper_sizes([view])
    letter = min((label.size for label in view.labels), default=math.inf)
    return share * letter * scale(share * width, share * height)


def least_letter(views: Sequence[Drawing]) -> float:
    """Return how high the least letter of views beside one another is on the page, mm."""
    shown = [_untitled(view) for view in views if is_figure(view)]
    sizes = (
        times * label.size
        for view, times in zip(shown, scales_of(shown), strict=True)
        for label in view.labels
    )
    return min(sizes, default=math.inf)


def _untitled(view: Drawing) -> Drawing:
    """Return a view without its title, which stands in the caption of the figure."""
    titled, _ = _below(view)
    kept = tuple(label for label in view.labels if label not in titled)
    return view._replace(labels=kept, cell=None, apart=None)


def is_figure(drawing: Drawing) -> bool:
    """Whether a view is a figure: tables and equations are set as such."""
    return drawing.role not in (TABLE, EQUATIONS)


def picture(drawing: Drawing, language: str, name: str = "") -> Picture:
    """Return a view as a figure; ``name``: its id, if that is not its own.

    The title below it is the caption of the figure; what else is told below it stays where it is.
    """
    drawing = alone(drawing)
    titled, told = _below(drawing)
    title = " ".join(clean(plain(label.text)) for label in titled) or clean(plain(drawing.title))
    first, *more = title.split("; ")
    title = "; ".join([first, *map(going_on, more)])
    alt = ", ".join([title, *(clean(plain(label.text)).rstrip(",") for label in told)])
    return Picture(
        f"fig-{name or drawing.name}".replace(" ", "-"), text(title), _untitled(drawing), alt
    )


def going_on(title: str) -> str:
    """Return a title as it goes on a sentence: with a small letter, unless it begins with a name or a symbol.

    >>> going_on("Plan of positions"), going_on("Zhukovsky's lever"), going_on("ΔT of links")
    ('plan of positions', "Zhukovsky's lever", 'ΔT of links')
    """
    word = title.partition(" ")[0]
    kept = word.endswith(("'s", "’s")) or len(word) < LEAST_WORD or not word[1:].islower()
    return title if kept else f"{title[0].lower()}{title[1:]}"


LEAST_WORD = 3
"""What has fewer letters is no word but a symbol."""


def _below(drawing: Drawing) -> tuple[list[Label], list[Label]]:
    """Return the lettering below a view: the lines of its title, which are the largest, and the others."""
    low = bounds(drawing)[1] + drawing.foot
    below = [label for label in drawing.labels if drawing.foot and label.at.imag < low - TOUCH]
    largest = max((label.size for label in below), default=0.0)
    title = [label for label in below if label.size == largest]
    if all(label.size == largest for label in below) and len(below) > 1:
        title = below[:1]
    return title, [label for label in below if label not in title]


TOUCH = 1e-9
"""Lengths nearer to one another than this, mm, are one."""


def sheet_of(
    drawing: Drawing, language: str, name: str, letter: str = "", times: float = 1.0
) -> Sheet:
    """Return a paper just as large as a view.

    ``letter``: of a part of a figure, it stands below; ``times``: how many times larger that is shown.
    """
    left, low, right, top = bounds(drawing._replace(cell=None))
    moved = drawing.moved(complex(EDGE - left, EDGE - low))
    width, height = right - left + 2 * EDGE, top - low + 2 * EDGE
    if letter:
        size = LETTER / times
        label = Label(letter, complex(width / 2, 0.6 * size), size, "middle", inclined=False)
        moved = moved.moved(2j * size)
        moved, height = moved._replace(labels=(*moved.labels, label)), height + 2 * size
    return Sheet(name, drawing.title, FORMAT, width, height, (moved,), language)


def scale(width: float, height: float) -> float:
    """Return how many times larger a picture stands on its page."""
    usual = min(HEIGHT / height, LARGEST)
    return min(WIDTH / width, max(usual, min(SMALLEST, max(LEAST, WHOLE / height))))


def paper_sizes(views: Sequence[Drawing]) -> list[tuple[float, float]]:
    """Return how wide and high the papers of views are, mm."""
    boxes = [bounds(one._replace(cell=None)) for one in views]
    return [(box[2] - box[0] + 2 * EDGE, box[3] - box[1] + 2 * EDGE) for box in boxes]


def fit(pictures: Sequence[Picture]) -> bool:
    """Whether views stand beside one another on a page without being made much smaller."""
    views = [one.drawing for one in pictures]
    if least_letter(views) < LEGIBLE:
        return False
    sizes = paper_sizes(views)
    heights = [size[1] * scale(*size) for size in sizes]
    if min(heights) < ALIKE * max(heights):
        return False
    return sum(size[0] * scale(*size) for size in sizes) * LESS + GAP <= WIDTH


def scales_of(views: Sequence[Drawing]) -> list[float]:
    """Return how many times larger views stand on their page, one alone or several beside one another."""
    sizes = paper_sizes(views)
    times = [scale(*size) for size in sizes]
    if len(views) < 2:
        return times
    times = [min(one, AT_MOST * min(times)) for one in times]
    room = WIDTH - GAP * (len(sizes) - 1)
    wide = sum(one * size[0] for one, size in zip(times, sizes, strict=True))
    return [one * min(1.0, room / wide) for one in times]


class DrawnFigure(NamedTuple):
    """A figure ready to be shown: its file's name, its paper, how wide it stands on the page, mm."""

    name: str
    sheet: Sheet | ReadyPicture
    width: float
    alt: str

    @property
    def svg(self) -> str:
        """The figure as SVG."""
        return svg(self.sheet) if isinstance(self.sheet, Sheet) else self.sheet.svg

    @property
    def height(self) -> float:
        """How high it stands on the page, mm."""
        return self.width * self.sheet.height / self.sheet.width


def drawn_figures(document: Document) -> dict[str, DrawnFigure]:
    """Return the figures of a note by id, each on a paper of its size."""
    found: dict[str, DrawnFigure] = {}
    for block in document.blocks:
        if isinstance(block, ReadyPicture):
            name = f"figure-{len(found) + 1}"
            found[block.id] = DrawnFigure(name, block, round(block.width, 1), block.alt)
        elif isinstance(block, Picture | SideBySide):
            _draw(block, document.language, found)
    return found


def _draw(block: Picture | SideBySide, language: str, found: dict[str, DrawnFigure]) -> None:
    """Enter a figure, or the parts of one, each with its letter."""
    parts = (block,) if isinstance(block, Picture) else block.parts
    times = scales_of([one.drawing for one in parts])
    for k, (one, larger) in enumerate(zip(parts, times, strict=True)):
        letter = f"{letter_of(k, language)})" if len(parts) > 1 else ""
        sheet = sheet_of(one.drawing, language, f"figure-{len(found) + 1}", letter, larger)
        found[one.id] = DrawnFigure(sheet.name, sheet, round(sheet.width * larger, 1), one.alt)

"""The sheets of a task: bands one below the other on A4, how close they are set, where they go on."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cache
from itertools import pairwise
from typing import NamedTuple

from graphic_tmm.handout.sheets import CAPTION, TITLE, advance, framed, paper, set_rows
from graphic_tmm.handout.words import LetteringRow, broken
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.paper.drawing import Drawing, Sheet
from graphic_tmm.paper.lettering.letters import letter
from graphic_tmm.paper.packing import bounds
from graphic_tmm.scene.records import Scene


class Setting(NamedTuple):
    """How close a task is set; mm.

    ``text``, ``heading``, ``rows``: heights of what is read, of headings, of letters in tables (ГОСТ 2.304);
    ``between``, ``least``: between blocks, and between the sentences of one list; ``share``: of its usual
    height that the scheme may take; ``run_in``: whether sentences begin on the line of their heading;
    ``under``: whether they stand in what is free below the scheme beside its table, too.
    """

    text: float = 3.5
    heading: float = 5.0
    rows: float = 3.5
    between: float = 4.0
    least: float = 1.5
    share: float = 1.0
    run_in: bool = False
    under: bool = False


ROOMY = Setting()
_CLOSE = Setting(between=3.0, least=0.8, under=True)
_CLOSER = _CLOSE._replace(run_in=True, rows=2.5)
_SMALL = Setting(2.5, 3.5, 2.5, 3.0, 1.0, 0.8, under=True)
SETTINGS = (
    ROOMY,
    ROOMY._replace(share=0.72),
    _CLOSE,
    _CLOSE._replace(rows=2.5),
    _CLOSER,
    _CLOSER._replace(share=0.72),
    _SMALL,
    _SMALL._replace(share=0.6, run_in=True, between=2.2, least=0.4),
)
"""The first that saves a sheet is taken."""
FILLING = tuple(
    one._replace(share=share)
    for one in (ROOMY, ROOMY._replace(under=True), _CLOSE._replace(rows=2.5))
    for share in (1.0, 1.3, 1.6)
)
"""Where several sheets are needed in any of them: that is taken which leaves them the least white."""


AMID = 0.12
"""A break that is not before a heading is as bad as this share of a sheet left white, squared."""


class Band(NamedTuple):
    """What stands side by side: drawings and where their upper left corners (0) come to from that of the band.

    ``height``, ``above``: how high it is, what is clear above, mm; ``heads``: whether a heading begins it.
    """

    parts: tuple[tuple[Drawing, complex], ...]
    height: float
    above: float
    heads: bool


class Paged(NamedTuple):
    """The bands of each sheet, and how bad that is: sheets left white, squared, and breaks amid a list."""

    sheets: tuple[Sequence[Band], ...]
    bad: float


Chosen = tuple[float, tuple[int, ...]]
"""How bad breaks are, and before which bands they are."""


def paged(bands: Sequence[Band], first: float, other: float, between: float) -> Paged:
    """Return the bands of each sheet; ``first``, ``other``: what the first and other sheets hold, mm.

    ``between``: clear above what begins a sheet, mm. What no sheet holds has one of its own.
    """

    @cache
    def best(begin: int) -> tuple[int, Chosen]:
        """Return how many sheets there are from a band on, how bad, and where they end."""
        if begin == len(bands):
            return 0, (0.0, ())
        room = first if begin == 0 else other
        found = list[tuple[int, Chosen]]()
        used = 0.0
        for end in range(begin + 1, len(bands) + 1):
            last = bands[end - 1]
            used += last.height + (last.above if end - 1 > begin or begin == 0 else between)
            if used > room + 1e-9 and end > begin + 1:
                break
            count, (bad, ends) = best(end)
            amid = AMID if end < len(bands) and not bands[end].heads else 0.0
            cost = (1.0 - min(used / room, 1.0)) ** 2 + amid + bad
            found.append((count + 1, (cost, (end, *ends))))
        return min(found)

    _, (bad, ends) = best(0)
    return Paged(tuple(bands[at:end] for at, end in pairwise((0, *ends))), bad)


BESIDE = 6.0
"""Between blocks beside one another, mm."""
CAPTION_WIDE = 84.0
"""Lines below a view are no narrower, mm, if there is room."""
RAG, NARROWER = 6.0, (0.95, 0.9, 0.85, 0.8)
"""A last line shorter than so many heights is a rag; lines so much narrower are tried to be rid of it."""
LOOSER = 1.7
"""What is clear between bands grows so many times at most where a sheet has room left."""
HEAD = 12.0
"""The head of a sheet is no lower, mm: the frame has something beside it."""


class Block(NamedTuple):
    """What stands together: a drawing whose upper left corner is 0, how large it is, what is clear above.

    ``middle``: stands in the middle; ``heads``: a heading begins it; ``follows``: goes on with what is above.
    """

    drawing: Drawing
    width: float
    height: float
    above: float = ROOMY.between
    middle: bool = False
    heads: bool = False
    follows: bool = False


def width_of(language: str) -> float:
    """Return how wide a sheet's room is, mm."""
    room = paper(language)
    return room.right - room.left


def figure(view: Drawing, *, middle: bool = True, above: float = ROOMY.between) -> Block:
    """Return a view as a block."""
    bare = view._replace(cell=None)
    left, low, right, top = bounds(bare)
    return Block(bare.moved(complex(-left, -top)), right - left, top - low, above, middle)


def below(view: Drawing, rows: Sequence[str], name: str, size: float, most: float) -> Drawing:
    """Return a view with lines of lettering (mark-up) below it, in the middle, no wider than ``most`` mm."""
    left, low, right, _ = bounds(view)
    wide = max(right - left, min(CAPTION_WIDE, most))
    lines = [row for text in rows for row in even(text, size, wide)]
    labels = [
        one._replace(at=complex((left + right) / 2, one.at.imag), anchor="middle")
        for one in set_rows(lines, complex(left, low - 2.0))
    ]
    return view._replace(name=name, labels=(*view.labels, *labels))


def even(text: str, size: float, wide: float) -> list[LetteringRow]:
    """Return mark-up in lines no wider than ``wide`` mm, the last of them no rag of a word if it can be."""
    rows = list(broken(text, size, wide))
    for share in NARROWER:
        if len(rows) < 2 or not rag(rows[-1]):
            break
        tried = list(broken(text, size, share * wide))
        rows = tried if len(tried) == len(rows) else rows
    return rows


def rag(row: LetteringRow) -> bool:
    """Tell whether a line is too short to stand alone below others."""
    return letter(row.text, size=row.size).right < RAG * row.size


def band(*blocks: Block, wide: float) -> Band:
    """Return blocks side by side, those in the middle with what is white shared between them."""
    lefts = _lefts(blocks, wide)
    parts = tuple((one.drawing, complex(at)) for one, at in zip(blocks, lefts, strict=True))
    high, above = max(one.height for one in blocks), max(one.above for one in blocks)
    return Band(parts, high, above, blocks[0].heads or (blocks[0].middle and not blocks[0].follows))


def columned(columns: Sequence[tuple[Sequence[Block], float]]) -> Band:
    """Return blocks one below the other in columns so wide, mm; those in the middle in that of theirs."""
    parts, highs, left = list[tuple[Drawing, complex]](), list[float](), 0.0
    for some, wide in columns:
        down = 0.0
        for n, one in enumerate(some):
            down += one.above if n else 0.0
            aside = max((wide - one.width) / 2, 0.0) if one.middle else 0.0
            parts.append((one.drawing, complex(left + aside, -down)))
            down += one.height
        highs.append(down)
        left += wide + BESIDE
    return Band(tuple(parts), max(highs), max(some[0].above for some, _ in columns), True)


def laid(head: Sequence[str], bands: Sequence[Band], scene: Scene, between: float) -> Paged:
    """Return bands as they stand on sheets, the head on the first."""
    begins, others = paper(scene.language, opens=True), paper(scene.language)
    first = begins.top - begins.bottom - _taken(_head(head, scene))
    return paged(bands, first, others.top - others.bottom - HEAD, between)


def _head(head: Sequence[str], scene: Scene) -> list[LetteringRow]:
    """Return the lines of the head (mark-up)."""
    room = paper(scene.language)
    sizes = [TITLE, *[CAPTION] * (len(head) - 2), TITLE]
    wide = room.right - room.head.real
    return [row for k, one in enumerate(head) for row in broken(one, sizes[k], wide)]


def _taken(told: Sequence[LetteringRow]) -> float:
    return max(sum(map(advance, told)), HEAD)


def pages(
    head: Sequence[str], bands: Sequence[Band], scene: Scene, between: float
) -> list[list[Drawing]]:
    """Return what stands on the sheets: the head (mark-up) on the first, bands one below the other."""
    room, told = paper(scene.language, opens=True), _head(head, scene)
    found = [[Drawing("task head", scene.title, (), tuple(set_rows(told, room.head)))]]
    for k, some in enumerate(laid(head, bands, scene, between).sheets):
        if k:
            room = paper(scene.language)
            found.append([])
        top = room.top - (HEAD if k else _taken(told))
        clear = [between if k and not n else one.above for n, one in enumerate(some)]
        left = top - room.bottom - sum(clear) - sum(one.height for one in some)
        looser = min(1.0 + max(left, 0.0) / sum(clear), LOOSER)
        for one, above in zip(some, clear, strict=True):
            top -= looser * above
            found[-1] += [part.moved(complex(room.left, top) + at) for part, at in one.parts]
            top -= one.height
    return found


def _lefts(row: Sequence[Block], wide: float) -> Iterator[float]:
    """Yield where the blocks of a row begin, mm from the left edge: those in the middle share what is white."""
    if not any(one.middle for one in row):
        yield from (0.0 for _ in row)
        return
    gap = max((wide - sum(one.width for one in row)) / (len(row) + 1), 0.0)
    at = gap
    for one in row:
        yield at
        at += one.width + gap


def sheets(
    called: str,
    head: Sequence[str],
    bands: Sequence[Band],
    scene: Scene,
    stem: str,
    setting: Setting,
) -> list[Sheet]:
    """Return the sheets of a task, ``called`` so in their title block."""
    made = [(called, drawings) for drawings in pages(head, bands, scene, setting.between)]
    fields, _ = {**scene.title_block}, speaking(scene.language)
    if designation := fields.get("designation"):
        fields["designation"] = _("{designation}", context="task", designation=designation)
    check, language = scene.print_check, scene.language
    return framed(made, fields, scene.title, language, check=check, stem=stem, opens=True)

"""The sheets of a task: bands one below the other on A4, as many sheets as they need, in their frames."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import NamedTuple

from graphic_tmm.classroom.tasks.breaks import Band, Paged, paged
from graphic_tmm.classroom.tasks.setting import ROOMY, Setting
from graphic_tmm.handout.sheets import CAPTION, TITLE, advance, framed, paper, set_rows
from graphic_tmm.handout.words import Row, broken
from graphic_tmm.paper.drawing import Drawing, Sheet
from graphic_tmm.paper.lettering.letters import letter
from graphic_tmm.paper.packing import bounds
from graphic_tmm.scene.records import Scene

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


def even(text: str, size: float, wide: float) -> list[Row]:
    """Return mark-up in lines no wider than ``wide`` mm, the last of them no rag of a word if it can be."""
    rows = list(broken(text, size, wide))
    for share in NARROWER:
        if len(rows) < 2 or not rag(rows[-1]):
            break
        tried = list(broken(text, size, share * wide))
        rows = tried if len(tried) == len(rows) else rows
    return rows


def rag(row: Row) -> bool:
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
    room = paper(scene.language)
    whole = room.top - room.bottom
    return paged(bands, whole - _taken(_head(head, scene)), whole - HEAD, between)


def _head(head: Sequence[str], scene: Scene) -> list[Row]:
    """Return the lines of the head (mark-up)."""
    room = paper(scene.language)
    sizes = [TITLE, *[CAPTION] * (len(head) - 2), TITLE]
    wide = room.right - room.head.real
    return [row for k, one in enumerate(head) for row in broken(one, sizes[k], wide)]


def _taken(told: Sequence[Row]) -> float:
    return max(sum(map(advance, told)), HEAD)


def pages(
    head: Sequence[str], bands: Sequence[Band], scene: Scene, between: float
) -> list[list[Drawing]]:
    """Return what stands on the sheets: the head (mark-up) on the first, bands one below the other."""
    room, told = paper(scene.language), _head(head, scene)
    found = [[Drawing("task head", scene.title, (), tuple(set_rows(told, room.head)))]]
    for k, some in enumerate(laid(head, bands, scene, between).sheets):
        top = room.top - (HEAD if k else _taken(told))
        if k:
            found.append([])
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
    fields = {**scene.title_block}
    return framed(made, fields, scene.title, scene.language, check=scene.print_check, stem=stem)

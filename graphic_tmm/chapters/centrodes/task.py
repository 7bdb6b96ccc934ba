"""What is asked of centrodes: of which links, in the axes of which, in which position they touch."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import TYPE_CHECKING

from graphic_tmm.language.said import said
from graphic_tmm.scene import letters
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Kind, Names, Said, Section, key
from graphic_tmm.scene.misfits import stands
from graphic_tmm.scene.tasks import SectionKey

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts

CENTRODES = "centrodes"


def _links(value: object, names: Names) -> tuple[int, ...]:
    listed = value if isinstance(value, list) else [value]
    whole = all(isinstance(n, int) and not isinstance(n, bool) and n >= 0 for n in listed)
    if not listed or not whole or len(set(listed)) < len(listed):
        raise ValueError(stands(value, said("write the number of a link, 2, or a list, [2, 4]")))
    return tuple(listed)


LINKS = Kind(
    _links,
    {"anyOf": [{"type": "integer"}, {"type": "array", "items": {"type": "integer"}}]},
    renamed=letters.renamed,
)


@dataclass(frozen=True)
class CentrodesTask:
    """The centrodes of each of ``links`` against a link (``against``; None: the frame).

    ``at``: the position in which the moving centrode is drawn, None: the first; ``mu_l``: m/mm, None: chosen.
    """

    links: tuple[int, ...] = key(
        LINKS, "the link that rolls, or a list of links", 2, written="link"
    )
    against: int | None = key(
        v.LINK_NUMBER, "the link in whose axes it rolls; left out: the frame", 3, None
    )
    at: str | None = key(
        v.POSITION, "the position in which both centrodes touch; left out: the first", 1, None
    )
    mu_l: float | None = key(
        v.MU_L, 'the scale of lengths of the centrodes: m/mm, or "1:2"', "1:2", None, fixes="size"
    )


ASKED: SectionKey[CentrodesTask] = SectionKey(CENTRODES)


def _check(asked: Said, parts: Parts) -> Iterator[Flaw]:
    """Every number that is no moving link, and a link that would roll on itself."""
    known = [link.number for link in parts.links if link is not None]
    for number in asked.link if isinstance(asked.link, tuple) else ():
        if number not in known:
            yield Flaw((CENTRODES, "link"), _unknown(number, known))
        elif number == asked.against:
            says = said("link {number} does not move against itself: name another", number=number)
            yield Flaw((CENTRODES, "against"), says)
    frame = [parts.frame.number] if parts.frame is not None else []
    if isinstance(asked.against, int) and asked.against not in (*known, *frame):
        yield Flaw((CENTRODES, "against"), _unknown(asked.against, known))


def _unknown(number: int, known: list[int]) -> str:
    return said(
        "there is no moving link {number}; there are {known}",
        number=number,
        known=", ".join(map(str, sorted(known))),
    )


SECTIONS = (
    Section(
        CENTRODES, CentrodesTask, "the fixed and the moving centrode of a link",
        begin="link = 2", check=_check,
    ),
)  # fmt: skip

"""What is driven: the pair of a drive, and whether its link stands by it or is a leg of changing length."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.groups import Pair
from graphic_tmm.mechanism.guides import level
from graphic_tmm.mechanism.records import Drive, Link, Mechanism, Slide


class Driven(NamedTuple):
    """A drive with its pair; ``pin``: the letter of its link whose place and vectors it gives.

    ``telescopes``: it drives between two links that move, a rod out of its cylinder: both are one leg of a
    group, whose length it gives. Else its link stands where the drive puts it.
    """

    drive: Drive
    pair: Pair
    pin: str
    telescopes: bool = False

    @property
    def link(self) -> int:
        """The link that is driven."""
        return self.drive.link

    @property
    def name(self) -> str:
        """Its link or links as they stand in the formula of structure: "1", "2-3"."""
        return (
            "-".join(str(k) for k in sorted(self.pair.links)) if self.telescopes else str(self.link)
        )


def driven_pairs(mechanism: Mechanism) -> tuple[Driven, ...]:
    """Return what the drives of a mechanism drive, in the order of the scene.

    Raises
    ------
    StructureError
        If a drive names no link that moves, or no pair that it could drive.
    """
    drives = mechanism.drives
    for k, drive in enumerate(drives):
        if drive.link in [one.link for one in drives[:k]]:
            raise StructureError(
                said("link {link} is driven twice: leave one drive out", link=drive.link),
                "drive.link",
            )
    return tuple(
        _sliding(mechanism, one) if one.slides else _turning(mechanism, one) for one in drives
    )


def _link(mechanism: Mechanism, drive: Drive) -> Link:
    link = mechanism.by_number.get(drive.link)
    if link is None or link is mechanism.frame:
        raise StructureError(
            said("the drive names link {link}, which is not a moving link", link=drive.link),
            "drive.link",
        )
    return link


def _turning(mechanism: Mechanism, drive: Drive) -> Driven:
    crank = _link(mechanism, drive)
    shared = [letter for letter in crank.points if letter in mechanism.frame.points]
    if len(shared) != 1 or crank.slides:
        raise StructureError(
            said(
                "the driving link {number} must turn about one letter that it shares with the "
                "frame (it shares {listed})",
                number=crank.number,
                listed=", ".join(shared) or said("none"),
            ),
            f"link {crank.number}",
            "drive.link",
        )
    letters = [letter for letter in crank.points if letter != shared[0]]
    joined = _joined(mechanism, crank, letters)
    if not (joined or letters):
        raise StructureError(
            said(
                "the driving link {number} has no second letter: give it the crank pin, e.g. A",
                number=crank.number,
            ),
            f"link {crank.number}, points",
        )
    pair = Pair("R", shared[0], (crank.number, mechanism.frame.number))
    return Driven(drive, pair, (joined or letters)[0])


def _sliding(mechanism: Mechanism, drive: Drive) -> Driven:
    link = _link(mechanism, drive)
    if len(link.slides) != 1:
        raise StructureError(
            said(
                "a speed in m/s drives what slides, but link {number} has {count} slides: give it one, on "
                "the frame or on its cylinder, or write an angular speed",
                number=link.number,
                count=len(link.slides) or said("no"),
            ),
            f"link {link.number}, slides",
            "drive.speed",
        )
    slide, pair = link.slides[0], sliding_pair(link)
    on = mechanism.by_number[slide.on]
    letters = [letter for letter in link.points if letter not in on.points]
    joined = _joined(mechanism, link, letters)
    if not letters or len(letters) < len(link.points):
        raise StructureError(
            said(
                "link {number} is driven along {guide}: give it a point of its own there, e.g. B",
                number=link.number,
                guide=slide.guide.name,
            ),
            f"link {link.number}, points",
        )
    telescopes = on is not mechanism.frame
    if telescopes:
        _refuse_oblique(link, on, slide, joined, _joined(mechanism, on, list(on.points)))
    return Driven(drive, pair, (joined or letters)[0], telescopes)


def sliding_pair(link: Link) -> Pair:
    """Return the sliding pair of a link that has one."""
    (slide,) = link.slides
    return Pair("P", slide.guide.name, (link.number, slide.on), slide)


def _joined(mechanism: Mechanism, link: Link, letters: list[str]) -> list[str]:
    """Return those of a link's letters that stand on other bodies too."""
    bodies = [one for one in mechanism.by_number.values() if one is not link]
    return [letter for letter in letters if any(letter in one.points for one in bodies)]


def _refuse_oblique(
    rod: Link, cylinder: Link, slide: Slide, pins: list[str], pivots: list[str]
) -> None:
    """Refuse a driven rod that is not pinned at its end, or whose guide does not go through both pins."""
    keys = (f"link {rod.number}", f"link {cylinder.number}")
    if len(pins) != 1 or len(pivots) != 1:
        raise StructureError(
            said(
                "link {rod} is driven out of link {cylinder}: rod and cylinder have each one pin by which "
                "they are joined to other links (the rod {pins}, the cylinder {pivots})",
                rod=rod.number,
                cylinder=cylinder.number,
                pins=", ".join(pins) or said("none"),
                pivots=", ".join(pivots) or said("none"),
            ),
            *keys,
        )
    pair = sliding_pair(rod)
    pin, pivot = rod.points[pins[0]], cylinder.points[pivots[0]]
    away = level(pair, rod.number, pin) - level(pair, cylinder.number, pivot)
    if abs(away) > 1e-9 * max(abs(pin), abs(pivot), abs(slide.guide.through), 1e-3):
        raise StructureError(
            said(
                "link {rod} is driven out of link {cylinder}: their guide {guide} goes through both pins, "
                "{pivot} and {pin}; they lie {off:.4g} mm off each other across it",
                rod=rod.number,
                cylinder=cylinder.number,
                guide=slide.guide.name,
                pivot=pivots[0],
                pin=pins[0],
                off=1000.0 * abs(away),
            ),
            *keys,
        )

"""Mechanisms by the letters of their links alone: what structure is asked of; lengths are of no account."""

from __future__ import annotations

from graphic_tmm.mechanism.records import Drive, Guide, Link, Mechanism, Slide

X = Guide("x", 0j, 0.0)
Y = Guide("y", 0j, 90.0)
Z = Guide("z", 0j, 45.0)


def mechanism(*links: Link, frame: Link | None = None, drive: int = 1) -> Mechanism:
    return Mechanism(frame or Link(0, {"O": 0j, "C": 4 + 0j}), links, Drive(drive, 1.0))


def link(number: int, letters: str, *slides: Slide, guides: tuple[Guide, ...] = ()) -> Link:
    return Link(number, {c: complex(k, 0) for k, c in enumerate(letters)}, guides, slides)


FOUR_BAR = (link(1, "OA"), link(2, "AB"), link(3, "BC"))

"""To which link a pin is counted where more than two links meet in it: whose reactions are meant there.

The link that comes first in the order of attachment bears the pin; each other link has its reaction with that
one, R_{first other}, and none with another. A load at the pin acts on the link that it is given on.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from graphic_tmm.chapters.forces.friction import joints
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import joined, said
from graphic_tmm.language.symbols import symbol

SHORT = said("pin {letter} is counted to link {link}")
"""What stands below a figure."""
WHOLE = said(
    "Links {links} meet in pin {letter}, which is counted to link {link}: {reactions}, the forces of link "
    "{link} with the pin on each of the others; a load at {letter} acts on the link that it is given on."
)
"""What stands below the table, in the protocol and in the note."""


class SharedPin(NamedTuple):
    """A pin of more than two links: its letter, the link that bears it, the others as they are attached."""

    letter: str
    bearer: int
    others: tuple[int, ...]


def shared_pins(drawn: Drawn) -> Iterator[SharedPin]:
    """Yield the pins in which more than two links meet, in the order of attachment."""
    plans = KINEMATICS_PLAN.on(drawn)
    structure, frame = plans.structure, plans.mechanism.frame.number
    on: dict[tuple[str, int], list[int]] = {}
    for joint in joints(plans.positions.closings, (structure.driver, frame, structure.pivot)):
        if joint.pair.kind == "R":
            link, bearer = joint.links
            on.setdefault((joint.pair.name, bearer), []).append(link)
    for (letter, bearer), others in on.items():
        if len(others) > 1:
            yield SharedPin(letter, bearer, tuple(others))


def below(drawn: Drawn, links: tuple[int, ...], language: str) -> list[str]:
    """Return the lines that stand below the figure of some links."""
    _ = speaking(language)
    return [
        _(SHORT, letter=symbol(pin.letter, language), link=pin.bearer)
        for pin in shared_pins(drawn)
        if {pin.bearer, *pin.others} & set(links)
    ]


def told(drawn: Drawn, language: str) -> list[str]:
    """Return a sentence on each shared pin (mark-up)."""
    _ = speaking(language)
    return [
        _(
            WHOLE,
            links=joined(", ", map(str, (pin.bearer, *pin.others))),
            letter=symbol(pin.letter, language),
            link=pin.bearer,
            reactions=", ".join(
                symbol(f"R_{{{pin.bearer}{other}}}", language) for other in pin.others
            ),
        )
        for pin in shared_pins(drawn)
    ]

"""Image points: the plan of velocities or accelerations keeps a figure similar to each link.

A link's images hang on an anchor (a point whose image is known) and turn with a base (two points of a link
with the same angular velocity, and their images). A link that does not turn has no base: all its images are
one point.
"""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.instruments import coincide, homologous, similar
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.kinematics.bodies import Body


class Base(NamedTuple):
    """Two points of a link on the plan of positions, and their images."""

    A: Mark
    B: Mark
    a: Mark
    b: Mark


class Hanging(NamedTuple):
    """How a link hangs in the plan: its anchor, the anchor's image, and the base it turns with."""

    anchor: Mark
    image: Mark
    base: Base | None


class Images:
    """The images of one plan while it is being drawn, by link."""

    def __init__(self, draft: Draft, pole: Mark, frame: Body) -> None:
        self.draft = draft
        self.pole = pole
        self.by_letter: dict[int, dict[str, Mark]] = {}
        self.hanging: dict[int, Hanging] = {}
        number = frame.link.number
        self.hanging[number] = Hanging(pole, pole, None)
        self.by_letter[number] = dict.fromkeys(frame.marks, pole)

    def hang(self, body: Body, hanging: Hanging, known: dict[str, Mark]) -> None:
        """Enter a link, with the images of letters known already."""
        self.hanging[body.link.number] = hanging
        self.by_letter[body.link.number] = known

    def turns(self, number: int) -> bool:
        """Whether a link turns (otherwise its images coincide)."""
        return self.hanging[number].base is not None

    def at(self, body: Body, point: Mark) -> Mark:
        """Return the image of a point of a body that is drawn already."""
        return self.by_letter[body.link.number][body.letter_of(point)]

    def of(self, number: int, point: Mark, letter: str, shown: str) -> Mark:
        """Return the image of a point as a point of the link; draw it if it is not there yet.

        ``letter``: that of the point in the scene; ``shown``: that of the image.
        """
        known = self.by_letter[number]
        if letter in known:
            return known[letter]
        anchor, image, base = self.hanging[number]
        if point == anchor or (base is None and image == self.pole):
            drawn = image
        elif base is None:
            drawn = self.draft.draw(coincide, shown, image, free=True)
        elif anchor == base.A and image == base.a:
            drawn = self.draft.draw(
                similar, shown, base.a, base.b, base.A, base.B, point, free=True
            )
        else:
            drawn = self.draft.draw(
                homologous,
                shown,
                image,
                base.a,
                base.b,
                base.A,
                base.B,
                anchor,
                point,
                free=True,
            )
        known[letter] = drawn
        return drawn

    def complete(self, body: Body) -> None:
        """Draw the images of all letters of the link."""
        for letter in body.link.points:
            self.of(body.link.number, body.marks[letter], letter, image_letter(letter))


def image_letter(letter: str, link: int | None = None) -> str:
    """Return the small letter of an image; with the link's number for one of several points at a place."""
    return letter.lower() if link is None else f"{letter.lower()}{link}"

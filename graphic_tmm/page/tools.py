"""Which instrument a step is done with, in words, and where it lies on the sheet.

The instruments of an operation are those of its geometrography. Where one lies is read off the marks of its
step: the compass with its opening, the square along its line and where it was slid from, the ruler along what
is laid off or read, the protractor on its vertex. What is done with several is told in words only.
"""

from __future__ import annotations

import cmath
import re
from collections.abc import Mapping
from typing import Any, NamedTuple

from graphic_tmm.accuracy.geometrography import symbol
from graphic_tmm.board.grammar import JOIN, SLIDE
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.values import Angle, Arc, Line, Point
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import fixed
from graphic_tmm.language.said import Said, said
from graphic_tmm.language.units import unit
from graphic_tmm.paper.rules import LEAST
from graphic_tmm.paper.seen import Seen, finite
from graphic_tmm.readers.sentences import phrase
from graphic_tmm.scene.captions import captions, view_name

NAMES: Mapping[str, Said] = {
    "C": said("compass"),
    "P": said("protractor"),
    "E": said("square and ruler"),
    "K": said("French curve"),
    "H": said("pencil, by hand"),
    "A": said("planimeter"),
    "M": said("ruler with its divisions"),
    "R": said("edge of the ruler"),
    "N": said("calculator"),
}
"""Instruments by the letters of geometrography, the one that matters most first."""
FAR = 50.0
"""A direction is told by a place so far away, mm: it is rounded as places are."""
_LOOK = said("Instrument: the row of standard values.")
_MARK = said("Instrument: pencil; the point is where drawn lines meet.")
_NAMED = said("Instrument: {names}.")
_COMPASS = said("Compass: needle in {centre}, opening {radius}.")
_PARALLEL = said("Square: lay an edge along {to}, slide it to {through}.")
_SQUARE = said("Square: lay one edge along {to}, slide it until the other goes through {through}.")
_EDGE = said("Ruler: lay its edge to {start} and {end}.")
_LAY = said("Ruler: zero at the beginning of {on}, prick off {length}.")
_READ = said("Ruler: zero on {start}, read at {end}.")
_PROTRACTOR = said("Protractor: centre on {at}, angle {angle}.")

Laid = tuple[Said, dict[str, str], str, list[complex]]
"""What an instrument is told by: a sentence, what stands in it, its kind, where it lies."""


class Desk(NamedTuple):
    """Where instruments are laid: the plan as it is seen, its origin on the sheet, the height of that, mm."""

    seen: Seen
    origin: complex
    height: float
    language: str

    def hint(self, step: Step, place: int) -> list[Any]:
        """Return the hint of a step: kind, words, and numbers (sheet mm, y downward) that its outline needs."""
        speech = speaking(self.language)
        found = self.laid(step, place)
        if found is None or not finite(*found[3]):
            return ["", tools_sentence(step, self.language)]
        told, words, kind, spots = found
        return [kind, speech(told, **words), *(x for z in spots for x in self.on_sheet(z))]

    def on_sheet(self, z: complex) -> tuple[float, float]:
        """Return a place of the view on the sheet."""
        at = z + self.origin
        return round(at.real, 2) + 0.0, round(self.height - at.imag, 2) + 0.0

    def laid(self, step: Step, place: int) -> Laid | None:
        """Return how an instrument lies; None where that is told in words only."""
        words = dict(phrase(step, self.language, self.seen.reading, place)[1])
        if step.it.kind is Arc:
            return self.compass(step, place, words)
        if step.it.kind is Line:
            return self.line(step, place, words)
        if step.op.name == "lay_off":
            at, _ = self.seen.line(step.uses[0], place)
            return _LAY, words, "ruler", [at, self.seen.point(step.it, place)]
        if step.op.reads and [mark.kind for mark in step.uses[:2]] == [Point, Point]:
            start, end = (self.seen.point(mark, place) for mark in step.uses[:2])
            named = {"start": words[step.op.arguments[0]], "end": words[step.op.arguments[1]]}
            return (_READ, named, "ruler", [start, end]) if abs(end - start) > LEAST else None
        if step.it.kind is Angle and step.op.name == "bearing":
            start, end = (self.seen.point(mark, place) for mark in step.uses)
            angle = self.seen.number(step.it, place)
            return self.protractor(words["start"], start, start + FAR, angle)
        return None

    def compass(self, step: Step, place: int, words: dict[str, str]) -> Laid | None:
        """The compass, its pencil where the arc was cut."""
        centre, radius = self.seen.arc(step.it, place)
        found = (use.it for use in self.seen.uses.get(step.it, ()) if use.it.kind is Point)
        spots = (self.seen.point(mark, place) for mark in found)
        tip = next((z for z in spots if abs(abs(z - centre) - radius) < LEAST), centre + radius)
        if "centre" not in words or not radius > LEAST:
            return None
        told = {"centre": words["centre"], "radius": self.length(radius)}
        return _COMPASS, told, "compass", [centre, tip]

    def line(self, step: Step, place: int, words: dict[str, str]) -> Laid | None:
        """The instrument that a line is drawn with."""
        at, along = self.seen.line(step.it, place)
        name, uses = step.op.name, dict(zip(step.op.arguments, step.uses, strict=True))
        if not finite(at, along) or along == 0:
            return None
        if step.op.symbol == JOIN:
            ends = step.op.arguments[:2]
            start, end = (self.seen.point(uses[key], place) for key in ends)
            return _EDGE, {"start": words[ends[0]], "end": words[ends[1]]}, "edge", [start, end]
        if step.op.symbol == SLIDE and "to" in uses:
            told = _SQUARE if name == "square" else _PARALLEL
            along = self.towards(step, place, at, along)
            spots = [at, at + FAR * along, at + FAR * 1j * along if name == "square" else at]
            if uses["to"].view == step.it.view:
                spots.append(self.seen.line(uses["to"], place)[0])
            else:
                words["to"] = self.elsewhere(words["to"], uses["to"])
            return told, words, "square", spots
        if name in ("ray", "incline"):
            base = 1 + 0j if name == "ray" else self.seen.line(uses["to"], place)[1]
            angle = cmath.phase(along / base) * 180 / cmath.pi
            told_at = words["start" if name == "ray" else "through"]
            return self.protractor(told_at, at, at + FAR * base, angle)
        return None

    def elsewhere(self, name: str, mark: Mark) -> str:
        """Return what a mark of another plan is called, and of which."""
        view = view_name(mark.view, self.language)
        told = captions(self.language)["of view"].format(view=view)
        return name if name.endswith(told) else name + told

    def towards(self, step: Step, place: int, at: complex, along: complex) -> complex:
        """Return the direction of a line to where most of it is drawn."""
        uses = self.seen.uses.get(step.it, ())
        found = [self.seen.point(use.it, place) for use in uses if use.it.kind is Point]
        reach = [((z - at) * along.conjugate()).real for z in found if finite(z)]
        return -along if reach and -min(reach) > max(*reach, 0.0) else along

    def protractor(self, name: str, at: complex, base: complex, angle: float) -> Laid:
        """The protractor on its vertex, its base line along a direction."""
        way = (base - at) * cmath.rect(1.0, angle * cmath.pi / 180)
        told = f"{fixed(angle, 1, self.language)}°"
        return _PROTRACTOR, {"at": name, "angle": told}, "protractor", [at, base, at + way]

    def length(self, mm: float) -> str:
        """Return a length as the ruler tells it."""
        return f"{fixed(mm, 1, self.language)} {unit('mm', self.language)}"


def tools_sentence(step: Step, language: str) -> str:
    """Return the sentence that names the instruments of a step."""
    speech = speaking(language)
    if step.op.looked_up:
        return speech(_LOOK)
    letters = set(re.findall("[A-Z]", symbol(step.op)))
    if not letters:
        return speech(_MARK)
    names = ", ".join(speech(name) for letter, name in NAMES.items() if letter in letters)
    return speech(_NAMED, names=names)

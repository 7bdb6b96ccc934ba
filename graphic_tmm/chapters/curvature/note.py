"""What a note concludes of curvature: radii by both ways, where the circles meet, where Ball's point lies."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from graphic_tmm.chapters.curvature.link_figure import LinkFigure
from graphic_tmm.chapters.curvature.record import Curvature
from graphic_tmm.chapters.curvature.table import by_bobillier, drawn_places, off_name
from graphic_tmm.language.said import said
from graphic_tmm.note.document import Runs
from graphic_tmm.note.page import Page, Put
from graphic_tmm.note.section_chapter import Noted

_RADIUS = said(
    "In position {position} the radius of curvature of the path of {point} is {plans} by the plans and {drawn} "
    "by Bobillier's construction; in no position are both farther apart than {off}."
)
_CIRCLES = said(
    "In position {position} the pole of accelerations is {away} from the middle of the inflection circle, and "
    "its radius is {radius}: where the circles of Bresse meet both are equal."
)
_BALL = said(
    "In position {position} Ball's point lies at x = {x}, y = {y} from {origin}: there the path of a point of "
    "the link is straight to a higher order."
)


class CurvaturePage(Page[Curvature]):
    """What the log tells of curvature; then what both constructions come to."""

    def concludes(self) -> Iterator[Runs]:
        """Yield the radii of the points by both ways, the check of the circles, Ball's point."""
        made = self.recorded
        for path in made.paths:
            names = {"plans": f"rho{path.point}", "drawn": by_bobillier(path)}
            if off_name(path) in self.results:
                known: dict[str, Put] = {
                    "point": self.letter(path.at),
                    "off": self.result(off_name(path)),
                }
                yield from self._where(_RADIUS, made.figure, names, known)
        if made.bresse is not None:
            names = {"away": "WΠ", "radius": "WP"}
            yield from self._where(_CIRCLES, made.bresse.figure, names, {})
        if made.ball is not None:
            names, origin = {"x": "xU", "y": "yU"}, self.letter(made.ball.origin)
            yield from self._where(_BALL, made.ball, names, {"origin": origin})

    def _where(
        self, words: str, figure: LinkFigure, names: dict[str, str], known: Mapping[str, Put]
    ) -> Iterator[Runs]:
        """Yield a sentence of columns (by segments) in the position that is worked, or the first drawn."""
        there = drawn_places(self.drawn, figure.mu)
        if not there or any(one not in self.columns for one in names.values()):
            return
        k = self.at if self.at in there else there[0]
        rows = {name: self.columns[one].first_figures[1][k] for name, one in names.items()}
        if None not in rows.values():
            put = {name: self.quantity(one, k) for name, one in names.items()}
            yield self.sentence(words, {**known, **put, "position": self.drawn.names[k]})


NOTE = Noted(CurvaturePage)

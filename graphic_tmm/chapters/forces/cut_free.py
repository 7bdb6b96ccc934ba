"""The figures in which links are cut free: a group in one of its own, what drives and each wheel in its own."""

from __future__ import annotations

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.forces.detached import Detached
from graphic_tmm.chapters.forces.loads import Ground
from graphic_tmm.chapters.kinematics.closings import AnyClosing, groups_of


class Figures:
    """The figures in which links are detached, each begun with all its points when it is first wanted."""

    def __init__(self, ground: Ground) -> None:
        self.draft, self.bodies = ground.draft, ground.positions.bodies
        alone = (pair.link for pair in ground.pairs if not pair.driven.telescopes)
        self.links: dict[int, tuple[int, ...]] = {link: (link,) for link in alone}
        self.closing: dict[int, AnyClosing] = {}
        self.known: dict[tuple[int, ...], Detached] = {}
        self.pitches: dict[int, list[Mark]] = {}
        for wheel in ground.positions.wheels:
            self.links[wheel.leg.link] = (wheel.leg.link,)
            for link, end in ((wheel.leg.link, wheel.pitch), (wheel.rolling.on, wheel.far)):
                self.pitches.setdefault(link, []).append(end)
        self.notes = {one.leg.link: one.rolling.note for one in ground.positions.wheels}
        for closing in groups_of(ground.positions.closings, "forces"):
            for link in (*closing.group.links, *closing.group.rods):
                self.links[link], self.closing[link] = closing.group.links, closing

    def of(self, link: int) -> Detached:
        """Return the figure that shows a link."""
        links = self.links[link]
        if links not in self.known:
            members = [number for number, own in self.links.items() if own == links]
            points = [mark for number in members for mark in self.bodies[number].marks.values()]
            closing, note = self.closing.get(link), self.notes.get(link, f"I({link})")
            if closing is not None:
                points.append(closing.point)
                note = closing.group.formula
            points += [pitch for number in members for pitch in self.pitches.get(number, [])]
            self.known[links] = Detached(self.draft, links, note, points)
        return self.known[links]

"""The section of a flywheel in a note: reduced moment, works, energies, J both ways, the rim as made."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from graphic_tmm.chapters.flywheel import note_words as words
from graphic_tmm.chapters.flywheel.beside import BESIDE, Beside
from graphic_tmm.chapters.flywheel.conclusions import concludes
from graphic_tmm.chapters.flywheel.names import ENERGY_MASS, FLYWHEEL, VIEWS
from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN, Flywheel
from graphic_tmm.chapters.flywheel.table import flywheel_columns
from graphic_tmm.chapters.flywheel.views import flywheel_views
from graphic_tmm.chapters.indicator.note import Worked, gas
from graphic_tmm.chapters.kinematics.names import VELOCITIES
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.table import kinematic_columns
from graphic_tmm.drawn import Drawn
from graphic_tmm.note.bricks import columns, heading, referred, results
from graphic_tmm.note.chapter import Noted
from graphic_tmm.note.document import Block, Picture, Symbol, Text
from graphic_tmm.note.figures import in_hand, is_figure, picture
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.readers.columns import Column
from graphic_tmm.scene.chapter import chapters


def note(drawn: Drawn, language: str) -> Iterator[Block]:
    """Yield the section of a flywheel."""
    made = FLYWHEEL_PLAN.of(drawn)
    if made is not None:
        views = flywheel_views(in_hand(drawn), True)
        page = FlywheelPage(drawn, language, made, BESIDE.on(drawn), views)
        yield from page.blocks(list(flywheel_columns(drawn)), FLYWHEEL)


class FlywheelPage(Worked):
    """A flywheel as drawn, what was calculated beside it, its figures by name."""

    def __init__(
        self,
        drawn: Drawn,
        language: str,
        made: Flywheel,
        beside: Beside,
        views: Sequence[Drawing],
    ) -> None:
        super().__init__(drawn, language)
        self.made, self.beside = made, beside
        self.shown = {one.name: picture(one, language) for one in views if is_figure(one)}

    def blocks(self, found: Sequence[Column], chapter: str) -> Iterator[Block]:
        """Yield what is told; ``found``: the columns of the table of a ``chapter``."""
        yield self._aim(chapter)
        yield from self._reduced()
        yield from self._moment(found, chapter)
        yield from self._works()
        yield from self._energies()
        if self.made.energy_mass is not None:
            yield from self.view(ENERGY_MASS, self.figures(ENERGY_MASS))
        yield from self._compared()
        yield from self._rim()
        yield from columns(self.drawn, found, self.language)
        own = next(one for one in chapters() if one.name == chapter)
        yield from results(self.drawn, own, self.language)

    def _aim(self, chapter: str) -> Block:
        given = self.made.delta if self.made.order.J is None else self.made.inertia
        return self.says(
            words.AIM if self.made.order.J is None else words.AIM_J,
            delta=self.number(given),
            J=self.number(given),
        )

    def _reduced(self) -> Iterator[Block]:
        """What is reduced to the crank, and by what readings."""
        if self.made.energies is None:
            return
        if self.made.indicator is None:
            yield self.says(words.BY_LOADS)
            return
        velocities = KINEMATICS_PLAN.on(self.drawn).velocities
        assert velocities is not None
        ratio = f"v_{{{self.made.indicator.order.point}}}/v_{{{KINEMATICS_PLAN.on(self.drawn).structure.pin}}}"
        yield self.says(words.BY_GAS, mu=Symbol(velocities.mu.name), ratio=Symbol(ratio))
        yield from gas(self, FLYWHEEL)
        yield from self._readings()

    def _readings(self) -> Iterator[Block]:
        """The table of what is read: segments of the plans of velocities, pressures."""
        speeds = [one for one in kinematic_columns(self.drawn) if one.plan == VELOCITIES]
        gas_ = [one for one in flywheel_columns(self.drawn) if one.unit == "Pa"]
        some = [(one, True) for one in speeds if one.drawn and one.segment != "pa"]
        some += [(one, False) for one in gas_]
        places = [k for k in range(self.drawn.project.count) if k not in self.drawn.undrawn]
        yield self.upright("table-flywheel-readings", words.READ, some, places)

    def _moment(self, found: Sequence[Column], chapter: str) -> Iterator[Block]:
        """The graph of the moment over the cycle; where it drives, where it resists."""
        view = VIEWS["moment"]
        shown = self.figures(f"{chapter}-graphs")
        yield from self.view(view, shown)
        if self.beside.force is not None:
            yield from self.calculation(self.beside.force)
        signs = self._signs(next(one for one in found if one.segment == "M"))
        if signs is not None:
            drives, resists = signs
            yield self.says(words.SIGNS, drives=Text(drives), resists=Text(resists))
        turns = KINEMATICS_PLAN.of(self.drawn)
        if turns is not None and turns.turns > 1:
            yield self.says(words.CYCLE, turns=Text(str(turns.turns)))

    def _signs(self, column: Column) -> tuple[str, str] | None:
        """Return the positions where the moment drives and where it resists; None if it only does one."""
        values = column.without(self.drawn.undrawn).told[1]
        driving = 1.0 if self.made.order.constant == "resisting" else -1.0
        there = [
            (name, value) for name, value in zip(self.drawn.names, values, strict=False) if value
        ]
        drives = [name for name, value in there if value * driving > 0]
        resists = [name for name, value in there if value * driving < 0]
        if not drives or not resists:
            return None
        return ", ".join(drives), ", ".join(resists)

    def _works(self) -> Iterator[Block]:
        constant = words.RESISTING if self.made.order.constant == "resisting" else words.DRIVING
        title = self.view(VIEWS["work"])
        yield next(title)
        yield self.says(words.STEADY, constant=Text(self.speech(constant)))
        yield from title

    def _energies(self) -> Iterator[Block]:
        """The energies of links and flywheel; the rim is told where it stands by itself."""
        rim, title = self.made.rim, self.view(VIEWS["energy"])
        yield next(title)
        yield self.says(words.SAME if self.made.energies is not None else words.ALONE)
        if rim is not None:
            self.hide(rim.limit, rim.inner, rim.mean, rim.mass, rim.width)
        yield from title

    def _compared(self) -> Iterator[Block]:
        """The mean moment, its power, the excess work, both moments of inertia beside one another."""
        own = self.beside
        yield heading(self.speech(words.POWER if own.apart is None else words.SECOND))
        yield from self.sentences(own.moment, own.power, own.excess, own.apart)

    def _rim(self) -> Iterator[Block]:
        """The sizes of the rim, its sketch, and what it does as it is made."""
        rim = self.made.rim
        if rim is None:
            return
        yield heading(self.speech(words.RIM))
        for mark in (rim.limit, rim.inner, rim.mean, rim.mass, rim.width):
            yield from self.again(mark)
            if mark == rim.limit:
                speed = self.drawn.construction.step(mark)
                assert speed is not None
                put = {"speed": speed.uses[0], "most": mark, "outer": rim.outer}
                yield self.says(words.LIMIT, {k: self.number(one) for k, one in put.items()})
        shown = self.figures("flywheel")
        if shown:
            yield referred(shown, self.language)
            yield from shown
        if self.beside.rim is not None:
            yield self.says(words.MADE)
            yield from self.sentences(*self.beside.rim)

    def figures(self, *names: str) -> tuple[Picture, ...]:
        """Return those of some figures that are drawn."""
        return tuple(self.shown[name] for name in names if name in self.shown)


NOTE = Noted(section=note, concludes=concludes)

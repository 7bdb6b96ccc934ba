"""The section of an engine in a note, as the book goes: gas, transfer of forces, couples, inertia, works."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.engine import note_words as words
from graphic_tmm.chapters.engine.beside import BESIDE
from graphic_tmm.chapters.engine.conclusions import concludes
from graphic_tmm.chapters.engine.names import (
    CALCULATED,
    ENGINE,
    HARMONICS,
    MASSES,
    TRANSFER,
    TRANSFER_PLACE,
    VIEW,
    WORKS_VIEW,
)
from graphic_tmm.chapters.engine.plan import ENGINE_PLAN, Engine
from graphic_tmm.chapters.engine.table import engine_columns
from graphic_tmm.chapters.engine.views import (
    engine_diagram_views,
    engine_views,
    transfer_views,
)
from graphic_tmm.chapters.indicator.cylinder import INDICATOR_PLAN
from graphic_tmm.chapters.indicator.note import Worked, gas
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.symbols import symbol
from graphic_tmm.note.bricks import asked, columns, heading, referred
from graphic_tmm.note.chapter import Noted
from graphic_tmm.note.document import (
    Block,
    Item,
    Listed,
    Paragraph,
    Picture,
    Run,
    Symbol,
    Text,
)
from graphic_tmm.note.figures import in_hand, picture, readable
from graphic_tmm.readers.columns import Column

LEAST, MOST = 0.25, 0.33
"""What share of a rod's mass is usually counted at the crosshead, by the book."""
QUARTERS = 4
"""The positions between which the book works its example are a quarter of a turn apart."""


def note(drawn: Drawn, language: str) -> Iterator[Block]:
    """Yield the section of an engine."""
    made = ENGINE_PLAN.of(drawn)
    if made is not None:
        yield from _Engine(drawn, made, language).blocks()


class _Engine(Worked):
    """An engine as drawn, the position that is worked in full, the figures of it."""

    def __init__(self, drawn: Drawn, made: Engine, language: str) -> None:
        super().__init__(drawn, language)
        self.made, self.beside = made, BESIDE.on(drawn)
        held = in_hand(drawn)
        views = [*engine_views(held, True), *readable(drawn, transfer_views)]
        self.shown = {view.name: picture(view, language) for view in views}
        self.position = Text(drawn.names[self.at])
        self.inertia = Symbol(symbol("P_{in}", language))
        self.found = {one.segment: one for one in engine_columns(drawn)}

    def blocks(self) -> Iterator[Block]:
        """Yield what is told, in the order of the book."""
        yield self.says(words.GAS)
        if len(INDICATOR_PLAN.on(self.drawn).indicator.sides) > 1:
            yield self.says(words.BOTH_SIDES)
        yield from gas(self, ENGINE)
        yield from self._transfer()
        yield from self._acting()
        yield from self._inertia()
        yield from self._resulting()
        yield from self._turn()

    def _transfer(self) -> Iterator[Block]:
        """What goes on to rod and guide, pin and bearing: formulas (339) to (344)."""
        yield heading(self.speech(words.TRANSFER))
        shown = self.figures(TRANSFER)
        put: dict[str, Run] = {
            "position": self.position,
            "force": self.number(self.made.values["P′"], size=True),
        }
        yield self.says(words.PASSED, **put)
        yield self.says(words.WITH_INERTIA)
        if shown:
            yield referred(shown, self.language)
        for told in (words.AT_B, words.AT_A, words.AT_O):
            yield self.says(told)
        yield from shown
        yield from self.alone(TRANSFER, bare=True)
        yield from self.view(CALCULATED)

    def _acting(self) -> Iterator[Block]:
        """The five forces on cylinder, bearings, crank and guide; what closes in the frame."""
        yield heading(self.speech(words.FIVE))
        values, moment = self.made.values, self.made.values["M"]
        items: tuple[tuple[str, dict[str, Mark]], ...] = (
            (words.ON_COVER, {"force": values["P"]}),
            (words.ON_BEARING, {"force": values["P′"]}),
            (words.TURNED, {"force": values["Q"], "moment": moment}),
            (words.ON_GUIDE, {"force": values["N"]}),
            (words.BACK, {}),
        )
        yield Listed(
            tuple(
                Item(str(k), (self._told(told, marks),)) for k, (told, marks) in enumerate(items, 1)
            )
        )
        arm = self.drawn.construction.step(values["NOB"])
        assert arm is not None
        yield self._told(words.FRAME, {"arm": arm.uses[1]})

    def _told(self, told: str, marks: Mapping[str, Mark]) -> Paragraph:
        return self.says(told, {k: self.number(mark, size=True) for k, mark in marks.items()})

    def _inertia(self) -> Iterator[Block]:
        """Masses, accelerations, inertia forces of both orders: formulas (345) to (351)."""
        yield heading(self.speech(words.INERTIA))
        yield self.says(words.METHOD, P_in=self.inertia)
        lumped, values = self.made.lumped, self.made.values
        if lumped.at_crank is not None:
            yield self.says(words.TWO_MASSES)
            yield from self._share()
            yield from self.calculation(lumped.at_slider, lumped.at_crank, lumped.mass)
            yield from self.calculation(lumped.inertia, lumped.lost)
        if self.beside.parts is not None:
            yield from self.alone(MASSES)
        yield self.says(words.BY_PLAN, position=self.position)
        yield from self.calculation(self.made.acceleration, *self._newtons(values["P_in"]))
        yield self.says(words.BY_SERIES, P_in=self.inertia)
        yield from self.view(HARMONICS, self.figures("rotating"))
        yield from self._quarters()

    def _share(self) -> Iterator[Block]:
        """Whether the share of the rod's mass that goes to and fro is a usual one, where it is given."""
        share = self.made.order.share
        if share is not None:
            told = words.USUAL if LEAST <= share <= MOST else words.UNUSUAL
            yield self.says(told, share=asked(self.drawn, ENGINE, "share", "", self.language))

    def _newtons(self, force: Mark) -> tuple[Mark, ...]:
        """Return a force with what it was converted from, if it was."""
        step = self.drawn.construction.step(force)
        if step is None or self.made.order.unit == "N":
            return (force,)
        return step.uses[0], force

    def _quarters(self) -> Iterator[Block]:
        """The inertia at the dead centres and half way between, as the book works it."""
        count = KINEMATICS_PLAN.on(self.drawn).count
        if count % QUARTERS:
            return
        there = [k * count // QUARTERS for k in range(QUARTERS - 1)]
        wanted = ("a_B", "a_B_series", "P_in", "P_in_series", "P_in1", "P_in2")
        some = [(self.found[name], False) for name in wanted]
        yield self.upright("table-engine-quarters", words.WORKED, some, there)

    def _resulting(self) -> Iterator[Block]:
        """The force with inertia, and the triangles of the worked position: formula (352)."""
        yield heading(self.speech(words.RESULTING))
        yield self.says(words.INSTEAD, P_in=self.inertia)
        yield from self.calculation(self.made.values["P"], self.made.values["P′"])
        shown = self.figures(f"{VIEW}-{self.drawn.names[self.at]}")
        if shown:
            yield referred(shown, self.language)
        base = self.made.turning[0].base
        self.hide(base.mu, base.x)
        yield from self.alone(VIEW)
        yield from shown
        force = self.number(self.made.values["P_in"])
        yield self.says(words.BASE_TAKES, force=force, position=self.position)

    def _turn(self) -> Iterator[Block]:
        """The graphs over a turn, the table of all positions, the works of T and P."""
        yield heading(self.speech(words.OVER_A_TURN))
        yield from self.again(self.made.turning[0].base.mu)
        views = [
            view
            for view in engine_diagram_views(in_hand(self.drawn), True)
            if view.name.startswith("engine-diagrams")
        ]
        charts = [chart.symbol for chart in self.made.charts]
        half = (len(charts) + 1) // 2
        shown = []
        for view, some in zip(views, (charts[:half], charts[half:]), strict=True):
            caption = self.says(words.GRAPHS, letters=Symbol(", ".join(some))).runs
            shown.append(picture(view, self.language)._replace(caption=caption))
        if shown:
            yield referred(shown, self.language)
            yield from shown
        yield from columns(self.drawn, self._columns(), self.language)
        yield from self.view(WORKS_VIEW)

    def _columns(self) -> list[Column]:
        """Return what is tabulated: in the unit of the task; SI stands in the tables of sheets."""
        return [one for name, one in self.found.items() if not name.endswith("_SI")]

    def figures(self, *names: str) -> tuple[Picture, ...]:
        """Return those of some figures that are drawn."""
        return tuple(self.shown[name] for name in names if name in self.shown)


NOTE = Noted(section=note, places=(TRANSFER_PLACE,), concludes=concludes)

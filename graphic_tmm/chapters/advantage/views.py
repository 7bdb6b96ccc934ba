"""What a sheet shows of forces by centres: the scheme with arms, and the balance as a table, by positions."""

from __future__ import annotations

import math
from collections.abc import Iterator

from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import Scale
from graphic_tmm.chapters.advantage.ink import draw_arms
from graphic_tmm.chapters.advantage.plan import ADVANTAGE_PLAN, Advantage, Arm
from graphic_tmm.chapters.advantage.table import figures
from graphic_tmm.chapters.advantage.task import ADVANTAGE
from graphic_tmm.chapters.centres.ink import SchemeInk
from graphic_tmm.chapters.centres.record import CENTRES_PLAN
from graphic_tmm.chapters.centres.task import CENTRES
from graphic_tmm.chapters.forces.loads import Couple, Force
from graphic_tmm.chapters.forces.plan import FORCES_PLAN
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.scales import reaches
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.numbers import fixed
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.paper.ruled import ruled_table
from graphic_tmm.paper.traced import value_at
from graphic_tmm.paper.views import mu_text
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Readings
from graphic_tmm.readers.result_table import results
from graphic_tmm.scene.captions import captions

NONE = "—"


def arm_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the forces with their arms and the balance of each position; none without both plans."""
    made = ADVANTAGE_PLAN.of(drawn)
    if made is None or not made.loads:
        return []
    centres, words = CENTRES_PLAN.on(drawn), captions(drawn.scene.language)
    tool = FORCES_PLAN.on(drawn).tool
    scale = Scale(centres.mu.name, drawn.value(centres.mu), centres.mu.unit)
    times = drawn.value(KINEMATICS_PLAN.on(drawn).mu_l) / scale.value
    found = list[Drawing]()
    for place in (k for k in made.places if k not in drawn.undrawn):
        name = drawn.names[place]
        title = f"{words[ADVANTAGE]}, {words['position']} {escape(name)}"
        on = subject(drawn, title, ADVANTAGE, CENTRES, name=f"{ADVANTAGE}-{name}")
        force = tool.force if tool is not None else None
        scheme = SchemeInk(on, centres, reaches(drawn), place, times)
        view = draw_arms(on, centres, made, force, scheme)
        found.append(with_caption(view, on, lettered, mu_text(scale, on.language)))
        found += balance(drawn, made, place)
    return found


class _Cells:
    """Figures of a position as a table has them."""

    def __init__(self, drawn: Drawn, made: Advantage, place: int) -> None:
        self.drawn, self.made, self.place = drawn, made, place
        self.language = drawn.scene.language

    def value(self, mark: Mark, decimals: int | None = None) -> str:
        """Return the figure of a mark."""
        return self.figure(value_at(self.drawn.reading.figure(mark), self.place).real, decimals)

    def figure(self, value: float, decimals: int | None = None) -> str:
        """Return a figure: four digits, or so many decimals."""
        if value != value:
            return NONE
        if decimals is None:
            whole = len(str(int(abs(value)))) if abs(value) >= 1.0 else 1
            decimals = max(0, 4 - whole)
        return fixed(value, decimals, self.language)

    def letter(self, name: str) -> str:
        """Return a letter as it is written."""
        return markup(symbol(name, self.language))

    def load(
        self, load: Force | Couple, own: Arm | None, ratio: Mark, at: Mark | None
    ) -> list[str]:
        """Return the cells of a load: a force by its size, its arm with the sense in which it turns."""
        size, height = (
            value_at(self.drawn.reading.figure(mark), self.place).real if mark else math.nan
            for mark in (load.value, own and own.height)
        )
        shown = abs(size) if own is not None else size
        sized = f"{self.figure(shown)} {unit(load.value.unit, self.language)}"
        arm_ = self.figure(math.copysign(1.0, size) * height, 1)
        gain = self.made.gains.get(load.value)
        ends = [NONE if mark is None else self.value(mark) for mark in (at, gain)]
        return [self.letter(load.letter), sized, arm_, self.value(ratio), *ends]


def balance(drawn: Drawn, made: Advantage, place: int) -> Iterator[Drawing]:
    """Yield the tables of a position: loads, arms, ratios, what they are at the drive; the balance."""
    words, language = captions(drawn.scene.language), drawn.scene.language
    cells, tool = _Cells(drawn, made, place), FORCES_PLAN.on(drawn).tool
    rows = [cells.load(one.load, one.arm, one.ratio, one.value) for one in made.loads]
    if tool is not None and made.tool is not None:
        rows.append(cells.load(tool.force, made.tool, made.tool.ratio, None))
    per, mm = unit(made.loads[0].value.unit, language), unit("mm", language)
    heads = [words["load"], words["load size"], f"{words['arm h']}, {mm}", words["ratio u"]]
    high, name = heights(drawn.scene, ADVANTAGE, CENTRES), drawn.names[place]
    yield ruled_table(
        f"table-{ADVANTAGE}-{name}", f"{words['loads at drive']}, {words['position']} {escape(name)}",
        [*heads, f"{words['at the drive']}, {per}", words["mechanical advantage"]], rows,
        size=high.number, title_size=high.title, align=["left", *["centre"] * 5],
    )  # fmt: skip
    found = [
        [words[told], cells.value(mark, 2 if mark.unit == "%" else None), unit(mark.unit, language)]
        for told, mark in balanced(drawn, made)
    ]
    if found:
        title = f"{words['centre balance']}, {words['position']} {escape(name)}"
        yield results(f"table-{ADVANTAGE}-balance-{name}", title, found, language, high)


def balanced(drawn: Drawn, made: Advantage) -> Iterator[tuple[str, Mark]]:
    """Yield the captions of what is found, each with its figure."""
    forces = FORCES_PLAN.on(drawn)
    if made.total is None or made.balance is None:
        return
    if made.total != made.loads[0].value:
        yield "sum at the drive", made.total
    if forces.tool is not None:
        yield "unknown by centres", made.balance
        yield "by lever", forces.tool.force.value
    else:
        yield "balancing by centres", made.balance
        yield "by force plans", forces.first.balance
        yield "by lever", forces.first.lever.balance
    told = ("off lever",) if forces.tool is not None else ("off force plans", "off lever")
    yield from zip(told, made.off, strict=True)


SHOWN = Views(draw={ADVANTAGE: arm_views})


def figure_marks(project: Project) -> dict[tuple[str, str], Mark]:
    """Return the marks of what is found, by plan and the name that machines read."""
    made = ADVANTAGE_PLAN.of(project)
    named = () if made is None else figures(made)
    return {(ADVANTAGE, one.segment): one.mark for one in named if not one.arm}


READINGS = Readings(named_marks=figure_marks)

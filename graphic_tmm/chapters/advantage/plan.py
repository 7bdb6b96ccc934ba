"""Loads at what drives, by the centres of their links; what balances them there, mechanical advantage."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

from graphic_tmm.board import roles
from graphic_tmm.board.operations.carried import carry_over
from graphic_tmm.board.operations.energetics import added
from graphic_tmm.board.operations.instruments import measure, parallel
from graphic_tmm.board.operations.statics import apart_percent, arm, balancing, reversed_
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.advantage import formulas as f
from graphic_tmm.chapters.advantage import words as why
from graphic_tmm.chapters.advantage.task import ADVANTAGE
from graphic_tmm.chapters.centres.record import CENTRES_PLAN, Centres
from graphic_tmm.chapters.forces.detached import bare
from graphic_tmm.chapters.forces.loads import Couple, Force
from graphic_tmm.chapters.forces.plan import FORCES_PLAN, Forces
from graphic_tmm.chapters.kinematics.drives.crank import Crank
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded


class Arm(NamedTuple):
    """How a force turns its link: the centre, the point and the line of the force in the scheme, the arm.

    ``ratio``: how fast the link turns by what drives; ``own``: where a force acts that is carried to another
    link's point.
    """

    about: Mark
    point: Mark
    line: Mark
    height: Mark
    ratio: Mark
    own: Mark | None = None


class AtDrive(NamedTuple):
    """A load at what drives, N·m or N; ``arm``: of a force."""

    load: Force | Couple
    value: Mark
    ratio: Mark
    arm: Arm | None


@dataclass
class Advantage:
    """What the centres tell of forces.

    ``places``: the positions (indices) that have both; ``lacks``: the links whose loads no centre carries to
    what drives; ``balance``: what balances it, or the force that is sought (``tool``); ``off``: its differences
    from the force plans and from the lever, %; ``gains``: the mechanical advantage of each external load on a
    driven link, by its size.
    """

    places: tuple[int, ...]
    several: bool = False
    lacks: list[int] = field(default_factory=list)
    loads: list[AtDrive] = field(default_factory=list)
    tool: Arm | None = None
    total: Mark | None = None
    balance: Mark | None = None
    off: tuple[Mark, ...] = ()
    gains: dict[Mark, Mark] = field(default_factory=dict)


ADVANTAGE_PLAN: Recorded[Advantage] = Recorded(ADVANTAGE)


def record(bench: Bench) -> Advantage | None:
    """Carry all loads to what drives by the centres, and balance them there."""
    centres, forces = CENTRES_PLAN.of(bench), FORCES_PLAN.of(bench)
    if centres is None or forces is None:
        return None
    places = tuple(sorted({*centres.places} & {*forces.places}))
    made = Advantage(places, several=len(forces.balanced) > 1)
    if places and not made.several:
        _Balance(bench, centres, forces, made).draw()
        bench.tell(ADVANTAGE, places)
    return made


class _Balance:
    """The balance while it is drawn."""

    def __init__(self, bench: Bench, centres: Centres, forces: Forces, made: Advantage) -> None:
        self.draft, self.plans = bench.draft, KINEMATICS_PLAN.on(bench)
        self.centres, self.forces, self.made = centres, forces, made
        self.pair = self.plans.pairs[0]
        self.turning = isinstance(self.pair, Crank)
        self.unit = "N·m" if self.turning else "N"
        self.rotations = {one.link: one for one in centres.rotations}
        self.ratios: dict[int, Mark | None] = {}
        self.points = dict(centres.points)

    def draw(self) -> None:
        """Carry the loads, then balance them."""
        draft, made = self.draft, self.made
        draft.open(ADVANTAGE)
        draft.lay_out(scale=self.centres.mu)
        forces, couples = self.forces.first.lever.loads
        every: list[Force | Couple] = [*forces, *couples]
        for load in every:
            if load.link != self.centres.frame:
                self._carry(load)
        tool = self.forces.tool
        if tool is not None:
            made.tool = self._arm(tool.force)
        if made.lacks or not made.loads:
            return
        made.total = made.loads[0].value
        for one in made.loads[1:]:
            uses = made.total, one.value
            made.total = draft.draw(
                added, self._named("Σ"), *uses, unit=self.unit, role=roles.SUM, why=why.SUM
            )
        made.balance = self._balanced(made.total)
        first = self.forces.first
        due = (tool.force.value,) if tool is not None else (first.balance, first.lever.balance)
        made.off = tuple(
            draft.draw(apart_percent, f"Δ_{index}", made.balance, mark, unit="%")
            for index, mark in zip("Rl", due, strict=False)
        )
        self._gain()

    def _named(self, stem: str) -> str:
        return f"{stem}{'M' if self.turning else 'P'}"

    def _ratio(self, link: int) -> Mark | None:
        """Return how fast a link turns by what drives, a number or 1/m; None where no centre tells it."""
        if link not in self.ratios:
            self.ratios[link] = self._rate(link)
        return self.ratios[link]

    def _rate(self, link: int) -> Mark | None:
        rotation, first = self.rotations.get(link), self.pair.link
        letter = f"u_{{{link}{first}}}"
        if self.turning and (link == first or (rotation is not None and rotation.alike)):
            return self.draft.constant(letter, 1.0, "")
        if rotation is None or rotation.still:
            return None
        if self.turning and rotation.ratio is not None:
            return rotation.ratio
        velocities = self.plans.velocities
        assert velocities is not None
        rates = velocities.rates if self.turning else velocities.speeds
        if rotation.omega is None or first not in rates:
            return None
        unit = "" if self.turning else "1/m"
        return self.draft.draw(f.rate_per_drive, letter, rotation.omega, rates[first], unit=unit)

    def _carry(self, load: Force | Couple) -> None:
        """Carry a load to what drives."""
        draft, rotation = self.draft, self.rotations.get(load.link)
        if isinstance(load, Couple):
            if rotation is not None and rotation.still:
                return
            ratio = self._ratio(load.link)
            if ratio is None:
                self.made.lacks.append(load.link)
                return
            letter = f"{load.letter}′"
            value = draft.draw(f.couple_at_drive, letter, load.value, ratio, unit=self.unit)
            self.made.loads.append(AtDrive(load, value, ratio, None))
            return
        own = self._arm(load)
        if own is None:
            self.made.lacks.append(load.link)
            return
        letter, uses = self._named("") + f"({load.letter})", (load.value, own.height)
        value = draft.draw(
            f.load_at_drive, letter, *uses, self.centres.mu, own.ratio, unit=self.unit
        )
        self.made.loads.append(AtDrive(load, value, own.ratio, own))

    def _arm(self, force: Force) -> Arm | None:
        """Draw the line of a force in the scheme and measure its arm about the centre of its link."""
        draft, letter = self.draft, force.letter
        standing = self._standing(force.link)
        if standing is None:
            return None
        through, link = standing
        because = why.ACTION if through is None else why.CARRIED
        own = self._point(force.point)
        point = through or own
        centre, ratio = self._centre(link), self._ratio(link)
        assert centre is not None
        assert ratio is not None
        line = draft.draw(parallel, f"({letter})", point, force.line, sense=1, why=because)
        height = draft.draw(arm, f"h_{{{bare(letter)}}}", centre, line, why=why.ARM)
        return Arm(centre, point, line, height, ratio, None if through is None else own)

    def _standing(self, link: int) -> tuple[Mark | None, int] | None:
        """Return the link that a force turns: its own, or one that moves as it does in their common centre."""
        if self._turns(link):
            return None, link
        rotation, driven = self.rotations.get(link), link == self.pair.link
        if not driven and (rotation is None or not rotation.still):
            return None
        every = sorted(self.plans.positions.bodies, key=lambda k: k != self.pair.link)
        for other in every:
            common = self.centres.of(link, other)
            if common is not None and not common.far and self._turns(other):
                return common.mark, other
        return None

    def _turns(self, link: int) -> bool:
        """Whether a link turns about a centre that is there, at a rate that is known."""
        return self._centre(link) is not None and self._ratio(link) is not None

    def _centre(self, link: int) -> Mark | None:
        own = self.centres.of(link, self.centres.frame)
        return own.mark if own is not None and not own.far else None

    def _point(self, of: Mark) -> Mark:
        """Return a point of the plan of positions in the scheme."""
        if of not in self.points:
            factors = self.draft.mu_l, self.centres.mu
            self.points[of] = self.draft.draw(carry_over, of.letter, of, *factors, free=True)
        return self.points[of]

    def _balanced(self, total: Mark) -> Mark:
        """Return what balances the loads as the scene wants it, or the force that is sought."""
        draft, tool, mu = self.draft, self.made.tool, self.centres.mu
        if self.forces.tool is not None and tool is not None:
            letter = f"{self.forces.tool.force.letter}′"
            uses = total, tool.height, mu, tool.ratio
            return draft.draw(f.unknown_by_centres, letter, *uses, unit="N")
        if self.turning and self.forces.first.balance.unit == "N":
            radius = self._radius()
            return draft.draw(balancing, "P_{b}^{P}", total, radius, mu, unit="N", why=why.RADIUS)
        return draft.draw(
            reversed_, f"{self._named('')}_{{b}}^{{P}}", total, unit=self.unit, why=why.BALANCE
        )

    def _radius(self) -> Mark:
        """Measure the crank in the scheme, once."""
        assert isinstance(self.pair, Crank)
        pivot, pin = (self.points[mark] for mark in self.pair.led(self.plans.positions))
        known = self.draft.board.length(pivot, pin)
        name = f"{pivot.name}{pin.name}"
        return known or self.draft.draw(measure, name, pivot, pin, why=why.RADIUS)

    def _gain(self) -> None:
        """Calculate the mechanical advantage of the force that is sought, else of each external load."""
        tool, made = self.forces.tool, self.made
        if tool is not None and made.tool is not None:
            self._advantage(tool.force.value, made.tool.ratio, made.tool)
            return
        for one in made.loads:
            if self._external(one.load.value) and one.load.link != self.pair.link:
                self._advantage(one.load.value, one.ratio, one.arm)

    def _external(self, size: Mark) -> bool:
        """Whether a load is one that the scene gives, as it stands or with the sign of a motion."""
        given = {*self.forces.loads.given}
        known = size in given or size in self.draft.given
        return size in given if known else bool(given & {*self.draft.uses(size)})

    def _advantage(self, load: Mark, ratio: Mark, own: Arm | None) -> None:
        draft, letter = self.draft, f"i_{{{bare(load.letter)}}}"
        if own is None:
            if self.turning:
                self.made.gains[load] = draft.draw(f.advantage_of_moment, letter, ratio)
        elif self.turning:
            uses = self._radius(), own.height, own.ratio
            self.made.gains[load] = draft.draw(f.advantage_of_pin, letter, *uses)
        else:
            uses = own.height, self.centres.mu, own.ratio
            self.made.gains[load] = draft.draw(f.advantage_of_slide, letter, *uses)

"""The sections of a scene file that ask for forces: effects, loads, kinetostatics, friction."""

from __future__ import annotations

from pydantic import Field

from graphic_tmm.chapters.forces.task import AGAINST, GRAVITY
from graphic_tmm.scene import force_values as w
from graphic_tmm.scene import values as v
from graphic_tmm.scene.quantities import KGF
from graphic_tmm.scene.table import Table, key


class EffectsTable(Table):
    """What acts; an effect that is left out is not simulated, not computed and not on the sheet."""

    gravity: w.Switch = key("weights of the links", True, False)
    g: v.Acceleration | None = key(
        f"what weights are taken with; {GRAVITY} m/s² if it is left out, while kgf is {KGF} N",
        "9.80665 m/s^2",
        None,
    )
    inertia: w.Switch = key("inertia forces and couples of the links", True, False)
    gas: w.Switch = key("the gas of the indicator diagram on the piston", True, False)
    friction: w.Switch = key("friction in the pairs that [friction] names", True, False)


class LoadTable(Table):
    """A force at a point of a link, or a moment on a link."""

    link: v.LinkNumber = key("the number of the link", 5)
    point: v.Text | None = key("the letter of the point where a force acts", "D", None)
    force: w.Force | None = key("its size", "190 N", None)
    moment: w.Moment | None = key("a moment, counter-clockwise positive", "12 N*m", None)
    direction: w.Direction | None = key(
        "an angle from the x axis, or against velocity, or against rotation",
        "against velocity",
        None,
    )
    by_position: w.Sizes | None = key("its size in each position", ["190 N", "0 N"], None)
    by_angle: w.ByAngle | None = key(
        "its size by the turn of the crank from the zero position",
        [[0, "0 N"], [90, "190 N"]],
        None,
    )
    of: v.Text | None = key("the letter of the point by whose travel it is told", "D", None)
    out: w.ByTravel | None = key(
        "its size on the stroke from the zero position, by shares of it",
        [[0, "0 N"], [1, "190 N"]],
        None,
    )
    back: w.ByTravel | None = key(
        "its size on the stroke back, by shares from the same end", [[0, "0 N"], [1, "190 N"]], None
    )

    @property
    def resists(self) -> bool:
        """Whether it acts against the motion."""
        return self.direction == AGAINST or (self.direction is None and self.point is not None)


class ForcesTable(Table):
    """Kinetostatics by groups and Zhukovsky's lever."""

    positions: v.Accelerations = key("the positions whose forces are drawn", [8], ("all",))
    balance: w.Balance = key(
        "what balances the crank: a force at its pin, or a moment", "force", "force"
    )
    couples: w.Couples = key(
        "couples on the lever: converted moments, or pairs of forces", None, "moment"
    )
    single: w.Links = key("links whose inertia force and couple are replaced by one force", [3], ())
    limit: w.Limit = key("how much the two methods may differ", "5 %", 5.0)
    mu_F: w.MuForce | None = key("N/mm, of every polygon", "40 N/mm", None)


class FrictionTable(Table):
    """Coefficients of friction, radii of pins."""

    f: w.Coefficient = key("the coefficient of every pair that is not named", 0.1, 0.0)
    pairs: dict[str, w.Coefficient] = Field(
        default_factory=dict, description="coefficients of pairs by their letter or guide"
    )
    radius: v.PositiveLength | None = key(
        "the radius of every pin that is not named", "15 mm", None
    )
    radii: dict[str, v.PositiveLength] = Field(
        default_factory=dict, description="radii of pins by their letter"
    )
    passes: w.Passes = key("passes with friction", 2, 2)


class EngineTable(Table):
    """The forces of the crank mechanism of an engine, over the whole turn."""

    point: v.Text = key("the letter where the connecting rod meets the crosshead", "B")
    share: w.Share | None = key(
        "share of the rod's mass that goes to and fro; left out: by the lever rule", 0.25, None
    )
    mass: v.Mass | None = key("the whole mass that goes to and fro", "2.18 kgf*s^2/m", None)
    inertia: w.Series = key("inertia from the plan, or by the two-term series", "plan", "plan")
    unit: w.ForceUnit = key("the unit of forces", "kgf", "N")
    base: v.Drawn = key("length of the diagrams' base for a turn", "120 mm", 120.0)

"""What closes a cam and its follower by force: inertia of the follower, its load, the spring; their keys."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass

from graphic_tmm.board.bounds import Bound
from graphic_tmm.chapters.cam.kinds import PLATE, ROCKING
from graphic_tmm.language.said import said
from graphic_tmm.scene import quantities
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Kind, Names, Said, key
from graphic_tmm.scene.units import Dimension

USUAL = 1.3
"""Reserve of a spring over the inertia force: 1.2 to 1.5 are usual."""


@dataclass(frozen=True)
class SpringTask:
    """What a follower is pressed on with, SI; of a lever moments of inertia, moments, moments per radian.

    ``load`` presses besides the spring. ``lead``: by how much the spring is compressed in the lowest place, as
    much as the stroke if None. ``rate`` and ``preload`` of a spring that is given, else both are None.
    """

    inertia: float
    load: float = 0.0
    reserve: float = USUAL
    lead: float | None = None
    rate: float | None = None
    preload: float | None = None


def spring_of(said: Said) -> SpringTask | None:
    """Return what a section says of the spring; None if the follower has no mass there."""
    inertia = said.inertia if said.follower in ROCKING else said.mass
    if not inertia:
        return None
    sizes = (said.load or 0.0, said.reserve, said.lead, said.rate, said.preload)
    return SpringTask(inertia, *sizes)


def _either(rod: Dimension, lever: Dimension) -> Kind:
    """Return the kind of a quantity of a rod, or of a lever: not negative, its dimension by its unit."""

    def read(value: object, names: Names) -> float:
        size = quantities.parse(value, lever if quantities.is_a(value, lever) else rod)
        if size < 0.0:
            raise ValueError(said("it is not negative"))
        return size

    return Kind(read, v.quantity_schema(rod), unit=f"{rod}, or {lever}")


_LEAD, _FORCE = _either("length", "angle"), _either("force", "moment")
_RATE = _either("stiffness", "moment")
KEYS = {
    "mass": key(v.quantity("mass"), "mass of the follower on a rod", "0.4 kg", None),
    "inertia": key(v.POSITIVE_INERTIA, "moment of inertia of a lever", "0.002 kg*m^2", None),
    "load": key(_FORCE, "force (of a lever moment) that presses it on the cam", "40 N", None),
    "reserve": key(
        v.number(Bound(1, 10)), "how many times the inertia force the spring holds", 1.3, USUAL
    ),
    "lead": key(
        _LEAD, "how much the spring is compressed in the lowest place; left out: as much as the stroke",
        "20 mm", None,
    ),
    "rate": key(_RATE, "rate of a spring that is given (of a lever a radian)", "3 kN/m", None),
    "preload": key(_FORCE, "its force, or moment, in the lowest place", "60 N", None),
}  # fmt: skip
"""The keys that `spring_of` reads."""

NO_SPEED = said('forces of inertia need it; write, for example, "300 rpm"')
_KINDS: dict[str, tuple[Dimension, Dimension]] = {
    "load": ("force", "moment"), "preload": ("force", "moment"),
    "rate": ("stiffness", "moment"), "lead": ("length", "angle"),
}  # fmt: skip
_EXAMPLES: dict[Dimension, str] = {
    "force": "40 N", "moment": "2 N*m", "stiffness": "3 kN/m", "length": "20 mm", "angle": "10 deg",
}  # fmt: skip


def flaws(cam: Said, written: dict[str, object]) -> Iterator[Flaw]:
    """Yield what contradicts itself about the spring; ``written``: the section as it stands."""
    rocks = cam.follower in ROCKING
    own, other = ("inertia", "mass") if rocks else ("mass", "inertia")
    given = getattr(cam, own) is not None
    pair = {"rate", "preload"}
    for wrong, name, says in (
        (getattr(cam, other) is not None, other, said("this follower has {own} instead", own=own)),
        (cam.mass is not None and cam.mass <= 0.0, "mass", said("a mass is greater than 0")),
        (given and cam.speed is None and cam.form != PLATE, "speed", NO_SPEED),
        (len(pair & set(written)) == 1, "preload" if "rate" in written else "rate",
         said("a spring that is given has both rate and preload")),
        (pair <= set(written) and "lead" in written, "lead",
         said("a spring that is given has its preload: leave lead out")),
    ):  # fmt: skip
        if wrong:
            yield Flaw(("cam", name), says)
    for name in (name for name in _KINDS if name in written):
        dimension = _KINDS[name][rocks]
        if not given:
            says = said("it belongs to the spring, which needs {own} of the follower", own=own)
            yield Flaw(("cam", name), says)
        elif isinstance(written[name], str) and not quantities.is_a(written[name], dimension):
            example = _EXAMPLES[dimension]
            says = said('for this follower write, for example, "{example}"', example=example)
            yield Flaw(("cam", name), says)

"""What is asked of a planetary train: its scheme, its ratio or its tooth numbers, limits (SI)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from fractions import Fraction
from types import MappingProxyType
from typing import TYPE_CHECKING, NamedTuple

from graphic_tmm.board.bounds import Bound
from graphic_tmm.chapters.trains import task_values as own
from graphic_tmm.language.said import said
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Said, Section, combined_key, key
from graphic_tmm.scene.tasks import SectionKey

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts


PLANETARY_TRAIN = "planetary"


class Mesh(NamedTuple):
    """A central wheel and the rim of the satellites that it touches.

    ``sense``: +1 where both have external teeth, −1 where the central wheel is a ring; of a ``bevel`` pair −1
    where the central wheel stands behind the satellite and turns as a ring would.
    """

    wheel: str
    rim: str
    sense: int
    bevel: bool = False

    @property
    def ring(self) -> bool:
        """Whether the central wheel is a ring."""
        return self.sense < 0 and not self.bevel


@dataclass(frozen=True)
class Scheme:
    """One of the usual schemes: its name, and which central wheels touch which rims of the satellites."""

    name: str
    meshes: tuple[Mesh, ...]

    @property
    def wheels(self) -> tuple[str, ...]:
        """The wheels by their numbers."""
        return tuple(sorted({name for mesh in self.meshes for name in mesh[:2]}))

    @property
    def rims(self) -> tuple[str, ...]:
        """The rims of the satellites, row by row."""
        return tuple(dict.fromkeys(mesh.rim for mesh in self.meshes))

    @property
    def rows(self) -> int:
        """How many rows of wheels stand beside each other."""
        return len(self.rims)

    @property
    def first(self) -> int:
        """The sense of the first mesh."""
        return self.meshes[0].sense

    @property
    def second(self) -> int:
        """The sense of the last mesh."""
        return self.meshes[-1].sense

    @property
    def bevel(self) -> bool:
        """Whether the wheels are bevel wheels, the axes of the satellites cross the main one."""
        return self.meshes[0].bevel

    @property
    def opposed(self) -> bool:
        """Whether, with the carrier held, the first and the last central wheel turn in opposite senses."""
        return self.first * self.second < 0

    @property
    def spots(self) -> dict[str, str]:
        """The points of the line of centres, by letter, each with the member that moves there."""
        first, *others = (mesh.wheel for mesh in self.meshes)
        return dict(zip("ABCD", (first, "H", *others), strict=False))

    @property
    def members(self) -> tuple[str, ...]:
        """What has a shaft on the main axis; where three central wheels have one the carrier runs idle."""
        central = tuple(mesh.wheel for mesh in self.meshes)
        return central if len(central) > 2 else (*central, "H")

    @property
    def shafts(self) -> int:
        """How many satellites there are, if nothing is said."""
        return 1 if len(self.meshes) < 2 else 2 if self.bevel else 3

    @property
    def usual(self) -> tuple[str, str]:
        """Which member drives and which stands, if nothing is said."""
        return ("H", "1") if len(self.meshes) < 2 else ("1", self.meshes[1].wheel)

    def driving(self, fixed: str | None) -> str:
        """Return which member drives, if nothing is said: of two the one that does not stand."""
        return "1" if fixed == "H" else self.usual[0]

    @property
    def pairs(self) -> tuple[Scheme, ...]:
        """The trains of two meshes, each with the first, that it is made of."""
        first, *others = self.meshes
        return tuple(Scheme(self.name, (first, one)) for one in others) or (self,)

    def mesh(self, wheel: str) -> Mesh:
        """Return the (first) mesh of a wheel, central or a rim."""
        return next(mesh for mesh in self.meshes if wheel in mesh[:2])


def _scheme(name: str, *meshes: str) -> Scheme:
    return Scheme(
        name, tuple(Mesh(m[0], m[2], 1 if m[1] in "+<" else -1, m[1] in "<>") for m in meshes)
    )


SCHEMES: Mapping[str, Scheme] = MappingProxyType(
    {
        scheme.name: scheme
        for scheme in (
            _scheme("ring", "1+2", "3−2"),
            _scheme("external-internal", "1+2", "4−3"),
            _scheme("external-external", "1+2", "4+3"),
            _scheme("internal-internal", "1−2", "4−3"),
            _scheme("external", "1+2"),
            _scheme("internal", "1−2"),
            _scheme("3K", "1+2", "3−2", "5−4"),
            _scheme("bevel", "1<2", "3>2"),
            _scheme("bevel-double", "1<2", "4>3"),
        )
    }
)
"""The schemes by name; of a mesh: central wheel, + or − as in the distance of axes, rim of the satellites.

Of bevel wheels < or >: before the axis of the satellites or behind it.
"""


@dataclass(frozen=True)
class Limits:
    """Limits on tooth numbers: ``least`` and ``most`` of a wheel with external teeth, ``ring_most`` of a ring.

    ``least`` is the number that is cut without undercut: 17 for α = 20°, h_a* = 1. ``difference``: by how much
    a ring has more teeth than the satellite inside it at the least, so that their tips pass each other.
    """

    least: int = 17
    most: int = 150
    ring_most: int = 300
    difference: int = 8


@dataclass(frozen=True)
class PlanetaryTask:
    """A planetary train: tooth numbers wanted, or checked.

    ``scheme``: one of `SCHEMES`: 2K–H, two wheels on an arm, 3K, or bevel wheels. ``module``: of the first
    row, m, of bevel wheels the mean one; ``module_2`` of the second, that of the first if None. ``speed``:
    angular velocity of the driving shaft, rad/s, with its sign, or of both that drive. ``driving``: the member
    that drives, a central wheel or "H", or two; "1" with two speeds is both central wheels. ``fixed``: the one
    that stands, None for the usual one (see `Scheme.usual`, `motion_of`).
    ``ratio``: the ratio wanted, driving over driven angular velocity, with its sign;
    ``tolerance``: by what share of itself it may be missed. ``teeth``: a tooth number for every wheel of the
    scheme, None for one that is to be found; () for all of them. ``satellites``: the numbers of satellites
    that are allowed. ``alpha`` (degrees), ``ha``, ``c``: pressure angle, factors of the addendum and of the
    clearance. ``moment``: torque on the (first) driving shaft in its sense, N·m; None asks for no torques;
    ``mesh_efficiency``: of each mesh with the carrier held. ``behind``: the teeth of the pairs of gears behind
    the train, in the order in which power goes through them, idlers between; ``before``: of those before it,
    the ``speed`` is that of the first of them. ``closed``: two members of a differential that wheels join: of
    each those from its shaft onward to one that is common to both. ``mu_l`` (m/mm), ``mu_v`` ((m/s)/mm) and
    ``pole``, the pole distance of the plan of angular velocities (mm): standard and round ones are
    chosen where they are None.
    """

    scheme: str = combined_key(
        lambda said: said.scheme,
        scheme=key(v.choice(*SCHEMES), "which wheels mesh", "ring", "ring"),
    )
    module: float = key(v.POSITIVE_LENGTH, "the module, of bevel wheels the mean one", "8 mm")
    speed: float | tuple[float, ...] = key(
        own.SPEEDS, "angular velocity of the driving shaft, of both of a differential", "2888 rpm"
    )
    driving: str | tuple[str, ...] = combined_key(
        lambda said: said.driving or SCHEMES[said.scheme].driving(said.fixed),
        "1",
        driving=key(
            own.DRIVERS,
            "which drives, a central wheel or the carrier H, or both of a differential",
            "1",
            None,
        ),
    )
    fixed: str | None = key(
        own.MEMBER, "which stands still, a central wheel or the carrier H", "3", None
    )
    ratio: float | None = key(own.RATIO, "wanted ratio, driving over driven", 4.55, None)
    tolerance: float = key(v.number(Bound(0, 0.5), "ratio"), "how far it may be off", "1 %", 0.01)
    teeth: tuple[int | None, ...] = key(
        own.SOME_TEETH, 'tooth numbers, "?" for one to be found', [25, "?", "?"], ()
    )
    satellites: tuple[int, ...] = combined_key(
        lambda said: said.satellites or (SCHEMES[said.scheme].shafts,),
        (3,),
        satellites=key(
            own.SATELLITES,
            "number of satellites, or several to choose from; if left out 3, bevel ones 2, on an arm 1",
            3,
            None,
        ),
    )
    module_2: float | None = key(v.POSITIVE_LENGTH, "the module of the second row", "6 mm", None)
    alpha: float = key(v.RACK, "pressure angle", "20 deg", 20.0)
    ha: float = key(v.ADDENDUM, "addendum coefficient", 1, 1.0)
    c: float = key(v.CLEARANCE, "clearance coefficient", 0.25, 0.25)
    limits: Limits = combined_key(
        lambda said: Limits(said.least, said.most, said.ring_most),
        Limits(),
        least=key(own.COUNT, "fewest teeth", 17, 17),
        most=key(own.COUNT, "most teeth of a wheel", 150, 150),
        ring_most=key(own.COUNT, "most teeth of a ring", 300, 300),
    )
    moment: float | None = key(
        v.quantity("moment", Bound(0, above=True)), "torque on the driving shaft", "20 N m", None
    )
    mesh_efficiency: float = key(
        v.number(Bound(0, 1, above=True)), "efficiency of a mesh", 0.97, 1.0
    )
    mu_l: float | None = key(v.MU_L, 'm/mm, or "1:5"', "1:5", None, fixes="size")
    mu_v: float | None = key(v.mu("scale of velocities"), "(m/s)/mm", "0.5 (m/s)/mm", None)
    pole: float | None = key(
        v.DRAWN, "pole distance of the plan of angular velocities", "40 mm", None
    )
    behind: tuple[tuple[int, ...], ...] = key(
        own.ROWS, "teeth of the pair of gears behind the train, or of several pairs", [15, 25], ()
    )
    rack: int | None = key(
        own.COUNT, "teeth of a wheel on the last shaft that drives a rack", 18, None
    )
    before: tuple[tuple[int, ...], ...] = key(
        own.ROWS, "teeth of the pair of gears before the train, or of several pairs", [20, 60], ()
    )
    closed: tuple[tuple[str, tuple[int, ...]], ...] = key(
        own.CLOSED,
        "two shafts of a differential that wheels join: teeth from each to a shaft of both",
        [["H", 30, 20], ["3", 32, 18]],
        (),
    )


ASKED: SectionKey[PlanetaryTask] = SectionKey("planetary")


@dataclass(frozen=True)
class Train:
    """A train that is settled: its scheme, a tooth number for every wheel, the number of satellites."""

    scheme: Scheme
    teeth: tuple[int, ...]
    satellites: int


def module_ratio(order: PlanetaryTask) -> Fraction:
    """Return module_2/module as the ratio of small whole numbers that it is."""
    if order.module_2 is None:
        return Fraction(1)
    return Fraction(order.module_2 / order.module).limit_denominator(1000)


def check(asked: Said, parts: Parts) -> Iterator[Flaw]:
    """What the section does not say, or says of a pair that is none."""
    for name in ("behind", "before"):
        if any(len(row) < 2 for row in getattr(asked, name)):
            says = said("a pair has two wheels, three with an idler; write [15, 25]")
            yield Flaw(("planetary", name), says)
    if asked.ratio is None and not asked.teeth:
        says = said("neither a ratio nor tooth numbers are given; write ratio = 4.55")
        yield Flaw(("planetary", "ratio"), says)


SECTIONS = (
    Section(
        "planetary", PlanetaryTask, "a planetary train", alone=True, metric=True,
        begin='ratio = 4.55, module = "8 mm"', check=check,
        refuse="graphic_tmm.chapters.trains.refusals:scheme_of",
    ),
)  # fmt: skip

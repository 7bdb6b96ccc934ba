"""The section of a scene that gives the lengths of its mechanism by a task: what there is to be given."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

from graphic_tmm.board.bounds import POSITIVE, Bound
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.synthesis import KINDS
from graphic_tmm.mechanism.synthesis_functions import KNOWN
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Sort, key, keys_of
from graphic_tmm.scene.tables import Several, missing_key


def _three(of: Sort, example: str) -> Several:
    return Several(of, said("write {example}", example=example))


@dataclass(frozen=True)
class Task:
    """A task that gives the lengths of a mechanism; which keys belong together is said by its kind."""

    kind: str = key(
        v.choice(
            *KINDS,
            кулиса="rocker",
            кривошипно_ползунный="slider-crank",
            кривошипно_коромысловый="crank-rocker",
            шатун="coupler",
            углы="angles",
            функция="function",
            качающийся_цилиндр="cylinder",
            выстой="dwell",
        ),
        "the kind of mechanism, by its keys, and the lengths that it gives: rocker (K_v, stroke, OB: OA, "
        "BC, OB); slider-crank (stroke, or v_m and n; K_v and e, or lambda or pressure and, if there is "
        "one, e: OA, AB, e); crank-rocker (psi, K_v, BC; OC or transmission: OA, AB, BC, OC); coupler in "
        "three positions (A, angles, AB: xO, yO, xC, yC, OA, AB, BC); three pairs of angles (crank, rocker, "
        "OA, OC: OA, AB, BC, OC); function (x; power, y or values; crank, rocker, OA, OC: the same); "
        "swinging cylinder (stroke, or v_m and n; psi: OA, OC); dwell by an arc of a coupler's path (OA, AB, "
        "BC, OC, M, dwell, tolerance, E: the lengths, xM, yM, xE, yE, MD, DE)",
        "rocker",
    )
    K_v: float | None = key(v.RATIO, "ratio of the mean speeds of the two strokes", 1.45, None)
    stroke: float | None = key(v.POSITIVE_LENGTH, "the stroke of the slider", "95 mm", None)
    OB: float | None = key(
        v.POSITIVE_LENGTH,
        "the distance of the fixed pivots of a rocker with its stone",
        "480 mm",
        None,
    )
    v_m: float | None = key(
        v.quantity("speed", POSITIVE),
        "in place of the stroke: the mean speed of the slider",
        "3 m/s",
        None,
    )
    n: float | None = key(
        v.quantity("angular speed", POSITIVE), "with v_m: how fast the crank turns", "600 rpm", None
    )
    e: float | None = key(
        v.POSITIVE_LENGTH, "how far the slider's guide passes the crank's pivot", "30 mm", None
    )
    lambda_: float | None = key(
        v.number(Bound(1, 100, above=True)),
        "in place of K_v: the connecting rod over the crank, l/r",
        4,
        None,
        written="lambda",
    )
    pressure: float | None = key(
        v.number(Bound(0, 90, above=True, below=True), "angle"),
        "in place of K_v: the greatest angle between connecting rod and guide",
        "15 deg",
        None,
    )
    psi: float | None = key(
        v.number(Bound(0, 180, above=True, below=True), "angle"),
        "by which angle the rocker, or the cylinder, swings",
        "40 deg",
        None,
    )
    BC: float | None = key(v.POSITIVE_LENGTH, "the length of the rocker", "100 mm", None)
    OC: float | None = key(
        v.POSITIVE_LENGTH, "the distance of the pivots of crank and rocker", "120 mm", None
    )
    transmission: float | None = key(
        v.number(Bound(0, 90, above=True, below=True), "angle"),
        "in place of OC: the least angle between coupler and rocker",
        "40 deg",
        None,
    )
    A: tuple[complex, ...] = key(
        _three(v.POINT, '[["0 mm", 0], ["30 mm", "20 mm"], ["50 mm", "60 mm"]]'),
        "the three places of a coupler's first pin",
        [["0 mm", 0], ["30 mm", "20 mm"], ["50 mm", "60 mm"]],
        (),
    )
    angles: tuple[float, ...] = key(
        v.ANGLES, "the directions of the coupler AB there", ["10 deg", "30 deg", "70 deg"], ()
    )
    AB: float | None = key(v.POSITIVE_LENGTH, "the length of that coupler", "80 mm", None)
    OA: float | None = key(v.POSITIVE_LENGTH, "the length of the crank, chosen", "40 mm", None)
    crank: tuple[float, ...] = key(
        v.ANGLES,
        "the three angles of the crank from the line OC; of a function the two for the ends of its range",
        ["30 deg", "60 deg", "90 deg"],
        (),
    )
    rocker: tuple[float, ...] = key(
        v.ANGLES,
        "the angles of the rocker, or of a pointer on it, that belong to them",
        ["40 deg", "60 deg", "75 deg"],
        (),
    )
    x: tuple[float, ...] = key(
        _three(v.number(Bound(-1e9, 1e9)), "[1, 2]"),
        "the range of a function's argument; of a table its three arguments",
        [1, 2],
        (),
    )
    power: float | None = key(
        v.number(Bound(-20, 20)), "the power p of the function y = x^p", 1.5, None
    )
    y: str | None = key(
        v.choice(*KNOWN, ln="ln x", sin="sin x"),
        "in place of the power: another function; x of a sine in degrees",
        "ln x",
        None,
    )
    values: tuple[float, ...] = key(
        _three(v.number(Bound(-1e9, 1e9)), "[0, 0.7, 1.1]"),
        "in place of the power: a table's values y at the three x",
        [0, 0.7, 1.1],
        (),
    )

    M: complex | None = key(
        v.POINT,
        "the point of a coupler that goes along an arc, from A along AB; B to the left of the way from A to C",
        ["50 mm", "40 mm"],
        None,
    )
    dwell: tuple[float, ...] = key(
        v.ANGLES,
        "the angles of the crank from the line OC between which it does",
        ["90 deg", "170 deg"],
        (),
    )
    tolerance: float | None = key(
        v.POSITIVE_LENGTH, "how far the path may leave the arc", "0.2 mm", None
    )
    E: complex | None = key(
        v.POINT,
        "the pivot of what is to stand meanwhile, from O along OC",
        ["150 mm", "90 mm"],
        None,
    )

    @property
    def given(self) -> Mapping[str, Any]:
        """What is given (SI, degrees), by the keys that say it."""
        return given_by(self.kind, lambda name: getattr(self, _FIELDS.get(name, name)))


_FIELDS = {"lambda": "lambda_"}
"""Fields of keys that Python keeps for itself."""


def given_by(kind: str, value: Callable[[str], Any]) -> dict[str, Any]:
    """Return what of the keys of a task is said, by key."""
    names = dict.fromkeys(
        name for one in KINDS.values() for way in one.ways for name in sorted(way)
    )
    return {name: value(name) for name in names if value(name) not in (None, ())}


def task_flaws(kind: str, given: Mapping[str, Any]) -> Iterator[Flaw]:
    """Yield what is missing or too much beside the way of giving the task that is meant."""
    said_ = set(given)
    way = min(KINDS[kind].ways, key=lambda one: (len(one ^ said_), len(one - said_)))
    known = keys_of(Task)
    for name in known:
        if name in way - said_:
            yield Flaw(("task", name), missing_key(name, known[name]))
        elif name in said_ - way:
            says = said(
                'kind = "{kind}" has no use of {name} beside {listed}; take it out',
                kind=kind,
                name=name,
                listed=", ".join(one for one in known if one in way & said_),
            )
            yield Flaw(("task", name), says)

"""What makes no sense of what is asked of a planetary train, and what to change."""

from __future__ import annotations

import math

from graphic_tmm.board.bounds import TaskError
from graphic_tmm.chapters.trains.motion import motion_of, refused
from graphic_tmm.chapters.trains.task import SCHEMES, PlanetaryTask, Scheme, module_ratio
from graphic_tmm.chapters.trains.task_values import TEETH
from graphic_tmm.language.said import said
from graphic_tmm.scene.declare import bound_of


def scheme_of(order: PlanetaryTask) -> Scheme:
    """Return the scheme of a sound order.

    Raises
    ------
    TaskError
        If the scheme is none, or anything asked for is no quantity of a train.
    """
    scheme = SCHEMES.get(order.scheme)
    if scheme is None:
        listed = ", ".join(SCHEMES)
        says = said('no scheme "{name}": take one of {listed}', name=order.scheme, listed=listed)
        raise TaskError("planetary", "scheme", says)
    closed = tuple(row for _, row in order.closed)
    for name, rows in (("behind", order.behind), ("before", order.before), ("closed", closed)):
        for row in rows:
            for z in row:
                _bounded(name, z)
    if order.rack is not None:
        _bounded("rack", order.rack)
    _refuse_sizes(order, scheme)
    _refuse_counts(order, scheme)
    _refuse_shafts(order, scheme)
    _refuse_ratio(order)
    return scheme


def _bounded(key: str, value: object) -> None:
    """Refuse a value outside the bounds of a key."""
    bound_of(PlanetaryTask, key).refuse("planetary", key, value)


def _refuse_sizes(order: PlanetaryTask, scheme: Scheme) -> None:
    for name, value in (
        ("module", order.module),
        ("module_2", order.module_2),
        ("mu_l", order.mu_l),
        ("mu_v", order.mu_v),
        ("pole", order.pole),
        ("moment", order.moment),
    ):
        if value is not None:
            _bounded(name, value)
    for name in ("alpha", "ha", "c", "mesh_efficiency"):
        _bounded(name, getattr(order, name))
    for speed in motion_of(order).driving.values():
        if not (math.isfinite(speed) and speed != 0.0):
            says = said(
                "the driving shaft turns at {speed}: give its angular velocity", speed=speed
            )
            raise refused("speed", says)
    if order.module_2 is None:
        return
    if scheme.rows == 1:
        raise refused("module_2", said("a single row has one module: leave module_2 out"))
    if abs(order.module * float(module_ratio(order)) - order.module_2) > 1e-9 * order.module_2:
        raise refused(
            "module_2",
            said(
                "modules of {first:g} and {second:g} m have no simple ratio: take standard ones",
                first=order.module,
                second=order.module_2,
            ),
        )


def _refuse_counts(order: PlanetaryTask, scheme: Scheme) -> None:
    if order.teeth and len(order.teeth) != len(scheme.wheels):
        raise refused(
            "teeth",
            said(
                'scheme "{name}" has wheels {wheels}, not {n}: give a tooth number for each, or none',
                name=scheme.name,
                wheels=", ".join(scheme.wheels),
                n=len(order.teeth),
            ),
        )
    for z in order.teeth:
        if z is not None:
            _bounded("teeth", z)
    if not order.satellites:
        says = said("no number of satellites is allowed: give one, such as 3")
        raise refused("satellites", says)
    for k in order.satellites:
        _bounded("satellites", k)
    limits = order.limits
    for name in ("least", "most", "ring_most"):
        _bounded(name, getattr(limits, name))
    TEETH.refuse("planetary", "difference", limits.difference)
    if limits.least > limits.most:
        says = said(
            "from {least} to {most} there is no tooth number", least=limits.least, most=limits.most
        )
        raise refused("least", says)


def _refuse_shafts(order: PlanetaryTask, scheme: Scheme) -> None:
    """Refuse what needs a shaft that the scheme has not, or is sought by none."""
    single = len(scheme.meshes) == 1
    _refuse_sought(order, scheme)
    if order.pole is not None and scheme.bevel:
        says = said("of bevel wheels angular velocities are laid off as vectors: leave pole out")
        raise refused("pole", says)
    if single and order.moment is not None:
        says = said("the satellite has no shaft on the axis to take a torque: leave moment out")
        raise refused("moment", says)
    motion = motion_of(order)
    shafts = (("behind", motion.driven), ("rack", motion.driven), ("before", motion.first))
    for name, member in shafts:
        if not getattr(order, name):
            continue
        if scheme.bevel:
            says = said(
                "outside a train of bevel wheels no pair is drawn: leave {key} out", key=name
            )
            raise refused(name, says)
        if single:
            says = said(
                "the satellite has no shaft on the axis for a pair: leave {key} out", key=name
            )
            raise refused(name, says)
        if "H" not in scheme.members and member == "3":
            raise refused(name, said("ring 3 has no shaft for a pair: leave {key} out", key=name))
    if order.before and (order.behind or order.rack) and "1" not in (motion.driven, motion.first):
        says = said("pairs before and behind would stand on one side of the train: leave one out")
        raise refused("before", says)


def _refuse_sought(order: PlanetaryTask, scheme: Scheme) -> None:
    """Refuse to seek teeth of a scheme whose teeth are given."""
    if len(scheme.meshes) > 1 and not scheme.bevel and "H" in scheme.members:
        return
    if order.ratio is not None:
        says = said(
            'teeth of scheme "{name}" are given, not sought: leave ratio out', name=scheme.name
        )
        raise refused("ratio", says)
    if not order.teeth or None in order.teeth:
        says = said(
            'teeth of scheme "{name}" are not sought: give all tooth numbers', name=scheme.name
        )
        raise refused("teeth", says)


def _refuse_ratio(order: PlanetaryTask) -> None:
    if not motion_of(order).fixed:
        if order.ratio is not None:
            says = said("a differential has no ratio that teeth are sought by: leave it out")
            raise refused("ratio", says)
        outside = [name for name in ("behind", "before", "rack") if getattr(order, name)]
        if outside:
            says = said("behind a differential no pair is drawn: leave it out")
            raise refused(outside[0], says)
    if order.ratio is None:
        if not order.teeth or None in order.teeth:
            raise refused(
                "ratio", said("neither a ratio nor all tooth numbers are given: give one of them")
            )
        return
    _bounded("ratio", order.ratio)
    if order.ratio == 0.0:
        raise refused("ratio", said("a ratio of 0 is none"))
    _bounded("tolerance", order.tolerance)

"""Plans of positions, velocities and accelerations as a student draws them, on paper, by ruler and square.

``wrong`` says what is done wrongly: a knob of the construction and its setting, in some positions or all.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, NamedTuple

import numpy as np

from .hand import RIGHT, Hand
from .machines import Machine

Knobs = Mapping[str, Any]


class Factors(NamedTuple):
    """The student's own scale factors: m, m/s and m/s² a mm, N a mm, and of diagrams."""

    l: float  # noqa: E741
    v: float
    a: float
    F: float = 4.0
    S: float = 0.004
    V: float = 0.04
    A: float = 0.75


class Plan(NamedTuple):
    """A plan of one position: points from its pole, and lengths that were calculated to be laid off, mm."""

    points: dict[str, complex]
    laid: dict[str, float]


class Position(NamedTuple):
    """What was drawn of one position, and the lengths that were read off for further calculation, mm."""

    places: Plan
    velocities: Plan
    accelerations: Plan | None
    read: dict[str, float]
    rates: dict[str, float]


def _sign(of: complex, by: complex) -> float:
    """Return 1 where turning ``by`` counterclockwise gives the way of ``of``, else −1."""
    return float(np.sign((of * (by * RIGHT).conjugate()).real)) or 1.0


def places(machine: Machine, mu: Factors, hand: Hand, k: float, w: Knobs) -> Plan:
    """Draw the mechanism in a position."""
    m = machine
    angle = m.angle(k + w.get("p.shift", 0)) * w.get("p.sense", 1)
    oa = m.OA / mu.l * w.get("p.OA", 1.0)
    A = hand.lay(0, np.exp(1j * angle), oa)
    points = {"A": A}
    if m.S1:
        points["S1"] = A * m.S1
    if m.kind == "slider":
        B = hand.arc(
            A, m.AB * w.get("p.AB", 1.0) / mu.l, w.get("p.axis", 0) * 1j, 1, w.get("p.way", 1)
        )
        share = m.S2 / m.AB
        share = w.get("p.s2", share)
        points |= {"B": B, "S2": A + (B - A) * share}
    elif m.kind == "rocker":
        C = m.pivot / mu.l * w.get("p.OC", 1.0)
        way = w.get("p.way", 1)
        B = hand.arcs(A, m.AB * w.get("p.AB", 1.0) / mu.l, C, m.BC * w.get("p.BC", 1.0) / mu.l, way)
        share = m.E / m.AB
        share = share.conjugate() if w.get("p.E") else share
        points |= {"B": B, "C": C, "E": A + hand.ray(B - A) * abs(B - A) * share}
    else:
        B = m.pivot / mu.l * w.get("p.OB", 1.0)
        C = hand.lay(B, A - B, m.BC * w.get("p.BC", 1.0) / mu.l * w.get("p.side", 1))
        points |= {"B": B, "C": C}
        if m.S3:
            points["S3"] = C
    if m.CD:
        line = m.guide / mu.l * 1j
        points["D"] = hand.arc(C, m.CD * w.get("p.CD", 1.0) / mu.l, line, 1, w.get("p.wayD", 1))
    return Plan(points, {})


def velocities(machine: Machine, mu: Factors, hand: Hand, at: Plan, w: Knobs) -> Plan:
    """Draw the plan of velocities by the places that were drawn; ω of the crank times OA is pa."""
    m, P = machine, at.points
    pa = m.omega * m.OA / mu.v * w.get("v.pa", 1.0)
    along = P["A"] if w.get("v.pa along") else P["A"] * RIGHT
    a = hand.lay(0, along * w.get("v.sense", 1) * m.omega, pa)
    points, laid = {"a": a}, {"pa": pa}
    if m.S1:
        points["s1"] = a * m.S1
    if m.kind in ("slider", "rocker"):
        link = P["B"] - P["A"]
        across = link if w.get("v.t along") else link * RIGHT
        other = 1 if m.kind == "slider" else (P["B"] - P["C"]) * RIGHT
        if w.get("v.guide across"):
            other *= RIGHT
        b = hand.meet(a, across, 0, other)
        points["b"] = b
        if m.S2:
            points["s2"] = a + (b - a) * w.get("v.s2", m.S2 / m.AB)
        if m.E:
            points["e"] = _image(hand, a, b, m, w.get("v.e"))
        return Plan(points, laid)
    return _lever_velocities(m, mu, hand, P, points, laid, w)


def _lever_velocities(
    m: Machine,
    mu: Factors,
    hand: Hand,
    P: dict[str, complex],
    points: dict[str, complex],
    laid: dict[str, float],
    w: Knobs,
) -> Plan:
    """Draw the velocities of a slotted lever under its stone, and of the group behind it."""
    a = points["a"]
    link = P["A"] - P["B"]
    along, across = link, link * RIGHT
    if w.get("v.t along"):
        along, across = across, along
    a3 = hand.meet(a, along, 0, across)
    ratio = m.BC / (abs(link) * mu.l)
    if w.get("v.pc inverse"):
        ratio = 1 / ratio
    if w.get("v.pc no mu"):
        ratio = m.BC / (abs(link) * 0.001)
    ratio *= w.get("v.pc", 1.0)
    c = hand.lay(0, a3, abs(a3) * ratio) if abs(a3) > 0.3 else a3 * ratio
    points |= {"a3": a3, "c": c}
    if m.S3:
        points["s3"] = c
    if m.CD:
        arm = P["D"] - P["C"]
        points["d"] = hand.meet(c, arm if w.get("v.t4 along") else arm * RIGHT, 0, 1)
    return Plan(points, laid)


def _image(hand: Hand, a: complex, b: complex, m: Machine, how: Any) -> complex:
    """Return the image of E: the triangle ABE on ab, in the same sense, or as it was done wrongly."""
    share = m.E / m.AB
    if how == "mirrored":
        share = share.conjugate()
    if how == "from b":
        return complex(b + hand.ray(a - b) * abs(a - b) * share)
    if how == "half":
        share = complex(0.5, share.imag)
    return complex(a + (hand.ray(b - a) * abs(b - a) * share if abs(b - a) > 0.2 else 0))


def calculated(
    machine: Machine, mu: Factors, hand: Hand, at: Plan, v: Plan, w: Knobs
) -> tuple[dict[str, float], dict[str, float]]:
    """Return lengths read off for calculation, mm, and angular velocities, 1/s, by the student's own μ."""
    m, P, V = machine, at.points, v.points
    read: dict[str, float] = {}
    rates = {"omega1": m.omega * w.get("w.1", 1.0)}

    def rate(name: str, moved: complex, link: complex, mm: float, length: float) -> None:
        rates[name] = mm * mu.v / length * _sign(moved, link) * w.get(f"w.{name}", 1.0)

    if m.kind in ("slider", "rocker"):
        read["ab"], read["pb"] = hand.measure(V["b"] - V["a"]), hand.measure(V["b"])
        mm = read["pb"] if w.get("w.by pb") else read["ab"]
        rate("omega2", V["b"] - V["a"], P["B"] - P["A"], mm, m.AB)
        if m.kind == "rocker":
            rate("omega3", V["b"], P["B"] - P["C"], read["pb"], m.BC)
        return read, rates
    read["BA"] = hand.measure(P["A"] - P["B"])
    read["pa3"], read["aa3"] = hand.measure(V["a3"]), hand.measure(V["a3"] - V["a"])
    mm = hand.measure(V["a"]) if w.get("w.by pa") else read["pa3"]
    rate("omega3", V["a3"], P["A"] - P["B"], mm, read["BA"] * mu.l)
    rates["omega2"] = rates["omega3"]
    if m.CD:
        read["cd"] = hand.measure(V["d"] - V["c"])
        rate("omega4", V["d"] - V["c"], P["D"] - P["C"], read["cd"], m.CD)
    return read, rates


def accelerations(
    machine: Machine, mu: Factors, hand: Hand, at: Plan, v: Plan, read: dict[str, float], w: Knobs
) -> tuple[Plan, dict[str, float]]:
    """Draw the plan of accelerations, and return the angular ones too, 1/s²; ``read`` gets their lengths."""
    m, P = machine, at.points
    speed = {name: mm * mu.v for name, mm in read.items()}
    pa = m.omega**2 * m.OA / mu.a * w.get("a.pa", 1.0)
    a = hand.lay(0, P["A"] if w.get("a.out") else -P["A"], pa)
    points, laid = {"a": a}, {"πa": pa}
    if m.S1:
        points["s1"] = a * m.S1
    eps: dict[str, float] = {}
    if m.kind in ("slider", "rocker"):
        link = P["B"] - P["A"]
        n = (
            _normal(speed["pb"] if w.get("a.n by pb") else speed["ab"], m.AB, w)
            / mu.a
            * w.get("a.n", 1.0)
        )
        n2 = hand.lay(a, link if w.get("a.n end") else -link, n)
        t = link if w.get("a.t along") else link * RIGHT
        start, pole, other = (a if w.get("a.t from a") else n2), 0j, 1 + 0j
        laid["an2"] = n
        if m.kind == "rocker":
            arm = P["B"] - P["C"]
            n3 = _normal(speed["pb"], m.BC, w) / mu.a * w.get("a.n3", 1.0)
            laid["πn3"] = n3
            pole, other = hand.lay(0, arm if w.get("a.n3 end") else -arm, n3), arm * RIGHT
            points["n3"] = pole
        b = hand.meet(start, t, pole, other)
        points |= {"n2": n2, "b": b}
        tab = abs(b - a) if w.get("a.eps whole") else abs(b - start)
        read["n2b"] = hand.measure(b - n2)
        tab_mm = read["n2b"] if start == n2 and not w.get("a.eps whole") else hand.measure(tab)
        eps["epsilon2"] = tab_mm * mu.a / m.AB * _sign(b - start, link) * w.get("e.2", 1.0)
        if m.kind == "rocker":
            read["n3b"] = hand.measure(b - pole)
            whole = hand.measure(b) if w.get("a.eps whole") else read["n3b"]
            eps["epsilon3"] = whole * mu.a / m.BC * _sign(b - pole, arm) * w.get("e.3", 1.0)
        if m.S2:
            points["s2"] = a + (b - a) * w.get("a.s2", m.S2 / m.AB)
            read["πs2"], read["πb"] = hand.measure(points["s2"]), hand.measure(b)
        if m.E:
            points["e"] = _image(hand, a, b, m, w.get("a.e"))
        return Plan(points, laid), eps
    return _slotted(m, mu, hand, at, v, read, w, points, laid)


def _normal(speed: float, length: float, w: Knobs) -> float:
    """Return v²/l, m/s², or what was taken for it."""
    return {"v/l": speed / length, "v2": speed**2}.get(w.get("a.n law", ""), speed**2 / length)


def _slotted(
    m: Machine,
    mu: Factors,
    hand: Hand,
    at: Plan,
    v: Plan,
    read: dict[str, float],
    w: Knobs,
    points: dict[str, complex],
    laid: dict[str, float],
) -> tuple[Plan, dict[str, float]]:
    """Draw the accelerations of a stone in a slotted lever, and of the group behind it."""
    P, V, a = at.points, v.points, points["a"]
    link, length = P["A"] - P["B"], read["BA"] * mu.l
    turning = read["pa3"] * mu.v / length
    ak = w.get("a.k", 2.0) * turning * read["aa3"] * mu.v / mu.a
    sense = _sign(V["a3"], link)
    way = (V["a"] - V["a3"]) * RIGHT * sense
    way = way / RIGHT if w.get("a.k along") else way
    k2 = hand.lay(a, way if w.get("a.k sense") else -way, ak) if abs(way) > 0.3 else a
    n = _normal(read["pa3"] * mu.v, length, w) / mu.a * w.get("a.n3", 1.0)
    n3 = hand.lay(0, link if w.get("a.n3 end") else -link, n)
    a3 = hand.meet(a if w.get("a.r from a") else k2, link, n3, link * RIGHT)
    ratio = m.BC / length * w.get("a.pc", 1.0)
    c = hand.lay(0, a3, abs(a3) * ratio)
    laid |= {"ak2": ak, "πn3": n}
    points |= {"k2": k2, "n3": n3, "a3": a3, "c": c}
    read["n3a3"] = hand.measure(a3 - n3)
    t = hand.measure(a3) if w.get("a.eps whole") else read["n3a3"]
    e3 = t * mu.a / length * _sign(a3 - n3, link) * w.get("e.3", 1.0)
    eps = {"epsilon2": e3, "epsilon3": e3}
    if m.S3:
        points["s3"] = c
        read["πs1"], read["πs3"] = hand.measure(points["s1"]), hand.measure(c)
    if m.CD:
        arm = P["D"] - P["C"]
        n4mm = _normal(read["cd"] * mu.v, m.CD, w) / mu.a * w.get("a.n4", 1.0)
        n4 = hand.lay(c, arm if w.get("a.n4 end") else -arm, n4mm)
        d = hand.meet(n4, arm if w.get("a.t4 along") else arm * RIGHT, 0, 1)
        laid["cn4"] = n4mm
        points |= {"n4": n4, "d": d}
        read["πd"] = hand.measure(d)
        read["n4d"] = hand.measure(d - n4)
        eps["epsilon4"] = read["n4d"] * mu.a / m.CD * _sign(d - n4, arm) * w.get("e.4", 1.0)
    return Plan(points, laid), eps


def draw(machine: Machine, mu: Factors, hand: Hand, k: int, w: Knobs) -> Position:
    """Draw all plans of a position."""
    at = places(machine, mu, hand, k + w.get("p.k", 0), w)
    v_at = places(machine, mu, hand, k + w["v.k"], w) if "v.k" in w else at
    v = velocities(machine, mu, hand, v_at, w)
    read, rates = calculated(machine, mu, hand, at, v, w)
    if k not in machine.at:
        return Position(at, v, None, read, rates)
    used = dict(read)
    if "a.n before" in w:
        before = velocities(machine, mu, hand, places(machine, mu, hand, k - 1, w), w)
        used |= calculated(machine, mu, hand, at, before, w)[0] | {"BA": read.get("BA", 0.0)}
    a_at = places(machine, mu, hand, k + w["a.k from"], w) if "a.k from" in w else at
    acc, eps = accelerations(machine, mu, hand, a_at, v, used, w)
    return Position(at, v, acc, used | read, rates | eps)

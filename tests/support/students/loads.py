"""Forces by a student: loads, the group of rod and slider, its polygon, the crank, Zhukovsky's lever.

A force is what it is (its amount, N) and which way it points; moments are taken counter-clockwise positive.
"""

from __future__ import annotations

import numpy as np

from support.another_hand import met
from support.students.drawing import Student
from support.students.machines import CALCULATED, CRANK, slider_crank_plans
from support.students.records import A, F, Machine, P, V

G = 9.81


def cross(a: complex, b: complex) -> float:
    return (a.conjugate() * b).imag


def _told(s: Student, name: str, amount: float, unit: str = "N") -> float:
    s.page.rates[F, name] = amount
    s.page.units[F, name] = unit
    return amount


def _weight(s: Student, name: str, mass: str) -> float:
    take = s.take(F, name, "weight", mass=mass, factor=1.0, g=G, sense=1.0)
    return take["sense"] * _told(s, name, take["factor"] * s.given[take["mass"]] * take["g"])


def _inertia(s: Student, name: str, mass: str, of: str, end: str) -> complex:
    """Return the force of inertia of a link: m·a against the acceleration."""
    take = s.take(F, name, "inertia", mass=mass, of=of, sense=-1.0, factor=1.0, mu=A, end=end)
    length = s.page.lengths[A, take["of"]]
    amount = take["factor"] * s.given[take["mass"]] * length * s.mu[take["mu"]]
    _told(s, name, amount)
    along = s.at(A, take["end"])
    return take["sense"] * amount * s.ray(name, along)


def _moment(s: Student, name: str, force: complex, at: str, about: str) -> float:
    """Return the moment of a force by its arm, which is measured."""
    take = s.take(F, name, "arm", at=at, about=about, sense=1.0, factor=1.0, left=False)
    if take["left"] or not abs(force):
        return 0.0
    way = force / abs(force)
    arm = cross(s.at(P, take["at"]) - s.at(P, take["about"]), way)
    arm = s.signed(f"arm {name}", arm)
    return float(take["sense"] * take["factor"] * abs(force) * arm * s.mu[P])


def forces(s: Student) -> None:
    """Draw the plans, and the forces where accelerations are drawn."""
    slider_crank_plans(s, accelerated=s.accelerated)
    if not s.accelerated:
        return
    g2, g3 = _weight(s, "G2", "m2") * -1j, _weight(s, "G3", "m3") * -1j
    p2 = _inertia(s, "Pi2", "m2", "πs2", "s2")
    p3 = _inertia(s, "Pi3", "m3", "πb", "b")
    take = s.take(F, "Mi2", "couple", J="J2", of="epsilon2", sense=-1.0, factor=1.0)
    rate = {name: number for (_, name), number in s.page.rates.items()}[take["of"]]
    m2 = _told(s, "Mi2", take["factor"] * take["sense"] * s.given[take["J"]] * rate, "N*m")
    take = s.take(F, "F3", "load", sense=-1.0, force="F")
    against = np.sign((s.at(V, "b") * take["sense"]).real) or 1.0
    f3 = complex(against * _told(s, "F3", s.given[take["force"]]))
    r12 = _group(s, {"G2": g2, "Pi2": p2, "G3": g3, "Pi3": p3, "F3": f3}, m2)
    _crank(s, r12)
    _lever(s, {"G2": g2, "Pi2": p2, "G3": g3, "Pi3": p3, "F3": f3}, m2)


def _group(s: Student, of: dict[str, complex], couple: float) -> complex:
    """Find the reactions of the rod and the slider; return the crank's force on the rod."""
    moment = sum(_moment(s, f"M {name}", of[name], "S2", "B") for name in ("G2", "Pi2"))
    take = s.take(F, "M_sum", "sum", couple=1.0, factor=1.0)
    moment = take["factor"] * moment + take["couple"] * couple
    take = s.take(F, "R12t", "tangential", link="AB", sense=1.0, factor=1.0, mu=P)
    link = s.length(take["link"]) * s.mu[take["mu"]]
    # the arm of A about B is AB: R·(A − B)×(the square to AB) = −moment
    square = s.way(("square", "AB"))
    tangential = take["sense"] * take["factor"] * moment / link
    at = tangential * s.ray("R12t", square) / s.mu[F]
    chain = [0j, at]
    for name, force in of.items():
        take = s.take(F, f"y {name}", "link of polygon", sense=1.0, left=False, mu=F)
        way = 0j if take["left"] else take["sense"] * force / s.mu[take["mu"]]
        turned = s.ray(f"y {name}", way) * s.opened(abs(way)) if way else 0j
        chain.append(chain[-1] + turned)
    take = s.take(F, "R12n", "ray of polygon", way=("along", "AB"), ago=0)
    along = s.ray("R12n", s.way(take["way"], take["ago"]))
    take = s.take(F, "R03", "ray of polygon", way=("square", "x"), ago=0)
    guide = s.ray("R03", s.way(take["way"], take["ago"]))
    parallel = abs(cross(along, guide)) < 1e-3
    corner = complex(np.nan, np.nan) if parallel else met(0j, along, chain[-1], guide)
    # R12 closes from the corner to the end of its tangential component
    for name, start, end in (
        ("R12", corner, chain[1]), ("R03", chain[-1], corner), ("R23", corner, chain[3]),
    ):  # fmt: skip
        _reaction(s, name, end - start)
    return (chain[1] - corner) / abs(chain[1] - corner) * s.page.lengths[F, "R12"] * s.mu[F]


def _reaction(s: Student, name: str, way: complex) -> None:
    s.page.write(F, name, s.ruled(f"{F} {name}", abs(way)))


def _crank(s: Student, r12: complex) -> None:
    """Balance the crank by a force at its pin, square to it."""
    take = s.take(F, "R21", "reaction", sense=-1.0)
    r21 = take["sense"] * r12
    moment = _moment(s, "M R21", r21, "A", "O")
    take = s.take(F, "P_bal_forces", "balance", link="OA", factor=1.0, sense=-1.0)
    force = take["factor"] * take["sense"] * moment / (s.given[take["link"]] * s.mu[P])
    _told(s, "P_bal_forces", force)
    held = r21 + force * s.ray("P_b", s.way(("square", "OA")))
    _reaction(s, "R01", held / s.mu[F])


def _lever(s: Student, of: dict[str, complex], couple: float) -> None:
    """Balance the plan of velocities, turned by 90°, as a lever about its pole."""
    total = 0.0
    for name, force in of.items():
        take = s.take(F, f"lever {name}", "arm of the lever", at="s2" if name[-1] == "2" else "b",
                      turn=1.0, sense=1.0, left=False)  # fmt: skip
        if take["left"]:
            continue
        velocity = s.at(V, take["at"]) * np.exp(1j * np.pi / 2 * take["turn"])
        # twice as large on the lever
        arm = s.signed(f"lever {name}", 2 * cross(velocity, force / abs(force))) / 2
        total += take["sense"] * abs(force) * arm
    take = s.take(F, "lever Mi2", "couple on the lever", sense=1.0, factor=1.0, of="ab", link="AB")
    ratio = s.page.lengths[V, take["of"]] / (s.length(take["link"]) * s.mu[P])
    # turned by 90° a vector's moment is minus its power
    turn = s.turns(V, "a", "b", ("square", "AB"))
    total -= take["sense"] * take["factor"] * couple * turn * ratio
    pa = s.page.lengths[V, "pa"]
    _told(s, "P_bal_lever", total / pa)


FORCED = Machine(
    {P: 0.002, V: 0.025, A: 0.5, F: 4.0},
    {**CRANK, "m2": 3.0, "m3": 5.0, "J2": 0.2, "F": 400.0},
    (1, 3, 5), forces, CALCULATED, ("OA", "AB"),
)  # fmt: skip

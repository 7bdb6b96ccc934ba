"""Four mechanisms as a student's steps: those of `another_hand`, told so that every operand can be mistaken."""

from __future__ import annotations

from support.students.drawing import Student
from support.students.records import A, Machine, P, V


def slider_crank_plans(s: Student, *, accelerated: bool = True) -> None:
    """Draw positions, velocities and accelerations of an in-line crank and slider."""
    share = s.given["AS2"] / s.given["AB"]
    s.crank("A", "OA")
    s.slide("B", "AB", 0.0, 1)
    s.place("S2", "A", "B", share)
    pa = s.crank_speed("pa", "OA")
    s.lay(V, "a", "pa", pa, "p", ("square", "OA"), 1.0)
    s.meet(V, "b", ("ab", "a", ("square", "AB")), ("pb", "p", ("along", "x")))
    s.image(V, "s2", "a", "b", share)
    s.read(V, "ab", "a", "b")
    s.read(V, "pb", "p", "b")
    s.read(V, "ps2", "p", "s2")
    s.rate(V, "omega2", "ab", "AB", s.turns(V, "a", "b", ("square", "AB")))
    if not accelerated:
        return
    s.lay(A, "a", "πa", s.crank_acceleration("πa", "OA"), "π", ("along", "OA"), -1.0)
    n = s.normal("an2", "ab", "AB")
    s.lay(A, "n2", "an2", n, "a", ("along", "AB"), -1.0)
    s.meet(A, "b", ("n2b", "n2", ("square", "AB")), ("πb", "π", ("along", "x")))
    s.image(A, "s2", "a", "b", share)
    s.read(A, "n2b", "n2", "b")
    s.read(A, "πb", "π", "b")
    s.read(A, "πs2", "π", "s2")
    s.rate(A, "epsilon2", "n2b", "AB", s.turns(A, "n2", "b", ("square", "AB")))


def slider_crank(s: Student) -> None:
    slider_crank_plans(s, accelerated=s.accelerated)


def four_bar(s: Student) -> None:
    shape = complex(s.given["AE"] / s.given["AB"])
    s.crank("A", "OA")
    s.swing("B", "AB", "CB", 1)
    s.place("E", "A", "B", shape)
    s.lay(V, "a", "pa", s.crank_speed("pa", "OA"), "p", ("square", "OA"), 1.0)
    s.meet(V, "b", ("ab", "a", ("square", "AB")), ("pb", "p", ("square", "CB")))
    s.image(V, "e", "a", "b", shape)
    s.read(V, "ab", "a", "b")
    s.read(V, "pb", "p", "b")
    s.read(V, "pe", "p", "e")
    s.rate(V, "omega2", "ab", "AB", s.turns(V, "a", "b", ("square", "AB")))
    s.rate(V, "omega3", "pb", "CB", s.turns(V, "p", "b", ("square", "CB")))
    if not s.accelerated:
        return
    s.lay(A, "a", "πa", s.crank_acceleration("πa", "OA"), "π", ("along", "OA"), -1.0)
    n, m = s.normal("an2", "ab", "AB"), s.normal("πn3", "pb", "CB")
    s.lay(A, "n2", "an2", n, "a", ("along", "AB"), -1.0)
    s.lay(A, "n3", "πn3", m, "π", ("along", "CB"), -1.0)
    s.meet(A, "b", ("n2b", "n2", ("square", "AB")), ("n3b", "n3", ("square", "CB")))
    s.image(A, "e", "a", "b", shape)
    s.read(A, "n2b", "n2", "b")
    s.read(A, "n3b", "n3", "b")
    s.read(A, "πb", "π", "b")
    s.read(A, "πe", "π", "e")
    s.rate(A, "epsilon2", "n2b", "AB", s.turns(A, "n2", "b", ("square", "AB")))
    s.rate(A, "epsilon3", "n3b", "CB", s.turns(A, "n3", "b", ("square", "CB")))


def slotted_plans(s: Student, arm: float) -> None:
    """Draw a crank that drives a rocker by a stone; C on the rocker, ``arm`` from its pivot."""
    s.crank("A", "OA")
    s.read(P, "BA", "B", "A")
    long = abs(s.vector(P, "BA"))
    s.place("C", "B", "A", arm / long)
    s.lay(V, "a", "pa", s.crank_speed("pa", "OA"), "p", ("square", "OA"), 1.0)
    s.meet(V, "a3", ("aa3", "a", ("along", "BA")), ("pa3", "p", ("square", "BA")))
    s.image(V, "c", "p", "a3", arm / long)
    s.read(V, "aa3", "a", "a3")
    s.read(V, "pa3", "p", "a3")
    s.read(V, "pc", "p", "c")
    turn = s.turns(V, "p", "a3", ("square", "BA"))
    s.rate(V, "omega3", "pa3", "BA", turn)
    s.page.rates[V, "omega2"] = s.page.rates[V, "omega3"]
    if not s.accelerated:
        return
    slides = s.turns(V, "a", "a3", ("along", "BA"))
    s.lay(A, "a", "πa", s.crank_acceleration("πa", "OA"), "π", ("along", "OA"), -1.0)
    k, n = s.coriolis("ak2", "aa3", "omega3"), s.normal("πn3", "pa3", "BA")
    s.lay(A, "k2", "ak2", k, "a", ("square", "BA"), slides * turn)
    s.lay(A, "n3", "πn3", n, "π", ("along", "BA"), -1.0)
    s.meet(A, "a3", ("k2a3", "k2", ("along", "BA")), ("n3a3", "n3", ("square", "BA")))
    s.image(A, "c", "π", "a3", arm / long)
    s.read(A, "k2a3", "k2", "a3")
    s.read(A, "n3a3", "n3", "a3")
    s.read(A, "πc", "π", "c")
    s.rate(A, "epsilon3", "n3a3", "BA", s.turns(A, "n3", "a3", ("square", "BA")))
    s.page.rates[A, "epsilon2"] = s.page.rates[A, "epsilon3"]


def slotted_lever(s: Student) -> None:
    slotted_plans(s, s.given["BC"])


def six_bar(s: Student) -> None:
    slotted_plans(s, -s.given["BC"])
    s.slide("D", "CD", -170.0, 1)
    s.meet(V, "d", ("cd", "c", ("square", "CD")), ("pd", "p", ("along", "x")))
    s.read(V, "cd", "c", "d")
    s.read(V, "pd", "p", "d")
    s.rate(V, "omega4", "cd", "CD", s.turns(V, "c", "d", ("square", "CD")))
    if not s.accelerated:
        return
    n = s.normal("cn4", "cd", "CD")
    s.lay(A, "n4", "cn4", n, "c", ("along", "CD"), -1.0)
    s.meet(A, "d", ("n4d", "n4", ("square", "CD")), ("πd", "π", ("along", "x")))
    s.read(A, "n4d", "n4", "d")
    s.read(A, "πd", "π", "d")
    s.rate(A, "epsilon4", "n4d", "CD", s.turns(A, "n4", "d", ("square", "CD")))


CRANK = {"OA": 50.0, "AB": 175.0, "AS2": 70.0, "omega": 20.0}
CALCULATED = frozenset({"pa", "πa", "an2", "πn3", "ak2", "cn4"})
MACHINES = {
    "sc": Machine(
        {P: 0.002, V: 0.025, A: 0.5}, CRANK, (1, 3, 5), slider_crank, CALCULATED, ("OA", "AB")
    ),
    "fb": Machine(
        {P: 0.002, V: 0.015, A: 0.25},
        {"OA": 40.0, "AB": 130.0, "CB": 90.0, "AE": 75.0 + 50.0j, "C": 150.0, "omega": 15.0},
        (1, 3, 6), four_bar, CALCULATED, ("OA", "AB", "CB"),
    ),
    "rpr": Machine(
        {P: 0.004, V: 0.02, A: 0.2},
        {"OA": 30.0, "BC": 162.5, "B": -100.0j, "omega": 10.0},
        (1, 3, 6), slotted_lever, CALCULATED, ("OA", "BC", "BA"),
    ),
    "six": Machine(
        {P: 0.004, V: 0.04, A: 1.0},
        {"OA": 27.5, "BC": 50.0, "CD": 55.0, "B": -112.5j, "omega": 30.0},
        (1, 3, 6), six_bar, CALCULATED, ("OA", "BC", "CD", "BA"),
    ),
}  # fmt: skip

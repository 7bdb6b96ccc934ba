"""The search for tooth numbers against brute force; C7's train; which condition leaves none."""

from __future__ import annotations

import itertools
import random
from dataclasses import replace
from fractions import Fraction as F

import numpy as np
import pytest
from support import train_oracle as oracle
from support.turns import in_turn

from graphic_tmm.chapters.trains.task import Limits, PlanetaryTask
from graphic_tmm.chapters.trains.tooth_search import Solutions, choose, search
from graphic_tmm.errors import StructureError

C7 = PlanetaryTask("ring", 0.008, 302.0, ratio=4.55, tolerance=0.003, teeth=(25, None, None))
SMALL = Limits(least=17, most=26, ring_most=80)
ORDERS = [
    PlanetaryTask("ring", 0.005, 1.0, ratio=4.55, tolerance=0.02, satellites=(2, 3, 4),
                   limits=Limits(most=60, ring_most=140)),
    PlanetaryTask("ring", 0.005, 1.0, ratio=0.3, driving="H", tolerance=0.1, satellites=(5, 3),
                   limits=Limits(most=60, ring_most=140)),
    PlanetaryTask("external-internal", 0.005, 1.0, ratio=4.0, tolerance=0.05, satellites=(3, 4), limits=SMALL),
    PlanetaryTask("external-internal", 0.005, 1.0, ratio=4.0, tolerance=0.2, satellites=(2, 3), limits=SMALL,
                   module_2=0.004),
    PlanetaryTask("external-external", 0.005, 1.0, ratio=-0.4, tolerance=0.3, satellites=(2, 3), limits=SMALL),
    PlanetaryTask("external-external", 0.005, 1.0, ratio=12.0, driving="H", tolerance=0.3, satellites=(3, 1),
                   limits=SMALL),
    PlanetaryTask("external-external", 0.004, 1.0, ratio=0.3, tolerance=0.5, satellites=(3,), module_2=0.005,
                   limits=replace(SMALL, least=15)),
    PlanetaryTask("internal-internal", 0.005, 1.0, ratio=-10.0, driving="H", tolerance=0.5, satellites=(2, 3),
                   limits=replace(SMALL, ring_most=60)),
    PlanetaryTask("internal-internal", 0.005, 1.0, ratio=0.06, tolerance=0.5, satellites=(1, 2),
                   limits=replace(SMALL, most=24, ring_most=52)),
]  # fmt: skip


def listed(found: Solutions, scheme: str) -> list[tuple[oracle.Four, int]]:
    rows = [tuple(int(z) for z in row) for row in found.teeth]
    ks = [int(k) for k in found.satellites]
    return [(oracle.four(scheme, row), k) for row, k in zip(rows, ks, strict=True)]


@pytest.mark.slow
@pytest.mark.parametrize("order", ORDERS, ids=lambda o: f"{o.scheme} {o.ratio}")
def test_the_search_finds_what_brute_force_finds(order: PlanetaryTask) -> None:
    found = search(order)
    rows = listed(found, order.scheme)
    due = oracle.brute_force(order)
    assert len(rows) == len(set(rows))
    assert set(rows) == due
    assert len(due) >= 2, "an order that proves something"


@pytest.mark.parametrize("order", ORDERS, ids=lambda o: f"{o.scheme} {o.ratio}")
def test_solutions_are_ranked_by_size_and_always_in_the_same_order(order: PlanetaryTask) -> None:
    found = search(order)
    q = F(1) if order.module_2 is None else F(order.module_2 / order.module).limit_denominator(100)
    spans = [float(oracle.span(order, z, q)) * order.module for z, _ in listed(found, order.scheme)]
    np.testing.assert_allclose(found.size, spans, rtol=1e-12)
    assert (np.diff(found.size) >= -1e-12).all()
    again = search(replace(order, satellites=order.satellites[::-1]))
    np.testing.assert_array_equal(found.teeth, again.teeth)
    np.testing.assert_array_equal(found.satellites, again.satellites)
    for (z, _), u in zip(listed(found, order.scheme), found.ratio, strict=True):
        due = oracle.ratio(order.scheme, z, order.driving, q)
        assert due is not None
        assert oracle.is_close(u, float(due))


def test_the_train_of_the_windrower_is_found() -> None:
    found = search(C7)
    assert found.teeth.tolist() == [[25, 32, 89]]
    assert found.ratio[0] == pytest.approx(4.56, rel=1e-15)
    assert choose(C7).teeth == (25, 32, 89)
    free = search(replace(C7, teeth=()))
    assert [25, 32, 89] in free.teeth.tolist()
    assert free.size[0] <= free.size[free.teeth.tolist().index([25, 32, 89])]


def test_a_tooth_number_given_is_kept() -> None:
    free = search(replace(C7, teeth=(), tolerance=0.02))
    for place in range(3):
        z = int(free.teeth[7, place])
        kept = replace(C7, tolerance=0.02, teeth=tuple(z if i == place else None for i in range(3)))
        due = free.teeth[free.teeth[:, place] == z]
        np.testing.assert_array_equal(search(kept).teeth, due)
    order = replace(ORDERS[2], limits=Limits(most=60, ring_most=160))
    free = search(order)
    for place in range(4):
        z = int(free.teeth[5, place])
        kept = replace(order, teeth=tuple(z if i == place else None for i in range(4)))
        np.testing.assert_array_equal(search(kept).teeth, free.teeth[free.teeth[:, place] == z])


def test_the_condition_that_leaves_none_is_told() -> None:
    for change, says in (
        (
            {"satellites": (4,)},
            r"z1 = 25: of 1 left till then, the satellites cannot be put in evenly",
        ),
        ({"satellites": (9,)}, r"neighbouring satellites touch: take fewer"),
        ({"tolerance": 0.001}, r"U_1H = 4.55 within 0.1 %, z1 = 25: none reaches the ratio"),
        ({"ratio": 0.5}, r"take another scheme"),
        ({"limits": Limits(least=26)}, r"all are undercut: allow a lesser number"),
    ):
        assert len(search(replace(C7, **change))) == 0  # type: ignore[arg-type]
        with pytest.raises(StructureError, match=says):
            choose(replace(C7, **change))  # type: ignore[arg-type]


def test_tooth_numbers_given_are_checked() -> None:
    whole = replace(C7, teeth=(25, 32, 89))
    assert choose(whole).satellites == 3
    assert choose(replace(whole, satellites=(4, 3))).satellites == 3
    assert choose(replace(whole, satellites=(4,))).satellites == 4
    with pytest.raises(StructureError, match=r"coaxial: 25 \+ 31 = 56, 89 − 31 = 58"):
        choose(replace(whole, teeth=(25, 31, 89)))
    assert choose(replace(whole, ratio=None)).teeth == (25, 32, 89)
    with pytest.raises(StructureError, match="no ratio is wanted"):
        search(replace(whole, ratio=None))


@pytest.mark.parametrize("scheme", oracle.SENSES)
def test_blocks_that_mesh_everywhere_are_those_the_formula_lets_in(scheme: str) -> None:
    """(z1·z3 ± z2·z4)/(k·gcd) is whole just where turns of the block, tried one by one, mesh."""
    from graphic_tmm.chapters.trains.task import SCHEMES
    from graphic_tmm.chapters.trains.tooth_conditions import assembles, in_two_rows

    draw, seen = random.Random(6), {True: 0, False: 0}
    for _ in range(400):
        z = [draw.randint(5, 24) for _ in range(4)]
        if scheme == "ring":
            z = [z[0], z[1], z[0] + 2 * z[1]]
        k = draw.randint(1, 7)
        due = oracle.phases(scheme, oracle.four(scheme, tuple(z)), k)
        found = bool(assembles(SCHEMES[scheme], in_two_rows(SCHEMES[scheme], z), k)[0])
        assert found == due, (z, k)
        seen[due] += 1
    assert min(seen.values()) > 40


def test_wide_searches_find_many() -> None:
    orders = [
        replace(ORDERS[2], ratio=12.0, tolerance=0.01, limits=Limits()),
        replace(ORDERS[5], ratio=60.0, tolerance=0.01, limits=Limits()),
        replace(ORDERS[7], ratio=-40.0, tolerance=0.01, limits=Limits()),
    ]
    for order in orders:
        assert len(search(order)) > 10


@pytest.mark.slow
def test_every_neighbour_that_only_touches_is_refused() -> None:
    """k = 2 and 6 are the only numbers at which tips may touch exactly."""
    from graphic_tmm.chapters.trains.task import SCHEMES
    from graphic_tmm.chapters.trains.tooth_conditions import in_two_rows, neighbours

    some = (2, 6, *in_turn((3, 4, 5, 7), 1))
    for z1, z2 in itertools.product(range(10, 60), repeat=2):
        for k in some:
            ring = (z1, z2, z1 + 2 * z2)
            found = neighbours(SCHEMES["ring"], in_two_rows(SCHEMES["ring"], ring), k, F(1), 1.0)
            assert bool(found[0]) == oracle.apart("ring", oracle.four("ring", ring), F(1), k, 1.0)

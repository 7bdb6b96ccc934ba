"""The shaking force and its moment against vector loops, Newton and Euler; its maxima, what is refused."""

from __future__ import annotations

import math
import random
import re
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from support.dynamics import statics
from support.shaken import (
    Put,
    counterweight_text,
    drawn,
    four_bar_text,
    masses_of,
    shaken,
    slider_crank_text,
    states,
    vectors,
    with_weights,
)

from graphic_tmm.chapters.balance.plan import BALANCE_PLAN
from graphic_tmm.chapters.balance.table import balance_results
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import single
from graphic_tmm.errors import StructureError
from graphic_tmm.fitting.choice import choices
from graphic_tmm.readers.findings import warnings

EXACT = 1e-9
TEXTS = (four_bar_text, slider_crank_text)


@pytest.mark.parametrize("text", TEXTS)
def test_force_and_moment_are_those_of_vector_loops(
    text: Callable[[random.Random], str], tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    for seed in range(many(40, 6)):
        pick = random.Random(seed)
        body = text(pick)
        rod = next(iter(drawn(tmp_path, f"{body}[balance]\n").scene.mechanism.links[1:]))
        puts = [
            Put(
                1, pick.uniform(0.2, 2.0), complex(pick.uniform(-0.1, 0.1), pick.uniform(-0.1, 0.1))
            ),
            Put(
                2, pick.uniform(0.2, 2.0), complex(pick.uniform(-0.1, 0.1), pick.uniform(-0.1, 0.1))
            ),
        ]
        assert rod.number == 2
        told = "".join(counterweight_text(one, 1.0 + 0j) for one in puts)
        about = pick.choice("OC") if text is four_bar_text else "O"
        made = drawn(tmp_path, f'{body}{told}[balance]\nabout = "{about}"\n')
        balance, mechanism = BALANCE_PLAN.on(made), KINEMATICS_PLAN.on(made).mechanism
        bare, weighted = balance.wholes
        links = masses_of(mechanism)
        for whole, put in ((bare, links), (weighted, [*links, *puts])):
            forces, moments = vectors(made, whole)
            due = [shaken(state, put, about) for state in states(made)]
            largest = max(abs(force) for force, _ in due)
            reach = max(abs(turning) for _, turning in due)
            for k, (force, turning) in enumerate(due):
                assert abs(forces[k] - force) < EXACT * largest, (seed, k)
                assert abs(moments[k] - turning) < EXACT * reach, (seed, k)
        results = single(balance_results(made))
        first = [shaken(state, links, about) for state in states(made)]
        assert results["shaking_max"][0] == pytest.approx(max(abs(f) for f, _ in first), rel=1e-8)
        assert results["shaking_moment"][0] == pytest.approx(
            max(abs(m) for _, m in first), rel=1e-8
        )
        both = results["shaking_max"][0], results["shaking_max_balanced"][0]
        share = 100.0 * (1.0 - both[1] / both[0])
        assert results["shaking_removed"][0] == pytest.approx(share, abs=0.06)


@pytest.mark.parametrize("text", TEXTS)
def test_frame_bears_weights_and_shaking_force(
    text: Callable[[random.Random], str], tmp_path: Path
) -> None:
    for seed in range(3):
        pick = random.Random(100 + seed)
        put = Put(1, 1.3, complex(-0.06, 0.01))
        made = drawn(tmp_path, f"{text(pick)}{counterweight_text(put, 1.0 + 0j)}[balance]\n")
        mechanism = with_weights(KINEMATICS_PLAN.on(made).mechanism, [put])
        weighted = BALANCE_PLAN.on(made).weighted
        assert weighted is not None
        forces, _ = vectors(made, weighted)
        frame, at = mechanism.frame.number, {"x": "B"} if text is slider_crank_text else {}
        weight = sum(link.mass or 0.0 for link in mechanism.links) * 9.81
        for force, state in zip(forces, states(made), strict=True):
            found = statics(
                mechanism,
                replace(state, mechanism=mechanism),
                [],
                gravity=True,
                inertia=True,
                balance="moment",
                at=at,
            )
            borne = sum(r for (_, j), r in found.reactions.items() if j == frame)
            assert abs(borne + 1j * weight - force) < EXACT * (abs(forces).max() + weight)


def test_no_mass_that_moves_is_refused(tmp_path: Path) -> None:
    body = four_bar_text(random.Random(1))
    bare = "\n".join(line for line in body.splitlines() if "mass" not in line and "J =" not in line)
    with pytest.raises(StructureError, match="no mass moves"):
        drawn(tmp_path, f"{bare}\n[balance]\n")


def test_a_mechanism_at_rest_is_refused_by_its_key(tmp_path: Path) -> None:
    body = re.sub(r"speed = .*", "speed = 0", four_bar_text(random.Random(1)))
    body = re.sub(r"acceleration = .*", "", body)
    with pytest.raises(StructureError, match=r"link 1 stands still: leave \[balance\] out"):
        drawn(tmp_path, f"{body}[balance]\n")


def test_positions_that_cannot_be_drawn_leave_no_largest(tmp_path: Path) -> None:
    """A crank too long for its rod: what is there is told, no maximum of a row that has gaps."""
    body = slider_crank_text(random.Random(3))
    rod = re.search(r"B = \[([\d.]+), 0.0\]", body)
    assert rod is not None
    made = drawn(tmp_path, f"{body.replace(rod[1], str(0.6 * float(rod[1]) / 3.0))}[balance]\n")
    bare, count = BALANCE_PLAN.on(made).bare, len(made.names)
    there = np.isfinite(np.broadcast_to(made.reading[bare.value][0], (count,)))
    assert there.any()
    assert not there.all()
    results = single(balance_results(made))
    assert math.isnan(results["shaking_max"][0])
    assert math.isnan(results["shaking_moment"][0])
    far = made.construction.step(bare.top)
    assert far is not None
    assert far.uses[1] in {one.step.it for one in made.findings()}


def test_the_scale_of_the_diagram_is_by_its_width_not_by_its_largest_force(tmp_path: Path) -> None:
    made = drawn(tmp_path, four_bar_text(random.Random(1)) + "[balance]\n")
    found = {mark.letter: value for mark, value in choices(made).given.items()}
    ends = [0j, *vectors(made, BALANCE_PLAN.on(made).wholes[0])[0]]
    assert found["B_{Φ}"] == pytest.approx(max(np.ptp(np.real(ends)), np.ptp(np.imag(ends))))
    assert "Φ_{max}" not in found
    assert found["B_{Φ}"] > 1.05 * max(map(abs, ends))


def test_links_that_have_half_of_what_shakes_are_told(tmp_path: Path) -> None:
    text = four_bar_text(random.Random(1)) + "[balance]\n"
    assert not any(
        "no mass" in one or "no J" in one for one in warnings(drawn(tmp_path, text), "en")
    )
    for key, due in (("mass", "but no mass"), ("J", "but no J")):
        head, link, rest = text.partition("number = 3\n")
        bare = head + link + re.sub(rf"^{key} = .*\n", "", rest, count=1, flags=re.MULTILINE)
        (line,) = (one for one in warnings(drawn(tmp_path, bare), "en") if due in one)
        assert "link 3" in line

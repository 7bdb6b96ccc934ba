"""Symmetries: a scene mirrored, scaled, run backward, with its links in another order."""

from __future__ import annotations

import random
import re
from dataclasses import replace
from typing import Any

import numpy as np
import pytest
from support.command import invoke
from support.drawn import board
from support.gallery import NAMES
from support.hard_mechanisms import Frame, put
from support.mechanisms import sample
from support.scenes import source, written

from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.scene.read import read
from graphic_tmm.studio import sheet_files

DRAWN = sample(40, seed=77)
OFFS = (0.0, 0.5, -0.25)


def _read(mechanism: Mechanism, phi: float, mu: float = 1.0) -> dict[str, dict[Any, Any]]:
    sheet = board(mechanism, mu=(mu, mu, mu))
    return {
        k: {n: np.ravel(v)[0] for n, v in row.items()} for k, row in sheet.read([[phi]]).items()
    }


def _equal(found: Any, due: Any) -> bool:
    return bool(found == due or (np.isnan(found) and np.isnan(due)))


@pytest.mark.slow
@pytest.mark.parametrize("k", range(0, len(DRAWN), 10))
def test_a_mirrored_mechanism_is_drawn_mirrored_to_the_last_bit(k: int) -> None:
    for drawn in DRAWN[k : k + 10]:
        for off in OFFS:
            first = _read(drawn.mechanism, drawn.phi + off)
            mirrored = put(drawn.mechanism, Frame(mirrored=True))
            second = _read(mirrored, -(drawn.phi + off))
            for plan in "rva":
                for key, value in first[plan].items():
                    found = complex(second[plan][key])
                    assert _equal(found, complex(value).conjugate()), (plan, key, drawn.kinds)
            for rate in ("omega", "epsilon"):
                for number, value in first[rate].items():
                    assert _equal(second[rate][number], -value), (rate, number, drawn.kinds)


@pytest.mark.parametrize("k", range(0, len(DRAWN), 10))
def test_a_crank_run_backward_reverses_velocities_and_keeps_accelerations(k: int) -> None:
    for drawn in DRAWN[k : k + 10]:
        one = drawn.mechanism
        back = replace(one, drive=replace(one.drive, speed=-one.drive.speed))
        first, second = _read(one, drawn.phi), _read(back, drawn.phi)
        for plan, sign in (("r", 1), ("v", -1), ("omega", -1), ("a", 1), ("epsilon", 1)):
            for key, value in first[plan].items():
                assert _equal(second[plan][key], sign * value), (plan, key, drawn.kinds)


@pytest.mark.slow
@pytest.mark.parametrize("power", [-20, -3, 1, 20])
def test_a_scaled_mechanism_is_the_same_drawing(power: int) -> None:
    """A power of two, and μ with it: nothing is rounded otherwise, so every millimetre is the same."""
    for drawn in DRAWN:
        scale = 2.0**power
        first = _read(drawn.mechanism, drawn.phi)
        second = _read(put(drawn.mechanism, Frame(scale)), drawn.phi, scale)
        for plan in "rva":
            for key, value in first[plan].items():
                assert _equal(second[plan][key], value * scale), (plan, key, drawn.kinds)
        for rate in ("omega", "epsilon"):
            for number, value in first[rate].items():
                assert _equal(second[rate][number], value), (rate, number, drawn.kinds)


@pytest.mark.slow
@pytest.mark.parametrize("turn", [90.0, 180.0, -90.0])
def test_a_mechanism_turned_by_right_angles_is_turned(turn: float) -> None:
    """The direction of a guide is rounded after it is turned: equal within rounding, not to the bit."""
    for drawn in DRAWN:
        first = _read(drawn.mechanism, drawn.phi)
        second = _read(put(drawn.mechanism, Frame(turn=turn)), drawn.phi + turn)
        way = 1j ** int(turn // 90 % 4)
        for plan in "rva":
            top = max(abs(value) for value in first[plan].values())
            for key, value in first[plan].items():
                assert abs(second[plan][key] - value * way) <= 1e-11 * top, (plan, key, drawn.kinds)


# whole scenes


def _shuffled(text: str, seed: int) -> str:
    """Put the [[link]] blocks in another order, in the places where they stand."""
    blocks = re.split(r"(?m)^(?=\[)", text)
    at = [k for k, block in enumerate(blocks) if block.startswith("[[link]]")]
    order = random.Random(seed).sample(at, len(at))
    # a heading in a comment belongs to no block: the shuffled text is read, not shown
    kept = list(blocks)
    for k, one in zip(at, order, strict=True):
        kept[k] = blocks[one]
    return "".join(kept)


QUICK = [n for n in NAMES if source(n).count("[[link]]") > 1]


@pytest.mark.turns(2)
@pytest.mark.slow
@pytest.mark.parametrize("name", QUICK)
def test_links_in_another_order_give_the_same_bytes(name: str, tmp_path: Any) -> None:
    text = source(name)
    told = []
    for seed in (None, 1):
        folder = tmp_path / str(seed) / "same"
        folder.mkdir(parents=True)
        path = written(folder, text if seed is None else _shuffled(text, seed))
        result = invoke("table", path, "-f", "csv")
        assert result.exit_code == 0, result.output
        told.append(result.stdout)
    assert told[0] == told[1]


@pytest.mark.slow
@pytest.mark.parametrize("name", ["crank-rocker", "scotch-yoke"])
def test_links_in_another_order_give_the_same_sheets(name: str, tmp_path: Any) -> None:
    text = source(name)
    drawn = []
    for seed in (None, 2):
        folder = tmp_path / str(seed) / "same"
        folder.mkdir(parents=True)
        (folder / "scene.toml").write_text(
            text if seed is None else _shuffled(text, seed), encoding="utf-8"
        )
        drawn.append(sheet_files(read(folder))[1])
    assert drawn[0] == drawn[1]

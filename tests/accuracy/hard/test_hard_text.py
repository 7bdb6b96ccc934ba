"""What is told of a walk: within 80 columns, the sentence first, both languages, the same as JSON."""

from __future__ import annotations

import json
from dataclasses import replace

import numpy as np
import pytest
from judges.test_random_drives import WAYS, random_of
from support import drives, gallery
from support.digits_left import scene_of
from support.hard_mechanisms import four_bar, slider_crank, weighed

import graphic_tmm
from graphic_tmm.accuracy.hard.hard_text import hard_json, hard_text
from graphic_tmm.accuracy.hard.walk import Walk, walk
from graphic_tmm.mechanism.records import Mechanism

EVEN = "\N{NO-BREAK SPACE}=\N{NO-BREAK SPACE}"


def _walk(mechanism: Mechanism, language: str = "en") -> Walk:
    return walk(replace(scene_of(weighed(mechanism)), language=language))


ROCKING = four_bar(0.3, 0.2, 0.2, 0.4)
PARALLEL = four_bar(0.1, 0.3, 0.1, 0.3, flips=(0.0, 180.0))


@pytest.mark.parametrize("language", ["en", "ru"])
@pytest.mark.parametrize("mechanism", [ROCKING, PARALLEL, slider_crank(0.1, 0.3)])
def test_nothing_is_wider_than_80_columns(mechanism: Mechanism, language: str) -> None:
    lines = hard_text(_walk(mechanism, language)).splitlines()
    assert max(map(len, lines)) <= 80


def test_the_strip_says_where_a_rocking_crank_cannot_go() -> None:
    """It reaches from 67.98° each side of nought: cells 14 to 57 hold nothing but ×."""
    lines = hard_text(_walk(ROCKING)).splitlines()
    for label in ("r", "v, ω", "a, ε", "R, P"):
        (strip,) = (line[6:] for line in lines if line[:6] == label.ljust(6) and len(line) == 78)
        assert set(strip[14:58]) == {"×"}
        assert "×" not in strip[:13]
        assert "×" not in strip[60:]


def test_the_strip_of_an_easy_mechanism_is_even_but_where_a_figure_is_zero() -> None:
    text = hard_text(_walk(slider_crank(0.1, 0.3)))
    strips = [line[6:] for line in text.splitlines() if len(line) == 78 and "°" not in line]
    assert len(strips) == 4
    assert {*"".join(strips)} == {"·", "∘"}
    assert strips[1][36] == "∘"
    assert "Nothing is left out." in text


def test_the_first_sentence_names_the_result_with_the_fewest_digits() -> None:
    found = walk(gallery.scene("windrower"))
    k, _ = np.unravel_index(np.nanargmin(found.digits), found.digits.shape)
    told = json.loads(hard_json(found))
    assert f" {found.results[k].letter} " in told["sentences"][0]
    assert f" {int(np.nanmin(found.digits))} из 15" in told["sentences"][0]


def test_what_is_left_out_is_named_with_its_reason() -> None:
    sentences = json.loads(hard_json(_walk(ROCKING)))["sentences"]
    (gone,) = (one for one in sentences if "the arcs do not meet" in one and "Cannot" in one)
    assert "67.97" in gone
    lost = next(
        one for one in json.loads(hard_json(_walk(PARALLEL)))["sentences"] if "Left out" in one
    )
    assert "ω_3" in lost
    assert "180°\N{NO-BREAK SPACE}±" in lost


def test_lengths_are_told_in_mm_and_written_in_m() -> None:
    found = walk(drives.scene(drives.BOOM))
    text, held = hard_text(found), json.loads(hard_json(found))
    assert "φ" not in text
    assert "°" not in text
    assert (
        "l_GN = 100 mm: the range of the drive ends".replace(" = ", EVEN).replace(
            "100 mm", "100\N{NO-BREAK SPACE}mm"
        )
        in text
    )
    (strip,) = (line for line in text.splitlines() if line.startswith("r  "))
    cells = strip[6:]
    low, cell = found.span.low, found.span.cell
    for k, sign in enumerate(cells):
        begins = low + k * cell
        assert (sign == "×") == (begins <= 100.0 or begins >= 900.0), begins
    assert [one["length_m"] for one in held["places"]] == pytest.approx([0.1, 0.9])
    assert held["lengths_m"] == (1e-3 * found.row).tolist()
    assert held["places"][0]["off_m"] == [*(1e-3 * off for off in found.span.offs), 0.0]
    assert "angles_deg" not in held


@pytest.mark.slow
@pytest.mark.parametrize("kind", WAYS)
def test_walks_of_random_drives_keep_within_80_columns(kind: str) -> None:
    for seed in range(1, 9):
        found = walk(graphic_tmm.read(random_of(kind, seed, forces=True)[1]))
        assert max(map(len, hard_text(found).splitlines())) <= 80


def test_json_holds_every_digit() -> None:
    found = _walk(PARALLEL)
    told = json.loads(hard_json(found))
    assert told["angles_deg"] == found.row.tolist()
    for one, row, missing in zip(told["results"], found.digits, found.missing, strict=True):
        assert [d is None for d in one["digits"]] == np.isnan(row).tolist()
        assert one["cannot_be_drawn"] == np.flatnonzero(missing).tolist()
    place = told["places"][0]
    assert place["off_deg"] == [*found.span.offs, 0.0]
    assert place["worst"][0] is not None
    assert place["worst"][-1] is None
    assert place["best"][-1] is not None

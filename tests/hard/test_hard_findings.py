"""Findings of one step at many positions: each position is told of by itself."""

from __future__ import annotations

import numpy as np
from support.drawn import board
from support.hard_judge import judge
from support.hard_mechanisms import chain, coulisse, slider_crank

from graphic_tmm.board.execute import BLOCK
from graphic_tmm.board.findings import examine
from graphic_tmm.board.operations.instruments import lay_off, rocker_line
from graphic_tmm.board.record import Board
from graphic_tmm.board.values import Length, Point


def test_doubt_and_touch_stand_beside_each_other() -> None:
    sheet = Board()
    sheet.open("positions")
    pivot, stone = sheet.take(Point, "C"), sheet.take(Point, "A")
    line = sheet.draw(rocker_line, "(CA)", pivot, stone)
    end = sheet.draw(lay_off, "D", line, sheet.take(Length, "l"))
    length = next(mark for mark in sheet.construction().given if mark.letter == "l")
    places = [1.0 + 1e-16j, 1.0 + 1e-10j, 1.0 + 1e-3j, 1.0 + 0j]
    given = {pivot: 1.0 + 0j, stone: [places], length: 2.0}
    told = examine(sheet.construction(), given, [end])
    found = {finding.kind: finding for finding in told}
    assert found["undrawn"].positions == (3,)
    assert found["touching"].positions == (0,)
    assert found["doubtful"].positions == (0, 1)
    assert found["doubtful"].step.it == end
    assert 0.1 < found["doubtful"].amount < 10.0


def test_mechanisms_far_from_a_change_point_have_no_findings() -> None:
    for mechanism in (slider_crank(0.1, 0.1, flips=(90.0, 270.0)), coulisse(0.1, 0.3)):
        assert all(not judge(mechanism, angle).findings for angle in (5.0, 60.0, 120.0, 200.0))


def test_one_position_in_a_long_row_is_told_of() -> None:
    """Two blocks that are fine, and one that ends a millionth of a radian behind the change point."""
    sheet = board(slider_crank(0.1, 0.1, flips=(90.0, 270.0)))
    count = 2 * BLOCK + 1
    phi = np.append(np.linspace(0.0, 80.0, count - 1), 90.0 + np.degrees(1e-6))[None, :]
    (side,) = sheet.positions.sides.values()
    given = sheet.given | {sheet.positions.row[0]: phi, side: np.where(phi < 90.0, 1.0, -1.0)}
    found = examine(sheet.log, given, [step.it for step in sheet.log.steps])
    assert [one.kind for one in found].count("doubtful") == 1
    assert {one.kind for one in found} == {"doubtful", "lost"}
    assert {one.positions for one in found} == {(count - 1,)}


def test_a_long_chain_of_sound_groups_is_not_doubted() -> None:
    """Conditions multiply over its eight groups and three plans; errors do not."""
    sheet = board(chain(8))
    given = sheet.given | {sheet.positions.row[0]: np.arange(0.0, 360.0, 5.0)[None, :]}
    assert examine(sheet.log, given, [step.it for step in sheet.log.steps]) == ()

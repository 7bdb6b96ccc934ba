"""Findings of one step at many positions: each position is told of by itself."""

from __future__ import annotations

from hard_mechanisms import coulisse, slider_crank

from graphic_tmm.board.findings import examine
from graphic_tmm.board.operations import lay_off, rocker_line
from graphic_tmm.board.record import Board
from graphic_tmm.board.values import Length, Point


def test_doubt_and_touch_stand_beside_each_other() -> None:
    board = Board()
    board.open("positions")
    pivot, stone = board.take(Point, "C"), board.take(Point, "A")
    line = board.draw(rocker_line, "(CA)", pivot, stone)
    end = board.draw(lay_off, "D", line, board.take(Length, "l"))
    length = next(mark for mark in board.construction().given if mark.letter == "l")
    places = [1.0 + 1e-16j, 1.0 + 1e-10j, 1.0 + 1e-3j, 1.0 + 0j]
    given = {pivot: 1.0 + 0j, stone: [places], length: 2.0}
    told = examine(board.construction(), given, [end])
    found = {finding.kind: finding for finding in told}
    assert found["undrawn"].positions == (3,)
    assert found["touching"].positions == (0,)
    assert found["doubtful"].positions == (0, 1)
    assert found["doubtful"].step.it == end
    assert 0.1 < found["doubtful"].amount < 10.0


def test_mechanisms_far_from_a_change_point_have_no_findings() -> None:
    from hard_judge import judge

    for mechanism in (slider_crank(0.1, 0.1, flips=(90.0, 270.0)), coulisse(0.1, 0.3)):
        assert all(not judge(mechanism, angle).findings for angle in (5.0, 60.0, 120.0, 200.0))

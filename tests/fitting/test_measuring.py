"""What is remembered of the room of views is what they take when they are drawn anew."""

from __future__ import annotations

import pytest

from graphic_tmm.fitting.measuring import Rooms
from graphic_tmm.fitting.sizes import Sizes, usual
from graphic_tmm.fitting.tried import Mechanism
from graphic_tmm.fitting.views import pieces
from graphic_tmm.paper.packing import bounds
from graphic_tmm.scene.packaged import scene_path
from graphic_tmm.scene.read import read

Boxes = list[tuple[str, tuple[float, float, float, float]]]


def boxes(rooms: Rooms, sizes: Sizes) -> Boxes:
    return [(one.view.name, bounds(one.view)) for one in rooms.sheet_views(sizes)]


@pytest.mark.slow
def test_a_piece_that_is_not_drawn_again_takes_the_same_room() -> None:
    """Of a flywheel the graphs do not depend on the size of its sketch, nor the sketch on theirs."""
    assert len(pieces("flywheel")) > 1
    scene = read(scene_path("windrower"))
    board = Mechanism(scene)
    remembering, begun = Rooms(scene, [board]), usual(scene)
    found = list[Boxes]()
    for changed in ({}, {"sketch": 1.6}, {"graphs": 1.4}, {"sketch": 1.6, "graphs": 1.4}, {}):
        sizes = {**begun, **{name: times * begun[name] for name, times in changed.items()}}
        found.append(boxes(remembering, sizes))
        assert found[-1] == boxes(Rooms(scene, [board]), sizes)
    assert found[0] == found[4]
    assert all(found[0] != other for other in found[1:4])

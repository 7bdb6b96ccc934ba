"""The room of views in sizes in which they were not measured, against what they take when drawn so."""

from __future__ import annotations

from pathlib import Path

import pytest
from support.gallery import SHEETS
from support.sheets_of_random import scenes

from graphic_tmm.fitting.formats import views_of
from graphic_tmm.fitting.rooms import FIXED, LETTERS, Rooms
from graphic_tmm.fitting.sizes import usual
from graphic_tmm.fitting.tried import Board, Mechanism, PartBoard
from graphic_tmm.paper.packing import bounds
from graphic_tmm.project import own_boards
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene

OFF, LESS, MORE = 16.0, 0.08, 0.25
"""How far a box may be off, mm, and besides by what share of itself it may be too small or too large: digits
hang a little on the size, forces at a group not at all."""
TIMES = (0.7, 1.25)


def boards_of(scene: Scene) -> list[Board]:
    boards: list[Board] = [PartBoard(scene, name) for name in own_boards(scene)]
    return [Mechanism(scene), *boards] if scene.mechanism is not None else boards


def faults(scene: Scene) -> list[str]:
    """Return the views whose box is not what they take, in two other sizes."""
    boards, found = boards_of(scene), []
    rooms = Rooms(scene, boards, usual(scene))
    for times in TIMES:
        free = {n for board in boards for n, size in board.sizes.items() if not size.fixed(scene)}
        sizes = {n: size * (times if n in free else 1.0) for n, size in rooms.natural.items()}
        drawn = [board.draw(sizes) for board in boards]
        for k, order in enumerate(scene.sheets):
            boxes = {box.name: box for box in rooms.outlines(k, sizes)}
            for view in (one for p in order.place for one in views_of(p, scene, drawn, False)):
                if view.role in FIXED or view.name not in boxes:
                    continue
                left, low, right, top = bounds(view)
                box = boxes[view.name]
                for due, real in ((box.width, right - left), (box.height, top - low)):
                    off = due - LETTERS - real
                    if not -OFF - LESS * real <= off <= OFF + MORE * real:
                        found.append(f"{scene.source} {times} {view.name}: {due:.0f} {real:.0f}")
    return found


@pytest.mark.parametrize("name", ["lever", "cam", "planetary", "gear-pair"])
def test_boxes_of_the_gallery_are_what_its_views_take(name: str) -> None:
    assert not faults(read(SHEETS / name / "scene.toml"))


@pytest.mark.turns(1, "sizes")
@pytest.mark.slow
def test_boxes_of_random_mechanisms_are_what_their_views_take(tmp_path: Path) -> None:
    found = []
    for k, text in enumerate(scenes(4, seed=15)):
        path = tmp_path / f"{k}.toml"
        path.write_text(text.replace('"auto"', '"A1"'), encoding="utf-8")
        found += faults(read(path))
    assert not found, "\n".join(found)

"""A scene changed so that its sheets come out larger, or the poles of its graphs stand farther."""

from __future__ import annotations

from graphic_tmm.accuracy.question import Accuracy
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.scene.chapter import chapters
from graphic_tmm.scene.records import Scene


def enlarge(scene: Scene, made: DrawnScene, times: float) -> Scene:
    """Return a scene drawn so many times larger than it was ``made``: every μ so much finer."""
    for drawn in made.boards:
        for chapter in chapters(drawn.board):
            scene = Accuracy.of(chapter).enlarged(scene, drawn, times)
    return scene


def farther(scene: Scene, made: DrawnScene, times: float) -> Scene:
    """Return a scene whose graphs, as ``made``, have their poles so many times farther, where it can say so."""
    for drawn in made.boards:
        for chapter in chapters(drawn.board):
            moved = Accuracy.of(chapter).moved
            scene = moved(scene, drawn, times) if moved is not None else scene
    return scene


def can_move(scene: Scene) -> bool:
    """Whether a scene can say how far poles of its graphs stand."""
    return any(
        Accuracy.of(one).moved is not None and Accuracy.of(one).poles(scene) for one in chapters()
    )

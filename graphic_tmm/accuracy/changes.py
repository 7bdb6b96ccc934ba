"""A scene changed so that its sheets come out larger, or the poles of its graphs stand farther."""

from __future__ import annotations

from graphic_tmm.chapter import chapters
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.scene.records import Scene


def enlarge(scene: Scene, made: DrawnScene, times: float) -> Scene:
    """Return a scene drawn so many times larger than it was ``made``: every μ so much finer."""
    for drawn in made.boards:
        for chapter in chapters(drawn.board):
            scene = chapter.accuracy.enlarged(scene, drawn, times)
    return scene


def farther(scene: Scene, made: DrawnScene, times: float) -> Scene:
    """Return a scene whose graphs, as ``made``, have their poles so many times farther, where it can say so."""
    for drawn in made.boards:
        for chapter in chapters(drawn.board):
            if chapter.accuracy.moved is not None:
                scene = chapter.accuracy.moved(scene, drawn, times)
    return scene


def can_move(scene: Scene) -> bool:
    """Whether a scene can say how far poles of its graphs stand."""
    return any(one.accuracy.moved is not None and one.accuracy.poles(scene) for one in chapters())

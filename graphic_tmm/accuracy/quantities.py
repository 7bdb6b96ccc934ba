"""The quantities whose error is told, as the chapters tell them."""

from __future__ import annotations

from graphic_tmm.accuracy.quantity import Quantity
from graphic_tmm.accuracy.question import Accuracy
from graphic_tmm.project import Project
from graphic_tmm.scene.chapter import in_order


def quantities(project: Project) -> tuple[Quantity, ...]:
    """Return the quantities that a drawing has, in the order in which they are found at the board."""
    there = (chapter for chapter in in_order(project.board) if chapter.name in project.made)
    return tuple(one for chapter in there for one in Accuracy.of(chapter).quantities(project))

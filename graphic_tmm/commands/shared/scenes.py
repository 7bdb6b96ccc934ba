"""The scene of a command: read by its path or name, drawn by the hand that is asked for."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

import click

if TYPE_CHECKING:
    from graphic_tmm.scene.records import Scene

F = TypeVar("F", bound=Callable[..., Any])


def read_scene(name: str | None, *, lettered: bool = False) -> Scene:
    """Return the scene of a path or a name; ``lettered``: refuse letters that cannot be written on a sheet."""
    from graphic_tmm.scene.read import read
    from graphic_tmm.scenes import scene_path

    path = scene_path(name)
    if not lettered:
        return read(path)
    from graphic_tmm.paper.lettering.letters import (
        missing,
    )

    return read(path, missing=missing)


def hands(command: F) -> F:
    """Give a command the options of the hand that draws."""
    for option in (
        click.option("--seed", type=click.IntRange(0, 2**31), help="Which of the hand's drawings."),
        click.option(
            "--hand",
            type=click.Choice(["exact", "cad", "careful", "student"]),
            help="Who draws; default: the scene's.",
        ),
    ):
        command = option(command)
    return command


def drawn_by(scene: Scene, hand: str | None, seed: int | None) -> Scene:
    """Return the scene drawn by another hand, with that hand's own ruler."""
    from dataclasses import replace

    from graphic_tmm.scene.build import DIVISIONS

    if hand is not None:
        scene = replace(scene, hand=hand, ruler=DIVISIONS[hand])
    return scene if seed is None else replace(scene, seed=seed)

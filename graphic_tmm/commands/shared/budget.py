"""The option of an error to be kept within."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import TYPE_CHECKING, Any, TypeVar

import click

from graphic_tmm.commands.shared.progress import progress
from graphic_tmm.commands.shared.telling import tell
from graphic_tmm.language.said import said

if TYPE_CHECKING:
    from graphic_tmm.scene.records import Scene

F = TypeVar("F", bound=Callable[..., Any])


def budgeted(command: F) -> F:
    """Give a command the option of an error to be kept within."""
    return click.option(
        "--budget",
        help=said(
            "Largest error, such as 2%: take the cheapest setting that keeps every quantity within "
            "it."
        ),
    )(command)


def within(scene: Scene, budget: str | None) -> Scene:
    """Return the scene at the cheapest setting within a budget such as "2%"; tell which it is.

    Raises
    ------
    SheetError
        If the budget is no percentage.
    SceneError
        If no setting keeps within it.
    """
    if budget is None:
        return scene
    from graphic_tmm.accuracy.budget import choose

    percent = _percentage(budget)
    with progress() as on_the_way:
        taken = choose(scene, percent, on_the_way)
    tell(f"{scene.source}: {taken.sentence}")
    return taken.scene


def _percentage(budget: str) -> float:
    from graphic_tmm.errors import SheetError

    match = re.fullmatch(r"\s*(\d+(?:[.,]\d*)?|[.,]\d+)\s*%?\s*", budget)
    percent = float(match[1].replace(",", ".")) if match else 0.0
    if not percent > 0.0:
        raise SheetError(
            said('--budget: "{budget}" is no percentage above 0; write --budget 2%', budget=budget)
        )
    return percent

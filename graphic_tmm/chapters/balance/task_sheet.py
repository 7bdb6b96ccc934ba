"""What a task gives of counterweights, and what it asks of the balance of a mechanism."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.balance.task import ASKED, BALANCE, FULL, HALF, PARTIAL
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import SIZE, Given, TaskSheet
from graphic_tmm.scene.records import Scene


def given(scene: Scene) -> Iterator[Given]:
    """Yield what is known of the counterweights, the share of the sliding masses."""
    order = ASKED.of(scene)
    if order is None:
        return
    if order.method == PARTIAL:
        yield Given("k", HALF if order.share is None else order.share)
    for one in order.counterweights:
        if one.mass is not None:
            yield Given(f"m_{{c{one.link}}}", one.mass, "kg")
        if one.radius is not None:
            yield Given(f"r_{{c{one.link}}}", one.radius, SIZE)


def asks(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the shaking force and its moment; with counterweights for what these take away."""
    order = ASKED.of(scene)
    if order is None:
        return
    _ = speaking(language)
    yield _(_POLAR)
    yield _(_MOMENT)
    if order.method is not None:
        yield _(_METHODS[order.method])
    if order.counterweights or order.method is not None:
        yield _(_WITH)


_POLAR = said(
    "The inertia forces of the links are added up in every position; the shaking force is drawn over the turn "
    "as a polar diagram."
)
_MOMENT = said("The moment of the shaking force about a point of the frame is drawn over the turn.")
_METHODS = {
    FULL: said(
        "Counterweights are found by replacing masses so that the centre of all masses stands still."
    ),
    PARTIAL: said(
        "A counterweight on the crank is found by replacing masses, with the share k of the sliding ones."
    ),
}
_WITH = said("The same is drawn with the counterweights; what they take away is told.")

TASK_SHEET = TaskSheet(given=given, wanted={BALANCE: asks})

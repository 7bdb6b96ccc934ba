"""What a task asks of a planetary train, a sentence each."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.planetary.given import given
from graphic_tmm.chapters.planetary.scheme import scheme
from graphic_tmm.chapters.planetary.task import ASKED
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.readers.task_sheet import TaskSheet
from graphic_tmm.scene.records import Scene


def asks(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the train: its teeth, its scheme, its pictures; tell which scheme it is."""
    order = ASKED.of(scene)
    if order is None:
        return
    _ = speaking(language)
    yield _(_SCHEMES[order.scheme])
    if order.ratio is not None:
        yield _(_TEETH)
    yield _(_DRAWN)
    yield _(_PICTURES)
    if order.behind:
        yield _(_BEHIND)


_SCHEMES = {
    "ring": said("The train has a single row: sun wheel 1, satellites 2, fixed ring 3, carrier H."),
    "external-internal": said(
        "The train has two rows: wheel 1 and rim 2 of the satellites mesh externally, rim 3 and "
        "the fixed ring 4 internally; carrier H."
    ),
    "external-external": said(
        "The train has two rows, both meshing externally: wheel 1 with rim 2 of the satellites, "
        "their rim 3 with the fixed wheel 4; carrier H."
    ),
    "internal-internal": said(
        "The train has two rows, both meshing internally: ring 1 with rim 2 of the satellites, "
        "their rim 3 with the fixed ring 4; carrier H."
    ),
}
_TEETH = said(
    "The numbers of teeth are found by the ratio wanted, the coaxiality, the assembly and the "
    "neighbourhood of the satellites."
)
_DRAWN = said("The pitch circles and the kinematic scheme of the train are drawn to scale.")
_PICTURES = said(
    "The picture of linear velocities and the plan of angular velocities are drawn; the ratio is "
    "found from them and compared with Willis's formula."
)
_BEHIND = said("The speed behind the following pair of wheels is found.")


TASK_SHEET = TaskSheet(
    given=given,
    scheme=scheme,
    wanted={"planetary": asks},
)

"""The documents that the sheets of a scene belong to, and their designations: 01, 02, … of the project's."""

from __future__ import annotations

import re

from graphic_tmm.language.catalogue import speaking
from graphic_tmm.scene.records import Scene

WHOLE = re.compile(r"(?<!\d)00(?!\d)")
"""What stands for the project as a whole in its designation: ТММ.08.00.000."""


def documents(scene: Scene) -> list[int]:
    """Return, by order, of which document its sheets are, from 0.

    Sheets follow each other in one, with one designation. One that is named, or designated as none before it,
    begins a document of its own, with the form of a first sheet.
    """
    found, known = list[int](), dict[str, int]()
    for order in scene.sheets:
        fresh = max(found, default=-1) + 1
        if order.designation:
            found.append(known.setdefault(order.designation, fresh))
        else:
            found.append(fresh if order.name or not found else found[-1])
    return found


def designation(scene: Scene, k: int) -> str:
    """Return the designation of the sheets ordered as the ``k``-th, from 0.

    It is what a sheet of its document says, else the project's with the document's number, from 01, where there
    are several: in the place of 00, or behind it.
    """
    papers = documents(scene)
    number = f"{papers[k] + 1:02d}"
    of = zip(papers, scene.sheets, strict=True)
    if own := next((one.designation for n, one in of if n == papers[k] and one.designation), ""):
        return own
    whole, _ = scene.title_block.get("designation", ""), speaking(scene.language)
    if not whole:
        return _("TMM.01.{sheet}.000", context="designation", sheet=number)
    if max(papers) == 0:
        return whole
    places = [one.start() for one in WHOLE.finditer(whole)]
    if not places:
        return f"{whole}.{number}"
    return whole[: places[-1]] + number + whole[places[-1] + 2 :]

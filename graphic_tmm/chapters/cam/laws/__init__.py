"""Laws of motion on the board: the points of S, dS/dφ and d²S/dφ² of one phase, as a draughtsman finds them.

A law is a file here that declares a `DrawnLaw` called LAW; it is found by being there. The return is the rise
seen in a mirror: everything is drawn from the outer end of a phase, the beginning of the rise or the end of the
return.
"""

from __future__ import annotations

import pkgutil
from functools import cache
from importlib import import_module
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from graphic_tmm.chapters.cam.laws.ground import DrawnLaw


@cache
def laws() -> dict[str, DrawnLaw]:
    """Return the laws by name, in their order."""
    rooms = (import_module(f"{__name__}.{one.name}") for one in pkgutil.iter_modules(__path__))
    found = [room.LAW for room in rooms if hasattr(room, "LAW")]
    return {one.name: one for one in sorted(found, key=lambda one: one.number)}

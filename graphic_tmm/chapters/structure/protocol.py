"""The view that the structure of a mechanism is told in."""

from __future__ import annotations

from graphic_tmm.chapters.structure.names import VIEW
from graphic_tmm.readers.titles import Protocols

PROTOCOL = Protocols(views=lambda project: {VIEW: (VIEW,)})

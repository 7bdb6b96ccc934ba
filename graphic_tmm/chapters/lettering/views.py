"""Specimens of the lettering and of the symbols, drawn of a scene alone."""

from __future__ import annotations

from graphic_tmm.chapters.lettering.specimen import specimen
from graphic_tmm.chapters.lettering.specimen_symbols import specimen_symbols
from graphic_tmm.fitting.views import Views
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.lettering.heights import heights
from graphic_tmm.scene.records import Scene


def _characters(scene: Scene) -> list[Drawing]:
    return specimen(scene.language, heights(scene, "lettering").title)


def _symbols(scene: Scene) -> list[Drawing]:
    return specimen_symbols(scene.language, heights(scene, "symbols"))


SHOWN = Views(plain={"lettering": _characters, "symbols": _symbols})

"""A composition as data: of every sheet its format and where its views stand, how large what is drawn is.

    # positions: μ_l = 0.004 m/mm          # the scale factors that come of it: told, not read
    [sizes]                                # what the drawing was made with: room in mm, or a share of the usual
    velocities = 80.0
    [[sheet]]
    order = 1                              # the [[sheet]] of the scene that it belongs to
    format = "A1"
    [sheet.views]                          # the lower left corner of each view, mm from that of the paper
    positions = [43.31, 245.9]

It is written beside the sheets on wish, and what stands beside a scene is used: no size is chosen then. An
author may move a view by hand; what does not fit any more is put elsewhere, and told.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from pathlib import Path
from types import MappingProxyType
from typing import NamedTuple

from graphic_tmm.board.scales import Scale
from graphic_tmm.errors import Fault, SceneError, first_of
from graphic_tmm.files import Kind
from graphic_tmm.language.said import said
from graphic_tmm.paper.formats import FORMATS
from graphic_tmm.scene.document import Document, as_table, document, number, parsed

FILE = "composition.toml"
COMPOSITION = Kind(
    said("a composition"), said("write it again with draw --composition, or take it away"), 256_000
)
DIGITS = 2
"""Places are told to so many decimals of a mm, and drawn so."""
MOST = 20
"""So many faults of a file are told."""
LEAST, LARGEST = 1e-3, 1e4
"""What is drawn in less is a dot on paper, in more no paper holds it: mm, or a share of the usual."""


class Placed(NamedTuple):
    """A sheet: the order that it belongs to (an index), its format, corners of its views (complex, mm) by name.

    Of views with one name the second is called "name 2".
    """

    order: int
    format: str
    views: Mapping[str, complex]


class Composition(NamedTuple):
    """How the sheets of a scene are composed; ``sizes``: what its drawing was made with, by name."""

    sizes: Mapping[str, float]
    sheets: tuple[Placed, ...]


def composition_file(scene: str) -> Path:
    """Return where the composition of a scene's file stands."""
    file = Path(scene)
    return file.with_name(FILE if file.stem == "scene" else f"{file.stem}.{FILE}")


def distinct_names(names: Iterable[str]) -> list[str]:
    """Return names of which none is there twice."""
    counts: dict[str, int] = {}
    found = []
    for name in names:
        counts[name] = counts.get(name, 0) + 1
        found.append(name if counts[name] == 1 else f"{name} {counts[name]}")
    return found


def text(composition: Composition, scales: Mapping[str, Scale] = MappingProxyType({})) -> str:
    """Return a composition as its file; ``scales``: the scale factors that it tells people, by view."""
    return "\n".join(_lines(composition, scales)) + "\n"


def _lines(composition: Composition, scales: Mapping[str, Scale]) -> Iterator[str]:
    yield "# Where the views of the sheets stand: the lower left corner of each, mm from that of the paper."
    yield "# What stands beside a scene is used by draw; a view may be moved here by hand."
    yield ""
    for view, scale in scales.items():
        yield f"# {view}: {scale.symbol} = {scale.value:g} {scale.unit}".rstrip()
    yield "[sizes]"
    for name, size in composition.sizes.items():
        yield f"{json.dumps(name, ensure_ascii=False)} = {size!r}"
    for sheet in composition.sheets:
        yield ""
        yield "[[sheet]]"
        yield f"order = {sheet.order + 1}"
        yield f'format = "{sheet.format}"'
        yield "[sheet.views]"
        for name, at in sheet.views.items():
            key = json.dumps(name, ensure_ascii=False)
            yield f"{key} = [{_number(at.real)}, {_number(at.imag)}]"


def _number(length: float) -> str:
    return f"{length:.{DIGITS}f}"


def read_composition(file: Path) -> Composition | None:
    """Return the composition of a file; None if there is none.

    Raises
    ------
    SceneError
        If it is no composition: the key that is wrong, and the remedy.
    """
    if not file.exists():
        return None
    return _composition(file, document(file, COMPOSITION)[1])


def known_composition(data: bytes, file: Path) -> Composition:
    """Return the composition that a file would hold with these bytes; raises as `read_composition`."""
    return _composition(file, parsed(data, file)[1])


def _composition(file: Path, doc: Document) -> Composition:
    faults: list[Fault] = []
    sizes = _table(doc, "sizes", "sizes", faults)
    for name, size in sizes.items():
        if not LEAST <= (number(size) or 0.0) <= LARGEST:
            limits = {"least": f"{LEAST:g}", "most": f"{LARGEST:g}"}
            says = said("a number from {least} to {most} is wanted", **limits)
            faults.append(Fault(f"sizes.{name}", 0, says))
    sheets = doc.get("sheet")
    found = [
        _sheet(as_table(one), f"sheet {k + 1}", faults)
        for k, one in enumerate(sheets if isinstance(sheets, list) else ())
    ]
    if not found:
        faults.append(Fault("sheet", 0, said("there is no [[sheet]]")))
    if faults:
        raise SceneError(str(file), first_of(faults, MOST))
    return Composition(dict(sizes), tuple(found))


def _sheet(told: Document, where: str, faults: list[Fault]) -> Placed:
    order, format = told.get("order"), told.get("format")
    views = _table(told, "sheet.views", f"{where}, views", faults)
    if not isinstance(order, int) or isinstance(order, bool) or order < 1:
        faults.append(
            Fault(f"{where}, order", 0, said("the number of a [[sheet]] of the scene is wanted"))
        )
        order = 1
    if not isinstance(format, str) or format not in FORMATS:
        listed = ", ".join(FORMATS)
        faults.append(Fault(f"{where}, format", 0, said("choose one of {listed}", listed=listed)))
    places = {}
    for name, at in views.items():
        x, y = map(number, at) if isinstance(at, list) and len(at) == 2 else (None, None)
        if x is not None and y is not None:
            places[name] = complex(x, y)
        else:
            says = said("a corner is wanted: [x, y] in mm from the lower left corner of the paper")
            faults.append(Fault(f"{where}, views.{name}", 0, says))
    return Placed(order - 1, str(format), places)


def _table(doc: Document, name: str, where: str, faults: list[Fault]) -> Document:
    """Return a table of the file; an empty one where there is none, or something else."""
    found = doc.get(name.rpartition(".")[2], {})
    if not isinstance(found, dict):
        says = said(
            "a section is wanted: [{name}] on a line of its own, its keys below it", name=name
        )
        faults.append(Fault(where, 0, says))
    return as_table(found)

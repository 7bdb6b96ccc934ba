"""A sheet in the hand: shown in a notebook as wide as its cell, saved true to the millimetre."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path

from graphic_tmm.errors import SheetError
from graphic_tmm.face.html import pictured
from graphic_tmm.files import write
from graphic_tmm.language.said import said
from graphic_tmm.paper import drawing


class Sheet:
    """A sheet as drawn: A1 to A4, or a picture of its own size.

    A notebook shows it no wider than its cell; what is saved is true to the millimetre.

    Parameters
    ----------
    paper : paper.drawing.Sheet
        The ink.

    Examples
    --------
    >>> import graphic_tmm as tmm
    >>> sheet = tmm.draw("crank-rocker").sheets[0]
    >>> sheet.format, sheet.width, sheet.height
    ('A4', 210.0, 297.0)
    """

    def __init__(self, paper: drawing.Sheet) -> None:
        self._paper = paper

    @property
    def name(self) -> str:
        """What it is called in code."""
        return self._paper.name

    @property
    def title(self) -> str:
        """What it is called by people."""
        return self._paper.title

    @property
    def format(self) -> str:
        """The format of the paper: A1 ... A4."""
        return self._paper.format

    @property
    def width(self) -> float:
        """How wide the paper is, mm."""
        return self._paper.width

    @property
    def height(self) -> float:
        """How high the paper is, mm."""
        return self._paper.height

    @property
    def views(self) -> tuple[str, ...]:
        """The titles of what is drawn on it."""
        return tuple(view.title or view.name for view in self._paper.drawings)

    @property
    def svg(self) -> str:
        """The sheet as SVG in true millimetres, as `save` writes it."""
        from graphic_tmm.paper.write.svg import svg

        return svg(self._paper)

    def save(self, path: str | os.PathLike[str]) -> Path:
        """Write the sheet into a file.

        Parameters
        ----------
        path : str or path
            Its end tells the format: ``.svg``, ``.pdf``, ``.png``, ``.dxf`` (PDF and PNG need the extra
            ``pdf``, DXF the extra ``dxf``).

        Returns
        -------
        Path
            The file.

        Raises
        ------
        SheetError
            If sheets are not saved so, a package is missing, or the file cannot be written.
        """
        file = Path(path)
        form = ending(file, WRITERS)
        return saved(file, WRITERS[form](self._paper))

    def _repr_html_(self) -> str:
        """Return the sheet for a notebook: as a picture by itself, no wider than its cell."""
        return pictured(self.svg, self.title)

    def __repr__(self) -> str:
        return f"<Sheet {self.title!r}: {self.format}, {self.width:g} × {self.height:g} mm>"


def ending(file: Path, known: Mapping[str, object]) -> str:
    """Return the format that a file's name asks for.

    Raises
    ------
    SheetError
        If it is none of those known.
    """
    form = file.suffix.lower().removeprefix(".")
    if form in known:
        return form
    listed = ", ".join(f".{one}" for one in known)
    raise SheetError(
        said(
            "{file}: the name of the file ends with one of {listed}", file=str(file), listed=listed
        )
    )


def saved(file: Path, data: str | bytes) -> Path:
    """Write a file whole, or not at all; return where it is."""
    return write(file.parent, {file.name: data})[0]


def _svg(paper: drawing.Sheet) -> str:
    return Sheet(paper).svg


def _pdf(paper: drawing.Sheet) -> bytes:
    from graphic_tmm.paper.write.export import pdf

    return pdf([paper])


def _png(paper: drawing.Sheet) -> bytes:
    from graphic_tmm.paper.write.export import png

    return png(paper)


def _dxf(paper: drawing.Sheet) -> str:
    from graphic_tmm.paper.write.dxf import dxf

    return dxf(paper)


WRITERS: Mapping[str, Callable[[drawing.Sheet], str | bytes]] = {
    "svg": _svg,
    "pdf": _pdf,
    "png": _png,
    "dxf": _dxf,
}
"""What a sheet is saved as, by the end of the file's name."""

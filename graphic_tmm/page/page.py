"""A scene as one page for a browser: its sheets, the pictures of its plans, the protocol, the program.

One file that asks for nothing else. What it may do is told to the browser in it: its own style and program by
their hashes, nothing from outside, no text made into elements.
"""

from __future__ import annotations

import base64
import gzip
import hashlib
import json
from collections.abc import Mapping, Sequence
from typing import Any

from graphic_tmm.drawn import DrawnScene
from graphic_tmm.files import environment
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.page.crank import crank
from graphic_tmm.page.join import folders, script, style
from graphic_tmm.page.layers import PARTS
from graphic_tmm.page.practice.own import own
from graphic_tmm.page.practice.own_words import OWN
from graphic_tmm.page.practice.pack import practice
from graphic_tmm.page.practice.words import practice_words
from graphic_tmm.page.protocol import protocol_of
from graphic_tmm.page.views import played
from graphic_tmm.page.words import WORDS
from graphic_tmm.paper.drawing import Drawing, Sheet
from graphic_tmm.paper.write.svg import ids, svg


def page(
    made: DrawnScene, sheets: Sequence[Sheet], *, practised: bool = False, seed: int | None = None
) -> str:
    """Return a drawn scene as a page for a browser (HTML), in the scene's language.

    ``practised``: with what lets a person draw the plans himself, each posed as ``seed`` says, if it is given.
    """
    from markupsafe import Markup

    language = made.scene.language
    data = page_data(made, sheets)
    turned = crank(made, sheets)
    if turned is not None:
        data["crank"] = turned.data
    program, looks = script(), style()
    if practised and (asked := practice(made, sheets, data["views"], seed)) is not None:
        data["practice"], written = asked
        data["own"] = own(sheets, language)
        data["words"] |= practice_words(language) | _said(OWN, language)
        program, looks = script(*folders(), written=written), style(*folders())
    return (
        environment("graphic_tmm.page")
        .get_template("page.html")
        .render(
            language=language,
            title=made.scene.title,
            words=data["words"],
            sheets=[(one, Markup(inline(one))) for one in sheets],
            rubbed=[Markup(inline(_rubbed(one))) for one in sheets],
            protocol=protocol_of(made, language) if made.boards else (),
            data=packed(data),
            rows=carried(turned.rows) if turned is not None else "",
            style=Markup(looks),
            style_hash=_hash(looks),
            program=Markup(program),
            program_hash=_hash(program),
        )
    )


def page_data(made: DrawnScene, sheets: Sequence[Sheet]) -> dict[str, Any]:
    """Return what the page knows of a scene, as JSON takes it."""
    speech = speaking(made.scene.language)
    return {
        "language": made.scene.language,
        "title": made.scene.title,
        "words": _said(WORDS, made.scene.language),
        "parts": {part: speech(PARTS[part]) for part in parts_of(sheets) if part in PARTS},
        "sheets": [
            {"name": one.name, "width": one.width, "height": one.height, "format": one.format}
            for one in sheets
        ],
        "views": played(made, sheets),
    }


def _said(words: Mapping[str, str], language: str) -> dict[str, str]:
    return {key: speaking(language)(text) for key, text in words.items()}


def parts_of(sheets: Sequence[Sheet]) -> list[str]:
    """Return the parts of which ink of sheets is, what was rubbed out too."""
    found = {
        stroke.part
        for sheet in sheets
        for drawing in sheet.drawings
        for stroke in (*drawing.strokes, *drawing.rubbed)
    }
    return sorted(found - {""})


def packed(data: object) -> str:
    """Return data as the page carries it: JSON, gzip, base64; the same data the same text."""
    text = json.dumps(data, ensure_ascii=False, separators=(",", ":"), allow_nan=False)
    return carried(text.encode())


def carried(data: bytes) -> str:
    """Return bytes as the page carries them: gzip, base64."""
    return base64.b64encode(gzip.compress(data, 9, mtime=0)).decode()


def inline(sheet: Sheet) -> str:
    """Return a sheet as SVG that stands within HTML."""
    return svg(sheet)


def _rubbed(sheet: Sheet) -> Sheet:
    """Return what was rubbed out on a sheet, each view by its name with "rubbed" before it."""
    names = ids(sheet)
    drawings = tuple(
        Drawing(f"rubbed {name}", one.title, one.rubbed)
        for name, one in zip(names, sheet.drawings, strict=True)
        if one.rubbed
    )
    return sheet._replace(name="of", drawings=drawings)


def _hash(text: str) -> str:
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()

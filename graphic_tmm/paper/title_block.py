"""Title blocks as tables: lines, captions and entries.

Forms 1, 2 and 2a of ГОСТ 2.104 with the columns in the margin, and a block with the data fields of ISO
7200. All figures are millimetres from the lower left corner of the block, x to the right, y upward.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import NamedTuple

from graphic_tmm.errors import SheetError
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Label, Stroke, line
from graphic_tmm.paper.lettering import letters
from graphic_tmm.paper.ruled import Box, Slot, set_text

Ruling = tuple[str, float, float, float, float]


class Block(NamedTuple):
    """A title block: its size in mm, ruling (pen, x0, y0, x1, y1), captions and entries."""

    width: float
    height: float
    ruling: tuple[Ruling, ...]
    captions: tuple[Slot, ...]
    entries: tuple[Slot, ...]


def _level(pen: str, left: float, right: float, *heights: float) -> tuple[Ruling, ...]:
    """Return horizontal lines between two x at several heights."""
    return tuple((pen, left, y, right, y) for y in heights)


def _upright(pen: str, bottom: float, top: float, *places: float) -> tuple[Ruling, ...]:
    """Return vertical lines between two y at several places."""
    return tuple((pen, x, bottom, x, top) for x in places)


SMALL, TEXT = (2.5, 1.8), (3.5, 2.5, 1.8)
"""Sizes of lettering, mm (ГОСТ 2.304), of captions and of texts: the first that fits."""
CHANGES = (
    said("Rev.", context="title block"),
    said("Sheet", context="title block"),
    said("Doc. No.", context="title block"),
    said("Sign.", context="title block"),
    said("Date", context="title block"),
)
LETTER, SHEET = said("Letter", context="title block"), CHANGES[1]
SHEETS = said("Sheets", context="title block")
EDGES = (0, 7, 17, 40, 55, 65)
"""Edges of the columns of changes, mm from the left (ГОСТ 2.104, form 1)."""
ROLES = (
    (said("Drawn", context="title block"), "drawn_by"),
    (said("Checked", context="title block"), "checked_by"),
    (said("Techn. check", context="title block"), "technical_by"),
    ("", ""),
    (said("Std. check", context="title block"), "standards_by"),
    (said("Approved", context="title block"), "approved_by"),
)


def _changes(bottom: float) -> tuple[Slot, ...]:
    """Return the header row of the table of changes, 5 mm high."""
    spans = zip(CHANGES, EDGES, EDGES[1:], strict=False)
    return tuple(Slot(t, Box(a, bottom, b, bottom + 5), SMALL) for t, a, b in spans)


PEOPLE = (*ROLES[:2], *ROLES[3:])
"""Who signs a text (form 2): nobody checks its techniques."""


def _roles(
    signed: Sequence[tuple[str, str]] = ROLES,
) -> tuple[tuple[Slot, ...], tuple[Slot, ...]]:
    """Return the captions and the entries of the rows of signatures at the foot of a form."""
    top = 5 * len(signed) - 5
    rows = [(text, key, top - 5 * k) for k, (text, key) in enumerate(signed) if text]
    captions = tuple(
        Slot(t, Box(0, y, 17, y + 5), SMALL, anchor="start", pad=1) for t, _, y in rows
    )
    people = tuple(
        Slot(key, Box(17, y, 40, y + 5), SMALL, anchor="start", pad=1) for _, key, y in rows
    )
    return captions, people


FORM_1 = Block(
    185,
    55,
    (
        *_level("main", 0, 185, 55),
        *_level("main", 65, 185, 40, 15),
        *_level("main", 0, 65, 35, 30),
        *_level("main", 135, 185, 35, 20),
        *_level("thin", 0, 65, 50, 45, 40, 25, 20, 15, 10, 5),
        *_upright("main", 0, 55, 0, 17, 40, 55, 65),
        *_upright("main", 30, 55, 7),
        *_upright("main", 0, 40, 135),
        *_upright("main", 20, 40, 150, 167),
        *_upright("main", 15, 20, 155),
        *_upright("thin", 20, 35, 140, 145),
    ),
    (
        *_changes(30),
        *_roles()[0],
        Slot(LETTER, Box(135, 35, 150, 40), SMALL),
        Slot(said("Mass", context="title block"), Box(150, 35, 167, 40), SMALL),
        Slot(said("Scale", context="title block"), Box(167, 35, 185, 40), SMALL),
        Slot(SHEET, Box(135, 15, 146, 20), SMALL, anchor="start", pad=1),
        Slot(SHEETS, Box(155, 15, 171, 20), SMALL, anchor="start", pad=1),
    ),
    (
        Slot("designation", Box(65, 40, 185, 55), (7, 5, 3.5, 2.5), 2, pad=2),
        Slot("name", Box(65, 15, 135, 40), (7, 5, 3.5, 2.5), 3, pad=2),
        Slot("material", Box(65, 0, 135, 15), (5, 3.5, 2.5), 2, pad=2),
        Slot("organisation", Box(135, 0, 185, 15), (5, 3.5, 2.5), 2, pad=1.5),
        Slot("letter", Box(135, 20, 140, 35), TEXT),
        Slot("mass", Box(150, 20, 167, 35), (5, 3.5, 2.5, 1.8), pad=1),
        Slot("scale", Box(167, 20, 185, 35), (5, 3.5, 2.5, 1.8), 2, pad=1),
        Slot("sheet", Box(146, 15, 155, 20)),
        Slot("sheets", Box(171, 15, 185, 20)),
        *_roles()[1],
        Slot("date", Box(55, 25, 65, 30), SMALL),
    ),
)
"""The first sheet of a drawing: 185 × 55 (ГОСТ 2.104, form 1)."""

FORM_2 = Block(
    185,
    40,
    (
        *_level("main", 0, 185, 40, 25),
        *_level("main", 0, 65, 30),
        *_level("main", 135, 185, 20, 15),
        *_level("thin", 0, 65, 35, 20, 15, 10, 5),
        *_upright("main", 0, 40, 0, 17, 40, 55, 65),
        *_upright("main", 25, 40, 7),
        *_upright("main", 0, 25, 135),
        *_upright("thin", 15, 20, 140, 145),
        *_upright("main", 15, 25, 150, 165),
    ),
    (
        *_changes(25),
        *_roles(PEOPLE)[0],
        Slot(LETTER, Box(135, 20, 150, 25), SMALL),
        Slot(SHEET, Box(150, 20, 165, 25), SMALL),
        Slot(SHEETS, Box(165, 20, 185, 25), SMALL),
    ),
    (
        Slot("designation", Box(65, 25, 185, 40), (7, 5, 3.5, 2.5), 2, pad=2),
        Slot("name", Box(65, 0, 135, 25), (7, 5, 3.5, 2.5), 3, pad=2),
        Slot("organisation", Box(135, 0, 185, 15), (5, 3.5, 2.5), 2, pad=1.5),
        Slot("letter", Box(135, 15, 140, 20), TEXT),
        Slot("sheet", Box(150, 15, 165, 20)),
        Slot("sheets", Box(165, 15, 185, 20)),
        *_roles(PEOPLE)[1],
        Slot("date", Box(55, 20, 65, 25), SMALL),
    ),
)
"""The first sheet of a text: 185 × 40 (ГОСТ 2.104, form 2)."""

FORM_2A = Block(
    185,
    15,
    (
        *_level("main", 0, 185, 15),
        *_level("main", 0, 65, 5),
        *_level("thin", 0, 65, 10),
        *_level("main", 175, 185, 8),
        *_upright("main", 0, 15, 0, 7, 17, 40, 55, 65, 175),
    ),
    (*_changes(0), Slot(SHEET, Box(175, 8, 185, 15), SMALL)),
    (
        Slot("designation", Box(65, 6.5, 175, 15), (5, 3.5, 2.5), pad=2),
        Slot("name", Box(65, 0, 175, 6.5), (3.5, 2.5), pad=2),
        Slot("sheet", Box(175, 0, 185, 8), (5, 3.5, 2.5, 1.8)),
    ),
)
"""The following sheets: 185 × 15 (ГОСТ 2.104, form 2a); the name of the sheet stands under its designation."""

COLUMN_26 = Block(
    70,
    14,
    (*_level("main", 0, 70, 0), *_upright("main", 0, 14, 70)),
    (),
    (Slot("designation", Box(0, 0, 70, 14), (7, 5, 3.5, 2.5), 2, turn=180, pad=2),),
)
"""The designation turned by 180°, at the upper left corner of the frame: A4, and larger sheets that lie."""

COLUMN_26_UPRIGHT = Block(
    14,
    70,
    (*_level("main", 0, 14, 0), *_upright("main", 0, 70, 0)),
    (),
    (Slot("designation", Box(0, 0, 14, 70), (7, 5, 3.5, 2.5), 2, turn=-90, pad=2),),
)
"""The designation read from the left, at the upper right corner: larger sheets that stand."""

ARCHIVE = (
    (said("Inv. No.", context="title block"), 0, 25),
    (said("Sign. and date", context="title block"), 25, 60),
    (said("Replaces inv. No.", context="title block"), 60, 85),
    (said("Dupl. inv. No.", context="title block"), 85, 110),
    (said("Sign. and date", context="title block"), 110, 145),
)
FIRST_USE = (
    (said("Ref. No.", context="title block"), 167, 227),
    (said("First use", context="title block"), 227, 287),
)


def _margin(rows: Sequence[tuple[str, float, float]]) -> Block:
    """Return columns of the binding margin: 5 mm for the caption, 7 for the entry, text upward."""
    low, high = rows[0][1], rows[-1][2]
    heights = [low, *(top for _, _, top in rows)]
    ruling = (*_level("main", 0, 12, *heights), *_upright("main", low, high, 0, 5))
    captions = tuple(Slot(t, Box(0, a, 5, b), SMALL, turn=90) for t, a, b in rows)
    return Block(12, high, ruling, captions, ())


MARGIN_19_23 = _margin(ARCHIVE)
MARGIN_24_25 = _margin(FIRST_USE)
"""Columns 19 ... 23 and 24, 25, to the left of the frame, heights from its lower edge."""


CAPTION = 3.9
"""Height of the strip of a caption in the English block, mm."""


def _field(
    caption: str, key: str, box: Box, sizes: tuple[float, ...], lines: int = 1
) -> tuple[Slot, Slot]:
    """Return a field of the English block: a caption in the upper left corner, the entry below."""
    head = Slot(caption, box._replace(bottom=box.top - CAPTION), (1.8,), anchor="start", pad=1)
    body = Slot(key, box._replace(top=box.top - CAPTION), sizes, lines, anchor="start", pad=1)
    return head, body


def _fields(*fields: tuple[Slot, Slot]) -> tuple[tuple[Slot, ...], tuple[Slot, ...]]:
    """Return the captions and the entries of several fields."""
    return tuple(head for head, _ in fields), tuple(body for _, body in fields)


ISO_FIRST = Block(
    180,
    40,
    (
        *_level("main", 0, 180, 40),
        *_upright("main", 0, 40, 0),
        *_level("thin", 0, 180, 30),
        *_level("thin", 48, 180, 20),
        *_level("thin", 120, 180, 9),
        *_upright("thin", 30, 40, 36, 72, 108, 144),
        *_upright("thin", 0, 30, 48),
        *_upright("thin", 0, 20, 120),
        *_upright("thin", 20, 30, 120, 155),
        *_upright("thin", 0, 9, 132, 155, 165),
    ),
    *_fields(
        _field(
            said("Responsible department", context="title block"),
            "department",
            Box(0, 30, 36, 40),
            TEXT,
            2,
        ),
        _field(
            said("Technical reference", context="title block"),
            "technical_by",
            Box(36, 30, 72, 40),
            TEXT,
            2,
        ),
        _field(said("Creator", context="title block"), "drawn_by", Box(72, 30, 108, 40), TEXT, 2),
        _field(
            said("Checked by", context="title block"), "checked_by", Box(108, 30, 144, 40), TEXT, 2
        ),
        _field(
            said("Approval person", context="title block"),
            "approved_by",
            Box(144, 30, 180, 40),
            TEXT,
            2,
        ),
        _field(
            said("Legal owner", context="title block"), "organisation", Box(0, 0, 48, 30), TEXT, 4
        ),
        _field(
            said("Document type", context="title block"),
            "document_type",
            Box(48, 20, 120, 30),
            TEXT,
            2,
        ),
        _field(
            said("Document status", context="title block"), "status", Box(120, 20, 155, 30), TEXT, 2
        ),
        _field(said("Scale", context="title block"), "scale", Box(155, 20, 180, 30), TEXT, 2),
        _field(
            said("Title, supplementary title", context="title block"),
            "name",
            Box(48, 0, 120, 20),
            (5, 3.5, 2.5),
            3,
        ),
        _field(
            said("Identification number", context="title block"),
            "designation",
            Box(120, 9, 180, 20),
            (5, 3.5, 2.5, 1.8),
            2,
        ),
        _field(said("Rev.", context="title block"), "revision", Box(120, 0, 132, 9), SMALL),
        _field(said("Date of issue", context="title block"), "date", Box(132, 0, 155, 9), SMALL),
        _field(said("Lang.", context="title block"), "language", Box(155, 0, 165, 9), SMALL),
        _field(said("Sheet", context="title block"), "sheet", Box(165, 0, 180, 9), SMALL),
    ),
)
"""The first English sheet: 180 × 40, the data fields of ISO 7200 in an arrangement of our own."""

ISO_NEXT = Block(
    180,
    10,
    (
        *_level("main", 0, 180, 10),
        *_upright("main", 0, 10, 0),
        *_upright("thin", 0, 10, 28, 76, 120, 132, 155, 165),
    ),
    *_fields(
        _field(
            said("Legal owner", context="title block"), "organisation", Box(0, 0, 28, 10), TEXT, 2
        ),
        _field(
            said("Title, supplementary title", context="title block"),
            "name",
            Box(28, 0, 76, 10),
            TEXT,
            2,
        ),
        _field(
            said("Identification number", context="title block"),
            "designation",
            Box(76, 0, 120, 10),
            TEXT,
            2,
        ),
        _field(said("Rev.", context="title block"), "revision", Box(120, 0, 132, 10), SMALL),
        _field(said("Date of issue", context="title block"), "date", Box(132, 0, 155, 10), SMALL),
        _field(said("Lang.", context="title block"), "language", Box(155, 0, 165, 10), SMALL),
        _field(said("Sheet", context="title block"), "sheet", Box(165, 0, 180, 10), SMALL),
    ),
)
"""The following English sheets: 180 × 10."""


def ruled(block: Block, at: complex) -> tuple[Stroke, ...]:
    """Return the lines of a block whose lower left corner stands at ``at`` (complex, mm)."""
    return tuple(
        line(pen, at + complex(a, b), at + complex(c, d)) for pen, a, b, c, d in block.ruling
    )


def lettered(
    block: Block, at: complex, fields: Mapping[str, str], speech: Speech
) -> tuple[Label, ...]:
    """Return the captions of a block in a language, and the entries of ``fields`` that it has a place for.

    Raises SheetError, naming the field, for a character that has no glyph.
    """
    for slot in block.entries:
        bad = letters.missing("".join(fields.get(slot.text, "").split()))
        if bad:
            raise SheetError(
                said(
                    "title block, {text}: no glyph for {bad!r}; write it otherwise",
                    text=slot.text,
                    bad=bad,
                )
            )
    texts = [(speech(slot.text), slot) for slot in block.captions]
    texts += [(fields.get(slot.text, ""), slot) for slot in block.entries]
    labels: list[Label] = []
    for text, slot in texts:
        labels += set_text(text, slot._replace(box=slot.box.moved(at)))
    return tuple(labels)

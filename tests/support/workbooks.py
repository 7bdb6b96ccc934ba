"""Workbooks (xlsx) written by hand, as spreadsheets write them: a ZIP of XML, without a library."""

from __future__ import annotations

import io
import zipfile
from collections.abc import Mapping, Sequence
from typing import NamedTuple
from xml.sax.saxutils import escape

MAIN = "http://schemas.openxmlformats.org/spreadsheetml/2006/main"
OFFICE = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
PACKAGE = "http://schemas.openxmlformats.org/package/2006"
TYPES = "application/vnd.openxmlformats-officedocument.spreadsheetml"
FORMATS = {"0.00": 1, "date": 2, "0%": 3}
"""Formats of cells, by the place of their style."""


class Formula(NamedTuple):
    """A formula, and the result that was saved with it, "" if none was."""

    text: str
    result: str = ""


class Shown(NamedTuple):
    """A number in a format of `FORMATS`."""

    value: float
    form: str


Cell = str | float | Formula | Shown | None


def workbook(
    sheets: Mapping[str, Sequence[Sequence[Cell]]], *, shared: bool = True, dimension: str = ""
) -> bytes:
    """Return a workbook; texts stand in the shared table, as Excel has it, or in their cells."""
    table: list[str] = []
    files = {
        f"xl/worksheets/sheet{k}.xml": _sheet(rows, table if shared else None, dimension)
        for k, rows in enumerate(sheets.values(), 1)
    }
    names = "".join(
        f'<sheet name="{escape(name)}" sheetId="{k}" r:id="rId{k}"/>'
        for k, name in enumerate(sheets, 1)
    )
    links = "".join(
        f'<Relationship Id="rId{k}" Type="{OFFICE}/worksheet" Target="worksheets/sheet{k}.xml"/>'
        for k in range(1, len(sheets) + 1)
    )
    more = len(sheets) + 1
    links += f'<Relationship Id="rId{more}" Type="{OFFICE}/styles" Target="styles.xml"/>'
    links += f'<Relationship Id="rId{more + 1}" Type="{OFFICE}/sharedStrings" Target="sharedStrings.xml"/>'
    files["xl/workbook.xml"] = (
        f'<workbook xmlns="{MAIN}" xmlns:r="{OFFICE}"><sheets>{names}</sheets></workbook>'
    )
    files["xl/_rels/workbook.xml.rels"] = (
        f'<Relationships xmlns="{PACKAGE}/relationships">{links}</Relationships>'
    )
    files["_rels/.rels"] = (
        f'<Relationships xmlns="{PACKAGE}/relationships"><Relationship Id="rId1" '
        f'Type="{OFFICE}/officeDocument" Target="xl/workbook.xml"/></Relationships>'
    )
    files["xl/styles.xml"] = _STYLES
    texts = "".join(f'<si><t xml:space="preserve">{escape(text)}</t></si>' for text in table)
    files["xl/sharedStrings.xml"] = f'<sst xmlns="{MAIN}">{texts}</sst>'
    files["[Content_Types].xml"] = _types(len(sheets))
    return zipped(files)


def zipped(files: Mapping[str, str | bytes]) -> bytes:
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, text in files.items():
            archive.writestr(name, text)
    return out.getvalue()


_STYLES = (
    f'<styleSheet xmlns="{MAIN}"><fonts><font/></fonts>'
    '<fills><fill><patternFill patternType="none"/></fill></fills>'
    "<borders><border/></borders><cellStyleXfs><xf/></cellStyleXfs><cellXfs>"
    '<xf numFmtId="0"/><xf numFmtId="2"/><xf numFmtId="14"/><xf numFmtId="9"/>'
    "</cellXfs></styleSheet>"
)


def _types(count: int) -> str:
    parts = "".join(
        f'<Override PartName="/xl/worksheets/sheet{k}.xml" ContentType="{TYPES}.worksheet+xml"/>'
        for k in range(1, count + 1)
    )
    return (
        f'<Types xmlns="{PACKAGE}/content-types">'
        '<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
        '<Default Extension="xml" ContentType="application/xml"/>'
        f'<Override PartName="/xl/workbook.xml" ContentType="{TYPES}.sheet.main+xml"/>{parts}'
        f'<Override PartName="/xl/styles.xml" ContentType="{TYPES}.styles+xml"/>'
        f'<Override PartName="/xl/sharedStrings.xml" ContentType="{TYPES}.sharedStrings+xml"/></Types>'
    )


def _sheet(rows: Sequence[Sequence[Cell]], table: list[str] | None, dimension: str) -> str:
    told = f'<dimension ref="{dimension}"/>' if dimension else ""
    lines = []
    for line, row in enumerate(rows, 1):
        cells = "".join(
            _cell(f"{chr(65 + k)}{line}", one, table)
            for k, one in enumerate(row)
            if one is not None
        )
        if cells:
            lines.append(f'<row r="{line}">{cells}</row>')
    return f'<worksheet xmlns="{MAIN}">{told}<sheetData>{"".join(lines)}</sheetData></worksheet>'


def _cell(at: str, value: Cell, table: list[str] | None) -> str:
    if isinstance(value, Formula):
        result = f"<v>{value.result}</v>" if value.result else ""
        return f'<c r="{at}"><f>{escape(value.text)}</f>{result}</c>'
    if isinstance(value, Shown):
        return f'<c r="{at}" s="{FORMATS[value.form]}"><v>{value.value!r}</v></c>'
    if isinstance(value, str) and table is not None:
        table.append(value)
        return f'<c r="{at}" t="s"><v>{len(table) - 1}</v></c>'
    if isinstance(value, str):
        return f'<c r="{at}" t="inlineStr"><is><t>{escape(value)}</t></is></c>'
    return f'<c r="{at}"><v>{value!r}</v></c>'

"""What a word processor is given beside the text: styles, page, contents; the same bytes whenever it is made.

The reference document is made here, so that nothing of it depends on who has installed what: page and margins,
fonts and sizes by ГОСТ 2.105 and 7.32, English notes a little closer.
"""

from __future__ import annotations

import io
import math
import re
import zipfile
from collections.abc import Sequence
from itertools import takewhile
from typing import NamedTuple
from xml.sax.saxutils import escape

from graphic_tmm.language.catalogue import code_of, speaking
from graphic_tmm.note.columns import PAGE
from graphic_tmm.note.document import Break, Document, Paragraph, Table, Text
from graphic_tmm.note.target import CONTENTS, Outline

EPOCH = (1980, 1, 1, 0, 0, 0)
"""When everything in the file was made: it does not tell."""
BREAK = '<w:p><w:r><w:br w:type="page"/></w:r></w:p>'
_W = "http://schemas.openxmlformats.org/wordprocessingml/2006/main"
_R = "http://schemas.openxmlformats.org/officeDocument/2006/relationships"
_TYPES = "application/vnd.openxmlformats-officedocument.wordprocessingml"
_HEAD = '<?xml version="1.0" encoding="UTF-8" standalone="yes"?>\n'
FONT = "Times New Roman"
MARGINS = (30, 15, 20, 20)
"""White at the left, right, top and bottom of a page, mm (ГОСТ 2.105)."""
NEARER = 1.1
"""How far lines stand apart in notes that are not Russian: as in their PDF."""
TWIP = 56.6929
"""Twentieths of a point a millimetre has."""


UNRULED = "Unruled"
"""The style of a table without lines."""
WIDTH, HEIGHT = 453.0, 690.0
"""Of the text on the narrower and the lower page, pt."""
LETTER, LEADING, ROW = 0.5, 1.15, 22.0
"""How wide a letter is at the most on average, how far lines stand apart, em; a row of who signs, pt."""
FILLED = 0.98
"""So much of the title page is filled; the rest is for what fonts of other computers take more."""


class Style(NamedTuple):
    """A style of paragraphs: its name, size (pt), alignment, room above and below (pt), indents (mm), lines."""

    name: str
    size: float
    align: str = "both"
    above: float = 0.0
    below: float = 0.0
    first: float = 0.0
    line: float = 1.5
    bold: bool = False
    italic: bool = False
    kept: bool = False
    level: int = 0


def _styles(lines: float) -> tuple[Style, ...]:
    """Return the styles that pandoc asks for by name; ``lines``: how far lines stand apart."""
    return (
        Style("Body Text", 12, first=12.5, line=lines),
        Style("First Paragraph", 12, first=12.5, line=lines),
        Style("Compact", 10, "left", line=1.0),
        Style("heading 1", 14, "left", 18, 10, 12.5, 1.15, bold=True, kept=True, level=1),
        Style("heading 2", 13, "left", 14, 8, 12.5, 1.15, bold=True, kept=True, level=2),
        Style("heading 3", 12, "left", 10, 6, 12.5, 1.15, italic=True, kept=True, level=3),
        Style("Table Caption", 12, "left", 10, 3, line=1.0, kept=True),
        Style("Image Caption", 12, "center", 3, 12, line=1.0),
        Style("Figure", 12, "center", 10, 0, line=1.0, kept=True),
        Style("Captioned Figure", 12, "center", 10, 0, line=1.0, kept=True),
        Style("ragged", 12, "left", first=12.5, line=lines),
        Style("leading", 12, first=12.5, line=lines, kept=True),
        Style("whole", 12, "center", line=lines, kept=True),
        Style("title", 18, "center", 12, 12, line=1.15, bold=True),
        Style("centre", 12, "center", 0, 6, line=1.15),
        Style("signed", 12, "left", 0, 4, line=1.0),
        Style("space", 14, "center", 60, 0, line=1.0),
        Style("toc 1", 12, "left", 1, 1, line=1.0),
        Style("toc 2", 12, "left", 0, 0, 6, line=1.0),
        Style("TOC Heading", 16, "center", 0, 12, line=1.15, bold=True),
        Style("footer", 12, "center", line=1.0),
    )


def empty(document: Document) -> str:
    """Return an empty line of the title page: so high that its last line stands at the foot of the page."""
    page = list(takewhile(lambda block: not isinstance(block, Break), document.blocks))
    known = {one.name: one for one in _styles(1.5)}
    spaces = sum(isinstance(one, Paragraph) and one.style == "space" for one in page)
    taken = 0.0
    for block in page:
        if isinstance(block, Table):
            taken += ROW * len(block.rows)
        elif isinstance(block, Paragraph):
            style = known.get(block.style, known["Body Text"])
            words = "".join(run.text for run in block.runs if isinstance(run, Text))
            lines = math.ceil(max(len(words), 1) * style.size * LETTER / WIDTH)
            taken += lines * style.size * LEADING * style.line + style.below
            taken += style.above if block.style != "space" else 0.0
    above = max(0, round(20 * (FILLED * HEIGHT - taken) / max(spaces, 1)))
    return f'<w:p><w:pPr><w:pStyle w:val="Space"/><w:spacing w:before="{above}"/></w:pPr></w:p>'


def reference(language: str) -> bytes:
    """Return the document whose styles and page pandoc takes."""
    parts = {
        "[Content_Types].xml": _content_types(),
        "_rels/.rels": _relations([("rId1", "officeDocument", "word/document.xml")]),
        "word/document.xml": _document(MARGINS),
        "word/_rels/document.xml.rels": _relations(
            [("rId1", "styles", "styles.xml"), ("rId2", "footer", "footer1.xml")]
        ),
        "word/styles.xml": _style_sheet(language, 1.5 if code_of(language) == "ru" else NEARER),
        "word/footer1.xml": _footer(),
    }
    return zipped([(name, text.encode("utf-8")) for name, text in parts.items()])


def zipped(parts: Sequence[tuple[str, bytes]]) -> bytes:
    """Return a zip file that tells no time."""
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, data in parts:
            entry = zipfile.ZipInfo(name, EPOCH)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = 0o644 << 16
            archive.writestr(entry, data)
    return out.getvalue()


def _content_types() -> str:
    overrides = [("document", "document.main"), ("styles", "styles"), ("footer1", "footer")]
    told = "".join(
        f'<Override PartName="/word/{part}.xml" ContentType="{_TYPES}.{kind}+xml"/>'
        for part, kind in overrides
    )
    return (
        f'{_HEAD}<Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">'
        '<Default Extension="rels" '
        'ContentType="application/vnd.openxmlformats-package.relationships+xml"/>'
        f'<Default Extension="xml" ContentType="application/xml"/>{told}</Types>'
    )


def _relations(found: Sequence[tuple[str, str, str]]) -> str:
    told = "".join(
        f'<Relationship Id="{id}" Type="{_R}/{kind}" Target="{target}"/>'
        for id, kind, target in found
    )
    space = "http://schemas.openxmlformats.org/package/2006/relationships"
    return f'{_HEAD}<Relationships xmlns="{space}">{told}</Relationships>'


def _document(margins: tuple[int, int, int, int]) -> str:
    left, right, top, bottom = (round(one * TWIP) for one in margins)
    return (
        f'{_HEAD}<w:document xmlns:w="{_W}" xmlns:r="{_R}"><w:body><w:p/><w:sectPr>'
        '<w:footerReference w:type="default" r:id="rId2"/><w:pgSz w:w="11906" w:h="16838"/>'
        f'<w:pgMar w:top="{top}" w:right="{right}" w:bottom="{bottom}" w:left="{left}" '
        'w:header="567" w:footer="567" w:gutter="0"/><w:titlePg/></w:sectPr></w:body></w:document>'
    )


def _footer() -> str:
    field = "".join(
        f"<w:r>{one}</w:r>"
        for one in (
            '<w:fldChar w:fldCharType="begin"/>',
            '<w:instrText xml:space="preserve"> PAGE </w:instrText>',
            '<w:fldChar w:fldCharType="end"/>',
        )
    )
    return (
        f'{_HEAD}<w:ftr xmlns:w="{_W}"><w:p><w:pPr><w:pStyle w:val="Footer"/></w:pPr>{field}</w:p>'
        "</w:ftr>"
    )


def _style_sheet(language: str, lines: float) -> str:
    code = code_of(language)
    lang = {"ru": "ru-RU", "en": "en-GB"}.get(code, code)
    fonts = f'<w:rFonts w:ascii="{FONT}" w:hAnsi="{FONT}" w:eastAsia="{FONT}" w:cs="{FONT}"/>'
    defaults = (
        f'<w:docDefaults><w:rPrDefault><w:rPr>{fonts}<w:sz w:val="24"/><w:szCs w:val="24"/>'
        f'<w:lang w:val="{lang}" w:eastAsia="{lang}" w:bidi="ar-SA"/></w:rPr></w:rPrDefault>'
        "<w:pPrDefault/></w:docDefaults>"
    )
    normal = (
        '<w:style w:type="paragraph" w:default="1" w:styleId="Normal"><w:name w:val="Normal"/>'
        "<w:qFormat/></w:style>"
        '<w:style w:type="character" w:default="1" w:styleId="DefaultParagraphFont">'
        '<w:name w:val="Default Paragraph Font"/></w:style>'
        '<w:style w:type="character" w:styleId="Hyperlink"><w:name w:val="Hyperlink"/></w:style>'
    )
    edges = "".join(
        f'<w:{side} w:val="single" w:sz="4" w:space="0" w:color="auto"/>'
        for side in ("top", "left", "bottom", "right", "insideH", "insideV")
    )
    table = (
        '<w:style w:type="table" w:default="1" w:styleId="TableNormal">'
        '<w:name w:val="Normal Table"/></w:style>'
        '<w:style w:type="table" w:styleId="Table"><w:name w:val="Table"/>'
        f'<w:basedOn w:val="TableNormal"/><w:tblPr><w:tblBorders>{edges}</w:tblBorders>'
        '<w:tblCellMar><w:left w:w="40" w:type="dxa"/><w:right w:w="40" w:type="dxa"/></w:tblCellMar>'
        "</w:tblPr></w:style>"
        f'<w:style w:type="table" w:styleId="{UNRULED}"><w:name w:val="{UNRULED}"/>'
        '<w:basedOn w:val="TableNormal"/></w:style>'
    )
    told = "".join(map(_style, _styles(lines)))
    return f'{_HEAD}<w:styles xmlns:w="{_W}">{defaults}{normal}{told}{table}</w:styles>'


def style_id(name: str) -> str:
    """Return the id of a style: its words, each with a capital, run together."""
    return "".join(word[:1].upper() + word[1:] for word in name.split())


def _style(one: Style) -> str:
    paragraph = "<w:keepNext/>" if one.kept else ""
    paragraph += (
        f'<w:spacing w:before="{round(one.above * 20)}" w:after="{round(one.below * 20)}" '
        f'w:line="{round(one.line * 240)}" w:lineRule="auto"/>'
    )
    if one.first:
        kind = "left" if one.name.startswith("toc") else "firstLine"
        paragraph += f'<w:ind w:{kind}="{round(one.first * TWIP)}"/>'
    paragraph += f'<w:jc w:val="{one.align}"/>'
    if one.level:
        paragraph += f'<w:outlineLvl w:val="{one.level - 1}"/>'
    run = ("<w:b/>" if one.bold else "") + ("<w:i/>" if one.italic else "")
    size = round(one.size * 2)
    run += f'<w:sz w:val="{size}"/><w:szCs w:val="{size}"/>'
    return (
        f'<w:style w:type="paragraph" w:styleId="{style_id(one.name)}"><w:name w:val="{one.name}"/>'
        f'<w:basedOn w:val="Normal"/><w:qFormat/><w:pPr>{paragraph}</w:pPr><w:rPr>{run}</w:rPr></w:style>'
    )


# ---------------------------------------------------------------- contents


def contents(outline: Outline, language: str) -> str:
    """Return the contents as a field that a word processor keeps; until it does, a list of the headings."""
    shown = [entry for entry in outline if entry.level <= 2]
    begin = (
        '<w:r><w:fldChar w:fldCharType="begin" w:dirty="true"/></w:r>'
        '<w:r><w:instrText xml:space="preserve">TOC \\o "1-2" \\h \\z \\u</w:instrText></w:r>'
        '<w:r><w:fldChar w:fldCharType="separate"/></w:r>'
    )
    end = '<w:r><w:fldChar w:fldCharType="end"/></w:r>'
    lines = []
    for k, entry in enumerate(shown):
        link = (
            f'<w:hyperlink w:anchor="{entry.id}"><w:r><w:t xml:space="preserve">{escape(entry.text)}</w:t>'
            "</w:r></w:hyperlink>"
        )
        lines.append(
            f'<w:p><w:pPr><w:pStyle w:val="Toc{entry.level}"/></w:pPr>{begin if k == 0 else ""}{link}'
            f"{end if k == len(shown) - 1 else ''}</w:p>"
        )
    title = escape(speaking(language)(CONTENTS))
    return (
        '<w:sdt><w:sdtPr><w:docPartObj><w:docPartGallery w:val="Table of Contents"/><w:docPartUnique/>'
        f'</w:docPartObj></w:sdtPr><w:sdtContent><w:p><w:pPr><w:pStyle w:val="TOCHeading"/></w:pPr>'
        f"<w:r><w:t>{title}</w:t></w:r></w:p>{''.join(lines)}</w:sdtContent></w:sdt>{BREAK}"
    )


# ---------------------------------------------------------------- afterwards

_TITLE = re.compile(r'<w:p>\s*<w:pPr>\s*<w:pStyle w:val="Title" />\s*</w:pPr>.*?</w:p>', re.DOTALL)
_SIGNED = re.compile(rf'<w:tblStyle w:val="{UNRULED}" />.*?</w:tbl>', re.DOTALL)
_TABLES = re.compile(r"<w:tbl>.*?</w:tbl>", re.DOTALL)
_GRID = re.compile(r'<w:gridCol w:w="(\d+)" />')
_WIDE = re.compile(r"<w:tblW [^>]*/>")
_MATHS = re.compile(r"(<m:r>(?:\s*<m:rPr>.*?</m:rPr>)?)", re.DOTALL)
SMALL = '<w:rPr><w:rFonts w:ascii="Cambria Math" w:hAnsi="Cambria Math"/><w:sz w:val="20"/></w:rPr>'
"""How a formula in a table is set: as small as its words."""
_ROWS = re.compile(r"<w:tr>\s*(?:<w:trPr>(.*?)</w:trPr>)?", re.DOTALL)
_INLINE = "<wp:inline>"
_CLOSE = '<wp:inline distT="0" distB="0" distL="0" distR="0">'
"""A picture without white about it, which some word processors else put there."""
PANDOC = 7920
"""The width of the text that pandoc divides among columns, twentieths of a point."""
_SIGN = r'<m:r>\s*<m:rPr>\s*(<m:sty m:val="p" />)\s*</m:rPr>\s*<m:t[^>]*>({signs})</m:t>'
_LOOSE = re.compile(_SIGN.format(signs=r"[][()|∗*]"))
_LEADING = re.compile(r"(<m:oMath>\s*)" + _SIGN.format(signs="[=≠≤≥<>]"))
"""Brackets that no other answers, and signs at the beginning of a line: they are letters, not operators."""
_DATES = re.compile(r"<dcterms:(created|modified).*?</dcterms:\1>", re.DOTALL)


def without_title(made: bytes, centred: Sequence[str] = ()) -> bytes:
    """Return a document without the title that pandoc puts above all, without dates, its parts in one order.

    ``centred``: the ids of headings that stand in the middle.
    """
    with zipfile.ZipFile(io.BytesIO(made)) as archive:
        parts = {name: archive.read(name) for name in archive.namelist()}
    text = _TITLE.sub("", parts["word/document.xml"].decode("utf-8"), count=1)
    for id in centred:
        text = re.sub(
            rf'(w:name="{re.escape(id)}" />\s*<w:p>\s*<w:pPr>\s*<w:pStyle w:val="Heading1" />)',
            r'\1<w:ind w:firstLine="0"/><w:jc w:val="center"/>',
            text,
        )
    text = _SIGNED.sub(lambda found: found[0].replace('"Compact"', '"Signed"'), text)
    text = _LEADING.sub(r"\1<m:r><m:rPr><m:nor />\2</m:rPr><m:t>\3 </m:t>", text)
    text = _LOOSE.sub(r"<m:r><m:rPr><m:nor />\1</m:rPr><m:t>\2</m:t>", text)
    text = _TABLES.sub(_fixed, text).replace(_INLINE, _CLOSE)
    text = _together(text)
    parts["word/document.xml"] = text.encode("utf-8")
    core = "docProps/core.xml"
    if core in parts:
        parts[core] = _DATES.sub("", parts[core].decode("utf-8")).encode("utf-8")
    return zipped(list(parts.items()))


def _together(text: str) -> str:
    """Return a document whose last list stands on one page with its heading, unless it is long.

    The last page of a note would else hold its last two lines.
    """
    at = text.rfind('<w:pStyle w:val="Heading')
    begun, end = text[:at], text[at:]
    last = end.rfind("<w:p>")
    if at < 0 or end.count("<w:p>") > MOST_KEPT or "<w:tbl>" in end:
        return text
    kept = _PROPERTIES.sub(r"<w:pPr>\1<w:keepNext />", end[:last])
    return begun + kept + end[last:]


MOST_KEPT = 20
"""A list of more items than these may be parted by the end of a page."""
_PROPERTIES = re.compile(r"<w:pPr>(\s*(?:<w:pStyle [^>]*/>)?)")


def _fixed(found: re.Match[str]) -> str:
    """Return a table whose columns are as wide as is told, whatever they hold; its rows are whole."""
    page = round(PAGE * TWIP)
    widths = [round(int(one) * page / PANDOC) for one in _GRID.findall(found[0])]
    grid = iter(widths)
    text = _GRID.sub(lambda _: f'<w:gridCol w:w="{next(grid)}" />', found[0])
    text = _WIDE.sub(f'<w:tblW w:type="dxa" w:w="{sum(widths)}" />', text, count=1)
    text = _MATHS.sub(rf"\1{SMALL}", text)
    return _ROWS.sub(lambda row: f"<w:tr><w:trPr><w:cantSplit/>{row[1] or ''}</w:trPr>", text)

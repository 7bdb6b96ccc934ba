"""The files of a note: HTML in one piece, DOCX, Markdown with its figures, PDF; the same bytes always."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from html import escape
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

from graphic_tmm.errors import SheetError
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.note import pandoc, word
from graphic_tmm.note.document import Beside, Document, Picture, Table
from graphic_tmm.note.figures import scales_of, sheet_of
from graphic_tmm.note.numbering import letter_of
from graphic_tmm.note.pandoc import Outline, Target, raw
from graphic_tmm.note.styles import APART, CSS, NEARER, TYPST
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.paper.write.svg import svg

FORMATS = ("pdf", "html", "docx", "md")
"""What a note can be written as."""
CONTENTS = said("Contents")
PPI = 200.0
"""Dots per inch of the figures of a DOCX."""

_MARKED = re.compile(r"\\|~|&(?=#?\w+;)|:(?=[\w+-]+:)|^-(?=-+$)")
"""What pandoc leaves as it is in Markdown, though it means something there."""
_SHORT = re.compile(r"(?<=\.\.)\.")
"""Three points, for which typst has a sign of its own."""

Tree = dict[str, Any]


TALL = 30.0
"""A figure higher than this, mm, may stand at the foot of a page, so that none is left half empty."""


SHORT = 14
"""A table of so many rows stands on one page."""


class Drawn(NamedTuple):
    """A figure ready to be shown: its file's name, its paper, how wide it stands on the page, mm."""

    name: str
    sheet: Sheet
    width: float
    alt: str

    @property
    def height(self) -> float:
        """How high it stands on the page, mm."""
        return self.width * self.sheet.height / self.sheet.width


def drawn_figures(document: Document) -> dict[str, Drawn]:
    """Return the figures of a note by id, each on a paper of its size."""
    found: dict[str, Drawn] = {}
    for block in document.blocks:
        if isinstance(block, Picture | Beside):
            _draw(block, document.language, found)
    return found


def _draw(block: Picture | Beside, language: str, found: dict[str, Drawn]) -> None:
    """Enter a figure, or the parts of one, each with its letter."""
    parts = (block,) if isinstance(block, Picture) else block.parts
    times = scales_of(parts)
    for k, (one, larger) in enumerate(zip(parts, times, strict=True)):
        letter = f"{letter_of(k, language)})" if len(parts) > 1 else ""
        sheet = sheet_of(one.drawing, language, f"figure-{len(found) + 1}", letter, larger)
        found[one.id] = Drawn(sheet.name, sheet, round(sheet.width * larger, 1), one.alt)


def files(document: Document, stem: str, formats: Sequence[str]) -> dict[str, str | bytes]:
    """Return the files of a note by name.

    Raises
    ------
    SheetError
        If what writes a format is not installed.
    """
    refuse_missing(formats)
    shown = drawn_figures(document)
    found: dict[str, str | bytes] = {}
    for form in formats:
        found |= WRITERS[form](document, stem, shown)
    return found


def refuse_missing(formats: Sequence[str]) -> None:
    """Refuse formats whose writers are not installed.

    Raises
    ------
    SheetError
        If one is not there; says how to install it.
    """
    pandoc.program()
    for form in formats:
        if form in ("pdf", "docx"):
            _typst(form)


# ---------------------------------------------------------------- HTML


def html(document: Document, stem: str, shown: Mapping[str, Drawn]) -> dict[str, str | bytes]:
    """Return a page that needs no other file: figures drawn in it, formulas as MathML."""

    def picture(block: Picture) -> Tree:
        return raw("html", _inline(shown[block.id]))

    target = Target(
        "html5",
        picture,
        _navigated(document.language),
        lambda: [],
        ("--mathml", "--wrap=none"),
        headed=True,
    )
    body = _scoped(pandoc.written(document, target).decode("utf-8"))
    title, lang = escape(document.title), escape(document.language)
    page = (
        f'<!doctype html>\n<html lang="{lang}">\n<head>\n<meta charset="utf-8">\n'
        f'<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f"<title>{title}</title>\n<style>\n{CSS}</style>\n</head>\n<body>\n<main>\n{body}</main>\n"
        "</body>\n</html>\n"
    )
    return {f"{stem}.html": page}


def _inline(one: Drawn) -> str:
    """Return a figure as an element of a page: an image to who does not see it."""
    text = svg(one.sheet)
    text = text[text.index("<svg") :]
    head, rest = text.split(">", 1)
    head = re.sub(r' (?:width|height)="[^"]*mm"', "", head)
    label = escape(one.alt, quote=True)
    return f'{head} role="img" aria-label="{label}" style="width:{one.width}mm">{rest}'


def _scoped(body: str) -> str:
    """Return a page on which heads of tables tell what they are heads of; tables without heads are none.

    Each stands in a box, which keys can move where a table is wider than its window.
    """
    parts = re.split(r"(<thead>.*?</thead>)", body, flags=re.DOTALL)
    told = [
        part.replace("<th ", f'<th scope="{"col" if part.startswith("<thead>") else "row"}" ')
        for part in parts
    ]
    page = "".join(told).replace('class="unruled"', 'class="unruled" role="presentation"')
    boxed = page.replace("<table", '<div class="wide" tabindex="0"><table')
    boxed = _MATHS.sub(_moving, boxed.replace("</table>", "</table></div>"))
    return _HEADS.sub(_spoken, boxed)


_MATHS = re.compile(r"<math (display=[^>]*>)(.*?)</math>", re.DOTALL)
_HEADS = re.compile(r'(<th scope="row"[^>]*><math)( .*?</math>)', re.DOTALL)
_UNSEEN = re.compile(r"<annotation.*?</annotation>|<[^>]*>|\s", re.DOTALL)
_LONG = 30
"""A formula of more letters may be wider than a window held in the hand."""


def _spoken(found: re.Match[str]) -> str:
    """Return a head of a row that begins with a formula, whose letters are told to those who do not see it."""
    letters = _UNSEEN.sub("", found[2].partition(">")[2])
    return f'{found[1]} aria-label="{letters}"{found[2]}'


def _moving(found: re.Match[str]) -> str:
    """Return a formula; one that may be wider than a window moves in its own box, and keys can move it."""
    if len(_UNSEEN.sub("", found[2])) <= _LONG:
        return found[0]
    return f'<math class="wide" tabindex="0" {found[1]}{found[2]}</math>'


def _navigated(language: str) -> Callable[[Outline], list[Tree]]:
    """Return the contents as a part of the page by which one finds one's way in it."""
    label = escape(speaking(language)(CONTENTS), quote=True)

    def told(outline: Outline) -> list[Tree]:
        opening = raw("html", f'<nav aria-label="{label}">', block=True)
        return [opening, *_listed_contents(language)(outline), raw("html", "</nav>", block=True)]

    return told


def _listed_contents(language: str, *, linked: bool = True) -> Callable[[Outline], list[Tree]]:
    """Return the contents as a list, of links if places have names."""

    def told(outline: Outline) -> list[Tree]:
        items: list[list[Tree]] = []
        for entry in outline:
            if entry.level > 2:
                continue
            words = [{"t": "Str", "c": entry.text}]
            link = {"t": "Link", "c": [pandoc.NONE, words, [f"#{entry.id}", ""]]}
            plain = {"t": "Plain", "c": [link] if linked else words}
            if entry.level == 1 or not items:
                items.append([plain])
            elif len(items[-1]) == 1:
                items[-1].append({"t": "BulletList", "c": [[plain]]})
            else:
                items[-1][1]["c"].append([plain])
        title = {
            "t": "Para",
            "c": [{"t": "Strong", "c": [{"t": "Str", "c": speaking(language)(CONTENTS)}]}],
        }
        return [title, {"t": "BulletList", "c": items}]

    return told


# ---------------------------------------------------------------- Markdown


def markdown(document: Document, stem: str, shown: Mapping[str, Drawn]) -> dict[str, str | bytes]:
    """Return the note as Markdown, and its figures as files beside it."""

    def picture(block: Picture) -> Tree:
        one = shown[block.id]
        words = [{"t": "Str", "c": one.alt}]
        return {"t": "Image", "c": [pandoc.NONE, words, [f"{stem}-{one.name}.svg", ""]]}

    target = Target(
        pandoc.MARKDOWN[0],
        picture,
        _listed_contents(document.language, linked=False),
        lambda: [{"t": "HorizontalRule"}],
        ("--wrap=none",),
        _emphasised,
        captioned=False,
        linked=False,
        word=pandoc.escaped(pandoc.MARKDOWN[0].partition("+")[0], _MARKED),
    )
    found: dict[str, str | bytes] = {f"{stem}.md": pandoc.written(document, target).decode("utf-8")}
    for one in shown.values():
        found[f"{stem}-{one.name}.svg"] = svg(one.sheet)
    return found


def _emphasised(block: Tree, style: str) -> list[Tree]:
    """Return a paragraph of the title page as Markdown has it."""
    if style == "space":
        return []
    if style in (pandoc.RAGGED, pandoc.LEADING):
        return [block]
    strong = {"t": "Strong", "c": block["c"]}
    return [{"t": "Para", "c": [strong]}] if style == "title" else [block]


# ---------------------------------------------------------------- PDF


def pdf(document: Document, stem: str, shown: Mapping[str, Drawn]) -> dict[str, str | bytes]:
    """Return the note as PDF: tagged, with bookmarks, its title and its language."""
    typst = _typst("pdf")

    def figure(block: Picture | Beside, caption: Tree) -> list[Tree]:
        parts = [shown[one.id] for one in (block.parts if isinstance(block, Beside) else [block])]
        told = [
            f'image("{one.name}.svg", width: {one.width}mm, alt: {quoted(one.alt)})'
            for one in parts
        ]
        image = told[0] if len(told) == 1 else f"beside({', '.join(told)})"
        where = "auto" if max(one.height for one in parts) > TALL else "none"
        opening = f"#figure(placement: {where}, kind: image, supplement: none, {image}, caption: ["
        closing = raw("typst", f"]) <{block.id}>", block=True)
        return [raw("typst", opening, block=True), caption, closing]

    contents = f"#contents({quoted(speaking(document.language)(CONTENTS))})"
    target = Target(
        "typst",
        lambda block: raw("typst", ""),
        lambda outline: [raw("typst", contents, block=True)],
        lambda: [raw("typst", "#pagebreak(weak: true)", block=True)],
        ("--wrap=none",),
        _set,
        _tabled,
        _part,
        figure=figure,
        word=pandoc.escaped("typst", _SHORT),
    )
    body = pandoc.written(document, target).decode("utf-8")
    head = (
        f"#set document(title: {quoted(document.title)}, date: none)\n"
        f"#set text(lang: {quoted(document.language)})\n"
        f"#let apart = {APART.get(document.language, NEARER)}\n"
    )
    with TemporaryDirectory() as folder:
        home = Path(folder)
        for one in shown.values():
            (home / f"{one.name}.svg").write_text(svg(one.sheet), encoding="utf-8")
        (home / "note.typ").write_text(f"{head}{TYPST}{body}", encoding="utf-8")
        made = typst.compile(
            str(home / "note.typ"), root=folder, format="pdf", ignore_system_fonts=True
        )
    return {f"{stem}.pdf": made}


def _set(block: Tree, style: str) -> list[Tree]:
    """Return a paragraph of the title page as typst sets it."""
    if style == "space":
        return [raw("typst", "#v(1fr)", block=True)]
    if style in (pandoc.RAGGED, pandoc.LEADING):
        return [raw("typst", f"#{style}[", block=True), block, raw("typst", "]", block=True)]
    opening = "#great[" if style == "title" else "#centred["
    return [raw("typst", opening, block=True), block, raw("typst", "]", block=True)]


def _part(heading: Tree) -> list[Tree]:
    """Return a heading as typst sets it in the middle."""
    return [raw("typst", "#part[", block=True), heading, raw("typst", "]", block=True)]


def _tabled(made: Tree, table: Table) -> list[Tree]:
    """Return a table as typst sets it: without lines if it has none, on one page if it is short."""
    if table.long:
        return [raw("typst", "#long[", block=True), made, raw("typst", "]", block=True)]
    if table.ruled and not table.apart and len(table.rows) > SHORT:
        return [made]
    kind = "bare" if not table.ruled else "apart-whole" if table.apart else "whole"
    opening = raw("typst", f"#{kind}[", block=True)
    return [opening, made, raw("typst", "]", block=True)]


def quoted(text: str) -> str:
    """Return a text as typst writes it."""
    return '"{}"'.format(" ".join(text.split()).replace("\\", "\\\\").replace('"', '\\"'))


def _typst(form: str) -> Any:
    try:
        import typst
    except ImportError as error:
        raise SheetError(
            said(
                "a note as {form} needs the package typst: pip install 'graphic-tmm[note]'",
                form=form,
            )
        ) from error
    return typst


# ---------------------------------------------------------------- DOCX


def docx(document: Document, stem: str, shown: Mapping[str, Drawn]) -> dict[str, str | bytes]:
    """Return the note as DOCX: formulas are those of a word processor, figures pictures."""
    typst = _typst("docx")

    def picture(block: Picture) -> Tree:
        one = shown[block.id]
        words = [{"t": "Str", "c": one.alt}]
        attributes = ["", [], [["width", f"{one.width}mm"]]]
        return {"t": "Image", "c": [attributes, words, [f"{one.name}.png", ""]]}

    def styled(block: Tree, style: str) -> list[Tree]:
        if style == "space":
            return [raw("openxml", word.empty(document), block=True)]
        return [pandoc.classed(block, style)]

    with TemporaryDirectory() as folder:
        home = Path(folder)
        _pictures(typst, home, list(shown.values()))
        (home / "reference.docx").write_bytes(word.reference(document.language))
        target = Target(
            "docx",
            picture,
            lambda outline: [raw("openxml", word.contents(outline, document.language), block=True)],
            lambda: [raw("openxml", word.BREAK, block=True)],
            ("--reference-doc=reference.docx",),
            styled,
            _bare,
            styled_rows=True,
        )
        pandoc.written(document, target, out="note.docx", folder=folder)
        made = word.settled((home / "note.docx").read_bytes(), pandoc.parts(document))
    return {f"{stem}.docx": made}


def _bare(made: Tree, table: Table) -> list[Tree]:
    """Return a table as a word processor is told it: of a style of its own if it has no lines."""
    if not table.ruled:
        made["c"][0][2].append(["custom-style", word.UNRULED])
    return [made]


def _pictures(typst: Any, home: Path, shown: Sequence[Drawn]) -> None:
    """Paint figures, all at once, as files beside the document."""
    if not shown:
        return
    lines = []
    for one in shown:
        (home / f"{one.name}.svg").write_text(svg(one.sheet), encoding="utf-8")
        size = f"width: {one.sheet.width:.3f}mm, height: {one.sheet.height:.3f}mm"
        lines.append(f'#page({size}, margin: 0pt)[#image("{one.name}.svg", {size})]')
    (home / "figures.typ").write_text("\n".join(lines), encoding="utf-8")
    widest = [one.width / one.sheet.width for one in shown]
    made = typst.compile(
        str(home / "figures.typ"), root=str(home), format="png", ppi=PPI * max(*widest, 0.5)
    )
    painted = made if isinstance(made, list) else [made]
    for one, image in zip(shown, painted, strict=True):
        (home / f"{one.name}.png").write_bytes(image)


WRITERS: Mapping[str, Callable[[Document, str, Mapping[str, Drawn]], dict[str, str | bytes]]] = {
    "pdf": pdf,
    "html": html,
    "docx": docx,
    "md": markdown,
}

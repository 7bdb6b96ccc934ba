"""The files of a note: HTML in one piece, DOCX, Markdown with its figures, PDF; the same bytes always."""

from __future__ import annotations

import re
from collections.abc import Callable, Mapping, Sequence
from html import escape
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from graphic_tmm.language.catalogue import speaking
from graphic_tmm.note import pandoc, word
from graphic_tmm.note.document import Document, Picture, ReadyPicture, Table
from graphic_tmm.note.figures import DrawnFigure, drawn_figures
from graphic_tmm.note.pdf import pdf, typesetter
from graphic_tmm.note.styles import CSS
from graphic_tmm.note.target import (
    CONTENTS,
    LEADING,
    NONE,
    RAGGED,
    Outline,
    Target,
    Tree,
    classed,
    escaped,
    raw,
)

FORMATS = ("pdf", "html", "docx", "md")
"""What a note can be written as."""
PPI = 200.0
"""Dots per inch of the figures of a DOCX."""

_MARKED = re.compile(r"\\|~|&(?=#?\w+;)|:(?=[\w+-]+:)|^-(?=-+$)")
"""What pandoc leaves as it is in Markdown, though it means something there."""


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
            typesetter(form)


# ---------------------------------------------------------------- HTML


def html(document: Document, stem: str, shown: Mapping[str, DrawnFigure]) -> dict[str, str | bytes]:
    """Return a page that needs no other file: figures drawn in it, formulas as MathML."""

    def picture(block: Picture | ReadyPicture) -> Tree:
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


def _inline(one: DrawnFigure) -> str:
    """Return a figure as an element of a page: an image to who does not see it."""
    text = one.svg
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

    def entries(outline: Outline) -> list[Tree]:
        opening = raw("html", f'<nav aria-label="{label}">', block=True)
        return [opening, *_listed_contents(language)(outline), raw("html", "</nav>", block=True)]

    return entries


def _listed_contents(language: str, *, linked: bool = True) -> Callable[[Outline], list[Tree]]:
    """Return the contents as a list, of links if places have names."""

    def entries(outline: Outline) -> list[Tree]:
        items: list[list[Tree]] = []
        for entry in outline:
            if entry.level > 2:
                continue
            words = [{"t": "Str", "c": entry.text}]
            link = {"t": "Link", "c": [NONE, words, [f"#{entry.id}", ""]]}
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

    return entries


# ---------------------------------------------------------------- Markdown


def markdown(
    document: Document, stem: str, shown: Mapping[str, DrawnFigure]
) -> dict[str, str | bytes]:
    """Return the note as Markdown, and its figures as files beside it."""

    def picture(block: Picture | ReadyPicture) -> Tree:
        one = shown[block.id]
        words = [{"t": "Str", "c": one.alt}]
        return {"t": "Image", "c": [NONE, words, [f"{stem}-{one.name}.svg", ""]]}

    target = Target(
        pandoc.MARKDOWN[0],
        picture,
        _listed_contents(document.language, linked=False),
        lambda: [{"t": "HorizontalRule"}],
        ("--wrap=none",),
        _emphasised,
        captioned=False,
        linked=False,
        word=escaped(pandoc.MARKDOWN[0].partition("+")[0], _MARKED),
    )
    found: dict[str, str | bytes] = {f"{stem}.md": pandoc.written(document, target).decode("utf-8")}
    for one in shown.values():
        found[f"{stem}-{one.name}.svg"] = one.svg
    return found


def _emphasised(block: Tree, style: str) -> list[Tree]:
    """Return a paragraph of the title page as Markdown has it."""
    if style == "space":
        return []
    if style in (RAGGED, LEADING):
        return [block]
    strong = {"t": "Strong", "c": block["c"]}
    return [{"t": "Para", "c": [strong]}] if style == "title" else [block]


# ---------------------------------------------------------------- DOCX


def docx(document: Document, stem: str, shown: Mapping[str, DrawnFigure]) -> dict[str, str | bytes]:
    """Return the note as DOCX: formulas are those of a word processor, figures pictures."""
    typst = typesetter("docx")

    def picture(block: Picture | ReadyPicture) -> Tree:
        one = shown[block.id]
        words = [{"t": "Str", "c": one.alt}]
        attributes = ["", [], [["width", f"{one.width}mm"]]]
        return {"t": "Image", "c": [attributes, words, [f"{one.name}.png", ""]]}

    def styled(block: Tree, style: str) -> list[Tree]:
        if style == "space":
            return [raw("openxml", word.empty(document), block=True)]
        return [classed(block, style)]

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
            piece=lambda one: [one],
            measured=True,
            whole=lambda lines: [*(classed(one, "whole") for one in lines[:-1]), lines[-1]],
        )
        pandoc.written(document, target, out="note.docx", folder=folder)
        made = word.without_title((home / "note.docx").read_bytes(), pandoc.parts(document))
    return {f"{stem}.docx": made}


def _bare(made: Tree, table: Table) -> list[Tree]:
    """Return a table as a word processor is told it: of a style of its own if it has no lines."""
    if not table.ruled:
        made["c"][0][2].append(["custom-style", word.UNRULED])
    return [made]


def _pictures(typst: Any, home: Path, shown: Sequence[DrawnFigure]) -> None:
    """Paint figures, all at once, as files beside the document."""
    if not shown:
        return
    lines = []
    for one in shown:
        (home / f"{one.name}.svg").write_text(one.svg, encoding="utf-8")
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


WRITERS: Mapping[
    str, Callable[[Document, str, Mapping[str, DrawnFigure]], dict[str, str | bytes]]
] = {
    "pdf": pdf,
    "html": html,
    "docx": docx,
    "md": markdown,
}

"""The pages of the studio: a scene with its sheets and values, a folder of scenes; what they say.

They hold no more than a frame, words and names; the scripts of ``web/`` ask for all else, and follow it. Every
text goes through a template that escapes it. Addresses within a page are relative, so that it knows no token.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Mapping
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any

from graphic_tmm.errors import SceneError
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.scene.document import parsed
from graphic_tmm.serve.scheme.words import SCHEME_WORDS

if TYPE_CHECKING:
    from jinja2 import Environment


WORDS: dict[str, str] = {
    "sheets": said("Sheets"),
    "page": said("Plans step by step"),
    "values": said("Values"),
    "files": said("Files"),
    "scenes": said("Scenes"),
    "dark": said("Dark or light"),
    "ways": said("Ways to look at the scene"),
    "sheet": said("Sheet {n}"),
    "page of": said("The plans of the scene, step by step"),
    "no page": said("The page is being made."),
    "page failed": said("The page could not be made."),
    "no sheets": said("There is no sheet yet."),
    "larger": said("Larger"),
    "smaller": said("Smaller"),
    "whole": said("The whole sheet"),
    "true size": said("True size"),
    "desk": said(
        "The sheets: arrows move them, + and − zoom, 0 shows a sheet whole, 1 in its true size"
    ),
    "drawing": said("It is being drawn …"),
    "drawn": said("Drawn as the file says."),
    "faults": said("Faults: {n}. The sheets are those of before."),
    "faults first": said("Faults: {n}. Nothing could be drawn yet."),
    "faults page": said("Faults: {n}. The sheets are as the file says, the page is not."),
    "failed": said("Not drawn: {why}."),
    "failed page": said("The sheets are as the file says; their page was not made: {why}."),
    "again": said("Draw again"),
    "own put": said("Put into the scene; the Scheme tab takes it back."),
    "page old": said("This page is out of date: it is of the file as it was before."),
    "faults head": said("What is wrong"),
    "warnings head": said("What to know"),
    "line": said("line {line}"),
    "lost": said(
        "The connection is lost; it is tried again. If the studio has ended, begin it again, and open "
        "the address that it tells."
    ),
    "mended": said("The connection is there again."),
    "written": said("{key}: written into the file."),
    "refused": said("{key}: refused."),
    "conflict": said(
        "The file was changed meanwhile. It has {text} here now; yours was not written: Enter writes it."
    ),
    "nothing there": said("nothing"),
    "not sent": said("It could not be sent; Enter tries again."),
    "no form": said("The file is no TOML: there are no values to set. Mend it in your editor."),
    "fixed": said("A scene of the package is not changed; copy it to a folder of yours first."),
    "find": said("Find a value"),
    "more": said("What else may be written"),
    "default": said("else {default}"),
    "usual": said("left out"),
    "needed": said("has to be written"),
    "on": said("yes"),
    "off": said("no"),
    "form keys": said("Enter writes a value into the file, Escape takes back what was typed."),
    "fine": said("without faults"),
    "waiting": said("not drawn yet"),
    "scene faults": said("faults: {n}"),
    "photo": said("Check a photograph"),
    "photo desk": said(
        "The photograph: Enter places a mark, arrows move it, + and − zoom, 0 shows all of it, Backspace "
        "takes the last mark back"
    ),
    "photo drop": said(
        "Drop a photograph of your drawing here, or choose one: the whole sheet, from straight above, on a "
        "darker table."
    ),
    "photo choose": said("Choose a photograph"),
    "photo other": said("Another photograph"),
    "photo of": said("What is photographed"),
    "photo own": said("My own sheet, {paper}"),
    "photo sheet": said("Sheet {n} as the scene lays it out"),
    "photo plan": said("Plan and position"),
    "photo every": said("Every plan is clicked."),
    "photo pole": said("Click the pole {letter}: {plan}, position {position}."),
    "photo first": said(
        "Click {letter}, the end of its first vector: {plan}, position {position}."
    ),
    "photo paper": said("Click corner {n} of 4 of the paper."),
    "photo frame": said("Click corner {n} of 4 of the frame."),
    "photo laid": said(
        "Nothing has to be clicked on this sheet: check it. A plan that stands elsewhere is clicked."
    ),
    "photo marks": said("Clicked"),
    "photo corners row": said("Corners: {n} of 4"),
    "photo also": said("Click {letter}, too"),
    "photo remove": said("Remove"),
    "photo remove of": said("Remove: {what}"),
    "photo undo": said("Take back"),
    "photo corners": said("Click the corners"),
    "photo corners why": said("Only if they are not found (--corners)."),
    "photo check": said("Check it"),
    "photo need": said("Click the pole and the first vector of a plan first."),
    "photo propose": said("Look for the plans"),
    "photo looked": said(
        "Plans found: {n}. See in the photograph whether each stands right; remove those that do not."
    ),
    "photo begun": said("The photograph is being read …"),
    "photo done": said("The report is there."),
    "photo failed": said("The photograph could not be checked."),
    "photo report": said("Report"),
    "photo seen": said("Photograph"),
    "photo alone": said("The report in a window of its own"),
    "photo stale": said("Something was clicked since: check again."),
    "photo none": said(
        "Nothing can be clicked here: the scene has no plan of velocities or accelerations."
    ),
    "photo unread": said("{name} is no picture that a browser shows: save it as JPEG or PNG."),
    "photo large": said("{name} is larger than 60 MB: make it smaller."),
    "photo loupe": said(
        "What is about the last mark, four times as large: drag it to move the mark"
    ),
    "photo aim": said("Not on the point? Drag in the loupe, or press arrows."),
    "photo command": said("The same at the command line"),
    "no scenes": said("There is no scene in this folder."),
    **SCHEME_WORDS,
    "no scripts": said("The studio needs scripts: allow them for this address."),
}
"""Braces are filled in by the script."""
FILES: dict[str, str] = {
    "svg": said("Sheets (SVG)"),
    "pdf": said("Sheets (PDF)"),
    "png": said("Sheets as pictures (PNG)"),
    "dxf": said("Sheets for CAD (DXF)"),
    "html": said("Page for a browser (HTML)"),
    "csv": said("Tables (CSV)"),
    "note": said("Explanatory note (DOCX)"),
    "toml": said("The scene (TOML)"),
}
"""What files of a format are called; one that is not named here is called by its format."""


SCHEME = "scheme"
"""The folder of what draws a mechanism."""
KINDS = {".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml"}
SHARED = {name: "" for name in ("dom.js", "theme.js", "theme.css")} | {
    f"{name}.js": "own/"
    for name in ("curl", "fitting", "flatten", "lens", "loupe", "photo", "projection", "shot")
}
"""What the studio has from the page of a scene, and where that stands there."""
_PAGE = re.compile(r'"(?:\./|(?:\.\./)+)(?:page/web/)?(?:own/|scheme/)?(?=[\w-]+\.js")')
"""Where modules of ``web/`` find these, and each other; to a browser all stand in one folder."""


def studio(
    name: str,
    title: str,
    language: str,
    *,
    formats: Iterable[str],
    several: bool,
    fixed: bool,
    photographed: bool,
) -> str:
    """Return the page of a scene.

    Parameters
    ----------
    name, title : str
        By which the server knows it, and what it calls itself ("" if it does not).
    language : str
        In which all is told.
    formats : iterable of str
        What can be downloaded, as addresses name it.
    several : bool
        Whether there is a gallery to go back to.
    fixed : bool
        Whether its values cannot be set.
    photographed : bool
        Whether photographs of drawings can be checked.
    """
    speech = speaking(language)
    downloads = [{"form": one, "name": speech(FILES.get(one, one.upper()))} for one in formats]
    about = {"name": name, "several": several, "fixed": fixed, "downloads": downloads}
    about["photographed"] = photographed
    return _page("studio", title or name, language, about)


def drawing_paper(language: str, *, several: bool) -> str:
    """Return the page on which a mechanism is drawn; ``several``: there is a gallery to go back to."""
    title = speaking(language)(said("Draw a scheme"))
    return _page("scheme", title, language, {"several": several})


def gallery(scenes: Mapping[str, str], title: str, language: str, *, fixed: bool = False) -> str:
    """Return the page of a folder: ``scenes``: titles by name; ``title``: of the folder."""
    about = {
        "fixed": fixed,
        "scenes": [{"name": name, "title": one or name} for name, one in scenes.items()],
    }
    return _page("gallery", title, language, about)


def title_of(data: bytes, file: Path) -> str:
    """Return what a scene calls itself, however wrong it is; "" if that cannot be told."""
    try:
        _, doc = parsed(data, file)
    except SceneError:
        return ""
    title = doc.get("title", "")
    return title[:200] if isinstance(title, str) else ""


@cache
def asset(name: str) -> tuple[bytes, str] | None:
    """Return a script or a style of the studio, and what kind of text it is; None if there is none."""
    kind = next((kind for end, kind in KINDS.items() if name.endswith(end)), None)
    if kind is None or name not in assets():
        return None
    room = "graphic_tmm.page" if name in SHARED else "graphic_tmm.serve"
    text = (files(room) / "web" / (SHARED.get(name) or _own().get(name, "")) / name).read_text(
        "utf-8"
    )
    return _PAGE.sub('"./', text).encode(), kind


@cache
def assets() -> frozenset[str]:
    """Return the names of all scripts and styles."""
    return frozenset((*_own(), *SHARED))


@cache
def _own() -> Mapping[str, str]:
    """Return in which folder of the studio's a script or a style stands, by its name."""
    web = files("graphic_tmm.serve") / "web"
    return {
        one.name: room for room in ("", SCHEME) for one in (web / room).iterdir() if one.is_file()
    }


def _page(kind: str, title: str, language: str, about: Mapping[str, Any]) -> str:
    from markupsafe import Markup

    speech = speaking(language)
    words = {key: speech(text) for key, text in WORDS.items()}
    data = json.dumps({"language": language, "words": words, **about}, ensure_ascii=False)
    return (
        _environment()
        .get_template("shell.html")
        .render(
            kind=kind,
            language=language,
            title=title,
            words=words,
            web="../../web/" if kind == "studio" else "web/",
            # in a script nothing is escaped, and only its end is looked for
            data=Markup(data.replace("<", "\\u003c")),
        )
    )


@cache
def _environment() -> Environment:
    """Return the templates: every text is escaped, and a name that is not given is an error."""
    from jinja2 import Environment, PackageLoader, StrictUndefined

    return Environment(
        loader=PackageLoader("graphic_tmm.serve"),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        lstrip_blocks=True,
        keep_trailing_newline=True,
    )

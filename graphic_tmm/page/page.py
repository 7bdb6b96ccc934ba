"""A scene as one page for a browser: its sheets, the pictures of its plans, the protocol, the program.

One file that asks for nothing else. What it may do is told to the browser in it: its own style and program by
their hashes, nothing from outside, no text made into elements.

The program is the modules of ``web/`` joined: plain ES modules in their order, one scope, no names twice. It is
begun by ``main.js``, with what that imports. A folder of ``web/`` holds what not every page has: its
``enter.js`` enters its ways of looking into ``rooms.js`` before ``main.js`` runs; its style stands behind the
page's.
"""

from __future__ import annotations

import base64
import gzip
import hashlib
import json
import re
from collections.abc import Mapping, Sequence
from functools import cache
from graphlib import TopologicalSorter
from importlib.resources import files
from importlib.resources.abc import Traversable
from posixpath import dirname, join, normpath
from typing import Any

from graphic_tmm.accuracy.answer import Answer
from graphic_tmm.accuracy.answer_text import sentences
from graphic_tmm.accuracy.figure_inline import inline_figure
from graphic_tmm.board.script_rows import RowScript
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import SheetError
from graphic_tmm.files import environment
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.page.assemblies import ASSEMBLIES, assemblies
from graphic_tmm.page.crank import crank
from graphic_tmm.page.dense import first_asked
from graphic_tmm.page.error_shares import ERRORS, error_shares, marked_up
from graphic_tmm.page.live.givens import live_log
from graphic_tmm.page.live.words import LIVE
from graphic_tmm.page.practice.own import OWN, own
from graphic_tmm.page.practice.pack import Tables, practice, written_module
from graphic_tmm.page.practice.words import practice_words
from graphic_tmm.page.sentences import protocol_of
from graphic_tmm.page.short_names import shortened
from graphic_tmm.page.turning import turning_data
from graphic_tmm.page.views import played
from graphic_tmm.page.words import ENDS, PARTS, TURNS, WORDS
from graphic_tmm.paper.drawing import Drawing, Sheet
from graphic_tmm.paper.formats import FORMATS
from graphic_tmm.paper.write.svg import ids, svg

LOWER = 0.2
"""How much lower than its page a figure in print is, mm."""

ACCURACY, LENGTHS, PRACTICE, TURNING = "accuracy", "live", "practice", "turning"
"""The folders of what tells of accuracy, changes lengths, lets plans be drawn, turns cams and wheels."""
PLACES = "assemblies"
"""The folder of what shows the ways to assemble a group."""
MAIN, ENTER, WRITTEN = "main", "enter", "written"
"""The module that begins a page; that of a folder which enters its ways of looking; one of the page alone."""

_IMPORT = re.compile(r'^import (?:\{[^}]*\} from )?"(\.{1,2}/[\w/-]+)\.js";\n', re.M)
_EXPORT = re.compile(r"^export (?=(?:async )?(?:function|const|let|class)\b)", re.M)
_NAME = re.compile(r"^(?:export )?(?:async )?(?:function\*?|const|let|class) (\w+)", re.M)
_INDEX = re.compile(r"_\{([^}]*)\}")
_REMARK = re.compile(r"/\*.*?\*/", re.S)
_BLANKS = re.compile(r"\s*([{};,])\s*|(?<=:)\s+")
_INDENT = re.compile(r"^\s+", re.M)
_WEB: Traversable = files(__package__) / "web"
_COMMENT = re.compile(r"^[ \t]*/\*\*(?:(?!\*/).|\n)*\*/\n|^[ \t]*//.*\n", re.M)


def script(*further: str, written: str = "") -> str:
    """Return the page's program with its own names; see `program_parts`."""
    return "\n" + "\n".join(program_parts(*further, written=written)) + "\n"


@cache
def program_parts(*further: str, written: str = "") -> tuple[str, ...]:
    """Return the page's modules: main.js behind all that it imports, without comments, indents, empty lines.

    ``further``: folders whose ways of looking the page has too; ``written``: a module for the page alone, that
    runs before main.js as if it stood in the folder of practice. No text of a module goes over a line
    (tests/page/test_page.py), so that indents are nobody's.

    Raises SheetError where two modules have one name at their top.
    """
    begun = [f"{folder}/{ENTER}" for folder in further]
    modules = modules_of(*dict.fromkeys((*further, *([PRACTICE] if written else []))))
    if written:
        begun = [f"{PRACTICE}/{WRITTEN}", *begun]
        modules[begun[0]] = written
    needs = {name: imported(name, text) for name, text in modules.items()}
    taken: dict[str, str] = {}
    parts = []
    for name in _order(needs, begun):
        text = modules[name]
        for found in _NAME.findall(text):
            if found in taken:
                raise SheetError(f"page/web: {found} stands in {taken[found]}.js and in {name}.js")
            taken[found] = name
        bare = _EXPORT.sub("", _COMMENT.sub("", _IMPORT.sub("", text)))
        parts.append(_INDENT.sub("", bare).strip("\n"))
    return tuple(parts)


@cache
def style(*further: str) -> str:
    """Return the page's style sheet: its parts in the order of their names, without blanks, then the papers.

    ``further``: folders whose parts stand behind those.
    """
    bare = _REMARK.sub("", "".join(_texts(".css", *further).values()))
    return _BLANKS.sub(r"\1", bare).replace(";}", "}") + papers()


def papers() -> str:
    """Return the rules by which a sheet in print has a page of its own format.

    A figure is a little lower than its page: one as high would, by the rounding of its pixels, begin another.
    """
    rules = []
    for name, paper in FORMATS.items():
        page = name.replace(" ", "-")
        rules += [
            f"@page {page} {{ size: {paper.width:g}mm {paper.height:g}mm; margin: 0; }}",
            f'@media print {{ #sheets > figure[data-format="{name}"] {{ page: {page};'
            f" width: {paper.width:g}mm; height: {paper.height - LOWER:g}mm; }} }}",
        ]
    return "".join(f"{rule}\n" for rule in rules)


def modules_of(*folders: str) -> dict[str, str]:
    """Return the modules of the page by their names: those of folders as practice/bench."""
    return {name.removesuffix(".js"): text for name, text in _texts(".js", *folders).items()}


def folders() -> tuple[str, ...]:
    """Return the folders that enter ways of drawing oneself, practice before those that build on it."""
    found = [one.name for one in _WEB.iterdir() if one.is_dir() and (one / f"{ENTER}.js").is_file()]
    return tuple(sorted({*found} - {ACCURACY, LENGTHS, PLACES, TURNING}, reverse=True))


def _texts(ending: str, *folders: str) -> dict[str, str]:
    """Return the texts of the files with an ending: those of ``web/`` by their names, then those of folders."""
    found: dict[str, str] = {}
    for folder in ("", *folders):
        names = sorted(one.name for one in (_WEB / folder).iterdir() if one.name.endswith(ending))
        found |= {join(folder, name): (_WEB / folder / name).read_text("utf-8") for name in names}
    return found


def imported(name: str, text: str) -> list[str]:
    """Return the names of the modules that a module imports."""
    return sorted({normpath(join(dirname(name), path)) for path in _IMPORT.findall(text)})


def _order(needs: dict[str, list[str]], before: list[str]) -> list[str]:
    """Return the modules that a page needs in their order: ``before`` run before main.js."""
    wanted, ahead = set(), [MAIN, *before]
    while ahead:
        name = ahead.pop()
        if name not in wanted:
            wanted.add(name)
            ahead += needs[name]
    graph = {name: needs[name] for name in sorted(wanted)}
    return list(TopologicalSorter(graph | {MAIN: [*needs[MAIN], *before]}).static_order())


def page(
    made: DrawnScene,
    sheets: Sequence[Sheet],
    *,
    practised: bool = False,
    seed: int | None = None,
    weighed: Answer | None = None,
    live: bool = True,
) -> str:
    """Return a drawn scene as a page for a browser (HTML), in the scene's language.

    ``practised``: with what lets a person draw the plans himself, each posed as ``seed`` says, if it is given;
    ``weighed``: what accuracy costs in the scene, which is then told, too; ``live``: with what lets lengths and
    other givens of a mechanism that turns be changed.
    """
    from markupsafe import Markup

    language = made.scene.language
    data = page_data(made, sheets)
    turned = crank(made, sheets, live=live)
    board = RowScript()
    tables: Tables = {}
    logs: Mapping[str, str] = {}
    if turned is not None:
        plans = [view["position"] for view in data["views"]]
        begins = turned.found.at[first_asked(made.mechanism, plans)] if made.mechanism else 0
        data["crank"] = turned.data | {"begins": begins}
        if "ends" in turned.data:
            data["words"] |= _said(ENDS, language)
    further: tuple[str, ...] = ()
    if turned is not None and live:
        data["live"], logs = live_log(turned.found, turned.slots, turned.charted, board, language)
        data["words"] |= _said(LIVE, language)
        further = (LENGTHS,)
    if practised and (asked := practice(made, sheets, data["views"], seed, board)) is not None:
        data["practice"], tables = asked
        data["own"] = own(sheets, language)
        data["words"] |= practice_words(language) | _said(OWN, language)
        further = (*folders(), *further)
    if weighed is not None:
        data["accuracy"] = error_shares(weighed, made, data["views"])
        data["words"] |= _said(ERRORS, language)
        further = (*further, ACCURACY)
    if (turning := turning_data(made, sheets)) is not None:
        data["turning"] = turning
        data["words"] |= _said(TURNS, language)
        further = (*further, TURNING)
    if places := assemblies(made):
        data["words"] |= _said(ASSEMBLIES, language)
        further = (*further, PLACES)
    written = written_module(board, tables, logs) if tables or logs else ""
    program, looks = shortened(program_parts(*further, written=written)), style(*further)
    return (
        environment("graphic_tmm.page")
        .get_template("page.html")
        .render(
            language=language,
            title=made.scene.title,
            words=data["words"],
            sheets=[(one, Markup(svg(one, layers=False))) for one in sheets],
            rubbed=[Markup(svg(_rubbed(one), layers=False)) for one in sheets],
            protocol=protocol_of(made, language) if made.boards else (),
            assemblies=places,
            accuracy=_accuracy(weighed, data["words"]["error figure"]) if weighed else None,
            data=packed(data),
            rows=carried(turned.rows) if turned is not None else "",
            style=Markup(looks),
            style_hash=policy_hash(looks),
            program=Markup(program),
            program_hash=policy_hash(program),
        )
    )


def _accuracy(weighed: Answer, label: str) -> dict[str, Any]:
    """Return what the page tells of accuracy at its end: sentences, and the figure by its label."""
    from markupsafe import Markup, escape

    drawn = inline_figure(weighed, lettered=True).svg
    named = drawn.replace("<svg", f'<svg role="img" aria-label="{escape(label)}"', 1)
    told = (_INDEX.sub(r"<sub>\1</sub>", str(escape(marked_up(one)))) for one in sentences(weighed))
    return {"sentences": [*map(Markup, told)], "figure": Markup(named)}


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


def _rubbed(sheet: Sheet) -> Sheet:
    """Return what was rubbed out on a sheet, each view by its name with "rubbed" before it."""
    names = ids(sheet)
    drawings = tuple(
        Drawing(f"rubbed {name}", one.title, one.rubbed)
        for name, one in zip(names, sheet.drawings, strict=True)
        if one.rubbed
    )
    return sheet._replace(name="of", drawings=drawings)


def policy_hash(text: str) -> str:
    """Return the hash by which a policy of a page allows a style or a program of it."""
    return "sha256-" + base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()

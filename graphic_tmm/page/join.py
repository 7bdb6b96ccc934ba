"""The modules of the page joined into one: plain ES modules in their order, one scope, no names twice."""

from __future__ import annotations

import re
from functools import cache
from graphlib import TopologicalSorter
from importlib.resources import files

from graphic_tmm.errors import SheetError
from graphic_tmm.paper.formats import FORMATS

LOWER = 0.2
"""How much lower than its page a figure in print is, mm."""

_IMPORT = re.compile(r'^import \{[^}]*\} from "\./([\w-]+)\.js";\n', re.M)
_EXPORT = re.compile(r"^export (?=(?:async )?(?:function|const|let|class)\b)", re.M)
_NAME = re.compile(r"^(?:export )?(?:async )?(?:function\*?|const|let|class) (\w+)", re.M)
_INDENT = re.compile(r"^[ \t]+", re.M)
_COMMENT = re.compile(r"^[ \t]*/\*\*(?:(?!\*/).|\n)*\*/\n|^[ \t]*//.*\n", re.M)


@cache
def script() -> str:
    """Return the page's program: all modules behind those that they import, without comments and indents.

    No text of a module goes over a line (tests/page/test_join.py), so that indents are nobody's.

    Raises SheetError where two modules have one name at their top.
    """
    modules = _modules()
    needs = {name: sorted(set(_IMPORT.findall(text))) for name, text in modules.items()}
    taken: dict[str, str] = {}
    parts = []
    for name in TopologicalSorter(needs).static_order():
        text = modules[name]
        for found in _NAME.findall(text):
            if found in taken:
                raise SheetError(f"page/web: {found} stands in {taken[found]}.js and in {name}.js")
            taken[found] = name
        bare = _EXPORT.sub("", _COMMENT.sub("", _IMPORT.sub("", text)))
        parts.append(_INDENT.sub("", bare).strip("\n"))
    return "\n" + "\n".join(parts) + "\n"


@cache
def style() -> str:
    """Return the page's style sheet: all of its parts in the order of their names, then the papers."""
    folder = files(__package__) / "web"
    sheets = sorted(one.name for one in folder.iterdir() if one.name.endswith(".css"))
    return "\n" + "".join((folder / name).read_text("utf-8") for name in sheets) + papers()


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


def _modules() -> dict[str, str]:
    folder = files(__package__) / "web"
    names = sorted(one.name for one in folder.iterdir() if one.name.endswith(".js"))
    return {name.removesuffix(".js"): (folder / name).read_text("utf-8") for name in names}

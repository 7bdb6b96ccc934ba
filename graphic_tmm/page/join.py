"""The modules of the page joined into one: plain ES modules in their order, one scope, no names twice."""

from __future__ import annotations

import re
from functools import cache
from graphlib import TopologicalSorter
from importlib.resources import files

from graphic_tmm.errors import SheetError

_IMPORT = re.compile(r'^import \{[^}]*\} from "\./([\w-]+)\.js";\n', re.M)
_EXPORT = re.compile(r"^export (?=(?:async )?(?:function|const|let|class)\b)", re.M)
_NAME = re.compile(r"^(?:export )?(?:async )?(?:function\*?|const|let|class) (\w+)", re.M)
_COMMENT = re.compile(r"^[ \t]*/\*\*(?:(?!\*/).|\n)*\*/\n|^[ \t]*//.*\n", re.M)


@cache
def script() -> str:
    """Return the page's program: all modules behind those that they import, without their comments.

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
        parts.append(_EXPORT.sub("", _COMMENT.sub("", _IMPORT.sub("", text))).strip("\n"))
    return "\n" + "\n".join(parts) + "\n"


@cache
def style() -> str:
    """Return the page's style sheet: all of its parts in the order of their names."""
    folder = files(__package__) / "web"
    sheets = sorted(one.name for one in folder.iterdir() if one.name.endswith(".css"))
    return "\n" + "".join((folder / name).read_text("utf-8") for name in sheets)


def _modules() -> dict[str, str]:
    folder = files(__package__) / "web"
    names = sorted(one.name for one in folder.iterdir() if one.name.endswith(".js"))
    return {name.removesuffix(".js"): (folder / name).read_text("utf-8") for name in names}

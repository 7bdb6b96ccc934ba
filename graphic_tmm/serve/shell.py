"""The pages of the studio: a scene with its sheets and its values, a folder of scenes; what they are made of.

They hold no more than a frame, words and names; the scripts of ``web/`` ask for all else, and follow it. Every
text goes through a template that escapes it. Addresses within a page are relative, so that it knows no token.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping
from functools import cache
from importlib.resources import files
from pathlib import Path
from typing import TYPE_CHECKING, Any

from graphic_tmm.errors import SceneError
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.scene.document import parsed
from graphic_tmm.serve.words import FILES, WORDS

if TYPE_CHECKING:
    from jinja2 import Environment

KINDS = {".js": "text/javascript", ".css": "text/css", ".svg": "image/svg+xml"}
SHARED = ("dom.js", "theme.js", "theme.css")
"""What the studio has from the page of a scene."""
_PAGE = '"../../page/web/'
"""Where modules of ``web/`` find these; to a browser all stand in one folder."""


def studio(
    name: str, title: str, language: str, *, formats: Iterable[str], several: bool, fixed: bool
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
    """
    speech = speaking(language)
    downloads = [{"form": one, "name": speech(FILES.get(one, one.upper()))} for one in formats]
    about = {"name": name, "several": several, "fixed": fixed, "downloads": downloads}
    return _page("studio", title or name, language, about)


def gallery(scenes: Mapping[str, str], title: str, language: str) -> str:
    """Return the page of a folder: ``scenes``: titles by name; ``title``: of the folder."""
    about = {"scenes": [{"name": name, "title": one or name} for name, one in scenes.items()]}
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
    text = (files(room) / "web" / name).read_text("utf-8")
    return text.replace(_PAGE, '"./').encode(), kind


@cache
def assets() -> frozenset[str]:
    """Return the names of all scripts and styles."""
    own = (one.name for one in (files("graphic_tmm.serve") / "web").iterdir())
    return frozenset((*own, *SHARED))


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

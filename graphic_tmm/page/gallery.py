"""A gallery of pages: one page that leads to those of several scenes, for a folder or a site of files alone.

It asks for nothing but the pictures that lie beside it, and needs no script.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Mapping, Sequence
from importlib.resources import files
from typing import NamedTuple

from graphic_tmm.errors import SheetError
from graphic_tmm.files import environment
from graphic_tmm.language.catalogue import code_of, languages, speaking
from graphic_tmm.language.said import said
from graphic_tmm.page.page import policy_hash

STEM = "index"
"""What a server shows of a folder: the gallery in the first language; in another, ``index.ru.html``."""
STYLE = ("web/theme.css", "templates/gallery.css")
WORDS = {
    "scenes": said("Scenes"),
    "hint": said("Open a scene: its plans play step by step, its sheets lie beside them."),
}
OWN_NAME = said("English", context="the language's own name")


class Card(NamedTuple):
    """A scene in a gallery: name, title and language; ``page`` and ``picture``: the files beside it."""

    name: str
    title: str
    language: str
    page: str
    picture: str


def galleries(cards: Sequence[Card], title: str, first: str = "") -> dict[str, str | bytes]:
    """Return the gallery in every language by the names of its files, each with links to the others.

    ``first``: the language of ``index.html``; left out, that of most scenes.

    Raises
    ------
    SheetError
        If the page of a scene would take the place of a gallery.
    """
    for card in cards:
        if card.page.partition(".")[0].casefold() == STEM:
            raise SheetError(
                said(
                    '{name}: "index" is the name of the gallery; rename this scene', name=card.name
                )
            )
    first = first or Counter(code_of(card.language) for card in cards).most_common(1)[0][0]
    named = {
        code: f"{STEM}.html" if code == first else f"{STEM}.{code}.html" for code in languages()
    }
    return {file: _gallery(cards, title, code, named) for code, file in named.items()}


def _gallery(cards: Sequence[Card], title: str, language: str, named: Mapping[str, str]) -> str:
    from markupsafe import Markup

    speech, home = speaking(language), files(__package__)
    style = "".join((home / path).read_text("utf-8") for path in STYLE)
    return (
        environment("graphic_tmm.page")
        .get_template("gallery.html")
        .render(
            language=language,
            title=speech(title),
            words={key: speech(text) for key, text in WORDS.items()},
            cards=cards,
            others=[
                (code, speaking(code)(OWN_NAME), file)
                for code, file in named.items()
                if code != language
            ],
            style=Markup(style),
            style_hash=policy_hash(style),
        )
    )

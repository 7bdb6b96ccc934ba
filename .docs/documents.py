"""Documents of the repository as pages: the text as it stands, its links led to where they now are."""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from pathlib import Path, PurePosixPath
from posixpath import normpath, relpath

from translated import translated
from words import Language

ROOT = Path(__file__).parents[1]
REPOSITORY = os.environ.get("GRAPHIC_TMM_REPOSITORY", "").rstrip("/")
"""Where files that are no page can be read, if anywhere: links to them are plain words else."""

ENGLISH: Mapping[str, str] = {
    "README.md": "index.md",
    "sheets/start.en.md": "guides/start.md",
    "sheets/class.en.md": "guides/class.md",
    "graphic_tmm/scene/README.md": "guides/scene.md",
    "graphic_tmm/checking/README.md": "guides/checking.md",
    "graphic_tmm/accuracy/README.md": "guides/accuracy.md",
    "graphic_tmm/face/README.md": "python/index.md",
    "sheets/README.md": "gallery/index.md",
    "graphic_tmm/README.md": "project/built.md",
    "tests/README.md": "project/measured.md",
    "graphic_tmm/CHANGES.md": "project/changes.md",
    "graphic_tmm/scene/keys.md": "keys/index.md",
}
RUSSIAN: Mapping[str, str] = {
    "sheets/start.ru.md": "guides/start.md",
    "sheets/class.ru.md": "guides/class.md",
    "graphic_tmm/scene/README.md": "guides/scene.md",
    "graphic_tmm/accuracy/README.md": "guides/accuracy.md",
    "graphic_tmm/face/README.md": "python/index.md",
    "graphic_tmm/scene/keys.ru.md": "keys/index.md",
}
"""Which page a document is; the keys are printed anew, and only links lead by these names."""
PAGES: Mapping[Language, Mapping[str, str]] = {"en": ENGLISH, "ru": RUSSIAN}
PICTURES = (".svg", ".png", ".jpg")

_LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^()\s]+)\)")
_ATTRIBUTE = re.compile(r'\b(href|src)="([^":#]+)"')
_CODE = re.compile(r"(^```.*?^```|^ {4}.*?$|``.*?``|`[^`\n]*`)", re.DOTALL | re.MULTILINE)


def text_of(document: str, language: Language) -> str:
    """Return what a document says, in its own language where it is the only one of that page."""
    source: Language = "en" if document in ENGLISH else language
    return translated((ROOT / document).read_text(encoding="utf-8"), language, source, code=True)


def page_of(document: str, language: Language) -> str:
    """Return a document as a page of the site of a language."""
    text = text_of(document, language)
    page = PAGES[language][document]
    parts = _CODE.split(text)
    joined, kept = "", list[str]()  # a link may have code for its words, and none is in code
    for k, part in enumerate(parts):
        joined += part if not k % 2 else f"\0{len(kept)}\0"
        if k % 2:
            kept.append(part)
    joined = _ATTRIBUTE.sub(lambda one: _attribute(one, document, page, language), joined)
    joined = _LINK.sub(lambda one: _led(one, document, page, language), joined)
    return re.sub(r"\0(\d+)\0", lambda one: kept[int(one[1])], joined)


def _led(found: re.Match[str], document: str, page: str, language: Language) -> str:
    picture, words, target = found.groups()
    if re.match(r"[a-z]+:", target) or target.startswith("#"):
        return found[0]
    where, hash_, anchor = target.partition("#")
    path = normpath(str(PurePosixPath(document).parent / where))
    if picture or path.endswith(PICTURES):
        source = across(path, page, "en", language)
        if picture:
            return f'<img class="sheet" src="{source}" alt="{words}">'
        return f'<a href="{source}">{words}</a>'
    led, own = lead(path, page, language)
    if not led:
        return words
    return (
        f"[{words}]({led}{hash_}{anchor})" if own else f'<a href="{led}{hash_}{anchor}">{words}</a>'
    )


def lead(path: str, page: str, language: Language) -> tuple[str, bool]:
    """Return where a file of the repository is read, "" if nowhere; whether in the site of the language."""
    there = {"graphic_tmm/chapters": "theory/index.md"}
    if path.startswith("sheets/") and (ROOT / path / "scene.toml").exists():
        there[path] = f"gallery/{PurePosixPath(path).name}.md"
    for other in sorted(PAGES, key=lambda one: one != language):
        known = {**PAGES[other], **there}
        for one in (path, normpath(f"{path}/README.md")):
            if one in known and other == language:
                return relpath(known[one], str(PurePosixPath(page).parent)), True
            if one in known:
                return across(known[one].replace(".md", ".html"), page, other, language), False
    return (f"{REPOSITORY}/blob/main/{path}" if REPOSITORY else ""), True


def across(file: str, page: str, other: Language, language: Language) -> str:
    """Return the link from a page to a file of the site of another language; English stands at the root."""
    home = {"en": "", "ru": "ru"}
    here = PurePosixPath(home[language]) / PurePosixPath(page).parent
    return relpath(str(PurePosixPath(home[other]) / file), str(here))


def _attribute(found: re.Match[str], document: str, page: str, language: Language) -> str:
    path = normpath(str(PurePosixPath(document).parent / found[2]))
    if path.endswith(PICTURES):
        return f'{found[1]}="{across(path, page, "en", language)}"'
    led, _ = lead(path, page, language)
    return f'{found[1]}="{led.replace(".md", ".html")}"'

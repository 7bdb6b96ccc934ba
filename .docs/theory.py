"""The pages of chapters: theory as it stands at the head of each, a worked example as a note tells it, keys."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cache
from html import escape, unescape
from importlib import import_module
from inspect import getdoc

from documents import across
from translated import titled, translated
from words import Language, word

from graphic_tmm import Scene, read, scenes
from graphic_tmm.note.note import note_files, wanted
from graphic_tmm.note.page import title
from graphic_tmm.scene.chapter import Chapter, chapters
from graphic_tmm.studio import make

FIRST: dict[Language, str] = {"en": "crank-rocker", "ru": "windrower"}
"""The scene of a chapter whose page names none, written in the language of the site."""


def theory_pages(language: Language) -> Iterator[tuple[str, str]]:
    """Yield the pages of all chapters by file, an index of them first."""
    index = [f"# {word('theory', language)}\n", f"{word('each chapter', language)}\n"]
    index += ["| № | |", "|---|---|"]
    for chapter in chapters():
        link = f"[{called(chapter, language)}]({chapter.name}.md)"
        first = _theory(chapter, language).partition("\n")[0]
        index.append(f"| {chapter.number} | {link}<br>{first} |")
    yield "theory/index.md", "\n".join(index) + "\n"
    for chapter in chapters():
        yield f"theory/{chapter.name}.md", _page(chapter, language)


def called(chapter: Chapter, language: Language) -> str:
    """Return what the page of a chapter is called: as in a note, else as the scene that shows it."""
    name = title(chapter, language)
    if name != chapter.name:
        return name
    return _theory(chapter, language).partition(":")[0]


def links(those: tuple[Chapter, ...], language: Language, folder: str = "") -> str:
    """Return links to the pages of chapters, in a line."""
    return ", ".join(f"[{called(one, language)}]({folder}{one.name}.md)" for one in those)


as_written = cache(read)
"""A scene as its file says; each is asked for by every chapter."""


def shows(scene: Scene, chapter: Chapter) -> bool:
    """Whether sheets of a scene show something of a chapter; of one without places, whether it is given."""
    if chapter.places:
        return bool(scene.called & {place.name for place in chapter.places})
    return any(one.name in scene.doc for one in chapter.sections)


@cache
def scene_of(chapter: Chapter, language: Language) -> str:
    """Return the scene by which a chapter is worked.

    Those written in the language come first, of these that which the chapter's page names.
    """
    named: list[str] = re.findall(r"``([\w-]+)``", _theory(chapter).partition("\nSources:")[2])
    order = [name for name in (*named, FIRST[language], *scenes()) if name in scenes()]
    order.sort(key=lambda name: as_written(name).language != language)
    return next(
        name
        for name in order
        if shows(as_written(name), chapter)
        and (not chapter.board or _section(name, chapter, language))
    )


def _theory(chapter: Chapter, language: Language = "en") -> str:
    return translated(getdoc(import_module(chapter.folder)) or "", language)


def _page(chapter: Chapter, language: Language) -> str:
    parts = [f"# {called(chapter, language)}\n", _marked(_theory(chapter, language), language)]
    parts += _further(chapter, language)
    parts.append(_worked(chapter, language))
    return "\n".join(parts)


def _marked(theory: str, language: Language) -> str:
    """Return a page of theory as Markdown: what it is about first, scenes that it names as links."""
    first, _, rest = theory.partition("\n")
    bold = "|".join(word(name, language) for name in ("draws", "sources"))
    text = re.sub(rf"^({bold}):", r"**\1:**", f"**{first}**\n{rest}\n", flags=re.MULTILINE)
    text = re.sub(r"^    (.+)$", _displayed, text, flags=re.MULTILINE)
    text = _INDEX.sub(_indexed, text)
    known = set(scenes())
    return re.sub(r"``([\w-]+)``(?=\))", lambda one: _led(one, known), text)


_INDEX = re.compile(r"`+[^`]+`+|_([^\W_²³]+)|\^(\w|\([^)]*\))")


def _indexed(found: re.Match[str]) -> str:
    """Return an index or an exponent of a formula as one, and code as it is."""
    low, high = found.groups()
    return f"<sub>{low}</sub>" if low else f"<sup>{high}</sup>" if high else found[0]


def _displayed(found: re.Match[str]) -> str:
    return f'<p class="formula">{found[1]}</p>'


def _led(found: re.Match[str], known: set[str]) -> str:
    return f"[{found[1]}](../gallery/{found[1]}.md)" if found[1] in known else found[0]


def _further(chapter: Chapter, language: Language) -> Iterator[str]:
    below = tuple(one for one in chapters() if one.name in chapter.builds_on)
    if below:
        yield f"**{word('builds on', language)}:** {links(below, language)}\n"
    if chapter.sections:
        keys = ", ".join(f"[`{one.name}`](../keys/{one.name}.md)" for one in chapter.sections)
        yield f"**{word('keys of it', language)}:** {keys}\n"
    shown = [name for name in scenes() if shows(as_written(name), chapter)]
    told = ", ".join(f"[{name}](../gallery/{name}.md)" for name in shown)
    yield f"**{word('shown by', language)}:** {told}\n"


# ---------------------------------------------------------------- a worked example


@cache
def note_of(name: str, language: Language) -> str:
    """Return the note of a scene as a page by itself."""
    scene = read(name, language=language)
    made = make(scene, wanted=wanted(scene))
    return str(note_files(made, name, ("html",))[f"{name}.html"])


def notes(language: Language) -> Iterator[tuple[str, str]]:
    """Yield the notes that chapters are worked by, as files of the site."""
    drawn = (scene_of(one, language) for one in chapters() if one.board)
    for name in dict.fromkeys(drawn):
        yield f"notes/{name}.html", note_of(name, language)


def _worked(chapter: Chapter, language: Language) -> str:
    """Return the section of a note on a chapter; of one that stands on no board its scene's sheet."""
    name = scene_of(chapter, language)
    heading = f"## {word('worked', language).format(titled(name, language))} {{ #worked }}\n"
    if not chapter.board:
        source = across(f"sheets/{name}/{name}.svg", "theory/x.md", "en", language)
        return f'{heading}\n<img class="sheet" src="{source}" alt="{name}">\n'
    own = _section(name, chapter, language)
    known = set(re.findall(r'\bid="([^"]+)"', own))
    whole = f"../notes/{name}.html"

    def led(found: re.Match[str]) -> str:
        return found[0] if found[1] in known else f'href="{whole}#{found[1]}"'

    own = re.sub(r'href="#([^"]+)"', led, own)
    note = f'<p><a href="{whole}">{word("whole note", language)}</a></p>\n'
    return f"{heading}\n{_parted(own)}\n{note}"


def _section(name: str, chapter: Chapter, language: Language) -> str:
    """Return what the note of a scene has below the title of a chapter, "" if nothing."""
    body = note_of(name, language).partition("<main>")[2].partition("</main>")[0]
    words = re.escape(escape(called(chapter, language)))
    for level in (1, 2):
        until = rf"(?=<h[1-{level}]\b|\Z)"
        found = re.search(rf"<h{level}[^>]*>[\d. ]*{words}</h{level}>(.*?){until}", body, re.DOTALL)
        if found:
            return found[1]
    return ""


_HEADS = re.compile(r"<h([2-6])[^>]*>(.*?)</h\1>", re.DOTALL)


def _parted(body: str) -> str:
    """Return the body of a note as parts of HTML below headings of Markdown, which the site lists."""
    first, *rest = _HEADS.split(body)
    found = [_boxed(first)]
    for level, words, part in zip(rest[::3], rest[1::3], rest[2::3], strict=True):
        told = re.sub(r"^[\d.]+\s*", "", unescape(re.sub(r"<[^>]*>", "", words)).strip())
        found.append(f"{'#' * (int(level) + 1)} {told}\n\n{_boxed(part)}")
    return "\n".join(found)


def _boxed(part: str) -> str:
    part = part.strip()
    return f'<div class="worked">\n{part}\n</div>\n' if part else ""

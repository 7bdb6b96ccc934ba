"""The gallery: a page of each scene of the package with its sheets, its text and the chapters that it shows."""

from __future__ import annotations

from collections.abc import Iterator

from documents import ROOT, across, page_of
from theory import links, shows
from translated import titled
from words import Language, word

from graphic_tmm import read, scenes
from graphic_tmm.scene.chapter import chapters

SHEETS = ROOT / "sheets"


def gallery_pages(language: Language) -> Iterator[tuple[str, str]]:
    """Yield a page of every scene, and one of all."""
    if language == "en":
        yield "gallery/index.md", page_of("sheets/README.md", language)
    else:
        cards = "\n".join(_card(name, language) for name in scenes())
        heading = f"# {word('gallery', language)}\n\n{word('a scene each', language)}\n"
        yield "gallery/index.md", f'{heading}\n<div class="gallery">\n{cards}\n</div>\n'
    for name in scenes():
        yield f"gallery/{name}.md", _page(name, language)


def pictures(name: str) -> list[str]:
    """Return the sheets of a scene, as files of the repository."""
    return [f"sheets/{name}/{file.name}" for file in sorted((SHEETS / name).glob("*.svg"))]


def _card(name: str, language: Language) -> str:
    source = across(pictures(name)[0], "gallery/x.md", "en", language)
    picture = f'<img src="{source}" alt="" loading="lazy">'
    return f'<a href="{name}.html">{picture}<code>{name}</code>{titled(name, language)}</a>'


def _page(name: str, language: Language) -> str:
    scene = read(name)
    parts = [f"# {name}\n", f"{titled(name, language)}\n"]
    told = links(tuple(one for one in chapters() if shows(scene, one)), language, "../theory/")
    parts.append(f"**{word('chapters of it', language)}:** {told}\n")
    parts.append(f"{word('draw it', language)}\n\n```sh\ngraphic-tmm draw {name}\n```\n")
    for file in pictures(name):
        source = across(file, "gallery/x.md", "en", language)
        alt = file.rpartition("/")[2]
        parts.append(
            f'<p><a href="{source}"><img class="sheet" src="{source}" alt="{alt}" loading="lazy"></a></p>\n'
        )
    text = (SHEETS / name / "scene.toml").read_text(encoding="utf-8")
    parts.append(f"## {word('scene', language)}\n\n```toml\n{text.rstrip()}\n```\n")
    return "\n".join(parts)

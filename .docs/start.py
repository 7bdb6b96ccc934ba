"""The first page of a site whose language the README is not written in."""

from __future__ import annotations

from inspect import cleandoc

from documents import PAGES, across, text_of
from words import Language, word

from graphic_tmm.__main__ import main
from graphic_tmm.language.catalogue import speaking

SHEET = "sheets/windrower/windrower-2.svg"


def start_page(language: Language) -> str:
    """Return what the program is, as its help says, a sheet, and where to read on."""
    told = speaking(language)(cleandoc(main.help or "")).partition("\n\n")[0]
    lines = ["# graphic_tmm\n", f"{' '.join(told.split())}\n"]
    source = across(SHEET, "index.md", "en", language)
    lines.append(f'<p><a href="{source}"><img class="sheet" src="{source}" alt=""></a></p>\n')
    for document, page in PAGES[language].items():
        if page.startswith("guides/"):
            heading = text_of(document, language).partition("\n")[0]
            lines.append(f"- [{heading.removeprefix('# ')}]({page})")
    lines += [
        f"- [{word(tab, language)}]({tab}/index.md)"
        for tab in ("theory", "keys", "commands", "python", "gallery")
    ]
    english = across("index.html", "index.md", "en", language)
    lines.append(f'- <a href="{english}">{word("more", language)}</a>')
    return "\n".join(lines) + "\n"

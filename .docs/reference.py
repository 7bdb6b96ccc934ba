"""Pages of reference, printed as the package prints them: keys of a scene, commands, names of the face."""

from __future__ import annotations

import re
from collections.abc import Iterator
from html import escape
from inspect import cleandoc

import click
from documents import across
from theory import links
from words import Language, word

import graphic_tmm
from graphic_tmm.__main__ import main
from graphic_tmm.commands.shared.spoken import click_speaking, translated
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.reader import reading
from graphic_tmm.scene.chapter import chapters
from graphic_tmm.scene.keys import reference

PROGRAM = "graphic-tmm"
NAMES = graphic_tmm.__all__


def key_pages(language: Language) -> Iterator[tuple[str, str]]:
    """Yield a page of each section of a scene, and one of what belongs to none, with a list of all."""
    head, *parts = re.split(r"^(?=## )", reference(language), flags=re.MULTILINE)
    sections: dict[str, list[str]] = {}
    rest = [head.strip() + "\n"]
    for part in parts:
        headed = re.match(r"## `\[+(\w+)\]+`", part)
        (sections.setdefault(headed[1], []) if headed else rest).append(part)
    listed = [f"[`{name}`]({name}.md)" for name in sections]
    rest.insert(1, f"{' · '.join(listed)}\n")
    yield "keys/index.md", "\n".join(rest)
    for name, told in sections.items():
        yield f"keys/{name}.md", "\n".join([told[0][1:], *told[1:], _chapters(name, language)])


def _chapters(section: str, language: Language) -> str:
    those = tuple(one for one in chapters() if section in {key.name for key in one.sections})
    if not those:
        return ""
    return f"**{word('chapter', language)}:** {links(those, language, '../theory/')}\n"


def command_pages(language: Language) -> Iterator[tuple[str, str]]:
    """Yield a page of each command, as its help tells it, and one of the program with a list of all."""
    with reading(language), click_speaking():
        group = click.Context(main, info_name=PROGRAM)
        rows, pages = list[str](), dict[str, str]()
        for name in main.list_commands(group):
            command = main.get_command(group, name)
            assert command is not None
            context = click.Context(command, info_name=name, parent=group)
            pages[f"commands/{name}.md"] = _command(command, context, language)
            told = _paragraphs(command, language)[0]
            rows.append(f"| [`{name}`]({name}.md) | {told} |")
        parts = [f"# {word('commands', language)}\n", *_paragraphs(main, language)]
        parts += [f"\n| {word('commands', language)} | |\n|---|---|", *rows, ""]
        yield "commands/index.md", "\n".join(parts) + "\n" + _options(main, group, language)
        yield from pages.items()


def _command(command: click.Command, context: click.Context, language: Language) -> str:
    shown = translated(command, speaking(language))
    usage = " ".join([context.command_path, *shown.collect_usage_pieces(context)])
    told = "\n\n".join(_paragraphs(command, language))
    return f"# {command.name}\n\n{told}\n\n```text\n{usage}\n```\n\n{_options(command, context, language)}"


def _paragraphs(command: click.Command, language: Language) -> list[str]:
    told = speaking(language)(cleandoc(command.help or ""))
    return [escape(" ".join(one.split()), quote=False) for one in told.split("\n\n")]


def _options(command: click.Command, context: click.Context, language: Language) -> str:
    shown = translated(command, speaking(language))
    lines = [f"| {word('option', language)} | {word('what for', language)} |", "|---|---|"]
    for param in shown.get_params(context):
        record = param.get_help_record(context)
        if record is not None and record[1]:
            names, told = (escape(one, quote=False).replace("|", "&#124;") for one in record)
            lines.append(f"| <code>{names}</code> | {told} |")
    return "\n".join(lines) + "\n"


def face_links(language: Language) -> str:
    """Return links to the pages of public names, which are those of the English site."""
    page = "python/index.md"
    there = {name: across(f"python/{name}.html", page, "en", language) for name in NAMES}
    listed = ", ".join(f'<a href="{link}"><code>{name}</code></a>' for name, link in there.items())
    return f"\n## {word('names', language)}\n\n{word('in English', language)}\n\n{listed}\n"


def face_pages() -> Iterator[tuple[str, str]]:
    """Yield a page of each public name, told from its docstring."""
    for name in NAMES:
        home = getattr(graphic_tmm, name).__module__
        yield f"python/{name}.md", f"# {name}\n\n::: {home}.{name}\n"

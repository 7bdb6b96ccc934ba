"""The guides of `sheets`: what they tell to write and to type, and a template filled in as they say."""

from __future__ import annotations

import csv
import re
import shlex
from pathlib import Path

from support.gallery import SHEETS

LANGUAGES = ("en", "ru")


def guide(name: str, language: str) -> str:
    return (SHEETS / f"{name}.{language}.md").read_text(encoding="utf-8")


def commands(text: str) -> list[list[str]]:
    return [shlex.split(line) for line in re.findall(r"(?m)^    \$ graphic-tmm (.*)$", text)]


def typed(text: str) -> list[str]:
    """Return the lines that a guide tells to type, those in its sentences too."""
    indented = re.findall(r"(?m)^    (?:\$ )?(\S.*)$", text)
    spoken = re.findall(r"`([^`\n]+)`", text)
    return indented + [one for one in spoken if 'pip install "' in one]


def unlike_in_shells(line: str) -> bool:
    """Whether cmd, PowerShell and sh would not take a line alike."""
    return bool(re.search(r"['>]|activate|&&", line))


def blocks(text: str, kind: str = "toml") -> list[str]:
    return re.findall(rf"```{kind}\n(.*?)```", text, re.DOTALL)


def filled(file: Path, table: Path, into: Path | None = None) -> None:
    """Fill in a template with the mm of a table, as if they had been measured."""
    told = csv.reader(table.read_text("utf-8-sig").splitlines(), delimiter=separator(table))
    lengths = {(plan, position, segment): mm for plan, position, _, segment, mm, *_ in told}
    lines = [one for one in file.read_text("utf-8-sig").splitlines() if not one.startswith("#")]
    rows = list(csv.reader(lines, delimiter=separator(file)))
    for row in rows[1:]:
        row[3] = lengths.get((row[0], row[1], row[2]), "")
    assert any(row[3] for row in rows[1:])
    text = "\n".join(separator(file).join(row) for row in rows)
    (into or file).write_text(text, encoding="utf-8")


def separator(file: Path) -> str:
    lines = file.read_text("utf-8-sig").splitlines()
    return ";" if ";" in next(line for line in lines if not line.startswith("#")) else ","

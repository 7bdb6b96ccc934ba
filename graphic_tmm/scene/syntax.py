"""What is wrong with a text that is not TOML, for people: the line, and what to write instead."""

from __future__ import annotations

import re

from graphic_tmm.errors import Fault
from graphic_tmm.language.said import joined, said
from graphic_tmm.scene.letters import latin
from graphic_tmm.scene.misfits import truth

_AT = re.compile(r"\s*\((?:at line ([0-9]+), column ([0-9]+)|at end of document)\)")
_TWICE = (
    "Cannot overwrite a value",
    "Duplicate inline table key",
    "Cannot declare",
    "Cannot mutate",
)

_COMMENT = re.compile(r"""^([^"#]*(?:"[^"]*"[^"#]*)*)#.*$""")
"""A line with a comment behind it, and what stands before; a # in quotes is none."""
LONGEST = 300
"""A longer line is not quoted in a remedy."""


def syntax_fault(text: str, message: str) -> Fault:
    """Return the fault that tomllib's message speaks of.

    Parameters
    ----------
    text : str
        The whole file.
    message : str
        What ``tomllib.loads`` said, in English, with "(at line 3, column 7)" at its end.
    """
    match = _AT.search(message)
    lines = text.replace("\r\n", "\n").split("\n")
    number = int(match.group(1)) if match and match.group(1) else len(lines)
    line = lines[number - 1] if number <= len(lines) else ""
    reason = _AT.sub("", message)
    if reason.startswith(_TWICE):
        return _twice(reason, number, line, match)
    says = said("this is not TOML ({reason})", reason=reason)
    return Fault(_key(line), number, joined("; ", filter(None, (says, _remedy(line)))))


def _twice(reason: str, number: int, line: str, match: re.Match[str] | None) -> Fault:
    """Return the fault of a key or a section that stands twice."""
    names = re.findall(r"'([^']*)'", reason)
    section = line.lstrip().startswith("[")
    column = int(match.group(2)) if match and match.group(2) else len(line)
    key = ".".join(names) or (line.strip(" \t[]") if section else _key(line[:column]))
    if section:
        name = key.split(".")[0]
        says = (
            said("write [[{name}]] in double brackets, each time: there can be several", name=name)
            if name in several()
            else said("put its keys into one section")
        )
        twice = said("the section [{key}] stands twice", key=key)
        return Fault(key, number, joined("; ", (twice, says)))
    says = said('"{key}" stands twice in one table; take one out, or rename it', key=key)
    return Fault(key, number, says)


def _sections() -> list[str]:
    from graphic_tmm.scene.sections import LENGTHS, declared

    named = declared().items()
    return [f"[{LENGTHS}]", *(f"[[{k}]]" if one.several else f"[{k}]" for k, one in named)]


def several() -> frozenset[str]:
    """Return the sections that a scene may have several times."""
    from graphic_tmm.scene.sections import declared

    return frozenset(name for name, section in declared().items() if section.several)


def _key(line: str) -> str:
    """Return the word before the first sign of equality, in one pass: a line may be very long."""
    name = line.partition("=")[0].rstrip() if "=" in line else ""
    start = len(name)
    while start and (name[start - 1].isalnum() or name[start - 1] in "_.′\"'-"):
        start -= 1
    return name[start:].strip("\"'")


def _remedy(line: str) -> str:
    """Return what to do about the commonest mistakes, as far as the line shows them."""
    if len(line) > LONGEST:
        return ""
    name, sign, value = _COMMENT.sub(r"\1", line).partition("=")
    value = value.strip()
    if re.search(r"[«»“”„]", line):
        return said('write straight quotes: "..."')
    if not sign and re.match(r"\s*\[", line):
        if re.search(r"[^\x00-\x7f]", name):
            return said("sections have English names: {listed}", listed=", ".join(_sections()))
        return said("a section is written [frame], or [[link]] for one of several")
    if not sign:
        return said("write key = value")
    return _key_remedy(name, value) or _value_remedy(name.strip(), value)


def _key_remedy(name: str, value: str) -> str:
    if re.search(r"[^\x00-\x7f]", name) and '"' not in name:
        return _not_latin(name.strip())
    if inner := re.search(r"[{,]\s*([^\x00-\x7f\s\"]+)\s*=", value):
        return _not_latin(inner[1])
    return ""


def _not_latin(name: str) -> str:
    """Return how a key is written that is not Latin; of one that only looks so, both ways."""
    quoted = said('a key that is not Latin stands in quotes: "{name}" = ...', name=name)
    looks = latin(name)
    if not looks.isascii():
        return quoted
    says = said('"{name}" is not Latin: write {looks} with Latin letters', name=name, looks=looks)
    return joined("; ", (says, quoted))


def _value_remedy(name: str, value: str) -> str:
    if not value:
        return said("a value is missing, {name} = ...", name=name)
    if word := truth(value):
        return said("write {name} = {word}", name=name, word=word)
    if value.count('"') % 2:
        return said("a quote is not closed: write {name} = {value}", name=name, value=f'{value}"')
    if re.match(r"[–—‒‑−]\s*[0-9.,]+$", value):
        right = f"-{value[1:].strip()}"
        return said('a minus is written "-": {name} = {right}', name=name, right=right)
    if re.match(r"[-+]?[0-9]+,[0-9]", value):
        right = value.replace(",", ".", 1)
        return said("the decimal sign of a number is a point: {right}", right=right)
    if '"' in value:
        return ""
    if re.match(r"[-+–—‒‑−]?\s*[0-9][0-9.,]*\s*[^\W\d_]", value):
        return said(
            'a value with a unit stands in quotes: {name} = "{value}"', name=name, value=value
        )
    if value.count("{") > value.count("}"):
        return said("a table in { } stands on one line")
    if re.match(r"[^\W\d_]", value):
        return said('a text stands in quotes: {name} = "{value}"', name=name, value=value)
    return ""

"""Texts of scenes before and after: their comments, the lines that differ, their links with other keys."""

from __future__ import annotations

import copy
import difflib
import re
import tomllib
from typing import Any

from graphic_tmm.scene.packaged import FILE
from support import gallery


def text_of(name: str) -> str:
    return (gallery.SHEETS / name / FILE).read_bytes().decode("utf-8")


def comments(text: str) -> list[str]:
    return re.findall(r"#[^\n]*", text)


def lines(old: str, new: str) -> list[str]:
    """The lines of a text that differ, as they are now."""
    return [
        line[2:] for line in difflib.ndiff(old.splitlines(), new.splitlines()) if line[:2] == "+ "
    ]


def with_links(text: str, **links: dict[str, Any] | None) -> dict[str, Any]:
    """The links of a scene, some with other keys, by "_" and number; None: without the link."""
    told = copy.deepcopy(tomllib.loads(text)["link"])
    kept = [one for one in told if links.get(f"_{one['number']}", {}) is not None]
    return {"link": [one | (links.get(f"_{one['number']}") or {}) for one in kept]}

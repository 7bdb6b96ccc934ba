"""Values as a scene file writes them: TOML on one line; defaults of keys in a form that is read again."""

from __future__ import annotations

import json
import re
import tomllib
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import MISSING
from typing import Any

from graphic_tmm.scene.declare import Found, Key

_UNIT = re.compile(r"[\d.,]+( [^\d\s].*)")
_BARE = re.compile(r"[A-Za-z0-9_-]+")


def default_text(one: Key) -> str | None:
    """Return a key's default as a scene writes it; None where that is nothing."""
    if one.default is not MISSING and one.default is not None and one.default not in ((), {}, ""):
        for text in _spelled(one):
            if _read(one, text) == one.default:
                return text
    return None


def _spelled(one: Key) -> Iterator[str]:
    """Yield how a default may be written: an only item by itself, as it is, in the unit of the example."""
    with suppress(TypeError):
        if isinstance(one.default, tuple) and len(one.default) == 1:
            yield toml(one.default[0])
        yield toml(one.default)
    unit = _UNIT.fullmatch(one.example) if isinstance(one.example, str) else None
    if unit is not None and isinstance(one.default, (int, float)):
        yield toml(f"{one.default:g}{unit[1]}")


def _read(one: Key, text: str) -> object:
    """Return what a value means that is written so; None if it is none."""
    found: list[Found] = []
    value = one.kind.understood(value_of(text), (), {}, found)
    return None if found else value


def value_of(text: str) -> Any:
    """Return the value that TOML writes so."""
    return tomllib.loads(f"it = {text}")["it"]


def toml(value: object) -> str:
    """Return a value as TOML writes it, on one line.

    >>> toml({"a": [0, 0.5], "b c": True})
    '{ a = [0, 0.5], "b c" = true }'

    Raises
    ------
    TypeError
        If TOML has no such values.
    """
    if isinstance(value, (bool, int, float)):
        return f"{value:g}" if isinstance(value, float) else str(value).lower()
    if isinstance(value, str):
        return json.dumps(value, ensure_ascii=False)
    if isinstance(value, (list, tuple)):
        return f"[{', '.join(map(toml, value))}]"
    if isinstance(value, dict):
        pairs = (f"{k if _BARE.fullmatch(k) else toml(k)} = {toml(v)}" for k, v in value.items())
        return f"{{ {', '.join(pairs)} }}" if value else "{}"
    raise TypeError(type(value).__name__)

"""Whether a person can read what is told: texts out of data, and what never stands in one."""

from __future__ import annotations

import re
from collections.abc import Iterator

UNREADABLE = re.compile(r"NaN|Infinity|undefined|10⁻¹[1-9]|(?:^|[=≈:] ?)—|\{it\}|None\b")
"""What no person should ever read."""


def texts(told: object) -> Iterator[str]:
    """Every text of some data."""
    if isinstance(told, str):
        yield told
    elif isinstance(told, dict):
        for one in told.values():
            yield from texts(one)
    elif isinstance(told, list | tuple):
        for one in told:
            yield from texts(one)

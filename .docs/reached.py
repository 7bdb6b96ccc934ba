"""Whether every link, picture and anchor of a built site leads somewhere in it."""

from __future__ import annotations

import re
from functools import cache
from html import unescape
from pathlib import Path
from typing import NamedTuple
from urllib.parse import unquote, urlsplit


class _Seen(NamedTuple):
    """What a page refers to, and the places in it that others may refer to."""

    targets: list[str]
    places: set[str]


UNREAD = re.compile(r"<!--.*?-->|(<(script|style)\b[^>]*>).*?</\2\s*>", re.DOTALL | re.IGNORECASE)
"""What holds no tags; a script may be a file that its own tag names."""
TAG = re.compile(r"""<(?!base\b)[a-z](?:[^<>"']|"[^"]*"|'[^']*')*>""", re.IGNORECASE)
VALUE = re.compile(
    r"""\s(href|src|id|name)\s*=\s*(?:"([^"]*)"|'([^']*)'|([^\s"'>]+))""", re.IGNORECASE
)


@cache
def _seen(page: Path) -> _Seen:
    found = _Seen([], set())
    text = UNREAD.sub(lambda unread: unread[1] or "", page.read_text(encoding="utf-8"))
    for tag in TAG.finditer(text):
        for name, *values in VALUE.findall(tag[0]):
            value = unescape("".join(values))
            if name.lower() not in ("href", "src"):
                found.places.add(value)
            elif value:
                found.targets.append(value)
    return found


def lost(site: Path) -> list[str]:
    """Return a line for each reference of a site's pages that leads nowhere; others' sites are not asked."""
    _seen.cache_clear()
    faults = []
    for page in sorted(site.rglob("*.html")):
        if page.name == "404.html":  # it is served from anywhere
            continue
        for target in _seen(page).targets:
            parts = urlsplit(target)
            if parts.scheme or parts.netloc:
                continue
            there = (page.parent / unquote(parts.path)).resolve() if parts.path else page
            place = unquote(parts.fragment)
            known = there.exists() and there.is_relative_to(site)
            if not known or (
                place and there.suffix == ".html" and place not in _seen(there).places
            ):
                faults.append(f"{page.relative_to(site)}: {target} leads nowhere")
    return faults

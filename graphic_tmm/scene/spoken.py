"""The language that a scene's text asks for, however wrong the rest of it is."""

from __future__ import annotations

import re

from graphic_tmm.language.catalogue import languages

LOOKED = 256_000
"""So many characters of a scene are looked through for its language."""
_LANGUAGE = re.compile(r"""^language\s*=\s*["'](\w+)["']""", re.MULTILINE)


def spoken(text: str) -> str:
    """Return the language that a text asks for; "" if none that there is."""
    found = _LANGUAGE.search(text[:LOOKED])
    return found[1] if found is not None and found[1] in languages() else ""

"""Letters of the log as they are lettered: figures as indices."""

from __future__ import annotations

import re


def markup(letter: str, number: str = "") -> str:
    """Return a letter of the log as lettered on the sheet: figures become indices, d3d -> d_{3}d.

    The number of a position follows in the last index: a_{3,5}.
    """
    if "_" in letter:
        return letter
    text = re.sub(r"([^\W\d])(\d+)", r"\1_{\2}", letter)
    if not number:
        return text
    return f"{text[:-1]},{number}}}" if text.endswith("}") else f"{text}_{{{number}}}"

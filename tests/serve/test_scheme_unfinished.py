"""What a drawing that is no mechanism yet is told: its mobility and the one thing that is missing."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from support.slider_sketch import PLACES, body

from graphic_tmm.language.catalogue import speaking
from graphic_tmm.serve.scheme.act import SchemeAct, scheme

EN = speaking("en")

UNFINISHED: list[tuple[list[dict[str, Any]], int | None, int | None, str]] = [
    ([body(0)], None, None, "Draw a link"),
    ([body(0), body(1, "O", "A")], None, 3, "W = 3: hold one of its pins"),
    ([body(0, "O"), body(1, "O", "A")], None, 1, "say which link is driven"),
    (
        [body(0, "O"), body(1, "O", "A"), body(2, "A", "B")],
        1,
        2,
        "O(1,0), A(1,2); joined with nothing: B",
    ),
    ([body(0, "O", "B"), body(1, "O", "A"), body(2, "A", "B")], 1, 0, "a pair is too many"),
    ([body(0, "O", "B"), body(1, "O", "A"), body(2, "A", "B")], None, 0, "nothing can move"),
    ([body(0, "O"), body(1, "O", "A"), body(2, "B")], 1, 4, "link 2 is tied to nothing"),
]


@pytest.mark.parametrize(("links", "drive", "mobility", "says"), UNFINISHED)
def test_what_is_missing_is_said(
    links: list[dict[str, Any]], drive: int | None, mobility: int | None, says: str
) -> None:
    sketch = {"places": PLACES, "links": links, "drives": [] if drive is None else [drive]}
    made = scheme(b"", Path("scheme.toml"), SchemeAct(sketch=sketch), EN)
    assert made["mobility"] == mobility
    assert says in made["says"]
    assert made["text"] is None
    assert made["sketch"] == sketch

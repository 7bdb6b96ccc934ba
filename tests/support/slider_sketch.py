"""A crank and a slider as a browser sends them."""

from __future__ import annotations

from typing import Any


def body(number: int, *points: str, **more: Any) -> dict[str, Any]:
    return {"number": number, "points": list(points), "guides": {}, "slides": [], **more}


PLACES = {"O": [0.1, 0.2], "A": [0.121, 0.23], "B": [0.252, 0.2]}


def crank_and_slider() -> dict[str, Any]:
    slider = body(3, "B", slides=[{"on": 0, "along": "x"}])
    frame = {**body(0, "O"), "guides": {"x": {"through": [0.0, 0.2003], "angle": 0.0}}}
    links = [frame, body(1, "O", "A"), body(2, "A", "B"), slider]
    return {"places": PLACES, "links": links, "drives": [1]}

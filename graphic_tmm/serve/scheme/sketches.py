"""A sketch as a browser sends it, a mechanism as it lies, and each as the other.

JSON: places of letters [x, y], m; links with number, letters, guides and slides, the frame first, passive
or not; guides (through, angle) in the axes of the frame; the numbers of the driving links.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from graphic_tmm.mechanism.guides import turn
from graphic_tmm.mechanism.records import Guide, Link, Mechanism, Slide
from graphic_tmm.scene.document import Document

MOST = 60
"""So many links, and letters of a link, a sketch may have: four times the largest mechanism of the books."""
FAR = 1e6
"""Nothing lies farther from the origin, m."""
Sketch = dict[str, Any]
BLANK: Sketch = {
    "places": {},
    "links": [{"number": 0, "points": [], "guides": {}, "slides": []}],
    "drives": [],
}
"""Nothing but the frame."""
GEOMETRY = ("points", "guides", "slides", "centre", "passive", "weld")
"""Keys of a link that a sketch tells."""
ARM = ("guides", "slides")
"""Keys of a link that a sketch cannot show at an arm: it shows one plate then."""
SIDES = ("side", "flips_at")
"""Keys that say where a link lies: one that is passive has none."""


def is_sketch(told: object) -> bool:
    """Whether something is a sketch in form: what it says may still be no mechanism."""
    if not isinstance(told, dict) or not {"places", "links", "drives"} <= told.keys():
        return False
    places, links, drives = told["places"], told["links"], told["drives"]
    return (
        isinstance(places, dict)
        and isinstance(links, list)
        and 0 < len(links) <= MOST
        and len(places) <= MOST * MOST
        and all(map(_is_place, places.values()))
        and all(_is_link(one, places) for one in links)
        and isinstance(drives, list)
        and len(drives) <= MOST
        and all(map(_is_number, drives))
    )


def _is_number(told: object) -> bool:
    return isinstance(told, int) and not isinstance(told, bool) and 0 <= told < 1000


def is_length(told: object) -> bool:
    """Whether something is a number that a place may have."""
    plain = isinstance(told, (int, float)) and not isinstance(told, bool)
    return plain and math.isfinite(told) and abs(told) <= FAR  # type: ignore[arg-type]


def _is_place(told: object) -> bool:
    return isinstance(told, list) and len(told) == 2 and all(map(is_length, told))


def _is_link(told: object, places: Mapping[str, object]) -> bool:
    if not isinstance(told, dict) or not _is_number(told.get("number")):
        return False
    points, guides, slides = (told.get(key) for key in ("points", "guides", "slides"))
    return (
        isinstance(points, list)
        and len(points) <= MOST
        and all(isinstance(one, str) and one in places for one in points)
        and isinstance(guides, dict)
        and all(
            isinstance(one, dict) and _is_place(one.get("through")) and is_length(one.get("angle"))
            for one in guides.values()
        )
        and isinstance(slides, list)
        and all(
            isinstance(one, dict)
            and _is_number(one.get("on"))
            and isinstance(one.get("along"), str)
            and isinstance(one.get("cylinder", ""), str)
            for one in slides
        )
        and isinstance(told.get("centre", ""), str)
        and isinstance(told.get("passive", False), bool)
        and ("weld" not in told or _is_number(told["weld"]))
    )


def lying_document(sketch: Sketch, like: Document) -> Document:
    """Return the tables of a sketch, links in the axes of the frame; ``like``: says what else is given."""
    places = sketch["places"]
    frame, *links = sketch["links"]
    known = {one.get("number"): one for one in like.get("link", []) if isinstance(one, dict)}
    fixed: dict[str, Any] = {"number": frame["number"]}
    fixed |= {letter: _place(places[letter]) for letter in frame["points"]} | _guides(frame)
    told = [
        _link(
            one if one["number"] in known else _from_pivot(one, frame),
            places,
            frame["number"],
            known.get(one["number"], {}),
        )
        for one in links
    ]
    return {**like, "frame": fixed, "link": told}


def with_centres(doc: Document, sketch: Sketch) -> Document:
    """Return a scene whose links have the mass centres of a sketch; none of a point that is gone."""
    drawn = {one["number"]: one for one in sketch["links"]}
    links = []
    for link in doc.get("link", ()):
        now = drawn.get(link.get("number"), {})
        points = [
            k for one in sketch["links"] if link.get("number") in _whose(one) for k in one["points"]
        ]
        if now.get("centre"):
            link = {**link, "centre": now["centre"]}
        elif now and "centre" in link and link["centre"] not in points:
            link = {key: value for key, value in link.items() if key != "centre"}
        links.append(link)
    return {**doc, "link": links} if links else doc


def _from_pivot(link: Sketch, frame: Sketch) -> Sketch:
    """Return a link whose letters begin with its pivot, where its own axes begin."""
    letters = sorted(link["points"], key=lambda letter: letter not in frame["points"])
    return {**link, "points": letters}


def _link(
    link: Mapping[str, Any], places: Mapping[str, Any], frame: int, known: Mapping[str, Any]
) -> Document:
    passive = link.get("passive", False)
    gone = (*GEOMETRY, *SIDES) if passive or "weld" in link else GEOMETRY
    made = {key: value for key, value in known.items() if key not in gone}
    made |= {"number": link["number"]} | ({"passive": True} if passive else {})
    made["points"] = {letter: _place(places[letter]) for letter in link["points"]}
    if "weld" in link:
        made["weld"] = {"to": link["weld"], "angle": "0 deg"}
    if link["guides"]:
        made["guides"] = _guides(link)
    before = known.get("slides", [])
    before = before if isinstance(before, list) else [before]
    slides = []
    for slide in link["slides"]:
        same = (
            one for one in before if isinstance(one, dict) and one.get("along") == slide["along"]
        )
        keys = ("cylinder",) if passive else (*SIDES, "cylinder")
        kept = {k: v for k, v in next(same, {}).items() if k in keys}
        cylinder = {"cylinder": slide["cylinder"]} if slide.get("cylinder") else {}
        on = "frame" if slide["on"] == frame else slide["on"]
        slides.append({**kept, **cylinder, "on": on, "along": slide["along"]})
    if slides:
        made["slides"] = slides if len(slides) > 1 else slides[0]
    if link.get("centre"):
        made["centre"] = link["centre"]
    return made


def _guides(link: Mapping[str, Any]) -> dict[str, Any]:
    return {
        name: {"through": _place(one["through"]), "angle": f"{one['angle']!r} deg"}
        for name, one in link["guides"].items()
    }


def _place(place: list[float]) -> list[str]:
    return [f"{length!r} m" for length in place]


def scaled(sketch: Sketch, by: float) -> Sketch:
    """Return a sketch that is larger."""
    return _moved(sketch, lambda place: [by * length for length in place])


def shifted(sketch: Sketch, by: complex) -> Sketch:
    """Return a sketch that lies elsewhere, m; guides of the frame go through what is nearest to the origin."""
    made = _moved(sketch, lambda place: [place[0] + by.real, place[1] + by.imag])
    frame, *links = made["links"]
    guides = {name: {**one, "through": _foot(one)} for name, one in frame["guides"].items()}
    return {**made, "links": [{**frame, "guides": guides}, *links]}


def _foot(guide: Mapping[str, Any]) -> list[float]:
    way = turn(guide["angle"])
    off = (complex(*guide["through"]) * way.conjugate()).imag
    return _pair(1j * off * way)


def _moved(sketch: Sketch, place: Callable[[list[float]], list[float]]) -> Sketch:
    def body(link: Sketch) -> Sketch:
        guides = {n: {**one, "through": place(one["through"])} for n, one in link["guides"].items()}
        return {**link, "guides": guides}

    places = {letter: place(there) for letter, there in sketch["places"].items()}
    return {**sketch, "places": places, "links": [body(one) for one in sketch["links"]]}


def sketch_of(lies: Mechanism, places: Mapping[str, complex], doc: Document) -> Sketch:
    """Return a mechanism that lies somewhere as a browser takes it.

    ``places``: of its letters, m; ``doc``: its scene: a mass centre is drawn as one where that says so.
    """
    told = {one.get("number"): one for one in doc["link"]}
    centres = {number: one.get("centre") for number, one in told.items()}
    return {
        "places": {letter: _pair(z) for letter, z in places.items()},
        "links": _on_arms(
            [
                body | ({"passive": True} if one in lies.passive else {})
                for one in (lies.frame, *lies.drawn)
                for body in _bodies(one, centres.get(one.number), told)
            ]
        ),
        "drives": [one.link for one in lies.drives],
    }


def _whose(link: Sketch) -> tuple[Any, Any]:
    """Return the number of a link, and that of the link with which it is one body."""
    return link["number"], link.get("weld", link["number"])


def _bodies(link: Link, centre: object, told: Mapping[object, Any]) -> list[Sketch]:
    """Return a link as a browser takes it, each of its arms by itself."""
    first, *arms = link.arms or (None,)
    if first is None or any(key in told.get(arm.number, {}) for arm in arms if arm for key in ARM):
        return [_body(link, centre)]
    own = replace(link, points={letter: link.points[letter] for letter in first.letters})
    bodies = [_body(own, centre)]
    for arm in arms:
        assert arm is not None
        bodies.append(_body(Link(arm.number, dict.fromkeys(arm.letters, 0j)), centre))
        bodies[-1]["weld"] = link.number
    return bodies


def _on_arms(links: list[Sketch]) -> list[Sketch]:
    """Return links whose slides along two letters of an arm are on this."""
    for slide in (one for link in links for one in link["slides"]):
        for arm in (one for one in links if one.get("weld") == slide["on"]):
            if any(slide["along"] == a + b for a in arm["points"] for b in arm["points"] if a != b):
                slide["on"] = arm["number"]
    return links


def _body(link: Link, centre: object) -> dict[str, Any]:
    made: dict[str, Any] = {
        "number": link.number,
        "points": list(link.points),
        "guides": {one.name: _guide(one) for one in link.guides},
        "slides": [_slide(one) for one in link.slides],
    }
    return made | ({"centre": centre} if centre in link.points else {})


def _guide(guide: Guide) -> dict[str, Any]:
    return {"through": _pair(guide.through), "angle": guide.angle}


def _slide(slide: Slide) -> dict[str, Any]:
    made: dict[str, Any] = {"on": slide.on, "along": slide.guide.name}
    return made | ({"cylinder": slide.cylinder} if slide.cylinder else {})


def _pair(z: complex) -> list[float]:
    return [z.real, z.imag]

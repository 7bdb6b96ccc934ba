"""The tables of a mechanism's frame and links, as a scene says them; what a scene says already in its words."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import MISSING, replace
from functools import cached_property
from typing import Any

from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Arm, Drive, Guide, Link, Mechanism, Slide
from graphic_tmm.mechanism.sketch import parted
from graphic_tmm.scene import guides
from graphic_tmm.scene import mechanism as m
from graphic_tmm.scene.build import mechanism_of
from graphic_tmm.scene.declare import FAULTY, Names, Sort
from graphic_tmm.scene.document import Document, as_table, raw_links
from graphic_tmm.scene.meaning import alike, inner, is_point, left_out, meant, same, sort_of
from graphic_tmm.scene.mechanism import DIGITS, Joints
from graphic_tmm.scene.quantities import measuring, si
from graphic_tmm.scene.sections import lengths_of, measures, understand
from graphic_tmm.scene.values import LINK_SIDE, SENSE
from graphic_tmm.scene.weld import OF_BODY

AS_IT_IS = Joints()
"""The hand that rounds nothing."""
_GEOMETRY = ("points", "guides", "slides", "passive", "weld")
TENTHS = 0.1
"""The angle of an arm is rounded so, degrees, where lengths are."""


def tables_of(
    mechanism: Mechanism,
    hand: Joints = AS_IT_IS,
    doc: Document | None = None,
    lies: Mechanism | None = None,
) -> Document:
    """Return the tables frame and link of a mechanism in own axes; joints, too, of a scene that has them.

    Parameters
    ----------
    mechanism : Mechanism
        In own axes, as `mechanism.sketch.built` returns it.
    hand : Joints
        How lengths are rounded that the scene does not say.
    doc : dict, optional
        The scene as it was: what it says that is the same stays in its words, and so does all that is no
        geometry.
    lies : Mechanism, optional
        The mechanism as it lies, where ``doc`` has links by joints: they are said so again.

    Raises
    ------
    SceneError
        If a link that others are welded to has changed.
    """
    doc = doc or {}
    with measuring(measures(doc)):
        return _Tables(mechanism, lies, doc, lengths_of(doc)).all(hand)


def link_table(link: Link, hand: Joints, frame: int, told: Mapping[str, Any]) -> dict[str, Any]:
    """Return a link in its own axes as a scene says it; ``told``: its table, whose words for sides stay."""
    found: dict[str, Any] = {
        "number": link.number,
        "points": {letter: hand.point(z) for letter, z in link.points.items()},
    }
    if link.guides:
        found["guides"] = {one.name: guide_table(one, hand) for one in link.guides}
    if link.slides:
        row = list(link.points.values())
        reach = max((abs(z - row[0]) for z in row[:2]), default=0.0)
        known = _by_pair(told, frame)
        slides = [
            _slide(one, hand, frame, reach, known.get((one.on, one.guide.name), {}))
            for one in link.slides
        ]
        lone = len(slides) == 1 and not isinstance(told.get("slides"), list)
        found["slides"] = slides[0] if lone else slides
    if link.side is not None and link.side.left_of is not None:
        found["side"] = _side(link.side.sign, link.side.left_of, told.get("side"))
        if link.side.flips_at is not None:
            found["flips_at"] = [_degrees(at) for at in link.side.flips_at]
    return found


def near_table(link: Link, told: Mapping[str, Any], drive: Drive) -> dict[str, Any]:
    """Return which place of a plate is meant, where a scene does not say it."""
    if link.near is None or "near" in told:
        return {}
    found: dict[str, Any] = {"near": f"{link.near.angle:.6g} deg"}
    if (at := link.near.at) is not None:
        slides = drive.slides or drive.rack
        found["near_at"] = f"{at:.{DIGITS}g} m" if slides else _degrees(at)
    return found


def slides_of(link: Mapping[str, Any]) -> list[Mapping[str, Any]]:
    """Return the tables of a link's sliding pairs, written as a table or as a list of them."""
    told = link.get("slides")
    return told if isinstance(told, list) else [told] if isinstance(told, dict) else []


def _by_pair(link: Mapping[str, Any], frame: int) -> dict[tuple[Any, Any], Mapping[str, Any]]:
    """Return the tables of a link's sliding pairs by the number of the other link and its guide."""
    return {
        (frame if one.get("on") == "frame" else one.get("on"), one.get("along")): one
        for one in slides_of(link)
    }


def guide_table(guide: Guide, hand: Joints) -> dict[str, Any]:
    """Return a guide as a scene says it."""
    return {"through": hand.point(guide.through), "angle": _degrees(guide.angle)}


def _degrees(angle: float) -> str:
    return f"{angle:.{DIGITS}g} deg"


def _slide(
    slide: Slide, hand: Joints, frame: int, reach: float, told: Mapping[str, Any]
) -> dict[str, Any]:
    on = "frame" if slide.on == frame else slide.on
    found: dict[str, Any] = {"on": on, "along": slide.guide.name}
    if offset := hand.length(slide.offset):
        found["offset"] = offset
    if angle := hand.angle(slide.angle, reach):
        found["angle"] = angle
    if slide.side is not None:
        found["side"] = _sense(slide, told.get("side"), fixed=slide.on == frame)
        if slide.side.flips_at is not None:
            found["flips_at"] = [_degrees(at) for at in slide.side.flips_at]
    elif "side" in told:
        found["side"] = told["side"]
    if slide.cylinder:
        found["cylinder"] = slide.cylinder
    return found


def _sense(slide: Slide, told: object, *, fixed: bool) -> str:
    """Return the word for a side along a guide: that of the scene or its opposite, if either tells it."""
    assert slide.side is not None
    word = meant(SENSE, told, {})
    if isinstance(told, str) and isinstance(word, str):
        try:
            sign = guides.sense(word, slide.guide, fixed=fixed)
        except ValueError:
            sign = 0
        if sign:
            return (
                told
                if sign == slide.side.sign
                else guides.OTHER_WAY.get(told, guides.OTHER_WAY[word])
            )
    return "+" if slide.side.sign > 0 else "-"


def _side(sign: int, left_of: tuple[str, str], told: object) -> str:
    """Return the side of an inner pin; of the same two letters in the words of the scene."""
    side = meant(LINK_SIDE, told, {})
    known, pair = (0, ("", "")) if side is FAULTY else side
    if set(pair) != set(left_of):
        return f"{'left of' if sign > 0 else 'right of'} {''.join(left_of)}"
    text = str(told).strip()
    if known * (1 if pair == left_of else -1) == sign:
        return str(told)
    return next(
        text.replace(word, other, 1)
        for word, other in guides.OTHER_WAY.items()
        if text.startswith(word) and " " in word
    )


class _Tables:
    """What a mechanism is in a scene, beside what that said before."""

    def __init__(
        self, mechanism: Mechanism, lies: Mechanism | None, doc: Document, names: Names
    ) -> None:
        self.mechanism = mechanism
        self.lies = lies
        self.doc = doc
        self.names = names
        self.told: dict[object, Document] = {one.get("number"): one for _, one in raw_links(doc)}
        self.joined = "joints" in doc or any(map(_is_listed, self.told.values()))

    def all(self, hand: Joints) -> Document:
        """Return the tables, what is new in them as a hand rounds it."""
        frame = self._settled("frame", as_table(self.doc.get("frame")), self._frame, hand)
        made: Document = {"frame": frame, "link": []}
        if joints := as_table(self.doc.get("joints")):
            made["joints"] = self._settled("joints", joints, self._joints, hand)
        links = {one.number: one for one in self.mechanism.drawn}
        arms = {arm.number: (one, arm) for one in links.values() for arm in one.arms[1:]}
        for number in dict.fromkeys((*self.told, *links, *arms)):
            if number in arms:
                made["link"].append(self._arm(*arms[number], hand))
            elif number in links:
                made["link"].append(self._link(self._without_arms(links[number]), hand))
        return made

    def _without_arms(self, body: Link) -> Link:
        """Return a body that others are welded to by itself; refuse what slides at an arm and has changed."""
        if not body.arms:
            return body
        if any(slides_of(self.told.get(one.number, {})) for one in body.arms[1:]):
            self._refuse_changed(body)
        return replace(body, points={k: body.points[k] for k in body.arms[0].letters})

    def _arm(self, body: Link, arm: Arm, hand: Joints) -> Document:
        """Return the table of an arm of a body, in the own axes that it had if it was there."""
        told = self.told.get(arm.number, {})
        if told.get("guides") or told.get("slides"):
            self._refuse_changed(body)
            return told
        known = next(
            (Link(arm.number, dict(one.points)) for one in self.links if one.number == arm.number),
            None,
        )
        own, angle = parted(body, arm, known)
        kept = {k: x for k, x in told.items() if k not in (*_GEOMETRY, *OF_BODY)}

        def table(by: Joints) -> Document:
            shown = round(angle / TENTHS) * TENTHS if by.to else angle
            weld = {"to": body.number, "angle": _degrees(shown)}
            return {**kept, **link_table(own, by, self.mechanism.frame.number, told), "weld": weld}

        sort = inner(sort_of("link"), [], 0)
        made: Document = _settled(sort, told, table(AS_IT_IS), table(hand), self.names)
        return made

    @cached_property
    def links(self) -> list[m.Link]:
        """The links that the scene had, each as it is written."""
        found = understand(self.doc)[0].links if self.doc.get("link") else []
        return [one for one in found if one is not None]

    def _settled(self, section: str, told: Document, table: Any, hand: Joints) -> Any:
        sort = sort_of(section)
        return _settled(sort, told, table(AS_IT_IS), table(hand), self.names)

    def _frame(self, hand: Joints) -> Document:
        frame = self.mechanism.frame
        points = {letter: hand.point(z) for letter, z in frame.points.items()}
        lines = {one.name: guide_table(one, hand) for one in frame.guides}
        return {"number": frame.number, **points, **lines}

    def _joints(self, hand: Joints) -> Document:
        """Return the places of letters by which links are told, and what else stands there."""
        links = () if self.lies is None else self.lies.drawn
        places = {
            letter: z
            for link in links
            if self._listed(link)
            for letter, z in link.points.items()
            if letter not in self.mechanism.frame.points
        }
        told = self.doc["joints"]
        kept = {key: told[key] for key in ("to", "near") if key in told}
        return kept | {
            k: [hand.rounded(x) or 0 for x in (z.real, z.imag)] for k, z in places.items()
        }

    def _listed(self, link: Link) -> bool:
        told = self.told.get(link.number)
        return self.lies is not None and (self.joined if told is None else _is_listed(told))

    def _link(self, link: Link, hand: Joints) -> Document:
        """Return the table of a link, with what it said that is no geometry."""
        told = self.told.get(link.number, {})
        exact, rounded = (self._written(link, told, one) for one in (AS_IT_IS, hand))
        sort = inner(sort_of("link"), [], 0)
        made: Document = _settled(sort, told, exact, rounded, self.names)
        return made

    def _written(self, link: Link, told: Document, hand: Joints) -> Document:
        own = link_table(link, hand, self.mechanism.frame.number, told)
        if self._listed(link):
            own = self._by_joints(own, told, hand)
        own |= near_table(link, told, self.mechanism.drive)
        passive = link in self.mechanism.passive
        own |= {"passive": True} if passive else {}
        if not told:
            return own | _loads(link)
        stands = self._side_stands(told) and not passive
        gone = _GEOMETRY if stands else (*_GEOMETRY, "side", "flips_at")
        return {k: x for k, x in told.items() if k not in gone} | own

    def _side_stands(self, told: Document) -> bool:
        """Whether the letters by which a link tells its side are still there."""
        bodies = (self.mechanism.frame, *self.mechanism.drawn)
        side = meant(LINK_SIDE, told.get("side"), {})
        return side is FAULTY or all(any(k in one.points for one in bodies) for k in side[1])

    def _by_joints(self, own: Document, told: Document, hand: Joints) -> Document:
        """Return the table of a link by the places of its joints: guides as they lie, sides if it said them."""
        assert self.lies is not None
        lies = next(one for one in self.lies.drawn if one.number == own["number"])
        known = told.get("points", [])
        letters = [k for k in known if k in own["points"]]
        made = {**own, "points": letters + [k for k in own["points"] if k not in letters]}
        if lies.guides:
            by_letter = {
                name: one["through"]
                for name, one in as_table(told.get("guides")).items()
                if str(as_table(one).get("through")) in lies.points
            }
            made["guides"] = {
                one.name: guide_table(one, hand)
                | ({"through": by_letter[one.name]} if one.name in by_letter else {})
                for one in lies.guides
            }
        if "side" not in told:
            made.pop("side", None)
        frame, left = self.mechanism.frame.number, ("offset", "angle")
        known_slides = _by_pair(told, frame)
        slides = [
            {
                k: x
                for k, x in one.items()
                if k not in left and (k != "side" or k in known_slides.get(at, {}))
            }
            for at, one in _by_pair(own, frame).items()
        ]
        if slides:
            made["slides"] = slides if isinstance(own["slides"], list) else slides[0]
        return made

    def _refuse_changed(self, body: Link) -> None:
        """Refuse a body that has changed of which an arm slides or is slid on."""
        was = mechanism_of(understand(self.doc)[0])
        if was is None or not alike(was.by_number.get(body.number), body):
            says = said(
                "link {body} has arms that are told in their own axes; change them in the file",
                body=body.number,
            )
            raise SceneError("", (Fault(f"link {body.number}", 0, says),))


def _is_listed(link: Mapping[str, Any]) -> bool:
    return isinstance(link.get("points"), list)


def _loads(link: Link) -> dict[str, Any]:
    """Return what a link is called and weighs, as a scene says it."""
    found: dict[str, Any] = {"name": link.name} if link.name else {}
    if link.mass is not None:
        found["mass"] = f"{si(link.mass, 'mass'):.{DIGITS}g} kg"
    if link.centre is not None:
        found["centre"] = link.centre
    if link.rod is not None:
        found["rod"] = AS_IT_IS.rounded(link.rod)
    elif link.inertia is not None:
        found["J"] = f"{si(link.inertia, 'moment of inertia'):.{DIGITS}g} kg*m^2"
    return found


def _settled(sort: Sort | None, told: Any, exact: Any, rounded: Any, names: Names) -> Any:
    """Return what is new as it was rounded; where that says what was told already, as that was told."""
    if isinstance(told, dict) and isinstance(exact, dict):
        made = {}
        for key in dict.fromkeys((*(k for k in told if k in exact), *exact)):
            one, default = inner(sort, told, key), left_out(sort, told, key)
            if key in told and key in rounded:
                made[key] = _settled(one, told[key], exact[key], rounded[key], names)
            elif key in told and same(one, told[key], exact[key], names):
                made[key] = told[key]
            elif key in rounded and not (
                default is not MISSING and alike(meant(one, exact[key], names), default)
            ):
                made[key] = rounded[key]
        return made
    items = isinstance(told, list) and isinstance(exact, list) and len(told) == len(exact)
    if items and (is_point(sort, told) or any(isinstance(one, dict) for one in exact)):
        return [
            _settled(inner(sort, told, k), told[k], exact[k], rounded[k], names)
            for k in range(len(exact))
        ]
    return told if same(sort, told, exact, names) else rounded

"""Names that a file uses: letters, link numbers and guides have to exist, and may not be confused.

These checks look at the parsed document itself, so that a fault elsewhere hides none of them.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import NamedTuple, TypeGuard

from graphic_tmm.language.said import Said, joined, said
from graphic_tmm.scene import letters
from graphic_tmm.scene.declare import Flaw, Path
from graphic_tmm.scene.document import Document, as_table, raw_links, texts
from graphic_tmm.scene.values import link_side


class Body(NamedTuple):
    """A link as far as names go: its place in the file, its letters, the names of its guides.

    ``passive``: it carries no forces; ``welded``: the link with which it is one body.
    """

    path: Path
    letters: tuple[str, ...]
    guides: tuple[str, ...]
    passive: bool = False
    welded: int | None = None


class Outline(NamedTuple):
    """The names of a file: its links by number (the frame too), and the number of the frame.

    Not ``complete`` where a link has no number that could be read. ``letters``: of all points, in the order of
    the file, each once; ``moving``: those that do not stand on the frame.
    """

    frame: int
    bodies: dict[int, Body]
    complete: bool
    letters: tuple[str, ...]
    moving: tuple[str, ...]

    @property
    def bearing(self) -> dict[int, Body]:
        """The links that bear forces: no passive one, an arm as part of its link."""
        return {
            number: body
            for number, body in self.bodies.items()
            if not body.passive and body.welded is None
        }


def outline(doc: Document) -> Outline:
    """Return the names of a file, whatever else is wrong; of two links of one number the first."""
    frame = as_table(doc.get("frame"))
    number = frame.get("number", 0)
    fixed: int = number if _is_whole(number) else 0
    places = _places(doc)
    guides = tuple(key for key, value in places.items() if isinstance(value, dict))
    points = tuple(key for key, value in places.items() if not isinstance(value, dict))
    bodies = {fixed: Body(("frame",), points, guides)}
    complete = True
    for path, link in raw_links(doc):
        complete = complete and _is_number(link.get("number"))
        if _is_whole(link.get("number")):
            body = Body(
                path,
                tuple(as_table(link.get("points"))),
                tuple(as_table(link.get("guides"))),
                link.get("passive") is True,
                to if _is_whole(to := as_table(link.get("weld")).get("to")) else None,
            )
            bodies.setdefault(link["number"], body)
    for arm in [one for one in bodies.values() if one.welded in bodies]:
        whole = bodies[arm.welded or 0]
        bodies[arm.welded or 0] = whole._replace(
            letters=tuple(dict.fromkeys((*whole.letters, *arm.letters))),
            guides=(*whole.guides, *arm.guides),
        )
    letters = dict.fromkeys(name for body in bodies.values() for name in body.letters)
    standing = set(bodies[fixed].letters)
    moving = tuple(letter for letter in letters if letter not in standing)
    return Outline(fixed, bodies, complete, tuple(letters), moving)


def name_faults(doc: Document, missing: Callable[[str], str]) -> Iterator[Flaw]:
    """Everything that is wrong with the names of a file.

    Parameters
    ----------
    doc : dict
        The parsed document.
    missing : callable
        text -> those of its characters that cannot be lettered.
    """
    names = outline(doc)
    yield from _numbers(doc, names)
    for path, text in texts(doc):
        yield from (Flaw(path, says) for says in letters.undrawable(text, missing(text)))
    yield from _letters(doc)
    for path, link in raw_links(doc):
        yield from _slides(path, link, names)
        yield from _sides(path, link, names)
        yield from _centre(path, link)
    drives = doc.get("drive")
    if isinstance(drives, list):
        for k, one in enumerate(drives):
            yield from _drive(as_table(one), names, ("drive", k))
    else:
        yield from _drive(as_table(drives), names, ("drive",))
    yield from _trajectories(as_table(doc.get("plans")).get("trajectories"), names)


def _places(doc: Document) -> Document:
    """Return the points and guides of the frame."""
    frame = as_table(doc.get("frame"))
    return {key: value for key, value in frame.items() if isinstance(value, (list, dict))}


def _is_whole(value: object) -> TypeGuard[int]:
    return isinstance(value, int) and not isinstance(value, bool) and abs(value) < 10**9


def _is_number(value: object) -> bool:
    return _is_whole(value) and 0 <= value <= 999


def _numbers(doc: Document, names: Outline) -> Iterator[Flaw]:
    for path, link in raw_links(doc):
        number = link.get("number")
        if not _is_whole(number) or names.bodies[number].path == path:
            continue
        yield Flaw((*path, "number"), number_taken(number, names))


def number_taken(number: int, names: Outline) -> Said:
    """Tell that a number is that of a link, and one that is free."""
    return said(
        "{number} is the number of {taken}; write {free} or another",
        number=number,
        taken=FRAME if number == names.frame else said("another link", context="of"),
        free=next((n for n in range(1, 1000) if n not in names.bodies), 0),
    )


def _letters(doc: Document) -> Iterator[Flaw]:
    """Faults of single letters, then of letters that are confused with an earlier one."""
    seen: dict[str, str] = {}
    told: set[str] = set()
    for path, letter, is_point in _written(doc):
        if says := letters.letter_fault(letter, pole=is_point):
            yield Flaw(path, says)
        elif is_point:
            first = seen.setdefault(letters.folded(letter), letter)
            if letter not in told and (says := letters.clash(first, letter)):
                told.add(letter)
                yield Flaw(path, says)


def _written(doc: Document) -> Iterator[tuple[Path, str, bool]]:
    """Every letter with its path, and whether it is a point (else a guide)."""
    for key, value in _places(doc).items():
        yield ("frame", key), key, not isinstance(value, dict)
    for path, link in raw_links(doc):
        for part in ("points", "guides"):
            for key in as_table(link.get(part)):
                yield (*path, part, key), key, part == "points"


def _slides(path: Path, link: Document, names: Outline) -> Iterator[Flaw]:
    slides = link.get("slides", [])
    several = isinstance(slides, list)
    for i, slide in enumerate(slides if several else [slides]):
        at: Path = (*path, "slides", i) if several else (*path, "slides")
        on = as_table(slide).get("on")
        number = names.frame if on == "frame" else on
        if not isinstance(number, int) or isinstance(number, bool):
            continue
        if number not in names.bodies:
            yield from no_link((*at, "on"), number, names)
        elif number == link.get("number"):
            says = said("link {number} cannot slide on itself; write another number", number=number)
            yield Flaw((*at, "on"), says)
        elif number == names.frame and "cylinder" in slide:
            says = said(
                "a cylinder is a link that moves, and link {number} slides on the frame; leave cylinder out",
                number=link.get("number"),
            )
            yield Flaw((*at, "cylinder"), says)
        else:
            yield from _along((*at, "along"), slide.get("along"), number, names)


def no_link(path: Path, number: int, names: Outline) -> Iterator[Flaw]:
    """Tell that there is no link of that number, if all numbers could be read."""
    if names.complete:
        says = said(
            "there is no link {shown}; links are {listed} ({frame} is the frame)",
            shown=number if abs(number) < 10**40 else said("of so large a number"),
            listed=", ".join(str(n) for n in sorted(names.bodies)),
            frame=names.frame,
        )
        yield Flaw(path, says)


def arm_only(number: int, to: int) -> str:
    """Tell that a link is an arm of another, which is to be named in its place."""
    return said(
        "link {number} is welded to link {to} and one body with it; write {to}",
        number=number,
        to=to,
    )


def _along(path: Path, along: object, number: int, names: Outline) -> Iterator[Flaw]:
    body = names.bodies[number]
    if not isinstance(along, str) or along in body.guides:
        return
    of = FRAME if number == names.frame else of_link(number)
    pair = letters.split(along)
    if pair is None:
        says = said(
            '"{along}" is neither a guide of {of} nor two of its letters', along=along, of=of
        )
        wrong = letters.unknown(says, along, body.guides, said("guides of {of}", of=of))
        listed = ", ".join(body.letters) or said("none", context="letters")
        there = said("letters are {listed}", listed=listed)
        yield Flaw(path, joined("; ", (wrong, there)))
    elif pair[0] == pair[1]:
        says = said(
            '"{along}" names one letter twice; name two letters of {of}', along=along, of=of
        )
        yield Flaw(path, says)
    else:
        yield from unknown_letters(path, pair, body.letters, of)


FRAME, MECHANISM = said("the frame", context="of"), said("the mechanism", context="of")


def of_link(number: int) -> str:
    """Return a link as that of which letters are."""
    return said("link {number}", context="of", number=number)


def unknown_letters(
    path: Path, wanted: tuple[str, ...], known: tuple[str, ...], of: str
) -> Iterator[Flaw]:
    """Tell of letters that are none of some body."""
    for letter in wanted:
        if letter not in known:
            says = said('"{letter}" is not a letter of {of}', letter=letter, of=of)
            what = said("letters of {of}", of=of)
            yield Flaw(path, letters.unknown(says, letter, known, what))


def no_moving(letter: str, names: Outline) -> str:
    """Tell that a letter is that of no moving point, and which are."""
    says = said('"{letter}" is no moving point', letter=letter[:20])
    return letters.unknown(says, letter, names.moving, said("moving points"))


def _sides(path: Path, link: Document, names: Outline) -> Iterator[Flaw]:
    try:
        pair = link_side(link["side"])[1] if "side" in link else ()
    except ValueError:
        return
    yield from unknown_letters((*path, "side"), pair, names.letters, MECHANISM)


def _centre(path: Path, link: Document) -> Iterator[Flaw]:
    if isinstance(link.get("centre"), str) and isinstance(link.get("points", {}), dict):
        known = tuple(link.get("points", {}))
        yield from unknown_letters(
            (*path, "centre"), (link["centre"],), known, said("this link", context="of")
        )


def _drive(drive: Document, names: Outline, at: Path) -> Iterator[Flaw]:
    number = drive.get("link")
    if _is_whole(number) and number not in names.bodies:
        yield from no_link((*at, "link"), number, names)
    elif number == names.frame and _is_whole(number):
        says = said(
            "link {number} is the frame, which does not turn; name the crank", number=number
        )
        yield Flaw((*at, "link"), says)
    extra = drive.get("extra")
    extremes: dict[Path, object] = {("zero",): drive.get("zero")}
    extremes |= {
        ("extra", k): one for k, one in enumerate(extra if isinstance(extra, list) else ())
    }
    for path, extreme in extremes.items():
        point = as_table(extreme).get("point")
        if isinstance(point, str):
            yield from _moving((*at, *path, "point"), point, names)


def _trajectories(items: object, names: Outline) -> Iterator[Flaw]:
    for i, letter in enumerate(items if isinstance(items, list) else []):
        if isinstance(letter, str):
            yield from _moving(("plans", "trajectories", i), letter, names)


def _moving(path: Path, letter: str, names: Outline) -> Iterator[Flaw]:
    if letter not in names.moving and letter in names.letters:
        says = said(
            '"{letter}" stands on the frame and does not move; name a moving point', letter=letter
        )
        yield Flaw(path, says)
    else:
        yield from unknown_letters(path, (letter,), names.letters, MECHANISM)

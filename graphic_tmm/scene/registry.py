"""What the chapters of the book declare: sections, and places on sheets, by the names that scenes write."""

from __future__ import annotations

from collections.abc import Iterator, Sequence, Set

from graphic_tmm.scene.chapter import MECHANISM, Chapter, chapters, places
from graphic_tmm.scene.declare import Section, keys_of


def sections() -> tuple[Section, ...]:
    """Return the sections of all chapters, in their order."""
    return tuple(section for chapter in chapters() for section in chapter.sections)


def named(name: str) -> Section | None:
    """Return a section by its name; None if no chapter declares it."""
    return next((section for section in sections() if section.name == name), None)


def size_keys() -> tuple[str, ...]:
    """Return the keys of chapters that fix how large something is drawn, as section.key."""
    return tuple(
        f"{section.name}.{name}"
        for section in sections()
        for name, declared in keys_of(section.record).items()
        if declared.fixes == "size"
    )


SMALLEST = "A4"
"""The format on which nothing stands that no sheet asks for."""


def known_places() -> tuple[str, ...]:
    """Return all places: first those of a sheet that does not say what it shows, in their order."""
    ranks = {name: place.rank for name, (_, place) in places().items()}
    first = sorted((name for name in ranks if ranks[name]), key=ranks.__getitem__)
    return (*first, *(name for name in ranks if not ranks[name]))


def usual(asked: Set[str], *, mechanism: bool) -> tuple[str, ...]:
    """Return what stands on a sheet that does not say what does.

    ``asked``: the sections that are there; a chapter without one shows something of every mechanism.
    """
    there = places()
    ranked = (name for name in known_places() if there[name][1].rank)
    return tuple(name for name in ranked if called(there[name][0], asked, mechanism=mechanism))


def without(usual: Sequence[str], named: Sequence[str]) -> tuple[str, ...]:
    """Return what stands on a sheet that does not say what does: of the usual what no other sheet names.

    Where others name all of it, it shows all again.
    """
    single = {part for name in named for part in places()[name][1].together or (name,)}
    rest = (n for n in usual if not single.issuperset(places()[n][1].together or (n,)))
    return tuple(rest) or tuple(usual)


def called(one: Chapter, asked: Set[str], *, mechanism: bool) -> bool:
    """Whether a scene calls for what a chapter shows."""
    own = one.asking
    return mechanism and one.board == MECHANISM if own is None else own.name in asked


def attended(
    orders: Sequence[tuple[str, ...]], formats: Sequence[str], asked: Set[str]
) -> tuple[tuple[str, ...], ...]:
    """Return what stands on sheets together with what attends it, where none of them names that.

    ``asked``: the sections that are there; what attends is shown where its chapter is called for.

    The smallest sheets hold nothing but what they are asked for.
    """
    large = [not format.startswith(SMALLEST) for format in formats]
    found = _moved(orders, large)
    for name, (one, place) in places().items():
        if not called(one, asked, mechanism=True):
            continue
        there = (k for k, order in enumerate(found) if large[k] and place.attends in order)
        first = next(there, None)
        if first is not None and not any(name in order for order in found):
            found[first] = _behind(found[first], place.attends, name)
    return tuple(found)


def _moved(orders: Sequence[tuple[str, ...]], large: Sequence[bool]) -> list[tuple[str, ...]]:
    """Return what stands on sheets with parts of places moved to where what they tell of is shown.

    Nothing is moved onto the smallest sheets.
    """
    found, there = list(orders), places()
    for name, (_, place) in there.items():
        home = next((k for k, order in enumerate(found) if name in order), None)
        if home is None:
            continue
        left = []
        for part in place.together:
            plan = there[part][1].tells
            shown = [k for k, order in enumerate(found) if plan in order]
            if home in shown or not shown or not large[shown[0]]:
                left.append(part)
            elif not any(part in order for order in found):
                found[shown[0]] = _behind(found[shown[0]], plan, part)
        if len(left) < len(place.together):
            at = found[home].index(name)
            found[home] = (*found[home][:at], *left, *found[home][at + 1 :])
    return found


def _behind(order: tuple[str, ...], place: str, more: str) -> tuple[str, ...]:
    """Return what stands on a sheet with one place more, behind another."""
    at = order.index(place) + 1
    return (*order[:at], more, *order[at:])


def of_section(section: Section) -> tuple[str, ...]:
    """Return what a sheet can show of what a section asks for."""
    return tuple(place.name for one in chapters() if one.asking == section for place in one.places)


def called_by(section: Section) -> Iterator[str]:
    """Yield what sheets show of what a section asks for, but for what only a sheet that names it shows."""
    there = places()
    yield from (name for name in of_section(section) if there[name][1].rank)


def without_mechanism() -> tuple[str, ...]:
    """Return what a sheet can show where there is no mechanism."""
    return tuple(name for name, (one, _) in places().items() if one.board != MECHANISM)

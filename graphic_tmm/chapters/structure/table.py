"""The tables of structure: links by their pairs, pairs; the lines below them; what machines are given of it."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from graphic_tmm.chapters.structure import STRUCTURE
from graphic_tmm.chapters.structure.record import STRUCTURE_PLAN
from graphic_tmm.language.catalogue import Tongues, speaking
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.groups import AssurGroup, Pair
from graphic_tmm.mechanism.passive import holds
from graphic_tmm.mechanism.records import Link, Mechanism
from graphic_tmm.mechanism.structure import CLASSES, Structure, driven_otherwise, freedoms
from graphic_tmm.mechanism.wheels import Rolling
from graphic_tmm.paper.blocks import breakable
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import Heights
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.readers.columns import Tabled
from graphic_tmm.readers.protocol import Protocols
from graphic_tmm.scene.captions import captions

LINK_NAMES = Tongues(
    {
        "crank": said("crank"),
        "rocker": said("rocker"),
        "slotted rocker": said("slotted rocker"),
        "coupler": said("connecting rod"),
        "cylinder": said("cylinder"),
        "piston": said("piston with rod"),
        "slider": said("slider"),
        "stone": said("sliding block"),
        "frame": said("frame"),
        "link": said("link"),
        "wheel": said("wheel", context="link"),
        "belt": said("pulley"),
        "crossed belt": said("pulley"),
        "chain": said("sprocket"),
    }
)
"""What a link is called by its role."""


def link_role(mechanism: Mechanism, structure: Structure, link: Link) -> str:
    """Return what a link is by its pairs: crank, rocker, coupler, slider, piston ... (a key of LINK_NAMES)."""
    frame = mechanism.frame.number
    if link.number == frame:
        return "frame"
    there = (*structure.pairs, *(pair for hold in holds(mechanism) for pair in hold.pairs))
    pairs = [pair for pair in there if link.number in pair.links]
    for pair in (one for one in pairs if one.slide is not None and one.slide.cylinder):
        return "piston" if pair.links[0] == link.number else "cylinder"
    for one in structure.driven:
        if one.telescopes and link.number in one.pair.links:
            return "piston" if link.number == one.link else "cylinder"
        if link.number == one.link and one.pair.kind == "R":
            return "crank"
    slides_on = [
        pair.links[1] for pair in pairs if pair.kind == "P" and pair.links[0] == link.number
    ]
    if slides_on:
        return "slider" if frame in slides_on else "stone"
    owns = any(pair.kind == "P" and pair.links[1] == link.number for pair in pairs)
    rolling = {wheel.link: wheel.mesh for wheel in structure.wheels}
    if not owns and link.number in rolling:
        mesh = rolling[link.number]
        return mesh.by if mesh.belted else "wheel"
    turns_on_frame = any(pair.kind == "R" and frame in pair.links for pair in pairs)
    if owns:
        return "slotted rocker" if turns_on_frame else "link"
    return "rocker" if turns_on_frame else "coupler"


ARMS = said("{name}, arms {arms}")
"""What a link is called that others are welded to."""
WELDED = said("Links {link} and {arm} are welded at {letter}: one link, {link}")
"""What stands below the table of pairs, and in a note, on an arm."""


def link_name(mechanism: Mechanism, structure: Structure, link: Link, language: str) -> str:
    """Return the name the scene gives to a link, or that of its role; of one with arms these, too."""
    name = link.name or LINK_NAMES[language][link_role(mechanism, structure, link)]
    if not link.arms:
        return name
    arms = ", ".join(
        "".join((arm.at, *(k for k in arm.letters if k != arm.at))) for arm in link.arms
    )
    return speaking(language)(ARMS, name=name, arms=arms)


def pair_name(pair: Pair, mechanism: Mechanism) -> str:
    """Return a pair's letter; a guide of the frame is named y-y, one on a moving link by the stone's letter."""
    if pair.kind != "P":
        return pair.name
    if pair.links[1] == mechanism.frame.number:
        return f"{pair.name}-{pair.name}"
    letters = mechanism.by_number[pair.links[0]].points
    return next(iter(letters), pair.name)


WORDS = Tongues(
    {
        "links": said("Links"),
        "pairs": said("Kinematic pairs"),
        "number": said("No."),
        "link": said("Link"),
        "mobility": said("Mobility"),
        "movable": said("movable"),
        "passive": said("passive", context="link"),
        "fixed": said("fixed"),
        "letter": said("Letter"),
        "joined": said("Links", context="by a pair"),
        "kind": said("Kind"),
        "kind R": said("turning"),
        "kind P": said("sliding"),
        "contact": said("Contact"),
        "lower": said("lower", context="pair"),
        "freedoms": said("Class, freedoms"),
        "one freedom": said("5, one"),
        "kind K": said("wheels in mesh"),
        "higher": said("higher", context="pair"),
        "two freedoms": said("4, two"),
        "kind belt": said("open belt", context="pair"),
        "kind crossed belt": said("crossed belt", context="pair"),
        "kind chain": said("chain", context="pair"),
        "flexible": said("as a higher one", context="pair"),
        "K index": said("K", context="pair"),
        "F index": said("F", context="pair"),
        "index": said("Index"),
        "R index": said("R"),
        "P index": said("P", context="pair"),
        "formula": said("Formula of structure"),
        "class of group": said("Group {name}, class {numeral}"),
        "wheel": said("Group {name}: one link, a lower and a higher pair"),
        "class of wheel": said("Wheel {name} with its higher pair"),
        "belted wheel": said(
            "Group {name}: one link, a lower pair and a flexible link, which counts as a higher one"
        ),
        "class of belted wheel": said("Wheel {name} with its flexible link"),
        "replacing": said("Replacing linkage"),
        "class of link": said("Driving link {name}, class I"),
        "class of rod": said("Rod in its cylinder {name}, class I"),
        "class IV": said("The mechanism is of class IV: that of its highest group"),
        "class III": said("The mechanism is of class III: that of its highest group"),
        "class II": said("The mechanism is of class II: that of its highest group"),
        "class I": said("The mechanism is of class I: it has no groups"),
    }
)


def link_rows(mechanism: Mechanism, structure: Structure, language: str) -> list[list[str]]:
    """Return a row a link, the frame last: its number, what it is, whether it moves."""
    words, frame = WORDS[language], mechanism.frame
    return [
        [
            str(link.number),
            link_name(mechanism, structure, link, language),
            words[_moves(mechanism, link)],
        ]
        for link in sorted((*mechanism.drawn, frame), key=lambda link: (link is frame, link.number))
    ]


def _moves(mechanism: Mechanism, link: Link) -> str:
    """Return whether a link moves, and counts (a key of WORDS)."""
    if link is mechanism.frame:
        return "fixed"
    return "passive" if link in mechanism.passive else "movable"


def link_table(mechanism: Mechanism, structure: Structure, language: str, high: Heights) -> Drawing:
    """Return the table of links."""
    words, found = WORDS[language], link_rows(mechanism, structure, language)
    rows = [[number, escape(name), moves] for number, name, moves in found]
    heads = [words[head] for head in LINK_HEADS]
    return _table("links", heads, rows, language, high, align=["centre", "left", "left"])


LINK_HEADS = ("number", "link", "mobility")
PAIR_HEADS = ("letter", "joined", "kind", "contact", "freedoms", "index")
"""What the columns of both tables are called, in `WORDS`."""


def pair_rows(mechanism: Mechanism, structure: Structure, language: str) -> list[list[str]]:
    """Return a row a pair; its letter, which is first, and its index, which is last, as mark-up."""
    words = WORDS[language]
    rows = []
    for pair in structure.pairs:
        name = pair_name(pair, mechanism)
        joined = ",".join(str(k) for k in sorted(pair.links))
        index = _index(pair, mechanism, words)
        kind = words[f"kind {pair.kind}"]
        rows.append([escape(name), joined, kind, words["lower"], words["one freedom"], index])
    for one in structure.wheels:
        pair = one.pair
        joined = ",".join(map(str, pair.links))
        kind, contact = (one.mesh.by, "flexible") if one.mesh.belted else ("K", "higher")
        cells = words[f"kind {kind}"], words[contact], words["two freedoms"]
        rows.append([escape(pair.name), joined, *cells, _index(pair, mechanism, words)])
    return rows


def pair_table(mechanism: Mechanism, structure: Structure, language: str, high: Heights) -> Drawing:
    """Return the table of kinematic pairs."""
    rows = pair_rows(mechanism, structure, language)
    heads = [WORDS[language][head] for head in PAIR_HEADS]
    return _table("pairs", heads, rows, language, high)


def _table(
    name: str,
    heads: Sequence[str],
    rows: Sequence[Sequence[str]],
    language: str,
    high: Heights,
    align: Sequence[str] | None = None,
) -> Drawing:
    """Return a table of structure under the word for what it lists."""
    return breakable(
        f"table-{name}",
        WORDS[language][name],
        heads,
        rows,
        again=captions(language)["continued"],
        size=high.number,
        title_size=high.title,
        align=align,
    )


PASSIVE = said(
    "Link {link} is passive: with its pairs {pairs} W would be {sum} = {w}, so they are left out"
)
"""What stands below the table of pairs, and in a note, on a passive link."""


def aside_lines(mechanism: Mechanism, structure: Structure, language: str) -> list[str]:
    """Return a line on each arm that is welded to a link, and on each passive link, as mark-up."""
    words, _, found = WORDS[language], speaking(language), list[str]()
    for link in mechanism.links:
        for arm in link.arms[1:]:
            found.append(_(WELDED, link=link.number, arm=arm.number, letter=arm.at))
    for hold in holds(mechanism):
        n, p = structure.moving + 1, len(structure.pairs) + len(hold.pairs)
        pairs = ", ".join(_index(pair, mechanism, words) for pair in hold.pairs)
        w = f"{3 * n - 2 * p - len(structure.wheels)}".replace("-", "−")
        total = freedoms(n, p, len(structure.wheels))
        found.append(_(PASSIVE, link=hold.link.number, pairs=pairs, sum=total, w=w))
    return found


def _index(pair: Pair, mechanism: Mechanism, words: Mapping[str, str]) -> str:
    """Return the index of a pair as mark-up: R_{A}(1,2)."""
    joined = ",".join(str(k) for k in sorted(pair.links))
    return f"{words[pair.kind + ' index']}_{{{escape(pair_name(pair, mechanism))}}}({joined})"


def _group(one: AssurGroup | Rolling, language: str) -> str:
    """Return what a group is, or a wheel: its class, order and kind."""
    if isinstance(one, Rolling):
        kind = "belted wheel" if one.mesh.belted else "wheel"
        return WORDS[language][kind].format(name=one.name)
    return speaking(language)(one.described)


OTHERWISE = said("Driven by link {link}, it is of class {numeral}: {formula}")
"""What stands below the table of pairs, and in a note, on a mechanism of a higher class than II."""


def otherwise_lines(mechanism: Mechanism, structure: Structure, language: str) -> list[str]:
    """Return a line on each other link that drives a mechanism of class III or IV as one of a lower class."""
    if structure.numeral in CLASSES[:2]:
        return []
    return [
        speaking(language)(OTHERWISE, link=one.first.link, numeral=one.numeral, formula=one.formula)
        for one in driven_otherwise(mechanism)
        if one.rank < structure.rank
    ]


def structure_lines(mechanism: Mechanism, structure: Structure, language: str) -> tuple[str, ...]:
    """Return mobility, formula of structure, and the kind of each group, as lines of lettering."""
    words = WORDS[language]
    groups = [_group(one, language) for one in structure.attached]
    n, p, p4 = structure.moving, len(structure.pairs), len(structure.wheels)
    w = f"W = {freedoms(n, p, p4)} = {structure.mobility}"
    mobility = f"n = {n}, p_5 = {p}, p_4 = {p4}, {w}"
    highest = words[f"class {structure.numeral}"]
    beside = aside_lines(mechanism, structure, language)
    otherwise = otherwise_lines(mechanism, structure, language)
    formula = f"{words['formula']}: {structure.formula}"
    return (mobility, *beside, formula, *groups, highest, *otherwise)


PROTOCOL = Protocols(views=lambda project: {STRUCTURE: (STRUCTURE,)})


TABLE = Tabled(
    facts=lambda drawn: {
        "W": STRUCTURE_PLAN.on(drawn).mobility,
        "formula": STRUCTURE_PLAN.on(drawn).formula,
    }
)

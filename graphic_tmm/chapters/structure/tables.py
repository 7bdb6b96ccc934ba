"""The tables of structure: links, pairs; the lines below them: mobility, formula, groups, class."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.chapters.structure.roles import link_name, pair_name
from graphic_tmm.language.said import said
from graphic_tmm.language.tables import Tongues
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import Structure
from graphic_tmm.paper.blocks import breakable
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.lettering.heights import Heights
from graphic_tmm.paper.lettering.letters import (
    escape,
)
from graphic_tmm.scene.captions import captions

WORDS = Tongues(
    {
        "links": said("Links"),
        "pairs": said("Kinematic pairs"),
        "number": said("No."),
        "link": said("Link"),
        "mobility": said("Mobility"),
        "movable": said("movable"),
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
        "index": said("Index"),
        "R index": said("R"),
        "P index": said("P", context="pair"),
        "formula": said("Formula of structure"),
        "group": said("Group {name}: class II, order 2, kind {kind}"),
        "class of group": said("Group {name}, class II"),
        "class of link": said("Driving link {name}, class I"),
        "class II": said("The mechanism is of class II: that of its highest group"),
        "class I": said("The mechanism is of class I: it has no groups"),
    }
)


def link_table(mechanism: Mechanism, structure: Structure, language: str, high: Heights) -> Drawing:
    """Return the table of links."""
    words = WORDS[language]
    frame = mechanism.frame
    rows = [
        [
            str(link.number),
            escape(link_name(mechanism, structure, link, language)),
            words["fixed" if link is frame else "movable"],
        ]
        for link in sorted((*mechanism.links, frame), key=lambda link: (link is frame, link.number))
    ]
    heads = [words["number"], words["link"], words["mobility"]]
    return _table("links", heads, rows, language, high, align=["centre", "left", "left"])


def pair_table(mechanism: Mechanism, structure: Structure, language: str, high: Heights) -> Drawing:
    """Return the table of kinematic pairs."""
    words = WORDS[language]
    rows = []
    for pair in structure.pairs:
        name = pair_name(pair, mechanism)
        joined = ",".join(str(k) for k in sorted(pair.links))
        index = f"{words[pair.kind + ' index']}_{{{escape(name)}}}({joined})"
        kind = words[f"kind {pair.kind}"]
        rows.append([escape(name), joined, kind, words["lower"], words["one freedom"], index])
    heads = [words[head] for head in ("letter", "joined", "kind", "contact", "freedoms", "index")]
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


def structure_lines(structure: Structure, language: str) -> tuple[str, ...]:
    """Return mobility, formula of structure, and the kind of each group, as lines of lettering."""
    words = WORDS[language]
    groups = [words["group"].format(name=g.name, kind=g.kind) for g in structure.groups]
    n, p = structure.moving, len(structure.pairs)
    mobility = f"n = {n}, p_5 = {p}, p_4 = 0, W = 3·{n} − 2·{p} = {structure.mobility}"
    highest = words["class II" if structure.groups else "class I"]
    return (mobility, f"{words['formula']}: {structure.formula}", *groups, highest)

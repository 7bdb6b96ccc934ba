"""What a sheet shows of structure: the tables; the driving link and the groups by themselves."""

from __future__ import annotations

from graphic_tmm.chapters.kinematics.scales import reaches
from graphic_tmm.chapters.structure.ink_groups import draw_part
from graphic_tmm.chapters.structure.mobility import MOBILITY, parts
from graphic_tmm.chapters.structure.names import PARTS, VIEW
from graphic_tmm.chapters.structure.tables import WORDS, link_table, pair_table, structure_lines
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.numbers import number
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.finish import finished
from graphic_tmm.paper.lettering.heights import heights
from graphic_tmm.paper.views import captioned


def structure_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the table of links, and that of pairs with the formula of structure below it."""
    mechanism, language = drawn.scene.mechanism, drawn.scene.language
    assert mechanism is not None
    structure = dissect(mechanism)
    high = heights(drawn.scene, VIEW)
    pairs = pair_table(mechanism, structure, language, high)
    return [
        link_table(mechanism, structure, language, high),
        captioned(pairs, *structure_lines(structure, language), heights=high),
    ]


def part_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the driving link and every group, each with its mobility below it."""
    made = MOBILITY.of(drawn)
    if made is None or drawn.scene.mechanism is None:
        return []
    structure, high = dissect(drawn.scene.mechanism), heights(drawn.scene, PARTS)
    words, found = WORDS[drawn.scene.language], []
    groups = {group.name for group in structure.groups}
    for name, (n, p5) in parts(structure).items():
        links = [int(one) for one in name.split("-")]
        told = words["class of group" if name in groups else "class of link"].format(name=name)
        view = draw_part(
            drawn.construction,
            drawn.reading,
            reaches(drawn),
            links,
            drawn.main,
            f"part-{name}",
            told,
            high,
        )
        w = drawn.reading[made.parts[name]].item()
        line = f"W = 3·{n} − 2·{p5} = {number(w, drawn.scene.language)}"
        found.append(captioned(finished(view, lettered), told, line, heights=high))
    return found


SHOWN = Views(draw={"structure": structure_views, PARTS: part_views})

"""Structure: links, pairs, mobility by Chebyshev, the formula of structure by Assur groups.

A plane mechanism of n moving links with p₅ pairs of one freedom and p₄ of two has the mobility W = 3n − 2p₅
− p₄: three freedoms a link, less what the pairs take away. Here all pairs are turning or sliding (p₄ = 0),
but for wheels on links: a mesh is a pair of two freedoms, and a belt or a chain counts as one. A letter that
k links share is k − 1 turning pairs.

The argument of Assur: take off the frame and the driving link, which alone has W = 1. What is left has to
add no freedom, so it comes apart into groups of 3n = 2p₅, the smallest of which are two links with three
pairs, the dyads (class II). By which of these pairs slide there are five kinds:

    1  RRR    2  RRP (a slider)    3  RPR (a stone on a rocker)    4  PRP    5  RPP

A group is attached to links that stand already, so groups have an order, I(1) → II(2-3) → II(4-5).
Kinematics goes along it, since each group moves as those before it tell it to; forces go against it, since
the last group is loaded by nothing that comes after. The order of links in the scene changes nothing: of
the groups that could come next, the one with the smallest numbers comes first.

The class depends on the driving link: below a mechanism of class III or IV stand the other links on the frame
that would drive it as one of a lower class, each with the formula of structure then.

A passive link (the third of parallel cranks, a second stone) doubles what others hold already: with its pairs W
would be 0, so it is left out and told; it is drawn where its letters on other links stand. Links welded to
each other are one link, told as its arms.

Draws: the tables of links and of pairs, with W, the formula and the kind of each group below (place
``structure``); the driving link and each group by itself, as it stands in the main position (place ``groups
of structure``); the linkage with a link and two turning pairs for each mesh or belt, and the groups that this
makes (place ``replacing linkage``). Its steps are calculations beside the plans: W of the mechanism and, as a
check, of each part. The dissection itself is `graphic_tmm.mechanism.structure`, for every plan needs it.
Builds on kinematics, whose links it shows.

Sources: Ассур Л. В., Исследование плоских стержневых механизмов; Артоболевский И. И., Теория механизмов и
машин (структура и классификация механизмов); as worked in the course project of the windrower (scene
``windrower``).
"""

from __future__ import annotations

from graphic_tmm.language.said import said
from graphic_tmm.scene.chapter import Chapter, Place

STRUCTURE = "structure"
"""The chapter, its view, its place."""
PARTS = "groups of structure"
"""The place of the parts by themselves."""
REPLACING = "replacing linkage"
"""The place of the linkage that moves as the mechanism with its higher pairs does."""
_TABLES = said(
    "The structure is analysed: links and pairs, mobility, Assur groups, formula of structure, "
    "class of the mechanism."
)
_PARTS = said("The driving link and each Assur group are drawn by themselves.")
_REPLACING = said(
    "Wheels are replaced by links with turning pairs; the linkage and its groups are drawn."
)

CHAPTER = Chapter(
    name=STRUCTURE,
    number=1,
    builds_on=("kinematics",),
    places=(
        Place(STRUCTURE, 90, asks=(_TABLES,)),
        Place(PARTS, asks=(_PARTS,)),
        Place(REPLACING, asks=(_REPLACING,)),
    ),
    always=True,
)

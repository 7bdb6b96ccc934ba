"""How large what is drawn may be: sizes by name, and on which of them the views of a place depend."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar

from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.formats import narrowest
from graphic_tmm.scene.chapter import Answer, Chapter, chapters, places
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.tasks import calls_for

Sizes = Mapping[str, float]
"""How large what is drawn may be, by the names that chapters give to sizes."""


@dataclass(frozen=True)
class Size:
    """How large something is drawn, by a name.

    ``natural``: the most that the longest of it takes ``in_mm`` on an A1 (on other formats in proportion to
    their room), or a share (1) of its usual room. ``low``, ``high``: shares of that to which it gives way, or
    grows, for the sake of its sheet; ``least``: to which it is made smaller where else no sheet holds a view.
    ``first``: whether it gives way before others do. ``plan``: whether it sets the μ of a plan; ``extent``:
    what there is to draw of that, SI, of a board's reach. ``fixed``: the key by which a scene itself says how
    large it is, "" if it does not; ``freed``: the scene without saying so; ``remedy``: of a drawing made with
    a free size, what to write for the key. ``keys``: those of [scales] of which one fixes it.
    """

    name: str
    natural: float = 1.0
    in_mm: bool = False
    low: float = 0.5
    high: float = 1.7
    least: float = 0.0
    first: bool = False
    plan: bool = False
    extent: Callable[[Mapping[str, Any]], float] = lambda reach: 0.0
    fixed: Callable[[Scene], str] = lambda scene: ""
    freed: Callable[[Scene], Scene] = lambda scene: scene
    remedy: Callable[[Drawn, str], str] = lambda drawn, key: ""
    keys: tuple[str, ...] = ()


@dataclass(frozen=True)
class Sizing(Answer):
    """How large a chapter is drawn.

    ``sizes``: by which that is told; ``graphs``: that of its graphs. ``depends``: by place, the role of a view
    -> the sizes on which it depends, in the order in which they give way.
    """

    stands: ClassVar[str] = "scales.SIZES"
    sizes: tuple[Size, ...] = ()
    graphs: str = ""
    depends: Mapping[str, Callable[[Scene, str], tuple[str, ...]]] = field(default_factory=dict)


GRAPHS = "graphs"
"""Under which is kept what graphs on axes go by, of whatever chapter."""


def graph_size(chapter: str) -> Size:
    """Return the size of a chapter's graphs, a share of their usual base and height."""
    return Size(f"{chapter} {GRAPHS}", high=1.4, least=0.2, first=True)


def all_sizes(scene: Scene | None = None) -> dict[str, Size]:
    """Return the sizes of the chapters that a scene calls for, by name; without one those of all chapters."""
    there = chapters() if scene is None else _called(scene)
    return {size.name: size for one in there for size in Sizing.of(one).sizes}


def sizes_of(place: str, role: str, scene: Scene) -> tuple[str, ...]:
    """Return the sizes on which views of a place and a role depend, in the order in which they give way."""
    depends = Sizing.of(places()[place][0]).depends.get(place)
    return depends(scene, role) if depends is not None else ()


def usual(scene: Scene) -> dict[str, float]:
    """Return the usual, natural sizes: on the narrowest format of the sheets that show something of each."""
    found = dict[str, float]()
    for chapter in _called(scene):
        sizing = Sizing.of(chapter)
        for size in sizing.sizes:
            own = {place for place, on in sizing.depends.items() if size.name in on(scene, "")}
            own = own or set(sizing.depends)
            formats = [order.format for order in scene.sheets if own & set(order.place)]
            formats = formats or [order.format for order in scene.sheets]
            found[size.name] = size.natural * (narrowest(formats).share if size.in_mm else 1.0)
    return found


def _called(scene: Scene) -> list[Chapter]:
    """Return the chapters that a scene calls for, and those they build on: no other is imported."""
    there = {one.name: one for one in chapters()}
    found = [name for name, one in there.items() if calls_for(scene, one)]
    for name in found:
        found += [more for more in there[name].builds_on if more in there and more not in found]
    return [one for name, one in there.items() if name in found]

"""How large what is drawn may be: sizes by name, and on which of them the views of a place depend."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, ClassVar

from graphic_tmm.drawn import Drawn
from graphic_tmm.scene.chapter import Answer, chapters, places
from graphic_tmm.scene.records import Scene

Sizes = Mapping[str, float]
"""How large what is drawn may be, by the names that chapters give to sizes."""


@dataclass(frozen=True)
class Size:
    """How large something is drawn, by a name.

    ``usual``: room for it ``in_mm``, which sets the μ of a plan, or a share (1) of its usual room; what the
    formats of a scene's sheets suggest; ``small``: less, from where it may begin; ``unseen``: where no sheet
    shows it. ``least``: where this is reached, something else has to give way. ``cap``: what share of a sheet's
    height its views grow to, as far as the sheets have room; 0: it does not grow; ``step``: by how much at
    least at a time. ``seen``: whether what comes of it is seen in scale factors. ``extent``: what there is to
    draw, SI, of a board's reach. ``fixed``: the key by which a scene itself says how large it is, "" if it
    does not; ``freed``: the scene without saying so; ``remedy``: of a drawing made with a free size, what to
    write for the key. ``keys``: those of [scales] of which one fixes it.
    """

    name: str
    usual: Callable[[Scene], float] = lambda scene: 1.0
    in_mm: bool = False
    least: float = 0.0
    small: float = 0.0
    unseen: float = 0.0
    cap: float = 0.0
    step: float = 1.1
    seen: bool = True
    extent: Callable[[Mapping[str, Any]], float] = lambda reach: 0.0
    fixed: Callable[[Scene], str] = lambda scene: ""
    freed: Callable[[Scene], Scene] = lambda scene: scene
    remedy: Callable[[Drawn, str], str] = lambda drawn, key: ""
    keys: tuple[str, ...] = ()


@dataclass(frozen=True)
class Sizing(Answer):
    """How large a chapter is drawn.

    ``sizes``: by which that is told. ``depends``: by place, the role of a view -> the sizes on which it
    depends, in the order in which they give way.
    """

    stands: ClassVar[str] = "scales.SIZES"
    sizes: tuple[Size, ...] = ()
    depends: Mapping[str, Callable[[Scene, str], tuple[str, ...]]] = field(default_factory=dict)


GRAPHS = "graphs"
"""Graphs on axes, of whatever chapter."""
GRAPH = Size(GRAPHS, least=0.2, small=0.7, cap=0.94, step=1.4)
"""How large they are drawn: each chapter that has some lists it among its sizes."""


def all_sizes() -> dict[str, Size]:
    """Return the sizes of all chapters, by name."""
    return {size.name: size for one in chapters() for size in Sizing.of(one).sizes}


def sizes_of(place: str, role: str, scene: Scene) -> tuple[str, ...]:
    """Return the sizes on which views of a place and a role depend, in the order in which they give way."""
    depends = Sizing.of(places()[place][0]).depends.get(place)
    return depends(scene, role) if depends is not None else ()


def usual(scene: Scene) -> dict[str, float]:
    """Return the usual sizes, which the formats of a scene's sheets suggest."""
    return {name: size.usual(scene) for name, size in all_sizes().items()}

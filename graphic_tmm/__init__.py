"""The drawing board of the theory of machines and mechanisms: plans as recorded constructions."""

from __future__ import annotations

from importlib import import_module
from typing import Any

_HOMES = {
    "Drawn": "drawn",
    "Scene": "scene.records",
    "SceneError": "errors",
    "SheetError": "errors",
    "StructureError": "errors",
    "TmmError": "errors",
    "dissect": "mechanism.structure",
    "fitted": "fitting.fit",
    "motion": "chapters.kinematics.any_angles",
    "read": "scene.read",
    "sheets": "studio",
    "svg": "paper.write.svg",
}
__all__ = [
    "Drawn",
    "Scene",
    "SceneError",
    "SheetError",
    "StructureError",
    "TmmError",
    "dissect",
    "fitted",
    "motion",
    "read",
    "sheets",
    "svg",
]


def __getattr__(name: str) -> Any:
    """Import a public name when it is first asked for, so that the package itself is light."""
    if name not in _HOMES:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    return getattr(import_module(f"{__name__}.{_HOMES[name]}"), name)

"""The name of a scene, by where it was read."""

from __future__ import annotations

from pathlib import Path

from graphic_tmm.files import STANDARD_INPUT


def scene_name(source: str) -> str:
    """Return the name that a scene's sheets bear: that of its folder, or of its file."""
    if source == str(STANDARD_INPUT):
        return "scene"
    path = Path(source).resolve()
    return path.parent.name if path.name == "scene.toml" else path.stem

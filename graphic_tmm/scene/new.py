"""A scene to begin with: the copy of another one, with the schema that editors read beside it."""

from __future__ import annotations

import json
import re

from graphic_tmm.scene.letters import POLES
from graphic_tmm.scene.read import FILE
from graphic_tmm.scene.schema import schema

SCHEMA = "scene.schema.json"
KEPT = f"# The letters {', '.join(POLES)} are kept for the poles of plans: call a point K, or P1.\n"
_HEAD = re.compile(rf"^#:schema .*\n(?:{re.escape(KEPT)})?", re.MULTILINE)


def begun(text: str) -> dict[str, str]:
    """Return the files of a new scene by name.

    ``text``: of the scene that is copied; the line that leads editors to the schema leads to the folder's own.
    """
    return {FILE: f"#:schema {SCHEMA}\n{KEPT}{_HEAD.sub('', text)}", SCHEMA: schema_text()}


def schema_text() -> str:
    """Return the JSON Schema of scenes as it is printed and shipped."""
    return json.dumps(schema(), ensure_ascii=False, indent=2) + "\n"

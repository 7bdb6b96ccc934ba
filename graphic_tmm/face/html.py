"""What a notebook shows of tables and protocols; all text in it is escaped."""

from __future__ import annotations

import base64
from collections.abc import Sequence
from functools import cache
from typing import TYPE_CHECKING, Any

from graphic_tmm.files import environment

if TYPE_CHECKING:
    from jinja2 import Environment


@cache
def _environment() -> Environment:
    return environment("graphic_tmm.face")


def rendered(template: str, **values: Any) -> str:
    """Return a template of the face with values put in."""
    return _environment().get_template(template).render(**values)


def grid(title: str, rows: Sequence[Sequence[str]], left: int = 2) -> str:
    """Return rows of cells as a table of HTML, heads first; the first ``left`` columns stand to the left."""
    return rendered("grid.html", title=title, rows=rows, left=left)


def pictured(svg: str, title: str) -> str:
    """Return a picture as large as it is on paper, but no wider than where it is shown.

    Within an image its styles and names are its own: two pictures on a page do not meddle with one another.
    """
    return rendered("picture.html", data=base64.b64encode(svg.encode()).decode(), title=title)

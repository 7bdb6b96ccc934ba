"""Reports as their templates render them."""

from __future__ import annotations

from functools import cache, partial
from typing import TYPE_CHECKING, Any

from graphic_tmm.files import environment

if TYPE_CHECKING:
    from jinja2 import Environment
    from markupsafe import Markup


def render(template: str, **values: Any) -> Markup:
    """Return a template of the folder ``templates`` with values put in; it may be put into another as it is."""
    from markupsafe import Markup

    return Markup(_environment().get_template(template).render(values))


@cache
def _environment() -> Environment:
    """Return the templates of reports, with what they write figures and rows by."""
    made = environment("graphic_tmm.checking.report")
    made.filters |= {"mm": "{:.2f}".format, "zip": partial(zip, strict=True)}
    return made

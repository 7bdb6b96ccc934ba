"""Texts that remember what they were made of, so that they can still be said in another language.

A message is often written before anybody knows who will read it: an error of a file, a warning, a finding. It
is then English, as every string of the package, and remembers its template and the values that were put in;
`catalogue.Speech` says it in the reader's language, what is nested in it too.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any


class Said(str):
    """An English text with its template, its template for several, its context and its values."""

    __slots__ = ("context", "plural", "template", "values")
    template: str
    plural: str
    context: str
    values: Mapping[str, Any]

    def __new__(
        cls,
        template: str,
        plural: str = "",
        context: str = "",
        values: Mapping[str, Any] | None = None,
    ) -> Said:
        """Put the values into the template; one without values stays as it is, with its braces."""
        values = values or {}
        one = not plural or values.get("n") == 1
        text = template if one else plural
        made = super().__new__(cls, text.format(**values) if values else text)
        made.template, made.plural, made.context, made.values = template, plural, context, values
        return made

    def __getnewargs__(self) -> tuple[Any, ...]:
        """Return its template and values, for copies and other processes."""
        return self.template, self.plural, self.context, self.values


def said(template: str, plural: str = "", /, *, context: str = "", **values: Any) -> Said:
    """Return a text that can be said in any language; without values it is a word or a template for later.

    ``plural``: the template where the value ``n`` is not 1. ``context``: tells apart what English calls by one
    word and another language by two.

    >>> said("{n} sheet", "{n} sheets", n=2), said("no {what}", what=said("scene"))
    ('2 sheets', 'no scene')
    """
    return Said(template, plural, context, values)


def joined(separator: str, parts: Iterable[str]) -> Said:
    """Return texts one after another, each of which can be said in another language, as can the separator.

    >>> joined("; ", ["a", said("b")]), joined(said(" or "), "xyz")
    ('a; b', 'x or y or z')
    """
    parts = tuple(parts)
    template = "{s}".join(f"{{p{k}}}" for k in range(len(parts)))
    return Said(template, "", "", {"s": separator, **{f"p{k}": p for k, p in enumerate(parts)}})

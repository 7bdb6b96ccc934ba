"""Whether weights and inertia act: asked beside the masses, and so from the first mass that is given there."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from graphic_tmm.language.said import Said, said
from graphic_tmm.scene.document import Document, as_table
from graphic_tmm.serve.form import Field

FORCES, EFFECTS = "forces", "effects"
SWITCHES: dict[str, Said] = {
    "effects.gravity": said("weights of the links act"),
    "effects.inertia": said("inertia of the links acts"),
}
"""The keys of the choice, and what it is called."""


def weighs(doc: Document) -> bool:
    """Whether a scene gives a mass."""
    return any("mass" in as_table(one) for one in doc.get("link", ()))


def effects_on(doc: Document) -> Mapping[str, str]:
    """Return the values by which weights and inertia act; none where a scene says itself what does."""
    return {} if EFFECTS in doc else dict.fromkeys(SWITCHES, "true")


def effect_fields(fields: list[Field], doc: Document) -> Iterator[tuple[Field, Said]]:
    """Yield the choice, and what it is called, where there is something that may act."""
    if weighs(doc) or FORCES in doc:
        yield from ((one, SWITCHES[one.key]) for one in fields if one.key in SWITCHES)

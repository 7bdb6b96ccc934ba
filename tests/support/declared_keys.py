"""Every key of every section of a scene, those of the tables in them too."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.scene import keys
from graphic_tmm.scene.declare import Key, keys_of
from graphic_tmm.scene.drawing import Head
from graphic_tmm.scene.sections import declared


def _keys(record: type, at: str) -> Iterator[tuple[str, Key]]:
    """Yield the keys of a section, and those of the tables in it."""
    others = getattr(record, "OTHERS", None)
    inner = list(keys.inner_tables(others)) if others is not None else []
    for name, one in keys_of(record).items():
        yield f"{at}.{name}", one
        inner += keys.inner_tables(one.kind)
    for table in inner:
        yield from _keys(table, f"{at}.{table.__name__}")


ALL = [
    *_keys(Head, ""),
    *(one for section in declared().values() for one in _keys(section.record, section.name)),
]

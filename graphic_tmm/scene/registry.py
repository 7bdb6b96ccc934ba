"""The sections that the chapters of the book declare: what scenes may ask for."""

from __future__ import annotations

from functools import cache
from importlib import import_module
from importlib.util import find_spec
from pkgutil import iter_modules

from graphic_tmm.scene.declare import Section


@cache
def sections() -> tuple[Section, ...]:
    """Return the sections of all chapters, in their order."""
    book = import_module("graphic_tmm.chapters")
    rooms = [f"{book.__name__}.{room.name}" for room in iter_modules(book.__path__)]
    files = [f"{room}.{name}" for room in rooms for name in ("sections", "task")]
    modules = [import_module(file) for file in files if find_spec(file)]
    found = [section for module in modules for section in getattr(module, "SECTIONS", ())]
    return tuple(sorted(found, key=lambda section: section.number))


def named(name: str) -> Section | None:
    """Return a section by its name; None if no chapter declares it."""
    return next((section for section in sections() if section.name == name), None)

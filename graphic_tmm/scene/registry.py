"""The sections that the chapters of the book declare: what scenes may ask for."""

from __future__ import annotations

from graphic_tmm.scene.chapter import chapters
from graphic_tmm.scene.declare import Section, keys_of


def sections() -> tuple[Section, ...]:
    """Return the sections of all chapters, in their order."""
    return tuple(section for chapter in chapters() for section in chapter.sections)


def named(name: str) -> Section | None:
    """Return a section by its name; None if no chapter declares it."""
    return next((section for section in sections() if section.name == name), None)


def size_keys() -> tuple[str, ...]:
    """Return the keys of chapters that fix how large something is drawn, as section.key."""
    return tuple(
        f"{section.name}.{name}"
        for section in sections()
        for name, declared in keys_of(section.record).items()
        if declared.fixes == "size"
    )

"""What a scene asks chapters for: by the key of a section, and whether it asks for a chapter at all."""

from __future__ import annotations

from dataclasses import dataclass
from typing import TYPE_CHECKING, Generic, TypeVar

if TYPE_CHECKING:
    from graphic_tmm.scene.chapter import Chapter
    from graphic_tmm.scene.records import Scene

T = TypeVar("T")


@dataclass(frozen=True)
class SectionKey(Generic[T]):
    """The name of a section of a scene, by which what it asks for is got."""

    section: str

    def of(self, scene: Scene) -> T | None:
        """Return what the scene asks for; None if it has no such section."""
        task: T | None = scene.tasks.get(self.section)
        return task

    def put(self, scene: Scene, task: T | None) -> Scene:
        """Return the scene asking for ``task`` instead; None: not asking."""
        return scene.asking(**{self.section: task})


def calls_for(scene: Scene, chapter: Chapter) -> bool:
    """Whether a scene calls for a chapter."""
    if chapter.always:
        return scene.mechanism is not None
    section = chapter.asking
    return section is not None and scene.tasks.get(section.name) is not None

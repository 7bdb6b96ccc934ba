"""What the views of a recorded project are called."""

from __future__ import annotations

from graphic_tmm.captions import view_name
from graphic_tmm.project import Project


def title_of(project: Project, view: str, language: str) -> str:
    """Return what a view is called, as plain text; a chapter may tell more of it by what was made."""
    titles = (one.titles(project, view, language) for one in project.chapters)
    return next((title for title in titles if title), "") or view_name(view, language)

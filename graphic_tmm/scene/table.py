"""What every table of a scene file has in common."""

from __future__ import annotations

from typing import Any

from pydantic import BaseModel, ConfigDict, Field


class Table(BaseModel):
    """A table of the file: a key that it does not know is a fault."""

    model_config = ConfigDict(defer_build=True, extra="forbid")


def key(says: str, example: Any = None, default: Any = ...) -> Any:
    """Return a key's field: what it says, an example, its default."""
    return Field(default, description=says, examples=None if example is None else [example])

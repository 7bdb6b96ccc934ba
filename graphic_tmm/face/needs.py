"""Packages that only some of the verbs need, and nobody else."""

from __future__ import annotations

from importlib import import_module
from typing import Any

from graphic_tmm.errors import MissingError
from graphic_tmm.language.said import said


def needed(module: str, package: str) -> Any:
    """Return a module that may be missing.

    Raises
    ------
    MissingError
        If it is: how its package is installed.
    """
    try:
        return import_module(module)
    except ImportError as error:
        says = said("this needs the package {package}: pip install {package}", package=package)
        raise MissingError(says) from error

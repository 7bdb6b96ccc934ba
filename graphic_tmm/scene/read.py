"""Read a scene file: every fault at once, each with its key, its line and the remedy."""

from __future__ import annotations

import re
import tomllib
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path
from typing import NoReturn

from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.scene import build, checks, force_checks, order_checks, references
from graphic_tmm.scene.faults import fault
from graphic_tmm.scene.lines import locate
from graphic_tmm.scene.quantities import in_kgf
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.remarks import remarks
from graphic_tmm.scene.sections import Document, understand
from graphic_tmm.scene.syntax import syntax_fault

FILE = "scene.toml"
LARGEST_FILE = 4_000_000


def read(path: Path, *, missing: Callable[[str], str] = lambda text: "") -> Scene:
    """Read the scene of a file, or of a folder that holds a ``scene.toml``.

    Parameters
    ----------
    path : Path
        The file or the folder.
    missing : callable
        text -> those of its characters that cannot be lettered; none by default.

    Returns
    -------
    Scene
        In SI units; angles in degrees.

    Raises
    ------
    SceneError
        With every fault of the file.
    """
    file = path / FILE if path.is_dir() else path
    text = _text(file)
    doc = _document(file, text)
    parts, found = understand(doc)
    found.extend(references.check(doc, missing))
    found.extend(checks.check(parts))
    found.extend(order_checks.check(doc, parts))
    found.extend(force_checks.check(doc, parts))
    if found:
        lines = locate(text)
        faults = {fault(doc, lines, item) for item in found}
        raise SceneError(str(file), tuple(sorted(faults, key=lambda f: (f.line, f.key, f.message))))
    made = build.scene(parts, str(file), kgf=in_kgf(doc))
    return replace(made, remarks=remarks(doc, parts), told=_told(doc))


def _told(doc: Document) -> frozenset[str]:
    """Return the keys of the file's sections that are tables, as section.key."""
    tables = {name: section for name, section in doc.items() if isinstance(section, dict)}
    return frozenset(f"{name}.{key}" for name, section in tables.items() for key in section)


def _text(file: Path) -> str:
    try:
        data = file.read_bytes()
    except FileNotFoundError:
        _refuse(file, "there is no such file; name a scene file, or a folder with a scene.toml")
    except IsADirectoryError:
        _refuse(file, "this is a folder; a scene is a file")
    except (OSError, ValueError) as error:
        _refuse(
            file, f"the file cannot be read ({type(error).__name__}); check its name and rights"
        )
    if len(data) > LARGEST_FILE:
        _refuse(file, f"the file has {len(data)} bytes; a scene is a short text")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        _refuse(file, "the file is not in UTF-8; save it with the encoding UTF-8", line)


def _document(file: Path, text: str) -> Document:
    try:
        return tomllib.loads(text)
    except tomllib.TOMLDecodeError as error:
        raise SceneError(str(file), (syntax_fault(text, str(error)),)) from None
    except RecursionError:
        _refuse(file, "lists or tables are nested too deep; a scene needs three levels at most")
    except ValueError as error:
        _refuse(file, f"a value cannot be read: {re.sub(r'[;,].*', '', str(error))}")


def _refuse(file: Path, message: str, line: int = 0) -> NoReturn:
    raise SceneError(str(file), (Fault("", line, message),)) from None

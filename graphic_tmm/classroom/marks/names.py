"""Who hands in what: hand-ins of a folder, named by variant and student, and what is none.

A file is a hand-in, or all files of a folder below. A name tells its variant by a part of its own, between
signs that are no letters or digits: ``07.csv``, ``Иванов-07.csv``, ``07 Иванов.xlsx``; zeros before a number do
not count. A photograph may end with the number of its sheet, ``ivanov_07_1.jpg``. What names no variant of
the table, or two, is nobody's.
"""

from __future__ import annotations

import os
import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from graphic_tmm.classroom.variants.table import folded
from graphic_tmm.errors import SheetError, printable, reason_of
from graphic_tmm.language.said import joined, said

TABLES = (".csv", ".tsv", ".txt", ".xlsx")
PHOTOGRAPHS = (".jpg", ".jpeg", ".png")
MOST = 5_000
"""A folder has no more files."""
LONGEST = 80
"""Of a name so many characters are kept in the names of files."""
_UNSEEN = ("thumbs.db", "desktop.ini", "__macosx")
_SHEET = re.compile(r"(?P<name>.*\S)[\s_-]+(?:[^\W\d_]{3,6}[\s_-]*)?(?P<sheet>[1-9])\)?")
_LAST = re.compile(r"(?:.*\D)?([1-9])")
_LINK = said("a link: what it leads to is not of this folder; put the file itself there")
_STRANGE = re.compile(r"[\x00-\x1f\x7f-\x9f/\\:*?\"<>|\ud800-\udfff]")


class HandIn(NamedTuple):
    """What a student hands in.

    ``name``: of the file (without its ending) or the folder, by which the row is known; ``student``: what it
    tells besides the variant; ``variant``: "" where there is none; ``tables``, ``photographs``: files, these
    with the number of the sheet (0 if not told); ``file``: a name by which files can be called.
    """

    name: str
    student: str
    variant: str
    tables: tuple[Path, ...]
    photographs: tuple[tuple[Path, int], ...]
    file: str = ""


class Skipped(NamedTuple):
    """A file, or a hand-in, that is not judged, and why."""

    name: str
    why: str


def hand_ins(
    folder: Path, variants: Sequence[str] | None = None
) -> tuple[tuple[HandIn, ...], tuple[Skipped, ...]]:
    """Return the hand-ins of a folder by their names, and what is none; ``variants``: the known ones.

    Raises
    ------
    SheetError
        If there is no such folder, it cannot be looked into, or has too many files.
    """
    known = None if variants is None else _known(variants)
    groups: dict[tuple[str, str], list[_File]] = {}
    skipped: list[Skipped] = []
    for path in _files(folder):
        inside = path.relative_to(folder)
        named = Skipped(inside.as_posix(), _LINK) if path.is_symlink() else _named(inside, known)
        if isinstance(named, Skipped):
            skipped.append(named)
        else:
            groups.setdefault(named.whose, []).append(named._replace(path=path))
    made = [_hand_in(group) for _, group in sorted(groups.items())]
    names = Counter(one.name for one in made)
    for one in made:
        if names[one.name] > 1:
            says = said("the files in it name more than one variant; leave those of one")
            skipped.append(Skipped(one.name, says))
    found = _called([one for one in made if names[one.name] == 1])
    return tuple(found), tuple(sorted(set(skipped)))


class _File(NamedTuple):
    """A file as its name tells of it; ``whose``: by what files of one hand-in belong together."""

    path: Path
    name: str
    student: str
    variant: str
    sheet: int
    whose: tuple[str, str]


def _files(folder: Path) -> Iterator[Path]:
    """Yield the files of a folder and of those in it, in a fixed order, but what nobody has put there."""
    if not folder.is_dir():
        says = said(
            "--class: {folder}: this is no folder; name the one that holds what was handed in",
            folder=printable(str(folder)),
        )
        raise SheetError(says)
    count = 0
    for path in _listed(folder):
        for file in _listed(path) if path.is_dir() and not path.is_symlink() else (path,):
            count += 1
            if count > MOST:
                says = said(
                    "--class: {folder}: more than {most} files; name the folder of one class",
                    folder=printable(str(folder)),
                    most=MOST,
                )
                raise SheetError(says)
            yield file


def _listed(folder: Path) -> list[Path]:
    try:
        found = [folder / name for name in os.listdir(folder)]
    except OSError as error:
        says = said(
            "--class: {folder}: {reason}; check its rights",
            folder=printable(str(folder)),
            reason=reason_of(error),
        )
        raise SheetError(says) from error
    seen = (one for one in found if not _is_aside(one.name))
    return sorted(seen, key=lambda one: (folded(one.name), one.name))


def _is_aside(name: str) -> bool:
    """Whether a file is not a student's: hidden, or left by a spreadsheet or a system."""
    return name.startswith((".", "~$")) or name.casefold() in _UNSEEN


def _named(place: Path, known: Mapping[str, str] | None) -> _File | Skipped:
    """Return what the name of a file tells; Skipped if it is none of a hand-in."""
    ending, shown = place.suffix.lower(), place.as_posix()
    if ending not in (*TABLES, *PHOTOGRAPHS):
        says = said("neither readings (CSV, xlsx) nor a photograph (JPEG, PNG)")
        return Skipped(shown, says)
    photograph, inner = ending in PHOTOGRAPHS, len(place.parts) > 1
    name = place.parts[0] if inner else place.stem
    if known is None:
        whole, sheet = _sheet(place.stem if inner else name, None) if photograph else (name, 0)
        name = name if inner else whole
        sheet = sheet or (_last(place.stem) if inner and photograph else 0)
        return _File(place, name, name, "", sheet, (folded(name), ""))
    stem, sheet = _sheet(place.stem, known) if photograph else (place.stem, 0)
    if inner and photograph and (_in(name, known) or not (sheet or _is_variant(stem, known))):
        stem, sheet = "", _last(place.stem)
    texts = [name, *([stem] if _in(name, known) == {} else [])] if inner else [stem]
    if inner and _is_variant(stem, known):
        texts.append(stem)
    told: dict[str, str] = {}
    for text in texts:
        told |= _in(text, known)
    if len(told) != 1:
        return Skipped(shown, _unclear(told, known))
    ((variant, piece),) = told.items()
    name = name if inner else stem
    student = " ".join(re.sub(r"[\s_-]+", " ", name.replace(piece, " ", 1)).strip(" ,.;()").split())
    return _File(place, name, student, variant, sheet, (folded(student), variant))


def _unclear(told: Mapping[str, str], known: Mapping[str, str]) -> str:
    if told:
        return said(
            "the name names more than one variant: {listed}; leave one",
            listed=joined(", ", sorted(told)),
        )
    some = sorted(set(known.values()))
    return said(
        "the name names no variant of the table; call it by one, such as {name}",
        name=f"Ivanov-{some[0]}",
    )


def _sheet(stem: str, known: Mapping[str, str] | None) -> tuple[str, int]:
    """Return the name of a photograph without the number of its sheet, and that; 0 if it has none."""
    match = _SHEET.fullmatch(stem)
    if match is None or (known is not None and not _in(match["name"], known)):
        return stem, 0
    return match["name"], int(match["sheet"])


def _last(stem: str) -> int:
    """Return the number with which the name of a photograph ends: that of its sheet; 0 for none."""
    match = _LAST.fullmatch(stem)
    return int(match[1]) if match else 0


def _known(variants: Iterable[str]) -> dict[str, str]:
    """Return variants by what may stand for them: their names, numbers without zeros before them too."""
    names = list(variants)
    short = {_bare(folded(name)): name for name in reversed(names)}
    return short | {folded(name): name for name in names}


def _bare(text: str) -> str:
    return text.lstrip("0") or "0" if text.isdecimal() else text


def _is_variant(text: str, known: Mapping[str, str]) -> bool:
    return folded(text) in known or _bare(folded(text)) in known


def _in(text: str, known: Mapping[str, str]) -> dict[str, str]:
    """Return the variants that a name names, each with the piece that does; the longest pieces first."""
    pieces = [match.span() for match in re.finditer(r"[^\W_]+", text)]
    found: dict[str, str] = {}
    taken: list[tuple[int, int]] = []
    spans = [
        (start, end)
        for k, (start, _) in enumerate(pieces)
        for _, end in pieces[k : k + 8]
        if end - start <= LONGEST
    ]
    for start, end in sorted(spans, key=lambda span: span[0] - span[1]):
        piece = folded(text[start:end])
        name = known.get(piece) or known.get(_bare(piece))
        if name is None or any(start < b and a < end for a, b in taken):
            continue
        taken.append((start, end))
        found.setdefault(name, text[start:end])
    return found


def _hand_in(group: Sequence[_File]) -> HandIn:
    first = group[0]
    tables = [one.path for one in group if one.path.suffix.lower() in TABLES]
    photographs = [(one.path, one.sheet) for one in group if one.path not in tables]
    return HandIn(first.name, first.student, first.variant, tuple(tables), tuple(photographs))


def _called(found: Sequence[HandIn]) -> Iterator[HandIn]:
    """Yield hand-ins with names for files: of none a sign that a disk does not take, no two of them alike."""
    seen: set[str] = set()
    for one in found:
        stem = _STRANGE.sub("_", one.name)[:LONGEST].strip(" .") or "_"
        stem, k = (f"_{stem}" if stem.startswith("_.") else stem), 1
        name = stem
        while folded(name) in seen:
            k += 1
            name = f"{stem}-{k}"
        seen.add(folded(name))
        yield one._replace(file=name)

"""The named lengths of a document: in which values they stand, and how long one is for a value to come out."""

from __future__ import annotations

from graphic_tmm.scene.declare import FAULTY, Names, Path, Sort
from graphic_tmm.scene.document import Document
from graphic_tmm.scene.meaning import alike, leaves, meant, sort_at, value_at
from graphic_tmm.scene.quantities import si
from graphic_tmm.scene.sections import lengths_of


def places_of(doc: Document, name: str) -> tuple[Path, ...]:
    """Return the paths of the values in which a named length stands."""
    names = lengths_of(doc)
    return tuple(path for path, sort, value in leaves(doc) if _hangs_on(sort, value, name, names))


def name_at(doc: Document, path: Path) -> str | None:
    """Return the named length that a value hangs on; None of one by no name, or by several."""
    names, sort, value = lengths_of(doc), sort_at(doc, path), value_at(doc, path)
    found = [name for name in names if _hangs_on(sort, value, name, names)]
    return found[0] if len(found) == 1 else None


def _hangs_on(sort: Sort | None, value: object, name: str, names: Names) -> bool:
    """Whether a value means something else if a named length is another."""
    if not isinstance(value, str) or name not in value:
        return False
    other = {**names, name: 2.0 * names[name] + 1.0}
    one, two = meant(sort, value, names), meant(sort, value, other)
    return one is not FAULTY and two is not FAULTY and not alike(one, two)


def solved(doc: Document, path: Path, name: str, wanted: object) -> float | None:
    """Return how long a named length (m) is if a sum with it is as long as wanted."""
    names, sort = lengths_of(doc), sort_at(doc, path)
    zero, one = (meant(sort, value_at(doc, path), {**names, name: length}) for length in (0.0, 1.0))
    new = meant(sort, wanted, names)
    if not all(isinstance(x, float) for x in (zero, one, new)) or zero == one:
        return None
    return si((new - zero) / (one - zero), "length")

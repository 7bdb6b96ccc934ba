"""What a person asks by: names that are not there are refused with what was meant, numbers with their range."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import TypeVar

from graphic_tmm.errors import AbsentError, SheetError
from graphic_tmm.language.said import joined, said
from graphic_tmm.scene.misfits import meant

T = TypeVar("T")
LISTED = 30
"""So many names are told of those that there are."""


class Named(Mapping[str, T]):
    """A mapping whose error tells the names that there are."""

    def __init__(self, found: Mapping[str, T]) -> None:
        self._found = dict(found)

    def __getitem__(self, name: str) -> T:
        """Return what has a name.

        Raises
        ------
        AbsentError
            If nothing has it: a KeyError that tells the names that there are.
        """
        if name not in self._found:
            raise absent(name, self._found)
        return self._found[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self._found)

    def __len__(self) -> int:
        return len(self._found)

    def __repr__(self) -> str:
        return "\n".join(f"{name} = {one}" for name, one in self._found.items())


def absent(name: object, known: Iterable[str]) -> AbsentError:
    """Return the error of a name that is not there: what was probably meant, and all that there are."""
    there = list(known)
    told = there if len(there) <= LISTED else [*there[:LISTED], "..."]
    says: list[str] = [said('there is no "{name}"', name=str(name)), meant(str(name), there)]
    says.append(said("there are {known}", known=", ".join(told or [said("none")])))
    return AbsentError(joined("; ", filter(None, says)))


def refuse_out_of_range(name: str, value: float, least: float, most: float) -> None:
    """Refuse a number out of its range.

    Raises
    ------
    SheetError
        If it is: its name, the range.
    """
    if not least <= value <= most:
        limits = {"least": f"{least:g}", "most": f"{most:g}"}
        raise SheetError(
            said("{name}: a number from {least} to {most} is wanted", name=name, **limits)
        )

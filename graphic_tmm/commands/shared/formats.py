"""What files are written as, as an option names it: one form, or several with commas."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import PurePath

from graphic_tmm.language.said import said


def chosen(forms: str, known: Sequence[str], option: str = "--format") -> list[str]:
    """Return the forms that an option names.

    Raises
    ------
    SheetError
        If one of them is none; those that are known are told.
    """
    from graphic_tmm.errors import SheetError

    wanted = [form.strip().lower() for form in forms.split(",")]
    if unknown := [form for form in wanted if form not in known]:
        says = said(
            "{option}: no {unknown}; choose from {known}",
            option=option,
            unknown=", ".join(unknown),
            known=", ".join(known),
        )
        raise SheetError(says)
    return wanted


def form_of(form: str | None, output: str | None, known: Sequence[str]) -> str:
    """Return the one form that is asked for: by its name, else by the end of a file's name, else the first.

    >>> form_of(None, "table.CSV", ["text", "csv"]), form_of("text", "table.csv", ["text", "csv"])
    ('csv', 'text')
    """
    end = PurePath(output or "").suffix[1:].lower()
    return form or (end if end in known else known[0])

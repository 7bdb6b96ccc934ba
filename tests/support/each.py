"""One property of many cases as one test, which tells every case that fails."""

from __future__ import annotations

import inspect
from collections.abc import Callable, Iterable
from functools import wraps
from pathlib import Path
from typing import Any

from support.turns import in_turn


def each(
    names: str, cases: Iterable[Any], *, turns: int | None = None
) -> Callable[[Callable[..., None]], Callable[..., None]]:
    """Decorate a test of one case: it becomes one test of all, that fails with every case that does.

    It reads as ``pytest.mark.parametrize``: ``names`` are arguments of the test, ``cases`` their values, a
    tuple for several names. Several of these stand above each other. A test that asks for ``tmp_path`` gets an
    empty folder for each case. Parametrize where a person has to run a case alone; use this where it is one
    property. With ``turns`` so many of the cases run, others with each version.

    Raises
    ------
    ExceptionGroup
        Holds what each failing case raised, with the case as a note.
    """
    told = [name.strip() for name in names.split(",")]
    every = list(cases) if turns is None else in_turn(cases, turns)
    assert every, f"{names}: there is no case"

    def of_all(check: Callable[..., None]) -> Callable[..., None]:
        signature = inspect.signature(check)

        @wraps(check)
        def test(**fixtures: Any) -> None:
            failed = []
            for k, case in enumerate(every):
                values = case if len(told) > 1 else (case,)
                given = fixtures | dict(zip(told, values, strict=True))
                if isinstance(folder := fixtures.get("tmp_path"), Path):
                    given["tmp_path"] = folder / f"{k}"
                    given["tmp_path"].mkdir()
                try:
                    check(**given)
                except Exception as error:
                    error.add_note(f"{names}: {_shown(case)}")
                    failed.append(error)
            if failed:
                which = "; ".join(error.__notes__[-1] for error in failed)
                raise ExceptionGroup(f"{len(failed)} of {len(every)} fail: {which}", failed)

        kept = [p for name, p in signature.parameters.items() if name not in told]
        test.__signature__ = signature.replace(parameters=kept)  # type: ignore[attr-defined]
        return test

    return of_all


def _shown(case: Any) -> str:
    """A case in few words: its name, if it has one."""
    if isinstance(case, tuple):
        return ", ".join(map(_shown, case))
    text = str(getattr(case, "name", case))
    return text if len(text) <= 60 else text[:59] + "…"

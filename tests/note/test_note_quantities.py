"""One quantity has one letter and one number of digits, in figures, formulas and tables of a note."""

from __future__ import annotations

import re

from support.laid_out import drawn_case, note_of_case

from graphic_tmm.board import roles
from graphic_tmm.note.document import Symbol, leaves, runs_of, walk
from graphic_tmm.paper.views import pole_figures


def test_pole_distances_on_figures_are_as_a_ruler_lays_them_off() -> None:
    """H = 60,2 mm in a formula is H = 60,2 on the figure."""
    drawn = drawn_case("slotting").boards[0]
    log, reading = drawn.construction, drawn.reading
    views = {step.it.view for step in log.steps if log.roles(step.it.view, roles.POLE)}
    told = [text for view in views for text in pole_figures(log, reading, view, "ru").values()]
    exact = [
        float(reading[log.step(pole).uses[1]][0, 0])  # type: ignore[union-attr]
        for view in views
        for pole in log.roles(view, roles.POLE)
    ]
    assert any(abs(value - round(value, 1)) > 1e-3 for value in exact)
    assert all(re.fullmatch(r"H\S* = \d+(,\d)?", text) for text in told), told


def test_the_mean_moment_has_no_second_letter() -> None:
    letters = {
        leaf.markup
        for block in walk(note_of_case("slotting").blocks)
        for run in runs_of(block)
        for leaf in ([run] if isinstance(run, Symbol) else leaves_of(run))
    }
    assert {"M_д", "M_{д}"} & letters
    assert not [letter for letter in letters if "ср" in letter and letter.startswith("M")]


def leaves_of(run: object) -> list[Symbol]:
    sides = getattr(run, "sides", ())
    return [leaf for side in sides for leaf in leaves(side) if isinstance(leaf, Symbol)]

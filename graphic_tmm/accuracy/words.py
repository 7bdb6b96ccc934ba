"""The words of the study of accuracy, by the names that its writers have for them."""

from __future__ import annotations

from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.tables import Tongues

TEXTS: dict[str, str] = {
    "title": said("{title}. What accuracy costs"),
    "measure": said(
        "Error in % of the largest value that nine readings of ten keep within "
        "({trials} drawings by each hand that slips); work of that quantity at all positions."
    ),
    "error": said("error, %"),
    "axis": said("varied"),
    "value": said("value"),
    "positions": said("positions", context="how many"),
    "parts": said("parts of a phase"),
    "steps": said("rolling steps"),
    "slip": said("single slip of the student"),
    "ruler": said("ruler, mm"),
    "size": said("drawing, times as large"),
    "method": said("differentiation"),
    "start": said("taken from the plans"),
    "pole": said("pole distance H, times"),
    "passes": said("passes of friction"),
    "rod": said("mass of the rod"),
    "inertia": said("inertia force"),
    "trials": said("drawings by the student"),
    "others": said(
        "One thing varied about the scene's own setting ({hand}); in brackets minutes "
        "where the work changes"
    ),
    "exact": said("exact"),
    "cad": said("CAD"),
    "careful": said("careful"),
    "student": said("student"),
    "scene": said("as in the scene"),
    "prick": said("prick"),
    "compass": said("compass"),
    "swing": said("square and protractor"),
    "reading": said("reading"),
    "digits": said("digits"),
    "chords": said("chords"),
    "tangents": said("tangents"),
    "displacement": said("displacement"),
    "velocity": said("velocity"),
    "lever rule": said("by the lever rule"),
    "plan": said("plan of accelerations"),
    "series": said("series of two terms"),
    "minutes": said("min"),
    "milliseconds": said("ms"),
    "quartiles": said("ms (quartiles)"),
    "board": said("work at the board, minutes"),
    "machine": said("time on the machine, milliseconds"),
    "front": said("Pareto front of a hand"),
    "other": said("one thing varied"),
    "count": said("number of positions (parts, steps)"),
    "quantity": said("quantity"),
    "step": said("step"),
    "share": said("share"),
    "shares": said("Share of the variance per step, student, {count} positions"),
    "step of": said("{view}, step {number}: {text}"),
    "slope": said(
        "{quantity}: with the exact hand the error falls as N^{error} ± {width}, the work "
        "grows as N^{minutes}."
    ),
    "slope timed": said(
        "{quantity}: with the exact hand the error falls as N^{error} ± {width}, "
        "the work grows as N^{minutes}, the time on the machine as N^{seconds}."
    ),
    "optimum": said(
        "{quantity}, {hand}: least with {best} ({error} %), as good from {low} to {high}."
    ),
    "optimum sure": said("{quantity}, {hand}: least with {best} ({error} %)."),
    "optimum edge": said(
        "{quantity}, {hand}: least at the end of what was tried, {best} ({error} %)."
    ),
    "optimum flat": said("{quantity}, {hand}: about {error} % at any number."),
    "advice": said(
        "{best}, {hand}: {quantity} to {error} %; {finer} cost {times} times the work "
        "and give {other} %."
    ),
    "advice flat": said(
        "{quantity}, {hand}: to {error} % with any number of {unit}; {finer} "
        "instead of {number} only cost {times} times the work."
    ),
    "advice last": said(
        "{best}, {hand}: {quantity} to {error} %, the more the better: {finer} take "
        "{times} of the work and give {other} %."
    ),
    "most": said(
        "{quantity}: most of the student's error comes from {step} ({share} % of the variance)."
    ),
    "slopes": said("Slopes"),
    "optima": said("Best numbers"),
    "advices": said("Advice"),
    "left out": said("Not drawn: {text}"),
    "v": said("v by plans"),
    "a": said("a by plans"),
    "V_diagram": said("V by diagram"),
    "a_diagram": said("a by diagram"),
    "P_bal": said("P_bal"),
    "M_bal": said("M_bal"),
    "M_engine": said("M of the engine"),
    "J_fly": said("J of the flywheel"),
    "J_fly_energy_mass": said("J, energy–mass"),
    "r0_min": said("r₀ min of the cam"),
    "contact_ratio": said("contact ratio, line"),
    "contact_arc": said("contact ratio, arc"),
    "budget": said("budget {percent} %: {setting}; {minutes} min at the board; {errors}"),
    "budget size": said("{times} times as large"),
    "budget pole": said("H {times} times as far"),
    "budget none": said(
        "--budget {percent} %: no setting keeps within it; the best found: "
        "{setting}; {errors}. Allow more, or let a better hand draw (--hand)"
    ),
    "advice same": said("{quantity}, {hand}: to {error} % with any number of {unit}."),
    "slope flat": said(
        "{quantity}: with the exact hand the error is the same at any number "
        "(N^{error}), the work grows as N^{minutes}."
    ),
}
WORDS = Tongues(TEXTS)
COUNTED = {
    "positions": said("{n} position", "{n} positions"),
    "parts": said("{n} part", "{n} parts"),
    "steps": said("{n} step", "{n} steps"),
}


def counted(number: int, axis: str, language: str) -> str:
    """Return a number of positions, parts or steps with its noun.

    >>> counted(24, "positions", "ru"), counted(1, "steps", "en")
    ('24 положения', '1 step')
    """
    return speaking(language)(COUNTED[axis], n=number)

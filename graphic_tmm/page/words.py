"""What the page says besides the protocol, by the names that its program has for it."""

from __future__ import annotations

from graphic_tmm.language.said import said

WORDS: dict[str, str] = {
    "play": said("Play"),
    "sheets": said("Sheets"),
    "protocol": said("Protocol"),
    "plan": said("Plan"),
    "position": said("Position"),
    "first": said("First picture"),
    "previous": said("Previous step"),
    "next": said("Next step"),
    "last": said("Last picture"),
    "run": said("Play the steps"),
    "pause": said("Pause"),
    "given": said("Given: what is there before the first step."),
    "ready": said("Ready: what only helped is rubbed out."),
    "again": said("The same in position {name}."),
    "step of": said("{step} of {count}"),
    "why": said("Why"),
    "steps": said("Steps"),
    "drawing": said("The plan as far as it is drawn"),
    "tabs": said("Ways to look at the scene"),
    "no scripts": said("Sheets and protocol; with scripts the plans play step by step."),
    "sheet": said("Sheet"),
    "fit": said("Fit"),
    "fit whole": said("The whole sheet (key 0)"),
    "fit true": said("True size (key 1)"),
    "larger": said("Larger"),
    "smaller": said("Smaller"),
    "size": said("Sheet and size"),
    "desk keys": said(
        "The sheet: arrows move it, + and − zoom, 0 whole, 1 true size, Enter plays the chosen view"
    ),
    "desk": said(
        "Tap a view to see it large, once more to play it; tap a line to read what it is."
    ),
    "true size": said("{percent} of true size"),
    "100 mm": said("100 mm"),
    "screen size": said("Size of the screen"),
    "ruler": said("Lay a ruler at the line and move the slider until it is 100 mm long."),
    "calibrate": said("A millimetre of this screen"),
    "layers": said("Layers"),
    "letters": said("Letters"),
    "large letters": said("Letters and lines large enough for the screen"),
    "helping lines": said("Helping lines that were rubbed out"),
    "all positions": said("all"),
    "parts": said("Parts"),
    "views": said("Views"),
    "show step": said("Show step {step}"),
    "play view": said("Play this view"),
    "print": said("Print"),
    "print sheet": said("This sheet 1 : 1, on paper of its size"),
    "print tiles": said("This sheet on A4, to be glued"),
    "print check": said(
        "Print at 100 %, without fitting to the page; then measure the line of 100 mm."
    ),
    "tile": said("Sheet {sheet}: row {row} of {rows}, column {column} of {columns}"),
    "too old": said(
        "This browser cannot play the plans step by step: take one of 2023 or later. "
        "Sheets and protocol can be read below."
    ),
}
"""Braces are filled in by the page."""

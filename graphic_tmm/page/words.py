"""What the page says besides the protocol, by the names that its program has for it."""

from __future__ import annotations

from graphic_tmm.language.said import said

WORDS: dict[str, str] = {
    "play": said("Play"),
    "sheets": said("Sheets"),
    "crank": said("Crank"),
    "angle": said("Angle of the crank"),
    "turn on": said("Turn the crank"),
    "turn off": said("Stop the crank"),
    "speed": said("Speed"),
    "a second": said("°/s"),
    "shown": said("What is seen"),
    "not drawn": said("It cannot be drawn here: {why}."),
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
    "pace": said("Pace"),
    "seconds": said("{n} s a step"),
    "instrument": said("Instrument"),
    "segment": said("Segment"),
    "length": said("On the plan"),
    "scale": said("Scale factor"),
    "quantity": said("Quantity"),
    "values": said("Values"),
    "in position": said("position"),
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
    "large letters": said("Letters large enough for the screen"),
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
    "everywhere": said("Everywhere"),
    "lecture": said("Lecture"),
    "help": said("Keys"),
    "close": said("Close"),
    "space": said("Space"),
    "dark": said("Dark or light"),
    "keys run": said("Play the steps, pause"),
    "keys onward": said("Next step; then the next plan"),
    "keys back": said("Previous step; then the plan before"),
    "keys views": said("Next plan or position, the one before"),
    "keys tabs": said("Among the ways to look, when one of them has the focus"),
    "full screen": said("Full screen"),
    "leave full screen": said("Leave the full screen"),
    "black": said("Black screen, and back"),
    "speaker": said("Speaker's window"),
    "no window": said(
        "The browser did not open the speaker's window: allow windows of this page, then press again."
    ),
    "comes next": said("What comes next"),
    "nothing follows": said("This is the last picture of the last plan."),
    "clock": said("Time gone"),
    "clock start": said("Start the clock"),
    "clock stop": said("Stop the clock"),
    "clock back": said("Clock to 0:00"),
    "begin": said("Draw it step by step"),
    "welcome": said(
        "Every plan of this mechanism is drawn here step by step, as on paper: "
        "what is done, why, and what comes out."
    ),
    "or keys": said("Or press → for the next step, ? for all keys."),
}
"""Braces are filled in by the page."""

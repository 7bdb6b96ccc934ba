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
    "fit": said("As large as it is now"),
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
    "tabs": said("Ways to look at the scene"),
    "no scripts": said("Sheets and protocol; with scripts the plans play step by step."),
    "too old": said(
        "This browser cannot play the plans step by step: take one of 2023 or later. "
        "Sheets and protocol can be read below."
    ),
}
"""Braces are filled in by the page."""

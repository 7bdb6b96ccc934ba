"""What the page says of lengths that can be changed."""

from __future__ import annotations

from graphic_tmm.language.said import said

LIVE: dict[str, str] = {
    "givens": said("Lengths and other givens"),
    "as given": said("As given"),
    "copy keys": said("Copy as TOML"),
    "copied": said("Copied."),
    "of several": said(
        "{letter} is not a single number of [frame], [[link]] or [drive]: it is left out."
    ),
    "breaks": said(
        "It cannot be assembled with {letter} = {value}: {why}. Everything stands where it was."
    ),
    "exists": said("It exists over {share} of the turn."),
    "own lengths": said("Lengths of your own, exact: nothing is rounded as with a ruler."),
    "value of": said("{letter}, value"),
}
"""Sentences, by the names that its program has for them."""

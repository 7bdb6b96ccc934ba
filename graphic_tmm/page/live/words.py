"""What the page says of lengths that can be changed."""

from __future__ import annotations

from graphic_tmm.language.said import said

LIVE: dict[str, str] = {
    "givens": said("Lengths and other givens"),
    "how changed": said(
        "Move a range, type a value, or drag a joint by its ring; that beyond the crank's pin is its length."
    ),
    "as given": said("As given"),
    "copy keys": said("Copy as TOML"),
    "put keys": said("Put into my scene"),
    "copied": said("Copied."),
    "of several": said("{letter} is not a single number of the scene: it is left out."),
    "breaks": said("It cannot be assembled with {value}: {why}. Everything stands where it was."),
    "exists": said("It exists over {share} of the turn."),
    "own lengths": said("Lengths of your own, exact: nothing is rounded as with a ruler."),
    "value of": said("{letter}, value"),
    "given no number": said('"{text}" is no number: the value stays.'),
    "practised": said(
        "With lengths of your own: {values}. How far a hand may be off is taken of the sheet's lengths."
    ),
    "questions": said("Three questions", context="of a page"),
    "how answered": said("Answer by the range or the field of the letter; the rest is as given."),
    "ask ratio point": said(
        "With which {letter} is {ratio}, the ratio of the mean speeds of both strokes of {point}, {target}?"
    ),
    "ask ratio link": said(
        "With which {letter} is {ratio}, the ratio of the mean speeds of both swings of link {point}, {target}?"
    ),
    "ask travel point": said(
        "With which {letter} does {point} travel {target} mm from end to end?"
    ),
    "ask travel link": said("With which {letter} does link {point} swing by {target}°?"),
    "ask most": said("How large may {letter} be at the most for the crank to turn round?"),
    "ask least": said("How small may {letter} be at the least for the crank to turn round?"),
    "asks nothing": said("With other lengths it does not turn round, or does the same."),
    "answer now": said("Now: {value}.", context="answer to a question"),
    "answer right": said("Right.", context="answer to a question"),
    "answer turns": said("It turns round; {letter} may go farther."),
    "answer stops": said("It does not turn round."),
    "answer others": said("The rest has to be as given."),
}
"""Sentences, by the names that its program has for them."""

"""A log at a million positions: noted on a tape, written as a loop in LLVM's language, translated, run.

The way of a log is `loop` (what of the steps can be noted) by `trace` and `tape`, `llvm` (the text), `machine`
(the function, kept on the disk), `run`. Sheets, tables and checks have few positions and never come here.
"""

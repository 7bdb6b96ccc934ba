"""The commands as a person runs them: what they print, and the tables read back."""

from __future__ import annotations

import csv
import io
import json
import re
from typing import Any

from click.testing import CliRunner, Result

from graphic_tmm.__main__ import main
from graphic_tmm.language.catalogue import languages, speaking
from graphic_tmm.readers.writing import HEADS


def invoke(*arguments: object) -> Result:
    """Run a command in this process."""
    return CliRunner().invoke(main, [str(a) for a in arguments])


def printed(*arguments: object) -> str:
    """Return what a command prints that is right."""
    done = invoke(*arguments)
    assert done.exit_code == 0, done.output
    return done.stdout


def rows(text: str, delimiter: str = ",") -> list[dict[str, str]]:
    """Return the rows of a table printed as CSV, whatever the language of its titles."""
    titles = {speaking(one)(head): str(head) for one in languages() for head in HEADS}
    first, *others = csv.reader(io.StringIO(text), delimiter=delimiter)
    names = [titles.get(title, title) for title in first]
    return [dict(zip(names, cells, strict=True)) for cells in others]


def tabled(*arguments: object) -> dict[str, Any]:
    """Return the table that a command prints as JSON."""
    return json.loads(printed("table", *arguments, "--format", "json"))


def warned(done: Result) -> list[str]:
    """Return the warnings of a command without the words before each."""
    words = (speaking(language)("warning: {text}", text="") for language in languages())
    said = re.compile("|".join(words))
    return [said.split(line, maxsplit=1)[-1] for line in done.stderr.splitlines()]


def column(found: dict[str, Any], plan: str, segment: str) -> dict[str, Any]:
    """Return a column of a document by its plan and segment."""
    return next(c for c in found["columns"] if (c["plan"], c["segment"]) == (plan, segment))

"""A reader of finished reports: every number of every sentence is looked up: as read, as due, in the log.

He knows the forms of the sentences, the file of readings, the table of what is due and the log; of how a
report is made he knows nothing. What he cannot look up is returned as a fault.
"""

from __future__ import annotations

import math
import re
from collections import defaultdict
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import Any

import numpy as np

from graphic_tmm.board.record import Mark, segment_name
from graphic_tmm.board.values import Angle, Length, Number, Point
from graphic_tmm.checking.cells import cells, points, segment_text
from graphic_tmm.checking.records import Taken
from graphic_tmm.checking.report.rows import WORDS
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.language.symbols import plain, spoken
from graphic_tmm.readers.protocol import title_of
from support.report_page import NUMBER, Page, Table, reckoned, worth

_NUMBER = r"−?\d+(?:[.,]\d+)?(?:·10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?"
_FIGURE = _NUMBER + r"(?: [^\s.;,]+)?"
FIELDS = {
    "lines": r"\d[\d–, …]*", "steps": ".+", "found": _FIGURE, "due": _FIGURE, "off": _NUMBER,
    "of": r"\d+", "count": r"\d+", "wrong": r"\d+", "fine": r"\d+", "doubtful": r"\d+", "all": r"\d+",
    "percent": _NUMBER, "number": r"\d+", "segment": r"\S+", "position": r"[\w*]+",
}  # fmt: skip
"""What stands where in a sentence."""
FOUR = 6e-4
"""What four digits leave of a number, as a share."""


def near(text: str, *known: float, share: float = FOUR) -> bool:
    """Whether a printed number is one of some, as exactly as it is printed; whatever its sign."""
    digits = len(text.partition("·")[0].replace(",", ".").partition(".")[2])
    slack = 0.51 * 10.0**-digits if "·" not in text else 0.0
    value = abs(worth(text))
    return any(abs(value - abs(one)) <= max(slack, share * abs(one)) for one in known)


class Reader:
    """Who looks numbers up; ``rows``: of the file, by the names that the scene has for its segments."""

    def __init__(self, made: DrawnScene, rows: Sequence[Taken], page: str) -> None:
        self.made, self.language = made, made.scene.language
        self.words, self.page = WORDS[self.language], Page(page)
        self.due, self.spots = cells(made), points(made)
        self.rows = list(rows)
        self.called = lambda one: segment_text(one.segment, self.language)
        self.by_line = defaultdict(list)
        for one in self.rows:
            self.by_line[one.line].append(one)
        self.names = {name for board in made.boards for name in board.names}
        self.steps: dict[tuple[str, str], tuple[Drawn, Any]] = {}
        self.letters: set[str] = set()
        for board in made.boards:
            count: defaultdict[str, int] = defaultdict(int)
            for step in board.construction.steps:
                count[step.it.view] += 1
                title = title_of(board.project, step.it.view, self.language)
                self.steps.setdefault((title, str(count[step.it.view])), (board, step))
            for mark in (*board.construction.given, *(s.it for s in board.construction.steps)):
                self.letters |= {mark.name, plain(mark.name), spoken(mark, self.language)}
                self.letters |= {segment_name(mark.letter)}
        self.letters |= {segment for _, segment, _ in self.due} | {p for _, p, _ in self.spots}
        titles = {title for title, _ in self.steps}
        self.known = sorted((self.letters | titles) - {""}, key=len, reverse=True)
        self.known = [one for one in self.known if re.search(r"\d", one)]
        self._explains = False
        self.wrong: list[str] = []
        self._fault = self.wrong.append

    def exact(self, board: Drawn, mark: Mark, position: str) -> float:
        reading = board.of(mark.view)
        if reading is None or mark not in reading:
            reading = board.reading
        places = list(board.row(mark.view)) if mark.view in board.project.rows else None
        if mark not in reading:
            value = board.given.get(mark)
            return float(np.ravel(np.asarray(value))[0]) if value is not None else math.nan
        row = np.ravel(reading[mark])
        place = board.names.index(position) if position in board.names else 0
        at = place if places is None else places.index(place) if place in places else 0
        return float(np.real(row[at if row.size > 1 else 0]))

    def own(self, board: Drawn, mark: Mark, position: str) -> float:
        """Return a number as the file gives it, or as it is calculated from such by the log; NaN if neither."""
        for one in self.rows:
            if one.pointed or one.position not in (position, ""):
                continue
            names = (segment_name(mark.letter), mark.name, mark.letter)
            if one.segment in names and one.plan == mark.view:
                value, cell = one.mm if one.mm is not None else one.value, self.due.get(one.key)
                if one.mm is None and mark.kind is Length and cell and cell.mm and cell.value:
                    value = None if value is None else value * cell.mm / cell.value
                if value is not None:
                    sign = self.exact(board, mark, position)
                    return math.copysign(value, sign) if value >= 0 else value
        step = next((s for s in board.construction.steps if s.it == mark), None)
        if step is None:
            return self.exact(board, mark, position)
        if not (step.op.formula or step.op.proportion):
            return math.nan
        values = [np.array([[self.own(board, m, position)]]) for m in step.uses]
        with np.errstate(all="ignore"):
            return float(np.ravel(step.op.run(*values, **step.choice))[0])

    def figures(self, position: str, segment: str = "") -> Iterator[tuple[float, float, str]]:
        """Yield what was read and what is due there."""
        for one in self.rows:
            cell = self.due.get(one.key)
            if position and one.position not in (position, ""):
                continue
            if segment not in ("", self.called(one)) or cell is None or one.pointed:
                continue
            if one.mm is not None and cell.mm is not None:
                yield one.mm, cell.mm, one.segment
            elif one.value is not None and cell.value is not None:
                yield one.value, cell.value, one.segment

    def faults(self) -> list[str]:
        """Return what a report says that is not so, with its sentence."""
        for heading, text in self.page.sentences:
            before = len(self.wrong)
            self._sentence(heading, text)
            self.wrong[before:] = [f"{one} | {heading} | {text}" for one in self.wrong[before:]]
        for table in self.page.tables:
            self._table(table)
        return self.wrong

    def _template(self, key: str) -> re.Pattern[str]:
        parts = re.split(r"\{(\w+)\}", self.words[key].rstrip("."))
        text = "".join(
            re.escape(part) if k % 2 == 0 else f"(?P<{part}>{FIELDS.get(part, '.+?')})"
            for k, part in enumerate(parts)
        )
        return re.compile(text.replace(r"\ ", " ") + r"(?:\.(?= |$)|;|,|$|(?=[):]))", re.IGNORECASE)

    def _sentence(self, heading: str, text: str) -> None:
        place = self._template("at").search(text)
        position = place["position"] if place else ""
        text = text.replace(place[0], " ", 1) if place else text
        if position and position not in self.names:
            self._fault(f"there is no position {position}")
        step = self._step(heading)
        self._explains = bool(self._template("explains").search(text))
        for key, check in self._forms().items():
            for found in list(self._template(key).finditer(text)):
                if not check(found, position, step):
                    self._fault(f"{key}: {found[0]}")
                text = text.replace(found[0], " ", 1)
        for key in ("own numbers", "due numbers"):
            head = re.match(rf"{re.escape(self.words[key])}[, :]* (.*)", text)
            if head:
                self._calculation(head[1].strip().rstrip("."), key, position, step)
                return
        why = step[1].reason if step else ""
        self._left(text, position, step, [*NUMBER.findall(why)])

    def _step(self, heading: str) -> tuple[Drawn, Any] | None:
        words = re.split(r"\{\w+\}", self.words["found wrong"])
        found = re.match(rf"\W*(.+?){re.escape(words[1])}(\d+){re.escape(words[2])}(.+)", heading)
        if not found:
            return None
        known = self.steps.get((found[1], found[2]))
        if known is None:
            self._fault(f"there is no step {found[2]} of {found[1]}")
        elif spoken(known[1].it, self.language) != found[3]:
            self._fault(f"step {found[2]} of {found[1]} does not leave {found[3]}")
        return known

    def _forms(self) -> Mapping[str, Callable[[re.Match[str], str, Any], bool]]:
        return {
            "counts": self._counts,
            "explains": lambda f, at, step: int(f["count"]) <= int(f["wrong"]) == self.count("wrong"),
            "at lines": lambda f, at, step: self._lines(f["lines"], f.string),
            "left over": lambda f, at, step: int(f["count"]) <= self.count("wrong"),
            "sure": lambda f, at, step: 0 < int(f["percent"]) <= 99,
            "rare": lambda f, at, step: 0 < worth(f["percent"]) <= 0.5,
            "it shows": self._both,
            "yours for": self._both,
            "yours fine": lambda f, at, step: self._both(f, at, step, same=True),
            "yours": self._yours,
            "off itself": self._own_error,
            "off": self._off,
            "drawn length": self._position, "drawn amiss": self._position,
            "drawn": self._position,
            "drawn due": self._position,
            "drawn so": self._drawn,
            "whole": lambda f, at, step: worth(f["due"]) < int(f["doubtful"]) <= self.count("doubtful"),
            "slips": lambda f, at, step: (worth(f["swing"]), worth(f["reading"])) == (0.6, 0.75),
            "whole alone": lambda f, at, step: True,
            "so many": lambda f, at, step: int(f["count"]) <= self.count("wrong"),
            "fine ones": lambda f, at, step: int(f["count"]) == self.count("fine"),
            "begin": lambda f, at, step: (
                (f["plan"], f["number"]) in self.steps
                and spoken(self.steps[f["plan"], f["number"]][1].it, self.language) == f["letter"]
            ),
        }  # fmt: skip

    def count(self, verdict: str) -> int:
        """Return how many rows of the page's tables have a verdict."""
        of = {"wrong": [], "doubtful": [], "fine": []}  # type: ignore[var-annotated]
        doubtful = self.words["doubtful ones"].partition("}")[2]
        for table in self.page.tables:
            key = "doubtful" if table.heading.endswith(doubtful) else "wrong"
            if not re.match(r"[✖▲]", table.heading):
                key = "fine"
            of[key] += table.rows
        return len(of[verdict])

    def _counts(self, found: re.Match[str], position: str, step: Any) -> bool:
        told = {key: int(found[key]) for key in ("fine", "doubtful", "wrong")}
        whole = int(found["all"]) == len(self.rows) == sum(told.values())
        return whole and all(self.count(key) == value for key, value in told.items())

    def _lines(self, text: str, sentence: str) -> bool:
        """Whether lines are of the file, and wrong where something is said to explain them."""
        wrong = {row[0] for table in self.page.tables for row in table.rows
                 if re.match(r"[✖▲]", table.heading)}  # fmt: skip
        if not self._explains:
            wrong |= set(map(str, self.by_line))
        for part in re.findall(r"\d+(?:–\d+)?", text):
            first, _, last = part.partition("–")
            if any(str(k) not in wrong for k in range(int(first), int(last or first) + 1)):
                return False
        return True

    def _both(self, found: re.Match[str], position: str, step: Any, *, same: bool = False) -> bool:
        told = found.groupdict()
        pairs = list(self.figures(position, told.get("segment", "")))
        mine = NUMBER.match(told["found"])
        due = mine if same else NUMBER.match(told["due"])
        if mine is None or due is None:
            return False
        slack = 0.3 if same else FOUR  # what is fine is not what is due to the last digit
        return any(near(mine[0], a) and near(due[0], b, share=slack) for a, b, _ in pairs)

    def _yours(self, found: re.Match[str], position: str, step: Any) -> bool:
        mine = NUMBER.match(found["found"])
        return mine is not None and any(near(mine[0], a) for a, _, _ in self.figures(position))

    def _off(self, found: re.Match[str], position: str, step: Any) -> bool:
        off = [
            abs(one.spot - self.spots[one.key])
            for one in self.rows
            if one.pointed and self.called(one) == found["segment"] and one.position == position
        ]
        return near(found["off"], *off)

    def _own_error(self, found: re.Match[str], position: str, step: Any) -> bool:
        own = self.words["own"]
        return any(
            near(found["off"], worth(row[table.columns.index(own)].lstrip("+")), share=0.05)
            for table in self.page.tables
            if own in table.columns
            for row in table.rows
            if found["segment"] in " ".join(row) and NUMBER.search(row[table.columns.index(own)])
        )

    def _position(self, found: re.Match[str], position: str, step: Any) -> bool:
        return found["position"] in self.names

    def _drawn(self, found: re.Match[str], position: str, step: Any) -> bool:
        if step is None:
            return False
        board, at = step
        title = title_of(board.project, at.it.view, self.language)
        for number, sentence in re.findall(r"(\d+)\. (.+?)(?= \d+\. |$)", found["steps"]):
            named = self.steps.get((title, number))
            if named is None or spoken(named[1].it, self.language) not in sentence:
                return False
            self._left(sentence, position, named, [])
        return True

    def _calculation(self, text: str, key: str, position: str, step: Any) -> None:
        if step is None:
            self._fault("no step is calculated here")
            return
        board, at = step
        value = self.own if key == "own numbers" else self.exact
        known = {m: value(board, m, position) for m in at.uses if m.kind in (Length, Number, Angle)}
        if at.op.proportion:
            self._proportion(text, board, position)
            return
        parts = text.split(" = ")
        numbers, result = parts[-2], parts[-1]
        if key == "own numbers" and not all(map(math.isfinite, known.values())):
            self._fault("not all of its numbers were read")
        said = NUMBER.match(result)
        values = [np.array([[known[m]]]) for m in at.uses if m in known]
        if said is None or len(values) < len(at.uses):
            self._fault("a calculation without a result")
            return
        due = float(np.ravel(at.op.run(*values, **at.choice))[0])
        if not near(said[0], due, share=2e-3):
            self._fault(f"{said[0]} is not {due:.5g}")
        if len(parts) > 2:
            come = reckoned(numbers)
            if come is not None and not near(said[0], come, share=5e-3):
                self._fault(f"{numbers} comes to {come:.5g}")
            constants = NUMBER.findall(at.op.formula)
            for one in NUMBER.findall(numbers):
                if one not in constants and not near(one, *known.values()):
                    self._fault(f"{one} is nobody's number")

    def _proportion(self, text: str, board: Drawn, position: str) -> None:
        """Check ae/ab = AE/AB; ae = ab·AE/AB = 56.3·90.1/130 = 39.05 mm: each segment from point to point."""
        _, letters, numbers, result = text.rpartition("; ")[2].split(" = ")
        come = reckoned(numbers)
        if come is None or not near(NUMBER.findall(result)[0], come, share=2e-3):
            self._fault(f"{numbers} does not come to {result}")
        names, figures = re.split("[·/]", letters), NUMBER.findall(numbers)
        for name, figure in zip(names, figures, strict=True):
            if not near(figure, *self._segments(board, name, position)):
                self._fault(f"{name} is not {figure}")

    def _segments(self, board: Drawn, name: str, position: str) -> Iterator[float]:
        there = defaultdict(list)
        for (plan, letter, at), spot in self.spots.items():
            if at == position:
                there[plan].append((letter, spot))
        for some in there.values():
            yield from (abs(z - w) for a, z in some for b, w in some if a + b == name)

    def _left(self, text: str, position: str, step: Any, known: Sequence[str]) -> None:
        """Look up the numbers that are left of a sentence without the letters of the log and its plans."""
        for plan, number, rest in self._told_steps(text):
            text = text.replace(plan, " ").replace(number, " ", 1)
            if rest is None:
                self._fault(f"there is no such step: {plan} {number}")
        for one in self.known:
            text = re.sub(rf"(?<![\w.,]){re.escape(one)}(?!\w|[.,]\d)", " ", text)
        text = re.sub(r"−?\d+°", " ", text) if step is None else text  # how far a mistake turns
        for name in sorted(self.names, key=len, reverse=True):
            for lead in (self.words["at"], "positions {position}", "{position} and", "положений {position}",
                         "положении {position}", "положения {position}", "({position})"):  # fmt: skip
                told = re.escape(lead.format(position=name)).replace(r"\ ", " ")
                text = re.sub(rf"{told}(?!\d)", " ", text)
        values = list[float]()
        if step is not None:
            board, at = step
            values = [self.exact(board, m, position) for m in at.uses if m.kind is not Point
                      and m.kind in (Length, Number, Angle)]  # fmt: skip
        for one in NUMBER.findall(text):
            if one not in known and not near(one, *values) and not self._factor(one, text):
                self._fault(f"{one} stands nowhere")

    def _told_steps(self, text: str) -> Iterator[tuple[str, str, Any]]:
        words = re.split(r"\{\w+\}", self.words["found wrong"])
        for title in sorted({title for title, _ in self.steps}, key=len, reverse=True):
            for found in re.finditer(rf"{re.escape(title)}({re.escape(words[1])}(\d+))", text):
                yield title, found[1], self.steps.get((title, found[2]))

    def _factor(self, one: str, text: str) -> bool:
        """Whether readings are so many times what is due, or its power or inverse: of any position."""
        value = abs(worth(one))
        ratios = [abs(a / b) for a, b, _ in self.figures("") if b and a]
        ways = {value, value**2, value**0.5, 1 / value if value else 0.0}
        return any(abs(r - w) <= 0.06 * w for r in ratios for w in ways)

    def _table(self, table: Table) -> None:
        keys = {self.words[k]: k for k in ("line", "position", "segment", "found", "due", "deviation",
                                           "unit", "percent", "farther", "own")}  # fmt: skip
        for row in table.rows:
            cell = {
                keys[name]: text
                for name, text in zip(table.columns, row, strict=True)
                if name in keys
            }
            told = f"{table.heading}: {' '.join(row)}"
            mine, due = (worth(cell[k]) for k in ("found", "due"))
            there = self.by_line[int(cell["line"])]
            if not any(self._is(one, cell, mine, due) for one in there):
                self._fault(f"not what was read and is due | {told}")
            off = cell["deviation"].lstrip("+")
            apart = abs(abs(worth(off)) - abs(abs(mine) - abs(due)))
            same = near(off, mine - due, share=0.02) or apart <= 0.02 * abs(due) + 0.011
            if not same and not any(one.pointed for one in there):
                self._fault(f"off by something else | {told}")

    def _is(self, one: Taken, cell: Mapping[str, str], mine: float, due: float) -> bool:
        known = self.due.get(one.key)
        here = one.position == cell.get("position", "")
        if not here or not cell["segment"].startswith(self.called(one)):
            return False
        if one.pointed:
            spot = self.spots[one.key]
            return near(cell["found"], abs(one.spot)) and near(cell["due"], abs(spot))
        if known is None:
            return False
        if one.mm is not None and known.mm is not None:
            return near(cell["found"], one.mm) and near(cell["due"], known.mm)
        return one.mm is None and known.value is not None and near(cell["due"], known.value)

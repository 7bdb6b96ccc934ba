"""The answer for a terminal: three sentences, where the error comes from, one table of the front."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from typing import Any

from graphic_tmm.accuracy.answer import Answer, MeasuredWay, Origin
from graphic_tmm.accuracy.quantities import Accuracy
from graphic_tmm.accuracy.settings import dividing
from graphic_tmm.accuracy.sources import TOGETHER, Share, Sources
from graphic_tmm.accuracy.timing import Load, Seconds
from graphic_tmm.accuracy.ways import Way
from graphic_tmm.accuracy.words import WORDS
from graphic_tmm.language.catalogue import Words
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.readers.protocol import title_of
from graphic_tmm.readers.sentences import sentence
from graphic_tmm.scene.chapter import chapters

WIDTH = 80
"""Characters of a line."""
DOUBTFUL = "~"
"""Marks seconds that are not to be believed."""
BAR = 60
"""Characters of the bar of sources."""
SHADES = "█▓▒░#=+-"
"""What a source is drawn with, from the largest on."""
STEP = 0.05
"""A step is named that brings more than this share."""
LEAST = 0.005
"""A source with a smaller share is not named: shares are known to 1 %."""
ALIKE = 0.95
"""Of two ways that err no more differently than by this factor neither is truer."""


def answer_text(answer: Answer) -> list[Any]:
    """Return what rich prints of an answer, in order."""
    from rich.text import Text

    words = WORDS[answer.scene.language]
    printed: list[Any] = [Text(words["title"].format(title=answer.scene.title), style="bold")]
    printed += [Text(line) for line in sentences(answer)]
    printed += [Text(line) for line in bars(answer)]
    if answer.own.worst > 0.0:
        printed += [_table(answer), Text(words["answer letters"])]
    if answer.load is not None:
        printed += [_machine(answer), Text(_load(answer))]
    return printed


def sentences(answer: Answer) -> Iterator[str]:
    """Yield how far the drawing is off, what halves that, what is not worth its cost, where it comes from."""
    yield from costs(answer)
    if answer.own.worst > 0.0:
        for origin in of_worst(answer):
            yield _sources(answer, origin)


def costs(answer: Answer) -> Iterator[str]:
    """Yield how far the drawing is off, what halves that, what is not worth its cost, where the knee is."""
    if not answer.own.worst > 0.0:
        yield _words(answer)["answer exact"]
        return
    yield _how_far(answer)
    yield from _compared(answer)
    yield _halved(answer)
    yield _wasted(answer)
    yield _knee(answer)


def _words(answer: Answer) -> Words:
    return WORDS[answer.scene.language]


def _percent(answer: Answer, error: float) -> str:
    return number(error, answer.scene.language, 2)


def _minutes(answer: Answer, way: Way) -> str:
    return fixed(way.minutes, 0, answer.scene.language)


def setting(answer: Answer, way: Way) -> str:
    """Return a way in words."""
    return way.sentence(answer.own.way, answer.scene.language)


def _how_far(answer: Answer) -> str:
    words, own, main = _words(answer), answer.own, answer.main
    parts = [setting(answer, own.way)]
    if own.way.ruler is not None:
        ruler = number(own.way.ruler, answer.scene.language)
        parts.append(words["by ruler"].format(ruler=ruler))
    parts.append(words[f"by {own.way.hand}"])
    key = "answer far" if main == answer.worst else "answer far main"
    text = words[key].format(
        setting=", ".join(part for part in parts if part),
        quantity=words[answer.worst],
        error=_percent(answer, own.worst),
        main=words[main],
        least=_percent(answer, own.errors[main]),
    )
    if answer.printed is not None:
        key = "answer printed" if main == answer.worst else "answer printed main"
        text += " " + words[key].format(
            error=_percent(answer, answer.printed.get(answer.worst, float("nan"))),
            least=_percent(answer, answer.printed.get(main, float("nan"))),
        )
    lost = [words["answer lost"].format(quantity=words[name]) for name in answer.lost]
    lost += [words["answer unjudged"].format(quantity=words[name]) for name in answer.unjudged]
    return " ".join([text, *lost])


def _compared(answer: Answer) -> Iterator[str]:
    """Yield, of what is drawn in several ways, how far each is off, and which is the truest."""
    words, errors = _words(answer), answer.own.errors
    for chapter in chapters():
        ways = [name for name in Accuracy.of(chapter).compared if name in errors]
        if len(ways) > 1:
            first, second, *_ = sorted(ways, key=lambda name: errors[name])
            alike = errors[first] >= ALIKE * errors[second]
            each = "; ".join(f"{words[name]} {_percent(answer, errors[name])} %" for name in ways)
            key = "answer compared alike" if alike else "answer compared"
            yield words[key].format(each=each, truest=words[first])


def _halved(answer: Answer) -> str:
    words = _words(answer)
    if answer.halved is not None:
        way = answer.halved.way
        key = "answer halved" if way.minutes > answer.own.way.minutes else "answer halved less"
        return words[key].format(
            setting=setting(answer, way),
            error=_percent(answer, max(answer.halved.errors.values())),
            minutes=_minutes(answer, way),
            own=_minutes(answer, answer.own.way),
        )
    assert answer.nearest is not None
    row, in_the_way = answer.nearest
    text = words["answer not halved"].format(
        setting=setting(answer, row.way),
        error=_percent(answer, row.worst),
        minutes=_minutes(answer, row.way),
    )
    return f"{text} {in_the_way}".strip()


def _wasted(answer: Answer) -> str:
    words, own, row = _words(answer), answer.own, answer.wasted
    if row is None:
        return words["answer none wasted"]
    error, before = _percent(answer, row.worst), _percent(answer, own.worst)
    return words["answer wasted same" if error == before else "answer wasted"].format(
        setting=setting(answer, row.way),
        minutes=fixed(row.way.minutes - own.way.minutes, 0, answer.scene.language),
        error=error,
        own=before,
    )


def _knee(answer: Answer) -> str:
    return _words(answer)["answer knee"].format(
        setting=setting(answer, answer.knee.way),
        minutes=_minutes(answer, answer.knee.way),
        error=_percent(answer, answer.knee.worst),
    )


def of_worst(answer: Answer) -> Iterator[Origin]:
    """Yield where the error of the quantity that errs most comes from, by each hand."""
    return (one for one in answer.origins if answer.worst in one.of)


def parts(of: Sources) -> list[tuple[str, float]]:
    """Return the sources with a share that is known, the largest first; what several bring as the last."""
    named = [(name, share) for name, share in of.parts.items() if share >= LEAST]
    if of.together > TOGETHER:
        named.append(("together", of.together))
    whole = sum(share for _, share in named)  # of what shares are not sure of each has its part
    return [(name, share / whole) for name, share in named]


def _sources(answer: Answer, origin: Origin) -> str:
    words, of = _words(answer), origin.of[answer.worst]
    each = ", ".join(
        f"{words[f'from {name}']} {_percent(answer, 100.0 * share)} %" for name, share in parts(of)
    )
    key = "answer from" if origin.hand == answer.own.way.hand else "answer from printed"
    text = words[key].format(quantity=words[answer.worst], each=each)
    return f"{text} {most(origin, of, answer.scene.language)}".rstrip()


def most(origin: Origin, of: Sources, language: str) -> str:
    """Return which step brings most of the error of a quantity, "" if none brings much."""
    if not of.steps or of.steps[0].share <= STEP:
        return ""
    return WORDS[language]["answer step"].format(
        step=step_name(origin, of.steps[0], language).rstrip("."),
        share=number(100.0 * of.steps[0].share, language, 2),
    )


def step_name(origin: Origin, share: Share, language: str) -> str:
    """Return a step as the protocol names it: its view, its number there, its sentence."""
    view, project, reading = share.step.it.view, origin.project, origin.reading
    return WORDS[language]["step of"].format(
        view=title_of(project, view, language),
        number=project.marks(view).index(share.step.it) + 1,
        text=sentence(share.step, language, reading, min(1, reading.positions - 1)),
    )


def bars(answer: Answer) -> Iterator[str]:
    """Yield a bar of the sources of the worst quantity for each hand, and what its shades are."""
    words = _words(answer)
    named: dict[str, str] = {}
    lines = []
    for origin in of_worst(answer):
        row = [(name, share) for name, share in parts(origin.of[answer.worst]) if share > 0.0]
        for name, _ in row:
            named.setdefault(name, SHADES[min(len(named), len(SHADES) - 1)])
        whole = sum(share for _, share in row)
        ends = [0.0]
        for _, share in row:
            ends.append(ends[-1] + BAR * share / whole)
        bar = "".join(
            named[name] * (round(b) - round(a))
            for (name, _), a, b in zip(row, ends, ends[1:], strict=False)
        )
        lines.append(f"{bar} {words[hand_name(answer, origin)]}")
    if not lines:
        return
    yield from lines
    legend = (f"{shade} {words[f'from {name}']}" for name, shade in named.items())
    yield "; ".join(legend)


def hand_name(answer: Answer, origin: Origin) -> str:
    """Return what a hand is called in words: that at the board, or the scene's own."""
    return origin.hand if origin.hand == answer.own.way.hand else "printed"


def _table(answer: Answer) -> Any:
    """Return the table of the front."""
    words, language = _words(answer), answer.scene.language
    columns = table_columns(answer)
    table = _plain(words["answer table"])
    table.add_column("")
    for name in columns:
        table.add_column(name, justify="right")
    for row in answer.rows:
        table.add_row(mark(answer, row), *table_cells(answer, row, language))
    return table


def _plain(title: str) -> Any:
    """Return a table without lines."""
    from rich.table import Table

    return Table(title=title, title_justify="left", box=None, pad_edge=False)


def mark(answer: Answer, row: MeasuredWay) -> str:
    """Return how a row is marked: the scene as it is, the knee."""
    return ("●" if row.way is answer.own.way else "") + ("◆" if row is answer.knee else "")


def _varied(answer: Answer) -> list[str]:
    """Return the axes that are not the same in all rows; the numbers of parts are always there."""
    rows = [dict(row.way.changes) for row in answer.rows]
    varied = (name for name in rows[0] if len({row.get(name, "") for row in rows}) > 1)
    named = {name for name in rows[0] if name in dividing()} | set(varied)
    return [name for name in rows[0] if name in named]


def table_columns(answer: Answer) -> list[str]:
    """Return the heads of the table."""
    words = _words(answer)
    heads = [words[name] if name in dividing() else words["how"] for name in _varied(answer)]
    heads += [words["hand"]] if _hands(answer) else []
    heads += [words["ruler"]] if _rulers(answer) else []
    heads += ["×"] if any(row.way.times != 1.0 for row in answer.rows) else []
    heads.append(words["worst"])
    heads += [words["main"]] if answer.main != answer.worst else []
    return [*heads, words["minutes"]]


def _hands(answer: Answer) -> bool:
    return len({row.way.hand for row in answer.rows}) > 1


def _rulers(answer: Answer) -> bool:
    """Whether rulers are not the same as are usual for each hand."""
    rows = {(row.way.hand, row.way.ruler) for row in answer.rows}
    return len(rows) > len({hand for hand, _ in rows})


def table_cells(answer: Answer, row: MeasuredWay, language: str) -> list[str]:
    """Return the cells of a row, in the order of the heads."""
    words, changes, way = _words(answer), dict(row.way.changes), row.way
    cells = [words.get(changes[name]) or changes[name] for name in _varied(answer)]
    cells += [words[way.hand]] if _hands(answer) else []
    cells += [number(way.ruler or 0.0, language)] if _rulers(answer) else []
    if any(one.way.times != 1.0 for one in answer.rows):
        cells.append(number(way.times, language))
    cells.append(number(row.worst, language, 2))
    cells += [_cell(row.errors, answer.main, language)] if answer.main != answer.worst else []
    return [*cells, fixed(way.minutes, 0, language)]


def _cell(errors: Mapping[str, float], name: str, language: str) -> str:
    return number(errors.get(name, float("nan")), language, 2)


def _machine(answer: Answer) -> Any:
    """Return the table of the seconds on the machine, by what a user asks for."""
    language, words = answer.scene.language, _words(answer)
    counts = sorted({one.positions for one in answer.machine})
    table = _plain(words["machine seconds"])
    for head in (words["asked"], *map(str, counts)):
        table.add_column(head, justify="right" if head.isdecimal() else "left")
    for what in dict.fromkeys(one.what for one in answer.machine):
        row = {one.positions: one.seconds for one in answer.machine if one.what == what}
        table.add_row(words[f"time {what}"], *(_second(row.get(n), language) for n in counts))
    return table


def _second(seconds: Seconds | None, language: str) -> str:
    if seconds is None:
        return ""
    return f"{DOUBTFUL if seconds.doubtful else ''}{number(seconds.least, language, 2)}"


def _load(answer: Answer) -> str:
    """Return how the seconds were taken, and whether the machine was busy."""
    return f"{_words(answer)['timed']} {busy(answer.load, answer.scene.language)}".rstrip()


def busy(load: Load | None, language: str) -> str:
    """Return that the machine was busy while it timed, "" if it was not."""
    if load is None or not load.busy:
        return ""
    share = number(100.0 * load.elsewhere, language, 2)
    return WORDS[language]["busy"].format(share=share, scattered=load.scattered, calls=load.calls)

"""A study for a terminal: tables of rich, sentences behind them."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from graphic_tmm.accuracy.answer_text import DOUBTFUL, answer_text, parts, step_name
from graphic_tmm.accuracy.lessons import along, divisions
from graphic_tmm.accuracy.measure import NOISE, Measurement
from graphic_tmm.accuracy.settings import GRID, POSITIONS, dividing, own_parts
from graphic_tmm.accuracy.study import Study
from graphic_tmm.accuracy.words import WORDS, counted
from graphic_tmm.language.numbers import fixed, number

KNOWN, LEVEL = 0.5, 0.25
"""A slope is printed if its error is below the first; it is zero if below the second. Both chosen by eye."""
TOP = 3
"""So many steps of a construction are named for each quantity."""


def text_report(study: Study) -> list[Any]:
    """Return what rich prints of a study on a terminal, in order; the answer comes first."""
    from rich.text import Text

    words = WORDS[study.scene.language]
    made: list[Any] = [*answer_text(study.answer), Text("")]
    made.append(Text(words["measure"].format(trials=study.trials)))
    made += [_divided(study, name) for name in study.quantities if _measured(study, name)]
    made += [_varied_table(study), _steps(study), Text(_choice(study))]
    for heading, lines in (
        ("slopes", slopes(study)),
        ("optima", best_numbers(study)),
    ):
        told = list(lines)
        if told:
            made += [Text(words[heading], style="bold"), *(Text(f"• {line}") for line in told)]
    return [*made, *(Text(words["left out"].format(text=text)) for text in study.left_out)]


def _choice(study: Study) -> str:
    """Return what it takes to choose the scale factors."""
    language, work = study.scene.language, study.choice
    minutes = number(work.minutes, language)
    told = {"simplicity": work.simplicity, "minutes": minutes, "symbol": work.symbol}
    return WORDS[language]["choice"].format(**told)


def _measured(study: Study, name: str) -> bool:
    return any(run.quantity == name and run.axis in dividing() for run in study.runs)


def _table(title: str, heads: Sequence[str]) -> Any:
    from rich.markup import escape
    from rich.table import Table

    table = Table(title=escape(title), title_justify="left")
    for k, head in enumerate(heads):
        table.add_column(escape(head), justify="left" if k == 0 else "right", no_wrap=True)
    return table


def _divided(study: Study, name: str) -> Any:
    """Return the table of a quantity: error by number of positions and hand, and what they cost."""
    language, words = study.scene.language, WORDS[study.scene.language]
    hands = [h for h in (*GRID, study.hand) if along(study.runs, name, h)]
    hands = list(dict.fromkeys(hands))
    rows: dict[int, dict[str, Measurement]] = {}
    for hand in hands:
        for run in along(study.runs, name, hand):
            rows.setdefault(divisions(run), {})[hand] = run
    axis = next(run.axis for row in rows.values() for run in row.values())
    heads = [words[axis], *(words[hand] for hand in hands), "S", "X", words["minutes"]]
    heads += [words["quartiles"]] if study.timed else []
    table = _table(f"{words[name]}: {words['error']}", heads)
    least = {hand: min(along(study.runs, name, hand), key=_order) for hand in hands}
    for count, row in sorted(rows.items()):
        one = next(iter(row.values()))
        cells = [_cell(row.get(hand), least[hand], language) for hand in hands]
        work = [f"{one.work.simplicity}", f"{one.work.exactitude}"]
        work.append(fixed(one.work.minutes, 0, language))
        work += [_quartiles(one, language)] if study.timed else []
        table.add_row(f"{count}", *cells, *work)
    return table


def _order(run: Measurement) -> tuple[bool, float]:
    return run.error != run.error, run.error


def _cell(run: Measurement | None, least: Measurement, language: str) -> str:
    if run is None:
        return ""
    text = number(run.error, language, 3)
    return f"[bold]{text}[/bold]" if run is least and run.error > 0.0 else text


def _quartiles(run: Measurement, language: str) -> str:
    if run.seconds is None:
        return ""
    least, low, _, high = (number(1e3 * x, language, 2) for x in run.seconds[:4])
    return f"{DOUBTFUL if run.seconds.doubtful else ''}{least} ({low}…{high})"


def _varied_table(study: Study) -> Any:
    """Return the table of settings in which one thing is varied."""
    language, words = study.scene.language, WORDS[study.scene.language]
    runs = [run for run in study.runs if run.axis not in dividing()]
    names = [name for name in study.quantities if any(run.quantity == name for run in runs)]
    heads = [words["axis"], words["value"], *(words[name] for name in names)]
    table = _table(words["others"].format(hand=words[study.hand]), heads)
    own = {name: _own_minutes(study, name) for name in names}
    before = ""
    for axis, value in dict.fromkeys((run.axis, run.value) for run in runs):
        row = {run.quantity: run for run in runs if (run.axis, run.value) == (axis, value)}
        cells = [_other(row.get(name), own[name], language) for name in names]
        if axis != before:
            table.add_section()
        table.add_row(words[axis] if axis != before else "", value_name(value, language), *cells)
        before = axis
    return table


def _own_minutes(study: Study, name: str) -> float:
    count = own_count(study)
    row = [r for r in along(study.runs, name, "exact") if divisions(r) == count]
    return row[0].work.minutes if row else float("nan")


def _other(run: Measurement | None, minutes: float, language: str) -> str:
    if run is None:
        return ""
    text = number(run.error, language, 3)
    if run.axis == "trials" and run.errors.spread > NOISE:
        text += f" ± {number(run.errors.spread, language, 1)}"
    if abs(run.work.minutes - minutes) > 0.5:
        text += f" ({fixed(run.work.minutes, 0, language)})"
    return text


def value_name(value: str, language: str) -> str:
    """Return a value on an axis in words, or the number with the decimal sign of the language."""
    text = WORDS[language].get(value)
    return text if text is not None else number(float(value), language, 5)


def _steps(study: Study) -> Any:
    """Return the table of the sources and steps that cost most accuracy."""
    from rich.markup import escape

    language, words = study.scene.language, WORDS[study.scene.language]
    heads = [words["quantity"], words["hand"], words["sources"], words["step"]]
    table = _table(words["shares"], heads)
    for column in table.columns[2:]:
        column.no_wrap, column.justify = False, "left"
    for origin in study.answer.origins:
        for quantity, of in origin.of.items():
            steps = (
                f"{number(100.0 * share.share, language, 2)} %: {step_name(origin, share, language)}"
                for share in of.steps[:TOP]
            )
            each = (
                f"{words[f'from {name}']} {number(100.0 * share, language, 2)} %"
                for name, share in parts(of)
            )
            table.add_row(
                words[quantity],
                words[origin.hand],
                escape(", ".join(each)),
                escape("\n".join(steps)),
            )
    return table


def slopes(study: Study) -> Iterator[str]:
    """Yield how the exact hand's error falls with the number of positions, and how its costs grow."""
    language, words = study.scene.language, WORDS[study.scene.language]
    for one in study.fitted:
        width = one.error.half_width()
        if not width < KNOWN:
            continue
        spread = one.seconds.half_width()
        form = "slope timed" if spread < KNOWN else "slope"
        form = form if one.error.slope < -LEVEL else "slope flat"
        yield words[form].format(
            quantity=words[one.quantity],
            error=number(one.error.slope, language, 3),
            width=number(width, language, 1),
            minutes=number(one.minutes.slope, language, 3),
            seconds=number(one.seconds.slope, language, 2),
            spread=number(spread, language, 1),
        )


def best_numbers(study: Study) -> Iterator[str]:
    """Yield at which number of positions each hand errs least."""
    language, words = study.scene.language, WORDS[study.scene.language]
    for one in study.optima:
        form = "optimum" if len(one.sure) > 1 else "optimum sure"
        form = "optimum edge" if not one.inside else form
        form = "optimum flat" if one.flat else form
        yield words[form].format(
            quantity=words[one.quantity],
            hand=words[one.hand],
            best=counted(divisions(one.best), one.axis, language),
            error=number(one.best.error, language, 2),
            low=min(one.sure),
            high=max(one.sure),
        )


def own_count(study: Study) -> int:
    """Return into how many parts the scene's own setting divides the drawing."""
    divided = dividing()
    axis = next((run.axis for run in study.runs if run.axis in divided), POSITIONS.name)
    return own_parts(study.scene, axis)

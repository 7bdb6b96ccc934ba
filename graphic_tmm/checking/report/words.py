"""The words of a report, Russian and English; and text of others made fit to be shown.

Titles, plans, letters, units and notes come from a scene or from a file of readings: they are data, and every
report passes them through `shown` before it escapes them for its own medium.
"""

from __future__ import annotations

from graphic_tmm.language.captions import CAPTIONS, UNITS_RU

LONGEST = 80
"""Of a name, a letter or a unit so many characters are shown."""
LONGEST_SENTENCE = 600
"""Of a sentence (a mistake's, a note) so many characters are shown."""
PLANS = frozenset(
    {
        *("positions", "extremes", "velocities", "accelerations", "diagrams", "flywheel", "forces"),
        *("lever", "engine", "cam", "gear", "sliding", "planetary", "results"),
    }
)
"""Plans that have a name for people; any other is called as the reading calls it."""

WORDS: dict[str, dict[str, str]] = {
    "en": {
        "check": "Check: {title}",
        "who": "Scene: {scene}. Hand: {hand}.",
        "counts": "Readings: {all}. Fine {fine}, doubtful {doubtful}, wrong {wrong}.",
        "none": "There are no readings.",
        "all right": "Nothing is wrong.",
        "explained": "The wrong ones are explained by: {mistakes}.",
        "explains": "{name} ({count} of {wrong})",
        "the same": "{name} (the same: {like})",
        "more": "{count} more",
        "left over": "Not explained: {count}{lines}.",
        "at lines": " (lines of the file: {lines})",
        "unexplained": "No known mistake explains the wrong ones.",
        "fine": "fine",
        "doubtful": "doubtful",
        "wrong": "wrong",
        "line": "line",
        "position": "pos.",
        "segment": "segment",
        "found": "found",
        "due": "due",
        "unit": "unit",
        "deviation": "off by",
        "percent": "% of plan",
        "farther": "farther, %",
        "verdict": "verdict",
        "step": "step",
        "own": "own, mm",
        "follows": "follows from",
        "follows from": "{segment}",
        "follows from line": "{segment} (line {line})",
        "not sure": "Line {line}: {segment} is not judged: no digit of the figure due is sure.",
        "mistakes": "Likely mistakes",
        "mistake": "mistake",
        "says": "what was done",
        "count": "wrong ones",
        "rest": "left, %",
        "lines": "lines",
        "notes": "Notes",
        "not listed": "{count} more are not listed here, none of them worse; Markdown, JSON and HTML have all.",
        "chart": "Deviations in % of the longest vector of the plan",
        "beyond": "an arrow: beyond the axis",
        "legend": "Line: of the file. Found, due and off by are in mm where no unit stands. "
        "% of plan: of its longest vector. "
        "Farther: so many of the hand's own drawings are farther off. Step: where the error was made. "
        "Own: the error that this step made itself. "
        "Follows from: the earlier reading whose deviation it has, though it is found from it rightly. "
        "Left: what the mistake leaves of the deviations that it explains.",
    },
    "ru": {
        "check": "Проверка: {title}",
        "who": "Сцена: {scene}. Рука: {hand}.",
        "counts": "Отсчётов: {all}. Верных {fine}, сомнительных {doubtful}, неверных {wrong}.",
        "none": "Отсчётов нет.",
        "all right": "Неверных нет.",
        "explained": "Неверные объясняет: {mistakes}.",
        "explains": "{name} ({count} из {wrong})",
        "the same": "{name} (то же: {like})",
        "more": "ещё {count}",
        "left over": "Не объяснено: {count}{lines}.",
        "at lines": " (строки файла: {lines})",
        "unexplained": "Ни одна известная ошибка неверных отсчётов не объясняет.",
        "fine": "верно",
        "doubtful": "сомнительно",
        "wrong": "неверно",
        "line": "№",
        "position": "пол.",
        "segment": "отрезок",
        "found": "снято",
        "due": "должно",
        "unit": "ед.",
        "deviation": "откл.",
        "percent": "% плана",
        "farther": "дальше, %",
        "verdict": "вывод",
        "step": "шаг",
        "own": "своя, мм",
        "follows": "следует из",
        "follows from": "{segment}",
        "follows from line": "{segment} (№ {line})",
        "not sure": "Строка {line}: {segment} не проверяется: у должной величины нет ни одной верной цифры.",
        "mistakes": "Вероятные ошибки",
        "mistake": "ошибка",
        "says": "что сделано",
        "count": "неверных",
        "rest": "остаток, %",
        "lines": "строки",
        "notes": "Замечания",
        "not listed": "Ещё {count} здесь не показаны, худших среди них нет; все есть в Markdown, JSON и HTML.",
        "chart": "Отклонения в % наибольшего вектора плана",
        "beyond": "стрелка: за пределами оси",
        "legend": "№: строка файла. Снято, должно и отклонение в мм, если единица не указана. "
        "% плана: от его наибольшего вектора. "
        "Дальше: столько собственных чертежей этой руки отклоняются сильнее. "
        "Шаг: где сделана ошибка. Своя: ошибка, внесённая самим этим шагом. "
        "Следует из: более ранний отсчёт, отклонение которого перешло сюда, хотя найдено из него верно. "
        "Остаток: сколько отклонений, которые ошибка объясняет, после неё остаётся.",
    },
}


def shown(text: str, most: int = LONGEST) -> str:
    r"""Return text as it may be shown: on one line, what is not printable as its escape, cut to ``most``.

    >>> shown(" a\n\x1b[31mb"), shown("abcdef", 4)
    ('a \\x1b[31mb', 'abc…')
    """
    line = " ".join(text.split())[: most + 1]
    line = "".join(sign if sign.isprintable() else ascii(sign)[1:-1] for sign in line)
    return line if len(line) <= most else f"{line[: most - 1]}…"


def plan_name(plan: str, language: str) -> str:
    """Return what a plan is called in a language; as the reading calls it if there is no such name."""
    if not plan:
        return CAPTIONS[language]["results"]
    return CAPTIONS[language][plan] if plan in PLANS else shown(plan)


def unit_name(unit: str, language: str) -> str:
    """Return a unit in a language; as it was written if it is no unit of the package."""
    return UNITS_RU.get(unit, shown(unit)) if language == "ru" else shown(unit)

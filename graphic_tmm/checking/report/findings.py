"""What the readings tell, in sentences: what matters first, how sure it is, what it explains."""

from __future__ import annotations

from graphic_tmm.checking.cells import segment_text
from graphic_tmm.checking.records import (
    DOUBTFUL,
    MISTAKE,
    SLIP,
    UNKNOWN,
    WRONG,
    Judged,
    Lesson,
    Likely,
    Report,
    Sight,
)
from graphic_tmm.checking.report.rows import (
    LONGEST_SENTENCE,
    WORDS,
    counts,
    plan_name,
    printable_text,
    runs,
)
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import fixed
from graphic_tmm.scene.captions import view_name

NAMED = 5
"""So many findings are told; the JSON has all of them."""
LEAST_LEFT = 0.005
"""What rounds to 0 % is nothing left."""
ENOUGH = 0.8
"""From here on a mistake is named; below it may be: of names so sure 19 of 20 are to be right."""
SURE = 0.995
"""From here on a finding is said to be sure to 99 %: it is never said to be certain."""


RAREST = 0.1
"""%: of honest drawings so few are told to be as far off; fewer are not."""


def headline(report: Report) -> str:
    """Return what matters, in one sentence."""
    if report.sight is None:
        return _verdict(report)
    return f"{_verdict(report)} {_seen(report.sight, report.language)}"


def _verdict(report: Report) -> str:
    words = WORDS[report.language]
    if not report.readings:
        return words["none"]
    if report.mistakes and not idle(report):
        return finding(report.mistakes[0], report.language)
    if report.wrong:
        return _begin(report)
    if report.whole is not None:
        return words["only whole"]
    if report.sight is not None and not report.sight.whole:
        return words["seen right"]
    doubtful = any(one.verdict == DOUBTFUL for one in report.readings)
    return words["look again" if doubtful else "all right"]


def idle(report: Report) -> bool:
    """Whether the first mistake, which is not sure, has nothing to do with what is wrong."""
    first = report.mistakes[0]
    wrong = {one.taken.plan for one in report.readings if one.verdict == WRONG}
    shown = not wrong or first.plan in ("", *wrong) or explained(report, first) > 0
    return first.kind == MISTAKE and not sure(first) and not shown


def _seen(sight: Sight, language: str) -> str:
    """Return what a photograph showed: of how many points how many, of which plans nothing is said."""
    words = WORDS[language]
    plans = []
    for one in sight.plans:
        seen = one.asked - len(one.unseen) - len(one.partly)
        told = words["plans seen"].format(
            name=view_name(one.plan, language), seen=seen, of=one.asked
        )
        if len(one.unseen) == one.asked:
            told += words["nothing said"]
        elif one.unseen:
            told += words["unseen plans"].format(positions=", ".join(one.unseen))
        if one.partly:
            told += words["not whole"].format(positions=", ".join(one.partly))
        plans.append(told)
    counted = words["points seen"].format(points=sight.points, of=sight.of)
    return f"{counted} {'; '.join(plans)}."


def summary(report: Report) -> str:
    """Return how many readings are fine, doubtful, wrong; the whole; how many wrong no finding explains."""
    words = WORDS[report.language]
    if not report.readings:
        return ""
    said = [words["counts"].format(all=len(report.readings), **counts(report))]
    if (whole := report.whole) is not None:
        due = fixed(whole.due, 1, report.language)
        key = "whole" if whole.doubtful > whole.due else "whole alone"
        said.append(words[key].format(doubtful=whole.doubtful, of=whole.of, due=due))
    left = unexplained(report)
    if 0 < len(left) < report.wrong:
        lines = runs([one.taken.line for one in left])
        told = words["left over"].format(count=len(left), lines=words["at lines"])
        said.append(told.format(lines=lines) if lines else told.partition(" (")[0] + ".")
    return " ".join(said)


def finding(one: Likely, language: str) -> str:
    """Return a finding as a sentence; what a slip or something unknown says is a sentence by itself."""
    speech, words = speaking(language), WORDS[language]
    says = [one.says or speech(one.name), *map(speech, one.like)]
    told = "; ".join(
        filter(None, (printable_text(text, LONGEST_SENTENCE).rstrip(".") for text in says))
    )
    if one.kind in (SLIP, UNKNOWN):
        return f"{told[:1].upper()}{told[1:]}."
    kind = one.kind if one.kind in words else MISTAKE
    if kind == MISTAKE and one.like:
        kind = "alike" if sure(one) else "perhaps alike"
    elif kind == MISTAKE and not sure(one):
        kind = "perhaps"
    return words[kind].format(says=told)


def sure(one: Likely) -> bool:
    """Whether a finding is as good as sure, or nobody has told how sure it is."""
    return one.chance <= 0.0 or one.chance >= ENOUGH


def finding_rows(report: Report) -> tuple[str, ...]:
    """Return what the headline leaves: of the first finding its details, of the others all."""
    found = []
    for k, one in enumerate(report.mistakes[:NAMED]):
        told = [] if k == 0 and not idle(report) else [finding(one, report.language)]
        more = details(report, one)
        told += [more[:1].upper() + more[1:] + "."] if more else []
        found += [" ".join(told)] if told else []
    if (left := len(report.mistakes) - NAMED) > 0:
        found.append(WORDS[report.language]["more"].format(count=left))
    return tuple(found)


def details(report: Report, one: Likely) -> str:
    """Return what a finding explains, how sure it is: for who asks; "" if nothing is to be told."""
    words, language = WORDS[report.language], report.language
    told = []
    if count := explained(report, one):
        told.append(words["explains"].format(count=count, wrong=report.wrong))
        if one.rest >= LEAST_LEFT:
            told.append(words["leaves"].format(rest=fixed(100 * one.rest, 0, language)))
    if lines := runs(one.lines):
        told.append(words["at lines"].format(lines=lines))
    if one.chance > 0.0 and one.kind == UNKNOWN:
        most = fixed(max(100 * (1.0 - one.chance), RAREST), 1, language)
        told.append(words["rare"].format(percent=most))
    elif one.chance > 0.0:
        percent = fixed(100 * min(one.chance, SURE), 0, language) if one.chance < SURE else "99"
        told.append(words["sure"].format(percent=percent))
    return "; ".join(told)


def explained(report: Report, mistake: Likely) -> int:
    """Return how many of the wrong readings a mistake explains."""
    lines = set(mistake.lines)
    return sum(one.verdict == WRONG and one.taken.line in lines for one in report.readings)


def unexplained(report: Report) -> tuple[Judged, ...]:
    """Return the wrong readings that no mistake of the report explains."""
    lines = {line for mistake in report.mistakes for line in mistake.lines}
    wrong = (one for one in report.readings if one.verdict == WRONG)
    return tuple(one for one in wrong if one.taken.line not in lines)


def where(lesson: Lesson, language: str) -> dict[str, str]:
    """Return the words that tell a step: the view it is drawn in, its number, its letter."""
    number = printable_text(lesson.step.partition(" ")[0])
    called = lesson.title or view_name(lesson.view, language)
    view = printable_text(called) or plan_name(lesson.plan, language)
    return {"plan": view, "number": number, "letter": printable_text(lesson.letter)}


def _begin(report: Report) -> str:
    """Return that no known mistake explains the wrong readings, and what is first to be looked at."""
    words = WORDS[report.language]
    wrong = [one for one in report.readings if one.verdict == WRONG]
    named = 0 if report.mistakes else None  # what has nothing to do with it is where nobody begins
    if lesson := next((one for one in report.lessons if named not in one.names), None):
        return words["begin"].format(**where(lesson, report.language))
    return words["begin at"].format(
        segment=printable_text(segment_text(wrong[0].taken.segment, report.language)),
        plan=plan_name(wrong[0].taken.plan, report.language),
    )

"""What a report shows of its readings: lessons on the steps that are blamed, tables of what follows."""

from __future__ import annotations

from support.reports import explaining, judged, report

from graphic_tmm.checking.records import (
    DOUBTFUL,
    INSTRUMENT,
    MISTAKE,
    UNKNOWN,
    WRONG,
    Lesson,
    Likely,
)
from graphic_tmm.checking.report.parts import doubtful_parts, wrong_parts


def likely(kind: str = MISTAKE) -> Likely:
    return explaining(2, 3)._replace(kind=kind)


def lesson_of(step: str, **more: object) -> Lesson:
    return Lesson("velocities", step, step.partition(" ")[2], f"Do {step}.")._replace(**more)  # type: ignore[arg-type]


def test_what_follows_from_a_named_mistake_has_no_lesson_of_its_own() -> None:
    rows = [
        judged(line=2, verdict=WRONG, step="3 ab"),
        judged(line=3, verdict=WRONG, step="7 pb"),
        judged(line=4, verdict=WRONG, step="9 pc"),
    ]
    lessons = (
        lesson_of("3 ab"),
        lesson_of("7 pb"),
        lesson_of("8 n", names=(0,)),
        lesson_of("9 pc"),
    )
    found = likely()._replace(lines=(2, 3), step="8 n")
    made = report(*rows, mistakes=[found])._replace(lessons=lessons)
    first, follows, other = wrong_parts(made)
    assert first.heading.endswith("step 8: n")
    assert first.grid is None
    assert other.heading.endswith("step 9: pc")
    assert follows.heading.endswith("wrong for the same reason")
    assert follows.grid is not None
    assert [cells[0] for cells in follows.grid.rows] == ["2", "3"]
    for other in (found._replace(kind=UNKNOWN), found._replace(chance=0.5)):
        unsure = made._replace(mistakes=(other,))
        assert [part.heading[-2:] for part in wrong_parts(unsure)] == [" n", "ab", "pb", "pc"]


def test_a_second_mistake_stands_under_its_own_head() -> None:
    """What the first does not explain is not told to be wrong for it."""
    rows = [judged(line=k, verdict=WRONG, step=step) for k, step in ((2, "3 ab"), (3, "7 pb"))]
    rows += [judged(line=4, verdict=WRONG, step="9 pc")]
    lessons = (lesson_of("2 n", names=(0,)), lesson_of("7 pb", names=(1,)), lesson_of("9 pc"))
    first = likely()._replace(lines=(2,), step="2 n")
    second = first._replace(lines=(3, 4), step="7 pb")
    made = report(*rows, mistakes=[first, second])._replace(lessons=lessons)
    parts = wrong_parts(made)
    assert [part.heading.rpartition(": ")[2] for part in parts] == [
        "n",
        "wrong for the same reason",
        "pb",
        "wrong for the same reason",
    ]
    lines = [[cells[0] for cells in part.grid.rows] for part in parts if part.grid is not None]
    assert lines == [["2"], ["3"], ["4"]]


def test_every_reading_stands_in_just_one_part() -> None:
    rows = [judged(line=k, verdict=WRONG, step=("7 pb", "", "8 x")[k % 3]) for k in range(1, 10)]
    rows += [judged(line=k, verdict=DOUBTFUL) for k in (10, 11)]
    table = judged("R12", line=12, verdict=WRONG)
    lessons = (lesson_of("7 pb"), lesson_of("2 R_{12}", segment="R12"))
    made = report(*rows, table)._replace(lessons=lessons)
    parts = (*wrong_parts(made), *doubtful_parts(made))
    lines = [int(cells[0]) for part in parts if part.grid is not None for cells in part.grid.rows]
    assert sorted(lines) == list(range(1, 13))
    (forces,) = (part for part in parts if part.heading.endswith("R_{12}"))
    assert forces.grid is not None
    assert [cells[0] for cells in forces.grid.rows] == ["12"]


def test_a_lesson_says_in_which_reading_a_mistake_shows() -> None:
    seen = judged("ab", found=33.0, due=57.8, verdict=WRONG)
    lesson = lesson_of("8 (AB)", position="3", shows=seen)
    (part, _) = wrong_parts(report(seen)._replace(lessons=(lesson,)))
    assert part.told[-1] == "Position 3. It shows in ab: you have 33.0 mm; due is 57.8 mm."


def test_what_is_calculated_in_another_unit_than_it_was_read_has_both_figures() -> None:
    def told(unit: str) -> str:
        seen = judged("ab", found=3.0, due=5.0, verdict=WRONG)._replace(unit=unit)
        lesson = lesson_of("2 ab", calculation="ab = 2·4 = 8 mm", shown=seen)
        return wrong_parts(report()._replace(lessons=(lesson,)))[0].told[-1]

    assert told("mm") == "It should be: ab = 2·4 = 8 mm. You have 3.0 mm."
    assert told("m/s") == "It should be: ab = 2·4 = 8 mm. You have 3 m/s; due is 5 m/s."


def test_readings_of_a_sure_mistake_of_no_step_have_no_lessons_of_theirs() -> None:
    """A crank that stands amiss, signs, a copy: what follows is a table, the mistake said once."""
    rows = [judged(line=k, verdict=WRONG, step=step) for k, step in ((2, "3 ab"), (3, "7 pb"))]
    rows += [judged(line=4, verdict=WRONG, step="9 pc")]
    lessons = (lesson_of("3 ab"), lesson_of("7 pb"), lesson_of("9 pc", names=(1,)))
    crank = explaining(2, 3)._replace(chance=0.99)
    other = explaining(4)._replace(chance=0.9, step="9 pc", says="pc is turned")
    made = report(*rows, mistakes=[crank, other])._replace(lessons=lessons)
    table, lesson = wrong_parts(made)
    assert (table.heading, table.told) == ("Velocity plan: wrong for the same reason", ())
    assert table.grid is not None
    assert [cells[0] for cells in table.grid.rows] == ["2", "3"]
    assert lesson.heading.endswith("step 9: pc")
    lesson, table = wrong_parts(
        made._replace(
            mistakes=(other._replace(lines=(4,)), crank),
            lessons=(*lessons[:2], lesson_of("9 pc", names=(0,))),
        )
    )
    assert lesson.heading.endswith("step 9: pc")
    assert table.told == ("Most likely: the speed was divided.",)
    for unlike in (crank._replace(kind=UNKNOWN), crank._replace(chance=0.5)):
        parts = wrong_parts(made._replace(mistakes=(unlike, other)))
        assert [part.heading[-2:] for part in parts] == ["pc", "ab", "pb"]
    copy = made._replace(mistakes=(crank._replace(kind=INSTRUMENT), other))
    assert [part.grid is not None for part in wrong_parts(copy)] == [True, True]
    assert len(wrong_parts(copy)) == 2

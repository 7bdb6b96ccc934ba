"""What matters first: a sentence for every kind of finding, in both languages, and how sure it is."""

from __future__ import annotations

import re

import pytest
from support.reports import LANGUAGES, explaining, judged, loaded, printed, report

from graphic_tmm.checking.records import (
    DOUBTFUL,
    INSTRUMENT,
    MISTAKE,
    SLIP,
    UNKNOWN,
    UNSEEN,
    WRONG,
    Lesson,
    Likely,
    Whole,
)
from graphic_tmm.checking.report.findings import details, finding, finding_rows, headline, summary
from graphic_tmm.checking.report.html import html_report
from graphic_tmm.checking.report.json import json_report
from graphic_tmm.checking.report.markdown import markdown_report
from graphic_tmm.checking.report.parts import wrong_parts

WHOLE = (SLIP, UNKNOWN)
"""What says a whole sentence of its own."""
KINDS = (MISTAKE, SLIP, INSTRUMENT, UNKNOWN, UNSEEN)
SAYS = "шаг 10: πn3 вычислено с BC"


def likely(kind: str = MISTAKE, *, like: tuple[str, ...] = (), chance: float = 0.0) -> Likely:
    return Likely("name", SAYS, (2, 3), 3, 0.04, like, kind, chance=chance)


@pytest.mark.parametrize("language", LANGUAGES)
def test_every_kind_has_a_sentence_of_its_own(language: str) -> None:
    told = [finding(likely(kind), language) for kind in KINDS if kind not in WHOLE]
    told.append(finding(likely(chance=0.79), language))
    told.append(finding(likely(like=("other", "third.")), language))
    told.append(finding(likely(like=("other", "third."), chance=0.06), language))
    assert len(set(told)) == len(KINDS) - len(WHOLE) + 3
    assert finding(likely(chance=0.8), language) == told[0]
    for text in told:
        assert SAYS in text
        assert text.endswith(".")
        assert not re.search(r"[{}]|\.\.", text)
        own = text.replace(SAYS, "").replace("other", "").replace("third", "")
        assert bool(re.search("[А-Яа-я]", own)) is (language == "ru")
        assert bool(re.search("[A-Za-z]", own)) is (language == "en")
    assert f"{SAYS}; other; third." in told[-1]


@pytest.mark.parametrize("kind", [SLIP, UNKNOWN])
def test_a_slip_and_what_is_unknown_are_told_by_their_own_sentence(kind: str) -> None:
    one = likely(kind)._replace(says="only pb is off")
    assert finding(one, "en") == finding(one, "ru") == "Only pb is off."


def test_an_instrument_is_no_mistake() -> None:
    assert finding(likely(INSTRUMENT), "en").startswith("There is no mistake in the construction")
    assert finding(likely(INSTRUMENT), "ru").startswith("Ошибки в построении нет")


def test_a_finding_without_a_sentence_is_told_by_its_name() -> None:
    assert finding(explaining(2)._replace(says=""), "ru") == (
        "Скорее всего, дело вот в чём: ω/r вместо ω·r."
    )


@pytest.mark.parametrize(
    ("chance", "told"), [(0.934, "93"), (0.5, "50"), (0.9999, "99"), (1.0, "99"), (0.996, "99")]
)
def test_how_sure_it_is_is_told_and_never_certain(chance: float, told: str) -> None:
    made = report(judged(verdict=WRONG))
    assert f"sure to {told} %" in details(made, likely(chance=chance))
    assert "sure" not in details(made, likely())


def test_the_details_count_what_is_explained() -> None:
    made = report(*(judged(line=k, verdict=WRONG) for k in (2, 3, 7)), mistakes=[likely()])
    assert finding_rows(made) == (
        "Explains 2 of 3 wrong readings; leaves 4 % of their deviations; lines of the file: 2–3.",
    )
    assert (
        summary(made)
        == "Readings: 3. Fine 0, doubtful 0, wrong 3. Not explained: 1 (lines of the file: 7)."
    )
    assert "Not explained" not in summary(made._replace(mistakes=()))


def test_of_many_findings_some_are_told_and_the_others_counted() -> None:
    made = report(judged(verdict=WRONG), mistakes=[likely(kind) for kind in KINDS + KINDS])
    assert len(finding_rows(made)) == 6
    assert finding_rows(made)[-1].endswith(": 5.")
    assert len(loaded(json_report(made))["mistakes"]) == 10


@pytest.mark.parametrize("language", LANGUAGES)
def test_what_matters_is_said_first_in_every_form(language: str) -> None:
    wrong, doubtful = judged(verdict=WRONG), judged(verdict=DOUBTFUL)
    lesson = Lesson("velocities", "7 pb", "pb", "Measure pb.")
    blamed = wrong._replace(step="7 pb")
    reports = [
        report(wrong, language=language, mistakes=[likely()]),
        report(blamed, language=language)._replace(lessons=(lesson,)),
        report(wrong, language=language),
        report(doubtful, language=language),
        report(judged(), language=language),
        report(language=language),
    ]
    heads = [headline(made) for made in reports]
    assert len(set(heads)) == len(heads)
    assert "pb" in heads[1]
    assert "7" in heads[1]
    for made, head in zip(reports, heads, strict=True):
        for text in (markdown_report(made), html_report(made), printed(made, 400)):
            assert head in text
            assert summary(made) in text
            if made.readings and text.count("17.47") + text.count("17,47"):
                assert text.index(head) < re.search("17[.,]47", text).start()  # type: ignore[union-attr]


def test_json_has_every_field_of_a_finding_and_of_a_lesson() -> None:
    found = Likely("n", "s", (2,), 1, 0.1, ("l",), SLIP, "f", "velocities", "pb", "3", "7 pb", 0.25)
    lesson = Lesson("velocities", "7 pb", "pb", "Measure pb.", "For it.", "pb = 2", "3", True)
    made = loaded(
        json_report(report(judged(verdict=WRONG), mistakes=[found])._replace(lessons=(lesson,)))
    )
    assert made["mistakes"] == [
        {"name": "n", "says": "s", "like": ["l"], "kind": "slip", "family": "f", "plan": "velocities",
         "segment": "pb", "position": "3", "step": "7 pb", "chance": 0.25, "lines": [2], "explains": 1,
         "wrong": 1, "rest": 0.1}
    ]  # fmt: skip
    assert made["lessons"] == [
        {"plan": "velocities", "step": "7 pb", "letter": "pb", "says": "Measure pb.", "why": "For it.",
         "drawn": [], "position": "3", "calculation": "pb = 2", "own_numbers": True}
    ]  # fmt: skip


def test_small_errors_together_are_no_mistake_that_is_sure() -> None:
    made = report(judged(verdict=DOUBTFUL))
    told = details(made, likely(UNKNOWN, chance=0.9971)._replace(lines=()))
    assert told == "of honest drawings 0.3 % at the most are so far off"
    assert "0.1 %" in details(made, likely(UNKNOWN, chance=1.0))


OFF = Whole(rare=1e-4, doubtful=10, due=0.48, of=16)


@pytest.mark.parametrize("language", LANGUAGES)
def test_a_drawing_that_is_off_as_a_whole_is_told_at_the_head(language: str) -> None:
    """In every form, with its figures; and the headline no longer says that all is well."""
    doubtful = [judged(verdict=DOUBTFUL, line=line) for line in range(2, 12)]
    fine = report(*doubtful, language=language)
    whole = fine._replace(whole=OFF)
    assert headline(whole) != headline(fine)
    assert summary(fine) in summary(whole)
    told = re.findall(r"\d+[.,]?\d*", summary(whole).replace(summary(fine), ""))
    figures = [float(one.replace(",", ".")) for one in told]
    assert sorted(figures) == [0.5, 10, 16, 99.9]
    for text in (markdown_report(whole), html_report(whole), printed(whole, 400)):
        assert summary(whole).split(".")[-2].strip()[-30:] in " ".join(text.split())
    assert loaded(json_report(whole))["whole"] == OFF._asdict()
    assert loaded(json_report(fine))["whole"] is None


def test_what_is_wrong_goes_before_the_whole() -> None:
    rows = (judged(verdict=WRONG), judged(verdict=DOUBTFUL, line=3))
    assert headline(report(*rows)._replace(whole=OFF)) == headline(report(*rows))


@pytest.mark.parametrize(("language", "never"), [("en", "Nothing is wrong"), ("ru", "Ошибок нет")])
def test_what_is_doubtful_is_not_told_to_be_right(language: str, never: str) -> None:
    doubtful = report(judged(verdict=DOUBTFUL), language=language)
    assert never not in headline(doubtful)
    assert never in headline(report(judged(), language=language))


def test_an_unsure_mistake_that_has_nothing_to_do_with_what_is_wrong_is_no_headline() -> None:
    """It stands below; where to begin stands first."""
    idle = likely(chance=0.24)._replace(lines=(), plan="diagrams", segment="S")
    made = report(judged("pb", verdict=WRONG), mistakes=[idle])
    assert headline(made).startswith("No known mistake explains what is wrong; begin with pb")
    assert finding_rows(made)[0].startswith(
        f"Perhaps, but the readings do not say it for sure: {SAYS}"
    )
    for shown in (
        idle._replace(plan="velocities", segment="ab"),
        idle._replace(plan="", segment=""),
        idle._replace(lines=(2,)),
        idle._replace(chance=0.9),
    ):
        assert SAYS in headline(made._replace(mistakes=(shown,)))
        assert SAYS not in finding_rows(made._replace(mistakes=(shown,)))[0]
    assert SAYS in headline(report(judged(), mistakes=[idle]))
    lessons = (
        Lesson("diagrams", "3 S", "S", "Do S.", names=(0,)),
        Lesson("velocities", "7 pb", "pb", "Do pb."),
    )
    blamed = made._replace(readings=(judged("pb", verdict=WRONG, step="7 pb"),), lessons=lessons)
    assert "begin with pb (Velocity plan, step 7)" in headline(blamed)
    assert [part.heading[-2:] for part in wrong_parts(blamed)] == ["pb", " S"]

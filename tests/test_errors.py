"""Messages of files: what they quote is shortened, their own words never are."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from graphic_tmm.errors import LONGEST, Fault, SceneError, first_of, printable

OWN = "means nothing here; and these are the message's own words, which are rather more than sixty of them"
WORDS = st.text(st.characters(categories=("L", "Nd")), min_size=1, max_size=LONGEST)


def said(message: str) -> str:
    return str(SceneError("f", (Fault("", 0, message),))).removeprefix("f: ")


@given(st.lists(WORDS, max_size=5))
def test_words_between_two_quotes_are_kept(names: list[str]) -> None:
    message = "".join(f'"{name}" {OWN}, ' for name in names) + 'did you mean "B"? write x = "1 mm"'
    assert said(message) == printable(message)


@pytest.mark.parametrize("name", ["a" * 64, "a b " * 16, "a" * 10_000, 'a"b' * 30, "Ж" * 70])
def test_what_is_quoted_is_shortened(name: str) -> None:
    for message in (f'"{name}" {OWN}', f'{OWN}: "{name}" is none of "A", "B"'):
        found = said(message)
        assert len(found) <= len(message) - len(name) + LONGEST + 3
        assert OWN in found
        assert f'"{name[:LONGEST]}..."' in found


def test_of_many_faults_the_first_are_told_and_the_others_counted() -> None:
    faults = [Fault("k", line, "wrong") for line in range(1, 31)]
    told = first_of(faults, 20)
    assert told[:20] == tuple(faults[:20])
    assert told[20:] == (Fault("", 0, "and 10 more faults; put these right first"),)
    assert first_of(faults, 30) == tuple(faults)
    assert first_of(faults[:5], 5, 1000)[-1].message.startswith("and 995 more faults")


@given(st.text())
def test_what_is_told_does_nothing_to_a_terminal(text: str) -> None:
    assert printable(text).isprintable()

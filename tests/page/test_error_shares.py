"""Where errors come from, as the page carries it: beside the plans of a quantity, with the stop of the step."""

from __future__ import annotations

import re
from functools import cache

import pytest
from support import pages
from support.tasks import answered

from graphic_tmm.accuracy.answer import Answer
from graphic_tmm.accuracy.answer_text import parts
from graphic_tmm.accuracy.words import WORDS
from graphic_tmm.page import page as of_page
from graphic_tmm.page.error_shares import error_shares, marked_up
from graphic_tmm.page.page import page, page_data

pytestmark = pytest.mark.slow
SCENE = "slider-diagrams"


def weighed() -> Answer:
    return answered(SCENE, "en")


@cache
def data() -> dict:
    return page_data(*pages.on_sheets(SCENE, "en"))


def test_each_quantity_stands_beside_the_plans_that_give_it() -> None:
    words, views = WORDS["en"], data()["views"]
    made, _ = pages.on_sheets(SCENE, "en")
    beside = {
        one["quantity"]: {views[k]["plan"] for k in one["views"]}
        for one in error_shares(weighed(), made, views)
    }
    assert beside[words["v"]] == {"velocities"}
    assert beside[words["a_diagram"]]
    assert not beside[words["a_diagram"]] & {"positions", "velocities"}


def test_shares_are_those_of_the_hand_at_the_board_and_a_whole() -> None:
    made, _ = pages.on_sheets(SCENE, "en")
    by_student = {WORDS["en"][name]: of for name, of in weighed().origins[0].of.items()}
    assert weighed().origins[0].hand == "student"
    for one in error_shares(weighed(), made, data()["views"]):
        shares = [share for _, share, _ in one["shares"]]
        assert shares == [round(100 * x, 2) for _, x in parts(by_student[one["quantity"]])]
        assert abs(sum(shares) - 100.0) < 0.1
        assert shares[0] == max(shares[:-1], default=shares[0])
        assert one["student"], "the scene's own hand leaves nothing to chance"


def test_the_stop_is_that_in_which_the_step_is_told_first() -> None:
    made, _ = pages.on_sheets(SCENE, "en")
    views, stops = data()["views"], 0
    for one in error_shares(weighed(), made, views):
        if "stop" not in one:
            continue
        stops += 1
        view, n = one["stop"]
        told = [
            "".join(run if isinstance(run, str) else run[0] for run in line.get("text", ()))
            for line in views[view]["pictures"][n]["lines"]
        ]
        assert any(text and text.rstrip(".") in one["most"] for text in told), (one["most"], told)
    assert stops


def test_a_page_has_it_only_if_it_was_weighed() -> None:
    drawn = pages.on_sheets(SCENE, "en")
    plain, more = pages.text(SCENE, "en"), page(*drawn, weighed=weighed())
    assert 'id="accuracy"' not in plain
    assert "accuracyRoom" not in plain
    assert more == page(*drawn, weighed=weighed()), "the same bytes"
    assert len(more.encode()) - len(plain.encode()) < 60_000
    section = re.search(r'<section id="accuracy".*?</section>', more, re.DOTALL)
    assert section is not None
    assert " style=" not in section[0], "the policy of the page refuses it"
    assert "<sub>" not in plain.partition("<main")[0]
    assert "_{" not in section[0]
    assert "&lt;" not in section[0]


def test_sentences_have_their_indices_and_no_elements_of_a_scene(monkeypatch) -> None:
    monkeypatch.setattr(of_page, "sentences", lambda _: ["<b>D_0–D</b> & h_R21"])
    told = page(*pages.on_sheets(SCENE, "en"), weighed=weighed())
    assert "<p>&lt;b&gt;D<sub>0</sub>–D&lt;/b&gt; &amp; h<sub>R21</sub></p>" in told


def test_indices_end_where_a_segment_does() -> None:
    assert marked_up("D_0–D") == "D_{0}–D"

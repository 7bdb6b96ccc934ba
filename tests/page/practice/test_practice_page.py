"""A page that is practised on: the plain page and what practice needs, under the same policy."""

from __future__ import annotations

import base64
import gzip
import hashlib
import json
import re
from pathlib import Path
from typing import Any

import pytest
from support import pages
from support.command import invoke

from graphic_tmm.page.page import page
from graphic_tmm.page.practice.words import WORDS

NAME = "crank-rocker"
FORBIDDEN = ("innerHTML", "eval(", "new Function", "await import(", "fetch(", "__proto__")


def text(name: str, **asked: Any) -> str:
    return page(*pages.on_sheets(name, "en"), **asked)


def data(told: str) -> dict[str, Any]:
    """What a page carries."""
    found = re.search(r'<script type="application/octet-stream" id="data">\s*([\w+/=]+)', told)
    assert found is not None
    carried: dict[str, Any] = json.loads(gzip.decompress(base64.b64decode(found[1])))
    return carried


@pytest.fixture(scope="module")
def practised() -> str:
    return text(NAME, practised=True)


def test_a_page_that_is_not_practised_on_has_nothing_of_it(practised: str) -> None:
    plain = pages.text(NAME, "en")
    # its names are short ones, what it says to the browser is not
    assert "loupe" not in plain
    assert "loupe" in practised
    assert "practice" not in data(plain)
    assert not {"practice", "own"} & set(data(plain)["words"])
    assert len(plain) < len(practised)


def test_it_is_the_plain_page_and_what_practice_needs(practised: str) -> None:
    plain, more = data(pages.text(NAME, "en")), data(practised)
    practice = more.pop("practice")
    more.pop("own")
    assert set(practice["plans"]) >= {"positions", "velocities", "accelerations"}
    assert set(WORDS) <= set(more["words"])
    assert plain["words"].items() <= more.pop("words").items()
    assert more == {key: value for key, value in plain.items() if key != "words"}


def test_the_policy_names_the_program_that_was_written_for_it(practised: str) -> None:
    program = re.search(r'<script type="module">(.*?)</script>', practised, re.DOTALL)
    assert program is not None
    assert ".times(" in program[1]
    digest = base64.b64encode(hashlib.sha256(program[1].encode()).digest()).decode()
    assert f"'sha256-{digest}'" in practised
    assert [word for word in FORBIDDEN if word in program[1]] == []


@pytest.mark.slow
def test_the_same_scene_has_the_same_page_and_another_seed_another(practised: str) -> None:
    assert text(NAME, practised=True) == practised
    posed = [data(text(NAME, practised=True, seed=seed))["practice"] for seed in (1, 2)]
    assert posed[0] != posed[1]
    assert posed[0]["marks"] == data(practised)["practice"]["marks"]


def test_what_cannot_be_practised_has_a_plain_page() -> None:
    assert text("planetary", practised=True) == pages.text("planetary", "en")


@pytest.mark.slow
def test_the_command_writes_it_and_poses_by_its_seed(tmp_path: Path) -> None:
    told = []
    for folder, options in (("plain", ()), ("posed", ("--seed", "3"))):
        done = invoke("page", NAME, "--practice", *options, "-o", str(tmp_path / folder))
        assert done.exit_code == 0, done.output
        told.append(data((tmp_path / folder / f"{NAME}.html").read_text("utf-8")))
    plain, posed = (one.pop("practice") for one in told)
    # the seed poses the plans; it is no other drawing of a hand
    assert told[0] == told[1]
    assert not [task for task in plain["tasks"] if "pose" in task]
    assert len([task for task in posed["tasks"] if task.get("pose")]) == len(
        {task["plan"] for task in plain["tasks"]}
    )


def test_practice_is_small(practised: str) -> None:
    told = json.dumps(data(practised)["practice"], ensure_ascii=False).encode()
    assert len(gzip.compress(told, 9)) < 25_000
    assert len(practised) - len(pages.text(NAME, "en")) < 250_000

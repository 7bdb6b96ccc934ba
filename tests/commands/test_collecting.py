"""Cycles are looked for seldom while a command runs, and as before when it has ended."""

from __future__ import annotations

import gc

import click
import pytest

from graphic_tmm.commands.shared.ending import SELDOM, People


@pytest.mark.parametrize("wrong", [False, True])
def test_the_threshold_is_put_back(wrong: bool) -> None:
    before, seen = gc.get_threshold(), []

    @click.group(cls=People)
    def group() -> None:
        pass

    @group.command()
    def one() -> None:
        seen.append(gc.get_threshold())
        if wrong:
            raise OSError(2, "gone", "there")

    with pytest.raises(SystemExit) as ended:
        group.main(["one"])
    assert (ended.value.code != 0) == wrong
    assert seen == [(SELDOM, *before[1:])]
    assert gc.get_threshold() == before

"""Work travels: it is done by name, and pickled as it is."""

from __future__ import annotations

import pickle

import pytest

from graphic_tmm.classroom.batch.work import Done, Work, done


def doubled(given: int) -> Done:
    return Done({"it.txt": f"{2 * given}"}, ("told",))


def test_work_is_done_by_the_name_of_its_operation() -> None:
    work = Work("one", f"{__name__}:doubled", 21)
    assert done(pickle.loads(pickle.dumps(work))) == Done({"it.txt": "42"}, ("told",))


def test_what_there_is_not_is_an_error() -> None:
    with pytest.raises(AttributeError):
        done(Work("one", f"{__name__}:halved", 21))

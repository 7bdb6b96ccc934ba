"""Planetary orders: what is no train is a clear error."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

import pytest

from graphic_tmm.errors import StructureError
from graphic_tmm.mechanism.tooth_search import choose, search
from graphic_tmm.mechanism.trains import Limits, PlanetaryOrder, module_ratio, scheme_of

C7 = PlanetaryOrder("ring", 0.008, 302.0, ratio=4.55, tolerance=0.003, teeth=(25, None, None))
TWO = replace(C7, scheme="external-internal", teeth=(), ratio=12.0)
NAN = float("nan")


@pytest.mark.parametrize(
    ("change", "says"),
    [
        ({"scheme": "planet"}, 'no scheme "planet"'),
        ({"module": 0.0}, "module = 0.0 is not greater than 0"),
        ({"module": NAN}, "module = nan"),
        ({"module_2": 0.008}, "a single row has one module"),
        ({"alpha": 0.0}, "no pressure angle"),
        ({"alpha": NAN}, "no pressure angle"),
        ({"ha": -1.0}, "h_a"),
        ({"c": -0.1}, "less than 0"),
        ({"speed": 0.0}, "the driving shaft turns at 0.0"),
        ({"speed": float("inf")}, "the driving shaft"),
        ({"driving": "3"}, 'wheel "3" cannot drive'),
        ({"ratio": 0.0}, "a ratio of 0.0 is none"),
        ({"ratio": NAN}, "a ratio of nan"),
        ({"ratio": None}, "neither a ratio nor all tooth numbers"),
        ({"tolerance": -0.1}, "a tolerance of -0.1"),
        ({"tolerance": 1.0}, "a tolerance of 1.0"),
        ({"tolerance": NAN}, "a tolerance of nan"),
        ({"teeth": (25, 32)}, "wheels 1, 2, 3, not 2"),
        ({"teeth": (25.5, 32, 89)}, "z1 = 25.5 is not a whole number of teeth"),
        ({"teeth": (25, True, 89)}, "z2 = True"),
        ({"teeth": (25, 32, -89)}, "z3 = -89"),
        ({"satellites": ()}, "no number of satellites"),
        ({"satellites": (0,)}, "0 is not a number of satellites"),
        ({"satellites": (2.5,)}, "2.5 is not a number"),
        ({"limits": Limits(least=60, most=50)}, "from 60 to 50"),
        ({"limits": Limits(most=10**9)}, "from 1 to 1000"),
        ({"limits": Limits(difference=0)}, "limit difference = 0"),
        ({"mu_l": 0.0}, "mu_l = 0.0"),
        ({"mu_v": -1.0}, "mu_v = -1.0"),
        ({"pole": 0.0}, "pole = 0.0"),
    ],
)
def test_what_is_no_train_is_refused(change: dict[str, Any], says: str) -> None:
    for act in (scheme_of, search, choose):
        with pytest.raises(StructureError, match=f"planetary: .*{says}"):
            act(replace(C7, **change))


def test_modules_without_a_simple_ratio_are_refused() -> None:
    assert module_ratio(replace(TWO, module_2=0.01)) == module_ratio(TWO) * 5 / 4
    with pytest.raises(StructureError, match="no simple ratio: take standard ones"):
        scheme_of(replace(TWO, module_2=0.00812345678))


def test_schemes_know_their_wheels() -> None:
    scheme = scheme_of(C7)
    assert (scheme.wheels, scheme.opposed) == (("1", "2", "3"), True)
    scheme = scheme_of(replace(C7, scheme="internal-internal", teeth=()))
    assert (scheme.wheels, scheme.opposed) == (("1", "2", "3", "4"), False)

"""Which rooms name the classes of groups above II: the walks over groups, and those that draw such groups."""

from __future__ import annotations

import re

import pytest
from support.messages import PACKAGE

pytestmark = pytest.mark.every

NAMES = re.compile(r"\b(Plate|Square)(Group|Closing)\b")
WALKS = {"mechanism/groups.py", "mechanism/attachment.py", "chapters/kinematics/closings.py"}
"""They find groups and hand them on."""
ROOMS = {
    *(f"chapters/kinematics/{name}.py" for name in ("plates", "squares")),
    *(
        f"chapters/kinematics/special_{name}.py"
        for name in ("choices", "groups", "point", "square")
    ),
    "chapters/forces/special.py",
    "chapters/free_scale/record.py",
    "chapters/loci/record.py",
    "chapters/substitution/record.py",
}
"""They draw what these classes alone have: plates, special points, loci of a plate, substitution."""


def test_no_other_room_names_a_class_of_groups() -> None:
    files = PACKAGE.rglob("*.py")
    found = {
        path.relative_to(PACKAGE).as_posix()
        for path in files
        if NAMES.search(path.read_text("utf-8"))
    }
    assert found == {room for room in WALKS | ROOMS if (PACKAGE / room).exists()}

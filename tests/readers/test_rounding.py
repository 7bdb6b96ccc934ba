"""Who takes the mm that a table prints times the μ that the sheet prints gets the quantity that it prints."""

from __future__ import annotations

import math
from collections import defaultdict
from collections.abc import Callable, Iterable, Iterator, Sequence
from decimal import ROUND_HALF_UP, Decimal
from itertools import groupby, pairwise
from pathlib import Path

import numpy as np
import pytest
from support import gallery
from support.boards import in_usual_size
from support.columns import along
from support.gallery import NAMES
from support.sheets_of_random import scenes

from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.views import drawing_of
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.readers.columns import Column
from graphic_tmm.readers.result_table import result_table
from graphic_tmm.readers.rounding import rounded_figures
from graphic_tmm.readers.table import columns_of, table
from graphic_tmm.scene.chapter import chapters
from graphic_tmm.scene.read import read

Row = list[str]
PRINTED = ("velocities", "accelerations", "forces")


def tables(drawn: Drawn) -> Iterator[Drawing]:
    """Yield the tables that a board can be asked for, whole."""
    for chapter in chapters():
        if chapter.board == drawn.board:
            for place in chapter.places:
                yield from (
                    v for v in drawing_of(place.name)(drawn, False) if v.name.startswith("table-")
                )


def rows_of(view: Drawing) -> list[Row]:
    """Return the cells of a table as they stand on the sheet, row by row, the highest first."""
    rows: dict[float, list[tuple[float, str]]] = defaultdict(list)
    for label in view.labels:
        rows[round(label.at.imag, 3)].append((label.at.real, label.text))
    return [[text for _, text in sorted(rows[y])] for y in sorted(rows, reverse=True)]


def measured(rows: Sequence[Row]) -> Iterator[tuple[Row, Row]]:
    """Yield what is in mm with the row of its quantities below it."""
    for one, other in pairwise(rows):
        if len(one) == len(other) > 2 and one[1] in ("mm", "мм") and other[1] not in ("mm", "мм"):
            yield one[2:], other[2:]


def plain(text: str) -> Decimal | None:
    return None if text == "—" else Decimal(text.replace("−", "-").replace(",", "."))


def plain_or(text: str) -> Decimal | None:
    return plain(text) if text[-1:].isdigit() else None


def follows(mm: Row, value: Row, mu: Decimal) -> bool:
    """Whether every mm of a row times μ, rounded as people round, is the quantity below it."""
    for length, figure in zip(map(plain, mm), map(plain, value), strict=True):
        if length is not None and figure is not None:
            due = (length * mu).quantize(figure, ROUND_HALF_UP)
            if abs(due) != abs(figure):
                return False
    return True


def upright(rows: Sequence[Row]) -> Sequence[Row]:
    """Return the rows of a table, of one whose quantities stand beside one another its columns."""
    beside = len(rows) > 2 and rows[2][0] in ("Unit", "Ед.")
    return [list(one) for one in zip(*rows[1:], strict=True)] if beside else rows


def wrong(drawn: Drawn, views: Iterable[Drawing]) -> list[tuple[str, Row, Row]]:
    """Return the rows of a board's tables whose quantities follow from no μ of the board as it is printed."""
    mus = [Decimal(f"{scale.value:.4g}") for scale in drawn.scales.values()]
    return [
        (view.name, mm, value)
        for view in views
        for mm, value in measured(upright(rows_of(view)))
        if not any(follows(mm, value, mu) for mu in mus)
    ]


@pytest.mark.parametrize("name", NAMES)
def test_mm_times_mu_is_the_quantity_in_every_table_of_every_scene(name: str) -> None:
    assert not [
        found for drawn in gallery.made(name).boards for found in wrong(drawn, tables(drawn))
    ]


def test_mm_times_mu_is_the_quantity_in_what_the_command_prints() -> None:
    """Also of a length half-way between two figures: 1.25 mm is 1.3 in both rows."""
    rows = [
        [cell.strip() for cell in line.strip("│ ").split("│")]
        for one in table(gallery.made("gripper"), "text", width=300)
        for line in (one.plain(300) or "").splitlines()
        if line.startswith("│")
    ]
    (drawn,) = gallery.made("gripper").boards
    mus = [Decimal(f"{scale.value:.4g}") for scale in drawn.scales.values()]
    pairs = [
        (mm[2:], value[2:])
        for mm, value in pairwise(rows)
        if len(mm) == len(value) > 2 and mm[0] == value[0] and mm[1] in ("mm", "мм")
    ]
    assert len(pairs) > 5
    assert not [two for two in pairs if not any(follows(*two, mu) for mu in mus)]


def test_the_tables_are_read() -> None:
    (drawn,) = gallery.made("shaper").boards
    found = [row for view in tables(drawn) for row in measured(rows_of(view))]
    assert len(found) > 10
    mm, value = found[0]
    assert follows(mm, value, Decimal("0.0025"))
    assert not follows(mm, value, Decimal("0.00252"))


def test_mm_times_mu_is_the_quantity_on_random_mechanisms(
    tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    rows = 0
    for text in scenes(many(4, 3), 41):
        file = tmp_path / "scene.toml"
        file.write_text(text.partition("[[sheet]]")[0], encoding="utf-8")
        (drawn,) = in_usual_size(read(file)).boards
        plans = groupby(columns_of(drawn), key=lambda column: column.plan)
        views = [
            result_table(plan, list(some), drawn.names, "en")
            for plan, some in plans
            if plan in PRINTED
        ]
        rows += sum(len(list(measured(rows_of(view)))) for view in views)
        assert not wrong(drawn, views)
    assert rows > 50


def test_the_ratio_of_a_train_follows_from_its_table() -> None:
    (drawn,) = gallery.made("planetary").boards
    (view,) = (v for v in tables(drawn) if v.name == "table-planetary-rates")
    mu = Decimal(f"{drawn.scales['planetary-rates'].value:.4g}")
    a_minute = Decimal(f"{float(mu) * 30.0 / np.pi:.4g}")
    rows = [row for row in rows_of(view) if len(row) == 5 and plain_or(row[2]) is not None]
    assert len(rows) == 3
    assert all(follows(row[2:3], row[3:4], mu) for row in rows)
    assert all(follows(row[2:3], row[4:], a_minute) for row in rows)


@pytest.mark.parametrize("seed", range(20))
def test_equal_lengths_stand_for_equal_quantities(seed: int) -> None:
    pick = np.random.default_rng(seed)
    mu = float(f"{pick.uniform(1, 10):.2g}") * 10.0 ** pick.integers(-4, 3)
    lengths = pick.uniform(-200, 200, (4, 12)) * 10.0 ** pick.integers(-2, 1, (4, 1))
    lengths[1] = np.round(lengths[1], 1)  # as a ruler of 0.1 mm reads it
    columns = [
        Column("plan", str(k), str(k), "m/s", row[None], mu * row[None])
        for k, row in enumerate(lengths)
    ]
    found: dict[float, float] = {}
    figures = rounded_figures(columns)
    for column, one in zip(columns, figures, strict=True):
        for (mm, value), (length, figure) in zip(
            zip(*column.first_figures, strict=True),
            zip(one.mm, one.value, strict=True),
            strict=True,
        ):
            assert mm is not None
            assert value is not None
            assert length is not None
            assert figure is not None
            assert found.setdefault(length, figure) == figure
            # it is the quantity to its last decimal, but for what the last of its mm is worth
            assert abs(length - mm) <= 0.5 * 10.0**-one.mm_places * (1 + 1e-9)
            last = 0.5 * 10.0**-one.places + mu * abs(length - mm)
            assert abs(figure - value) <= last * (1 + 1e-9)
            assert 10.0**-one.places < 0.5 * mu
    assert len({one.places for one in figures}) == 1
    assert figures[1].mm_places == 1


def test_what_no_length_stands_for_has_three_digits() -> None:
    one = Column("plan", "w", "ω", "1/s", along(None, None), along(12.345, -0.06))
    other = Column("plan", "d", "d", "%", along(None, None), along(1.5, 0.25))
    assert [(f.value, f.places) for f in rounded_figures([one, other])] == [
        ([12.345, -0.06], 1),
        ([1.5, 0.25], 2),
    ]


def test_a_length_laid_off_is_told_to_a_hundredth_of_a_mm() -> None:
    laid = Column("velocities", "pa", "pa", "m/s", along(72.453, 72.453), along(5.43398, 5.43398))
    read_off = Column("velocities", "ab", "ab", "m/s", along(72.5, 3.1), along(5.4375, 0.2325))
    (one, two) = rounded_figures([laid, read_off])
    assert (one.mm, one.value, one.places) == ([72.45, 72.45], [5.43, 5.43], 2)
    assert (two.mm, two.value, two.places) == ([72.5, 3.1], [5.44, 0.23], 2)
    view = result_table("velocities", [laid, read_off], ["1", "2"], "en")
    assert ["72.45", "72.45"] in [row[2:] for row in rows_of(view)]


def test_columns_of_a_scene_keep_their_order() -> None:
    (drawn,) = gallery.made("shaper").boards
    columns = columns_of(drawn)
    for column, one in zip(columns, rounded_figures(columns), strict=True):
        there = [x for x in column.first_figures[1] if x is not None]
        assert math.isclose(
            max(map(abs, there), default=0.0),
            max((abs(x) for x in one.value if x is not None), default=0.0),
            rel_tol=0.02,
            abs_tol=10.0**-one.places,
        )

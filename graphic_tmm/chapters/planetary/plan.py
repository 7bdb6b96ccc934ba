"""A planetary train 2K–H: its sizes and conditions, two views, velocities, the ratio measured off them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.planetary.dimensions import Dimensions, calculate_train
from graphic_tmm.chapters.planetary.names import PLANETARY_TRAIN
from graphic_tmm.chapters.planetary.pictures import (
    VIEW,
    AxialView,
    EndView,
    PairView,
    draw_axial_view,
    draw_end_view,
    draw_pair,
)
from graphic_tmm.chapters.planetary.rates import Picture, Rates, draw_picture, draw_rates
from graphic_tmm.chapters.planetary.reach import Drawn, choose_scales
from graphic_tmm.chapters.planetary.task import ASKED, PlanetaryTask, Train
from graphic_tmm.chapters.planetary.tooth_search import choose
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Made


@dataclass(frozen=True)
class Planetary:
    """The train as drawn: what was asked and settled, μ_l, its sizes, views, picture and plan.

    ``results``: marks (Number) by the names under which tables give them: planetary_z1 …, planetary_satellites,
    planetary_ratio (Willis), planetary_ratio_drawn, planetary_difference (%); overall_ratio, where there is a
    ``pair`` behind the train.
    """

    order: PlanetaryTask
    train: Train
    mu: Mark
    sizes: Dimensions
    end: EndView
    axial: AxialView
    picture: Picture
    rates: Rates
    results: Mapping[str, Mark]
    pair: PairView | None = None


PLANETARY_PLAN: Made[Planetary] = Made(PLANETARY_TRAIN)


def record(bench: Bench) -> Planetary | None:
    """Draw the train that the scene asks for, at a share of its usual size where there is one."""
    order = ASKED.of(bench.scene)
    if order is None:
        return None
    share = bench.sizes.get(PLANETARY_TRAIN, 1.0)
    return draw_planetary(bench.draft, order, share)


def draw_planetary(draft: Draft, order: PlanetaryTask, size: float = 1.0) -> Planetary:
    """Draw the smallest train that fulfils an order, or the one whose tooth numbers it gives.

    The draft is the train's own: its positions are the satellites. The scale factors, the pole distance and the
    places of the views are chosen and kept in ``draft.given``; they may be replaced there. ``size``: what share
    of the usual room the views take.

    Raises
    ------
    StructureError
        If the order is not sound, no train fulfils it, or the one given breaks a condition.
    """
    train = choose(order)
    draft.open(VIEW)
    mu = draft.mu_l = draft.scale("μ_l", "m/mm")
    draft.lay_out()
    sizes = calculate_train(draft, order, train)
    end = draw_end_view(draft, train, sizes)
    axial = draw_axial_view(draft, train, end)
    pair = draw_pair(draft, order, train, sizes, end)
    picture = draw_picture(draft, order, end, sizes)
    rates = draw_rates(draft, order, train, end, sizes, picture)
    results = {f"planetary_z{wheel}": mark for wheel, mark in sizes.teeth.items()}
    results |= {
        "planetary_satellites": sizes.satellites,
        "planetary_ratio": sizes.ratio,
        "planetary_ratio_drawn": rates.ratio,
        "planetary_difference": rates.difference,
    }
    if pair is not None:
        results["overall_ratio"] = pair.ratio
    choose_scales(draft, Drawn(order, train, end, axial, picture, rates, pair, size))
    return Planetary(order, train, mu, sizes, end, axial, picture, rates, results, pair)

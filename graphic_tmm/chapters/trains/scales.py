"""How large a planetary train may be drawn; its scale factors, and how they were chosen."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.trains.plan import PLANETARY_PLAN, Planetary, reach_of
from graphic_tmm.chapters.trains.task import PLANETARY_TRAIN
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import Choice, value_of
from graphic_tmm.fitting.scales import ScaleFactor, ScaleFactors
from graphic_tmm.fitting.sizes import Size, Sizing
from graphic_tmm.scene.records import Scene


def _fixed(scene: Scene) -> str:
    return "planetary.mu_l" if "planetary.mu_l" in scene.told else ""


SIZES = Sizing(
    sizes=(Size(PLANETARY_TRAIN, low=0.75, least=0.3, fixed=_fixed),),
    depends={"planetary": lambda scene, role: (PLANETARY_TRAIN,)},
)


SCALE_KEYS = {
    "planetary": "mu_l_planetary",
    "planetary-velocities": "mu_v_planetary",
    "planetary-rates": "mu_omega_planetary",
}
"""What the scale factors are called where machines read them."""

SCALES = ScaleFactors(keys=lambda project: SCALE_KEYS)


def factors(drawn: Drawn) -> Iterator[ScaleFactor]:
    """Yield both scale factors: by the diameter that the train takes, by the largest velocity."""
    train = PLANETARY_PLAN.on(drawn)
    order, mu_l, mu_v = train.order, train.mu, train.picture.mu
    wide = 2.0 * _reach(drawn, train) * value_of(drawn, mu_l)
    yield ScaleFactor(mu_l, "d_{max}", wide, fixed=order.mu_l, lengths=True)
    longest = max(abs(value_of(drawn, mark)) for mark in train.picture.readings.values())
    yield ScaleFactor(mu_v, "v_{max}", longest * value_of(drawn, mu_v), fixed=order.mu_v)
    if train.train.scheme.bevel:
        rates = train.rates
        longest = max(abs(value_of(drawn, mark)) for mark in rates.segments.values())
        yield ScaleFactor(rates.mu, "ω_{max}", longest * value_of(drawn, rates.mu))


def _reach(drawn: Drawn, train: Planetary) -> float:
    """Return the radius about the main axis that the pitch circles take, mm."""
    radii = {name: abs(drawn.value(mark)) for name, mark in train.end.lengths.items()}
    return reach_of(train.train.scheme, radii)


CHOICE = Choice(factors)

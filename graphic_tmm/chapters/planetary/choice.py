"""How μ_l and μ_v of a planetary train were chosen, step by step."""

from __future__ import annotations

from graphic_tmm.chapters.planetary.plan import PLANETARY_PLAN, Planetary
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import Choice, Ledger


def choose_steps(drawn: Drawn, ledger: Ledger) -> None:
    """Record how both were chosen: by the diameter that the train takes, by the largest velocity."""
    train = PLANETARY_PLAN.on(drawn)
    order, mu_l, mu_v = train.order, train.mu, train.picture.mu
    ledger.of(mu_l.view)
    value = ledger.value_of(drawn, mu_l)
    if order.mu_l:
        ledger.told(mu_l, order.mu_l)
    else:
        most = ledger.quantity("d_{max}", 2.0 * _reach(drawn, train) * value, "m")
        ledger.fitting(mu_l, most, value, lengths=True)
    ledger.of(mu_v.view)
    value = ledger.value_of(drawn, mu_v)
    if order.mu_v:
        ledger.told(mu_v, order.mu_v)
        return
    longest = max(abs(ledger.value_of(drawn, mark)) for mark in train.picture.readings.values())
    ledger.fitting(mu_v, ledger.quantity("v_{max}", longest * value, "m/s"), value)


def _reach(drawn: Drawn, train: Planetary) -> float:
    """Return the radius about the main axis that the pitch circles take, mm."""
    lengths = train.end.lengths
    found = {wheel: abs(float(drawn.reading[mark][0, 0])) for wheel, mark in lengths.items()}
    wheels = train.train.scheme.wheels
    rims = max(found[wheel] for wheel in wheels[1:-1])
    return max(found["1"], found[wheels[-1]], found["H"] + rims)


CHOICE = Choice(choose_steps)

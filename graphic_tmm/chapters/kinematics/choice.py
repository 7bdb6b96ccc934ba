"""How μ_l, μ_v and μ_a were chosen, step by step, with the lengths of the crank's vectors that follow."""

from __future__ import annotations

from graphic_tmm.board.operations.choice import scale_by_turning
from graphic_tmm.board.operations.formulas import product, product_of_squares
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.kinematics.images import image_letter
from graphic_tmm.chapters.kinematics.names import ACCELERATIONS, KINEMATICS, POSITIONS, VELOCITIES
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.scales import Extents, crank_sizes
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.choice import Choice, Ledger


def choose(drawn: Drawn, ledger: Ledger) -> None:
    """Record how the scale factors of the three plans were chosen."""
    made, wanted = KINEMATICS_PLAN.on(drawn), drawn.scene.scales
    reach: Extents = drawn.reach[KINEMATICS]
    pivot, pin, driver = made.structure.pivot, made.structure.pin, made.structure.driver
    small = image_letter(pin)
    ledger.of(POSITIONS)
    arm = ledger.quantity(f"l_{{{pivot}{pin}}}", crank_sizes(made)[0], "m")
    mu = drawn.project.scale(POSITIONS)
    if wanted.mu_l:
        mu_l = ledger.told(mu, wanted.mu_l)
    elif wanted.OA:
        mu_l = ledger.by_length(mu, arm, f"{pivot}{pin}", wanted.OA)
    else:
        most = ledger.quantity("l_{max}", reach.positions, "m")
        mu_l = ledger.fitting(mu, most, ledger.value_of(drawn, mu), lengths=True)
    if not wanted.OA or wanted.mu_l:
        ledger.follows(f"{pivot}{pin}", arm, mu_l)
    if made.velocities is None:
        return
    ledger.of(VELOCITIES)
    omega = ledger.speed(str(driver), made.mechanism.drive.speed)
    if made.velocities.speed is not None:
        ledger.enter(made.velocities.speed, omega)
    speed = ledger.found(product, f"v_{pin}", omega, arm, unit="m/s")
    mu = drawn.project.scale(VELOCITIES)
    if wanted.mu_v_is_mu_l_omega:
        mu_v = ledger.draft.draw(scale_by_turning, mu.letter, mu_l, omega, unit=mu.unit)
        ledger.follows(f"p{small}", speed, ledger.enter(mu, mu_v))
    else:
        fixed = wanted.mu_v, wanted.pa
        _plan(drawn, ledger, VELOCITIES, fixed, (f"p{small}", speed), reach.velocities)
    if made.accelerations is None:
        return
    ledger.of(ACCELERATIONS)
    gain = ledger.found(product_of_squares, f"a_{pin}", omega, arm, unit="m/s²")
    fixed = wanted.mu_a, wanted.pi_a
    _plan(drawn, ledger, ACCELERATIONS, fixed, (f"π{small}", gain), reach.accelerations)


def _plan(
    drawn: Drawn,
    ledger: Ledger,
    plan: str,
    fixed: tuple[float | None, float | None],
    of_pin: tuple[str, Mark],
    longest: float,
) -> None:
    """Record the choice for a plan of vectors: as the scene fixes it, or by the longest vector of the plan.

    ``of_pin``: the segment that shows the crank pin's vector, and that vector.
    """
    mu, (told, length), (letter, quantity) = drawn.project.scale(plan), fixed, of_pin
    if told:
        found = ledger.told(mu, told)
    elif length:
        ledger.by_length(mu, quantity, letter, length)
        return
    else:
        most = ledger.quantity(f"{quantity.letter[0]}_{{max}}", longest, quantity.unit)
        found = ledger.fitting(mu, most, ledger.value_of(drawn, mu))
    ledger.follows(letter, quantity, found)


CHOICE = Choice(choose)

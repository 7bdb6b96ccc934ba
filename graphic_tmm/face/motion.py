"""The third verb: how a scene moves wherever its drive stands."""

from __future__ import annotations

from collections.abc import Collection

from numpy.typing import ArrayLike

from graphic_tmm.errors import ConstructionError
from graphic_tmm.face.reading import Source, read
from graphic_tmm.language.said import said
from graphic_tmm.readers.any_angles import motion as any_angles
from graphic_tmm.readers.any_angles.results import Motion
from graphic_tmm.readers.any_angles.turn import OwnPlan, Plan


def motion(
    scene: Source,
    at: ArrayLike | None = None,
    points: Collection[str] | None = None,
    *,
    plans: Plan | OwnPlan | Collection[Plan | OwnPlan] | None = None,
    exact: bool = False,
    fast: bool | None = None,
    threads: int | None = None,
    angles: ArrayLike | None = None,
) -> Motion:
    """Draw plans of a scene at places of its drive and return what they say, in SI.

    The log is recorded at the first call; only the steps are run that what is asked
    for needs. Arrays of a call that is compiled lie side by side in one piece of memory, which goes when the
    last of them does.

    Parameters
    ----------
    scene
        A scene with a mechanism, a cam, a train, a pair of gears, or what `read` takes. Its scale factors and
        its hand hold; of a hand that slips, the first drawing. A `Scene` keeps what was recorded of it for the
        next call.
    at
        Where the drive stands, a number or a row: of a crank its directions from the x axis, degrees,
        counter-clockwise positive; of a slider how far it is along its guide, of a rod how far its pin is from
        that of its cylinder, m.
    points
        Letters of the points wanted; None for all.
    plans
        What is wanted; None for the first three, of a scene without a mechanism for what it has.
        Of "positions", "velocities" (with ω), "accelerations" (with ε), and "forces": the
        reactions and what balances the crank, of a scene that has loads. A load by the travel of a slider turns
        at the ends of its travel; one by the angle or by the position is read off its diagram along straight
        lines, gas off the indicator diagram as drawn. They go with the cycle, which begins at the zero
        position; its angles go on to 720° where it takes two turns. "centres", "centrodes", "curvature",
        "hodograph" (the analogues of its points): what these chapters find. Or "cam", "arc_cam", "planetary",
        "gears": the places are then angles of the cam from where its phases, or the rise, begin, or of the
        shaft that drives.
    exact
        Read without the ruler's rounding.
    fast
        Whether the log is compiled (extra ``fast``), to the same numbers within 1e-12; None: where llvmlite is
        installed, at any number of angles. A process' first call for a kind of mechanism takes some hundredths
        of a second more then, less where the code is kept on the disk; every other one takes a tenth, of
        mechanisms of other lengths too. It hangs on nothing that was called before.
    threads
        How many threads a compiled log may use; None: as many as there are. The numbers do not depend on it.
    angles
        An earlier name of ``at``.

    Raises
    ------
    SceneError
        If the scene cannot be read, or has nothing that moves.
    StructureError
        If it cannot be drawn, or a load is not known at any angle.
    ConstructionError
        If a point or a plan is unknown, the places are none or no row of numbers, or ``fast`` is asked for and
        cannot be had.

    Examples
    --------
    >>> import graphic_tmm
    >>> k = graphic_tmm.motion("windrower", [0, 90, 180], ["C", "D"])
    >>> k["D"].velocity.shape, k.omega[3].shape
    ((3,), (3,))
    """
    places = angles if at is None else at
    if places is None:
        raise ConstructionError(said("motion: say where the drive stands: at, degrees or m"))
    return any_angles.motion(
        read(scene), places, points, plans=plans, exact=exact, fast=fast, threads=threads
    )

"""What the plans tell at any angle of the crank: of every point, of every link that can turn."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from graphic_tmm.any_angles.turn import Plan, Quantity, Told
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.kinematics.plan import ALL, KINEMATICS_PLAN
from graphic_tmm.project import Project
from graphic_tmm.scene.records import Scene

VECTORS: tuple[tuple[Plan, Quantity, Quantity], ...] = (
    ("velocities", "velocities", "omega"),
    ("accelerations", "accelerations", "epsilon"),
)
"""The plans of vectors: what stands for what of points and of links."""


def free(scene: Scene) -> Scene:
    """Return the scene with direct plans, accelerations among them, and no path of a point."""
    row = scene.row if scene.row.accelerations else replace(scene.row, accelerations=ALL)
    return replace(scene, row=row, turned=False, trajectories=())


def told(project: Project) -> Iterator[Told]:
    """Yield places, velocities and accelerations of all points, then ω and ε of links that turn."""
    made = KINEMATICS_PLAN.on(project)
    bodies = made.positions.bodies
    names = [(letter, n) for n, body in bodies.items() for letter in body.link.points]
    origin = made.mechanism.frame.points[made.structure.pivot]
    for letter, n in names:
        mark = bodies[n].marks[letter]
        yield Told("positions", "places", (letter, n), mark, made.mu_l, origin=origin)
    for plan, quantity, turning in VECTORS:
        motion = made.motion(plan)
        if motion is None:
            continue
        for letter, n in names:
            image: Mark = motion.images.by_letter[n][letter]
            yield Told(plan, quantity, (letter, n), image, motion.mu)
        for n, rate in motion.rates.items():
            yield Told(plan, turning, n, rate)

"""The curvature of a profile under a flat face on a lever, and its least radius, without the package's way."""

from __future__ import annotations

import numpy as np

from graphic_tmm.chapters.cam.kinds import FlatRockerFollower
from graphic_tmm.chapters.cam.task import CamTask
from support.cams import motion


def radii_under_face(order: CamTask, r0: float, degrees: np.ndarray) -> np.ndarray:
    """Return the radius of curvature (m) under a face on a lever: h + d²h/dθ² of its support by differences.

    h is how far the face stands from the cam's centre, θ the angle by which its normal has turned against the
    cam.
    """
    follower, t = order.follower, 1e-4
    assert isinstance(follower, FlatRockerFollower)
    start = np.arcsin((r0 + follower.face) / follower.centres)

    def at(shift: float) -> tuple[np.ndarray, np.ndarray]:
        phi = degrees + np.degrees(shift)
        angle = motion(order, phi)[0]
        turned = np.radians(phi) + (-angle if follower.same_sense else angle)
        return follower.centres * np.sin(start + angle) - follower.face, turned

    (h0, a0), (h1, a1), (h2, a2) = at(-t), at(0.0), at(t)
    second = 2 * ((h2 - h1) / (a2 - a1) - (h1 - h0) / (a1 - a0)) / (a2 - a0)
    return np.asarray(h1 + second)


def least_under_face(order: CamTask) -> float:
    """Return the least r0 (m) at which the profile under a face on a lever is convex enough: by halving."""
    follower = order.follower
    assert isinstance(follower, FlatRockerFollower)
    low, high = follower.least, follower.centres - follower.face
    turn = np.arange(0.025, 360.0, 0.05)
    for _ in range(40):
        middle = (low + high) / 2
        fits = radii_under_face(order, middle, turn).min() >= follower.least
        low, high = (low, middle) if fits else (middle, high)
    return high

"""The image of a link is similar to the link and lettered in the same sense, in both plans."""

from __future__ import annotations

import pytest
from hypothesis import HealthCheck, given, settings
from support.drawn import board
from support.examples import most
from support.mechanisms import Sampled, mechanisms


@pytest.mark.slow
@settings(max_examples=most(50), deadline=None, suppress_health_check=list(HealthCheck))
@given(drawn=mechanisms())
def test_images_of_a_link_are_similar_to_it(drawn: Sampled) -> None:
    read = board(drawn.mechanism).read([[drawn.phi]])
    for link in drawn.mechanism.links:
        letters = list(link.points)
        if len(letters) < 3:
            continue
        z = [complex(read["r"][k, link.number][0]) for k in letters]
        a, b = max(
            ((i, j) for i in range(len(z)) for j in range(i)),
            key=lambda ij: abs(z[ij[0]] - z[ij[1]]),
        )
        omega = float(read["omega"].get(link.number, [0.0])[0])
        epsilon = float(read["epsilon"].get(link.number, [0.0])[0])
        # one complex ratio for the whole figure: similar, in the same sense (no conjugate)
        for name, ratio in (("v", 1j * omega), ("a", 1j * epsilon - omega**2)):
            w = [complex(read[name][k, link.number][0]) for k in letters]
            size = max(map(abs, w)) + abs(ratio) * abs(z[a] - z[b])
            for i in range(len(z)):
                due = w[b] + ratio * (z[i] - z[b])
                assert abs(w[i] - due) <= 1e-10 * size, (name, link.number, drawn.kinds)

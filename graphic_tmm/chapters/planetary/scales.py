"""The scale factors of a planetary train, as drawn."""

from __future__ import annotations

from graphic_tmm.fitting.scales import ScaleFactors

SCALE_KEYS = {
    "planetary": "mu_l_planetary",
    "planetary-velocities": "mu_v_planetary",
    "planetary-rates": "mu_omega_planetary",
}
"""What the scale factors are called where machines read them."""

SCALES = ScaleFactors(
    key=lambda view: SCALE_KEYS.get(view, ""),
)

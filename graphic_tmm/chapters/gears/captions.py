"""What people call the views and the results of a pair of gears."""

from __future__ import annotations

from graphic_tmm.language.said import said

_LAID_OFF = ("r", "r_b", "r_w", "r_f", "r_a", "s")
"""What is laid off of a wheel."""
CAPTIONS: dict[str, str] = {
    "chapter gears": said("Gear pair"),
    "given gears": said("Given data: gears"),
    "gear": said("Meshing of the gears"),
    "gear-dimensions": said("Dimensions of the gear pair"),
    "gear-rolling-1": said("Construction of a tooth of wheel 1"),
    "gear-rolling-2": said("Construction of a tooth of wheel 2"),
    "gear-calculation": said("Calculation of the gear pair"),
    "sliding": said("Specific sliding"),
    "sliding-stations": said("Specific sliding at the stations"),
    "gear_ratio": "u_{12}",
    "arc_of_engagement": "s_{cd}",
    "alpha_w": "α_{w}",
    "delta_y": "Δy",
    "contact_ratio": "ε_{α}",
    "contact_ratio_drawn": "ε_{dr}",
    "contact_ratio_difference": "Δε",
    "arc_of_engagement1": "c_{1}d_{1}",
    "arc_of_engagement2": "c_{2}d_{2}",
    **{
        f"{name}_drawn": f"[{symbol}]"
        for name, symbol in (
            *(("a_w", "a_{w}"), ("h", "h"), ("h_w", "h_{w}"), ("p", "p"), ("p_b", "p_{b}")),
            ("arc_of_engagement", "s_{cd}"),
            *((f"{of}{i}", f"{of[0]}_{{{of[2:]}{i}}}") for of in _LAID_OFF for i in (1, 2)),
        )
    },
}

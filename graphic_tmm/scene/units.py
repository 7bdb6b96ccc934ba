"""The units that a scene may be written in, and those that its quantities are kept and printed in."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping
from decimal import Decimal
from typing import Literal, NamedTuple

Dimension = Literal[
    "length",
    "angle",
    "angular speed",
    "angular acceleration",
    "speed",
    "acceleration",
    "time",
    "mass",
    "force",
    "pressure",
    "moment",
    "moment of inertia",
    "unbalance",
    "scale of lengths",
    "scale of velocities",
    "scale of accelerations",
    "scale of times",
    "scale of angles",
    "scale of pressures",
    "scale of moments",
    "scale of works",
    "scale of forces",
    "density",
    "power",
    "stiffness",
    "damping",
    "ratio",
]


class Unit(NamedTuple):
    """What a spelling of a unit means: its dimension, its size in SI units (angles: degrees)."""

    dimension: Dimension
    factor: Decimal | float


KGF = "9.80665"
GRAVITY = 9.81
"""g throughout the documents, m/s²: what a weight is taken with if a scene gives no other."""
_LB, _LBF, _FT = Decimal("0.45359237"), Decimal("4.4482216152605"), Decimal("0.3048")
"""Pound, pound-force and foot: exact by their definitions of 1959 and by the standard g of KGF."""
_IN, _SLUG = _FT / 12, _LBF / _FT
_TABLE: tuple[tuple[Dimension, str | float | Decimal, str], ...] = (
    ("length", "0.001", "mm мм"),
    ("length", "0.01", "cm см"),
    ("length", "1", "m м"),
    ("length", "1000", "km км"),
    ("length", _IN, "in дюйм дюйма дюймов inch inches"),
    ("length", _FT, "ft фут фута футов foot feet"),
    ("angle", "1", "deg ° degree degrees град градус градуса градусов"),
    ("angle", 180 / math.pi, "rad рад"),
    ("angular speed", "1", "rad/s рад/с 1/s 1/с s⁻¹ с⁻¹ rad·s⁻¹ рад·с⁻¹"),
    ("angular speed", math.pi / 30, "rpm об/мин rev/min r/min 1/min 1/мин min⁻¹ мин⁻¹ об·мин⁻¹"),
    ("angular speed", math.pi / 180, "deg/s °/s град/с °/с"),
    ("angular speed", 2 * math.pi, "rev/s об/с"),
    ("angular acceleration", "1", "rad/s² рад/с² 1/s² 1/с² s⁻² с⁻² rad·s⁻² рад·с⁻²"),
    ("angular acceleration", math.pi / 180, "deg/s² °/s² град/с² °/с²"),
    ("speed", "1", "m/s м/с m·s⁻¹ м·с⁻¹"),
    ("speed", "0.01", "cm/s см/с"),
    ("speed", "0.001", "mm/s мм/с"),
    ("speed", 1 / 3.6, "km/h км/ч"),
    ("speed", _FT, "ft/s фут/с"),
    ("speed", _IN, "in/s дюйм/с"),
    ("acceleration", "1", "m/s² м/с² m·s⁻² м·с⁻²"),
    ("acceleration", "0.001", "mm/s² мм/с²"),
    ("acceleration", "0.01", "cm/s² см/с²"),
    ("acceleration", _FT, "ft/s² фут/с²"),
    ("acceleration", _IN, "in/s² дюйм/с²"),
    ("time", "1", "s с"),
    ("time", "0.001", "ms мс"),
    ("time", "60", "min мин"),
    ("mass", "1", "kg кг"),
    ("mass", "0.001", "g г"),
    ("mass", "1000", "t т"),
    ("mass", KGF, "kgf·s²/m кгс·с²/м"),
    ("mass", _LB, "lb lbs lbm фунт фунта фунтов"),
    ("mass", _SLUG, "slug slugs слаг lbf·s²/ft"),
    ("force", "1", "N Н"),
    ("force", "1000", "kN кН"),
    ("force", KGF, "kgf кгс"),
    ("force", _LBF, "lbf фунт-сила"),
    ("force", 1000 * _LBF, "kip"),
    ("pressure", "1", "Pa Па N/m² Н/м²"),
    ("pressure", "1e3", "kPa кПа"),
    ("pressure", "1e6", "MPa МПа N/mm² Н/мм²"),
    ("pressure", "1e5", "bar бар"),
    ("pressure", "98066.5", "kgf/cm² кгс/см²"),
    ("pressure", "98066.5", "at ат"),
    ("pressure", "101325", "atm атм"),
    ("pressure", _LBF / _IN**2, "psi lbf/in² lb/in²"),
    ("pressure", _LBF / _FT**2, "psf lbf/ft² lb/ft² фунт-сила/фут²"),
    ("moment", "1", "N·m Н·м"),
    ("moment", "0.001", "N·mm Н·мм"),
    ("moment", "1000", "kN·m кН·м"),
    ("moment", KGF, "kgf·m кгс·м"),
    ("moment", "0.0980665", "kgf·cm кгс·см"),
    ("moment", _LBF * _FT, "lbf·ft ft·lbf lb·ft ft·lb фунт-сила·фут"),
    ("moment", _LBF * _IN, "lbf·in in·lbf lb·in in·lb"),
    ("moment of inertia", "1", "kg·m² кг·м²"),
    ("moment of inertia", KGF, "kgf·m·s² кгс·м·с²"),
    ("moment of inertia", "1e-4", "kg·cm² кг·см²"),
    ("moment of inertia", "1e-6", "kg·mm² кг·мм²"),
    ("moment of inertia", "1e-7", "g·cm² г·см²"),
    (
        "moment of inertia",
        _SLUG * _FT**2,
        "slug·ft² lbf·ft·s² ft·lbf·s² lb·ft·s² ft·lb·s² слаг·фут²",
    ),
    ("moment of inertia", _SLUG * _FT * _IN, "lbf·in·s² in·lbf·s² lb·in·s² in·lb·s²"),
    ("moment of inertia", _LB * _FT**2, "lb·ft² lbm·ft²"),
    ("moment of inertia", _LB * _IN**2, "lb·in² lbm·in²"),
    ("unbalance", "1", "kg·m кг·м"),
    ("unbalance", "0.001", "kg·mm кг·мм g·m г·м"),
    ("unbalance", "1e-5", "g·cm г·см"),
    ("unbalance", "1e-6", "g·mm г·мм"),
    ("scale of lengths", "1", "m/mm м/мм"),
    ("scale of lengths", "0.001", "mm/mm мм/мм"),
    ("scale of lengths", _FT, "ft/mm фут/мм"),
    ("scale of lengths", _IN, "in/mm дюйм/мм"),
    ("scale of velocities", "1", "(m/s)/mm (м/с)/мм m/s/mm м/с/мм m/(s·mm) м/(с·мм)"),
    ("scale of velocities", _FT, "(ft/s)/mm (фут/с)/мм ft/s/mm фут/с/мм"),
    ("scale of times", "1", "s/mm с/мм"),
    ("scale of angles", "1", "rad/mm рад/мм"),
    ("scale of pressures", "1", "Pa/mm Па/мм"),
    ("scale of pressures", "1e3", "kPa/mm кПа/мм"),
    ("scale of pressures", "1e6", "MPa/mm МПа/мм"),
    ("scale of pressures", _LBF / _FT**2, "(lbf/ft²)/mm"),
    ("scale of pressures", _LBF / _IN**2, "psi/mm"),
    ("scale of moments", "1", "N·m/mm Н·м/мм"),
    ("scale of moments", _LBF * _FT, "lbf·ft/mm (lbf·ft)/mm"),
    ("scale of works", "1", "J/mm Дж/мм"),
    ("scale of works", _LBF * _FT, "ft·lbf/mm (ft·lbf)/mm"),
    ("scale of forces", "1", "N/mm Н/мм"),
    ("scale of forces", "1000", "kN/mm кН/мм"),
    ("scale of forces", KGF, "kgf/mm кгс/мм"),
    ("scale of forces", _LBF, "lbf/mm фунт-сила/мм"),
    ("density", "1", "kg/m³ кг/м³"),
    ("density", "1000", "g/cm³ г/см³"),
    ("density", _LB / _IN**3, "lb/in³"),
    ("density", _LB / _FT**3, "lb/ft³"),
    ("power", "1", "W Вт"),
    ("power", "1000", "kW кВт"),
    ("power", 550 * _FT * _LBF, "hp"),
    ("power", "735.49875", "л.с"),
    ("stiffness", "1", "N/m Н/м"),
    ("stiffness", "100", "N/cm Н/см"),
    ("stiffness", "1000", "kN/m кН/м"),
    ("stiffness", KGF, "kgf/m кгс/м"),
    ("stiffness", "980.665", "kgf/cm кгс/см"),
    ("stiffness", _LBF / _FT, "lbf/ft lb/ft фунт-сила/фут"),
    ("stiffness", _LBF / _IN, "lbf/in lb/in фунт-сила/дюйм"),
    ("damping", "1", "N·s/m Н·с/м"),
    ("damping", "1000", "kN·s/m кН·с/м N·s/mm Н·с/мм"),
    ("damping", KGF, "kgf·s/m кгс·с/м"),
    ("damping", _LBF / _FT, "lbf·s/ft lb·s/ft фунт-сила·с/фут"),
    ("damping", _LBF / _IN, "lbf·s/in lb·s/in"),
    ("ratio", "0.01", "%"),
    ("scale of accelerations", "1", "(m/s²)/mm (м/с²)/мм m/s²/mm м/с²/мм m/(s²·mm) м/(с²·мм)"),
)


def _units() -> dict[str, Unit]:
    return {
        spelling: Unit(dimension, Decimal(factor) if isinstance(factor, str) else factor)
        for dimension, factor, spellings in _TABLE
        for spelling in spellings.split()
    }


UNITS: Mapping[str, Unit] = _units()
"""Every spelling of a unit in its plain form (see ``plain_unit``) -> what it means."""


def si_unit(dimension: str) -> str:
    """Return what a number of a dimension is in without a unit, in signs of any keyboard; "" if in none.

    >>> si_unit("moment of inertia"), si_unit("angle"), si_unit("ratio")
    ('kg*m^2', 'deg', '')
    """
    known = (one for one, unit in UNITS.items() if (unit.dimension, unit.factor) == (dimension, 1))
    return next(known, "").replace("·", "*").replace("²", "^2").replace("³", "^3")


def plain_unit(unit: str) -> str:
    """One form for the ways a unit may be typed: ``kg * m^2``, ``kg m2`` -> ``kg·m²``.

    Parameters
    ----------
    unit : str
        The unit as typed; spaces of any kind.
    """
    text = re.sub(r"\*\*", "^", unit.strip().removesuffix("."))
    text = re.sub(r"[*⋅∙•×]|(?<=[A-Za-z])-(?=[A-Za-z])", "·", text)
    text = re.sub(r"\^?(?:-|⁻)([12¹²])(?![0-9])", r"⁻\1", text)
    text = re.sub(r"(?:(?<=[^\W\d_])|\^|(?<=⁻))([123])(?![0-9])", _raised, text)
    text = re.sub(r"\s*([·/()])\s*", r"\1", text)
    return re.sub(r"\s+", "·", text)


def _raised(match: re.Match[str]) -> str:
    return "¹²³"[int(match.group(1)) - 1]


class System(NamedTuple):
    """The coherent units that quantities are kept in, each in SI: of length, mass, force (mass·length/s²).

    Formulas hold in any coherent units, so a construction needs to know nothing of them.
    """

    length: Decimal = Decimal(1)
    mass: Decimal = Decimal(1)
    force: Decimal = Decimal(1)

    def size(self, dimension: Dimension) -> float:
        """Return the unit of a dimension in SI."""
        length, force = _POWERS.get(dimension, (0, 0))
        mass = (
            self.mass if dimension in ("mass", "density", "moment of inertia", "unbalance") else 1
        )
        return float(self.length**length * self.force**force * mass)


_POWERS: Mapping[Dimension, tuple[int, int]] = {
    "length": (1, 0),
    "speed": (1, 0),
    "acceleration": (1, 0),
    "force": (0, 1),
    "pressure": (-2, 1),
    "moment": (1, 1),
    "moment of inertia": (2, 0),
    "unbalance": (1, 0),
    "power": (1, 1),
    "density": (-3, 0),
    "stiffness": (-1, 1),
    "damping": (-1, 1),
    "scale of lengths": (1, 0),
    "scale of velocities": (1, 0),
    "scale of accelerations": (1, 0),
    "scale of pressures": (-2, 1),
    "scale of moments": (1, 1),
    "scale of works": (1, 1),
    "scale of forces": (0, 1),
}
"""Powers of length and force in a dimension; those with a mass have it once."""
SI = "SI"
SYSTEMS: Mapping[str, System] = {SI: System(), "imperial": System(_FT, _SLUG, _LBF)}
"""By what a scene calls them: metre, kilogram, newton; foot, slug, pound-force."""

"""Numbers, units and names for people: what most readers need, in one place."""

from graphic_tmm.language.names import flywheel_title, plain, spoken, view_name
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.units import unit

__all__ = ["fixed", "flywheel_title", "number", "plain", "spoken", "unit", "view_name"]

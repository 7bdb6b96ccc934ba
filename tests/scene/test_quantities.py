"""Units: every spelling, wrong dimensions, and what can be read in two ways."""

import math
from decimal import Decimal

import pytest
from hypothesis import given
from hypothesis import strategies as st

from graphic_tmm.scene.quantities import LARGEST, Measures, measuring, parse
from graphic_tmm.scene.units import UNITS, plain_unit


@pytest.mark.parametrize(
    ("text", "dimension", "value"),
    [
        ("95 mm", "length", 0.095),
        ("117.6 mm", "length", 0.1176),
        ("117,6мм", "length", 0.1176),
        ("12 см", "length", 0.12),
        ("1e-3 m", "length", 0.001),
        ("−3 mm", "length", -0.003),
        ("+.5 м", "length", 0.5),
        ("2 in", "length", 0.0508),
        ("1\u00a0км", "length", 1000.0),
        ("0,125 m", "length", 0.125),
        ("30°", "angle", 30.0),
        ("30 град", "angle", 30.0),
        ("2 рад", "angle", 360 / math.pi),
        ("380 rpm", "angular speed", 380 * math.pi / 30),
        ("380 об/мин", "angular speed", 380 * math.pi / 30),
        ("380 об / мин", "angular speed", 380 * math.pi / 30),
        ("30 1/min", "angular speed", math.pi),
        ("50 1/s", "angular speed", 50.0),
        ("50 1/с", "angular speed", 50.0),
        ("50 s^-1", "angular speed", 50.0),
        ("50 с-1", "angular speed", 50.0),
        ("50 s⁻¹", "angular speed", 50.0),
        ("50 рад/с", "angular speed", 50.0),
        ("180 deg/s", "angular speed", math.pi),
        ("20 rad/s^2", "angular acceleration", 20.0),
        ("20 1/s²", "angular acceleration", 20.0),
        ("20 рад/с2", "angular acceleration", 20.0),
        ("20 s**-2", "angular acceleration", 20.0),
        ("0,05 m/s", "speed", 0.05),
        ("0,05 м/с", "speed", 0.05),
        ("250 mm/s", "speed", 0.25),
        ("9.81 m/s^2", "acceleration", 9.81),
        ("20 ms", "time", 0.02),
        ("2 мин", "time", 120.0),
        ("250 g", "mass", 0.25),
        ("2 т", "mass", 2000.0),
        ("1 kgf*s^2/m", "mass", 9.80665),
        ("1 кгс·с²/м", "mass", 9.80665),
        ("190 Н", "force", 190.0),
        ("1.5 kN", "force", 1500.0),
        ("2 кгс", "force", 19.6133),
        ("300 kPa", "pressure", 3e5),
        ("3 бар", "pressure", 3e5),
        ("1 kgf/cm2", "pressure", 98066.5),
        ("12 N*m", "moment", 12.0),
        ("12 Н м", "moment", 12.0),
        ("1 kgf·m", "moment", 9.80665),
        ("0.02 kg*m^2", "moment of inertia", 0.02),
        ("0.02 kg m2", "moment of inertia", 0.02),
        ("0,02 кг·м²", "moment of inertia", 0.02),
        ("1 kgf*m*s^2", "moment of inertia", 9.80665),
        ("0.005 m/mm", "scale of lengths", 0.005),
        ("0.25 (m/s)/mm", "scale of velocities", 0.25),
        ("0.25 ( м / с ) / мм", "scale of velocities", 0.25),
        ("12.5 (m/s^2)/mm", "scale of accelerations", 12.5),
    ],
)
def test_reads(text, dimension, value):
    assert parse(text, dimension) == pytest.approx(value, rel=1e-15)


@pytest.mark.parametrize(("number", "value"), [(3, 3.0), (0.25, 0.25), (-1, -1.0)])
def test_a_number_is_si(number, value):
    found = parse(number, "length")
    assert found == value
    assert isinstance(found, float)


def test_a_number_for_an_angle_is_in_degrees():
    assert parse(90, "angle") == 90.0


def test_wrong_dimension_says_what_is_wanted():
    with pytest.raises(ValueError, match="wanted") as error:
        parse("95 kg", "length")
    assert str(error.value) == '"95 kg" is a mass; a length is wanted here, for example "95 mm"'


def test_a_weight_in_kgf_becomes_a_mass_by_the_g_that_makes_a_kgf_of_a_kg():
    assert parse("17.1 kgf", "mass") == 17.1
    assert parse("10 lbf", "mass") == pytest.approx(4.5359237, rel=1e-15)


@pytest.mark.parametrize("weight", ["200 N", "200 Н", "0.2 kN", "0,2 кН"])
def test_a_weight_in_newtons_becomes_a_mass_by_the_g_of_the_scene(weight):
    assert parse(weight, "mass") == pytest.approx(200 / 9.81, rel=1e-15)
    with measuring(Measures(gravity=10.0)):
        assert parse(weight, "mass") == 20.0


def test_a_mass_for_a_force_is_answered_with_its_weight():
    with pytest.raises(ValueError, match='"100 lb" is a mass; its weight is "100 lbf"; a force is'):
        parse("100 lb", "force")
    with pytest.raises(ValueError, match='its weight is "1500 kgf"'):
        parse("1.5 t", "force")


@pytest.mark.parametrize(
    ("value", "words"),
    [
        ("1 000 mm", "two ways.*one piece"),
        ("1\u00a0000 mm", "two ways.*one piece"),
        ("1_000 mm", "two ways"),
        ("1'000 mm", "two ways"),
        ("1,000 mm", r"decimal comma.*1\.000.*1000"),
        ("1.000,5 mm", "two ways"),
        ("1/2 m", "fraction; write it as a decimal"),
        ("95", 'has no unit; write "95 mm"'),
        ("", "not a number with a unit"),
        ("mm", "not a number with a unit"),
        ("nan mm", "not a number"),
        ("1e400 mm", "not a finite number"),
        ("1e308 km", "too large"),
        ("9" * 150 + " mm", "too large"),
        ("9" * 500 + " mm", "not a number"),
        ("95 mn", 'did you mean "mm"'),
        ("٣ mm", "not a number"),
        ("5 рад/c", "unit"),
        (math.nan, "not a finite"),
        (math.inf, "not a finite"),
        (10**400, "too large"),
        (True, "true .*a length is wanted"),
        ([1], "list"),
        ({}, "table"),
    ],
)
def test_refuses(value, words):
    with pytest.raises(ValueError, match=words):
        parse(value, "length")


def test_two_alphabets_in_one_unit_are_pointed_out():
    with pytest.raises(ValueError, match='mixes Latin and Russian letters; did you mean "рад/с"'):
        parse("5 рад/c", "angular speed")


def test_every_spelling_is_its_own_plain_form():
    assert [spelling for spelling in UNITS if plain_unit(spelling) != spelling] == []


@given(
    st.sampled_from(sorted(UNITS)),
    st.decimals(-(10**4), 10**4, places=3),
    st.sampled_from(["", " ", "\u00a0", "\u202f"]),
    st.booleans(),
)
def test_round_trip(spelling, number, space, comma):
    dimension, factor = UNITS[spelling]
    text = f"{number:f}".replace(".", "," if comma else ".")
    space = space or (" " if spelling[0] == "1" else "")
    if comma and abs(number) >= 1 and abs(number) < 1000:
        with pytest.raises(ValueError, match="two ways"):  # 1,250: a thousand or a comma?
            parse(text + space + spelling, dimension)
        return
    due = float(number) * factor if isinstance(factor, float) else float(number * factor)
    if abs(due) > LARGEST:
        return
    assert parse(text + space + spelling, dimension) == due


@given(st.text(max_size=30))
def test_never_anything_but_a_value_error(text):
    try:
        found = parse(text, "length")
    except ValueError:
        return
    assert math.isfinite(found)


def test_decimal_factors_are_correctly_rounded():
    assert all(
        parse(f"{n}.{n % 10} mm", "length") == float(Decimal(f"{n}.{n % 10}") / 1000)
        for n in range(1000)
    )


@pytest.mark.parametrize("value", [5.551115123125783e-17, -1e-300, 5e-324, "1e-20 m", "9e-10 mm"])
@pytest.mark.parametrize("dimension", ["length", "angle"])
def test_what_rounding_leaves_of_zero_is_zero(value, dimension):
    if dimension == "length" or not isinstance(value, str):
        assert parse(value, dimension) == 0.0
    assert parse("1e-9 mm", "length") == 1e-12
    assert parse(1e-16, "force") == 0.0


FEET = {
    # published factors: NIST SP 811, appendix B.8 (to the digits given there)
    "length": [("1 ft", 0.3048), ("1 in", 0.0254)],
    "speed": [("1 ft/s", 0.3048)],
    "acceleration": [("1 ft/s^2", 0.3048)],
    "mass": [("1 lb", 0.4535924), ("1 slug", 14.59390)],
    "force": [("1 lbf", 4.448222), ("1 kip", 4448.222)],
    "pressure": [("1 psi", 6894.757), ("1 lbf/ft^2", 47.88026)],
    "moment": [("1 lbf*ft", 1.355818), ("1 lb-ft", 1.355818), ("1 lbf in", 0.1129848)],
    "moment of inertia": [
        ("1 lb*in^2", 2.926397e-04),
        ("1 lb-ft2", 0.04214011),
        ("1 slug*ft^2", 1.355818),
        ("1 lbf*in*s^2", 0.1129848),
    ],
    "density": [("1 lb/in^3", 2.767990e04), ("1 lb/ft^3", 16.01846)],
    "power": [("1 hp", 745.6999)],
}


@pytest.mark.parametrize("dimension", FEET)
def test_feet_and_pounds(dimension):
    for text, value in FEET[dimension]:
        assert parse(text, dimension) == pytest.approx(value, rel=5e-7), text

"""Why a planetary train and its pictures of velocities are drawn as they are: the arguments of the book."""

from __future__ import annotations

from graphic_tmm.language.said import said

AXIS = said("The axis of the train; radii are laid off square to it.")
MESH = said(
    "Pitch circles touch in the mesh: its distance from the axis is the radius of the central wheel."
)
SATELLITES = said(
    "The carrier holds the satellites evenly about the axis, so that their forces balance."
)
CIRCLE = said("The pitch circle of the wheel.")
LEVEL = said("The level of this point is carried over to the other views.")
DISC = said(
    "Seen from the side a wheel is a line of the length of its radius to either side of its axis."
)
ZERO = said("On this line velocities begin: a point that stands still is on it.")
KNOWN_VELOCITY = said(
    "The velocity of the driving point is known: it is square to the radius, to scale."
)
SATELLITE_LINE = said(
    "The satellite touches the wheel that stands still in C, where it has no velocity, so its velocities "
    "grow from there in proportion to the distance."
)
SOUGHT_VELOCITY = said(
    "The point belongs to the satellite too: its velocity ends on the satellite's line."
)
BODY_LINE = said(
    "The body turns about the axis of the train: its velocities grow in proportion to the radius."
)
VELOCITY_READ = said("The segment, times the scale factor, is the velocity.")
RATES_LINE = said("On this line the segments will be the angular velocities of all bodies.")
RATES_POLE = said("The pole distance gives the scale of angular velocities.")
RATE_RAY = said(
    "The slope of a body's line is its angular velocity: a ray of the same slope cuts it off, whatever the "
    "radius."
)
RATE_READ = said(
    "The segment from the body that stands still is the angular velocity, with its sense."
)

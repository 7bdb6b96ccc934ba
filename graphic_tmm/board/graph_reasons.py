"""Why graphs on axes are drawn, differentiated and integrated as they are."""

from __future__ import annotations

from graphic_tmm.language.said import said

BASE_AXIS = said(
    "The base of the graph stands for the turn of the crank: time, or angle, from the zero position on."
)
UP_AXIS = said("Ordinates are laid off square to the base.")
FOOT = said("Each position stands over its own share of the base.")
END = said("The base ends where the turn does.")
ORDINATE_LINE = said("Over its place on the base each position has an ordinate of its own.")
ORDINATE = said("The ordinate shows, to scale, what was found for this position.")
REPEATS = said("After a whole turn everything repeats itself: the graph ends as high as it began.")
ORDINATE_READ = said(
    "The ordinate of the graph, times its scale factor, is the quantity in this position."
)
POLE_LINE = said(
    "The pole stands on the axis of the base, before its origin: rays from it slope as the graph does."
)
POLE = said(
    "Over the pole distance a ray of the slope tan α rises by H·tan α: the distance decides the scale."
)
CHORD = said(
    "The chord has the mean slope of the graph over its interval; in the middle of the interval the graph "
    "slopes nearly alike."
)
RAY = said(
    "A ray from the pole with this slope cuts off, on the axis of ordinates, a segment proportional to the "
    "slope: to the derivative."
)
CUT_OFF = said(
    "The segment from the origin to here is the derivative, to the scale that the pole distance gives."
)
CARRIED = said("What was cut off on the axis is carried across to where it belongs on the base.")
MEAN_LEVEL = said("The mean ordinate of the interval is carried across to the axis of ordinates.")
MEAN_RAY = said(
    "The ray from the pole to the mean ordinate has the slope with which the integral rises over this "
    "interval."
)
STATION = said(
    "The base is divided into as many equal parts as the turn; a position outside the row stands between "
    "its neighbours as the crank pin divides their arc."
)

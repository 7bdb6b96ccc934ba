"""Why a drum cam and a groove are drawn as they are; what their views are called."""

from __future__ import annotations

from graphic_tmm.language.said import said

CAPTIONS: dict[str, str] = {
    "cam drum": said("Mean radius of the drum"),
    "cam development": said("Development of the drum"),
    "drum_radius_min": "R_{min}",
    "drum_radius": said("R of the drum"),
    "roller_by_drum_radius": said("[r] by R"),
    "left_roller_drum_radius": said("[r] by R − r"),
}

RADIUS = said("The least mean radius of the drum is {drum_radius_min}; {drum_radius} is taken.")
CURVATURE = said(
    "The curvature of the roller's path follows from how its tangent turns on the development; in this "
    "position:"
)
ALL = said(
    "All conditions of the drum hold: below the allowed pressure angle {left_rise} are left on the rise "
    "and {left_return} on the return, below the largest radius of the roller {left_roller_drum_radius} by the "
    "drum's radius and {left_roller_profile} by the path."
)
FINDINGS = {
    "drum pressure": said(
        "the pressure angle reaches {value:.4g}° at φ = {angle:.4g}°, {limit:g}° are allowed: the mean "
        "radius of {r0:.4g} mm is too small, take {least:.4g} mm at least"
    ),
    "drum roller by r0": said(
        "the roller's radius {value:.4g} mm is larger than {limit:.4g} mm, the allowed share of the mean "
        "radius"
    ),
    "drum roller by curvature": said(
        "the roller's radius {value:.4g} mm is larger than {limit:.4g} mm, the allowed share of the least "
        "radius of curvature of its path, at φ = {angle:.4g}°"
    ),
    "drum undercut": said(
        "the roller of {value:.4g} mm cuts a flank of the groove away at φ = {angle:.4g}°, where the "
        "radius of curvature of its path is {limit:.4g} mm: take a smaller roller or a larger mean radius"
    ),
    "drum sharp": said(
        "the radius of curvature of the roller's path falls to {value:.4g} mm at φ = {angle:.4g}°, "
        "{limit:.4g} mm are the least: take a larger mean radius than {r0:.4g} mm"
    ),
}
"""By kind of finding."""

STATED = said("The cam is a drum; its groove moves a roller whose rod goes along the drum's axis.")
GROOVE = said("The roller runs in a groove of the cam.")
ASKS = (
    said(
        "The least mean radius of the drum is found by the largest pressure angle allowed; the radius is "
        "chosen."
    ),
    said("The drum is developed: the path of the roller and both flanks of the groove are drawn."),
)

RATE_AT = said("The derivative dS/dφ stands on the axis at whose distance R the pole is sought.")
TURNING = said(
    "On the development the normal turns as the tangent does, whose slope is dS/dφ over R: its derivative "
    "by the angle, taken positive where the groove's lower flank is convex."
)
LIMIT = said(
    "Nearer to the axis than this point the pressure angle would pass its limit in this phase."
)
GREATER = said("The limits of rise and return have to hold both: the greater value rules.")
POLE = said("The pole stands before the axis at the mean radius of the drum.")
RAY = said(
    "While the drum turns by a radian the roller goes on along it by R and across it by dS/dφ: this ray is"
    " parallel to the tangent of its path."
)
ANGLE = said(
    "The rod moves square to the circumference, the force along the normal of the path: between them is "
    "the angle of the tangent with the circumference."
)
BASE_LINE = said("The mean circumference of the drum, unrolled, is a straight line.")
FOOT = said("Turned by φ, the drum has gone on by R·φ at its mean radius.")
PATH_POINT = said(
    "Over this place of the circumference the roller's centre stands at its displacement."
)
TANGENT = said("The tangent of the path is parallel to the ray to the end of the derivative.")
NORMAL = said("Cam and follower touch on the normal of the path.")
DWELL = said("While the follower rests its path is parallel to the way of the cam.")
FLANK = said("The outer flank touches the roller on the other side, on the same normal.")

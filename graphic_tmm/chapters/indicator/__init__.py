"""The indicator diagram of a cylinder: the pressure on each side of a piston over its stroke.

The base of the diagram is the stroke; it is divided as the piston travels, not evenly: the piston's
positions are carried from the plan of positions onto it by an auxiliary ray (similar triangles), since
travel on the plan and base of the diagram have lengths of their own. Over each position stands the pressure
of that part of the working cycle, going or coming back.

Pressures are given position by position, or by the parts of the two strokes: straight between given points,
or polytropic. For a gas p·V^n = const, and V is the clearance plus the travel, so with lengths as shares of
the stroke p = p₁·((c + x₁)/(c + x))^n on the cover's side; on the shaft's side the travel is counted from
the other end. On which part a position stands is chosen before the log is run, by the exact travel; the
pressure itself is a step, by the travel as measured.

Of several cylinders the base of each begins at the dead centre of its own piston, which is drawn where the row
does not begin there (`kinematics.dead_centres`); in a cylinder that swings the travel is the change of its
length. Pistons of the same pressures that follow each other by whole positions share one diagram, each with
a row of its own positions (`sharing`). A cycle of four strokes begins at the first dead centre away from the
crank, or a turn later by its ``phase``. The reduced moments of all add up.

The force of the gas is the pressure on the cover's area less that on the ring that the rod leaves of it on
the shaft's side: P = p_k·F_k − p_v·F_v. It is positive away from the cover.

Draws no place of its own: its diagram stands with the chapter that needs the gas (`Wish`: forces, flywheel
or engine, the greatest wish wins). Builds on kinematics (the travel) and diagrams (`sliding_leg`).

Sources: Артоболевский И. И., Теория механизмов и машин (диаграммы сил, индикаторная диаграмма); the book
chapter on the forces in the crank mechanism of a steam engine, formula (338) (scene ``locomobile``); the
course project of the flywheel of a single-cylinder engine (scene ``engine``).
"""

from __future__ import annotations

from graphic_tmm.chapters.diagrams.task import DIAGRAMS
from graphic_tmm.chapters.indicator.sections import SECTIONS
from graphic_tmm.chapters.indicator.task import INDICATOR
from graphic_tmm.chapters.kinematics.task import KINEMATICS
from graphic_tmm.scene.chapter import Chapter

CHAPTER = Chapter(
    name=INDICATOR,
    number=4,
    drive="crank",
    builds_on=(KINEMATICS, DIAGRAMS),
    sections=SECTIONS,
)

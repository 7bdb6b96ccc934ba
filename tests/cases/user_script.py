"""A script as a user writes it: every verb, checked by mypy --strict as it stands."""

from typing import reveal_type

import numpy as np

import graphic_tmm as tmm

scene = tmm.read("crank-rocker", language="en")
scene = scene.with_({"drive.speed": "600 rpm"}, title="Mine")
reveal_type(scene)
reveal_type(tmm.scenes())
drawn = tmm.draw(scene, hand="student", seed=7, trials=10)
reveal_type(drawn)
table = drawn.table("velocities")
reveal_type(table)
reveal_type(table["pb"].mm)
reveal_type(table["pb"].at(3))
reveal_type(table.to_records())
reveal_type(drawn.results["J_fly"] * 2)
reveal_type(drawn.results["J_fly"].unit)
reveal_type(drawn.scales["mu_l"])
reveal_type(drawn.warnings)
steps = drawn.steps("velocities", 3, why=True)
reveal_type(steps[0].value)
reveal_type(drawn.sheets[0].save("sheet.svg"))
reveal_type(drawn.save("page.html"))
found = drawn.check([{"plan": "velocities", "position": 1, "segment": "pa", "mm": 60.0}])
reveal_type(found.verdicts[0].verdict)
reveal_type(found.mistakes[0].chance)
reveal_type(drawn.plot("velocities", ["pb"]))
motion = tmm.motion(scene, np.linspace(0, 360, 13), ["B"])
reveal_type(motion["B"].velocity)
reveal_type(tmm.motion("crank-rocker", 40.0, plans="velocities"))
board = tmm.Board(hand="student", trials=3)
start = board.point("O", 0, 0)
end = board.lay_off("A", board.ray("a", start, np.arange(3.0)), 20)
reveal_type(board.value(board.measure("OA", start, end)))
reveal_type(board.where(end))
reveal_type(board.save("board.svg"))
try:
    drawn.table("nothing")
except (tmm.AbsentError, tmm.SceneError) as error:
    reveal_type(error)
reveal_type(tmm.__version__)

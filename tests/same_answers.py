"""Hash everything that a person can get out of every packaged scene: run before and after a redesign, compare.

python same_answers.py > before.txt      # then change the code
python same_answers.py | diff before.txt -
"""

import hashlib
import json

from click.testing import CliRunner

from graphic_tmm.__main__ import main
from graphic_tmm.packaged import packaged
from graphic_tmm.scene.read import read
from graphic_tmm.scene.schema import schema
from graphic_tmm.studio import sheet_files


def told(*args):
    found = CliRunner().invoke(main, list(map(str, args)))
    text = f"{found.exit_code}\n{found.stdout}\n{found.stderr}"
    return text.replace(str(packaged()[0].parent), "sheets")  # warnings name the file


def line(name, text):
    data = text if isinstance(text, bytes) else text.encode()
    print(hashlib.sha256(data).hexdigest()[:16], len(data), name, flush=True)


line("schema", json.dumps(schema(), ensure_ascii=False, sort_keys=True))
for folder in packaged():
    name = folder.name
    for file, text in sheet_files(read(folder))[1].items():
        line(f"{name} sheet {file}", text)
    line(f"{name} table json", told("table", folder, "-f", "json"))
    line(f"{name} table exact csv", told("table", folder, "-f", "csv", "--exact"))
    line(
        f"{name} table student",
        told("table", folder, "-f", "json", "--hand", "student", "--seed", "7"),
    )
    for language in ("ru", "en"):
        line(f"{name} steps {language}", told("steps", folder, "-l", language))
    if (folder / "published.csv").exists():
        line(
            f"{name} check",
            told("check", folder, folder / "published.csv", "-f", "json", "--trials", "40"),
        )

"""Write everything that a person can get out of every packaged scene: run before and after a redesign, compare.

    python tests/same_answers.py BEFORE      # then change the code
    python tests/same_answers.py AFTER
    diff -r BEFORE AFTER

One file an answer, so that a difference in words is seen as words. Pages are told by the data that they carry,
documents by their XML. ``--scenes a,b``: of these alone; ``--jobs 1``: in one process.
"""

from __future__ import annotations

import argparse
import base64
import gzip
import hashlib
import io
import json
import re
import shutil
import sys
import tempfile
import zipfile
from collections.abc import Iterator, Mapping
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from pathlib import Path

import numpy as np
from click.testing import CliRunner

import graphic_tmm
from graphic_tmm.__main__ import main
from graphic_tmm.scene.new import schema
from graphic_tmm.scene.packaged import packaged

sys.path.insert(0, str(Path(__file__).parent / "hard"))

from fuzz_mechanisms import filled
from support.served import copied, opened, run

ANGLES = np.arange(24) * 15.0
NAMES = ("places", "velocities", "accelerations", "omega", "epsilon", "forces", "balance")
LANGUAGES = ("en", "ru")
CARRIED = re.compile(r'(<script type="application/octet-stream"[^>]*>)([^<]*)</script>')
PROGRAM = re.compile(r"<(script|style)[ >].*?</\1>", re.DOTALL)
HASHES = re.compile(r"sha256-[^']*")
"""Of the page's program and looks: they are no answer."""
PRINTED = {
    "table json": ("table", "-f", "json"),
    "table exact csv": ("table", "-f", "csv", "--exact"),
    "table student": ("table", "-f", "json", "--hand", "student", "--seed", "7"),
    "table trials": ("table", "--trials", "20"),
    "steps": ("steps", "--why"),
    "steps scales": ("steps", "-p", "scales"),
    "template": ("template",),
    "accuracy": ("accuracy", "-f", "json", "--no-time", "--trials", "10"),
}
WRITTEN = {
    "draw": ("draw", "-f", "svg,dxf", "--composition"),
    "student": ("draw", "--hand", "student", "--seed", "3"),
    "note": ("note", "-f", "md,docx"),
    "page": ("page",),
    "practice": ("page", "--practice"),
    "task": ("task", "--keys", "sheets,table", "--readings", "-j", "1"),
}
DEAR = {"sheets of steps": ("steps", "--sheets")}
"""What takes as long as all the rest: in English only."""


def printed(*words: object) -> str:
    """Return what a command says, and its status; the scene's folder is one of its kind."""
    done = CliRunner().invoke(main, [str(word) for word in words])
    said = f"{done.exit_code}\n{done.stdout}\n{done.stderr}"
    return said.replace(str(packaged()[0].parent), "sheets")


def written(*words: object) -> Iterator[tuple[str, bytes]]:
    """Yield what a command says, then its files, by their names."""
    with tempfile.TemporaryDirectory() as out:
        said = printed(*words, "-o", out)
        yield "said.txt", said.replace(out, "out").encode()
        for path in sorted(Path(out).rglob("*")):
            name = path.relative_to(out).as_posix()
            if path.is_file() and not name.startswith(".") and "/." not in name:
                yield from _parts(name, path.read_bytes())


def _parts(name: str, data: bytes) -> Iterator[tuple[str, bytes]]:
    if name.endswith(".html"):
        page = data.decode()
        for head, carried in CARRIED.findall(page):
            of = (re.findall('id="([^"]*)"', head) or ["data"])[0]
            if carried.strip():
                yield f"{name}/{of}", gzip.decompress(base64.b64decode(carried))
        yield f"{name}/text", HASHES.sub("", PROGRAM.sub("", page)).encode()
    elif name.endswith((".docx", ".zip")):
        with zipfile.ZipFile(io.BytesIO(data)) as archive:
            for part in sorted(archive.namelist()):
                yield f"{name}/{part}", archive.read(part)
    else:
        yield name, data


def moved(folder: Path) -> Iterator[tuple[str, bytes]]:
    """Yield the numbers of a motion at 24 angles, by what they are called; of forces where there are any."""
    for plans in (("positions", "velocities", "accelerations"), ("forces",)):
        for fast in (False, None):
            try:
                found = graphic_tmm.motion(folder, ANGLES, plans=plans, fast=fast)
            except graphic_tmm.TmmError as refused:
                yield (
                    f"{plans[-1]} {fast}",
                    str(refused).replace(str(packaged()[0].parent), "sheets").encode(),
                )
                continue
            for name in NAMES:
                try:
                    rows: Mapping[object, np.ndarray] = getattr(found, name)
                    lines = [f"{key} {np.asarray(row).tolist()}" for key, row in rows.items()]
                except graphic_tmm.TmmError:
                    continue  # not asked for
                yield f"{plans[-1]} {fast} {name}", "\n".join(lines).encode()


def judged(folder: Path, language: str) -> Iterator[tuple[str, bytes]]:
    """Yield how readings are judged of which every fifth is half as large again."""
    with tempfile.TemporaryDirectory() as home:
        template, readings = Path(home) / "template.csv", Path(home) / "readings.csv"
        printed("template", folder, "-l", language, "-o", template)
        if template.exists():
            readings.write_bytes(filled(template.read_text("utf-8-sig"), folder / "scene.toml"))
            asked = ("check", folder, readings, "--trials", "20", "-l", language, "-f", "json")
            yield "readings.csv", readings.read_bytes()
            yield "report.json", printed(*asked).replace(home, "home").encode()


def served(folder: Path) -> Iterator[tuple[str, bytes]]:
    """Yield what a browser is answered that asks for a scene, its values, its sheets."""
    found: dict[str, bytes] = {}

    async def serving() -> None:
        with tempfile.TemporaryDirectory() as home:
            file = copied(folder.name, Path(home))
            async with opened(file) as (browser, _):
                state = await browser.settled(folder.name)
                for path in ("/", f"/s/{folder.name}/", f"/s/{folder.name}/form"):
                    body = (await browser.ask(path)).body.decode()
                    body = PROGRAM.sub("", body).replace(browser.token, "TOKEN")
                    found[path.strip("/").replace("/", " ") or "gallery"] = body.encode()
                found["state"] = json.dumps(state, ensure_ascii=False, indent=1).encode()
            for name, body in found.items():
                found[name] = body.replace(home.encode(), b"home")

    run(serving)
    yield from found.items()


def answers(folder: Path) -> Iterator[tuple[str, bytes]]:
    """Yield all answers of a scene by their names."""
    for language in LANGUAGES:
        for name, (command, *words) in PRINTED.items():
            said = printed(command, folder, *words, "-l", language)
            yield f"{language}/{name}", said.encode()
        files = WRITTEN | (DEAR if language == "en" else {})
        for name, (command, *words) in files.items():
            for file, data in written(command, folder, *words, "-l", language):
                yield f"{language}/{name}/{file}", data
        for name, data in judged(folder, language):
            yield f"{language}/check/{name}", data
    for name, data in moved(folder):
        yield f"motion/{name}", data
    for name, data in served(folder):
        yield f"served/{name}", data


def kept(out: Path, folder: Path) -> tuple[str, int]:
    """Write the answers of a scene; return its name and their number."""
    shutil.rmtree(out / folder.name, ignore_errors=True)
    count = 0
    for name, data in answers(folder):
        count += 1
        path = out / folder.name / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_bytes(data)
    return folder.name, count


def of_all() -> Iterator[tuple[str, str]]:
    """Yield what is told of no scene."""
    yield "schema.json", json.dumps(schema(), ensure_ascii=False, sort_keys=True, indent=1)
    for language in LANGUAGES:
        for name in ("keys", "scenes"):
            yield f"{name}.{language}.txt", printed(name, "-l", language)
        for name in main.list_commands(None):  # type: ignore[arg-type]
            yield f"help {name}.{language}.txt", printed(name, "--help", "-l", language)


def whole() -> None:
    """Read what is wanted, write it, tell a hash a scene."""
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("out", type=Path)
    parser.add_argument("--scenes", default="")
    parser.add_argument("--jobs", type=int, default=2)
    asked = parser.parse_args()
    asked.out.mkdir(parents=True, exist_ok=True)
    for name, text in of_all():
        (asked.out / name).write_text(text, encoding="utf-8")
    names = asked.scenes.split(",") if asked.scenes else [one.name for one in packaged()]
    folders = [one for one in packaged() if one.name in names]
    with ProcessPoolExecutor(asked.jobs) as pool:
        for name, count in pool.map(partial(kept, asked.out), folders):
            files = sorted(path for path in (asked.out / name).rglob("*") if path.is_file())
            sums = "".join(hashlib.sha256(path.read_bytes()).hexdigest() for path in files)
            print(hashlib.sha256(sums.encode()).hexdigest()[:16], count, name, flush=True)


if __name__ == "__main__":
    whole()

"""The command batch: what it makes, what it names, how it ends."""

from __future__ import annotations

import subprocess
import sys
from pathlib import Path

import pytest
from support.batches import files_of
from support.command import invoke, printed
from support.each import each

SCENE = "shaper"


@pytest.fixture
def table(tmp_path: Path) -> Path:
    file = tmp_path / "variants.csv"
    file.write_text("variant,OA\n1,108\n2,нет\n3,400\n4,112\n", encoding="utf-8")
    return file


@pytest.mark.slow
def test_what_is_good_is_made_and_the_rest_named(table: Path, tmp_path: Path) -> None:
    out = tmp_path / "out"
    done = invoke("batch", SCENE, table, "-o", out, "--make", "table", "--jobs", 1, "-l", "en")
    assert done.exit_code == 1
    assert set(files_of(out)) == {"1/shaper-1.csv", "4/shaper-4.csv"}
    assert done.stdout == f"{out}: 2 made, 0 there already, 2 failed\n"
    lines = done.stderr.splitlines()
    assert f"{table}:3: OA: variant 2:" in lines[0]
    assert "variant 3:" in lines[1]
    assert len(lines) == 2
    again = invoke("batch", SCENE, table, "-o", out, "--make", "table", "--jobs", 1, "-l", "en")
    assert again.stdout == f"{out}: 0 made, 2 there already, 2 failed\n"


@pytest.mark.slow
def test_what_was_made_else_of_a_variant_stays(tmp_path: Path) -> None:
    table, out = tmp_path / "variants.csv", tmp_path / "out"
    table.write_text("variant,OA\n1,108\n")
    printed("batch", SCENE, table, "-o", out, "--make", "table", "--jobs", 1)
    printed("batch", SCENE, table, "-o", out, "--make", "table", "-f", "json", "--jobs", 1)
    assert set(files_of(out)) == {"1/shaper-1.csv", "1/shaper-1.json"}


@each(
    "options, said",
    [
        (("--make", "drwa"), "--make: no drwa; choose from draw, table, note, page, scene"),
        (("-f", "csv"), "--format: no csv; choose from svg, pdf, png, dxf, html"),
        (("--make", "table", "-f", "svg"), "--format: no svg; choose from csv, json"),
        (("--jobs", "0"), "--jobs"),
        (("--jobs", "1", "--scheduler", "tcp://127.0.0.1:9"), "take one"),
        (("--scheduler", "nonsense"), "no scheduler answers at nonsense"),
    ],
)
def test_what_is_asked_wrongly_is_one_message(
    options: tuple[str, ...], said: str, tmp_path: Path
) -> None:
    table = tmp_path / "variants.csv"
    table.write_text("variant,OA\n1,108\n")
    done = invoke("batch", SCENE, table, "-o", tmp_path / "out", "-l", "en", *options)
    assert done.exit_code == 2, done.output
    assert said in done.stderr
    assert files_of(tmp_path / "out") == {}


def test_a_table_that_is_not_there_is_one_message(tmp_path: Path) -> None:
    done = invoke("batch", SCENE, tmp_path / "none.csv", "-o", tmp_path / "out", "-l", "en")
    assert (done.exit_code, done.stdout) == (2, "")
    assert "there is no such file" in done.stderr


@pytest.mark.slow
@pytest.mark.skipif(sys.platform == "win32", reason="signals")
def test_broken_off_it_tells_how_to_go_on(tmp_path: Path) -> None:
    import os
    import signal
    import time

    table, out = tmp_path / "variants.csv", tmp_path / "out"
    rows = "".join(f"{k},{100 + k}\n" for k in range(12))
    table.write_text(f"variant,OA\n{rows}")
    command = [sys.executable, "-m", "graphic_tmm", "batch", SCENE, table, "-o", out, "-l", "en"]
    process = subprocess.Popen(
        [*map(str, command), "--jobs", "1"],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
    )
    until = time.monotonic() + 60
    while not any(out.rglob("*.json")) and time.monotonic() < until:
        time.sleep(0.05)
    os.killpg(process.pid, signal.SIGINT)
    told, errors = process.communicate(timeout=60)
    assert (process.returncode, told) == (130, "")
    assert len(errors.split("\n\n")[0].splitlines()) == 1
    assert "of 12 done; run the same command again to make the rest" in errors
    rest = printed("batch", SCENE, table, "-o", out, "-l", "en", "--jobs", 1)
    assert "0 failed" in rest
    assert " 12 made" not in rest

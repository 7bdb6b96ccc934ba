"""Draw, tell and check with the program that is installed, each extra once; every file must be what it says."""

import json
import signal
import subprocess
import sys
from pathlib import Path
from urllib.request import urlopen

BEGINS = {".svg": b"<svg", ".pdf": b"%PDF", ".png": b"\x89PNG", ".dxf": b"  0"}
ENDS = "118,3478 4937,3478 4937,30 118,30"
"""Of the frame of an A1 at 150 dots to the inch: 20 mm and 5 mm from its edges."""


def run(program: str, *arguments: object, status: int = 0) -> str:
    """Return what a command prints that ends with a status."""
    command = [program, *map(str, arguments)]
    print("+", *command[1:], flush=True)
    done = subprocess.run(command, check=False, stdout=subprocess.PIPE, encoding="utf-8")
    assert done.returncode == status, (command, done.returncode)
    return done.stdout


def main(program: str, home: Path) -> None:
    """Try the program; all files go to a folder of their own."""
    home.mkdir(parents=True)
    drawn = run(program, "draw", "engine", "-o", home, "-f", ",".join(BEGINS).replace(".", ""))
    for path in map(Path, drawn.split()):
        assert path.read_bytes().startswith(BEGINS[path.suffix]), path
    assert len(drawn.split()) == len(BEGINS)
    assert json.loads(run(program, "table", "engine", "-f", "json"))["columns"]
    assert "│" in run(program, "table", "cam")
    assert "1. " in run(program, "steps", "gear-pair")
    assert json.loads(run(program, "schema"))["properties"]
    run(program, "new", home / "mine", "--like", "crank-rocker")
    told = json.loads(run(program, "table", home / "mine", "-f", "json"))
    (due,) = (c for c in told["columns"] if (c["plan"], c["segment"]) == ("velocities", "pb"))
    rows = zip(told["positions"], due["mm"], strict=True)
    lines = [f"velocities,{at['number']},pb,{mm}" for at, mm in rows]
    (home / "readings.csv").write_text("\n".join(["plan,position,segment,mm", *lines]) + "\n")
    report = run(
        program, "check", home / "mine", home / "readings.csv", "-f", "json", "--trials", 50
    )
    assert len(json.loads(report)["readings"]) == len(lines)
    page = run(program, "check", home / "mine", home / "readings.csv", "-f", "html", "--trials", 50)
    assert page.startswith("<!DOCTYPE html>")
    assert page.count("<tr") == 1 + len(lines)
    short = home / "short.xlsx"
    written = run(program, "check", home / "mine", "--template", "--short", "-o", short)
    assert written.split() == [str(short), str(home / "short.svg")]
    run(program, "check", home / "mine", short, "-f", "json", status=2)  # nothing is filled in
    photo = ("--photo", home / "engine.png", "--corners", ENDS, "--overlay", home / "under.svg")
    assert run(program, "check", "engine", *photo, "-f", "md", status=3)  # not every plan is seen
    assert (home / "under-flat.png").exists()
    run(program, "accuracy", "cam", "--trials", 10, "--no-time", "-o", home)
    (home / "variants.csv").write_text("variant,drive.speed\n1,1100 rpm\n2,1300 rpm\n")
    tables = ("--make", "table", "-o", home / "batch", "--jobs", 2)
    run(program, "batch", "crank-rocker", home / "variants.csv", *tables)
    assert len(list((home / "batch").glob("?/crank-rocker-?.csv"))) == 2
    compiled(home)
    serve(program, home / "mine")


def compiled(home: Path) -> None:
    """Move a mechanism at many angles by every road of a log: they lead to the same numbers."""
    import numpy

    import graphic_tmm

    print("+ motion", flush=True)
    scene, angles = graphic_tmm.read("windrower"), numpy.linspace(0.0, 360.0, 70_001)
    one, two = (graphic_tmm.motion(scene, angles, ["D"], fast=fast) for fast in (False, True))
    least = float(numpy.nanmax(abs(one["D"].acceleration))) * 1e-9
    assert numpy.allclose(one["D"].acceleration, two["D"].acceleration, rtol=0.0, atol=least)
    board = graphic_tmm.Board()
    board.link(board.point("O", 0, 0), board.point("A", 40, 0))
    board.save(home / "board.svg")


def serve(program: str, scene: Path) -> None:
    """Serve a scene until it is drawn and its page made; then end it as Ctrl-C does."""
    print("+ serve", scene, flush=True)
    # a shell starts what runs beside it with Ctrl-C ignored, and a child would inherit that
    signal.signal(signal.SIGINT, signal.default_int_handler)
    with subprocess.Popen(
        [program, "serve", str(scene)], stdout=subprocess.PIPE, text=True
    ) as server:
        try:
            with urlopen(server.stdout.readline().strip(), timeout=60) as shown:
                assert b"<title>" in shown.read()
                address = shown.url
            with urlopen(address + "events", timeout=60) as events:
                states = (json.loads(line[6:]) for line in events if line.startswith(b"data: "))
                drawn = next(state for state in states if state["page"] or state["errors"])
            assert drawn["ok"], drawn
            assert drawn["sheets"], drawn
        finally:
            server.send_signal(signal.SIGINT)
    assert server.returncode == 130, server.returncode


main(sys.argv[1], Path(sys.argv[2]))

"""How soon an edit is in the browser's hands: the windrower served, its file changed, its events followed.

    python tests/benchmarks/follow.py [SCENE]

From the file being saved to the first event, to the first sheets and the last ones fetched, to the page; and
the seconds of the processor that the process in front took: on a machine with nothing else to do, that is the
time to the first sheets.
"""

from __future__ import annotations

import asyncio
import os
import sys
import time
from pathlib import Path
from tempfile import TemporaryDirectory

sys.path.insert(0, str(Path(__file__).parents[1]))

from support.served import Browser, copied, opened

EDITS = {
    "a number: the stroke": ('"95 mm"', '"{:g} mm"', (96.0, 96.5, 97.0)),
    "a title": ('"Привод ножа', '"{} привод ножа', ("Новый", "Другой", "Третий")),
    "a length that changes the composition: OB": ('"480 mm"', '"{:g} mm"', (700.0, 650.0, 720.0)),
    "a mass": ('"38 kg"', '"{:g} kg"', (40.0, 41.0, 42.0)),
    "a comment": ("# as long as", "# {} as long as", ("just", "half", "twice")),
}
"""What is changed for what; every time for something that was not there before."""


async def timed(browser: Browser, name: str, file: Path, text: str) -> list[float]:
    """Return the s from saving to the first event, to the first and to the last sheets fetched, to the page."""
    follow = browser.states(f"/s/{name}/events")
    before = await anext(follow)
    heard = first = last = page = float("nan")
    other = file.with_name("other~")
    other.write_text(text, encoding="utf-8")
    begun = time.perf_counter()
    os.replace(other, file)
    sheets = before["sheets"]
    while True:
        state = await anext(follow)
        now = time.perf_counter() - begun
        if heard != heard:
            heard = now
        if state["sheets"] != sheets:
            old = {one["hash"] for one in sheets}
            for one in state["sheets"]:
                if one["hash"] not in old:
                    await browser.ask(f"/s/{name}/sheet/{one['hash']}.svg")
            sheets = state["sheets"]
            last = time.perf_counter() - begun
            first = last if first != first else first
        if not state["busy"]:
            page = time.perf_counter() - begun
            break
    await follow.aclose()
    return [heard, first, last, page]


def cpu(process: int) -> float:
    """Return the seconds of the processor that a process has taken."""
    told = Path(f"/proc/{process}/stat").read_text(encoding="utf-8").rpartition(") ")[2].split()
    return (int(told[11]) + int(told[12])) / os.sysconf("SC_CLK_TCK")


async def main(scene: str) -> None:
    """Tell what every edit takes."""
    with TemporaryDirectory() as folder:
        file = copied(scene, Path(folder))
        text = file.read_text(encoding="utf-8")
        async with opened(file) as (browser, desk):
            begun = time.perf_counter()
            await browser.settled(scene)
            print(f"from nothing to the page: {time.perf_counter() - begun:.2f} s")
            await asyncio.sleep(3.0)
            print("saved to: heard, first sheets, last sheets, page; processor in front (s)")
            for name, (old, new, values) in EDITS.items():
                for value in values:
                    changed = text.replace(old, new.format(value))
                    assert changed != text
                    front = desk.front._process.pid
                    spent = cpu(front)
                    found = await timed(browser, scene, file, changed)
                    found.append(cpu(front) - spent)
                    await asyncio.sleep(1.0)
                    print(f"{name:45}", *(f"{s:6.2f}" for s in found), flush=True)


if __name__ == "__main__":  # the processes that draw load this file, too
    asyncio.run(main(sys.argv[1] if len(sys.argv) > 1 else "windrower"))

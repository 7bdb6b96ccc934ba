"""Modules of the page run by node, without a browser: what is asked goes in and comes back as JSON."""

from __future__ import annotations

import json
import shutil
import subprocess
from functools import cache
from pathlib import Path
from tempfile import mkdtemp
from typing import Any

from support.browser import without
from support.gallery import ROOT

WEB = ROOT / "graphic_tmm" / "page" / "web"
SECONDS = 300.0


@cache
def modules() -> Path:
    """Return a folder with the page's modules, which node takes for modules there."""
    folder = Path(mkdtemp(prefix="page-")) / "web"
    shutil.copytree(WEB, folder)
    (folder / "package.json").write_text('{"type": "module"}', encoding="utf-8")
    return folder


def run(program: str, asked: object = None, *further: Path | str, written: str = "") -> Any:
    """Run a program as a module beside those of the page; it has ``asked``, and answers by ``tell(x)``.

    It names modules as "./own/frame.js"; ``files`` are the further arguments; ``written``: the module that
    a page of a scene has beside them (`practice`), which is "./practice/written.js" then.
    """
    node = shutil.which("node")
    if node is None:
        without("node", "install it from the system's packages")
    folder = modules()
    begun = (
        'import { readFileSync } from "node:fs";\n'
        'const asked = JSON.parse(readFileSync(0, "utf-8"));\n'
        "const files = process.argv.slice(2);\n"
        "const tell = (answer) => process.stdout.write(JSON.stringify(answer));\n"
    )
    (folder / "practice" / "written.js").write_text(written, encoding="utf-8")
    main = folder / "asked.js"
    main.write_text(begun + program, encoding="utf-8")
    done = subprocess.run(
        [str(node), str(main), *map(str, further)],
        input=json.dumps(asked),
        capture_output=True,
        text=True,
        encoding="utf-8",
        timeout=SECONDS,
        check=False,
    )
    assert done.returncode == 0, done.stderr[-3000:]
    return json.loads(done.stdout)

"""What a process and those that it begins open, change or begin: written down by an audit hook.

``begin`` writes a `sitecustomize` into a folder; a Python that is begun with that folder on PYTHONPATH writes
each path that it touches into a file, one a line, before anything of it is done.
"""

from __future__ import annotations

from pathlib import Path

HOOK = """
import os, sys

_out = os.open({out!r}, os.O_WRONLY | os.O_APPEND | os.O_CREAT)
_EVENTS = {{
    "open", "os.rename", "os.remove", "os.rmdir", "os.mkdir", "os.link", "os.symlink", "os.truncate",
    "os.chmod", "os.chown", "os.listdir", "os.scandir", "os.utime", "shutil.rmtree", "subprocess.Popen",
    "os.system", "os.exec", "os.posix_spawn", "socket.connect", "ctypes.dlopen", "import",
}}


def _hook(event, told):
    if event not in _EVENTS or event == "import":
        return
    writes = event != "open" and event not in ("os.listdir", "os.scandir", "ctypes.dlopen")
    if event == "open":
        mode, flags = told[1], told[2] or 0
        writes = flags & (os.O_WRONLY | os.O_RDWR | os.O_CREAT)
        writes = writes if mode is None else set(mode) & set("wax+")
    paths = [one for one in told[: 1 if event == "open" else 2] if isinstance(one, (str, bytes))]
    for path in paths:
        path = os.fsdecode(path)
        line = "\\t".join([event, "write" if writes else "read", os.path.abspath(path)])
        os.write(_out, (line.replace("\\n", " ") + "\\n").encode("utf-8", "backslashreplace"))


sys.addaudithook(_hook)
"""


def begin(home: Path) -> tuple[Path, Path]:
    """Return the folder for PYTHONPATH, and the file in which everything will stand."""
    folder, out = home / "watched", home / "touched.txt"
    folder.mkdir()
    (folder / "sitecustomize.py").write_text(HOOK.format(out=str(out)), encoding="utf-8")
    return folder, out


def touched(out: Path) -> set[tuple[str, str, str]]:
    """Return what was touched: the event, "read" or "write", the path."""
    lines = out.read_text(encoding="utf-8").splitlines()
    return {(parts[0], parts[1], parts[2]) for line in lines if len(parts := line.split("\t")) == 3}

"""Build the program as one file that brings its own Python: `python .ci/single_file.py FOLDER`.

It is for the system that it is built on, with the extras that are small: the studio, PDF and PNG, DXF, tables
of readings. Of the packages that are installed here it takes what it uses, but for those that are left out.
"""

import sys
from pathlib import Path
from tempfile import TemporaryDirectory

from PyInstaller.__main__ import run

ROOT = Path(__file__).resolve().parents[1]
WHOLE = ("graphic_tmm", "uvicorn")
"""Packages of which all is taken: what they import by name, sources of operations, the version."""
LEFT_OUT = (
    # unpacked, MB: 58 with Pillow for one picture of `accuracy`; photographs 153, notes 155, fast motion 208
    *("matplotlib", "PIL", "cv2", "pypandoc", "llvmlite", "numba", "distributed", "dask"),
    # what those above, and tests, would bring
    *(
        "pandas",
        "tkinter",
        "IPython",
        "pytest",
        "hypothesis",
        "babel",
        "mpmath",
        "lxml",
        "playwright",
    ),
)
SCENES = (".toml", ".csv", ".md")
"""Ends of the files in sheets/ that go with the program, as in the wheel: no drawn sheet."""


def main(folder: Path) -> None:
    """Build the file into a folder."""
    scenes = [path for path in sorted(ROOT.glob("sheets/*/*")) if path.suffix in SCENES]
    homes = [f"graphic_tmm/scenes/{path.parent.name}" for path in scenes]
    with TemporaryDirectory() as work:
        run(
            [
                *("--onefile", "--clean", "--noconfirm", "--log-level", "WARN"),
                *("--name", "graphic-tmm", "--distpath", str(folder)),
                *("--workpath", work, "--specpath", work),
                *(f"--collect-all={name}" for name in WHOLE),
                "--collect-data=ezdxf",
                *(f"--exclude-module={name}" for name in LEFT_OUT),
                *(f"--add-data={path}:{home}" for path, home in zip(scenes, homes, strict=True)),
                str(ROOT / "graphic_tmm" / "__main__.py"),
            ]
        )


main(Path(sys.argv[1]))

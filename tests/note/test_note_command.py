"""The command `note`: files by name, an extra that is missing told with its remedy, wrong formats refused."""

from __future__ import annotations

import io
import sys
from pathlib import Path

import pytest
from click.testing import CliRunner
from support.gallery import SHEETS

from graphic_tmm.__main__ import main
from graphic_tmm.commands.shared import telling

SCENE = str(SHEETS / "slider-diagrams")


def run(*arguments: str) -> tuple[int, str]:
    """Exit status and all that is printed."""
    found = CliRunner().invoke(main, ["note", *arguments])
    return found.exit_code, found.output


@pytest.mark.parametrize(
    ("package", "form"), [("pypandoc", "html"), ("typst", "pdf"), ("typst", "docx")]
)
def test_a_package_that_is_missing_is_told_with_its_remedy(
    package: str, form: str, monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setitem(sys.modules, package, None)
    status, told = run(SCENE, "-f", form, "-o", str(tmp_path / "out"))
    assert status == 2
    assert 'pip install "graphic-tmm[note]"' in told
    assert not (tmp_path / "out").exists()


def test_a_format_that_there_is_none_of_is_refused(tmp_path: Path) -> None:
    status, told = run(SCENE, "-f", "pdf,odt", "-o", str(tmp_path / "out"))
    assert status == 2
    assert "odt" in told
    assert "docx" in told


@pytest.mark.slow
def test_files_are_named_after_the_scene_and_speak_the_language_asked_for(tmp_path: Path) -> None:
    status, _ = run(SCENE, "-f", "html", "-l", "en", "-o", str(tmp_path))
    assert status == 0
    page = (tmp_path / "slider-diagrams-note.html").read_text(encoding="utf-8")
    assert page.startswith('<!doctype html>\n<html lang="en">')
    assert "Explanatory note" in page


@pytest.mark.slow
def test_what_a_scene_is_called_is_data(tmp_path: Path) -> None:
    """A title with signs that formats know is told as it is written, in each of them."""
    text = (SHEETS / "slider-diagrams" / "scene.toml").read_text(encoding="utf-8")
    hostile = "<b>1 & 2</b> $x$ #set \\par *a* _b_"
    lines = [
        f"title = '{hostile}'" if line.startswith("title ") else line for line in text.split("\n")
    ]
    scene = tmp_path / "scene.toml"
    scene.write_text("\n".join(lines), encoding="utf-8")
    status, told = run(str(scene), "-f", "html,pdf,docx", "-o", str(tmp_path))
    assert status == 0, told
    page = next(tmp_path.glob("*.html")).read_text(encoding="utf-8")
    assert "<b>" not in page
    assert "&lt;b&gt;1 &amp; 2&lt;/b&gt; $x$ #set \\par *a* _b_" in page
    import pypdfium2

    found = pypdfium2.PdfDocument(next(tmp_path.glob("*.pdf")))
    assert found.get_metadata_dict()["Title"] == hostile
    found.close()


class Terminal(io.StringIO):
    """A stream that takes itself for a terminal."""

    def isatty(self) -> bool:
        """Return that it is one."""
        return True


@pytest.mark.parametrize("options", [[], ["--quiet"]])
def test_who_waits_for_a_note_is_told_what_is_done(
    options: list[str], monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    shown = Terminal()
    monkeypatch.setattr(sys, "stderr", shown)
    monkeypatch.setattr(telling, "PATIENCE", 0.0)
    monkeypatch.setenv("TERM", "xterm")
    words = ["note", SCENE, "-f", "md", "-l", "en", "-o", str(tmp_path), *options]
    with pytest.raises(SystemExit, match="0"):
        main.main(args=words)
    told = shown.getvalue()
    assert ("writing the note" in told) is not bool(options), told
    assert (tmp_path / "slider-diagrams-note.md").exists()

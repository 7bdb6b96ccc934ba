"""A tour of wrong scenes: each is refused with its file, its key and the remedy, and nothing is written."""

from __future__ import annotations

from pathlib import Path

from support.command import invoke
from support.each import each
from support.refusals import SCENE, refused, run
from support.scenes import written
from support.wrong_scenes import CASES


@each("old, new, words", CASES)
def test_a_wrong_scene(old: str, new: str, words: list[str], tmp_path: Path) -> None:
    assert old in SCENE
    file = written(tmp_path, SCENE.replace(old, new, 1))
    done = run(tmp_path, "draw", str(file), "-o", "out", "-f", "svg,dxf")
    refused(done, str(file) if "assembles" not in "".join(words) else "", *words)


def test_the_scene_that_is_made_wrong_is_right(tmp_path: Path) -> None:
    (tmp_path / "scene.toml").write_text(SCENE, encoding="utf-8")
    assert invoke("draw", tmp_path, "-o", tmp_path / "o").exit_code == 0


FILES = {
    "empty": (b"", ["title", "is missing"]),
    "zeros": (b"\0" * 100, ["not TOML"]),
    "latin-1": ('title = "Größe"'.encode("latin-1"), [":1:", "not in UTF-8; save it"]),
    "windows-1251": ('a = 1\ntitle = "Вал"'.encode("cp1251"), [":2:", "not in UTF-8; save it"]),
    "utf-16": (SCENE.encode("utf-16"), ["not in UTF-8; save it with the encoding UTF-8"]),
    "a workbook": (b"PK\x03\x04\xff", ["not in UTF-8"]),
    "a picture": (b"\x89PNG\r\n\x1a\n", ["not in UTF-8"]),
    "too large": (b"#" * 256_001, ["too large: a scene has at most 256 kB; name a scene file"]),
    "lists too deep": (b"a = " + b"[" * 5000, ["nested too deep"]),
    "lists rather deep": (b"a = " + b"[" * 50 + b"]" * 50, ["nested too deep"]),
    "keys too deep": (b"a." * 3000 + b"b = 1", ["nested too deep"]),
    "quoted keys too deep": (b'"a" . ' * 3000 + b"b = 1", ["nested too deep"]),
    "tables too deep": (b"[" + b"a." * 3000 + b"b]", ["nested too deep"]),
    "digits": (b"a = " + b"9" * 5000, ["a value cannot be read"]),
    "JSON": (b'{"title": "T"}', [":1:", "not TOML"]),
}


@each("what", FILES)
@each("command", [("draw", "-o", "out"), ("template",)])
def test_a_file_that_is_no_scene(command: tuple[str, ...], what: str, tmp_path: Path) -> None:
    data, words = FILES[what]
    (tmp_path / "s.toml").write_bytes(data)
    refused(run(tmp_path, command[0], "s.toml", *command[1:]), "s.toml", *words)

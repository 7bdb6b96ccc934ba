"""The scripts of the page, checked as they are written: types by tsc, faults by eslint."""

from __future__ import annotations

import json
import subprocess
from pathlib import Path

import pytest
from support.browser import WEB, tool
from support.gallery import ROOT

SCRIPTS = [ROOT / "graphic_tmm" / room / "web" for room in ("page", "serve")]


def typed(settings: Path) -> str:
    """What tsc complains of."""
    return ran(tool(".bin/tsc"), "--project", settings, "--pretty", "false")


def linted(where: Path, home: Path = ROOT) -> str:
    """What eslint complains of."""
    config = WEB / "eslint.config.js"
    return ran(tool(".bin/eslint"), "--max-warnings=0", "--config", config, where, home=home)


def ran(*command: Path | str, home: Path = ROOT) -> str:
    done = subprocess.run(
        list(map(str, command)), cwd=home, capture_output=True, text=True, check=False
    )
    assert done.returncode in (0, 1, 2), done.stderr
    assert (done.returncode == 0) == (not done.stdout + done.stderr), done.stderr
    return done.stdout + done.stderr


@pytest.mark.slow
def test_the_types_of_the_scripts_hold() -> None:
    assert typed(WEB / "tsconfig.json") == ""


@pytest.mark.slow
@pytest.mark.parametrize("scripts", SCRIPTS, ids=lambda folder: folder.parent.name)
def test_the_scripts_have_no_fault_that_is_seen_by_reading(scripts: Path) -> None:
    assert linted(scripts) == ""


WRONG_TYPES = {
    "a text for a number": "/** @type {number} */\nexport const size = 'a';",
    "maybe nothing": "document.querySelector('p').append('a');",
    "any without a word": "export function twice(x) { return x + x; }",
    "a name that nobody made": "unheard();",
}


@pytest.mark.slow
def test_the_check_of_types_can_fail(tmp_path: Path) -> None:
    for k, text in enumerate(WRONG_TYPES.values()):
        (tmp_path / f"m{k}.js").write_text(text, encoding="utf-8")
    settings = tmp_path / "tsconfig.json"
    told = {"extends": str(WEB / "tsconfig.json"), "include": [str(tmp_path / "*.js")]}
    settings.write_text(json.dumps(told), encoding="utf-8")
    found = typed(settings)
    assert [what for k, what in enumerate(WRONG_TYPES) if f"m{k}.js" not in found] == []


FAULTS = {
    "no-eval": "eval('1');",
    "no-new-func": "new Function('return 1')();",
    "no-restricted-properties": "document.body.innerHTML = '';",
    "no-restricted-syntax": "import('./other.js');",
    "no-restricted-globals": "fetch('x');",
    "no-console": "console.log(1);",
    "no-alert": "alert(1);",
    "max-lines": "\n".join(f"export const c{k} = {k};" for k in range(251)),
}


@pytest.mark.slow
def test_the_check_of_faults_can_fail(tmp_path: Path) -> None:
    for name, text in FAULTS.items():
        (tmp_path / f"{name}.js").write_text(text, encoding="utf-8")
    found = linted(tmp_path, tmp_path)
    assert [name for name in FAULTS if f"  {name}\n" not in found] == []

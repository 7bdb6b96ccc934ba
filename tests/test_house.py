"""The house: how long files are, what stands where, what tests may import, versions, the checks of CI."""

from __future__ import annotations

import json
import re
import statistics
import subprocess
import tomllib
from collections import Counter
from pathlib import Path

import pytest
from support.each import each
from support.gallery import ROOT

TOP = {"pyproject.toml", "graphic_tmm", "sheets", "tests", "README.md", "LICENSE"}
MOST = 400
MEDIAN = 200
"""A file is one idea: at 115 lines in the median there were 861 files, and one was looked for in six."""
PROJECT = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))["project"]


def lengths(room: str) -> dict[str, int]:
    """How many lines the files of a room have."""
    found = sorted((ROOT / room).rglob("*.py"))
    return {
        str(path.relative_to(ROOT)): len(path.read_text(encoding="utf-8").splitlines())
        for path in found
    }


@each("room", ["graphic_tmm", "tests"])
def test_no_file_is_too_long_and_most_are_short(room: str) -> None:
    found = lengths(room)
    longest = sorted(found.items(), key=lambda one: -one[1])[:10]
    assert longest[0][1] <= MOST, longest
    assert statistics.median(found.values()) <= MEDIAN, longest


def test_the_top_level_is_as_agreed() -> None:
    listed = subprocess.run(
        ["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=False
    )
    if listed.returncode:
        pytest.skip("not a checkout")
    tops = {line.split("/")[0] for line in listed.stdout.splitlines()}
    assert {top for top in tops if not top.startswith(".")} == TOP


# tests


def test_no_two_files_of_tests_have_one_name() -> None:
    """pytest refuses to collect the second of them, and only when both are collected."""
    names = Counter(path.name for path in (ROOT / "tests").rglob("test_*.py"))
    assert [name for name, count in names.items() if count > 1] == []


def test_no_test_is_imported() -> None:
    """What tests share stands in tests/support: a test runs alone, whatever was collected before it."""
    asked = re.compile(r"^(?:from|import) (test_\w+)", re.MULTILINE)
    found = {
        path.name: asked.findall(path.read_text(encoding="utf-8"))
        for path in (ROOT / "tests").rglob("*.py")
    }
    assert {name: names for name, names in found.items() if names} == {}


# versions and checks


def test_the_newest_change_is_the_version() -> None:
    text = (ROOT / "graphic_tmm" / "CHANGES.md").read_text(encoding="utf-8")
    versions = re.findall(r"^## (\S+)$", text, re.MULTILINE)
    assert versions[0] == PROJECT["version"]
    assert len(set(versions)) == len(versions)


def test_the_package_says_that_it_is_typed() -> None:
    assert (ROOT / "graphic_tmm" / "py.typed").read_bytes() == b""


def name_of(asked: str) -> str:
    """The name of a package as pip compares it."""
    found = re.match(r"[\w.-]+", asked)
    assert found, asked
    return re.sub(r"[-_.]+", "-", found[0]).lower()


def test_the_lock_holds_a_version_of_everything_that_is_asked_for() -> None:
    lines = (ROOT / ".ci" / "lock.txt").read_text(encoding="utf-8").splitlines()
    pinned = [line for line in lines if not line.startswith("#")]
    assert [line for line in pinned if not re.fullmatch(r"[\w.-]+==\S+", line)] == []
    extras = PROJECT["optional-dependencies"].values()
    asked = {name_of(one) for one in [*PROJECT["dependencies"], *(x for e in extras for x in e)]}
    assert asked - {name_of(line) for line in pinned} == set()


def test_a_commit_is_held_to_the_checks_of_ci() -> None:
    before = (ROOT / ".pre-commit-config.yaml").read_text(encoding="utf-8")
    hooks = set(re.findall(r"entry: \.venv/bin/(.+)", before))
    run = (ROOT / ".ci" / "run").read_text(encoding="utf-8")
    checks = {
        line.removesuffix(" .") for line in re.findall(r"^\.venv/bin/(.+)$", run, re.MULTILINE)
    }
    assert checks <= {hook.removesuffix(" .") for hook in hooks}
    assert {hook for hook in hooks if "pytest" in hook} == {
        'python -m pytest -q -n auto -m "not slow"'
    }


def test_the_tests_of_the_readme_are_everything_that_ci_runs() -> None:
    """CI runs the two commands of the README word for word, so both run the same tests."""
    text = (ROOT / "README.md").read_text(encoding="utf-8")
    start = text.partition("## Start")[2].partition("\n## ")[0]
    _, second = re.findall(r"^    \$ (.+)$", start, re.MULTILINE)
    assert second.endswith("-m pytest -n auto")
    assert Path(ROOT / ".ci" / "run").read_text(encoding="utf-8").count("bash -c") == 1


def test_ci_fails_without_a_browser_and_the_checks_of_scripts() -> None:
    """What a person may do without is there before CI's tests begin: none of them is skipped for it."""
    run = (ROOT / ".ci" / "run").read_text(encoding="utf-8")
    before, after = run.split("bash -c")
    assert "GRAPHIC_TMM_BROWSER=required" in before
    assert 'wait "$browser" || ' in before
    assert "'.[browser,single,docs]'" in before
    assert "'.[browser,single,docs]'" not in after


def test_the_checks_of_scripts_are_pinned() -> None:
    web = ROOT / ".ci" / "web"
    asked = json.loads((web / "package.json").read_text(encoding="utf-8"))["devDependencies"]
    locked = json.loads((web / "package-lock.json").read_text(encoding="utf-8"))["packages"]
    assert {"typescript", "eslint", "axe-core"} <= set(asked)
    assert asked == {name: locked[f"node_modules/{name}"]["version"] for name in asked}

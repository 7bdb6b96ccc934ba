"""Build the documentation as a static site: `python .docs/build.py [OUT]`, Russian in its folder `ru`.

What the documents show is run first, by the tests that hold it (`--no-examples` leaves them out). Whatever
MkDocs warns of, and a link, a picture or an anchor that leads nowhere, ends it with status 1.
"""

from __future__ import annotations

import argparse
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

HERE = Path(__file__).parent
sys.path[:0] = [str(HERE), str(HERE.parent)]

from documents import PAGES, PICTURES, REPOSITORY, ROOT, across, page_of  # noqa: E402
from gallery import gallery_pages  # noqa: E402
from reached import lost  # noqa: E402
from reference import command_pages, face_links, face_pages, key_pages  # noqa: E402
from start import start_page  # noqa: E402
from theory import notes, theory_pages  # noqa: E402
from words import LANGUAGES, NAMES, Language, word  # noqa: E402

EXAMPLES = (
    "tests/test_readme.py",
    "tests/test_start.py",
    "tests/test_class_guide.py",
    "tests/face/test_face_readme.py",
)
"""The tests that run every command and example of the documents."""
OTHER = "scenes_with_ranges"
"""The test among these that is one of scenes, and of no document's example."""
TABS: Mapping[Language, Sequence[str]] = {
    "en": ("guides", "theory", "keys", "commands", "python", "gallery", "project"),
    "ru": ("guides", "theory", "keys", "commands", "python", "gallery"),
}
LOOK = ("look.css", "iframe-worker.js")
PRINTED = ("keys/index.md", "gallery/index.md")
"""Pages whose documents are printed anew, or stand with others."""


def pages(language: Language) -> dict[str, str]:
    """Return the pages of the site of a language, by file, in their order."""
    found = {} if "README.md" in PAGES[language] else {"index.md": start_page(language)}
    for document, page in PAGES[language].items():
        if page not in PRINTED:
            found[page] = page_of(document, language)
    found.update(theory_pages(language))
    found.update(key_pages(language))
    found.update(command_pages(language))
    if language == "en":
        found.update(face_pages())
    else:
        found["python/index.md"] += face_links(language)
    found.update(gallery_pages(language))
    found["index.md"] = f"---\nhide: [navigation]\n---\n\n{found['index.md']}"
    return found


def build(out: Path, work: Path) -> None:
    """Build both sites into a folder, that of English first: it holds the other, and all sheets."""
    for language in LANGUAGES:
        source, found = work / language, pages(language)
        for page, text in (*found.items(), *notes(language)):
            file = source / page
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        for look in LOOK:
            shutil.copy(HERE / look, source)
        if language == "en":
            _copy_sheets(source)
        settings = work / f"mkdocs.{language}.yml"
        home = out if language == "en" else out / language
        settings.write_text(
            json.dumps(_settings(language, list(found), source, home)), encoding="utf-8"
        )
        command = [
            sys.executable,
            "-m",
            "mkdocs",
            "build",
            "--quiet",
            "--strict",
            "-f",
            str(settings),
        ]
        quiet = {**os.environ, "NO_MKDOCS_2_WARNING": "1"}
        if (ended := subprocess.run(command, env=quiet, check=False).returncode) != 0:
            sys.exit(ended)


def _copy_sheets(home: Path) -> None:
    for file in (ROOT / "sheets").glob("*/*"):
        if file.suffix in PICTURES:
            copied = home / file.relative_to(ROOT)
            copied.parent.mkdir(parents=True, exist_ok=True)
            shutil.copy(file, copied)


def _settings(language: Language, found: Sequence[str], source: Path, home: Path) -> dict[str, Any]:
    """Return what MkDocs is set to for a language, beside what both have (mkdocs.yml)."""
    nav: list[Any] = [{word("home", language): "index.md"}]
    for tab in TABS[language]:
        nav.append({word(tab, language): [one for one in found if one.startswith(f"{tab}/")]})
    assert len(found) == 1 + sum(len(*one.values()) for one in nav[1:]), "a page out of the menu"
    alternate = [
        {
            "name": NAMES[one],
            "lang": one,
            "link": across("index.html", "index.md", one, language),
        }
        for one in LANGUAGES
    ]
    plugins: list[Any] = [{"search": {"lang": sorted({"en", language})}}, "offline"]
    if language == "en":
        options = {
            "docstring_style": "numpy",
            "show_source": False,
            "show_root_heading": False,
            "show_root_toc_entry": False,
            "heading_level": 2,
            "members_order": "source",
            "show_signature_annotations": True,
            "separate_signature": True,
        }
        handler = {"paths": [str(ROOT)], "options": options}
        plugins.append({"mkdocstrings": {"handlers": {"python": handler}}})
    return {
        "INHERIT": str(HERE / "mkdocs.yml"),
        "site_name": "graphic_tmm",
        "docs_dir": str(source),
        "site_dir": str(home),
        "repo_url": REPOSITORY or None,
        "theme": {"language": language},
        "nav": nav,
        "plugins": plugins,
        "extra": {"alternate": alternate, "polyfills": [LOOK[1]]},
    }


def main() -> None:
    """Run the examples, build, check all links."""
    told = argparse.ArgumentParser(description=__doc__)
    told.add_argument("out", nargs="?", default="build/site", help="the folder of the site")
    told.add_argument("--no-examples", action="store_true", help="do not run the examples first")
    asked = told.parse_args()
    if not asked.no_examples:
        options = ["-q", "-p", "no:cacheprovider", "--measured", "-k", f"not {OTHER}"]
        run = [sys.executable, "-m", "pytest", *options, *EXAMPLES]
        subprocess.run(run, cwd=ROOT, check=True)
    out = Path(asked.out).resolve()
    shutil.rmtree(out, ignore_errors=True)
    with TemporaryDirectory() as work:
        build(out, Path(work))
    if faults := lost(out):
        sys.exit("\n".join(faults))
    print(out)


if __name__ == "__main__":
    main()

"""A thousand edits and posts, wrong in every way: the server answers on, its files stay whole."""

from __future__ import annotations

import asyncio
import json
import os
import random
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from support import watching
from support.gallery import ROOT
from support.hostile import SCENES
from support.served import SMALL, Browser, opened, run, small

from graphic_tmm.serve import folder as folders
from graphic_tmm.serve import worker as begun
from graphic_tmm.serve.desk import Desk

MANY = 600
"""Of these every third is an edit, at all others two strangers ask: a thousand of them when measured."""
SECRET = "secret = 'nobody reads this'\n"
VALUES = [
    *(
        "0.1 m",
        "0,12 m",
        "120 mm",
        "1e400 m",
        "-1 m",
        "NaN",
        "0.1 kg",
        "",
        "../../secret.toml",
        "x" * 5000,
    ),
    *(
        '"',
        "'''",
        "\\",
        "\0",
        "\ud800",
        "a\nb = 1",
        "[1, 2",
        "{a = 1}",
        "/etc/passwd",
        "file:///etc/passwd",
    ),
    *(
        "9" * 400,
        "0x10",
        "true",
        "1979-05-27",
        "<script>alert(1)</script>",
        "{{ 7 * 7 }}",
        "%s%n",
        "\u202e",
    ),
]
KEYS = [
    *(
        "title",
        "language",
        "drive.positions",
        "link 1, points.A[1]",
        "link 2, points.B[1]",
        "drive.speed",
    ),
    *(
        "link 9, number",
        "../title",
        "",
        ".",
        "a.b.c.d",
        "__class__",
        "drive",
        "sheet 1, format",
        "x" * 3000,
    ),
]


def wrong_text(random_: random.Random, text: str) -> bytes:
    """A scene's text, as it might be after an accident, or as it should never be."""
    how = random_.randrange(8)
    if how == 0:
        return os.urandom(0) + random_.randbytes(random_.randrange(3000))
    if how == 1:
        return random_.choice(list(SCENES.values()))(random_.choice([100, 20_000])).encode(
            "utf-8", "replace"
        )
    if how == 2:
        return text.encode()[: random_.randrange(len(text))]
    if how == 3:
        lines = text.splitlines()
        random_.shuffle(lines)
        return "\n".join(lines).encode()
    if how == 4:
        at = random_.randrange(len(text))
        return (text[:at] + random_.choice('"[]{}=#\0\n.,') + text[at + 1 :]).encode()
    if how == 5:
        return text.replace("0.1 m", random_.choice(VALUES)).encode("utf-8", "replace")
    if how == 6:
        return text.encode() + b"#" * 300_000
    return text.replace("0.1 m", f"{random_.uniform(0.05, 0.15):.4f} m").encode()


class Stranger:
    """Who asks at random, with right and wrong tokens, paths and bodies."""

    def __init__(self, browser: Browser, seed: int) -> None:
        self.browser, self.random = browser, random.Random(seed)
        self.seen: dict[int, int] = {}

    async def ask(self) -> None:
        """Ask something; whatever comes, it is an answer."""
        how = self.random.randrange(6)
        if how == 0:
            path = self.random.choice(
                ["/../secret.toml", "/s/../../secret.toml/", "/s/%2e%2e/", "/web/../x"]
            )
            answer = await self.browser.ask(self.random.choice(["", "//wrong"]) + path)
            assert answer.status == 404
        elif how == 1:
            body = self.random.choice(
                [b"{", b"[" * 70_000, b"{}", b"\xff" * 100, [b"x" * 90_000] * 4]
            )
            answer = await self.browser.ask("/s/small/form", "POST", body)
            assert answer.status == 400
        elif how == 2:
            answer = await self.browser.ask("/s/small/download/toml")
        else:
            answer = await self.post()
        self.seen[answer.status] = self.seen.get(answer.status, 0) + 1
        assert answer.status in (200, 400, 404, 409, 422), answer
        assert b"nobody reads" not in answer.body

    async def post(self):  # type: ignore[no-untyped-def]
        """Set values by the form, of its version or of one that was."""
        form = await self.browser.ask("/s/small/form")
        version = form.json().get("version", "") if form.status == 200 else "old"
        if self.random.random() < 0.1:
            version = self.random.choice(["", "0" * 32, "../x"])
        some = {
            self.random.choice(KEYS): self.random.choice(VALUES)
            for _ in range(self.random.randint(1, 3))
        }
        if self.random.random() < 0.3:
            some = {"link 1, points.A[1]": f"{self.random.uniform(0.05, 0.15):.4f} m"}
        body = json.dumps({"version": version, "changes": some}).encode()
        return await self.browser.ask("/s/small/form", "POST", body)


async def beset(browser: Browser, desk: Desk, file: Path, count: int) -> dict[int, int]:
    """Edit and ask so often, two strangers and an editor; return how often what was answered."""
    random_, strangers = random.Random(5), [Stranger(browser, seed) for seed in (1, 2)]
    for k in range(count):
        if k % 3 == 0:
            file.write_bytes(wrong_text(random_, SMALL) if k % 2 else SMALL.encode())
            desk.look_all()
        else:
            await asyncio.gather(*(one.ask() for one in strangers))
    file.write_text(SMALL, encoding="utf-8")
    return {
        status: sum(one.seen.get(status, 0) for one in strangers) for status in strangers[0].seen
    }


class Opened:
    """What this process opens while it is watched; an audit hook cannot be taken away again."""

    def __init__(self) -> None:
        self.on, self.paths = False, set[tuple[str, bool]]()
        sys.addaudithook(self.hear)

    def hear(self, event: str, told: tuple[object, ...]) -> None:
        if self.on and event == "open" and isinstance(told[0], (str, bytes)):
            flags = told[2] if isinstance(told[2], int) else 0
            writes = bool(flags & (os.O_WRONLY | os.O_RDWR | os.O_CREAT))
            self.paths.add((os.path.abspath(os.fsdecode(told[0])), writes))


def allowed(home: Path) -> tuple[str, ...]:
    """Where programs may read: Python's own, the package, what the system tells of itself."""
    own = {
        sys.prefix,
        sys.base_prefix,
        sys.exec_prefix,
        str(ROOT / "graphic_tmm"),
        str(ROOT / "sheets"),
    }
    own |= {os.path.realpath(one) for one in own} | {
        "/proc/",
        "/sys/",
        "/dev/",
        "/usr/",
        "/lib",
        "/etc/",
    }
    own |= {one for one in sys.path if one}  # where it is looked for modules
    return (*own, str(home))


@pytest.mark.slow
def test_a_thousand_edits_and_posts_leave_all_whole(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, many: Callable[[int, int], int]
) -> None:
    home = tmp_path / "scenes"
    file = small(home)
    (tmp_path / "secret.toml").write_text(SECRET, encoding="utf-8")
    path, out = watching.begin(tmp_path)
    monkeypatch.setenv("PYTHONPATH", os.pathsep.join([str(path), *sys.path]))
    written = set[str]()
    plain = folders.write

    def write(folder, texts, **others):  # type: ignore[no-untyped-def]
        written.update(str((folder / name).resolve()) for name in texts)
        return plain(folder, texts, **others)

    monkeypatch.setattr(folders, "write", write)
    # however busy the machine is, a process is begun anew only where one has died
    monkeypatch.setattr(begun, "PATIENCE", 600.0)
    answered: dict[int, int] = {}
    here = Opened()

    async def serving() -> None:
        async with opened(home, anew=True) as (browser, desk):
            first = await browser.settled("small")
            workers = (desk.front, desk.behind)
            before = [one._process.pid for one in workers]
            here.on = True
            answered.update(await beset(browser, desk, file, many(MANY, 48)))
            here.on = False
            desk.look_all()
            last = await browser.settled(
                "small", lambda one: one["text_version"] == first["text_version"]
            )
            assert (last["ok"], last["sheets"], last["page"]) == (
                True,
                first["sheets"],
                first["page"],
            )
            assert [one._process.pid for one in workers] == before  # none had to be begun anew

    run(serving)
    assert set(answered) == {200, 400, 404, 409, 422}
    assert min(answered.values()) >= 5
    assert written == {str(file)}
    assert (tmp_path / "secret.toml").read_text(encoding="utf-8") == SECRET
    assert sorted(one.name for one in home.rglob("*")) == ["scene.toml", "small"]
    # what the processes touched that drew: nothing was written, and of what is read nothing is of this test
    drew = watching.touched(out)
    assert drew
    bytecode = {one for one in drew if "__pycache__" in one[2]}
    assert {one for one in drew - bytecode if one[1] == "write" and one[2] != os.devnull} == set()
    assert {one for one in drew if one[2].startswith(str(home))} == set()
    assert {one for one in drew if "secret.toml" in one[2]} == set()
    roots = allowed(path)
    assert {one for one in drew if not one[2].startswith(roots)} == set()
    # nor does the server open anything else than the scene
    far = {(one, writes) for one, writes in here.paths if not one.startswith(str(home))}
    assert {one for one, writes in far if writes and one != os.devnull} == set()
    assert {one for one, _ in far if not one.startswith(roots)} == set()

"""The watch over pages sees whatever a page must not do; one that does nothing of it passes."""

from __future__ import annotations

import time
from pathlib import Path

import pytest
from support.browser import OWN, REQUIRED, chromium, tool

POLICY = (
    '<meta http-equiv="Content-Security-Policy" content="default-src \'none\'; '
    "script-src 'unsafe-inline'; require-trusted-types-for 'script'; trusted-types 'none'\">"
)
FAULTS = {
    "an error on the console": ("<script>console.error('e')</script>", "console error: e"),
    "a warning": ("<script>console.warn('w')</script>", "console warning: w"),
    "an assertion": ("<script>console.assert(false, 'a')</script>", "console assert: a"),
    "a fault": ("<script>throw new Error('thrown')</script>", "fault: Error: thrown"),
    "a fault later": ("<script>Promise.reject(new Error('late'))</script>", "fault: Error: late"),
    "a dialog": ("<script>alert('hello')</script>", "dialog alert: hello"),
    "a picture from elsewhere": ("<img src='http://example.invalid/a.png'>", "request: http://exa"),
    "a file beside it": ("<img src='beside.png'>", "request: file://"),
    "a style from elsewhere": (
        "<link rel=stylesheet href='http://example.invalid/a.css'>",
        "request: http://example.invalid/a.css",
    ),
    "a call": (
        "<script>fetch('http://example.invalid/b').catch(() => 0)</script>",
        "request: http://example",
    ),
    "a beacon": (
        "<script>navigator.sendBeacon('http://example.invalid/c')</script>",
        "request: http://example.invalid/c",
    ),
    "a style against the policy": (f"{POLICY}<p style='color:red'>x</p>", "console error: "),
    "eval against the policy": (f"{POLICY}<script>eval('1')</script>", "fault: EvalError"),
    "markup against the policy": (
        f"{POLICY}<p></p><script>document.querySelector('p').innerHTML = 'a'</script>",
        "fault: TypeError",
    ),
    "a picture against the policy": (
        f"{POLICY}<img src='data:image/gif;base64,R0lGODlhAQABAAAAACw='>",
        "console error: ",
    ),
    "a fault in a window that it opens": (
        "<script>const w = window.open(''); const s = w.document.createElement('script');"
        "s.textContent = 'console.error(1)'; w.document.body.append(s)</script>",
        "console error: 1",
    ),
}
BEGIN = "<!DOCTYPE html><html lang=en><meta charset=utf-8><title>t</title>"


@pytest.mark.parametrize("what", FAULTS)
def test_the_watch_sees(what: str, opened, tmp_path: Path) -> None:
    body, due = FAULTS[what]
    file = tmp_path / "page.html"
    file.write_text(BEGIN + body, encoding="utf-8")
    tab = opened(file)
    faults = tab.settle()
    end = time.monotonic() + 10
    while not any(fault.startswith(due) for fault in faults) and time.monotonic() < end:
        tab.page.wait_for_timeout(10)
        faults += tab.settle()
    assert any(fault.startswith(due) for fault in faults), faults


def test_a_page_that_keeps_to_itself_passes(opened, tmp_path: Path) -> None:
    file = tmp_path / "page of a scene.html"
    script = (
        "<script>console.log('fine'); const w = window.open(''); w.document.title = 'n'</script>"
    )
    file.write_text(BEGIN + POLICY + "<a href='#here'>here</a>" + script, encoding="utf-8")
    tab = opened(file, "#velocities/2")
    tab.page.get_by_role("link", name="here").click()
    assert tab.page.evaluate("location.hash") == "#here"
    assert tab.settle() == []


def test_what_is_missing_is_skipped_with_a_reason_and_fails_where_it_is_required(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.setenv(OWN, "no-such-browser")
    for missing in (chromium, lambda: tool("no-such-package/index.js")):
        monkeypatch.delenv(REQUIRED, raising=False)
        with pytest.raises(
            pytest.skip.Exception, match=r"no-such-\S+ .*is missing: .*(install|npm ci)"
        ):
            missing()
        monkeypatch.setenv(REQUIRED, "required")
        with pytest.raises(pytest.fail.Exception, match="is missing"):
            missing()

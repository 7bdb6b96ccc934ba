"""What axe finds on a page that is serious; the thousands of strokes of a drawing are one image.

What stands in a drawing is taken out of the page while axe looks through the rest: it weighs every node against
every other, judged or not (measured 2026-11-29: 4 s in place of 22 for four tabs of the windrower's page).
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from support.browser import tool

INK = "svg > :not(title, desc)"
"""All that is drawn."""
STROKES = (
    "svg :is(path, line, circle, polyline, polygon, rect):not([role], [tabindex], [aria-label])"
)
"""What is drawn but groups, and what has a name or a part to play."""
RUN = """([where, without, tags]) => {
  const left = [...document.querySelectorAll(without)].map((one) => {
    const place = document.createComment("");
    one.replaceWith(place);
    return [one, place];
  });
  const asked = { resultTypes: ["violations"], ...(tags && { runOnly: tags }) };
  return axe.run(where ?? document, asked).then((found) => {
    for (const [one, place] of left) place.replaceWith(one);
    return found.violations.filter((one) => ["serious", "critical"].includes(one.impact))
      .map((one) => `${one.id}: ${one.nodes.map((node) => node.html.slice(0, 120)).join(" ")}`);
  });
}"""


def serious(
    page: Any, where: str | None = None, *, without: str = INK, tags: Sequence[str] | None = None
) -> list[str]:
    """Return what axe finds, in a part of the page or in all of it, by the rules of its tags or by its own."""
    if not page.evaluate("() => 'axe' in window"):
        page.evaluate(tool("axe-core/axe.min.js").read_text(encoding="utf-8"))
    return list(page.evaluate(RUN, [where, without, tags]))

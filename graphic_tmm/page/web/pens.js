import { drawnElement } from "./dom.js";

/**
 * @typedef {import("./types.js").Dense} Dense
 * @typedef {import("./types.js").Glyph} Glyph
 */

/** White about a letter that stands on lines, in widths of its pen. */
const HALO = 3;

/**
 * Return a group for each pen, in their order, with what stands still already in it.
 * @param {Dense} dense
 * @param {[string, string][]} still
 * @returns {Map<string, Element>}
 */
export function layers(dense, still) {
  const found = new Map();
  for (const [pen, [width, dashes, fill]] of Object.entries(dense.pens)) {
    const group = drawnElement("g", {
      fill: fill === "none" ? "none" : "var(--paper)",
      stroke: width > 0 ? "var(--ink)" : "none",
      class: "pen",
      "stroke-linecap": dashes.length > 0 ? "butt" : "round",
      "stroke-linejoin": "round",
    });
    group.style.setProperty("--pen", `${width}px`);
    if (dashes.length > 0) group.setAttribute("stroke-dasharray", dashes.join(" "));
    for (const [of, d] of still) if (of === pen) group.append(drawnElement("path", { d, class: "still" }));
    found.set(pen, group);
  }
  return found;
}

/**
 * Return the strokes of a letter, white about them.
 * @param {Glyph | undefined} glyph
 */
export function written(glyph) {
  const strokes = glyph?.[1] ?? [];
  const shared = { fill: "none", "stroke-linecap": "round", "stroke-linejoin": "round" };
  return drawnElement(
    "g",
    { class: "glyph" },
    ...strokes.map(([pen, d]) => drawnElement("path", { ...shared, d, stroke: "var(--paper)", "stroke-width": HALO * pen })),
    ...strokes.map(([pen, d]) => drawnElement("path", { ...shared, d, stroke: "var(--ink)", "stroke-width": pen })),
  );
}

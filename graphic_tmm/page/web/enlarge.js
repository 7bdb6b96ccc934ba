import { drawnElement } from "./dom.js";
import { boxesMeet } from "./sheet-bounds.js";

/** @typedef {import("./sheet-bounds.js").Box} Box */

/** Letters grow no more than so many times: they would cover what they name. */
const MOST = 2.2;
/** All letters grow by these shares in turn, each as long as it meets no other and no edge. */
const GROWTHS = [0.25, 0.5, 0.75, 1];
/** Clear between letters that have grown, px. */
const ASUNDER = 2;
/** The height of letters is so many times the width of their strokes (ГОСТ 2.304, type B). */
const HEIGHT = 10;

/**
 * Keep letters and lines of a drawing readable at the size it has on the screen: lettering of at least `least`
 * pixels where there is room for it among the other letters, `--mm` the length of a pixel on the drawing.
 * @param {SVGElement} svg
 * @param {number} least
 */
export function enlarge(svg, least) {
  const room = svg.getBoundingClientRect();
  const [, , width = 1, height = 1] = (svg.getAttribute("viewBox") ?? "").split(" ").map(Number);
  const scale = Math.min(room.width / width, room.height / height);
  if (!(scale > 0)) return;
  svg.style.setProperty("--mm", `${1 / scale}px`);
  const labels = /** @type {SVGElement[]} */ ([...svg.querySelectorAll(".label")]);
  const sizes = labels.map((label) => HEIGHT * Number(label.closest(".lettering")?.getAttribute("stroke-width")) * scale);
  svg.classList.add("measured");
  growApart(svg, labels, sizes.map((size) => Math.min(least / size, MOST)), "--times");
  svg.classList.remove("measured");
}

/**
 * Let letters grow, each as far as it meets no other one and no edge of its drawing.
 * @param {SVGElement} svg
 * @param {SVGElement[]} letters
 * @param {number[]} times how much larger each is to be
 * @param {string} property of its style, which tells it
 */
export function growApart(svg, letters, times, property) {
  for (const letter of letters) letter.style.setProperty(property, "1");
  if (times.every((most) => most <= 1)) return;
  const sheet = boxOf(svg.getBoundingClientRect());
  const whole = letters.map((letter) => boxOf(letter.getBoundingClientRect()));
  const boxes = [...whole];
  for (const share of GROWTHS) {
    letters.forEach((letter, k) => {
      const more = Math.max((times[k] ?? 1) - 1, 0);
      const larger = grownBox(whole[k] ?? sheet, 1 + share * more);
      if (more === 0 || !holds(sheet, larger) || boxes.some((other, n) => n !== k && boxesMeet(other, wider(larger)))) return;
      boxes[k] = larger;
      letter.style.setProperty(property, (1 + share * more).toFixed(2));
    });
  }
}

/**
 * @param {Box} box
 * @returns {Box}
 */
function wider([left, top, right, bottom]) {
  return [left - ASUNDER, top - ASUNDER, right + ASUNDER, bottom + ASUNDER];
}

/**
 * @param {DOMRect} rect
 * @returns {Box}
 */
function boxOf({ left, top, right, bottom }) {
  return [left, top, right, bottom];
}

/**
 * Return a box so many times as large about its middle.
 * @param {Box} box
 * @param {number} times
 * @returns {Box}
 */
function grownBox([left, top, right, bottom], times) {
  const [x, y] = [((times - 1) * (right - left)) / 2, ((times - 1) * (bottom - top)) / 2];
  return [left - x, top - y, right + x, bottom + y];
}

/**
 * @param {Box} outer
 * @param {Box} inner
 */
function holds(outer, inner) {
  return inner[0] >= outer[0] && inner[1] >= outer[1] && inner[2] <= outer[2] && inner[3] <= outer[3];
}

/** A window narrower than this is a phone's, px; letters on it are so high. */
const PHONE = { width: 800, letters: 13 };

/**
 * Close in on a drawing, and keep its letters readable on a phone whatever happens to its window.
 * @param {SVGElement} svg
 */
export function keepReadable(svg) {
  let closed = false;
  const fit = () => {
    if (!closed && svg.clientWidth > 0) closeIn(svg);
    closed ||= svg.clientWidth > 0;
    enlarge(svg, window.innerWidth < PHONE.width ? PHONE.letters : 0);
  };
  new ResizeObserver(fit).observe(svg);
}

/**
 * Take a view's own title off a drawing (the page says it), move up what stands below it (μ), close in on what is left.
 * @param {SVGElement} svg
 */
export function closeIn(svg) {
  svg.classList.add("measured");
  const own = /** @type {NodeListOf<SVGGraphicsElement>} */ (svg.querySelectorAll(".label:not([data-of])"));
  const widths = [...own].map((label) => Number(label.parentElement?.getAttribute("stroke-width")));
  const title = Math.max(PLAN_TITLE, ...widths);
  const titles = [...own].filter((_, k) => widths[k] === title);
  if (titles.length > 0) {
    const { y, height } = around(titles);
    const below = [...own].filter((label) => !titles.includes(label) && label.getBBox().y >= y + height - 1);
    titles.forEach((label) => label.remove());
    const up = below.length === 0 ? 0 : around(below).y - y;
    below.forEach((label) => label.parentElement?.append(liftedLabel(label, -up)));
  }
  const box = around([.../** @type {NodeListOf<SVGGraphicsElement>} */ (svg.querySelectorAll(":scope > :not(.instrument)"))]);
  svg.classList.remove("measured");
  if (box.width <= 0 && box.height <= 0) return;
  const sides = [box.x - EDGE, box.y - EDGE, box.width + 2 * EDGE, box.height + 2 * EDGE];
  svg.setAttribute("viewBox", sides.map((x) => x.toFixed(3)).join(" "));
}

/** White about what is closed in on, mm. */
const EDGE = 5;
/** The strokes of titles are the widest of a view's letters, so wide at least, mm. */
const PLAN_TITLE = 0.5;

/**
 * Return a part within a group that moves it down.
 * @param {SVGElement} part
 * @param {number} by mm
 */
function liftedLabel(part, by) {
  return drawnElement("g", { transform: `translate(0 ${by})` }, part);
}

/**
 * Return the box about parts that have ink.
 * @param {SVGGraphicsElement[]} parts
 */
function around(parts) {
  const boxes = parts.map((part) => part.getBBox()).filter((box) => box.width > 0 || box.height > 0);
  const x = Math.min(...boxes.map((box) => box.x));
  const y = Math.min(...boxes.map((box) => box.y));
  const right = Math.max(...boxes.map((box) => box.x + box.width));
  const low = Math.max(...boxes.map((box) => box.y + box.height));
  return { x, y, width: right - x, height: low - y };
}

import { drawnElement } from "../dom.js";
import { written } from "../pens.js";
import { hundredths } from "../strokes.js";
import { alongCourse, WHOLE_TURN } from "./courses.js";

/**
 * @typedef {import("../types.js").Turning} Turning
 * @typedef {import("../types.js").TurningFigure} TurningFigure
 * @typedef {import("../types.js").RigidBody} RigidBody
 * @typedef {[number, number]} Spot
 */

/**
 * Draw a picture whose bodies turn: `show` puts them where they are when what drives has turned so far (degrees).
 * @param {Turning} turning
 * @param {TurningFigure} figure
 */
export function turningPicture(turning, figure) {
  const svg = drawnElement("svg", { viewBox: figure.box.join(" "), class: "moving", role: "img", "aria-label": figure.title });
  const letters = drawnElement("g", { class: "letters" });
  svg.append(drawnElement("g", { class: "stands" }, ...penned(turning, figure.still)));
  const acts = figure.bodies.map((body) => bodyOf(turning, body, svg, letters));
  for (const [n, x, y] of figure.stands) {
    letters.append(drawnElement("g", { class: "stays", transform: `translate(${x} ${-y})` }, written(turning.glyphs[n])));
  }
  svg.append(letters);
  const show = (/** @type {number} */ turn) => acts.forEach((act) => act(turn));
  return { svg, show };
}

/**
 * @param {Turning} turning
 * @param {RigidBody} body
 * @param {SVGElement} svg
 * @param {SVGElement} letters
 */
function bodyOf(turning, body, svg, letters) {
  const made = drawnElement("g", { class: "rigid" });
  const [count, x, y] = body.copies ?? [1, 0, 0];
  for (let k = 0; k < count; k++) {
    const transform = `rotate(${(WHOLE_TURN * k) / count} ${x} ${y})`;
    made.append(drawnElement("g", { transform }, ...penned(turning, body.strokes)));
  }
  svg.append(made);
  const carried = (body.letters ?? []).map(([n, left, up, ...spot]) => {
    const letter = drawnElement("g", { class: "carried" }, written(turning.glyphs[n]));
    letters.append(letter);
    return { letter, off: [left - spot[0], -up - spot[1]], spot };
  });
  return (/** @type {number} */ turn) => {
    const moves = body.moves.map(([turns, u, v, course]) => ({ turns, u, v, by: alongCourse(course, turn) }));
    if (moves.length > 0) made.setAttribute("transform", moves.map(transformOf).reverse().join(" "));
    for (const { letter, off: [right = 0, down = 0], spot } of carried) {
      const [a, b] = moves.reduce(movedSpot, /** @type {Spot} */ (spot));
      letter.setAttribute("transform", `translate(${hundredths(a + right)} ${hundredths(b + down)})`);
    }
  };
}

/** @param {{turns: boolean, u: number, v: number, by: number}} move y is downward: what turns counter-clockwise turns back */
function transformOf({ turns, u, v, by }) {
  return turns ? `rotate(${exactly(-by)} ${u} ${v})` : `translate(${exactly(u * by)} ${exactly(v * by)})`;
}

/**
 * @param {Spot} spot
 * @param {{turns: boolean, u: number, v: number, by: number}} move
 * @returns {Spot}
 */
function movedSpot([x, y], { turns, u, v, by }) {
  if (!turns) return [x + u * by, y + v * by];
  const angle = (-by * Math.PI) / (WHOLE_TURN / 2);
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [u + c * (x - u) - s * (y - v), v + s * (x - u) + c * (y - v)];
}

/** @param {number} value */
function exactly(value) {
  return Number(value.toFixed(4));
}

/**
 * Return strokes as paths drawn with their pens.
 * @param {Turning} turning
 * @param {[string, string, boolean][]} strokes
 */
function penned(turning, strokes) {
  return strokes.map(([name, d, filled]) => {
    const [width = 0, dashes = [], fill = "none"] = turning.pens[name] ?? [];
    const inside = fill === "none" ? "none" : "var(--paper)";
    const path = drawnElement("path", { d, class: "pen", fill: filled ? "var(--ink)" : inside, stroke: width > 0 && !filled ? "var(--ink)" : "none" });
    path.style.setProperty("--pen", `${width}px`);
    if (dashes.length > 0) path.setAttribute("stroke-dasharray", dashes.join(" "));
    return path;
  });
}

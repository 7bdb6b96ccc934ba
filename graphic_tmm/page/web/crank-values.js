import { turnAt } from "./dense.js";
import { element, typeset } from "./dom.js";

/**
 * @typedef {import("./types.js").Dense} Dense
 * @typedef {import("./types.js").There} There
 */

/**
 * Something that is told at every angle: its letter, its unit, Python's own texts at the positions, a number between.
 * @typedef {{letter: string, unit: string, texts: (string | null)[], there: There,
 *   number: (k: number) => string, live?: (k: number) => string | null | undefined}} Told `live`: with lengths that are
 *   not as given; null of what is of the sheet alone, undefined while all is as given
 */

/** What stands where there is no figure. */
export const NONE = "";

/** What is called by more letters has a row of its own. */
const LONG = 10;

/**
 * A list of what is told, each with the text that changes.
 */
export class Values {
  /**
   * @param {Dense} dense
   * @param {Told[]} values
   */
  constructor(dense, values) {
    this.list = element("dl", { class: "values" });
    this.positions = new Map(dense.positions.map(([, index], n) => [index, n]));
    this.cells = values.map((value) => {
      const text = document.createTextNode(NONE);
      const cell = element("dd", {}, text);
      if (value.unit !== "") cell.append(` ${value.unit}`);
      const row = element("div", { class: value.letter.replace(/[_{}^]/g, "").length > LONG ? "gone long" : "gone" }, element("dt", {}, ...typeset(value.letter), " = "), cell);
      this.list.append(row);
      return { value, text, row };
    });
  }

  /**
   * @param {number} k
   * @param {boolean} drawn
   */
  show(k, drawn) {
    const position = this.positions.get(k);
    for (const { value, text, row } of this.cells) {
      const own = position === undefined ? null : (value.texts[position] ?? null);
      const live = drawn ? value.live?.(k) : undefined;
      const now = live ?? (!drawn || !isThere(value.there, k) ? NONE : (own ?? value.number(k)));
      row.classList.toggle("of-sheet", live === null);
      if (text.data !== now) text.data = now;
      row.classList.toggle("gone", now === NONE);
    }
  }
}

/**
 * @param {There} there
 * @param {number} k
 */
function isThere(there, k) {
  return there === 0 || there.filter((end) => end <= k).length % 2 === 1;
}

/**
 * Return where the drive stands, as sheets write it: the direction of the crank from the x axis, or a length.
 * @param {Dense} dense
 * @param {number} k
 */
export function placeText(dense, k) {
  const { letter, unit, from, per } = dense.ends ?? { letter: "φ", unit: "°", from: dense.zero, per: dense.sense };
  const value = from + per * turnAt(dense, k);
  const told = unit === "°" ? Number((((value % 360) + 360) % 360).toFixed(2)) % 360 : Number(value.toFixed(3));
  return `${letter} = ${fourFigures(told, dense.decimal)}${unit}`;
}

/**
 * Return a number with so many decimals, as sheets write it.
 * @param {number} value
 * @param {number} places
 * @param {string} sign what stands between the whole and the rest
 */
export function fixedText(value, places, sign) {
  const text = value.toFixed(places);
  return signed(Number(text) === 0 ? text.replace("-", "") : text, sign);
}

/**
 * Return a number to four figures, as sheets write it.
 * @param {number} value
 * @param {string} sign
 */
export function fourFigures(value, sign) {
  if (value === 0) return "0";
  const size = Math.floor(Math.log10(Math.abs(value)));
  if (size < -4 || size > 6) {
    const power = String(size).replace(/[-\d]/g, (one) => RAISED[one] ?? one);
    return signed(`${trimmed((value / 10 ** size).toFixed(3))}·10${power}`, sign);
  }
  return signed(size < 3 ? trimmed(value.toFixed(3 - size)) : value.toFixed(0), sign);
}

/** @type {Record<string, string>} */
const RAISED = { "-": "⁻", 0: "⁰", 1: "¹", 2: "²", 3: "³", 4: "⁴", 5: "⁵", 6: "⁶", 7: "⁷", 8: "⁸", 9: "⁹" };

/** @param {string} text */
function trimmed(text) {
  return text.includes(".") ? text.replace(/\.?0+$/, "") : text;
}

/**
 * @param {string} text
 * @param {string} sign
 */
function signed(text, sign) {
  return text.replace("-", "−").replace(".", sign);
}

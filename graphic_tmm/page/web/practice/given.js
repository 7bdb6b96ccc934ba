import { complex } from "./arithmetic.js";

/** @typedef {import("../types.js").Drawn} Drawn */

/** How many numbers a mark is made of. */
export const NUMBERS_OF = { point: 2, line: 4, arc: 3, length: 1, angle: 1, number: 1, side: 1 };

/**
 * Return what is given in a position: its numbers stand there once, or one after the other for each position.
 * @param {import("../types.js").Kind} kind
 * @param {number | null | (number | null)[]} told
 * @param {number} at
 * @returns {Drawn}
 */
export function givenAt(kind, told, at) {
  const wide = NUMBERS_OF[kind];
  const all = Array.isArray(told) ? told : [told];
  const begun = all.length > wide ? at * wide : 0;
  const [a = NaN, b = NaN, c = NaN, d = NaN] = all.slice(begun, begun + wide).map((x) => x ?? NaN);
  if (kind === "point") return complex(a, b);
  if (kind === "line") return { at: complex(a, b), along: complex(c, d) };
  return kind === "arc" ? { centre: complex(a, b), radius: c } : a;
}

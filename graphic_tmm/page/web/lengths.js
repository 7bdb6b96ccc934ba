/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./types.js").Dense} Dense
 * @typedef {import("./types.js").Complex} Complex
 * @typedef {{
 *   ink: import("./live/liveink.js").LiveInk | null,
 *   panel: HTMLElement,
 *   again: () => void,
 *   why: (k: number) => string | null,
 *   number: (log: number[], k: number) => number,
 *   changed: () => boolean,
 *   scale: (name: string, k: number) => number,
 *   pin: (k: number) => Complex | null,
 *   mark: (slot: number) => number,
 *   chart: (svg: Element, cursors: import("./types.js").Cursor[]) => import("./live/charts.js").LiveChart,
 *   stand: (k: number) => void,
 *   lead: (svg: SVGElement, numbers?: import("./numbers.js").PutNumbers) => void,
 * }} Lengths what figures are tied to; what is changed; takes what was changed in the page before this one; why an angle is not drawn, null while all is as given; a number
 *   of the log; whether anything is not as given; the scale factor of a figure, not a number while all is as given; where
 *   the pin of the crank is; a number that the sheet has once; lets the ink of a view of a sheet follow; takes notice of
 *   the angle that is shown; takes the figure of the mechanism
 */

/**
 * What lets lengths be changed; `live/enter.js` enters it, of pages that have it. What is given now otherwise than in
 * the scene, by slots, and in words.
 */
export const LENGTHS = {
  /** @type {{values: Map<number, number>, says: string}} */
  given: { values: new Map(), says: "" },
  /** @type {((data: Data, dense: Dense, show: () => void) => Lengths | null) | null} */
  begin: null,
};

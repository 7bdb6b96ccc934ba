/**
 * @typedef {import("./types.js").View} View
 * @typedef {import("./types.js").Line} Line
 * @typedef {import("./types.js").Row} Row
 */

/**
 * Return, for each stop of a view, what is told in it: its step, or in another position its figures.
 * @param {View} view
 * @returns {Line[][]}
 */
export function linesOfPictures(view) {
  return view.pictures.map((one) => one.lines.filter((line) => !line.head));
}

/**
 * Return what stands above the step of a stop: the headings and the equation that it belongs to.
 * @param {View} view
 * @param {number} n
 * @returns {Line[]}
 */
export function headsAt(view, n) {
  for (let k = Math.min(n, view.pictures.length - 1); k >= 0; k -= 1) {
    const heads = view.pictures[k]?.lines.filter((line) => line.head) ?? [];
    if (heads.length > 0) return heads;
  }
  return [];
}

/**
 * Return the sentence of the step that left a mark.
 * @param {View} view
 * @param {number} slot
 * @returns {Line | undefined}
 */
export function lineOfMark(view, slot) {
  const lines = view.pictures.flatMap((one) => one.lines);
  return lines.find((line) => line.it === slot && line.text !== undefined);
}

/**
 * Return the number of the last picture with ink up to a stop: how far the drawing is.
 * @param {View} view
 * @param {number} n
 */
export function pictureAt(view, n) {
  return view.pictures.slice(1, n + 1).filter((one) => one.keys.length > 0).length;
}

/**
 * Return in which stop each mark of a view is made first.
 * @param {View} view
 * @returns {Map<number, number>}
 */
export function madeIn(view) {
  /** @type {Map<number, number>} */
  const found = new Map();
  view.pictures.forEach((one, n) => {
    for (const line of one.lines) {
      if (line.it !== undefined && !found.has(line.it)) found.set(line.it, n);
    }
  });
  return found;
}

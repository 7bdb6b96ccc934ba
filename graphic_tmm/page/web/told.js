/**
 * @typedef {import("./types.js").View} View
 * @typedef {import("./types.js").Line} Line
 */

/** @type {WeakMap<View, Line[][]>} */
const TOLD = new WeakMap();

/**
 * Return, for each picture of a view, the lines of the protocol that are told with it.
 *
 * A line is told with the first picture in which its step is done or a later step is; what follows the last
 * picture of its position is told with that. The picture of what is given tells nothing.
 * @param {View} view
 * @returns {Line[][]}
 */
export function linesOfPictures(view) {
  const known = TOLD.get(view);
  if (known !== undefined) return known;
  /** @type {Line[][]} */
  const found = view.pictures.map(() => []);
  for (const [at, lines] of Object.entries(view.lines)) {
    const own = view.pictures.flatMap((one, n) => (n > 0 && one.at === Number(at) ? [n] : []));
    let from = 0;
    own.forEach((n, k) => {
      const marks = new Set(view.pictures[n]?.marks);
      const last = lines.findLastIndex((line) => line.it !== undefined && marks.has(line.it));
      const end = k === own.length - 1 ? lines.length : Math.max(from, last + 1);
      found[n] = lines.slice(from, end);
      from = end;
    });
  }
  TOLD.set(view, found);
  return found;
}

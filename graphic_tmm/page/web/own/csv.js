/** @typedef {import("./corners.js").OwnPack} OwnPack */

/** The columns that readings of points fill: plan, position, segment; x, y are the last two. */
const NAMED = 3;
const COORDINATES = 2;

/**
 * Return readings of points as a file that a check reads: as checking/readings/writing.py writes it.
 * @param {string[][]} rows plan, position, point, x, y
 * @param {OwnPack} pack
 */
export function csvOf(rows, { heads, separator, decimal, begins }) {
  const empty = new Array(heads.length - NAMED - COORDINATES).fill("");
  const whole = rows.map((row) => {
    const figures = row.slice(NAMED).map((one) => one.replace(".", decimal));
    return [...row.slice(0, NAMED).map((one) => quoted(one, separator)), ...empty, ...figures];
  });
  return begins + [heads, ...whole].map((row) => `${row.join(separator)}\n`).join("");
}

/**
 * Return a cell in quotes if it could be taken for several, or its row for a comment.
 * @param {string} cell
 * @param {string} separator
 */
function quoted(cell, separator) {
  return cell.includes(separator) || /["\r\n#]/.test(cell) ? `"${cell.replaceAll('"', '""')}"` : cell;
}

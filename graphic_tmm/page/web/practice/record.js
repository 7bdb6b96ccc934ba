/**
 * What a student drew, as a file: JSON with every try, CSV as the check reads it.
 *
 * @typedef {{plan: string, position: string, segment: string, mm?: string, value?: string, unit?: string, x?: string,
 *   y?: string}} Reading a row of CSV; figures as they were written
 */

/** The figures of a row, in the order of the titles behind plan, position, segment. @type {(keyof Reading)[]} */
const CELLS = ["plan", "position", "segment", "mm", "value", "unit", "x", "y"];

/**
 * Return readings as CSV.
 * @param {Reading[]} rows
 * @param {string} head the titles of the columns, as Python writes them
 * @param {string} separator
 */
export function csvOf(rows, head, separator) {
  const lines = rows.map((row) => CELLS.map((cell) => quotedCell(row[cell] ?? "", separator)).join(separator));
  return head + lines.map((line) => `${line}\n`).join("");
}

/**
 * Return a cell in quotes if it could be taken for several, or its row for a comment.
 * @param {string} cell
 * @param {string} separator
 */
function quotedCell(cell, separator) {
  const plain = !cell.includes(separator) && !/["\r\n#]/.test(cell);
  return plain ? cell : `"${cell.replaceAll('"', '""')}"`;
}

/**
 * Let a person save a text as a file.
 * @param {string} name
 * @param {string} text
 * @param {string} type
 */
export function save(name, text, type) {
  const address = URL.createObjectURL(new Blob([text], { type }));
  const link = document.createElement("a");
  link.href = address;
  link.download = name;
  document.body.append(link);
  link.click();
  link.remove();
  window.setTimeout(() => URL.revokeObjectURL(address), KEPT_FOR);
}

/** So long the address of a saved file is good, ms. */
const KEPT_FOR = 10_000;

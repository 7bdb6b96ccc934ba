import { drawnElement, filled } from "./dom.js";

/** @typedef {import("./types.js").SheetSize} SheetSize */

/**
 * A4, its white margin, how far neighbours overlap; mm. A page is not drawn to its last hair: one as high as its
 * paper would, by the rounding of its pixels, begin another.
 */
const PAGE = { width: 210, height: 297, margin: 10, overlap: 10, drawn: 296.8 };
const ROOM = { width: PAGE.width - 2 * PAGE.margin, height: PAGE.height - 2 * PAGE.margin };
/** Marks where to cut begin off the drawing and end so far from it, mm. */
const CROP_MARK = { from: 1, to: 6 };
const CHECKED = 100;
/** So far from the paper's edge stands what is to be read: nearer many printers do not print, mm. */
const TILE_EDGE = 6;
const THIN = { fill: "none", stroke: "black", "stroke-width": 0.2 };

/**
 * Return the pages, rows from above, in which a sheet is printed piece by piece at true size.
 * @param {Element} figure what the sheet stands in
 * @param {SheetSize} size
 * @param {number} number of the sheet
 * @param {Record<string, string>} words
 * @returns {SVGElement[]}
 */
export function tilePages(figure, size, number, words) {
  const views = [...figure.querySelectorAll("svg > g.drawing")].map((one) => one.id);
  const columns = startsOf(size.width, ROOM.width);
  const rows = startsOf(size.height, ROOM.height);
  return rows.flatMap((y, row) =>
    columns.map((x, column) => {
      const at = { row: row + 1, rows: rows.length, column: column + 1, columns: columns.length };
      const told = filled(words["tile"] ?? "", { sheet: number + 1, ...at });
      return tilePage(views, x, y, size, told, words["100 mm"] ?? "");
    }),
  );
}

/**
 * Return where pieces begin that cover a length, each overlapping the one before, mm.
 * @param {number} length
 * @param {number} room
 */
function startsOf(length, room) {
  const step = room - PAGE.overlap;
  const count = Math.max(1, Math.ceil((length - PAGE.overlap) / step));
  return Array.from({ length: count }, (_, k) => k * step);
}

/**
 * @param {string[]} views
 * @param {number} x where the piece begins on the sheet, mm
 * @param {number} y
 * @param {SheetSize} size
 * @param {string} told
 * @param {string} check
 */
function tilePage(views, x, y, size, told, check) {
  const { margin, width, height } = PAGE;
  const wide = Math.min(ROOM.width, size.width - x);
  const high = Math.min(ROOM.height, size.height - y);
  const uses = views.map((id) => drawnElement("use", { href: `#${id}` }));
  const box = { x: margin, y: margin, width: wide, height: high, viewBox: `${x} ${y} ${wide} ${high}` };
  const low = height - TILE_EDGE;
  const left = width / 2 - CHECKED / 2;
  const line = `M${left} ${low}h${CHECKED}m0 -1v2m${-CHECKED} 0v-2`;
  return drawnElement(
    "svg",
    { class: "tile", viewBox: `0 0 ${width} ${PAGE.drawn}`, width: `${width}mm`, height: `${PAGE.drawn}mm` },
    drawnElement("svg", box, ...uses),
    drawnElement("path", { ...THIN, d: cutMarks(margin, margin, wide, high) }),
    drawnElement("path", { ...THIN, class: "check", d: line }),
    lettered(check, left + CHECKED + 2, low + 1),
    lettered(told, margin + PAGE.overlap + 4, TILE_EDGE + 1),
  );
}

/**
 * Return path data of marks at the corners of a piece, and where its neighbours begin and end.
 * @param {number} left
 * @param {number} top
 * @param {number} wide
 * @param {number} high
 */
function cutMarks(left, top, wide, high) {
  const { overlap } = PAGE;
  const long = CROP_MARK.to - CROP_MARK.from;
  const across = [0, overlap, wide - overlap, wide].map((x, k) => {
    const length = k % 3 === 0 ? long : long / 2;
    const at = left + x;
    return `M${at} ${top - CROP_MARK.from}v${-length}M${at} ${top + high + CROP_MARK.from}v${length}`;
  });
  const down = [0, overlap, high - overlap, high].map((y, k) => {
    const length = k % 3 === 0 ? long : long / 2;
    const at = top + y;
    return `M${left - CROP_MARK.from} ${at}h${-length}M${left + wide + CROP_MARK.from} ${at}h${length}`;
  });
  return [...across, ...down].join("");
}

/**
 * @param {string} text
 * @param {number} x
 * @param {number} y
 */
function lettered(text, x, y) {
  const made = drawnElement("text", { x, y, "font-size": 3, "font-family": "sans-serif", fill: "black" });
  made.textContent = text;
  return made;
}

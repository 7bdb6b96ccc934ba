import { medianOf, polynomialFit, valueOf } from "./fitting.js";

/**
 * How a line is sought; the numbers and their reasons are those of checking/photo (frame_lines, lens, curl, bends).
 * @typedef {{stations: number, sights: number, reach: number, far: number, clear: number, clearDots: number, aside: number,
 *   nearCorner: number, faint: number, seen: number, bend: number, stray: number, degree: number, rounds: number,
 *   cut: number, floor: number, dim: number, share: number, usual: number, doubt: number,
 *   shortest: number, longest: number, stiff: number, clearer: number}} Seeking
 * @typedef {(station: number, offset: number) => number} ReadAcross grey, 0 ... 255, at an offset across the edge, mm
 */

/** Readings across a line whose darkness is weighed. */
const WINDOW = 33;
/** So often the window is laid about the middle of the darkness. */
const CENTRINGS = 3;
/** From the median of what is left to a standard deviation. */
const OF_MEDIAN = 1.4826;

/**
 * Return offsets, mm, and how much darker each is than the paper beside it: shares, a row a station, 0 where a side is
 * darker or is not in the photograph; each is the mean with its neighbours along the edge.
 * @param {ReadAcross} read
 * @param {number} clear mm
 * @param {Seeking} how
 */
export function stripOf(read, clear, { stations, reach, aside, dim }) {
  const step = clear / aside;
  const half = roundEven(reach / step);
  const wide = 2 * (half + aside) + 1;
  const grey = new Float64Array(stations * wide);
  for (let k = 0; k < stations; k += 1) {
    for (let n = 0; n < wide; n += 1) grey[k * wide + n] = read(k, step * (n - half - aside));
  }
  const mean = Float64Array.from(grey, (one, k) =>
    k < wide || k >= grey.length - wide ? one : ((grey[k - wide] ?? 0) + one + (grey[k + wide] ?? 0)) / 3,
  );
  const width = 2 * half + 1;
  const dark = new Float64Array(stations * width);
  for (let k = 0; k < stations; k += 1) {
    for (let n = 0; n < width; n += 1) {
      const at = k * wide + n;
      const paper = Math.min(mean[at] ?? NaN, mean[at + 2 * aside] ?? NaN);
      const share = (paper - (mean[at + aside] ?? NaN)) / Math.max(paper, dim);
      dark[k * width + n] = share > 0 ? share : 0;
    }
  }
  return { offsets: Float64Array.from({ length: width }, (_, n) => step * (n - half)), dark };
}

/**
 * Return the nearest whole number, of two the even one, as Python does.
 * @param {number} x
 */
function roundEven(x) {
  const low = Math.floor(x);
  if (x - low !== 0.5) return Math.round(x);
  return low % 2 === 0 ? low : low + 1;
}

/**
 * Return the path of columns, a station each, with the greatest sum of darkness; it goes a column aside at most.
 * @param {Float64Array} dark
 * @param {number} width
 * @param {number} bend what a step aside costs
 */
export function darkestPath(dark, width, bend) {
  const stations = dark.length / width;
  const came = new Int8Array(dark.length);
  let best = dark.slice(0, width);
  for (let k = 1; k < stations; k += 1) {
    const [before, first] = [best, k * width];
    best = before.map((sum, n) => {
      const left = valueAt(before, n - 1) - bend;
      const right = valueAt(before, n + 1) - bend;
      const most = Math.max(sum, left, right);
      came[first + n] = most === sum ? 0 : most === left ? -1 : 1;
      return most + valueAt(dark, first + n);
    });
  }
  const path = new Int32Array(stations);
  path[stations - 1] = best.indexOf(Math.max(...best));
  for (let k = stations - 1; k > 0; k -= 1) {
    const column = path[k] ?? 0;
    path[k - 1] = column + (came[k * width + column] ?? 0);
  }
  return path;
}

/**
 * @param {Float64Array} row
 * @param {number} n
 */
function valueAt(row, n) {
  return row[n] ?? -Infinity;
}

/**
 * Return the centroid of the darkness within `clear` of a place across the edge, mm; NaN where nothing is dark.
 * @param {ReadAcross} read
 * @param {number} station
 * @param {number} from mm
 * @param {number} clear mm
 */
export function centroidOf(read, station, from, clear) {
  let centre = from;
  for (let round = 0; round < CENTRINGS; round += 1) {
    const grey = Array.from({ length: WINDOW }, (_, n) => read(station, centre + windowAt(n, clear)));
    const [first = NaN, last = NaN] = [grey[0], grey.at(-1)];
    let whole = 0;
    let moment = 0;
    grey.forEach((one, n) => {
      const share = n / (WINDOW - 1);
      const dark = Math.max(first * (1 - share) + last * share - one, 0);
      whole += dark;
      moment += dark * windowAt(n, clear);
    });
    centre += moment / (whole > 0 ? whole : NaN);
  }
  return centre;
}

/**
 * @param {number} n
 * @param {number} clear
 */
function windowAt(n, clear) {
  return -clear + (2 * clear * n) / (WINDOW - 1);
}

/**
 * Return the smooth curve through most of the offsets, and the weight of each (Tukey's biweight).
 * @param {Float64Array} place
 * @param {Float64Array} offset
 * @param {boolean[]} given
 * @param {Seeking} how
 */
export function smoothCurve(place, offset, given, { degree, rounds, cut, floor }) {
  let weights = Float64Array.from(given, Number);
  /** @type {number[]} */
  let curve = [];
  for (let round = 0; round < rounds; round += 1) {
    if (weights.filter((one) => one > 0).length <= degree) break;
    curve = polynomialFit(place, offset, weights, degree);
    const off = offset.map((one, k) => Math.abs(one - valueOf(curve, place[k] ?? 0)));
    const scatter = OF_MEDIAN * medianOf(off.filter((_, k) => given[k] === true)) + floor;
    weights = off.map((one, k) => (given[k] === true ? Math.max(1 - (one / (cut * scatter)) ** 2, 0) ** 2 : 0));
  }
  return { curve, weights };
}

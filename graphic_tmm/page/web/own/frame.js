import { unbending } from "./bends.js";
import { noCurl, risenSpot } from "./curl.js";
import { medianOf, polynomialFit, valueOf } from "./fitting.js";
import { pinholeOf } from "./lens.js";
import { projected, verticesOf } from "./projection.js";
import { greyAt, Shot } from "./shot.js";
import { centroidOf, darkestPath, smoothCurve, stripOf } from "./strip.js";

/**
 * @typedef {import("./lens.js").SeenLine} SeenLine
 * @typedef {import("./projection.js").Rectangle} Rectangle
 * @typedef {import("./projection.js").Spot} Spot
 * @typedef {import("./shot.js").Photograph} Photograph
 * @typedef {import("./strip.js").ReadAcross} ReadAcross
 * @typedef {import("./strip.js").Seeking} Seeking
 * A line across an edge: offsets at its ends to the left, mm; how far it is from straight (NaN: not seen), its points
 * @typedef {{start: number, end: number, bend: number, line: SeenLine | null}} FoundEdge
 * The frame as it was found: `residual` without the lens, `bowed` by the lens alone, mm; `missing`: edges (0 lower,
 * right, upper, left) that show no line
 * @typedef {{shot: Shot, residual: number, bowed: number, missing: number[]}} FoundFrame
 */

const UNSEEN = { start: 0, end: 0, bend: NaN, line: null };
/** Places along an edge at which it is asked how far the lens bows it. */
const OF_BOW = 33;

/**
 * Return the frame found near corners, px, in a photograph, as checking/photo/frame_lines.py finds it.
 * @param {Photograph} image
 * @param {Rectangle} box mm
 * @param {Spot[]} clicked in the order of `verticesOf`
 * @param {Seeking} how
 * @returns {FoundFrame}
 */
export function refinedFrame(image, box, clicked, how) {
  const feet = verticesOf(box);
  let straighter = { lens: pinholeOf(image), curl: noCurl(box) };
  let shot = new Shot(box, clicked, straighter.lens);
  /** @type {FoundEdge[]} */
  let edges = [];
  for (let sight = 0; sight < how.sights; sight += 1) {
    const { lens, curl } = straighter;
    const aimed = new Shot(box, shot.corners, lens, curl);
    edges = feet.map((foot, k) => {
      const head = feet[(k + 1) % 4] ?? foot;
      const near = edgeOf(image, aimed, foot, head, how);
      // at first sight farther away if there is none near it
      return near.line === null && sight === 0 ? edgeOf(image, aimed, foot, head, { ...how, reach: how.far }) : near;
    });
    const met = meetingsOf(feet, edges);
    shot = new Shot(
      box,
      met.map(([x, y]) => aimed.seen(x, y)),
      lens,
      curl,
    );
    const lines = edges.flatMap((one) => (one.line === null ? [] : [one.line]));
    straighter = unbending(aimed, lines, how);
  }
  const bends = edges.map((one) => one.bend).filter((one) => one === one);
  return {
    shot,
    residual: bends.length > 0 ? Math.max(...bends) : NaN,
    bowed: bowedBy(new Shot(box, shot.corners, shot.lens), feet),
    missing: edges.flatMap((one, k) => (one.line === null ? [k] : [])),
  };
}

/**
 * Return where the lines of neighbouring edges meet, mm.
 * @param {Spot[]} feet
 * @param {FoundEdge[]} edges
 * @returns {Spot[]}
 */
function meetingsOf(feet, edges) {
  const lines = feet.map(([x, y], k) => {
    const [hx, hy] = feet[(k + 1) % 4] ?? [x, y];
    const { start, end } = edges[k] ?? UNSEEN;
    const long = Math.hypot(hx - x, hy - y);
    const [nx, ny] = [-(hy - y) / long, (hx - x) / long];
    const from = /** @type {const} */ ([x + nx * start, y + ny * start]);
    return { from, way: /** @type {const} */ ([hx + nx * end - from[0], hy + ny * end - from[1]]) };
  });
  return lines.map(({ from, way }, k) => {
    const { from: before, way: last } = lines[(k + 3) % 4] ?? { from, way };
    const along =
      ((from[0] - before[0]) * way[1] - (from[1] - before[1]) * way[0]) / (last[0] * way[1] - last[1] * way[0]);
    return [before[0] + last[0] * along, before[1] + last[1] * along];
  });
}

/**
 * Return the line that is seen along the edge between two corners.
 * @param {Photograph} image
 * @param {Shot} shot
 * @param {Spot} foot
 * @param {Spot} head
 * @param {Seeking} how
 * @returns {FoundEdge}
 */
function edgeOf(image, shot, foot, head, how) {
  const { stations, faint, seen: enough } = how;
  const long = Math.hypot(head[0] - foot[0], head[1] - foot[1]);
  const [wx, wy] = [(head[0] - foot[0]) / long, (head[1] - foot[1]) / long];
  const inset = Math.min(how.nearCorner, long / 10);
  const along = Float64Array.from({ length: stations }, (_, k) => inset + ((long - 2 * inset) * k) / (stations - 1));
  /** @type {(station: number, offset: number) => Spot} */
  const spotAt = (k, offset) => {
    const far = along[k] ?? 0;
    return shot.seen(foot[0] + wx * far - wy * offset, foot[1] + wy * far + wx * offset);
  };
  /** @type {ReadAcross} */
  const read = (k, offset) => greyAt(image, ...spotAt(k, offset));
  const fine = finestOf(stations, spotAt) / ((along[1] ?? 0) - (along[0] ?? 0));
  const wide = how.clearDots / fine;
  const clear = wide > how.clear ? wide : how.clear;

  const { offsets, dark } = stripOf(read, clear, how);
  const width = offsets.length;
  const strays = offsets.map((one) => how.stray * (one / how.reach) ** 2);
  const path = darkestPath(
    dark.map((one, k) => one - (strays[k % width] ?? 0)),
    width,
    how.bend,
  );
  const depth = Array.from(path, (column, k) => dark[k * width + column] ?? 0);
  const centre = Float64Array.from(path, (column, k) => centroidOf(read, k, offsets[column] ?? 0, clear));
  const half = medianOf(depth) / 2;
  const shown = depth.map((one, k) => one > faint && one > half && Number.isFinite(centre[k]));
  if (shareOf(shown) < enough) return UNSEEN;
  shown.forEach((one, k) => (centre[k] = one ? (centre[k] ?? 0) : 0));
  const place = along.map((one) => (2 * one) / long - 1);
  const { curve, weights } = smoothCurve(place, centre, shown, how);
  const kept = Array.from(weights, (one) => one > 0);
  if (shareOf(kept) < enough) return UNSEEN;
  const line = polynomialFit(place, centre, weights, 1);
  // beside its straight line, and what the curl that the strip follows has of bend
  const rise = along.map((far) => {
    const [ax, ay] = [foot[0] + wx * far, foot[1] + wy * far];
    const [sx, sy] = risenSpot(shot.curl, ax, ay);
    return (sy - ay) * wx - (sx - ax) * wy;
  });
  const tilt = polynomialFit(place, rise, weights, 1);
  const bends = [...place].map((one, k) =>
    Math.abs(valueOf(curve, one) - valueOf(line, one) + (rise[k] ?? 0) - valueOf(tilt, one)),
  );
  const spots = [...path.keys()].filter((k) => kept[k]).map((k) => spotAt(k, centre[k] ?? 0));
  return {
    start: valueOf(line, -1),
    end: valueOf(line, 1),
    bend: Math.max(...bends.filter((_, k) => kept[k])),
    line: {
      x: Float64Array.from(spots, (one) => one[0]),
      y: Float64Array.from(spots, (one) => one[1]),
      weights: weights.filter((one) => one > 0),
    },
  };
}

/** @param {boolean[]} which */
function shareOf(which) {
  return which.filter(Boolean).length / which.length;
}

/**
 * Return the least distance of neighbouring stations as they are seen, px.
 * @param {number} stations
 * @param {(station: number, offset: number) => Spot} spotAt
 */
function finestOf(stations, spotAt) {
  let least = Infinity;
  for (let k = 1; k < stations; k += 1) {
    const [[ax, ay], [bx, by]] = [spotAt(k - 1, 0), spotAt(k, 0)];
    const far = Math.hypot(bx - ax, by - ay);
    if (!(far >= least)) least = far;
  }
  return least;
}

/**
 * Return how far the lens alone bows the edges from straight lines, mm.
 * @param {Shot} shot
 * @param {Spot[]} feet
 */
function bowedBy(shot, feet) {
  let worst = 0;
  const share = Float64Array.from({ length: OF_BOW }, (_, k) => k / (OF_BOW - 1));
  feet.forEach(([x, y], k) => {
    const [hx, hy] = feet[(k + 1) % 4] ?? [x, y];
    const long = Math.hypot(hx - x, hy - y);
    const aside = share.map((one) => {
      const [sx, sy] = projected(shot.back, ...shot.seen(x + (hx - x) * one, y + (hy - y) * one));
      return ((sy - y) * (hx - x) - (sx - x) * (hy - y)) / long;
    });
    const line = polynomialFit(share, aside, new Float64Array(OF_BOW).fill(1), 1);
    aside.forEach((one, n) => (worst = Math.max(worst, Math.abs(one - valueOf(line, share[n] ?? 0)))));
  });
  return worst;
}

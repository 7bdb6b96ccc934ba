/**
 * Outlines of instruments over a drawing, as path data in millimetres of the sheet (y downward).
 *
 * @typedef {[number, number]} Spot
 * @typedef {{d: string, ghost?: boolean}} Outline
 */

/** How large instruments are, mm: legs of the square, radius of the protractor, width of the ruler. */
const LEG = 42;
const SHORT = 24;
const ROUND = 20;
const WIDE = 7;

/**
 * Return the outlines of an instrument.
 * @param {string} kind
 * @param {Spot[]} spots where it lies
 * @param {number} scale how many times larger it is shown than it is usually
 * @returns {Outline[]}
 */
export function outlinesOf(kind, spots, scale) {
  const [a = [0, 0], b = a, c = b, d] = spots;
  if (kind === "compass") return compassAt(a, b, scale);
  if (kind === "ruler") return [{ d: rulerAlong(a, b, scale) + ticksAlong(a, b, scale) }];
  if (kind === "edge") return [{ d: rulerAlong(a, b, scale) }];
  if (kind === "protractor") return [{ d: protractorAt(a, b, c, scale) }];
  if (kind === "square") return squareAt(a, b, c, d, scale);
  return [];
}

/** @param {Spot[]} spots */
function joined(spots, closed = true) {
  return spots.map(([x, y], k) => `${k === 0 ? "M" : "L"}${x.toFixed(2)} ${y.toFixed(2)}`).join("") + (closed ? "Z" : "");
}

/**
 * Return the place so far along and so far to the left of a direction.
 * @param {Spot} from
 * @param {Spot} way
 * @param {number} along
 * @param {number} aside
 * @returns {Spot}
 */
function beyond(from, way, along, aside = 0) {
  return [from[0] + along * way[0] + aside * way[1], from[1] + along * way[1] - aside * way[0]];
}

/**
 * @param {Spot} a
 * @param {Spot} b
 * @returns {[Spot, number]} the direction from one place to another, and how far it is
 */
function wayOf(a, b) {
  const size = Math.hypot(b[0] - a[0], b[1] - a[1]);
  return [size > 0 ? [(b[0] - a[0]) / size, (b[1] - a[1]) / size] : [1, 0], size];
}

/**
 * A compass: its needle in the centre, its pencil on the arc, its legs meeting above.
 * @param {Spot} centre
 * @param {Spot} tip
 * @param {number} scale
 * @returns {Outline[]}
 */
function compassAt(centre, tip, scale) {
  const [way, radius] = wayOf(centre, tip);
  const up = way[0] < 0 ? -1 : 1;
  const head = beyond(centre, way, radius / 2, up * Math.max(0.7 * radius, 16 * scale));
  const knob = wayOf(beyond(centre, way, radius / 2), head)[0];
  const legs = joined([centre, head, tip], false) + joined([head, beyond(head, knob, 5 * scale)], false);
  return [{ d: legs + ringAt(centre, 1.2 * scale) + ringAt(head, 1.6 * scale) }, { d: joined([centre, tip], false), ghost: true }];
}

/**
 * @param {Spot} at
 * @param {number} r
 */
function ringAt([x, y], r) {
  return `M${(x - r).toFixed(2)} ${y.toFixed(2)}a${r} ${r} 0 1 0 ${2 * r} 0a${r} ${r} 0 1 0 ${-2 * r} 0`;
}

/**
 * A ruler with its edge from one place to another.
 * @param {Spot} a
 * @param {Spot} b
 * @param {number} scale
 */
function rulerAlong(a, b, scale) {
  const [way, size] = wayOf(a, b);
  const [start, end, wide] = [-5 * scale, size + 8 * scale, WIDE * scale];
  return joined([beyond(a, way, start), beyond(a, way, end), beyond(a, way, end, -wide), beyond(a, way, start, -wide)]);
}

/**
 * The divisions of a ruler from its zero on, 5 mm by 5 mm.
 * @param {Spot} a
 * @param {Spot} b
 * @param {number} scale
 */
function ticksAlong(a, b, scale) {
  const [way, size] = wayOf(a, b);
  let d = "";
  for (let mm = 0; mm <= size + 5; mm += 5) {
    d += joined([beyond(a, way, mm), beyond(a, way, mm, (mm % 10 === 0 ? -3 : -1.8) * scale)], false);
  }
  return d;
}

/**
 * A protractor: its centre on the vertex, its base along a line, a ray to the angle.
 * @param {Spot} at
 * @param {Spot} base
 * @param {Spot} ray
 * @param {number} scale
 */
function protractorAt(at, base, ray, scale) {
  const [along] = wayOf(at, base);
  const [way] = wayOf(at, ray);
  const left = along[0] * way[1] - along[1] * way[0] < 0 ? 1 : -1;
  const r = ROUND * scale;
  let d = joined([beyond(at, along, -r), beyond(at, along, r)], false);
  const [from, to] = [beyond(at, along, r), beyond(at, along, -r)];
  d += `M${from[0].toFixed(2)} ${from[1].toFixed(2)}A${r} ${r} 0 0 ${left > 0 ? 0 : 1} ${to[0].toFixed(2)} ${to[1].toFixed(2)}`;
  for (let angle = 10; angle < 180; angle += 10) {
    const turned = (angle * Math.PI) / 180;
    const spoke = wayOf([0, 0], beyond([0, 0], along, Math.cos(turned), left * Math.sin(turned)))[0];
    d += joined([beyond(at, spoke, r), beyond(at, spoke, r - (angle % 30 === 0 ? 3 : 1.8) * scale)], false);
  }
  return d + joined([beyond(at, way, r - 5 * scale), beyond(at, way, r + 5 * scale)], false);
}

/**
 * A square with one edge along the line to be drawn, and where it was slid from: an edge along the known line.
 * @param {Spot} at where the line goes through
 * @param {Spot} along a place of the line
 * @param {Spot} to a place in the direction of the known line, where that is another one
 * @param {Spot | undefined} from a place of the known line
 * @param {number} scale
 * @returns {Outline[]}
 */
function squareAt(at, along, to, from, scale) {
  const [way] = wayOf(at, along);
  const across = Math.hypot(to[0] - at[0], to[1] - at[1]) > 0;
  /** @param {Spot} spot */
  const triangle = (spot) =>
    across
      ? joined([beyond(spot, way, -3 * scale), beyond(spot, way, LEG * scale), beyond(spot, way, -3 * scale, -SHORT * scale)])
      : joined([beyond(spot, way, -8 * scale), beyond(spot, way, LEG * scale), beyond(spot, way, -8 * scale, -SHORT * scale)]);
  const ghost = from === undefined ? [] : [{ d: triangle(from), ghost: true }];
  return [...ghost, { d: triangle(at) }];
}

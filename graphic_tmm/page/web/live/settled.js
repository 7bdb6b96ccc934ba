import { besideOf } from "../practice/beside-point.js";

/**
 * @typedef {import("../types.js").Variant} Variant
 * @typedef {import("../practice/beside-point.js").Spot} Spot
 * @typedef {import("./liveink.js").LiveInk} LiveInk
 * @typedef {import("./tied.js").Expressions} Expressions
 */

/** Between places of ink that letters keep from, mm; white about a letter; about a figure, as page/crank.py has it. */
const INK_PACE = 2;
const ABOUT_LETTER = 1.5;
const AROUND_INK = 4;
/** The middle of a letter stands off its point so many times half of what it takes with its white; farther, if it is
 * no farther than so much from ink there. The sign of its point is as large as the least, ink beyond the most is far away. */
const OFF = [1.6, 2.4];
const CLEAR_OF_INK = 0.7;
const AT_POINT = 0.6;
const FAR_INK = 5;
/** What reaches so many times as far as usual has flown away; how far is usual, mm: as page/strands.py has it. */
const FLOWN = 10;
const USUAL_LEAST = 200;
const USUAL_MOST = 1000;
/** What takes this share of a box, along either side, fills it. */
const FILLED_BOX = 0.75;
/** A figure is looked at every so many degrees, and at each about those where it reaches farthest. */
const EVERY = 5;

/**
 * Let a figure settle: place its letters anew in some positions, off lines and one another, gliding from one to the next as
 * page/letters.py lets them; then tell how much room it takes over all angles.
 * @param {LiveInk} ink
 * @param {import("../moving.js").Moving} moving
 * @param {number[]} places indices of angles at which letters are placed
 * @param {(k: number) => boolean} drawn
 * @returns {number[] | null} left, top, width, height, y downward; null of a figure without ink
 */
export function settled(ink, moving, places, drawn) {
  const { expressions, frames, whole } = ink;
  const { strokes, letters } = moving;
  const { nodes } = moving;
  const boxes = letters.map((one) => /** @type {SVGGraphicsElement} */ (one.made).getBBox());
  /** @type {Map<number, Spot>[]} */
  const asides = letters.map(() => new Map());
  const look = (/** @type {number} */ k) => {
    expressions.some(nodes, ink.marks(k));
    return strokes.map((one) => outlineOf(expressions, one));
  };
  for (const k of places.filter(drawn)) {
    const black = look(k).flatMap(spotsOf);
    letters.forEach(({ variants }, n) => {
      const { width = 0, height = 0 } = boxes[n] ?? {};
      for (const [x, y] of outlineOf(expressions, variants)) {
        // counted in halves of what it takes any letter is a circle
        const [wide, high] = [width / 2 + ABOUT_LETTER, height / 2 + ABOUT_LETTER];
        const [u, v] = freeBeside(black.map(([p, q]) => [(p - x) / wide, (q - y) / high]));
        asides[n]?.set(frames[k] ?? k, [u * wide, v * high]);
        for (const share of [-0.5, 0, 0.5]) black.push([x + u * wide + share * width, y + v * high]);
      }
    });
  }
  moving.asides = asides.map((own, n) => {
    const { x = 0, y = 0, width = 0, height = 0 } = boxes[n] ?? {};
    const along = gliding(own, whole);
    return own.size === 0 ? null : (k) => along(frames[k] ?? k, -x - width / 2, y + height / 2);
  });
  return roomOf(frames.map((_, k) => k).filter(drawn), whole, (k) => {
    const spots = look(k).flat();
    letters.forEach(({ variants, aside }, n) => {
      const { x = 0, y = 0, width = 0, height = 0 } = boxes[n] ?? {};
      const [u, v] = (moving.asides[n] ?? aside)(k);
      for (const [p, q] of outlineOf(expressions, variants)) spots.push([p + u + x, q + v - y], [p + u + x + width, q + v - y - height]);
    });
    return [0, 1, 2, 3].map((n) => Math.max(...spots.map((spot) => (n < 2 ? -1 : 1) * (spot[n % 2] ?? 0))));
  });
}

/**
 * Return the place of a letter whose point is at 0.
 * @param {Spot[]} black
 * @returns {Spot}
 */
function freeBeside(black) {
  const near = black.filter(([x, y]) => Math.hypot(x, y) > AT_POINT && Math.hypot(x, y) < FAR_INK);
  const tried = OFF.map((off) => besideOf([0, 0], off, near));
  return tried.find(([u, v]) => near.every(([x, y]) => Math.hypot(x - u, y - v) > CLEAR_OF_INK)) ?? tried[0] ?? [1, 1];
}

/**
 * Return the places of something as it is drawn, with the tops of its arcs; none where it is not there.
 * @param {Expressions} expressions
 * @param {Variant[]} variants
 * @returns {Spot[]}
 */
function outlineOf(expressions, variants) {
  const { re, im } = expressions;
  const [, nodes = [], bulges = 0] = expressions.drawn(variants) ?? [];
  const spots = nodes.map((node) => /** @type {Spot} */ ([re[node] ?? NaN, im[node] ?? NaN]));
  if (bulges === 0) return spots;
  return spots.flatMap(([x, y], n) => {
    const [u, v] = spots[(n + 1) % spots.length] ?? [x, y];
    const bulge = re[bulges[n] ?? -1] ?? 0;
    return [[x, y], [(x + u + bulge * (v - y)) / 2, (y + v - bulge * (u - x)) / 2]];
  });
}

/**
 * Return places along a line.
 * @param {Spot[]} line
 * @returns {Spot[]}
 */
function spotsOf(line) {
  return line.flatMap(([x, y], n) => {
    const [u, v] = line[n + 1] ?? [x, y];
    const count = Math.ceil(Math.hypot(u - x, v - y) / INK_PACE) || 1;
    return Array.from({ length: count }, (_, k) => /** @type {Spot} */ ([x + ((u - x) * k) / count, y + ((v - y) * k) / count]));
  });
}

/**
 * Return how far a letter stands from its point at any angle: ways go evenly from one to the next, round the shorter way.
 * @param {Map<number, Spot>} placed by the angles
 * @param {number} whole
 * @returns {(angle: number, x: number, y: number) => Spot} the way, and x, y more
 */
function gliding(placed, whole) {
  const known = [...placed].sort(([a], [b]) => a - b).map(([at, [x, y]]) => ({ at, far: Math.hypot(x, y), turn: Math.atan2(y, x) }));
  return (angle, x, y) => {
    const after = known.findIndex((one) => one.at > angle);
    const one = known.at(after < 0 ? -1 : after - 1) ?? { at: 0, far: 0, turn: 0 };
    const next = known[Math.max(after, 0)] ?? one;
    const share = ((angle - one.at + whole) % whole) / ((next.at - one.at + whole) % whole || whole);
    const turn = one.turn + share * (((next.turn - one.turn + 3 * Math.PI) % (2 * Math.PI)) - Math.PI);
    const far = one.far + share * (next.far - one.far);
    return [far * Math.cos(turn) + x, far * Math.sin(turn) + y];
  };
}

/**
 * Return the room of a figure over all angles, but for those at which it has flown away.
 * @param {number[]} angles
 * @param {number} whole
 * @param {(k: number) => number[]} sidesAt how far it reaches to the left, down, to the right, up
 */
function roomOf(angles, whole, sidesAt) {
  /** @type {Map<number, number[]>} */
  const rooms = new Map();
  const farthest = (/** @type {number[]} */ some) => {
    for (const k of some) if (!rooms.has(k)) rooms.set(k, sidesAt(k));
    const known = [...rooms].filter(([, sides]) => Math.max(...sides) > -Infinity).sort(([, a], [, b]) => Math.max(...a) - Math.max(...b));
    const usual = Math.max(...(known[known.length >> 1]?.[1] ?? []));
    const there = known.filter(([, sides]) => Math.max(...sides) <= FLOWN * Math.min(Math.max(usual, USUAL_LEAST), USUAL_MOST));
    return [0, 1, 2, 3].map((n) => there.reduce((a, b) => ((b[1][n] ?? 0) > (a[1][n] ?? 0) ? b : a), there[0] ?? [0, []]));
  };
  const ends = farthest(angles.filter((k) => k % EVERY === 0 || k >= whole)).map(([k]) => k);
  const near = angles.filter((k) => ends.some((end) => Math.abs(k - end) < EVERY || Math.abs(k - end) > whole - EVERY));
  const [left = NaN, low = NaN, right = NaN, high = NaN] = farthest(near).map(([, sides], n) => sides[n] ?? NaN);
  const box = [-left - AROUND_INK, -high - AROUND_INK, left + right + 2 * AROUND_INK, low + high + 2 * AROUND_INK];
  return box.some(Number.isNaN) ? null : box;
}

/**
 * Whether the box that a figure has with the lengths of its sheet holds another, and is well filled by it.
 * @param {number[]} box
 * @param {number[]} own
 */
export function holdsWell(box, own) {
  const [wide, high] = [0, 1].map((n) => {
    const [from = 0, size = 0, begins = 0, takes = 0] = [box[n], box[n + 2], own[n], own[n + 2]];
    return begins >= from && begins + takes <= from + size ? takes / size : NaN;
  });
  return Math.max(wide ?? NaN, high ?? NaN) > FILLED_BOX;
}

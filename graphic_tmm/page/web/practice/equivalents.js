import { BOARD } from "./board.js";

/**
 * @typedef {import("../types.js").Complex} Complex
 * @typedef {import("../types.js").Drawn} Drawn
 * @typedef {import("../types.js").DrawnArc} DrawnArc
 * @typedef {import("../types.js").DrawnLine} DrawnLine
 * @typedef {import("../types.js").Limb} Limb
 * @typedef {import("./judging.js").Judging} Judging
 * @typedef {import("./judging.js").Own} Own
 */

/**
 * Return the mildest of what a point is off by the log's construction and by others that are as right
 * (checking/judging/equivalents.py).
 * @param {Judging} judging
 * @param {import("./judging.js").Taken} row
 * @param {Own} own
 * @returns {Own}
 */
export function mildest(judging, { slot, found, last }, own) {
  const { reader, share, log } = judging;
  const due = judging.run.due.get(slot);
  if (typeof found === "number" || due === undefined) return own;
  const grain = judging.lost(last, share);
  const exact = /** @type {Complex} */ (log.exact.get(slot));
  const placed = BOARD.slips.off_place(found, exact) <= (judging.manner.placed[String(slot)]?.[judging.place] ?? -1);
  for (const way of log.steps.get(slot)?.ways ?? []) {
    const offs = offsOf(judging, way, found, /** @type {Complex} */ (due), placed);
    const times = offs.map(({ error, size }) => BOARD.slips.counted(error, grain) / size);
    const worst = times.indexOf(Math.max(...times));
    const counted = times[worst] ?? Infinity;
    const { doubtful, wrong } = reader.pair;
    if (gravity(counted, doubtful, wrong) < gravity(own.counted, own.doubtful, own.wrong)) {
      own = { counted, doubtful, wrong, error: offs[worst]?.error ?? 0, by: own.by };
    }
  }
  return own;
}

/**
 * @param {number} counted
 * @param {number} doubtful
 * @param {number} wrong
 */
function gravity(counted, doubtful, wrong) {
  return BOARD.slips.severity(counted, 0, doubtful, wrong, Infinity);
}

/**
 * Return how far a point is off the two conditions of a way, and how large a hand makes that; nothing if it cannot
 * be drawn so.
 * @param {Judging} judging
 * @param {[Limb, Limb]} way
 * @param {Complex} found
 * @param {Complex} due
 * @param {boolean} placed it stands where it is due, so that two lines fixed it, however sharp they cross
 */
function offsOf(judging, way, found, due, placed) {
  const [one, other] = way;
  const first = centreOf(judging.run.values.get(one[1]));
  const second = centreOf(judging.run.values.get(other[1]));
  if (first === undefined || second === undefined) return [];
  if (one[0] === "line") {
    if (!placed && !crosses(judging, alongOf(judging, one, first), alongOf(judging, other, second))) return [];
  } else if (one[0] === other[0] && !fixes(judging, one[0], found, due, first, second)) return [];
  const offs = [offLimb(judging, one, first, found, due), offLimb(judging, other, second, found, due)];
  return offs.every(({ error, size }) => Number.isFinite(error + size)) ? offs : [];
}

/**
 * Whether two rays or arcs fix a point, and it is the due one of two meetings.
 * @param {Judging} judging
 * @param {"ray" | "arc" | "line"} kind
 * @param {Complex} found
 * @param {Complex} due
 * @param {Complex} first
 * @param {Complex} second
 */
function fixes(judging, kind, found, due, first, second) {
  const { slips } = BOARD;
  if (kind === "arc" && slips.off_meeting(found, due, slips.reflected(due, first, second)) > 0) return false;
  return slips.sine_between(due, first, second) >= judging.reader.sine;
}

/**
 * Whether two lines cross so that they fix a point.
 * @param {Judging} judging
 * @param {Complex | undefined} one
 * @param {Complex | undefined} other
 */
function crosses(judging, one, other) {
  if (one === undefined || other === undefined) return false;
  const turn = Math.abs(one.re * other.im - one.im * other.re);
  return turn >= judging.reader.sine * Math.hypot(one.re, one.im) * Math.hypot(other.re, other.im);
}

/**
 * Return the direction of a line through a point.
 * @param {Judging} judging
 * @param {Limb} limb
 * @param {Complex} centre
 * @returns {Complex | undefined}
 */
function alongOf(judging, [, , slot = -1], centre) {
  const other = judging.run.values.get(slot);
  if (other === undefined || typeof other === "number" || "radius" in other) return undefined;
  return "at" in other ? other.along : { re: other.re - centre.re, im: other.im - centre.im };
}

/**
 * Return how far a point is off a line through two points, or through one along a line.
 * @param {Judging} judging
 * @param {Limb} limb
 * @param {Complex} centre
 * @param {Complex} found
 */
function offLine(judging, limb, centre, found) {
  const { slips } = BOARD;
  const { swing, prick } = judging.reader;
  const pointing = judging.share * judging.manner.pointing;
  const along = alongOf(judging, limb, centre) ?? { re: NaN, im: NaN };
  const [long, far] = [Math.hypot(along.re, along.im), slips.off_place(found, centre)];
  const error = ((found.im - centre.im) * along.re - (found.re - centre.re) * along.im) / long;
  const other = judging.run.values.get(limb[2] ?? -1);
  const straight = typeof other === "object" && "at" in other;
  // what both ends are off turns and moves it
  const slip = straight ? slips.swung(far, swing) : Math.hypot(prick, pointing) * Math.hypot(far / long, 1 - far / long);
  return { error, size: slips.found_within(slip, prick, pointing) };
}

/**
 * @param {Judging} judging
 * @param {Limb} limb
 * @param {Complex} centre
 * @param {Complex} found
 * @param {Complex} due
 */
function offLimb(judging, limb, centre, found, due) {
  const [kind, , ...of] = limb;
  if (kind === "line") return offLine(judging, limb, centre, found);
  const { slips } = BOARD;
  const { swing, compass, reading, half, prick } = judging.reader;
  const far = slips.off_place(due, centre);
  const pointing = judging.share * judging.manner.pointing;
  if (kind === "ray") {
    return { error: slips.off_ray(found, due, centre), size: slips.found_within(slips.swung(far, swing), prick, pointing) };
  }
  const [from, to] = of.map((slot) => centreOf(judging.run.values.get(slot)));
  const share = from === undefined || to === undefined ? 0 : far / slips.off_place(to, from);
  const slip = slips.opened(share, compass, reading, half);
  return { error: slips.off_opening(found, due, centre), size: slips.found_within(slip, prick, pointing) };
}

/**
 * Return the point about which a condition is: a point, the beginning of a line, the centre of an arc.
 * @param {Drawn | undefined} value
 * @returns {Complex | undefined}
 */
function centreOf(value) {
  if (value === undefined || typeof value === "number") return undefined;
  if ("at" in value) return value.at;
  return "centre" in value ? value.centre : value;
}

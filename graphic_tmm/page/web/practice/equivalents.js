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
  for (const way of log.steps.get(slot)?.ways ?? []) {
    const offs = offsOf(judging, way, found, /** @type {Complex} */ (due));
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
 */
function offsOf(judging, way, found, due) {
  const [one, other] = way;
  const first = centreOf(judging.run.values.get(one[1]));
  const second = centreOf(judging.run.values.get(other[1]));
  if (first === undefined || second === undefined) return [];
  if (one[0] === other[0] && !fixes(judging, one[0], found, due, first, second)) return [];
  const offs = [offLimb(judging, one, first, found, due), offLimb(judging, other, second, found, due)];
  return offs.every(({ error, size }) => Number.isFinite(error + size)) ? offs : [];
}

/**
 * Whether two rays or arcs fix a point, and it is the due one of two meetings.
 * @param {Judging} judging
 * @param {"ray" | "arc"} kind
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
 * @param {Judging} judging
 * @param {Limb} limb
 * @param {Complex} centre
 * @param {Complex} found
 * @param {Complex} due
 */
function offLimb(judging, [kind, , ...of], centre, found, due) {
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

/**
 * @typedef {import("./easel.js").Easel} Easel
 * @typedef {import("../types.js").View} View
 * @typedef {import("../types.js").Joint} Joint
 * @typedef {[number, number]} Place
 * @typedef {{ink: SVGGraphicsElement, drawn: Set<number>}} Kinematic its symbols as on the sheet, laid to the
 *   millimetres of a plan; the points that they draw themselves
 */

/** What of the ink of a mechanism says nothing of how its links are joined. */
const NO_SYMBOL = ".label, title, desc, [data-part=number], [data-part=leader], path:not([data-of])";
/** Sliders: a rectangle where the sheet draws a position in full, else the stroke of its middle. */
const SLIDERS = "[data-part=stone][d$=Z], [data-part=slider][d$=Z], [data-part=piston][d$=Z]";
/** Parts that draw the points they stand on. */
const OF_POINTS = "[data-part=pair], [data-part=pivot], [data-part=centre], [data-part=stone]";

/** The arrow of the sense of the crank is so much wider, to be clear of the letter of its pivot. */
const WIDER = 2;

/**
 * Return the ink of the mechanism in the position of a task; null where the sheet does not show it there.
 * @param {Easel} easel
 * @param {View} lead the view of the mechanism
 * @returns {Kinematic | null}
 */
export function kinematicOf(easel, lead) {
  const name = easel.practice.names[easel.task.at];
  const at = Object.keys(lead.names).find((k) => lead.names[k] === name);
  const sheet = document.getElementById(lead.id);
  const joints = lead.joints ?? [];
  const known = joints.find((one) => standsAt(one, Number(at ?? -1)) && easel.practice.marks[one[0]] !== undefined && easel.values.spot(one[0]) !== null);
  if (at === undefined || sheet === null || known === undefined) return null;
  const ink = /** @type {SVGGraphicsElement} */ (/** @type {unknown} */ (sheet.cloneNode(true)));
  ink.removeAttribute("id");
  ink.classList.add("kinematic");
  for (const part of ink.querySelectorAll(NO_SYMBOL)) part.remove();
  for (const part of ink.querySelectorAll("[data-part=turning]")) turnArrow(part, joints, Number(at));
  for (const part of ink.querySelectorAll(SLIDERS)) slideTo(part, ink, joints, Number(at));
  for (const part of ink.querySelectorAll(`[data-at]:not([data-at="${at}"])`)) part.remove();
  const [x, y] = easel.values.spot(known[0]) ?? [0, 0];
  const [left, top] = jointAt(known, Number(at));
  ink.setAttribute("transform", `translate(${x - left} ${-y - top})`);
  return { ink, drawn: slotsIn(ink.querySelectorAll(OF_POINTS)) };
}

/**
 * Turn the arrow of the sense of a crank, which the sheet has in one position, with the crank to another.
 * @param {Element} arrow
 * @param {Joint[]} joints
 * @param {number} at
 */
function turnArrow(arrow, joints, at) {
  const ends = [...slotsIn([arrow])].map((slot) => joints.find((one) => one[0] === slot));
  const from = Number(arrow.getAttribute("data-at") ?? at);
  const [pivot, pin] = ends;
  if (pivot === undefined || pin === undefined || ![from, at].every((k) => standsAt(pin, k))) return;
  const [was, is] = [from, at].map((k) => {
    const [[a, b], [x, y]] = [jointAt(pivot, k), jointAt(pin, k)];
    return (Math.atan2(y - b, x - a) * 180) / Math.PI;
  });
  const [x, y] = jointAt(pivot, at);
  const turned = `translate(${x} ${y}) rotate(${Number(is) - Number(was)}) scale(${WIDER}) translate(${-x} ${-y})`;
  arrow.setAttribute("transform", turned);
  arrow.setAttribute("data-at", String(at));
}

/**
 * Put the rectangle of a slider or a piston where another position has but a stroke for it.
 * @param {Element} slider
 * @param {Element} ink
 * @param {Joint[]} joints
 * @param {number} at
 */
function slideTo(slider, ink, joints, at) {
  const of = slider.getAttribute("data-of") ?? "";
  const same = `[data-of="${of}"][data-part=${slider.getAttribute("data-part")}][data-at="${at}"]`;
  const stroke = ink.querySelector(`${same}:not([d$=Z])`);
  const pin = joints.find((one) => one[0] === Number(of.split(" ")[0]));
  const from = Number(slider.getAttribute("data-at") ?? at);
  if (stroke === null || pin === undefined || ![from, at].every((k) => standsAt(pin, k))) return;
  const turn = directionOf(stroke, 0) - directionOf(slider, 1);
  const [to, was] = [jointAt(pin, at), jointAt(pin, from)];
  slider.setAttribute("transform", `translate(${to.join(" ")}) rotate(${turn}) translate(${-was[0]} ${-was[1]})`);
  slider.setAttribute("data-at", String(at));
  stroke.remove();
}

/**
 * Return the direction of a stretch of a path of straight lines, degrees.
 * @param {Element} path
 * @param {number} k
 */
function directionOf(path, k) {
  const [x = 0, y = 0, a = 0, b = 0] = (path.getAttribute("d") ?? "").match(/-?[\d.]+/g)?.map(Number).slice(2 * k) ?? [];
  return (Math.atan2(b - y, a - x) * 180) / Math.PI;
}

/** @param {Iterable<Element>} parts */
function slotsIn(parts) {
  return new Set([...parts].flatMap((part) => (part.getAttribute("data-of") ?? "").split(" ").map(Number)));
}

/**
 * @param {Joint} joint
 * @param {number} at
 * @returns {Place} sheet mm, y downward; (0, 0) if it is not there
 */
function jointAt(joint, at) {
  return [Number(joint[3 + 2 * at] ?? 0), Number(joint[4 + 2 * at] ?? 0)];
}

/**
 * @param {Joint} joint
 * @param {number} at
 */
function standsAt(joint, at) {
  return jointAt(joint, at).some((x) => x !== 0);
}

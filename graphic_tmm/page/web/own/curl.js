/**
 * @typedef {import("./lens.js").Lens} Lens
 * @typedef {import("./projection.js").Rectangle} Rectangle
 * @typedef {import("./projection.js").Spot} Spot
 * @typedef {import("./strip.js").Seeking} Seeking
 * How a sheet curls within its frame, as checking/photo/camera.py has it: `foot`: above which point of it the camera
 * stands, mm; `upright`: about which direction; `parts`: mm aside, in the middle of an edge and what grows along it
 * @typedef {{box: Rectangle, foot: Spot, upright: boolean, parts: [number, number]}} Curl
 */

/** Rounds for the flat place of what is seen; each leaves a hundredth. */
const TURNS_OF_CURL = 8;

/**
 * Return the curl of a sheet that lies flat.
 * @param {Rectangle} box
 * @returns {Curl}
 */
export function noCurl(box) {
  return { box, foot: [0, 0], upright: true, parts: [0, 0] };
}

/**
 * Return how far a point is aside for a millimetre of the first part, mm, and its place along an edge, -1 ... 1: as much
 * more for the second part.
 * @param {Curl} curl
 * @param {number} x
 * @param {number} y
 * @returns {[number, number, number]}
 */
export function asideAt({ box: [left, bottom, right, top], foot, upright }, x, y) {
  const [width, height] = [(right - left) / 2, (top - bottom) / 2];
  const along = upright ? (x - left - width) / width : (y - bottom - height) / height;
  const rise = (1 - along * along) / Math.hypot(width, height);
  return [rise * (x - foot[0]), rise * (y - foot[1]), along];
}

/**
 * Return on which place of the plane through the corners a point of the sheet is seen, mm.
 * @param {Curl} curl
 * @param {number} x
 * @param {number} y
 * @returns {Spot}
 */
export function risenSpot(curl, x, y) {
  const [middle, more] = curl.parts;
  if (middle === 0 && more === 0) return [x, y];
  const [dx, dy, along] = asideAt(curl, x, y);
  const part = middle + more * along;
  return [x + part * dx, y + part * dy];
}

/**
 * Return which point of the sheet is seen on a place of the plane through its corners, mm.
 * @param {Curl} curl
 * @param {number} x
 * @param {number} y
 * @returns {Spot}
 */
export function loweredSpot(curl, x, y) {
  let [fx, fy] = [x, y];
  for (let turn = 0; turn < TURNS_OF_CURL; turn += 1) {
    const [sx, sy] = risenSpot(curl, fx, fy);
    [fx, fy] = [x - (sx - fx), y - (sy - fy)];
  }
  return [fx, fy];
}

/**
 * Return above which point of the sheet, mm, the camera stands: dots are square, the sheet's ways at right angles and
 * alike; where that tells little the camera is a usual one.
 * @param {number[]} matrix
 * @param {Lens} lens
 * @param {Seeking} how
 * @returns {Spot}
 */
export function footOf(matrix, lens, { usual, doubt, shortest, longest }) {
  const [a = 0, b = 0, c = 0, d = 0, e = 0, f = 0, g = 0, h = 0, i = 0] = matrix;
  const { x, y, radius } = lens;
  const across = [(a - x * g) / radius, (d - y * g) / radius];
  const up = [(b - x * h) / radius, (e - y * h) / radius];
  const far = [(c - x * i) / radius, (f - y * i) / radius];
  const [wide, high] = [dot(across, across), dot(up, up)];
  const size = (wide + high) / 2;
  const skew = dot(across, up) / size;
  const apart = (wide - high) / 2 / size;
  const deep = skew * g * h + (apart * (g * g - h * h)) / 2;
  const due = 1 / (usual * usual);
  const found = (doubt * due - deep / size) / (doubt + skew * skew + apart * apart);
  const square = Math.min(Math.max(found, due * shortest), due * longest);
  return [
    -(square * dot(across, far) + g * i) / (square * wide + g * g),
    -(square * dot(up, far) + h * i) / (square * high + h * h),
  ];
}

/**
 * @param {number[]} one
 * @param {number[]} other
 */
function dot([ax = 0, ay = 0], [bx = 0, by = 0]) {
  return ax * bx + ay * by;
}

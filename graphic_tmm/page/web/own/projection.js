/**
 * @typedef {[number, number]} Spot across and up the sheet, mm; or across and down a photograph, px
 * @typedef {[number, number, number, number]} Rectangle left, bottom, right, top, mm
 */

/** No side of a frame in a photograph is shorter, nor any corner nearer to the diagonal, px. */
const SHORTEST_SIDE = 20;
const DIAGONALS = [
  [-1, -1],
  [1, -1],
  [1, 1],
  [-1, 1],
];

/**
 * Return the corners of a rectangle: lower left, lower right, upper right, upper left.
 * @param {Rectangle} box
 * @returns {Spot[]}
 */
export function verticesOf([left, bottom, right, top]) {
  return [
    [left, bottom],
    [right, bottom],
    [right, top],
    [left, top],
  ];
}

/**
 * Return four corners, given in any order, in the order of `verticesOf` as the photograph is seen; null if they make
 * no convex quadrilateral. Of the four turns the one nearest to upright is taken.
 * @param {Spot[]} given
 * @returns {Spot[] | null}
 */
export function orderedCorners(given) {
  const [mx, my] = [0, 1].map((k) => given.reduce((sum, one) => sum + (one[k] ?? NaN), 0) / 4);
  /** @type {Spot[]} */
  const rays = given.map(([x, y]) => [x - (mx ?? 0), (my ?? 0) - y]);
  const turn = [...given.keys()].sort((a, b) => angleOf(rays[a]) - angleOf(rays[b]));
  const upright = DIAGONALS.map((_, k) =>
    DIAGONALS.reduce((sum, [dx = 0, dy = 0], j) => {
      const [x, y] = rays[turn[(j + k) % 4] ?? 0] ?? [0, 0];
      return sum + x * dx + y * dy;
    }, 0),
  );
  const first = upright.indexOf(Math.max(...upright));
  const ring = DIAGONALS.map((_, j) => given[turn[(j + first) % 4] ?? 0] ?? /** @type {Spot} */ ([NaN, NaN]));
  return given.length === 4 && ring.every((_, k) => convexAt(ring, k)) ? ring : null;
}

/** @param {Spot | undefined} ray */
function angleOf(ray) {
  return Math.atan2(ray?.[1] ?? 0, ray?.[0] ?? 0);
}

/**
 * Whether a corner's side is long enough and the next corner far enough outside the diagonal behind it.
 * @param {Spot[]} ring y downward
 * @param {number} k
 */
function convexAt(ring, k) {
  const [a, b, c] = [0, 1, 2].map((n) => /** @type {Spot} */ (ring[(k + n) % 4]));
  if (a === undefined || b === undefined || c === undefined) return false;
  const [sx, sy, dx, dy] = [b[0] - a[0], b[1] - a[1], c[0] - a[0], c[1] - a[1]];
  const high = -(sx * dy - sy * dx) / Math.max(Math.hypot(dx, dy), 1);
  return Math.hypot(sx, sy) > SHORTEST_SIDE && high > SHORTEST_SIDE;
}

/**
 * Return the projection (rows of three, 9 numbers) of the sheet, mm, into the photograph of a pinhole, px: exact at four
 * corners, which are seen where `corners` says. Its third coordinate is positive on this side of the horizon.
 * @param {Rectangle} box
 * @param {Spot[]} corners
 * @returns {number[]}
 */
export function homographyOf([left, bottom, right, top], corners) {
  const [one, two, three, four] = /** @type {[Spot, Spot, Spot, Spot]} */ (corners);
  const [ex, ey] = [one[0] - two[0] + three[0] - four[0], one[1] - two[1] + three[1] - four[1]];
  const [rx, ry] = [two[0] - three[0], two[1] - three[1]];
  const [lx, ly] = [four[0] - three[0], four[1] - three[1]];
  const whole = rx * ly - ry * lx;
  const [g, h] = [(ex * ly - ey * lx) / whole, (rx * ey - ry * ex) / whole];
  const square = [
    two[0] - one[0] + g * two[0],
    four[0] - one[0] + h * four[0],
    one[0],
    two[1] - one[1] + g * two[1],
    four[1] - one[1] + h * four[1],
    one[1],
    g,
    h,
    1,
  ];
  const [width, height] = [right - left, top - bottom];
  return product(square, [1 / width, 0, -left / width, 0, 1 / height, -bottom / height, 0, 0, 1]);
}

/**
 * @param {number[]} a
 * @param {number[]} b
 */
function product(a, b) {
  return a.map((_, n) => [0, 1, 2].reduce((sum, k) => sum + entry(a, 3 * Math.floor(n / 3) + k) * entry(b, 3 * k + (n % 3)), 0));
}

/**
 * @param {number[]} matrix
 * @param {number} n
 */
function entry(matrix, n) {
  return matrix[n] ?? NaN;
}

/**
 * Return the projection back.
 * @param {number[]} matrix
 * @returns {number[]}
 */
export function inverseOf(matrix) {
  const [a = 0, b = 0, c = 0, d = 0, e = 0, f = 0, g = 0, h = 0, i = 0] = matrix;
  const whole = a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g);
  const parts = [
    e * i - f * h,
    c * h - b * i,
    b * f - c * e,
    f * g - d * i,
    a * i - c * g,
    c * d - a * f,
    d * h - e * g,
    b * g - a * h,
    a * e - b * d,
  ];
  return parts.map((one) => one / whole);
}

/**
 * Return where a point goes; NaN on and beyond the horizon.
 * @param {number[]} m
 * @param {number} x
 * @param {number} y
 * @returns {Spot}
 */
export function projected(m, x, y) {
  const w = entry(m, 6) * x + entry(m, 7) * y + entry(m, 8);
  if (!(w > 0)) return [NaN, NaN];
  return [(entry(m, 0) * x + entry(m, 1) * y + entry(m, 2)) / w, (entry(m, 3) * x + entry(m, 4) * y + entry(m, 5)) / w];
}

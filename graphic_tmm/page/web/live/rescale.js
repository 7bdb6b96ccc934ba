/**
 * @typedef {import("../types.js").Complex} Complex
 * @typedef {import("../types.js").Drawn} Drawn
 * @typedef {import("../types.js").FreeScale} FreeScale
 * @typedef {import("../types.js").ScalesData} ScalesData
 * @typedef {{rows: Complex[][], n: number[], by: Drawn[], mu: number, of: ScalesData}} Reached what is drawn to a scale factor,
 *   in SI, position by position; the rule's numbers; what it hangs on, as it is now; the scale factor that it is drawn to
 */

/** A standard value that is so little too small will do; what is apart by no more lies in one place. As in Python. */
const NEARLY = 1e-12;
const ROUNDED = 1e-9;

/**
 * Choose the free scale factors by what is drawn now, as their sheet does: page/live/scales.py says by which rules.
 * @param {ScalesData} of
 * @param {(k: number) => (Drawn | undefined)[]} marks at an angle (index)
 * @param {number[]} positions indices of the positions of the sheet
 * @param {Set<number>} kept slots of those that somebody has changed himself
 * @returns {Map<number, number>} by slots
 */
export function chosenScales(of, marks, positions, kept) {
  const free = of.free.filter((one) => !kept.has(one.mu));
  const rows = free.map(() => /** @type {Complex[][]} */ ([]));
  /** @type {(Drawn | undefined)[]} */
  let first = [];
  for (const k of [...new Set([...positions, ...free.flatMap((one) => one.at ?? [])])]) {
    const M = marks(k);
    if (first.length === 0) first = [...M];
    free.forEach((one, n) => {
      if ((one.at ?? positions).includes(k)) rows[n]?.push(one.of.flatMap((slot) => inUnits(M[slot], worth(one, M))));
    });
  }
  /** @type {Map<number, number>} */
  const found = new Map();
  free.forEach((one, n) => {
    const by = (one.by ?? []).map((slot) => found.get(slot) ?? first[slot] ?? NaN);
    const mu = RULES[one.rule]?.({ rows: rows[n] ?? [], n: one.n, by, mu: Number(first[one.mu]), of }) ?? NaN;
    if (mu > 0 && Number.isFinite(mu)) found.set(one.mu, mu);
  });
  return found;
}

/**
 * Return what a millimetre stands for; on a lever, which is so many times as large as its plan, that of the plan.
 * @param {FreeScale} one
 * @param {(Drawn | undefined)[]} M
 */
function worth(one, M) {
  const mu = Number(M[one.mu]);
  return one.rule === "lever" ? Number(M[one.by?.[0] ?? -1]) / mu : mu;
}

/**
 * @param {Drawn | undefined} mark
 * @param {number} mu
 * @returns {Complex[]} nothing of what is not there
 */
function inUnits(mark, mu) {
  if (mark === undefined || typeof mark === "number" || !("re" in mark)) return [];
  const { re, im } = mark;
  return Number.isFinite(re) && Number.isFinite(im) ? [{ re: re * mu, im: im * mu }] : [];
}

/** By what each rule goes; in Python it is `scales` of a chapter. @type {Record<string, (of: Reached) => number>} */
const RULES = {
  plan({ rows, n, by, mu, of }) {
    const [room = 1, most = 1, crank = 0, known = 0, flat = 1, ring = 0] = n;
    const [from, to] = by.flatMap((mark) => inUnits(mark, mu));
    const arm = howFar(from, to) || known;
    const around = ring === 1 ? [-arm, arm].flatMap((r) => [...shifted(from, r, 0), ...shifted(from, 0, r)]) : [];
    const far = extent([...rows.flat(), ...around], flat);
    const own = standardLength(far, room, of);
    if (arm / own >= crank) return own;
    const larger = standardLength(far, most, of);
    return of.lengths.findLast((one) => larger <= one && one < own && arm / one >= crank) ?? larger;
  },
  vectors({ rows, n: [room = 1, share = 1, times = 1], of }) {
    const sizes = rows.filter((row) => row.length > 0).map((row) => Math.max(...row.map((z) => Math.hypot(z.re, z.im))));
    sizes.sort((a, b) => a - b);
    const most = sizes[Math.ceil(share * sizes.length) - 1] ?? 0;
    const last = sizes.at(-1) ?? 0;
    return standard(0 < times * most && times * most < last ? most : last, room, of);
  },
  segment: ({ rows, n: [mm = 1] }) => howFar(rows[0]?.[0], rows[0]?.[1]) / mm,
  turning: ({ by: [mu, omega] }) => Number(mu) * Math.abs(Number(omega)),
  same: ({ by: [mu] }) => Number(mu),
  group({ rows, n: [room = 1, most = 1], by: [plan], of }) {
    const far = spread(rows);
    const larger = of.lengths.findLast((one) => one <= Number(plan) * (1 + ROUNDED)) ?? Number(plan);
    const wide = far / Math.max(Math.min(standardLength(far, room, of), larger), standardLength(far, most, of));
    return standardLength(far, wide * (1 + ROUNDED), of);
  },
  link({ rows, n: [room = 1, short = 0], by: [plan, group], of }) {
    const far = spread(rows);
    const wide = Math.max(Math.min(room, Math.max(far / Number(group), short)), far / Number(plan));
    return standardLength(far, wide * (1 + ROUNDED), of);
  },
  polygon({ rows, n: [room = 1, times = 1], of }) {
    const sizes = rows.map((row) => extent([{ re: 0, im: 0 }, ...row])).filter((far) => far > 0);
    sizes.sort((a, b) => b - a);
    /** @type {number[][]} */
    const alike = [];
    for (const far of sizes) {
      if (far * times < (alike.at(-1)?.[0] ?? Infinity)) alike.push([]);
      alike.at(-1)?.push(far);
    }
    alike.sort((a, b) => b.length - a.length);
    return standard(alike[0]?.[0] ?? 0, room, of);
  },
  lever({ rows, n: [room = 1, same = 1], by: [plan], of }) {
    const far = extent([{ re: 0, im: 0 }, ...rows.flat()]);
    return of.ratios.find((k) => k * far <= (k === 1 ? same : 1) * room * Number(plan)) ?? of.ratios.at(-1) ?? 1;
  },
};

/**
 * How far points reach along the axis of their longer reach; `wide`: what their width counts against their height.
 * @param {Complex[]} points
 * @param {number} wide
 */
function extent(points, wide = 1) {
  if (points.length === 0) return 0;
  const [xs, ys] = [points.map((z) => z.re), points.map((z) => z.im)];
  return Math.max(wide * (Math.max(...xs) - Math.min(...xs)), Math.max(...ys) - Math.min(...ys));
}

/**
 * How far points reach in one position; 0 where they are one point.
 * @param {Complex[][]} rows
 */
function spread(rows) {
  const far = Math.max(0, ...rows.map((row) => extent(row)));
  return far > ROUNDED * Math.max(0, ...rows.flat().map((z) => Math.hypot(z.re, z.im))) ? far : 0;
}

/**
 * The least scale factor of the standard decades at which so much takes no more room, mm.
 * @param {number} largest
 * @param {number} room
 * @param {ScalesData} of
 */
function standard(largest, room, { mantissas }) {
  const least = largest / room;
  if (!(least > 0 && Number.isFinite(least))) return NaN;
  const decade = Math.floor(Math.log10(least)) - 1;
  const tried = [0, 1, 2, 3].flatMap((d) => mantissas.map((m) => Number(`${m}e${decade + d}`)));
  return tried.find((mu) => mu >= least * (1 - NEARLY)) ?? NaN;
}

/**
 * The same of lengths: of the standard scales, beyond these of the decades.
 * @param {number} largest
 * @param {number} room
 * @param {ScalesData} of
 */
function standardLength(largest, room, of) {
  const least = largest / room;
  const [first = 0, last = 0] = [of.lengths[0], of.lengths.at(-1)];
  if (!(first <= least * (1 + NEARLY)) || least > last) return standard(largest, room, of);
  return of.lengths.find((mu) => mu >= least * (1 - NEARLY)) ?? NaN;
}

/**
 * How far two points are apart; not a number where one is not there.
 * @param {Complex | undefined} a
 * @param {Complex | undefined} b
 */
function howFar(a, b) {
  return a === undefined || b === undefined ? NaN : Math.hypot(b.re - a.re, b.im - a.im);
}

/**
 * @param {Complex | undefined} a
 * @param {number} x
 * @param {number} y
 */
function shifted(a, x, y) {
  return a === undefined ? [] : [{ re: a.re + x, im: a.im + y }];
}

/**
 * Arrays as numpy has them: nested ones, whose last axis is innermost. What they hold are numbers, points of the plane,
 * truths. The operations that work across positions are written for them (board/script_rows.py).
 * @typedef {any} Nested
 * @typedef {number | null} End
 * @typedef {number | boolean[] | number[] | End[] | "..." | null | {from: End, to: End}} Index
 */

/**
 * Return how many axes something has.
 * @param {Nested} x
 */
export function depth(x) {
  let found = 0;
  for (let one = x; Array.isArray(one); one = one[0]) found++;
  return found;
}

/**
 * @param {Nested} x
 * @returns {number[]}
 */
export function shape(x) {
  return Array.isArray(x) ? [x.length, ...shape(x[0])] : [];
}

/**
 * Let an operation on one number work on arrays.
 * @param {(x: any) => any} one
 * @returns {(x: Nested) => Nested}
 */
export function ofEachValue(one) {
  /** @type {(x: Nested) => Nested} */
  const own = (x) => (Array.isArray(x) ? x.map(own) : one(x));
  return own;
}

/**
 * Let an operation on two numbers work on arrays, an axis of one stretched where the other has more.
 * @param {(a: any, b: any) => any} one
 * @returns {(a: Nested, b: Nested) => Nested}
 */
export function ofTwoArrays(one) {
  const inStep = (/** @type {any[]} */ a, /** @type {any[]} */ b) => {
    const found = new Array(a.length === 1 ? b.length : a.length);
    const [by, on] = [a.length === 1 ? 0 : 1, b.length === 1 ? 0 : 1];
    for (let k = 0; k < found.length; k++) found[k] = one(a[by * k], b[on * k]);
    return found;
  };
  const own = (/** @type {Nested} */ a, /** @type {Nested} */ b, /** @type {number} */ p, /** @type {number} */ q) => {
    if (p === 0 && q === 0) return one(a, b);
    if (p === 1 && q === 1) return inStep(a, b);
    if (p > q) return a.map((/** @type {Nested} */ x) => own(x, b, p - 1, q));
    if (q > p) return b.map((/** @type {Nested} */ x) => own(a, x, p, q - 1));
    const found = new Array(a.length === 1 ? b.length : a.length);
    for (let k = 0; k < found.length; k++) found[k] = own(a[a.length === 1 ? 0 : k], b[b.length === 1 ? 0 : k], p - 1, q - 1);
    return found;
  };
  return (a, b) => own(a, b, depth(a), depth(b));
}

/**
 * Return the places along an axis that an index names.
 * @param {Index} index
 * @param {number} count
 * @returns {number[]}
 */
function indicesOf(index, count) {
  if (Array.isArray(index)) {
    if (typeof index[0] === "boolean") return index.flatMap((own, k) => (own ? [k] : []));
    return index.map((k) => wrapped(Number(k), count));
  }
  const { from, to } = /** @type {{from: End, to: End}} */ (index);
  const [first, end] = [from ?? 0, to ?? count].map((k) => Math.min(Math.max(k < 0 ? k + count : k, 0), count));
  return Array.from({ length: Math.max((end ?? 0) - (first ?? 0), 0) }, (_, k) => (first ?? 0) + k);
}

/**
 * @param {number} k
 * @param {number} count
 */
function wrapped(k, count) {
  return k < 0 ? k + count : k;
}

/** @type {{from: End, to: End}} */
const ALL_OF_IT = { from: null, to: null };

/**
 * Return an index with slices for what "..." leaves out.
 * @param {Nested} x
 * @param {Index[]} index
 * @returns {Index[]}
 */
function spelled(x, index) {
  const gap = index.indexOf("...");
  if (gap < 0) return index;
  const rest = depth(x) - index.filter((one) => one !== null && one !== "...").length;
  return [...index.slice(0, gap), ...new Array(rest).fill(ALL_OF_IT), ...index.slice(gap + 1)];
}

/**
 * Return what stands at an index; a row that whole numbers name is the row itself.
 * @param {Nested} x
 * @param {...Index} index null for a new axis
 * @returns {Nested}
 */
export function at(x, ...index) {
  return index.length === 0 ? x : among(x, spelled(x, index));
}

/**
 * @param {Nested} x
 * @param {Index[]} index
 * @returns {Nested}
 */
function among(x, [first, ...rest]) {
  if (first === undefined) return x;
  if (first === null) return [among(x, rest)];
  if (typeof first === "number") return among(x[wrapped(first, x.length)], rest);
  if (typeof first === "object" && "from" in first) {
    const part = x.slice(first.from ?? 0, first.to ?? x.length);
    return rest.length === 0 ? part : part.map((/** @type {Nested} */ own) => among(own, rest));
  }
  return indicesOf(first, x.length).map((k) => among(x[k], rest));
}

/**
 * Enter values at an index.
 * @param {Nested} x
 * @param {Index[]} index
 * @param {Nested} value
 */
export function enterValues(x, index, value) {
  const [first, ...rest] = spelled(x, index);
  if (typeof first === "number") {
    const k = wrapped(first, x.length);
    if (depth(x) === 1) x[k] = value;
    else enterValues(x[k], rest.length === 0 ? [ALL_OF_IT] : rest, value);
    return;
  }
  const own = depth(value) >= depth(x) - rest.filter((one) => typeof one === "number").length;
  indicesOf(first ?? ALL_OF_IT, x.length).forEach((k, n) => {
    const now = own ? value[value.length === 1 ? 0 : n] : value;
    if (depth(x) === 1) x[k] = now;
    else enterValues(x[k], rest.length === 0 ? [ALL_OF_IT] : rest, now);
  });
}

/**
 * Return what a function makes of each row along an axis: a number, or another row.
 * @param {Nested} x
 * @param {number} axis
 * @param {(row: any[]) => any} made
 * @returns {Nested}
 */
export function along(x, axis, made) {
  const own = axis < 0 ? axis + depth(x) : axis;
  if (own > 0) return x.map((/** @type {Nested} */ row) => along(row, own - 1, made));
  if (depth(x) === 1) return made(x);
  return x[0].map((/** @type {Nested} */ _, /** @type {number} */ k) => along(x.map((/** @type {Nested} */ row) => row[k]), 0, made));
}

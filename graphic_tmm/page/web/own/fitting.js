/**
 * Return what is left of a row beside its weighted straight line of least squares.
 * @param {Float64Array} along
 * @param {Float64Array} across
 * @param {Float64Array} weights
 */
export function leftOfLine(along, across, weights) {
  const line = polynomialFit(along, across, weights, 1);
  return across.map((one, k) => one - valueOf(line, along[k] ?? 0));
}

/**
 * Return the coefficients, the lowest first, of the polynomial of weighted least squares: by orthogonal columns, so
 * that the powers need not be apart.
 * @param {Float64Array} x
 * @param {Float64Array} y
 * @param {Float64Array} weights
 * @param {number} degree
 * @returns {number[]}
 */
export function polynomialFit(x, y, weights, degree) {
  /** @type {Float64Array[]} */
  const columns = [];
  /** The powers that a column is made of. @type {number[][]} */
  const made = [];
  const found = new Array(degree + 1).fill(0);
  const left = Float64Array.from(y);
  for (let n = 0; n <= degree; n += 1) {
    const column = x.map((one) => one ** n);
    const powers = found.map((_, k) => (k === n ? 1 : 0));
    // twice: what the first time leaves by rounding
    for (let again = 0; again < 2; again += 1) {
      columns.forEach((other, k) => subtract(column, powers, other, made[k] ?? [], weights));
    }
    const square = weighted(column, column, weights);
    if (!(square > 0)) continue;
    const share = weighted(column, left, weights) / square;
    column.forEach((one, k) => (left[k] = (left[k] ?? 0) - share * one));
    powers.forEach((one, k) => (found[k] += share * one));
    columns.push(column);
    made.push(powers);
  }
  return found;
}

/**
 * @param {Float64Array} column
 * @param {number[]} powers
 * @param {Float64Array} other
 * @param {number[]} made
 * @param {Float64Array} weights
 */
function subtract(column, powers, other, made, weights) {
  const share = weighted(column, other, weights) / weighted(other, other, weights);
  other.forEach((one, k) => (column[k] = (column[k] ?? 0) - share * one));
  made.forEach((one, k) => (powers[k] = (powers[k] ?? 0) - share * one));
}

/**
 * @param {Float64Array} a
 * @param {Float64Array} b
 * @param {Float64Array} weights
 */
function weighted(a, b, weights) {
  let sum = 0;
  for (let k = 0; k < weights.length; k += 1) sum += (weights[k] ?? 0) * (a[k] ?? 0) * (b[k] ?? 0);
  return sum;
}

/**
 * Return the value of a polynomial.
 * @param {number[]} coefficients the lowest first
 * @param {number} x
 */
export function valueOf(coefficients, x) {
  return coefficients.reduceRight((sum, one) => sum * x + one, 0);
}

/**
 * Return the middle of some numbers; of two the mean.
 * @param {number[] | Float64Array} numbers
 */
export function medianOf(numbers) {
  const sorted = Float64Array.from(numbers).sort();
  const half = sorted.length >> 1;
  return sorted.length % 2 === 1 ? (sorted[half] ?? NaN) : ((sorted[half - 1] ?? NaN) + (sorted[half] ?? NaN)) / 2;
}

/** So near to a power of ten a figure is off by nothing but its point. */
const SAME_DIGITS = 0.02;

/**
 * Return what is plainly wrong with a figure: its sense, its point; null where neither is.
 * @param {number} found
 * @param {number} due
 * @returns {{key: "other sense" | "times more" | "times less", times: number} | null}
 */
export function plainSlip(found, due) {
  const ratio = found / due;
  if (!Number.isFinite(ratio) || ratio === 0) return null;
  const power = Math.round(Math.log10(Math.abs(ratio)));
  if (Math.abs(Math.abs(ratio) / 10 ** power - 1) > SAME_DIGITS) return null;
  if (power !== 0) return { key: power > 0 ? "times more" : "times less", times: 10 ** Math.abs(power) };
  return ratio < 0 ? { key: "other sense", times: 1 } : null;
}

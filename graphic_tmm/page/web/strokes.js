/**
 * Return a row or a number as a function of the angle (index), mm.
 * @param {number[]} told a number of thousandths, or a row and a distance
 * @param {Float32Array[]} rows
 * @returns {(k: number) => number}
 */
export function placeOf(told, rows) {
  const [first = 0, by] = told;
  if (by === undefined) return () => first / 1000;
  const row = rows[first] ?? new Float32Array(1);
  return (k) => (row[k] ?? 0) + by / 1000;
}

/**
 * Return the data of a path through places, y upward; a bulge bends what goes to the next one, as in DXF.
 * @param {number[]} at x, y, x, y …
 * @param {number[] | null} bulges
 * @param {boolean} closed
 */
export function pathOf(at, bulges, closed) {
  let text = `M${told(at[0])} ${told(-(at[1] ?? 0))}`;
  const count = at.length / 2;
  const last = closed && bulges !== null ? count : count - 1;
  for (let n = 0; n < last; n++) {
    const m = (n + 1) % count;
    const [x = 0, y = 0, u = 0, v = 0] = [at[2 * n], at[2 * n + 1], at[2 * m], at[2 * m + 1]];
    const bulge = bulges?.[n] ?? 0;
    text += bulge === 0 ? `L${told(u)} ${told(-v)}` : arc(x, y, u, v, bulge);
  }
  return closed ? `${text}Z` : text;
}

/**
 * @param {number} x
 * @param {number} y
 * @param {number} u
 * @param {number} v
 * @param {number} bulge
 */
function arc(x, y, u, v, bulge) {
  const chord = Math.hypot(u - x, v - y);
  const radius = told((chord * (1 + bulge * bulge)) / (4 * Math.abs(bulge)));
  const side = (1 - bulge * bulge) / (4 * bulge);
  const centre = [(x + u) / 2 - (v - y) * side, (y + v) / 2 + (u - x) * side];
  const whole = 4 * Math.atan(bulge);
  const pieces = Math.max(1, Math.ceil(Math.abs(whole) / (Math.PI / 2) - 1e-9));
  const start = Math.atan2(y - (centre[1] ?? 0), x - (centre[0] ?? 0));
  const long = (chord * (1 + bulge * bulge)) / (4 * Math.abs(bulge));
  let text = "";
  for (let k = 1; k <= pieces; k++) {
    const turn = start + (whole * k) / pieces;
    const end =
      k === pieces ? [u, v] : [(centre[0] ?? 0) + long * Math.cos(turn), (centre[1] ?? 0) + long * Math.sin(turn)];
    text += `A${radius} ${radius} 0 0 ${bulge > 0 ? 0 : 1} ${told(end[0])} ${told(-(end[1] ?? 0))}`;
  }
  return text;
}

/**
 * A length in hundredths of a millimetre at most.
 * @param {number | undefined} value
 */
export function told(value) {
  return Math.round((value ?? 0) * 100) / 100;
}

/** A figure as people write it: a comma or a point, a minus or a hyphen, spaces about it. */
const FIGURE = /^[+-]?(?:\d+(?:[.,]\d*)?|[.,]\d+)$/;

/**
 * Return the number that was typed; NaN if it is none.
 * @param {string} text
 */
export function numberOf(text) {
  const bare = bareOf(text);
  return FIGURE.test(bare) ? Number(bare.replace(",", ".")) : NaN;
}

/**
 * Return a figure as it was typed, without spaces, in a language's decimal sign.
 * @param {string} text
 * @param {string} decimal
 */
export function cellOf(text, decimal) {
  return bareOf(text).replace(/[.,]/, decimal);
}

/**
 * Return a number to some decimals as the page writes numbers.
 * @param {number} value
 * @param {number} places
 * @param {string} decimal
 */
export function shownNumber(value, places, decimal) {
  const text = Math.abs(value).toFixed(places).replace(".", decimal);
  return value < 0 && /[1-9]/.test(text) ? `−${text}` : text;
}

/** @param {string} text */
function bareOf(text) {
  return text.replace(/[\s\u00a0\u202f]/g, "").replace(/[−–]/, "-");
}

/**
 * Return half a unit of the last digit of a figure as it was typed.
 * @param {string} text
 */
export function halfUnit(text) {
  const decimals = /[.,](\d*)$/.exec(bareOf(text))?.[1]?.length ?? 0;
  return 0.5 * 10 ** -decimals;
}

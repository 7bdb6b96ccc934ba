/** Russian letters that look as Latin ones do: who types one means the letter that he sees on the task. */
const ALIKE = new Map([..."АВЕКМНОРСТУХ"].map((one, k) => [one, "ABEKMHOPCTYX"[k] ?? one]));

/**
 * Return the letter of a pin that a key means, in any layout; "" if it means none.
 * @param {KeyboardEvent} event
 */
export function letterOf({ key, code }) {
  const typed = key.toUpperCase();
  if (/^[A-Z]$/.test(typed)) return typed;
  if (typed.length !== 1 || !/^\p{L}$/u.test(typed)) return "";
  const printed = code.startsWith("Key") ? code.slice(3) : "";
  return ALIKE.get(typed) ?? printed;
}

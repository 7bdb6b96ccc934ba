/** Letters of other alphabets that look as Latin ones do: who types one means the letter that he sees on the task. */
const ALIKE = new Map([..."АВЕКМНОРСТУХаеорсухΑΒΕΖΗΙΚΜΝΟΡΤΥΧο"].map((one, k) => [one, "ABEKMHOPCTYXaeopcyxABEZHIKMNOPTYXo"[k] ?? one]));

/**
 * Return a letter with Latin ones for those that look so.
 * @param {string} letter
 */
function latin(letter) {
  return [...letter].map((one) => ALIKE.get(one) ?? one).join("");
}

/**
 * Return the letter that looks as another does on a plan, which writes small ones; undefined if none does.
 * @param {Iterable<string>} letters
 * @param {string} letter
 */
export function alike(letters, letter) {
  const looks = (/** @type {string} */ one) => latin(one).toLowerCase();
  return [...letters].find((one) => looks(one) === looks(letter));
}

/**
 * Return the letter that is meant by what was typed for a pin: the one that a pin has which looks so, else in Latin.
 * @param {Iterable<string>} letters of other pins
 * @param {string} typed
 */
export function letterMeant(letters, typed) {
  return alike(letters, typed) ?? latin(typed);
}

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

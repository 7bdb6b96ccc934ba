/**
 * @typedef {import("../types.js").SchemeAct} SchemeAct
 * @typedef {import("../types.js").SchemeAnswer} SchemeAnswer
 */

/**
 * Whether an act on a scheme may be done on what another has made of its file meanwhile: a value where that value is
 * the same still, what was drawn where the mechanism is.
 * @param {SchemeAct} act
 * @param {SchemeAnswer | null} was what was seen when it was done
 * @param {SchemeAnswer} now
 */
export function agrees(act, was, now) {
  if (was === null || now.text === null || act.back) return false;
  const drawn = act.sketch || Object.keys(act.numbers ?? {}).length > 0;
  if (drawn && JSON.stringify(was.sketch) !== JSON.stringify(now.sketch)) return false;
  if (act.section) return true;
  const value = (/** @type {SchemeAnswer} */ { fields }, /** @type {string} */ key) => fields.find((one) => one.key === key)?.text;
  return Object.keys(act.typed ?? {}).every((key) => value(was, key) !== undefined && value(was, key) === value(now, key));
}

import * as changes from "./changes.js";
import { letterMeant } from "./letters.js";
import { frameOf, sizeOf } from "./sketch.js";

/**
 * What is done to the chosen pin or link, and to values, from keys and from the panel.
 *
 * @typedef {import("./editor.js").Editor} Editor
 */

/**
 * Take away what is chosen.
 * @param {Editor} editor
 */
export function removeChosen(editor) {
  const { letter, number } = editor.chosen;
  if (letter !== undefined) editor.act(changes.withoutPin(editor.sketch, letter), {});
  else if (number !== undefined) editor.act(changes.withoutLink(editor.sketch, number), {});
}

/**
 * Call a pin by another letter.
 * @param {Editor} editor
 * @param {string} from
 * @param {string} typed
 */
export function renameLetter(editor, from, typed) {
  const to = letterMeant(Object.keys(editor.sketch.places).filter((one) => one !== from), typed);
  const made = changes.relettered(editor.sketch, from, to);
  if (made !== null) editor.act(made, { letter: to }, { letters: { [from]: to } });
}

/**
 * Give a link another number.
 * @param {Editor} editor
 * @param {number} from
 * @param {number} to
 */
export function renameLink(editor, from, to) {
  if (from === to || to === frameOf(editor.sketch).number || !(Number.isInteger(to) && to > 0 && to < 1000)) return;
  editor.act(changes.renumbered(editor.sketch, from, to), { number: to }, { numbers: { [from]: to } });
}

/**
 * Type a value of the scene; the first length is the scale of all. Return why it was refused.
 * @param {Editor} editor
 * @param {string} key
 * @param {string} value
 * @param {boolean} long whether it is a length of the mechanism
 */
export function typeValue(editor, key, value, long) {
  let scale = false;
  let size = 1;
  const act = () => {
    scale = long && !editor.measured;
    size = sizeOf(editor.sketch);
    return { typed: { [key]: value }, scale, sketch: scale ? editor.sketch : null, at: editor.answer?.at ?? null };
  };
  return editor.ask(act, () => editor.history.keep(editor.moment), () => {
    if (!scale) return;
    editor.measured = true;
    enlarge(editor, sizeOf(editor.sketch) / size);
    const field = editor.answer?.fields.find((one) => one.key === key);
    if (field !== undefined) editor.tell(editor.say("scheme scaled", { length: field.label, text: field.text }));
  });
}

/**
 * Let the picture below be as much larger as the mechanism is, and both look as large as before.
 * @param {Editor} editor
 * @param {number} by
 */
function enlarge(editor, by) {
  editor.picture.scale(by);
  editor.paper.enlarged(by);
}

/**
 * Add a section with the values that were typed; return why it was refused.
 * @param {Editor} editor
 * @param {string} section
 * @param {Record<string, string>} typed
 */
export function addSection(editor, section, typed) {
  return editor.ask(() => ({ section, typed, at: editor.answer?.at ?? null }), () => editor.history.keep(editor.moment));
}

/**
 * Take the values that were changed in the page, as TOML; return why they were refused.
 * @param {Editor} editor
 * @param {string} own
 */
export function takeOwn(editor, own) {
  return editor.ask(() => ({ own, at: editor.answer?.at ?? null }), () => editor.history.keep(editor.moment));
}

/**
 * Take back the last act, when all are answered.
 * @param {Editor} editor
 */
export function takeBack(editor) {
  editor.queue = editor.queue.then(() => restore(editor, editor.history.back(editor.moment)));
}

/**
 * Do again what was taken back.
 * @param {Editor} editor
 */
export function doAgain(editor) {
  editor.queue = editor.queue.then(() => restore(editor, editor.history.forth(editor.moment)));
}

/**
 * @param {Editor} editor
 * @param {import("./editor.js").Moment | null} moment
 */
function restore(editor, moment) {
  if (moment === null) return;
  const before = editor.moment;
  const rescaled = moment.measured !== editor.measured && sizeOf(moment.sketch) / sizeOf(editor.sketch);
  if (rescaled) enlarge(editor, rescaled);
  editor.shift([moment.origin[0] - editor.origin[0], moment.origin[1] - editor.origin[1]]);
  Object.assign(editor, { sketch: moment.sketch, text: moment.text, answer: moment.answer, measured: moment.measured, chosen: {} });
  editor.changed();
  const whole = moment.answer !== null && moment.answer.text !== null;
  void editor.ask(() => (whole ? { at: moment.answer?.at ?? null, back: true } : { sketch: moment.sketch }), () => before);
}

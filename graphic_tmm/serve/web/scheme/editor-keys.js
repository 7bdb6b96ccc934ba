import { moved } from "./changes.js";
import { doAgain, removeChosen, renameLetter, renameLink, takeBack } from "./editor-acts.js";
import { letterOf } from "./letters.js";
import { placeOf } from "./sketch.js";

/** @typedef {import("./editor.js").Editor} Editor */

/** A figure typed so soon behind a letter belongs to it, ms. */
const TOGETHER = 1500;

/** With Ctrl. @type {Record<string, (editor: Editor, event: KeyboardEvent) => void>} */
const WITH_CONTROL = {
  KeyZ: (editor, event) => (event.shiftKey ? doAgain(editor) : takeBack(editor)),
  KeyY: (editor) => doAgain(editor),
  ArrowLeft: nudge,
  ArrowRight: nudge,
  ArrowUp: nudge,
  ArrowDown: nudge,
};
/** Alone. @type {Record<string, (editor: Editor) => void>} */
const ALONE = {
  Delete: removeChosen,
  Backspace: removeChosen,
  " ": (editor) => editor.turning.toggle(),
};

/**
 * @param {Editor} editor
 * @param {KeyboardEvent} event
 * @returns {boolean} whether it was for the editor
 */
export function keyed(editor, event) {
  const control = event.ctrlKey || event.metaKey;
  const act = control ? WITH_CONTROL[event.code] : ALONE[event.key];
  act?.(editor, event);
  return act !== undefined || (!control && named(editor, event));
}

/**
 * Name the chosen pin by a letter, and figures soon behind it; number the chosen link.
 * @param {Editor} editor
 * @param {KeyboardEvent} event
 */
function named(editor, event) {
  const { letter, number } = editor.chosen;
  const soon = event.timeStamp - editor.typedAt < TOGETHER;
  const figure = /^\d$/.test(event.key) ? Number(event.key) : null;
  const typed = letterOf(event);
  if (letter !== undefined && typed !== "") renameLetter(editor, letter, typed);
  else if (letter !== undefined && figure !== null && soon) renameLetter(editor, letter, `${letter}${figure}`);
  else if (number !== undefined && figure !== null) renameLink(editor, number, soon ? 10 * number + figure : figure);
  else return false;
  editor.typedAt = event.timeStamp;
  return true;
}

/**
 * Move the chosen pin by squares.
 * @param {Editor} editor
 * @param {KeyboardEvent} event
 */
function nudge(editor, event) {
  const { letter } = editor.chosen;
  const by = editor.paper.view.square * (event.shiftKey ? 10 : 1);
  const [x, y] = { ArrowLeft: [-by, 0], ArrowRight: [by, 0], ArrowUp: [0, by], ArrowDown: [0, -by] }[event.key] ?? [0, 0];
  if (letter === undefined || x === undefined || y === undefined) return;
  const place = placeOf(editor.sketch, letter);
  editor.act(moved(editor.sketch, letter, [place[0] + x, place[1] + y]));
}

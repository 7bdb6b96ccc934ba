import { boundsOf } from "./sketch.js";

/**
 * How a person looked at a scheme, and where its drive stood, kept for the next time in this tab: what is saved as a
 * scene lies then where it lay.
 *
 * @typedef {import("./editor.js").Editor} Editor
 * @typedef {{at: import("../types.js").SchemeAnswer["at"], scale: number, middle: import("./sketch.js").Place}} Seen middle: of the window, m
 */

/**
 * @param {Editor} editor
 * @param {string} place of the page by which it is kept
 */
export function keepSeen(editor, place = location.pathname) {
  const { view } = editor.paper;
  const middle = view.place([view.width / 2, view.height / 2]);
  try {
    sessionStorage.setItem(nameOf(place), JSON.stringify({ at: editor.answer?.at ?? null, scale: view.scale, middle }));
  } catch {
    // a browser may keep nothing
  }
}

/** @returns {Seen | null} what was kept of this page */
export function seenBefore() {
  try {
    return JSON.parse(sessionStorage.getItem(nameOf(location.pathname)) ?? "null");
  } catch {
    return null;
  }
}

/**
 * Look at the scheme as it was looked at; all of it, if it would not be seen so.
 * @param {Editor} editor
 * @param {Seen | null} seen
 */
export function lookAgain(editor, seen) {
  const { paper, sketch } = editor;
  const bounds = boundsOf(sketch);
  if (seen === null || bounds === null) return paper.fit();
  const { view } = paper;
  view.lie(seen.scale, seen.middle);
  const [left, low] = view.dots([bounds.left, bounds.low]);
  const [right, high] = view.dots([bounds.right, bounds.high]);
  if (left < 0 || high < 0 || right > view.width || low > view.height) return paper.fit();
  paper.draw();
}

/** @param {string} place */
function nameOf(place) {
  return `scheme seen ${place}`;
}

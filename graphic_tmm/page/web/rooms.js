import { crankRoom } from "./crank.js";
import { lectureRoom } from "./lecture.js";
import { playRoom } from "./play.js";
import { sheetRoom } from "./sheet.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./state.js").State} State
 * @typedef {(data: Data, state: State) => HTMLElement} Room
 */

/**
 * The ways of looking, in the order of their tabs; each is entered here, or by the enter.js of a folder that not
 * every page has, and nowhere else. A room makes its element, hears the state, shows what `place` says while
 * `place.tab` is its name (its element is seen by then), lets keys act by `listenToKeys(state, name, {…})`, tells
 * them in `KEYS` of help.js. Its tab is called by `data.words[name]`.
 * @type {Record<string, Room>}
 */
export const ROOMS = {
  play: playRoom,
  crank: crankRoom,
  sheets: sheetRoom,
  lecture: lectureRoom,
};

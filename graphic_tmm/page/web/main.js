import { crankRoom } from "./crank.js";
import { packedData } from "./data.js";
import { playRoom } from "./play.js";
import { letRun } from "./run.js";
import { State } from "./state.js";
import { fillTabs } from "./tabs.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {(data: Data, state: State) => HTMLElement} Room
 */

/**
 * The ways of looking, in the order of their tabs; each is entered here and nowhere else. A room makes its element
 * (with an id), hears the state, shows what `place` says while `place.tab` is its name, lets keys act by
 * `listenToKeys(state, name, {…})`. Its tab is called by `data.words[name]`.
 * @type {Record<string, Room>}
 */
const ROOMS = {
  play: playRoom,
  crank: crankRoom,
  sheets: () => /** @type {HTMLElement} */ (document.getElementById("sheets")),
};

const data = await packedData();
const there = Object.entries(ROOMS).filter(([name]) => name !== "crank" || data.crank !== undefined);
const state = new State(data.views, there.map(([name]) => name));
document.documentElement.classList.add("js");
const main = /** @type {HTMLElement} */ (document.getElementById("main"));
/** @type {Record<string, HTMLElement>} */
const rooms = Object.fromEntries(there.map(([name, room]) => [name, room(data, state)]));
for (const room of Object.values(rooms)) if (!room.isConnected) main.append(room);
const tabs = /** @type {HTMLElement} */ (document.getElementById("tabs"));
fillTabs(tabs, state, rooms, data.words);
letRun(state);
state.follow();
document.documentElement.classList.add("ready");

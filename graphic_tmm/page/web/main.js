import { packedData } from "./data.js";
import { turnAt } from "./dense.js";
import { helpButton, helpPanel } from "./help.js";
import { listenToKeys } from "./keys.js";
import { liveRegion } from "./live.js";
import { showPoster } from "./poster.js";
import { ROOMS } from "./rooms.js";
import { letRun } from "./run.js";
import { State } from "./state.js";
import { asPanel, fillTabs } from "./tabs.js";
import { themeButton, turnTheme } from "./theme.js";

/** @typedef {import("./types.js").Data} Data */

try {
  begin(await packedData());
} catch (fault) {
  document.documentElement.classList.remove("js");
  document.documentElement.classList.add("failed");
  throw fault;
}

/** @param {Data} data */
function begin(data) {
  const root = document.documentElement;
  const opened = location.hash.length < 2;
  const rooms = Object.entries(ROOMS).filter(([name]) => hasAny(name, data));
  const state = new State(
    data.views,
    rooms.map(([name]) => name),
    data.crank === undefined ? 0 : turnAt(data.crank, data.crank.begins),
  );
  if (opened) state.place = state.within({ view: firstSight(data.views), picture: Infinity });
  root.classList.add("js");
  fillTabs(part("tabs"), state, data.words);
  for (const [name, room] of rooms) {
    const made = room(data, state);
    asPanel(made, name, data.words[name] ?? name);
    made.hidden = name !== state.place.tab;
    if (!made.isConnected) part("main").append(made);
  }
  const help = helpPanel(data.words, state.tabs);
  part("aids").append(themeButton(data.words), helpButton(data.words, help));
  document.body.append(help);
  listenToKeys(state, "", { d: turnTheme, "?": () => help.showModal() });
  letRun(state);
  state.follow();
  const paper = /** @type {HTMLElement | null} */ (document.querySelector("#play .paper"));
  if (opened && paper !== null) showPoster(data, state, paper);
  document.body.append(liveRegion(data, state));
  root.classList.add("ready");
}

/**
 * Return the first plan that has the mechanism beside it, in its main position (index); else the first view.
 * @param {import("./types.js").View[]} views
 */
function firstSight(views) {
  return Math.max(views.findIndex((view, k) => view.main && view.mechanism !== undefined && view.mechanism !== k), 0);
}

/**
 * Tell whether a way of looking has anything to show: not every scene has plans, or a crank.
 * @param {string} name
 * @param {Data} data
 */
function hasAny(name, data) {
  if (name === "crank") return data.crank !== undefined;
  return name === "sheets" || data.views.length > 0;
}

/** @param {string} id */
function part(id) {
  return /** @type {HTMLElement} */ (document.getElementById(id));
}

import { packedData } from "./data.js";
import { element } from "./dom.js";
import { listenToKeys } from "./keys.js";
import { playRoom } from "./play.js";
import { State } from "./state.js";

const data = await packedData();
const state = new State(data.views, ["play", "sheets"]);
const main = /** @type {HTMLElement} */ (document.getElementById("main"));
document.documentElement.classList.add("js");
main.prepend(playRoom(data, state));

const tabs = /** @type {HTMLElement} */ (document.getElementById("tabs"));
tabs.append(
  ...state.tabs.map((name) => {
    const tab = element("button", { type: "button", role: "tab", "aria-controls": name }, data.words[name] ?? name);
    tab.addEventListener("click", () => state.go({ tab: name }));
    return tab;
  }),
);
state.hear((place) => {
  [...tabs.children].forEach((tab, k) => tab.setAttribute("aria-selected", String(state.tabs[k] === place.tab)));
  for (const name of state.tabs) {
    const room = document.getElementById(name);
    if (room !== null) room.hidden = name !== place.tab;
  }
});
listenToKeys(state, () => {
  /** @type {HTMLElement | null} */ (document.querySelector("#play .bar button:nth-child(3)"))?.click();
});
state.follow();
document.documentElement.classList.add("ready");

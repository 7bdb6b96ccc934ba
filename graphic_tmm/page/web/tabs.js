import { element } from "./dom.js";

/** @typedef {import("./state.js").State} State */

/**
 * Fill the list of tabs: one stop of the keyboard, arrows go among them. Of the rooms (their ids are the names of
 * the tabs) that of the tab is seen.
 * @param {HTMLElement} list
 * @param {State} state
 * @param {Record<string, string>} words
 */
export function fillTabs(list, state, words) {
  const tabs = state.tabs.map((name) => {
    const tab = element("button", { type: "button", role: "tab", id: `tab-${name}` }, words[name] ?? name);
    tab.setAttribute("aria-controls", name);
    tab.addEventListener("click", (event) => {
      state.go({ tab: name });
      if (event.detail > 0) tab.blur(); // by a pointer: the next arrow is meant for the room
    });
    return tab;
  });
  list.append(...tabs);
  list.addEventListener("keydown", (event) => {
    const now = state.tabs.indexOf(state.place.tab);
    const to = { ArrowRight: now + 1, ArrowLeft: now - 1, Home: 0, End: tabs.length - 1 }[event.key];
    if (to === undefined || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    const name = state.tabs[(to + tabs.length) % tabs.length] ?? "";
    state.go({ tab: name });
    document.getElementById(`tab-${name}`)?.focus();
  });
  state.hear((place) => {
    state.tabs.forEach((name, k) => {
      const chosen = name === place.tab;
      tabs[k]?.setAttribute("aria-selected", String(chosen));
      tabs[k]?.setAttribute("tabindex", chosen ? "0" : "-1");
      showRoom(name, chosen);
      if (chosen && list.scrollWidth > list.clientWidth) tabs[k]?.scrollIntoView({ block: "nearest", inline: "center" });
    });
    document.documentElement.dataset["tab"] = place.tab;
  });
}

/**
 * Make an element the room of a tab: named as it is.
 * @param {HTMLElement} room
 * @param {string} name
 * @param {string} called
 */
export function asPanel(room, name, called) {
  room.id = name;
  room.setAttribute("role", "tabpanel");
  room.setAttribute("aria-label", called);
}

/**
 * @param {string} name
 * @param {boolean} seen
 */
function showRoom(name, seen) {
  const room = document.getElementById(name);
  if (room !== null) room.hidden = !seen;
}

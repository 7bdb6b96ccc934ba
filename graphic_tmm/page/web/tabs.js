import { element } from "./dom.js";

/** @typedef {import("./state.js").State} State */

/**
 * Fill the list of tabs: one stop of the keyboard, arrows go among them; the room of the tab is what is seen.
 * @param {HTMLElement} list
 * @param {State} state
 * @param {Record<string, HTMLElement>} rooms
 * @param {Record<string, string>} words
 */
export function fillTabs(list, state, rooms, words) {
  const tabs = state.tabs.map((name) => {
    const tab = element("button", { type: "button", role: "tab", id: `tab-${name}` }, words[name] ?? name);
    tab.setAttribute("aria-controls", rooms[name]?.id ?? name);
    tab.addEventListener("click", () => state.go({ tab: name }));
    return tab;
  });
  for (const [name, room] of Object.entries(rooms)) {
    room.setAttribute("role", "tabpanel");
    room.setAttribute("aria-label", words[name] ?? name);
  }
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
      const room = rooms[name];
      if (room !== undefined) room.hidden = !chosen;
    });
    document.documentElement.dataset["tab"] = place.tab;
  });
}

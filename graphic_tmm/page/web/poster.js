import { element } from "./dom.js";
import { toggle } from "./run.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./state.js").State} State
 */

/**
 * Begin with the first plan as it is ready, what the page is and what to press upon it, until something is done.
 * @param {Data} data
 * @param {State} state
 * @param {HTMLElement} paper
 */
export function showPoster(data, state, paper) {
  if (data.views.length === 0) return;
  const say = (/** @type {string} */ key) => data.words[key] ?? key;
  state.go({ picture: Infinity });
  const begin = element("button", { type: "button", class: "begin" }, `▶ ${say("begin")}`);
  begin.addEventListener("click", () => {
    toggle(state);
    /** @type {HTMLElement | null} */ (document.querySelector("#play .stage"))?.focus();
  });
  const card = element("div", { class: "poster" }, element("p", {}, say("welcome")), begin, element("p", {}, say("or keys")));
  paper.append(card);
  paper.classList.add("posed");
  const first = state.place;
  state.hear((place) => {
    if (place === first || !card.isConnected) return;
    card.remove();
    paper.classList.remove("posed");
    const onward = place.tab === first.tab && place.view === first.view && place.picture === first.picture;
    if (onward && !place.running) state.go({ picture: 0 }); // behind the poster nothing follows: it begins
  });
}

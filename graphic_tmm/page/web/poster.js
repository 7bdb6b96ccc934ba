import { element } from "./dom.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./state.js").State} State
 */

/**
 * Stand with a plan that is ready, and beside it what the page is and what to press, until something is done.
 * @param {Data} data
 * @param {State} state
 * @param {HTMLElement} paper
 */
export function showPoster(data, state, paper) {
  if (data.views.length === 0) return;
  const say = (/** @type {string} */ key) => data.words[key] ?? key;
  const begin = element("button", { type: "button", class: "begin" }, `▶ ${say("begin")}`);
  begin.addEventListener("click", () => {
    state.go({ view: 0, picture: 0, running: true });
    /** @type {HTMLElement | null} */ (document.querySelector("#play .stage"))?.focus();
  });
  const card = element("div", { class: "poster" }, element("p", {}, say("welcome")), begin, element("p", {}, say("or keys")));
  document.querySelector("#play .words")?.prepend(card);
  paper.classList.add("posed");
  const first = state.place;
  state.hear((place) => {
    if (place === first || !card.isConnected) return;
    card.remove();
    paper.classList.remove("posed");
    const onward = place.tab === first.tab && place.view === first.view && place.picture === first.picture;
    if (onward && !place.running) state.go({ view: 0, picture: 0 }); // behind the poster nothing follows: it begins
  });
}

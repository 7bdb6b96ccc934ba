import { element } from "./dom.js";
import { tellingOf } from "./telling.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./state.js").State} State
 */

/** A step is read so long after it was gone to, ms: the last of several alone. */
const QUIET = 150;
/** While steps run nothing is read but where they end. */
const RUNS = 2500;
const READ = ["play", "lecture"];

/**
 * Return the one region that reads aloud what each step says.
 * @param {Data} data
 * @param {State} state
 */
export function liveRegion(data, state) {
  const region = element("div", { class: "unseen", id: "live", "aria-live": "polite", "aria-atomic": "true" });
  let timer = 0;
  state.hear((place, before) => {
    window.clearTimeout(timer);
    if (place === before || !READ.includes(place.tab) || data.views.length === 0) return;
    if (place.view === before.view && place.picture === before.picture && !before.running) return;
    const title = place.view === before.view ? "" : `${state.view.title}. `;
    const read = () => {
      const told = tellingOf(data, state.view, state.place.picture).filter((line) => !line.matches(".why"));
      region.textContent = title + told.map((line) => line.textContent).join(" ");
    };
    timer = window.setTimeout(read, place.running ? RUNS : QUIET);
  });
  return region;
}

import { viewAt } from "./state.js";

/** @typedef {import("./state.js").State} State */

/**
 * Go a step on or back; from what is ready to the next plan, from what is given to the plan before.
 * @param {State} state
 * @param {number} by
 */
export function stepOver(state, by) {
  const to = state.place.picture + by;
  const other = planBeside(state, by);
  if (to > state.view.pictures.length && other !== undefined) state.go({ view: other, picture: 0 });
  else if (to < 0 && other !== undefined) state.go({ view: other, picture: Infinity });
  else state.go({ picture: to });
}

/** @type {Map<string, number>} */
const SHOWN = new Map();

/**
 * Return the view (its index) of the next plan or of the one before: that which was shown of it last, else that in the
 * same position, else its main one. A lecture goes from plan to plan, not through all positions of each.
 * @param {State} state
 * @param {number} by
 * @returns {number | undefined}
 */
export function planBeside(state, by) {
  const { family, position } = state.view;
  SHOWN.set(family, state.place.view);
  const families = [...new Set(state.views.map((view) => view.family))];
  const wanted = families[families.indexOf(family) + by];
  if (wanted === undefined) return undefined;
  const among = state.views.flatMap((view, k) => (view.family === wanted ? [k] : []));
  return SHOWN.get(wanted) ?? viewAt(state.views, among, position);
}

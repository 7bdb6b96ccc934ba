/** @typedef {import("./state.js").State} State */

/**
 * Go a step on or back; from what is ready to the next plan, from what is given to the plan before.
 * @param {State} state
 * @param {number} by
 */
export function stepOver(state, by) {
  const { picture, view } = state.place;
  const to = picture + by;
  if (to > state.view.pictures.length && view + 1 < state.views.length) state.go({ view: view + 1, picture: 0 });
  else if (to < 0 && view > 0) state.go({ view: view - 1, picture: Infinity });
  else state.go({ picture: to });
}

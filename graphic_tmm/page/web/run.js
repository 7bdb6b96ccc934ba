/** @typedef {import("./state.js").State} State */

/** A step is left standing so long, ms. */
let pace = 1600;

/**
 * Let the steps of a view follow by themselves while the place says that they run.
 * @param {State} state
 */
export function letRun(state) {
  let timer = 0;
  state.hear((place) => {
    if (place.running === (timer !== 0)) return;
    window.clearInterval(timer);
    timer = place.running ? window.setInterval(() => stepOn(state), pace) : 0;
  });
}

/**
 * Let every step stand so long, ms, from now on.
 * @param {State} state
 * @param {number} wanted
 */
export function setPace(state, wanted) {
  pace = wanted;
  if (!state.place.running) return;
  state.go({ running: false });
  state.go({ running: true });
}

/**
 * Begin or stop; what is ready begins again with what is given.
 * @param {State} state
 */
export function toggle(state) {
  if (state.place.running) return state.go({ running: false });
  const ready = state.place.picture >= state.view.pictures.length;
  state.go({ picture: ready ? 0 : state.place.picture + 1, running: true });
}

/**
 * @param {State} state
 */
function stepOn(state) {
  const next = state.place.picture + 1;
  state.go({ picture: next, running: next < state.view.pictures.length });
}

/** @typedef {import("./state.js").State} State */

/**
 * Let the keyboard step through a plan, wherever nothing else wants the key.
 * @param {State} state
 * @param {() => void} toggle
 */
export function listenToKeys(state, toggle) {
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey || state.place.tab !== "play") return;
    const target = /** @type {Element} */ (event.target);
    if (target.closest("select, input, textarea, [role=slider], [role=tablist]")) return;
    const now = state.place.picture;
    /** @type {Record<string, () => void>} */
    const acts = {
      ArrowRight: () => state.go({ picture: now + 1 }),
      ArrowLeft: () => state.go({ picture: now - 1 }),
      Home: () => state.go({ picture: 0 }),
      End: () => state.go({ picture: Infinity }),
    };
    if (!target.closest("button, a")) acts[" "] = toggle;
    const act = acts[event.key];
    if (act === undefined) return;
    event.preventDefault();
    act();
  });
}

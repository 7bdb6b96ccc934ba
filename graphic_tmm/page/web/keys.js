/** @typedef {import("./state.js").State} State */

/** What wants the keys of the page for itself. */
const OWN = "select, input, textarea, dialog, [role=slider], [contenteditable]";
/** The keys by which one goes among tabs. */
const AMONG = ["ArrowLeft", "ArrowRight", "Home", "End"];
/** What the space bar and Enter press. */
const PRESSED = "button, a, summary, [role=button]";

/**
 * Let a way of looking have keys (names of KeyboardEvent.key; letters in lower case, the key's place where the layout has no
 * Latin letter), wherever nothing else wants them.
 * @param {State} state
 * @param {string} tab "" for every way of looking
 * @param {Record<string, () => void>} acts
 */
export function listenToKeys(state, tab, acts) {
  document.addEventListener("keydown", (event) => {
    if (event.defaultPrevented || (tab !== "" && state.place.tab !== tab)) return;
    const act = acts[keyOf(event)];
    if (act === undefined || takenBy(event)) return;
    event.preventDefault();
    act();
  });
}

/**
 * Return what a key is called: a letter by what it writes, or, where that is none of ours (a Cyrillic layout), by where it is.
 * @param {KeyboardEvent} event
 */
export function keyOf(event) {
  const place = /^Key([A-Z])$/.exec(event.code);
  if (place !== null && !/^[a-z]$/i.test(event.key)) return (place[1] ?? "").toLowerCase();
  return event.key.length === 1 ? event.key.toLowerCase() : event.key;
}

/**
 * Whether something else wants a key.
 * @param {KeyboardEvent} event
 */
export function takenBy(event) {
  if (event.ctrlKey || event.altKey || event.metaKey) return true;
  const target = /** @type {Element | null} */ (event.target);
  if (target === null || !("closest" in target)) return false;
  if (target.closest(OWN) !== null) return true;
  if (AMONG.includes(event.key) && target.closest("[role=tablist]") !== null) return true;
  return (event.key === " " || event.key === "Enter") && target.closest(PRESSED) !== null;
}

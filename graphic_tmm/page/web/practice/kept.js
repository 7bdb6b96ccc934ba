/** What a browser keeps of practice stands behind this. */
const KEPT = "graphic-tmm practice";

/** What is kept where the browser keeps nothing. @type {Map<string, string>} */
const MEMORY = new Map();

/**
 * Keep something of a task beyond the page, where the browser allows that; else as long as the page is open.
 * @param {string} name
 * @param {unknown} what as JSON takes it
 */
export function keep(name, what) {
  const text = JSON.stringify(what);
  MEMORY.set(name, text);
  try {
    localStorage.setItem(`${KEPT}: ${name}`, text);
  } catch {
    return; // a page from a file may be refused
  }
}

/**
 * Return what is kept of a task; null if there is nothing that can be read.
 * @param {string} name
 * @returns {unknown}
 */
export function kept(name) {
  const own = MEMORY.get(name) ?? stored(name);
  try {
    return own === null ? null : JSON.parse(own);
  } catch {
    return null;
  }
}

/** @param {string} name */
function stored(name) {
  try {
    return localStorage.getItem(`${KEPT}: ${name}`);
  } catch {
    return null;
  }
}

/** @typedef {import("./types.js").Answer} Answer */
/** @typedef {import("./types.js").Checked} Checked */
/** @typedef {import("./types.js").Clickable} Clickable */
/** @typedef {import("./types.js").Fault} Fault */
/** @typedef {import("./types.js").Form} Form */
/** @typedef {import("./types.js").Proposal} Proposal */
/** @typedef {import("./types.js").SchemeAct} SchemeAct */
/** @typedef {import("./types.js").SchemeTold} SchemeTold */
/** @typedef {import("./types.js").State} State */

/** After so long a connection that was closed is tried again, ms. */
const AGAIN = 2000;

/**
 * Return what the server put into the page.
 * @template T
 * @returns {T}
 */
export function about() {
  return JSON.parse(document.getElementById("data")?.textContent ?? "{}");
}

/**
 * Follow a stream of states for as long as somebody looks: a browser has few connections to one server.
 * @param {string} address
 * @param {(state: State) => void} hear
 * @param {(there: boolean) => void} linked told when the connection is there, and when it is not
 */
export function follow(address, hear, linked) {
  /** @type {EventSource | null} */
  let source = null;
  let timer = 0;
  const end = () => {
    clearTimeout(timer);
    source?.close();
    source = null;
  };
  const begin = () => {
    end();
    if (document.hidden) return;
    const made = new EventSource(address);
    source = made;
    made.addEventListener("open", () => linked(true));
    made.addEventListener("state", (event) => hear(JSON.parse(event.data)));
    made.addEventListener("error", () => {
      linked(false);
      if (made.readyState === EventSource.CLOSED) timer = setTimeout(begin, AGAIN);
    });
  };
  document.addEventListener("visibilitychange", () => (document.hidden ? end() : begin()));
  window.addEventListener("pagehide", end);
  window.addEventListener("pageshow", (event) => {
    if (event.persisted) begin();
  });
  begin();
}

/** Have the scene drawn once more. */
export function drawAgain() {
  void fetch("again", { method: "POST", headers: { "Content-Type": "application/json" } }).catch(() => {});
}

/**
 * Return the values of the scene; null where there are none to set, or nothing came back.
 * @returns {Promise<Form | null>}
 */
export async function formOf() {
  try {
    const answer = await fetch("form", { cache: "no-store" });
    return answer.ok ? await answer.json() : null;
  } catch {
    return null;
  }
}

/**
 * Set values in the file that has a version.
 * @param {string} version
 * @param {Record<string, string>} changes
 * @returns {Promise<Answer>}
 */
export async function setValues(version, changes) {
  try {
    const answer = await fetch("form", {
      method: "POST",
      headers: { "Content-Type": "application/json" },
      body: JSON.stringify({ version, changes }),
    });
    const told = await answer.json().catch(() => ({}));
    return { status: answer.status, version: told.version ?? "", errors: told.errors ?? [] };
  } catch {
    return { status: 0, version: "", errors: [] };
  }
}

/**
 * Return the plans of the scene that may be clicked in a photograph; none with the reasons, if that cannot be told;
 * null if nothing came back.
 * @returns {Promise<Clickable | null>}
 */
export async function plansOf() {
  const none = { plans: [], sheets: [], papers: [] };
  try {
    const answer = await fetch("plans", { cache: "no-store" });
    const told = await answer.json();
    return answer.ok ? { ...told, errors: [] } : { ...none, errors: textsOf(told.errors) };
  } catch {
    return null;
  }
}

/**
 * Send a photograph to be checked; without a report what it is refused for, if that came back.
 * @param {Blob} file
 * @param {[string, string][]} asked
 * @returns {Promise<{answer: Checked | null, errors: string[]}>}
 */
export function checkPhoto(file, asked) {
  return sendPhoto("photo", file, asked);
}

/**
 * Send a photograph in which plans are to be found.
 * @param {Blob} file
 * @param {[string, string][]} asked
 * @returns {Promise<{answer: {plans: Proposal[]} | null, errors: string[]}>}
 */
export function proposePlans(file, asked) {
  return sendPhoto("proposals", file, asked);
}

/**
 * @param {string} address
 * @param {Blob} file
 * @param {[string, string][]} asked
 */
async function sendPhoto(address, file, asked) {
  try {
    const answer = await fetch(`${address}?${new URLSearchParams(asked)}`, {
      method: "POST",
      headers: { "Content-Type": "application/octet-stream" },
      body: file,
    });
    const told = await answer.json();
    return answer.ok ? { answer: told, errors: [] } : { answer: null, errors: textsOf(told.errors) };
  } catch {
    return { answer: null, errors: [] };
  }
}

/**
 * Send an act on a scheme.
 * @param {string} address
 * @param {SchemeAct} act
 * @returns {Promise<SchemeTold>}
 */
export async function schemeAfter(address, act) {
  try {
    const answer = await fetch(address, { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify(act) });
    const told = await answer.json();
    return answer.ok ? { answer: told, errors: [], status: answer.status } : { answer: null, errors: textsOf(told.errors ?? [], Object.keys(act.typed ?? {})), status: answer.status };
  } catch {
    return { answer: null, errors: [], status: 0 };
  }
}

/**
 * Put a scene into the folder; return its name, "" with what it is refused for.
 * @param {string} text
 * @param {string} title
 * @returns {Promise<{name: string, errors: string[]}>}
 */
export async function newScene(text, title) {
  try {
    const answer = await fetch("new", { method: "POST", headers: { "Content-Type": "application/json" }, body: JSON.stringify({ text, title }) });
    const told = await answer.json();
    return answer.ok ? { name: told.name, errors: [] } : { name: "", errors: textsOf(told.errors ?? []) };
  } catch {
    return { name: "", errors: [] };
  }
}

/**
 * Return faults in words, with their places but those that are named beside them.
 * @param {Fault[]} faults
 * @param {string[]} named keys
 */
function textsOf(faults, named = []) {
  return faults.map(({ text, place, key }) => (place && !named.includes(key) ? `${place}: ${text}` : text));
}

import { element } from "./dom.js";

/**
 * @typedef {import("./sheet-ink.js").Ink} Ink
 * @typedef {import("./sheet-ink.js").SheetInk} SheetInk
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./types.js").View} View
 */

/**
 * What of a sheet is shown; parts and views are those that are not.
 * @typedef {{rubbed: boolean, letters: boolean, large: boolean, position: string, parts: Set<string>,
 *   views: Set<string>}} Layers
 */

/** @returns {Layers} */
export function allLayers() {
  return { rubbed: false, letters: true, large: true, position: "", parts: new Set(), views: new Set() };
}

/**
 * Return which ink of a sheet its layers show; the frame is always there.
 * @param {SheetInk} sheet
 * @param {Layers} layers
 * @param {Map<string, View>} played the views that are played, by their ids
 * @returns {Ink[]}
 */
export function shownInk(sheet, layers, played) {
  return sheet.ink.filter((one) => {
    const view = sheet.views[one.view];
    if (view === undefined || view.frame) return true;
    if (one.rubbed && !layers.rubbed) return false;
    if (one.label >= 0 && !layers.letters) return false;
    if (layers.parts.has(one.part) || layers.views.has(view.id)) return false;
    if (layers.position === "" || one.at < 0) return true;
    return nameOf(played.get(view.id), one.at) === layers.position;
  });
}

/**
 * Return what a position of a view is called.
 * @param {View | undefined} view
 * @param {number} at
 */
function nameOf(view, at) {
  return view?.names[String(at)] ?? "";
}

/**
 * Build the choice of what is shown of a sheet.
 * @param {Data} data
 * @param {SheetInk} sheet
 * @param {Layers} layers what is shown; the choice changes it
 * @param {Map<string, View>} played
 * @param {() => void} changed
 */
export function layersPanel(data, sheet, layers, played, changed) {
  const say = (/** @type {string} */ key) => data.words[key] ?? key;
  const flags = [
    ["letters", "letters"],
    ["large", "large letters"],
    ["rubbed", "helping lines"],
  ].flatMap(([flag, word]) =>
    flag === "rubbed" && !sheet.ink.some((one) => one.rubbed)
      ? []
      : [flagBox(/** @type {"letters"} */ (flag), say(word ?? ""))],
  );
  const parts = [...new Set(sheet.ink.flatMap((one) => (one.part in data.parts ? [one.part] : [])))];
  const named = parts.map((part) => ({ part, name: data.parts[part] ?? "" }));
  named.sort((a, b) => a.name.localeCompare(b.name, data.language));
  const views = sheet.views.filter((view) => !view.frame);

  /**
   * @param {"letters" | "large" | "rubbed"} flag
   * @param {string} name
   */
  function flagBox(flag, name) {
    return tick(name, layers[flag], (on) => {
      layers[flag] = on;
      changed();
    });
  }
  /**
   * @param {Set<string>} off
   * @param {string} key
   * @param {string} name
   */
  function memberBox(off, key, name) {
    return tick(name, !off.has(key), (on) => {
      if (on) off.delete(key);
      else off.add(key);
      changed();
    });
  }
  return element(
    "div",
    { class: "layers", role: "group", "aria-label": say("layers") },
    ...flags,
    positionChoice(sheet, layers, played, say, changed),
    group(say("parts"), named.map(({ part, name }) => memberBox(layers.parts, part, name))),
    group(say("views"), views.map((view) => memberBox(layers.views, view.id, view.title))),
  );
}

/**
 * @param {string} name
 * @param {HTMLElement[]} inner
 */
function group(name, inner) {
  const made = element("details", {}, element("summary", {}, name), ...inner);
  made.hidden = inner.length === 0;
  return made;
}

/**
 * @param {string} name
 * @param {boolean} on
 * @param {(on: boolean) => void} act
 */
function tick(name, on, act) {
  const box = /** @type {HTMLInputElement} */ (element("input", { type: "checkbox" }));
  box.checked = on;
  box.addEventListener("change", () => act(box.checked));
  return element("label", { class: "tick" }, box, ` ${name}`);
}

/**
 * @param {SheetInk} sheet
 * @param {Layers} layers
 * @param {Map<string, View>} played
 * @param {(key: string) => string} say
 * @param {() => void} changed
 */
function positionChoice(sheet, layers, played, say, changed) {
  /** @type {Set<string>} */
  const names = new Set();
  for (const one of sheet.ink) {
    if (one.at >= 0) names.add(nameOf(played.get(sheet.views[one.view]?.id ?? ""), one.at));
  }
  names.delete("");
  const sorted = [...names].sort((a, b) => a.localeCompare(b, undefined, { numeric: true }));
  const choice = /** @type {HTMLSelectElement} */ (element("select", {}));
  choice.append(element("option", { value: "" }, say("all positions")));
  choice.append(...sorted.map((name) => element("option", { value: name }, name)));
  if (!names.has(layers.position)) layers.position = "";
  choice.value = layers.position;
  choice.addEventListener("change", () => {
    layers.position = choice.value;
    changed();
  });
  const made = element("label", { class: "tick" }, `${say("position")} `, choice);
  made.hidden = names.size < 2;
  return made;
}

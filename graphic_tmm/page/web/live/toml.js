import { filled } from "../dom.js";

/**
 * @typedef {import("../types.js").Slider} Slider
 * @typedef {import("../types.js").SceneKey} SceneKey
 */

/** Digits that are copied: a number typed comes back as it was. */
const KEPT_DIGITS = 12;

/**
 * Return what is changed as keys of the scene, table by table; what stands for no one number of it is named.
 * @param {Slider[]} sliders
 * @param {Map<Slider, number>} values
 * @param {string} several what is said of such a letter
 */
export function tomlOf(sliders, values, several) {
  const now = (/** @type {Slider} */ one) => values.get(one) ?? one.v;
  /** @type {Map<string, Map<string, string>>} */
  const tables = new Map();
  const left = sliders.filter((one) => values.has(one) && one.key === undefined && one.plan === undefined);
  const known = sliders.filter((one) => one.key !== undefined);
  for (const one of known) {
    const { key } = one;
    if (key === undefined) continue;
    const same = known.filter((other) => other.key?.in === key.in && other.key.name === key.name);
    if (!same.some((other) => otherNow(other, known, now))) continue;
    const rows = tables.get(key.in) ?? new Map();
    tables.set(key.in, rows);
    rows.set(key.name, literal(key, same, known, now));
  }
  const text = [...tables].map(([table, rows]) => `${table}\n${[...rows].map(([name, value]) => `${name} = ${value}\n`).join("")}`);
  return [...left.map((one) => `# ${filled(several, { letter: one.n })}\n`), ...text].join("\n");
}

/**
 * Return what a number of the scene is now.
 * @param {Slider} one
 * @param {Slider[]} known
 * @param {(one: Slider) => number} now
 * @returns {number}
 */
function sceneNumber(one, known, now) {
  const { key } = one;
  if (key === undefined) return NaN;
  const [table, name, part] = key.less ?? [];
  const less = known.find((other) => other.key?.in === table && other.key?.name === name && (other.key?.part ?? 0) === part);
  return now(one) / key.by + (less === undefined ? 0 : sceneNumber(less, known, now));
}

/**
 * @param {Slider} one
 * @param {Slider[]} known
 * @param {(one: Slider) => number} now
 */
function otherNow(one, known, now) {
  const before = sceneNumber(one, known, (other) => other.v);
  return Math.abs(sceneNumber(one, known, now) - before) > 1e-12 * Math.abs(before);
}

/**
 * @param {SceneKey} key
 * @param {Slider[]} same
 * @param {Slider[]} known
 * @param {(one: Slider) => number} now
 */
function literal(key, same, known, now) {
  const [only] = same;
  if (key.pair === undefined) return only === undefined ? "" : asWritten(sceneNumber(only, known, now), key.unit);
  const pair = key.pair.map((value, part) => {
    const own = same.find((one) => one.key?.part === part);
    return asWritten(own === undefined ? value : sceneNumber(own, known, now), key.unit);
  });
  const place = `[${pair.join(", ")}]`;
  return key.rest === "" ? place : `{ through = ${place}${key.rest}`;
}

/**
 * @param {number} value in SI
 * @param {string} unit
 */
function asWritten(value, unit) {
  const told = Number((unit === "mm" ? 1000 * value : value).toPrecision(KEPT_DIGITS));
  return unit === "" ? String(told) : `"${told} ${unit}"`;
}

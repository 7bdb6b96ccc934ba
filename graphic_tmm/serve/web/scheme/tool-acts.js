import * as acts from "./acts.js";
import { drivenBy, meeting, repeating, welded } from "./roles.js";
import { bodiesAt, frameOf } from "./sketch.js";
import { guideBar } from "./snap.js";

/**
 * What each tool does where it was used: a sketch (null: nothing) with the letter that is chosen then, a pin or a link
 * that it waits with for the next click, or null where it was not meant.
 *
 * @typedef {import("./editor.js").Editor} Editor
 * @typedef {import("./sketch.js").Sketch} Sketch
 * @typedef {import("./sketch.js").Target} Target
 * @typedef {import("./snap.js").Meant} Meant
 * @typedef {"support" | "slider" | "stone" | "cylinder" | "point" | "centre" | "drive" | "passive" | "weld"} ToolName
 * @typedef {{begun: Meant, meant: Meant, drawn: boolean, angle: number, pin: string}} Use where it was pressed and released;
 *   angle: of the way between them, degrees; pin: that it is for, "" for none
 * @typedef {{sketch: Sketch | null, letter?: string, numbers?: Record<string, number>} | {wait?: string, link?: number} | null} Done
 */

/** @type {Record<ToolName, (editor: Editor, use: Use) => Done>} */
export const TOOL_ACTS = {
  support: ({ sketch }, { meant: { letter } }) => (letter === undefined ? null : { sketch: acts.supported(sketch, letter) }),
  slider: ({ sketch }, { pin, angle }) => (pin === "" ? null : { sketch: acts.guided(sketch, pin, angle) }),
  stone: ({ sketch }, { pin, meant }) => {
    if (meant.letter !== undefined) return { wait: meant.letter };
    return pin === "" || meant.bar === undefined ? null : { sketch: acts.stoned(sketch, pin, guideBar(sketch, meant.bar)) };
  },
  cylinder: ({ sketch }, { begun, meant, drawn }) => (drawn ? acts.cylinder(sketch, targetOf(begun), targetOf(meant)) : null),
  point: ({ sketch, chosen }, { meant }) => {
    const link = linkAt(sketch, meant);
    if (chosen.number !== undefined) return acts.pinned(sketch, chosen.number, targetOf(meant));
    return link === undefined ? null : { link };
  },
  centre: ({ sketch, chosen }, { meant }) => {
    const number = sliderAt(sketch, meant) ?? linkAt(sketch, meant) ?? chosen.number;
    return number === undefined ? null : { sketch: acts.centred(sketch, number, targetOf(meant)) };
  },
  drive: ({ sketch }, { meant }) => {
    const number = linkAt(sketch, meant);
    return number === undefined ? null : drivenBy(sketch, number);
  },
  weld: ({ sketch, chosen }, { meant }) => {
    const both = meant.letter === undefined ? null : meeting(sketch, meant.letter);
    if (both !== null) return { sketch: welded(sketch, ...both) };
    const link = meant.bar?.number;
    if (link === undefined) return null;
    return chosen.number === undefined ? { link } : { sketch: welded(sketch, chosen.number, link) };
  },
  passive: ({ sketch }, { meant }) => {
    const number = sliderAt(sketch, meant) ?? linkAt(sketch, meant);
    return number === undefined ? null : { sketch: repeating(sketch, number) };
  },
};

/**
 * Return the link that is meant: that of a bar, at a pin the one with most letters.
 * @param {Sketch} sketch
 * @param {Meant} meant
 */
function linkAt(sketch, { letter, bar }) {
  if (letter === undefined) return bar?.number;
  const there = bodiesAt(sketch, letter).filter((one) => one !== frameOf(sketch));
  return there.sort((a, b) => b.points.length - a.points.length)[0]?.number;
}

/**
 * Return the slider at the pin that is meant.
 * @param {Sketch} sketch
 * @param {Meant} meant
 */
function sliderAt(sketch, { letter }) {
  const there = letter === undefined ? [] : bodiesAt(sketch, letter);
  return there.find((one) => one !== frameOf(sketch) && one.points.length === 1)?.number;
}

/**
 * @param {Meant} meant
 * @returns {Target}
 */
export function targetOf({ letter, bar, place }) {
  if (letter !== undefined) return { letter };
  return bar === undefined ? { place } : { bar, place };
}

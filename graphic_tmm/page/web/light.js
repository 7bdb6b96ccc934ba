/**
 * @typedef {import("./types.js").View} View
 */

/** What belongs to so many marks at the most is lit with one of them; a body that stands on more only by itself. */
const FEW = 2;

/**
 * Light up, wherever something of a mark is pointed at, everything of the same mark: on the drawing, in sentences,
 * formulas, the table, the list.
 * @param {Element} room
 * @param {() => View} viewOf
 */
export function lightAlike(room, viewOf) {
  /** @param {Element | null} of */
  const light = (of) => {
    const slots = of === null ? [] : slotsOf(of);
    const wanted = new Set(slots.flatMap((slot) => [slot, ...alike(viewOf(), slot)]));
    for (const one of room.querySelectorAll("[data-of]")) {
      one.classList.toggle("lit", one === of || isLit(one, wanted, slots.length));
    }
  };
  for (const kind of ["pointerover", "pointerdown"]) room.addEventListener(kind, (event) => light(pointed(event)));
  // what the keyboard or a finger comes upon stays lit until it goes elsewhere
  room.addEventListener("focusin", (event) => {
    const of = pointed(event);
    if (of !== null) light(of);
  });
  room.addEventListener("pointerleave", (event) => {
    if (/** @type {PointerEvent} */ (event).pointerType === "mouse") light(null);
  });
}

/** @param {Event} event */
function pointed({ target }) {
  return target instanceof Element ? target.closest("[data-of]") : null;
}

/**
 * @param {Element} one
 * @param {Set<string>} wanted
 * @param {number} count
 */
function isLit(one, wanted, count) {
  const own = slotsOf(one);
  if (own.length > FEW && count <= FEW && one.matches("path")) return false;
  return own.some((slot) => wanted.has(slot));
}

/** @param {Element} one */
function slotsOf(one) {
  return (one.getAttribute("data-of") ?? "").split(" ").filter((slot) => slot !== "");
}

/**
 * Return what else stands for the same: a length, and the point that was laid off with it.
 * @param {View} view
 * @param {string} slot
 * @returns {string[]}
 */
function alike(view, slot) {
  const found = [];
  for (const picture of view.pictures) {
    for (const line of picture.lines) {
      if (line.op !== "lay_off" || line.uses === undefined) continue;
      const pair = [String(line.uses[1]), String(line.it)];
      if (pair.includes(slot)) found.push(...pair);
    }
  }
  return found;
}

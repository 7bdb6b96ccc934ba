import { ROOMS } from "../rooms.js";

/** The ways to assemble a group stand in the page already. */
ROOMS["assemblies"] = () => {
  const room = /** @type {HTMLElement} */ (document.getElementById("assemblies"));
  room.tabIndex = 0; // keys move it where it is higher than its window
  return room;
};

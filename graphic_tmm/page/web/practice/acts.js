import { element } from "../dom.js";
import { showSide } from "./sides.js";

/**
 * Return what the buttons and forms beside the board do.
 * @param {import("./practising.js").Practising} work
 * @returns {import("./panel.js").Acts}
 */
export function actsOf(work) {
  return {
    choose: (name) => work.choose(name),
    pick: (slot) => work.pick(slot),
    submit: () => work.settle(work.task.submit()),
    tell: (value, text) => work.tell(value, [text]),
    aim: (spot) => work.aimAt(spot),
    prick: () => work.prick(),
    leave: () => work.leave(),
    help: () => work.help(),
    side: (side) => showSide(work, side),
    redo: (slot) => work.redo(slot),
    again: () => work.redo(work.now),
    clear: () => {
      if (work.panel.doubted(work.task.results.size > 0)) return;
      work.session.clear();
      work.go(work.n);
    },
    record: () => work.session.saveRecord(),
    readings: () => work.session.saveReadings(),
    refuse: (trouble) => work.report([element("p", { class: "verdict" }, trouble)]),
  };
}

import { element } from "./dom.js";
import { viewAt } from "./state.js";

/**
 * @typedef {import("./types.js").Data} Data
 * @typedef {import("./state.js").State} State
 */

/**
 * Return the choice of the plan and of its position.
 * @param {Data} data
 * @param {State} state
 */
export function chooser(data, state) {
  const plan = /** @type {HTMLSelectElement} */ (element("select", {}));
  const position = /** @type {HTMLSelectElement} */ (element("select", {}));
  const families = [...new Set(data.views.map((view) => view.family))];
  plan.append(...families.map((name) => element("option", { value: name }, name)));
  plan.addEventListener("change", () => {
    const among = viewsOf(data, plan.value);
    state.go({ view: viewAt(data.views, among, state.view.position) ?? 0, picture: 0 });
  });
  position.addEventListener("change", () => state.go({ view: Number(position.value), picture: state.place.picture }));
  const places = element("label", { class: "places" }, element("span", {}, data.words["position"] ?? ""), position);
  let family = "";
  state.hear((place) => {
    const view = data.views[place.view];
    if (view === undefined) return;
    if (view.family !== family) {
      family = view.family;
      plan.value = family;
      const among = viewsOf(data, family).filter((k) => data.views[k]?.position);
      position.replaceChildren(
        ...among.map((k) => element("option", { value: String(k) }, data.views[k]?.position ?? "")),
      );
      places.hidden = among.length === 0;
    }
    position.value = String(place.view);
  });
  const plans = element("label", { class: "plans" }, element("span", {}, data.words["plan"] ?? ""), plan);
  return element("div", { class: "chooser" }, plans, places);
}

/**
 * Return the views (indices) of a family: one plan in its positions.
 * @param {Data} data
 * @param {string} family
 */
function viewsOf(data, family) {
  return data.views.flatMap((view, k) => (view.family === family ? [k] : []));
}

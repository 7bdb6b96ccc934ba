import { element } from "./dom.js";

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
  plan.addEventListener("change", () =>
    state.go({ view: data.views.findIndex((view) => view.family === plan.value), picture: 0 }),
  );
  position.addEventListener("change", () => state.go({ view: Number(position.value), picture: state.place.picture }));
  const places = element("label", {}, `${data.words["position"]} `, position);
  state.hear((place) => {
    const view = data.views[place.view];
    if (view === undefined) return;
    plan.value = view.family;
    const among = data.views.flatMap((one, k) => (one.family === view.family && one.position ? [k] : []));
    position.replaceChildren(
      ...among.map((k) => element("option", { value: String(k) }, data.views[k]?.position ?? "")),
    );
    position.value = String(place.view);
    places.hidden = among.length === 0;
  });
  return element("p", { class: "chooser" }, element("label", {}, `${data.words["plan"]} `, plan), places);
}

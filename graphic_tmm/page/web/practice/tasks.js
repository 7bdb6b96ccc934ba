import { element } from "../dom.js";

/**
 * @typedef {import("../types.js").Practice} Practice
 * @typedef {(key: string) => string} Say
 */

/**
 * Return the choice of the task: the plan, and its position.
 * @param {Practice} practice
 * @param {Say} say
 * @param {(n: number) => void} go
 */
export function taskChooser(practice, say, go) {
  const plan = /** @type {HTMLSelectElement} */ (element("select", {}));
  const position = /** @type {HTMLSelectElement} */ (element("select", {}));
  const plans = [...new Set(practice.tasks.map((task) => task.plan))];
  plan.append(...plans.map((k) => element("option", { value: String(k) }, practice.titles[k] ?? "")));
  const among = (/** @type {number} */ of) => practice.tasks.flatMap((task, n) => (task.plan === of ? [n] : []));
  plan.addEventListener("change", () => {
    const own = among(Number(plan.value));
    const now = practice.tasks[Number(position.value)]?.at;
    go(own.find((n) => practice.tasks[n]?.at === now) ?? mainOf(practice, own));
  });
  position.addEventListener("change", () => go(Number(position.value)));
  const label = (/** @type {string} */ key, /** @type {HTMLElement} */ of, /** @type {string} */ name) =>
    element("label", { class: name }, element("span", {}, say(key)), of);
  return {
    whole: element("div", { class: "chooser" }, label("plan", plan, "plans"), label("position", position, "places")),
    /** @param {number} n */
    show(n) {
      const task = practice.tasks[n];
      if (task === undefined) return;
      plan.value = String(task.plan);
      const own = among(task.plan);
      position.replaceChildren(
        ...own.map((k) => element("option", { value: String(k) }, practice.names[practice.tasks[k]?.at ?? 0] ?? "")),
      );
      position.value = String(n);
    },
  };
}

/**
 * Return the task that is nearest to what is looked at: of the same plan in the same position, else of the same plan, else
 * of the first, in its main one.
 * @param {Practice} practice
 * @param {{plan: string, position: string, names: Record<string, string>}} view
 * @param {number} place number of the position, where the view has all of them; -1: none was chosen
 * @param {boolean} posed whether a pose of its own is taken before the positions of the sheet
 */
export function taskNear(practice, view, place, posed) {
  const of = (/** @type {number} */ plan) => practice.tasks.flatMap((task, n) => (task.plan === plan ? [n] : []));
  const same = of(practice.plans.indexOf(view.plan));
  const own = same.length > 0 ? same : of(practice.tasks[0]?.plan ?? 0);
  const name = view.position || (view.names[String(place)] ?? "");
  const pose = posed ? own.find((n) => practice.tasks[n]?.pose) : undefined;
  return pose ?? own.find((n) => practice.names[practice.tasks[n]?.at ?? -1] === name) ?? mainOf(practice, own);
}

/**
 * Return of the tasks of a plan that in the main position, else the first.
 * @param {Practice} practice
 * @param {number[]} own
 */
function mainOf(practice, own) {
  return own.find((n) => practice.tasks[n]?.at === practice.main) ?? own[0] ?? 0;
}

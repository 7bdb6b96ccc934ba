import { element } from "../../page/web/dom.js";

/** @typedef {{name: string, title: string, panel: HTMLElement}} Way a way of looking */

/**
 * Return the list of tabs that shows one panel at a time; arrows go from tab to tab.
 * @param {string} label
 * @param {Way[]} ways
 * @param {string} first
 * @param {(name: string) => void} chosen
 */
export function tabList(label, ways, first, chosen) {
  const tabs = ways.map(({ name, title, panel }) => {
    panel.id = `panel-${name}`;
    panel.setAttribute("role", "tabpanel");
    panel.setAttribute("aria-labelledby", `tab-${name}`);
    const tab = element("button", { type: "button", role: "tab", id: `tab-${name}`, "aria-controls": panel.id }, title);
    tab.addEventListener("click", () => choose(name));
    return tab;
  });
  const choose = (/** @type {string} */ name) => {
    ways.forEach((way, k) => {
      const now = way.name === name;
      way.panel.hidden = !now;
      tabs[k]?.setAttribute("aria-selected", String(now));
      tabs[k]?.setAttribute("tabindex", now ? "0" : "-1");
    });
    chosen(name);
  };
  const list = element("div", { role: "tablist", "aria-label": label }, ...tabs);
  list.addEventListener("keydown", (event) => {
    const by = { ArrowRight: 1, ArrowLeft: -1 }[event.key];
    if (by === undefined) return;
    const at = tabs.findIndex((tab) => tab.getAttribute("aria-selected") === "true");
    const to = (at + by + tabs.length) % tabs.length;
    choose(ways[to]?.name ?? first);
    tabs[to]?.focus();
    event.preventDefault();
  });
  choose(ways.some((way) => way.name === first) ? first : (ways[0]?.name ?? ""));
  return list;
}

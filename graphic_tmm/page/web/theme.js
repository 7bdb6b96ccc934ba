import { iconButton } from "./dom.js";

const HALF = "M12 3a9 9 0 0 0 0 18zM12 3a9 9 0 0 1 0 18a9 9 0 0 0 0-18z";

/** Whether the page is dark now: by a person's word, else as the system is. */
export function isDark() {
  const chosen = document.documentElement.dataset["theme"];
  return chosen === undefined ? matchMedia("(prefers-color-scheme: dark)").matches : chosen === "dark";
}

/** Turn the page from light to dark or back. */
export function turnTheme() {
  document.documentElement.dataset["theme"] = isDark() ? "light" : "dark";
}

/**
 * Return the button that turns the page from light to dark or back.
 * @param {Record<string, string>} words
 */
export function themeButton(words) {
  return iconButton(HALF, words["dark"] ?? "", turnTheme);
}

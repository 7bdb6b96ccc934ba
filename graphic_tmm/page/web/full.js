const ROOT = document.documentElement;

/** Whether the lecture fills the screen, or at least the window. */
export function isFull() {
  return ROOT.classList.contains("full");
}

/**
 * Fill the screen with the lecture; where a browser refuses that, the window.
 * @param {(full: boolean) => void} told
 */
export function enterFull(told) {
  ROOT.classList.add("full");
  told(true);
  if (ROOT.requestFullscreen !== undefined) ROOT.requestFullscreen().catch(() => {});
}

/**
 * @param {(full: boolean) => void} told
 */
export function leaveFull(told) {
  if (!isFull()) return;
  ROOT.classList.remove("full");
  told(false);
  if (document.fullscreenElement) document.exitFullscreen().catch(() => {});
}

/**
 * Be told when the browser itself leaves the full screen (its own Escape).
 * @param {(full: boolean) => void} told
 */
export function hearFull(told) {
  document.addEventListener("fullscreenchange", () => {
    if (document.fullscreenElement === null) leaveFull(told);
  });
}

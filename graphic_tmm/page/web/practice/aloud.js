/**
 * Let the page's one live region read something.
 * @param {HTMLElement[]} lines
 */
export function readAloud(lines) {
  const region = document.getElementById("live");
  if (region !== null && lines.length > 0) region.textContent = lines.map((line) => line.textContent).join(" ");
}

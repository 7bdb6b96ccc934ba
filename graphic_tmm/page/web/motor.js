/** Degrees a second, by the choice of speed. */
export const SPEEDS = [15, 45, 90];

/**
 * Turn evenly while it runs: `turn` is told every frame by how many degrees to go on.
 * @param {(by: number) => void} turn
 * @param {(runs: boolean) => void} told
 */
export function motor(turn, told) {
  let speed = SPEEDS[1] ?? 45;
  let frame = 0;
  let before = 0;
  const step = (/** @type {number} */ now) => {
    if (before > 0) turn((speed * Math.min(now - before, 100)) / 1000);
    before = now;
    frame = requestAnimationFrame(step);
  };
  const made = {
    /** @param {boolean} runs */
    run(runs) {
      if (runs === frame > 0) return;
      if (runs) frame = requestAnimationFrame(step);
      else cancelAnimationFrame(frame);
      if (!runs) frame = 0;
      before = 0;
      told(runs);
    },
    toggle: () => made.run(frame === 0),
    /** @param {number} n */
    shift(n) {
      speed = SPEEDS[n] ?? speed;
    },
  };
  return made;
}

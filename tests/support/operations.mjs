// Operations written down in JavaScript, run by node: what is asked for stands in a file, what is answered in another.
import { readFileSync, writeFileSync } from "node:fs";
import { BOARD } from "./practice/board.js";
import "./practice/written.js";

const [, , asked, answered] = process.argv;
const answers = JSON.parse(readFileSync(asked, "utf8")).map(([name, ...values]) =>
  plain(BOARD.operations[name](...values.map(drawn))));
writeFileSync(answered, JSON.stringify(answers));

/** A value of the board out of what JSON has: a number, [x, y], [[x, y], [x, y]], [[x, y], radius]. */
function drawn(told) {
  if (!Array.isArray(told)) return told;
  const [first, second] = told;
  if (!Array.isArray(first)) return { re: first, im: second };
  return Array.isArray(second) ? { at: drawn(first), along: drawn(second) } : { centre: drawn(first), radius: second };
}

/** The numbers of a value; null for one that is not finite. */
function plain(value) {
  const numbers = typeof value === "object" ? Object.values(value).flatMap(plain) : [Number(value)];
  return numbers.map((x) => (Number.isFinite(x) ? x : null));
}

import "../practice/enter.js";
import { KEYS } from "../help.js";
import { ROOMS } from "../rooms.js";
import { ownRoom } from "./own.js";

ROOMS["own"] = ownRoom;
KEYS["own"] = [
  ["← → ↑ ↓", "own nudge"],
  ["Enter", "own enter"],
  ["+", "larger"],
  ["−", "smaller"],
  ["0", "fit whole"],
];

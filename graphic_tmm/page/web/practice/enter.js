import { KEYS } from "../help.js";
import { ROOMS } from "../rooms.js";
import { practiceRoom } from "./room.js";

ROOMS["practice"] = practiceRoom;
KEYS["practice"] = [
  ["1 … 9 0", "keys tools"],
  ["Enter", "keys whole"],
  ["← → ↑ ↓", "keys nudge"],
  ["Esc", "keys let go"],
  ["H", "keys help"],
];

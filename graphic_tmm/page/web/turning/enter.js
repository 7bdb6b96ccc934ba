import { KEYS } from "../help.js";
import { ROOMS } from "../rooms.js";
import { turningRoom } from "./room.js";

ROOMS["turning"] = turningRoom;
KEYS["turning"] = [
  ["→ ↑", "turning degree on"],
  ["← ↓", "turning degree back"],
  ["PgUp", "turning leap on"],
  ["PgDn", "turning leap back"],
  ["0", "turning start"],
  ["space", "turning turn on"],
];

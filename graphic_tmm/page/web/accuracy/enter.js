import { ROOMS } from "../rooms.js";
import { accuracyRoom } from "./room.js";

ROOMS["accuracy"] = accuracyRoom;

import { LENGTHS } from "../lengths.js";
import { begunLengths } from "./own-lengths.js";

LENGTHS.begin = begunLengths;

import { openedPhoto } from "../../../page/web/own/photo.js";

/**
 * What a person has done on a scheme, kept while the page is loaded anew: the acts that can be taken back in the memory
 * of the tab, the picture below, which is too large for that, in the browser's data base. What was taken back over
 * another text than the file has now is forgotten.
 *
 * @typedef {import("./editor.js").Editor} Editor
 * @typedef {import("./editor.js").Moment} Moment
 * @typedef {Omit<Moment, "answer"> & {at: number | null, whole: boolean}} KeptMoment
 * @typedef {{text: string, sketch: Moment["sketch"], origin: [number, number], measured: boolean, past: KeptMoment[], future: KeptMoment[],
 *   picture: {at: [number, number], dot: number, pale: string} | null}} Kept
 */

const BASE = "graphic-tmm";
const PICTURES = "pictures";
const KIND = "image/jpeg";
const QUALITY = 0.92;

export class Memory {
  /**
   * @param {Editor} editor
   * @param {string} place of the scene, by which it is kept
   */
  constructor(editor, place = location.pathname) {
    this.editor = editor;
    this.place = place;
    this.recalled = false;
    editor.picture.kept = () => void this.keepPicture(this.place);
    window.addEventListener("pagehide", () => this.keep());
  }

  /**
   * Keep all of it; under another place, if the scene has one by now.
   * @param {string} place
   */
  keep(place = this.place) {
    if (!this.recalled) return;
    const { editor } = this;
    const { text, sketch, origin, measured, picture } = editor;
    const { past, future } = editor.history;
    const lies = picture.image === null ? null : { at: picture.at, dot: picture.dot, pale: picture.pale.value };
    for (let most = past.length; ; most = Math.floor(most / 2)) {
      /** @type {Kept} */
      const kept = { text, sketch, origin, measured, past: past.slice(past.length - most).map(slim), future: future.map(slim), picture: lies };
      try {
        sessionStorage.setItem(nameOf(place), JSON.stringify(kept));
        return;
      } catch {
        // there is no room for so many, or for any
        if (most === 0) return;
      }
    }
  }

  /** Take up what was kept, when the scheme is there. */
  async recall() {
    const { editor } = this;
    if (this.recalled || editor.answer === null) return;
    this.recalled = true;
    const kept = this.kept();
    if (kept === null) return;
    const same = kept.text === editor.text && (editor.text !== "" || JSON.stringify(kept.sketch) === JSON.stringify(editor.sketch));
    if (same && editor.history.past.length === 0) {
      editor.history.past = kept.past.map(whole);
      editor.history.future = kept.future.map(whole);
      editor.measured = kept.measured;
    }
    // an origin that was put elsewhere meanwhile is of a mechanism that began here
    if (same) editor.origin = [kept.origin[0] + editor.origin[0], kept.origin[1] + editor.origin[1]];
    editor.bar.show();
    if (kept.picture !== null) await this.recallPicture(kept.picture);
  }

  /** @returns {Kept | null} */
  kept() {
    try {
      return JSON.parse(sessionStorage.getItem(nameOf(this.place)) ?? "null");
    } catch {
      return null;
    }
  }

  /** @param {NonNullable<Kept["picture"]>} lies */
  async recallPicture(lies) {
    const { picture } = this.editor;
    const blob = await inBase((store) => store.get(this.place));
    if (!(blob instanceof Blob) || picture.image !== null) return;
    const opened = await openedPhoto(new File([blob], PICTURES));
    if (typeof opened === "string" || picture.image !== null) return;
    picture.at = lies.at;
    picture.dot = lies.dot;
    picture.pale.value = lies.pale;
    picture.show(opened.image);
  }

  /**
   * Keep the picture that lies below, or that there is none.
   * @param {string} place
   */
  async keepPicture(place) {
    const { canvas } = this.editor.picture;
    const blob = canvas === null ? null : await new Promise((done) => canvas.toBlob(done, KIND, QUALITY));
    await inBase((store) => (blob === null ? store.delete(place) : store.put(blob, place)), "readwrite");
  }

  /**
   * Keep all of it for the scene that was made of it.
   * @param {string} place of that
   */
  async moveTo(place) {
    await this.keepPicture(place);
    await inBase((store) => store.delete(this.place), "readwrite");
    this.keep(place);
    sessionStorage.removeItem(nameOf(this.place));
    this.recalled = false;
  }
}

/** @param {string} place */
function nameOf(place) {
  return `scheme ${place}`;
}

/**
 * What is needed to come back to a moment: what is known of it is asked for again then.
 * @param {Moment} moment
 * @returns {KeptMoment}
 */
function slim({ sketch, text, answer, measured, origin }) {
  return { sketch, text, measured, origin, at: answer?.at ?? null, whole: answer !== null && answer.text !== null };
}

/**
 * @param {KeptMoment} kept
 * @returns {Moment}
 */
function whole({ sketch, text, measured, origin, at, whole: all }) {
  const nothing = { version: "", mobility: null, formula: "", says: "", sweep: null, loads: [], fields: [], sections: [], errors: [], turn: null };
  const shift = /** @type {[number, number]} */ ([0, 0]);
  return { sketch, text, measured, origin, answer: { ...nothing, sketch, at, text: all ? text : null, shift } };
}

/**
 * Return what comes of asking the data base; undefined if there is none.
 * @param {(store: IDBObjectStore) => IDBRequest} ask
 * @param {IDBTransactionMode} mode
 * @returns {Promise<unknown>}
 */
function inBase(ask, mode = "readonly") {
  return new Promise((done) => {
    const none = () => done(undefined);
    try {
      const opening = indexedDB.open(BASE, 1);
      opening.addEventListener("upgradeneeded", () => opening.result.createObjectStore(PICTURES));
      opening.addEventListener("error", none);
      opening.addEventListener("success", () => {
        const base = opening.result;
        const change = base.transaction(PICTURES, mode);
        const asked = ask(change.objectStore(PICTURES));
        change.addEventListener("complete", () => {
          base.close();
          done(asked.result);
        });
        change.addEventListener("abort", none);
      });
    } catch {
      // a browser may keep nothing
      none();
    }
  });
}

/** @typedef {import("./types.js").Data} Data */

/**
 * Return the bytes that an element of the page carries: base64 of gzip.
 * @param {string} id
 * @returns {Promise<ArrayBuffer>}
 */
export async function bytesOf(id) {
  const text = document.getElementById(id)?.textContent ?? "";
  const packed = Uint8Array.from(atob(text.trim()), (sign) => sign.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
  return new Response(stream).arrayBuffer();
}

/**
 * Return what Python packed for the page.
 * @returns {Promise<Data>}
 */
export async function packedData() {
  return JSON.parse(new TextDecoder().decode(await bytesOf("data")));
}

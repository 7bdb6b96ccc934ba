/**
 * Return the rows that Python packed: second differences, their sign in the last bit, four byte planes.
 * @param {ArrayBuffer} bytes
 * @param {number[]} lengths
 * @returns {Int32Array[]}
 */
export function unpackedRows(bytes, lengths) {
  const planes = new Uint8Array(bytes);
  const count = planes.length / 4;
  let begun = 0;
  return lengths.map((length) => {
    const row = new Int32Array(length);
    let step = 0;
    let value = 0;
    for (let k = 0; k < length; k++, begun++) {
      const low = (planes[begun] ?? 0) + ((planes[begun + count] ?? 0) << 8);
      const high = (planes[begun + 2 * count] ?? 0) + (planes[begun + 3 * count] ?? 0) * 256;
      const told = low + high * 65536;
      step += told % 2 === 0 ? told / 2 : -(told + 1) / 2;
      value += step;
      row[k] = value;
    }
    return row;
  });
}

// The arrays that the page holds, as the library wrote them (io/viewer_writer).

/** The bytes behind base64 text. */
function decodeBase64(text) {
  if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
  const padding = text.endsWith("==") ? 2 : text.endsWith("=") ? 1 : 0;
  const bytes = new Uint8Array((text.length / 4) * 3 - padding);
  const kPiece = 1 << 20; // characters at a time, a multiple of four
  for (let from = 0, to = 0; from < text.length; from += kPiece) {
    const piece = atob(text.substring(from, from + kPiece));
    for (let i = 0; i < piece.length; ++i) bytes[to++] = piece.charCodeAt(i);
  }
  return bytes;
}

/** The bytes in the element `id`, which then gives its text back to the memory. */
function takeBytes(id) {
  const element = document.getElementById(id + "-data");
  const bytes = decodeBase64(element.textContent);
  element.remove();
  return bytes;
}

/** Integers of 32 bits, told as differences in groups of seven bits. */
function takeIntegers(id) {
  const bytes = takeBytes(id);
  let count = 0;
  for (let i = 0; i < bytes.length; ++i) count += bytes[i] < 0x80 ? 1 : 0;
  const integers = new Uint32Array(count);
  for (let i = 0, at = 0, last = 0; i < count; ++i) {
    let told = 0;
    let shift = 0;
    for (; bytes[at] >= 0x80; shift += 7) told |= (bytes[at++] & 0x7f) << shift;
    told |= bytes[at++] << shift;
    last = (last + ((told >>> 1) ^ -(told & 1))) | 0;
    integers[i] = last;
  }
  return integers;
}

/**
 * All that is to be shown. Vertices are numbered through the points, then the hidden ones; a triangle
 * is on the surface after the steps from `born` to before `died`.
 */
function takeScene() {
  const sizes = JSON.parse(document.getElementById("sizes").textContent);
  const positions = new Float32Array(takeBytes("positions").buffer);
  return {
    steps: sizes.steps,
    hiddenCount: sizes.hidden,
    pointCount: positions.length / 3 - sizes.hidden,
    positions,
    triangles: takeIntegers("triangles"),
    born: takeIntegers("born"),
    died: takeIntegers("died"),
    emst: takeIntegers("emst"),
    egh: takeIntegers("egh"),
  };
}

/** The largest distance of a vertex from the origin; 1 where there is none. */
function radiusOf({ positions: p }) {
  let largest = 0;
  for (let i = 0; i < p.length; i += 3) {
    largest = Math.max(largest, p[i] * p[i] + p[i + 1] * p[i + 1] + p[i + 2] * p[i + 2]);
  }
  return Math.sqrt(largest) || 1;
}

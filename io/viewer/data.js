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

/** The array in the element `id`, which then gives its text back to the memory. */
function takeArray(id, Type) {
  const element = document.getElementById(id + "-data");
  const array = new Type(decodeBase64(element.textContent).buffer);
  element.remove();
  return array;
}

/**
 * All that is to be shown. Vertices are numbered through the points, then the hidden ones; a triangle
 * is on the surface after the steps from `born` to before `died`.
 */
function takeScene() {
  const sizes = JSON.parse(document.getElementById("sizes").textContent);
  const positions = takeArray("positions", Float32Array);
  return {
    steps: sizes.steps,
    hiddenCount: sizes.hidden,
    pointCount: positions.length / 3 - sizes.hidden,
    positions,
    triangles: takeArray("triangles", Uint32Array),
    born: takeArray("born", Uint32Array),
    died: takeArray("died", Uint32Array),
    emst: takeArray("emst", Uint32Array),
    egh: takeArray("egh", Uint32Array),
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

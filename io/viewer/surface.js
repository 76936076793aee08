// The surface after a step of the sculpting: which of the recorded triangles it has.

class Surface {
  constructor(scene) {
    this.positions = scene.positions;
    this.triangles = scene.triangles;
    this.born = scene.born;
    this.died = scene.died;
    this.indices = new Uint32Array(3 * mostAtOnce(scene));
    this.normals = new Float32Array(scene.positions.length);
    this.count = 0; // triangles now
  }

  /** Makes `indices` and `normals` those of the surface after `step`. */
  showStep(step) {
    const { born, died, triangles, indices } = this;
    let end = 0;
    for (let t = 0, at = 0; t < born.length; ++t, at += 3) {
      if (born[t] > step || died[t] <= step) continue;
      indices[end] = triangles[at];
      indices[end + 1] = triangles[at + 1];
      indices[end + 2] = triangles[at + 2];
      end += 3;
    }
    this.count = end / 3;
    this.sumNormals();
  }

  corners() {
    return this.indices.subarray(0, 3 * this.count);
  }

  /** Per vertex the sum of its triangles' normals, by area. */
  sumNormals() {
    const { indices, normals: n, positions: p } = this;
    n.fill(0);
    for (let k = 0; k < 3 * this.count; k += 3) {
      const a = 3 * indices[k];
      const b = 3 * indices[k + 1];
      const c = 3 * indices[k + 2];
      const ux = p[b] - p[a], uy = p[b + 1] - p[a + 1], uz = p[b + 2] - p[a + 2];
      const vx = p[c] - p[a], vy = p[c + 1] - p[a + 1], vz = p[c + 2] - p[a + 2];
      const x = uy * vz - uz * vy;
      const y = uz * vx - ux * vz;
      const z = ux * vy - uy * vx;
      n[a] += x, n[a + 1] += y, n[a + 2] += z;
      n[b] += x, n[b + 1] += y, n[b + 2] += z;
      n[c] += x, n[c + 1] += y, n[c + 2] += z;
    }
  }

  /** The edges as pairs of vertices. Each belongs to two triangles, which run through it both ways. */
  edges() {
    const { indices } = this;
    const edges = new Uint32Array(3 * this.count);
    let end = 0;
    for (let k = 0; k < 3 * this.count && end < edges.length; ++k) {
      const a = indices[k];
      const b = indices[k % 3 === 2 ? k - 2 : k + 1];
      if (a > b) continue;
      edges[end++] = a;
      edges[end++] = b;
    }
    return edges.subarray(0, end);
  }
}

/** The largest number of triangles that the surface has after any step. */
function mostAtOnce({ steps, born, died }) {
  const change = new Int32Array(steps + 2);
  for (let t = 0; t < born.length; ++t) {
    ++change[born[t]];
    if (died[t] <= steps) --change[died[t]];
  }
  let now = 0;
  return change.reduce((most, c) => Math.max(most, (now += c)), 0);
}

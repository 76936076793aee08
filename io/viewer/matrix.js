// Rotations as unit quaternions [x, y, z, w]; matrices in columns, as WebGL takes them.

function quaternionProduct([ax, ay, az, aw], [bx, by, bz, bw]) {
  return [
    aw * bx + ax * bw + ay * bz - az * by,
    aw * by - ax * bz + ay * bw + az * bx,
    aw * bz + ax * by - ay * bx + az * bw,
    aw * bw - ax * bx - ay * by - az * bz,
  ];
}

function normalized(q) {
  const length = Math.hypot(...q);
  return q.map((x) => x / length);
}

/** The turn by `angle` around an axis of length one. */
function turnAround([x, y, z], angle) {
  const s = Math.sin(angle / 2);
  return [x * s, y * s, z * s, Math.cos(angle / 2)];
}

/** First the rotation, then the translation. */
function rigidMatrix([x, y, z, w], [tx, ty, tz]) {
  return new Float32Array([
    1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w), 0,
    2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w), 0,
    2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y), 0,
    tx, ty, tz, 1,
  ]);
}

/** `scale` is the cotangent of half the field of view, per axis of the picture. */
function perspectiveMatrix([scaleX, scaleY], near, far) {
  const depth = near - far;
  return new Float32Array([
    scaleX, 0, 0, 0,
    0, scaleY, 0, 0,
    0, 0, (far + near) / depth, -1,
    0, 0, (2 * far * near) / depth, 0,
  ]);
}

// From where the scene is seen.

const kFieldOfView = (30 * Math.PI) / 180; // of the smaller side of the window
const kMargin = 1.1; // the window's share of the scene at first
const kNearestEye = 0.02; // in radii of the scene, as the next
const kFarthestEye = 60;
const kReach = 1.02; // how far around its middle the scene is shown

class Camera {
  /** The scene lies in the ball of this radius around the origin. */
  constructor(radius) {
    this.radius = radius;
    this.width = 1;
    this.height = 1;
    this.reset();
  }

  reset() {
    this.rotation = [0, 0, 0, 1];
    this.pan = [0, 0]; // where the middle of the scene is, in the plane through it
    this.distance = (kMargin * this.radius) / Math.sin(kFieldOfView / 2);
  }

  /** The size of the window, in any unit; all pixels below are in the same one. */
  resize(width, height) {
    this.width = Math.max(1, width);
    this.height = Math.max(1, height);
  }

  /** Pixels per unit of length, one unit from the eye. */
  focalLength() {
    return Math.min(this.width, this.height) / 2 / Math.tan(kFieldOfView / 2);
  }

  /** Turns what is seen as a ball under the pointer would turn. */
  turn(dx, dy) {
    const pixels = Math.hypot(dx, dy);
    if (pixels === 0) return;
    const angle = (pixels / Math.min(this.width, this.height)) * Math.PI;
    const turn = turnAround([dy / pixels, dx / pixels, 0], angle);
    this.rotation = normalized(quaternionProduct(turn, this.rotation));
  }

  /** Moves what is seen by pixels, to the right and down. */
  move(dx, dy) {
    const covered = this.distance / this.focalLength(); // by a pixel
    this.panBy(dx * covered, -dy * covered);
  }

  panBy(x, y) {
    const bounded = (p) => Math.min(3, Math.max(-3, p));
    this.pan = [bounded(this.pan[0] + x), bounded(this.pan[1] + y)];
  }

  /** Makes what is seen larger by `factor`; what is at (x, y), from the upper left, stays there. */
  zoom(factor, x = this.width / 2, y = this.height / 2) {
    const before = this.distance / this.focalLength();
    const [nearest, farthest] = [kNearestEye * this.radius, kFarthestEye * this.radius];
    this.distance = Math.min(farthest, Math.max(nearest, this.distance / factor));
    const growth = this.distance / this.focalLength() - before; // of what a pixel covers
    this.panBy((x - this.width / 2) * growth, (this.height / 2 - y) * growth);
  }

  view() {
    return rigidMatrix(this.rotation, [...this.pan, -this.distance]);
  }

  /** Whether the whole scene lies before the eye and beyond what is cut off near it. */
  isOutside() {
    return this.distance > kReach * this.radius;
  }

  projection() {
    const scale = [(2 * this.focalLength()) / this.width, (2 * this.focalLength()) / this.height];
    // The plane through the middle stays at this distance, wherever the scene is moved in it.
    const reach = kReach * this.radius;
    const near = Math.max(this.distance - reach, 0.02 * this.distance);
    return perspectiveMatrix(scale, near, this.distance + reach);
  }
}

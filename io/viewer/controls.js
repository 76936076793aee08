// Mouse, touch and keys.

const kZoomPerPixel = 0.0015; // of the wheel
const kKeyTurn = 24; // pixels of a drag
const kKeyZoom = 1.15;

/** Turning, moving and zooming on the canvas; calls `changed` after each. */
function controlCamera(canvas, camera, changed) {
  const pointers = new Map();

  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    pointers.set(event.pointerId, event);
  });
  for (const end of ["pointerup", "pointercancel"]) {
    canvas.addEventListener(end, (event) => pointers.delete(event.pointerId));
  }
  canvas.addEventListener("pointermove", (event) => {
    const before = pointers.get(event.pointerId);
    if (!before) return;
    if (pointers.size === 2) {
      const still = [...pointers.values()].find((p) => p.pointerId !== event.pointerId);
      pinch(camera, still, before, event);
    } else {
      drag(camera, before, event);
    }
    pointers.set(event.pointerId, event);
    changed();
  });
  canvas.addEventListener("contextmenu", (event) => event.preventDefault());
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      const lines = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 20 : 1;
      const factor = Math.exp(-event.deltaY * lines * kZoomPerPixel);
      camera.zoom(factor, event.offsetX, event.offsetY);
      changed();
    },
    { passive: false },
  );
}

function drag(camera, before, now) {
  const dx = now.clientX - before.clientX;
  const dy = now.clientY - before.clientY;
  const kOtherButtons = 2 | 4; // right, middle
  if (now.buttons & kOtherButtons || now.shiftKey) camera.move(dx, dy);
  else camera.turn(dx, dy);
}

/** One of two fingers has moved. */
function pinch(camera, still, before, now) {
  const apart = (p) => Math.hypot(p.clientX - still.clientX, p.clientY - still.clientY);
  camera.move((now.clientX - before.clientX) / 2, (now.clientY - before.clientY) / 2);
  if (apart(before) < 1 || apart(now) < 1) return;
  const x = (now.clientX + still.clientX) / 2;
  const y = (now.clientY + still.clientY) / 2;
  camera.zoom(apart(now) / apart(before), x, y);
}

/** Keys that turn and zoom; true if it was one of them. */
function turnByKey(key, camera) {
  const turns = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
  if (key in turns) camera.turn(...turns[key].map((d) => d * kKeyTurn));
  else if (key === "+" || key === "=") camera.zoom(kKeyZoom);
  else if (key === "-") camera.zoom(1 / kKeyZoom);
  else if (key === "r" || key === "R") camera.reset();
  else return false;
  return true;
}

/**
 * Keys for the whole page, unless they belong to the control that has the focus: arrows move the
 * slider, space presses buttons.
 */
function controlByKeys(camera, switches, timeline, changed) {
  document.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const { tagName } = event.target;
    const control = ["INPUT", "BUTTON", "SUMMARY"].includes(tagName);
    if (control && (event.key === " " || event.key.startsWith("Arrow"))) return;
    if (event.key >= "1" && event.key <= String(switches.length)) {
      switches[event.key - 1].click();
    } else if (event.key === " ") {
      timeline.toggle();
    } else if (event.key === ",") {
      timeline.goTo(timeline.step - 1);
    } else if (event.key === ".") {
      timeline.goTo(timeline.step + 1);
    } else if (turnByKey(event.key, camera)) {
      changed();
    } else {
      return;
    }
    event.preventDefault();
  });
}

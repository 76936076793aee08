// Puts the page together.

const kLayers = ["surface", "wireframe", "points", "emst", "egh", "hidden", "smooth"];

/** Shows a line in the middle of the page; none takes it away. */
function say(text) {
  const message = document.getElementById("message");
  message.hidden = !text;
  message.textContent = text ?? "";
}

/** The canvas has as many pixels as the screen has under it. */
function fitCanvas(canvas, camera, changed) {
  const fit = () => {
    const ratio = Math.min(2, window.devicePixelRatio || 1);
    camera.resize(canvas.clientWidth, canvas.clientHeight);
    canvas.width = Math.round(camera.width * ratio);
    canvas.height = Math.round(camera.height * ratio);
    changed();
  };
  new ResizeObserver(fit).observe(canvas);
  fit();
}

/** Writes how many there are of each, and disables what there is none of. */
function setUpSwitches(switches, counts, changed) {
  for (const box of switches) {
    box.addEventListener("change", changed);
    const label = box.parentElement;
    if (box.id in kColours) label.querySelector("i").style.background = `rgb(${kColours[box.id]})`;
    if (!(box.id in counts)) continue;
    box.disabled = counts[box.id] === 0;
    label.classList.toggle("none", box.disabled);
    label.querySelector("output").textContent = counts[box.id].toLocaleString("en");
  }
}

function start() {
  // Where the panel would cover the scene, it is folded at first.
  document.querySelector("details").open = !window.matchMedia("(max-width: 640px)").matches;
  const canvas = document.getElementById("view");
  const switches = kLayers.map((id) => document.getElementById(id));
  const scene = takeScene();
  const surface = new Surface(scene);
  const camera = new Camera(radiusOf(scene));
  const renderer = new Renderer(canvas, scene, surface);
  const changed = onceAFrame(() => {
    const shown = Object.fromEntries(switches.map((box) => [box.id, box.checked]));
    renderer.draw(camera, shown);
  });
  const timeline = new Timeline(scene.steps, (step) => {
    surface.showStep(step);
    renderer.takeSurface();
    changed();
    return surface.count;
  });
  const counts = {
    surface: surface.count,
    wireframe: (3 * surface.count) / 2,
    points: scene.pointCount,
    emst: scene.emst.length / 2,
    egh: scene.egh.length / 3,
    hidden: scene.hiddenCount,
  };
  setUpSwitches(switches, counts, changed);
  controlCamera(canvas, camera, changed);
  controlByKeys(camera, switches, timeline, changed);
  canvas.addEventListener("webglcontextlost", (event) => event.preventDefault());
  canvas.addEventListener("webglcontextrestored", () => {
    renderer.setUp();
    changed();
  });
  fitCanvas(canvas, camera, changed);
}

// After the first picture of the page, which says that it loads.
requestAnimationFrame(() =>
  setTimeout(() => {
    try {
      start();
      say(null);
    } catch (error) {
      say(error.message);
      console.error(error);
    }
  }),
);

// The slider through the steps of the sculpting, and its buttons.

const kSecondsToPlay = 12;

/** Calls `work` once when the next frame comes, however often it is asked to. */
function onceAFrame(work) {
  let asked = false;
  return () => {
    if (asked) return;
    asked = true;
    requestAnimationFrame(() => {
      asked = false;
      work();
    });
  };
}

class Timeline {
  /**
   * Calls `show(step)`, which returns the surface's triangles, where another step is to be seen: the
   * last one at once, later ones when the next frame comes, however far the slider has gone by then.
   */
  constructor(steps, show) {
    this.steps = steps;
    this.step = steps;
    this.showSoon = onceAFrame(() => this.tellPlace(show(this.step)));
    this.slider = document.getElementById("step");
    this.place = document.getElementById("place");
    this.playButton = document.getElementById("play");
    this.slider.max = steps;
    this.slider.addEventListener("input", () => this.goTo(Number(this.slider.value)));
    this.playButton.addEventListener("click", () => this.toggle());
    document.getElementById("back").addEventListener("click", () => this.goTo(this.step - 1));
    document.getElementById("next").addEventListener("click", () => this.goTo(this.step + 1));
    document.getElementById("timeline").hidden = steps === 0;
    this.slider.value = steps;
    this.tellPlace(show(steps));
  }

  /** Stops what plays and goes to a step. */
  goTo(step) {
    this.stop();
    this.set(step);
  }

  set(step) {
    const bounded = Math.min(this.steps, Math.max(0, step));
    if (bounded === this.step) return;
    this.step = bounded;
    this.slider.value = bounded;
    this.showSoon();
  }

  tellPlace(triangles) {
    const text =
      `step ${this.step.toLocaleString("en")} of ${this.steps.toLocaleString("en")}, ` +
      `${triangles.toLocaleString("en")} triangles`;
    this.place.textContent = text;
    this.slider.setAttribute("aria-valuetext", text);
  }

  toggle() {
    if (this.frame) this.stop();
    else this.play();
  }

  /** From the step that is seen, from the start if that is the last one. */
  play() {
    if (this.steps === 0) return;
    if (this.step === this.steps) this.set(0);
    const first = this.step;
    let start = null;
    const advance = (now) => {
      start ??= now;
      const done = ((now - start) / 1000 / kSecondsToPlay) * this.steps;
      this.frame = requestAnimationFrame(advance);
      this.set(Math.floor(first + done));
      if (this.step === this.steps) this.stop();
    };
    this.frame = requestAnimationFrame(advance);
    this.tell(true);
  }

  stop() {
    if (!this.frame) return;
    cancelAnimationFrame(this.frame);
    this.frame = null;
    this.tell(false);
  }

  tell(playing) {
    this.playButton.setAttribute("aria-pressed", String(playing));
    this.playButton.setAttribute("aria-label", playing ? "Pause" : "Play the sculpting");
  }
}

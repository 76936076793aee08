// The slider through the steps of the sculpting, and its buttons.

const kSecondsToPlay = 12;

class Timeline {
  /** Calls `show(step)` whenever another step is to be seen; it returns the surface's triangles. */
  constructor(steps, show) {
    this.steps = steps;
    this.show = show;
    this.slider = document.getElementById("step");
    this.place = document.getElementById("place");
    this.playButton = document.getElementById("play");
    this.slider.max = steps;
    this.slider.addEventListener("input", () => this.goTo(Number(this.slider.value)));
    this.playButton.addEventListener("click", () => this.toggle());
    document.getElementById("back").addEventListener("click", () => this.goTo(this.step - 1));
    document.getElementById("next").addEventListener("click", () => this.goTo(this.step + 1));
    document.getElementById("timeline").hidden = steps === 0;
    this.goTo(steps);
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
    const triangles = this.show(bounded);
    this.slider.value = bounded;
    const text =
      `step ${bounded.toLocaleString("en")} of ${this.steps.toLocaleString("en")}, ` +
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

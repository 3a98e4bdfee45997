
"use strict";
const msPerFrame = 120;
for (const film of document.querySelectorAll(".film")) {
  const frame = film.querySelector(".film-frame");
  const controls = film.nextElementSibling;
  const [button, slider, output] = controls.children;
  const positions = film.dataset.positions.split(" "), labels = film.dataset.labels.split("|");
  let timer;
  const show = (number) => {
    slider.value = number;
    frame.style.backgroundPositionY = positions[number] + "%";
    output.value = labels[number];
    slider.setAttribute("aria-valuetext", labels[number]);
  };
  const stop = () => {
    clearInterval(timer);
    timer = undefined;
    button.textContent = "Play";
  };
  const play = () => {
    timer = setInterval(() => show((Number(slider.value) + 1) % positions.length), msPerFrame);
    button.textContent = "Pause";
  };
  button.addEventListener("click", () => (timer ? stop() : play()));
  slider.addEventListener("input", () => {
    stop();
    show(Number(slider.value));
  });
  controls.hidden = false;
}

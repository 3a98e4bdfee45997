"use strict";
const msPerFrame = 120;
for (const film of document.querySelectorAll(".film")) {
  const [button, slider, output] = film.querySelector(".film-controls").children;
  const cursor = film.querySelector(".film-cursor"), missing = film.querySelectorAll(".film-missing");
  const labels = film.dataset.labels.split("|"), places = film.dataset.cursor.split(" ");
  const poster = Number(slider.defaultValue);
  let timer, isPlayed = false;
  const show = (number) => {
    slider.value = number;
    film.style.setProperty("--row", `${(100 * number) / Math.max(1, labels.length - 1)}%`);
    for (const end of ["x1", "x2"]) cursor.setAttribute(end, places[number]);
    for (const note of missing) note.hidden = !note.dataset.moments.split(" ").includes(String(number));
    output.value = labels[number];
    slider.setAttribute("aria-valuetext", labels[number]);
  };
  const stop = () => {
    clearInterval(timer);
    timer = undefined;
    button.textContent = "Play";
  };
  const play = () => {
    if (!isPlayed) show(0);
    isPlayed = true;
    timer = setInterval(() => show((Number(slider.value) + 1) % labels.length), msPerFrame);
    button.textContent = "Pause";
  };
  button.addEventListener("click", () => (timer ? stop() : play()));
  slider.addEventListener("input", () => {
    stop();
    isPlayed = true;
    show(Number(slider.value));
  });
  let shown = poster;
  addEventListener("beforeprint", () => {
    stop();
    shown = Number(slider.value);
    show(poster);
  });
  addEventListener("afterprint", () => show(shown));
  button.hidden = slider.hidden = false;
}

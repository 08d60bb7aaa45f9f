// SPDX-License-Identifier: MIT
// Reads the figure of the front page: the slider and the pointer choose a frequency, and the legend shows the amplitudes there.
const limits = document.getElementById("limits");
const values = JSON.parse(limits.dataset.rows);
const reader = document.getElementById("reader");
const slider = document.getElementById("frequency");

function read() {
  const [hz, ...amplitudes] = values[slider.value];
  reader.querySelector("output").textContent = `${hz} Hz`;
  slider.setAttribute("aria-valuetext", `${hz} Hz`);
  document.getElementById("cursor").setAttribute("transform", `translate(${46 + 3.61 * (hz - 2)})`);
  document.querySelectorAll(".legend strong").forEach((place, curve) => { place.textContent = `${amplitudes[curve].toPrecision(3)} mm`; });
}

for (const kind of ["pointermove", "pointerdown"])
  limits.addEventListener(kind, (event) => {
    const box = limits.getBoundingClientRect();
    slider.value = Math.round(slider.max * ((event.clientX - box.left) / box.width * 516 - 70) / 426);
    read();
  });
slider.addEventListener("input", read);
slider.value = values.findIndex(([hz]) => hz >= 35);
reader.hidden = false;
read();

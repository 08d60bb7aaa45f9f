// SPDX-License-Identifier: MIT
// Reads the figure of the front page: slider and pointer choose a frequency, and the legend shows the amplitudes there, [Hz, mm, ...].
const limits = document.getElementById("limits");
const rows = JSON.parse(limits.dataset.rows);
const slider = document.getElementById("frequency");

function read() {
  const [hz, ...amplitudes] = rows[slider.value];
  slider.nextElementSibling.textContent = `${hz} Hz`;
  slider.setAttribute("aria-valuetext", `${hz} Hz`);
  document.getElementById("cursor").setAttribute("transform", `translate(${46 + 426 * slider.value / slider.max})`);
  document.querySelectorAll(".legend strong").forEach((place, curve) => { place.textContent = `${amplitudes[curve].toPrecision(3)} mm`; });
}

function point(event) {
  const { left, width } = limits.getBoundingClientRect();
  slider.value = Math.round(slider.max * ((event.clientX - left) / width * 516 - 70) / 426);
  read();
}

limits.addEventListener("pointermove", point);
limits.addEventListener("pointerdown", point);
slider.addEventListener("input", read);
slider.value = rows.findIndex(([hz]) => hz >= 35);
slider.parentElement.hidden = false;
read();

// SPDX-License-Identifier: MIT
// Search and sorting of the table of a page. Without this script the whole table is shown.
"use strict";

const table = document.querySelector("table[role]");
const body = table.tBodies[0];
const rows = [...body.rows];
const query = document.getElementById("query");
const address = new URLSearchParams(location.search);
const column = [...table.tHead.rows[0].cells].findIndex((cell) => cell.textContent.trim() === address.get("column"));

// A row stays if it has all the words. A query of the address may be the whole content of one column.
function isFound(row, words) {
  if (column >= 0 && query.value === address.get("q")) return row.cells[column].textContent.trim() === query.value;
  const text = row.textContent.toLowerCase();
  return words.every((word) => text.includes(word));
}

function search() {
  const words = query.value.toLowerCase().split(/\s+/).filter(Boolean);
  let count = 0;
  for (const row of rows) {
    row.hidden = !isFound(row, words);
    count += row.hidden ? 0 : 1;
  }
  document.getElementById("count").textContent = `${count} of ${rows.length} rows`;
}

// Numbers by value, other cells by text. Empty cells come last in either direction.
function compare(a, b, direction) {
  const [left, right] = [a, b].map((cell) => cell.textContent.trim());
  if (!left || !right) return (left ? 0 : 1) - (right ? 0 : 1);
  const isNumber = a.dataset.value !== undefined && b.dataset.value !== undefined;
  return direction * (isNumber ? a.dataset.value - b.dataset.value : left.localeCompare(right, "en", { numeric: true }));
}

for (const [index, head] of [...table.tHead.rows[0].cells].entries()) {
  head.querySelector("button").addEventListener("click", () => {
    const isAscending = head.getAttribute("aria-sort") !== "ascending";
    for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
    head.setAttribute("aria-sort", isAscending ? "ascending" : "descending");
    rows.sort((a, b) => compare(a.cells[index], b.cells[index], isAscending ? 1 : -1));
    body.append(...rows);
  });
}

query.value = address.get("q") ?? "";
query.addEventListener("input", search);
query.form.addEventListener("submit", (event) => event.preventDefault());
search();

// Folded rows are shown when an address names one of them.
function unfold() {
  const folded = table.closest("details");
  if (folded && (address.has("q") || location.hash)) folded.open = true;
  document.getElementById(location.hash.slice(1))?.scrollIntoView();
}
addEventListener("hashchange", unfold);
unfold();

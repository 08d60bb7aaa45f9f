// SPDX-License-Identifier: MIT
// Search over all pages: the rows and sentences that have all the words; Enter goes to the first. site.py writes the index,
// [page, address, words], above.
const find = document.getElementById("find");
const everywhere = document.getElementById("everywhere");
everywhere.addEventListener("input", () => {
  const words = everywhere.value.toLowerCase().split(/\s+/).filter(Boolean);
  const hits = words.length ? index.filter(([page, , text]) => words.every((word) => `${page} ${text}`.toLowerCase().includes(word))) : [];
  document.getElementById("hits").textContent = words.length ? `${hits.length} found${hits.length > 20 ? ", the first 20" : ""}` : "";
  document.getElementById("found").replaceChildren(...hits.slice(0, 20).map(([page, address, text]) => {
    const link = document.createElement("a");
    link.href = find.dataset.root + address;
    link.textContent = `${page}: ${text.slice(0, 160)}`;
    const item = document.createElement("li");
    item.append(link);
    return item;
  }));
});
find.addEventListener("submit", (event) => {
  event.preventDefault();
  document.querySelector("#found a")?.click();
});
find.hidden = false;

// Sorts tables by a click on their heads, and opens what a link leads to. Without it the page only moves less.
function key(row, column) {
  const cell = row.cells[column], held = cell.querySelector("data");
  return held ? Number(held.value) : cell.textContent.trim();
}
function compare(a, b) {
  if (typeof a === "number") return typeof b === "number" ? a - b : -1;
  return typeof b === "number" ? 1 : a.localeCompare(b, "en", {numeric: true});
}
document.querySelectorAll("table.sortable").forEach(table => {
  table.querySelectorAll("thead th").forEach((head, column) => {
    const button = document.createElement("button");
    button.append(...head.childNodes);
    head.append(button);
    button.addEventListener("click", () => {
      const way = head.getAttribute("aria-sort") === "ascending" ? -1 : 1, body = table.tBodies[0];
      table.querySelectorAll("th").forEach(other => other.removeAttribute("aria-sort"));
      head.setAttribute("aria-sort", way === 1 ? "ascending" : "descending");
      body.append(...Array.from(body.rows).sort((a, b) => way * compare(key(a, column), key(b, column))));
    });
  });
});
function openTarget() {
  const name = decodeURIComponent(location.hash.slice(1)), target = name ? document.getElementById(name) : null;
  if (!target) return;
  for (let box = target.closest("details"); box; box = box.parentElement.closest("details")) box.open = true;
  target.scrollIntoView();
}
addEventListener("hashchange", openTarget);
openTarget();

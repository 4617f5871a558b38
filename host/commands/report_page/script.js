"use strict";

// "1.52x" and "97.0 100.0" sort by their first number, "-" comes last, names sort as text.
function compareCells(a, b) {
  const x = parseFloat(a), y = parseFloat(b);
  if (!Number.isNaN(x) && !Number.isNaN(y)) return x - y;
  if (Number.isNaN(x) !== Number.isNaN(y)) return Number.isNaN(x) ? 1 : -1;
  return a.localeCompare(b, undefined, { numeric: true });
}

function sortBy(heading) {
  const table = heading.closest("table");
  const column = heading.cellIndex;
  const direction = heading.getAttribute("aria-sort") === "ascending" ? -1 : 1;
  const text = row => (row.cells[column] ? row.cells[column].textContent : "");
  const body = table.tBodies[0];
  const rows = Array.from(body.rows).sort((a, b) => direction * compareCells(text(a), text(b)));
  body.append(...rows);
  for (const other of table.tHead.rows[0].cells) other.removeAttribute("aria-sort");
  heading.setAttribute("aria-sort", direction > 0 ? "ascending" : "descending");
}

function setUpView(view) {
  const stage = view.querySelector(".stage");
  const split = view.querySelector(".split");
  const moveLine = () => stage.style.setProperty("--split", split.value + "%");
  split.addEventListener("input", moveLine);
  const follow = event => {
    const box = stage.getBoundingClientRect();
    split.value = (100 * (event.clientX - box.left)) / box.width;
    moveLine();
  };
  stage.addEventListener("pointerdown", follow);
  stage.addEventListener("pointermove", event => { if (event.buttons) follow(event); });
  stage.addEventListener("dragstart", event => event.preventDefault());
  for (const button of view.querySelectorAll(".choice button"))
    button.addEventListener("click", () => show(view, button.dataset.show));
}

function show(view, what) {
  for (const part of view.querySelectorAll(".extra, .legend")) part.hidden = !part.classList.contains(what || "none");
  for (const button of view.querySelectorAll(".choice button"))
    button.setAttribute("aria-pressed", String(button.dataset.show === what));
}

for (const heading of document.querySelectorAll(".sortable th")) heading.addEventListener("click", () => sortBy(heading));
document.querySelectorAll(".view").forEach(setUpView);

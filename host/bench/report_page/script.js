"use strict";

// "1.52x" and "97.0 100.0" sort by their first number, names as text. "-", what was not measured, comes last in both
// directions.
function compareCells(a, b, direction) {
  if (a === "-" || b === "-") return (a === "-") - (b === "-");
  const x = parseFloat(a), y = parseFloat(b);
  const areNumbers = !Number.isNaN(x) && !Number.isNaN(y);
  return direction * (areNumbers ? x - y : a.localeCompare(b, undefined, { numeric: true }));
}

function sortBy(heading) {
  const table = heading.closest("table");
  const column = heading.cellIndex;
  const direction = heading.getAttribute("aria-sort") === "ascending" ? -1 : 1;
  const text = row => (row.cells[column] ? row.cells[column].textContent : "");
  const body = table.tBodies[0];
  const rows = Array.from(body.rows).sort((a, b) => compareCells(text(a), text(b), direction));
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
    if (!stage.classList.contains("pair")) return;
    const box = stage.getBoundingClientRect();
    split.value = (100 * (event.clientX - box.left)) / box.width;
    moveLine();
  };
  stage.addEventListener("pointerdown", follow);
  stage.addEventListener("pointermove", event => { if (event.buttons) follow(event); });
  stage.addEventListener("dragstart", event => event.preventDefault());
  for (const button of view.querySelectorAll("[data-show]"))
    button.addEventListener("click", () => show(view, button.dataset.show));
  const naturalSize = view.querySelector(".natural-size");
  naturalSize.addEventListener("click", () =>
    naturalSize.setAttribute("aria-pressed", String(view.classList.toggle("natural"))));
}

// Only pairs of pictures meet at a line.
function show(view, what) {
  for (const part of view.querySelectorAll("[data-part]")) part.hidden = part.dataset.part !== what;
  for (const button of view.querySelectorAll("[data-show]"))
    button.setAttribute("aria-pressed", String(button.dataset.show === what));
  const isPair = view.querySelector(`.mres[data-part=${what}]`) !== null;
  view.querySelector(".stage").classList.toggle("pair", isPair);
  view.querySelector(".split").hidden = !isPair;
}

for (const button of document.querySelectorAll(".sortable th button"))
  button.addEventListener("click", () => sortBy(button.parentElement));
document.querySelectorAll(".view").forEach(setUpView);

// Interactive markers: the menu of one that was clicked, and the word that this page is there while it may drag one.
"use strict";

const HERE_MS = 200;

// The server ends the drags of a page of which it hears nothing. One that is not seen holds nothing.
setInterval(() => {
  if (state && !document.hidden && state.displays.some((row) => row.on && row.kind === "InteractiveMarkers")) send({ op: "here" });
}, HERE_MS);

function closeMenu() {
  const menu = document.getElementById("marker-menu");
  if (menu) menu.remove();
}

// An entry with entries of its own opens them; the others are told to the server of the markers.
function menuList(menu, parent, seen) {
  const list = element("ul", {});
  for (const entry of menu.entries.filter((one) => one.parent === parent && one.id !== parent && !seen.has(one.id))) {
    const inner = new Set([...seen, entry.id]);
    const hasMore = menu.entries.some((one) => one.parent === entry.id && one.id !== entry.id);
    const line = element("li", { textContent: entry.title + (hasMore ? " ▸" : ""), tabIndex: 0 });
    line.dataset.entry = entry.id;
    let below = null;
    const choose = (event) => {
      event.stopPropagation();
      if (!hasMore) {
        send({ op: "marker_menu", topic: menu.topic, marker: menu.marker, control: menu.control, entry: entry.id });
        closeMenu();
      } else if (below) { below.remove(); below = null; } else { below = menuList(menu, entry.id, inner); line.append(below); }
    };
    line.addEventListener("click", choose);
    line.addEventListener("keydown", (event) => { if (event.key === "Enter") choose(event); });
    list.append(line);
  }
  return list;
}

takers.marker_menu = (menu) => {
  closeMenu();
  const box = element("div", { id: "marker-menu" }, element("b", { textContent: menu.title }), menuList(menu, 0, new Set([0])));
  $("main").append(box);
  const scene = $("scene").getBoundingClientRect(), main = $("main").getBoundingClientRect();
  const left = scene.left - main.left + menu.at[0] * scene.width, top = scene.top - main.top + menu.at[1] * scene.height;
  box.style.left = `${Math.max(0, Math.min(left, main.width - box.offsetWidth - 4))}px`;
  box.style.top = `${Math.max(0, Math.min(top, main.height - box.offsetHeight - 4))}px`;
};

addEventListener("keydown", (event) => { if (event.key === "Escape") closeMenu(); });
addEventListener("pointerdown", (event) => { if (!event.target.closest("#marker-menu")) closeMenu(); });
$("scene").addEventListener("load", () => {
  try { $("scene").contentWindow.addEventListener("pointerdown", closeMenu, true); } catch { /* the scene is not loaded */ }
});

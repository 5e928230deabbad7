"""A drawn tree as a web page of its own: search, zoom, and the way from a frame to its root. It uses no network."""

from __future__ import annotations

import json
from html import escape

from tfloom.tf2_tools.drawing.shapes import Picture
from tfloom.tf2_tools.drawing.svg import svg_text
from tfloom.tf2_tools.tree_pictures.tree import FrameTree, tree_json

PAGE = """<!DOCTYPE html>
<html lang="en">
<head>
<meta charset="utf-8">
<meta http-equiv="Content-Security-Policy"
  content="default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data:">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>{title}</title>
<style>
html, body {{ margin: 0; height: 100%; overflow: hidden; font: 14px system-ui, sans-serif; color: #1c2733 }}
#bar {{ position: fixed; z-index: 1; top: 0; left: 0; right: 0; display: flex; gap: 8px; align-items: center;
  padding: 6px 10px; background: #274b78; color: #fff }}
#bar input {{ width: 18em; padding: 3px 6px; border: 0; border-radius: 3px; font: inherit }}
#bar button {{ border: 0; border-radius: 3px; padding: 3px 10px; font: inherit; cursor: pointer }}
#stage {{ position: absolute; top: 38px; left: 0; right: 0; bottom: 0; overflow: hidden;
  cursor: grab; background: #fff }}
#stage svg {{ position: absolute; transform-origin: 0 0; max-width: none }}
#details {{ position: fixed; right: 10px; bottom: 10px; max-width: 34em; max-height: 40%; overflow: auto; margin: 0;
  padding: 8px 12px; background: #fffffff0; border: 1px solid #8796a5; border-radius: 4px; white-space: pre-wrap;
  overflow-wrap: anywhere }}
#details:empty {{ display: none }}
g[data-name] {{ cursor: pointer }}
svg.filtered g[data-name] {{ opacity: .18 }}
svg.filtered g[data-name].hit {{ opacity: 1 }}
g[data-name].now rect {{ stroke: #d97706; stroke-width: 2.5 }}
</style>
</head>
<body>
<div id="bar"><b>{title}</b>
<input id="search" type="search" placeholder="find a frame or a node (Enter: next)"
  aria-label="find a frame or a node">
<span id="count"></span>
<button id="in" aria-label="zoom in">+</button><button id="out" aria-label="zoom out">&minus;</button>
<button id="fit">fit</button></div>
<div id="stage">{svg}</div>
<pre id="details"></pre>
<script id="tree" type="application/json">{data}</script>
<script>
{script}
</script>
</body>
</html>
"""

SCRIPT = """"use strict";
const tree = JSON.parse(document.getElementById("tree").textContent);
const edges = new Map(tree.transforms.map(edge => [edge.child, edge]));
const stage = document.getElementById("stage"), svg = stage.querySelector("svg");
const search = document.getElementById("search"), count = document.getElementById("count");
const details = document.getElementById("details");
const frames = [...svg.querySelectorAll("g[data-name]")];
const size = svg.viewBox.baseVal;
let x = 0, y = 0, scale = 1, hits = [], next = 0;

function place() {
  svg.setAttribute("width", size.width * scale);
  svg.setAttribute("height", size.height * scale);
  svg.style.transform = `translate(${x}px, ${y}px)`;
}
function zoom(factor, atX = stage.clientWidth / 2, atY = stage.clientHeight / 2) {
  const wanted = Math.min(12, Math.max(0.02, scale * factor));
  x = atX - (atX - x) * wanted / scale;
  y = atY - (atY - y) * wanted / scale;
  scale = wanted;
  place();
}
function fit() {
  scale = Math.min(stage.clientWidth / size.width, stage.clientHeight / size.height, 1.8);
  x = (stage.clientWidth - size.width * scale) / 2;
  y = 0;
  place();
}
function show(group) {
  const box = group.getBBox();
  scale = Math.max(scale, 1.2);
  x = stage.clientWidth / 2 - (box.x + box.width / 2) * scale;
  y = stage.clientHeight / 2 - (box.y + box.height / 2) * scale;
  place();
}
function mark(groups, current) {
  svg.classList.toggle("filtered", groups !== null);
  for (const group of frames) {
    group.classList.toggle("hit", groups !== null && groups.includes(group));
    group.classList.toggle("now", group === current);
  }
}
function find() {
  const words = search.value.trim().toLowerCase();
  hits = words ? frames.filter(group => {
    const edge = edges.get(group.dataset.name);
    return [group.dataset.name, ...(edge ? edge.publishers : [])].some(text => text.toLowerCase().includes(words));
  }) : [];
  next = 0;
  count.textContent = words ? `${hits.length} of ${frames.length}` : "";
  details.textContent = "";
  mark(words ? hits : null, null);
}
function select(group) {
  const names = new Set();
  for (let name = group.dataset.name; name !== undefined && !names.has(name); name = edges.get(name)?.parent)
    names.add(name);
  mark(frames.filter(each => names.has(each.dataset.name)), group);
  details.textContent = group.querySelector("title")?.textContent
    + (names.size > 1 ? "\\n" + [...names].join(" ← ") : "");
}
search.addEventListener("input", find);
search.addEventListener("keydown", event => {
  if (event.key === "Enter" && hits.length) {
    const group = hits[next++ % hits.length];
    mark(hits, group);
    details.textContent = group.querySelector("title")?.textContent;
    show(group);
  } else if (event.key === "Escape") { search.value = ""; find(); }
});
document.getElementById("in").onclick = () => zoom(1.3);
document.getElementById("out").onclick = () => zoom(1 / 1.3);
document.getElementById("fit").onclick = fit;
stage.addEventListener("wheel", event => {
  event.preventDefault();
  const box = stage.getBoundingClientRect();
  zoom(Math.exp(-event.deltaY * 0.0015), event.clientX - box.left, event.clientY - box.top);
}, { passive: false });
let pressed = null, moved = false;
stage.addEventListener("pointerdown", event => { pressed = [event.clientX - x, event.clientY - y]; moved = false; });
stage.addEventListener("pointermove", event => {
  if (!pressed || !event.buttons) return;
  moved ||= Math.hypot(event.clientX - pressed[0] - x, event.clientY - pressed[1] - y) > 4;
  if (moved) { x = event.clientX - pressed[0]; y = event.clientY - pressed[1]; place(); }
});
stage.addEventListener("click", event => {
  pressed = null;
  if (moved) return;
  const group = event.target.closest("g[data-name]");
  if (group) select(group); else { find(); }
});
addEventListener("resize", fit);
fit();"""


def html_text(tree: FrameTree, picture: Picture) -> str:
    """Return the page."""
    data = json.dumps(tree_json(tree), ensure_ascii=True, allow_nan=False)
    return PAGE.format(
        title=escape(picture.title),
        svg=svg_text(picture),
        data=data.replace("<", "\\u003c"),
        script=SCRIPT,
    )

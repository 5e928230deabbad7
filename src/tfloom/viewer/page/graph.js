// The graph of nodes in layers: boxes are nodes, and between them is what they exchange.
"use strict";

const GRAPH_NS = "http://www.w3.org/2000/svg";
const KIND_COLORS = { node: "#dfe3ea", topic: "#ffd166", service: "#6bdd6b", action: "#c792ea" };
const LAYER_PX = 220, PLACE_PX = 30, BOX_PX = 180, BOX_TALL_PX = 20, MAX_LETTERS = 28;
let graphBox = [0, 0, 400, 300];      // what of the picture is shown: x, y, width, height
let graphWhole = graphBox;
let graphHeld = null;                 // where a drag began, and what was shown then

function svgElement(tag, attributes, ...children) {
  const made = document.createElementNS(GRAPH_NS, tag);
  for (const [name, value] of Object.entries(attributes)) made.setAttribute(name, value);
  made.append(...children);
  return made;
}

function askGraph() {
  send({ op: "graph", services: $("graph-services").checked, actions: $("graph-actions").checked });
}

function graphPlaces(vertices) {
  const counts = [];
  for (const { layer } of vertices) counts[layer] = (counts[layer] || 0) + 1;
  const most = Math.max(1, ...counts);
  // The places of a layer are spread over the height of the fullest one.
  return vertices.map(({ layer, place }) => [layer * LAYER_PX, (place + 0.5) * most / counts[layer] * PLACE_PX]);
}

function showGraph(graph) {
  const places = graphPlaces(graph.vertices);
  const svg = svgElement("svg", { preserveAspectRatio: "xMidYMid meet" });
  svg.append(svgElement("defs", {}, svgElement("marker", { id: "arrow", viewBox: "0 0 8 8", refX: 8, refY: 4,
    markerWidth: 7, markerHeight: 7, orient: "auto" }, svgElement("path", { d: "M0,0 L8,4 L0,8 z", fill: "#8b93a3" }))));
  const edges = graph.edges.map(([from, to]) => {
    const [x1, y1] = places[from], [x2, y2] = places[to];
    // An edge that leads back goes from left to left, in an arc.
    const start = x1 + BOX_PX / 2, end = x2 - BOX_PX / 2, bend = Math.max(40, (end - start) / 2);
    const line = svgElement("path", { d: `M${start},${y1} C${start + bend},${y1} ${end - bend},${y2} ${end},${y2}`,
      fill: "none", stroke: "#8b93a3", "marker-end": "url(#arrow)" });
    svg.append(line);
    return line;
  });
  const boxes = graph.vertices.map(({ kind, name }, number) => {
    const [x, y] = places[number], color = KIND_COLORS[kind];
    const label = svgElement("text", { x, y: y + 4, "text-anchor": "middle", fill: color },
      name.length > MAX_LETTERS ? `${name.slice(0, MAX_LETTERS - 1)}…` : name);
    const box = svgElement("g", { class: "vertex", "data-kind": kind }, svgElement("rect", { x: x - BOX_PX / 2, y: y - BOX_TALL_PX / 2,
      width: BOX_PX, height: BOX_TALL_PX, rx: kind === "node" ? 3 : 10, fill: "#1e2128", stroke: color }),
    label, svgElement("title", {}, name));
    box.dataset.name = name;
    box.addEventListener("click", () => { if (kind === "node") openParameters(name); });
    svg.append(box);
    return box;
  });
  // Of a box under the pointer, only what it exchanges stays bright.
  boxes.forEach((box, number) => {
    const isNear = graph.edges.map((edge) => edge.includes(number));
    const near = new Set(graph.edges.filter((_, index) => isNear[index]).flat());
    const shade = (isOn) => {
      edges.forEach((line, index) => line.classList.toggle("faint", isOn && !isNear[index]));
      boxes.forEach((other, index) => other.classList.toggle("faint", isOn && index !== number && !near.has(index)));
    };
    box.addEventListener("pointerenter", () => shade(true));
    box.addEventListener("pointerleave", () => shade(false));
  });
  const xs = places.map(([x]) => x), ys = places.map(([, y]) => y);
  graphWhole = places.length ? [Math.min(...xs) - BOX_PX / 2 - 10, Math.min(...ys) - 20,
    Math.max(...xs) - Math.min(...xs) + BOX_PX + 20, Math.max(...ys) - Math.min(...ys) + 40] : [0, 0, 400, 300];
  graphBox = graphWhole;
  $("graph-picture").replaceChildren(places.length ? svg : element("p", { className: "hint", textContent: "no nodes that publish or subscribe" }));
  layGraph();
  const kinds = [...new Set(graph.vertices.map(({ kind }) => kind))];
  $("graph-legend").replaceChildren(...kinds.map((kind) => {
    const mark = element("span", { textContent: `▭ ${kind}` });
    mark.style.color = KIND_COLORS[kind];
    return mark;
  }), kinds.length ? "→ data, or a call" : "");
}

function layGraph() {
  const svg = $("graph-picture").querySelector("svg");
  if (svg) svg.setAttribute("viewBox", graphBox.join(" "));
}

function openParameters(node) {
  openPanel("parameters");
  send({ op: "parameters", node });
}

// The length of a pixel of the screen in the picture.
function graphScale() {
  const box = $("graph-picture").getBoundingClientRect();
  return Math.max(graphBox[2] / box.width, graphBox[3] / box.height);
}

function zoomGraph(event) {
  event.preventDefault();
  const box = $("graph-picture").getBoundingClientRect(), by = Math.exp(Math.max(-1, Math.min(1, event.deltaY / 300)));
  const across = (event.clientX - box.left) / box.width, down = (event.clientY - box.top) / box.height;
  const [x, y, wide, tall] = graphBox;
  const width = Math.max(80, Math.min(4 * graphWhole[2], wide * by)), height = tall * width / wide;
  graphBox = [x + across * (wide - width), y + down * (tall - height), width, height];
  layGraph();
}

takers.graph = showGraph;
openers.graph = askGraph;
for (const id of ["graph-services", "graph-actions"]) $(id).addEventListener("change", askGraph);
$("graph-refresh").addEventListener("click", askGraph);
$("graph-whole").addEventListener("click", () => { graphBox = graphWhole; layGraph(); });
$("graph-picture").addEventListener("wheel", zoomGraph, { passive: false });
$("graph-picture").addEventListener("pointerdown", (event) => { graphHeld = [event.clientX, event.clientY, graphBox]; });
addEventListener("pointermove", (event) => {
  if (!graphHeld) return;
  const scale = graphScale(), [x, y, [left, top, width, height]] = graphHeld;
  graphBox = [left - (event.clientX - x) * scale, top - (event.clientY - y) * scale, width, height];
  layGraph();
});
for (const name of ["pointerup", "pointercancel", "blur"]) addEventListener(name, () => { graphHeld = null; });

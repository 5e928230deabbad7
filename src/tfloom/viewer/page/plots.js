// Plots of numeric fields over time. The server keeps the numbers, and sends as many as a plot has columns.
"use strict";

const PLOT_COLORS = ["#4aa3ff", "#ffd166", "#6bdd6b", "#ff7ab8", "#c39bff", "#ff9f5a"];
const PLOT_LEFT = 58, PLOT_BOTTOM = 16;
const plots = new Map();

takers.plot_topics = (topics) => {
  $("plot-topics").replaceChildren(...topics.map(([name, type]) => element("option", { value: name, label: type })));
};

takers.plot_fields = ({ topic, fields }) => {
  if (topic !== $("plot-topic").value.trim()) return;
  $("plot-fields").replaceChildren(...fields.map((value) => element("option", { value })));
};

function askPlotFields() {
  $("plot-fields").replaceChildren();
  const topic = $("plot-topic").value.trim();
  if (topic) send({ op: "plot_fields", topic });
}

function addPlot() {
  const topic = $("plot-topic").value.trim(), field = $("plot-field").value.trim();
  if (topic && field) send({ op: "plot", topic, field, on: true });
}

function showPlots() {
  const kept = new Set();
  state.plots.forEach((plot, index) => {
    const key = `${plot.topic}\u0000${plot.field}`;
    kept.add(key);
    let parts = plots.get(key);
    if (!parts) { parts = makePlot(plot); plots.set(key, parts); }
    setText(parts.value, plot.shown === null ? "" : String(plot.shown));
    setText(parts.status, plot.status);
    setText(parts.rowStatus, plot.status);
    drawCurve(parts.canvas, plot, PLOT_COLORS[index % PLOT_COLORS.length]);
  });
  for (const [key, parts] of [...plots]) {
    if (!kept.has(key)) { parts.box.remove(); parts.row.remove(); plots.delete(key); }
  }
  if (plots.size) $("right").classList.add("on");
}

function makePlot(plot) {
  const name = `${plot.topic} ${plot.field}`;
  const remove = () => send({ op: "plot", topic: plot.topic, field: plot.field, on: false });
  const value = element("b", { className: "plot-value" }), status = element("div", { className: "status" });
  const canvas = element("canvas", { width: 340, height: 120, title: "drag: the time that is shown" });
  const box = element("div", { className: "curve" }, element("div", { className: "topic" }, name, " ", value), canvas, status);
  box.dataset.plot = name;
  const rowStatus = element("span", { className: "status" });
  const row = element("div", { className: "display" }, element("label", { textContent: name }),
    element("button", { textContent: "×", title: "end this plot", onclick: remove }), rowStatus);
  $("plots-right").append(box);
  $("plot-rows").append(row);
  const parts = { box, canvas, value, status, row, rowStatus, plot };
  const hold = (event) => {
    if (event.buttons) holdAtPlot(parts, event);
  };
  canvas.addEventListener("pointerdown", (event) => { canvas.setPointerCapture(event.pointerId); hold(event); });
  canvas.addEventListener("pointermove", hold);
  return parts;
}

function holdAtPlot(parts, event) {
  const shown = state.plots.find((plot) => plot.topic === parts.plot.topic && plot.field === parts.plot.field);
  if (!shown || !shown.length_s) return;
  const box = parts.canvas.getBoundingClientRect(), scale = parts.canvas.width / box.width;
  const share = ((event.clientX - box.left) * scale - PLOT_LEFT) / (parts.canvas.width - PLOT_LEFT - 4);
  const before = (1 - Math.max(0, Math.min(1, share))) * shown.length_s;
  send({ op: "hold", stamp_ns: String(BigInt(shown.end_ns) - BigInt(Math.round(before * 1e9))) });
}

function shortNumber(value) {
  const size = Math.abs(value);
  return size !== 0 && (size < 1e-3 || size >= 1e6) ? value.toExponential(2) : String(Number(value.toPrecision(5)));
}

function drawCurve(canvas, plot, color) {
  const context = canvas.getContext("2d");
  context.clearRect(0, 0, canvas.width, canvas.height);
  context.font = "11px sans-serif";
  const numbers = plot.values.filter((value) => value !== null);
  const width = canvas.width - PLOT_LEFT - 4, tall = canvas.height - PLOT_BOTTOM - 6;
  const length = Math.max(plot.length_s, 1e-6);
  context.strokeStyle = "#343945";
  context.strokeRect(PLOT_LEFT, 3, width, tall + 3);
  context.fillStyle = "#8b93a3";
  context.fillText(`-${shortNumber(Number(length.toPrecision(3)))} s`, PLOT_LEFT, canvas.height - 3);
  context.fillText("0", canvas.width - 12, canvas.height - 3);
  const toX = (seconds) => PLOT_LEFT + (1 + seconds / length) * width;
  if (state.held_ns !== null) {
    const x = toX(Number(BigInt(state.held_ns) - BigInt(plot.end_ns)) / 1e9);
    context.strokeStyle = "#ffffff80";
    context.beginPath(); context.moveTo(x, 3); context.lineTo(x, tall + 6); context.stroke();
  }
  if (!numbers.length) return;
  let low = Math.min(...numbers), high = Math.max(...numbers);
  if (high - low <= 1e-9 * Math.max(Math.abs(low), 1e-3)) { low -= Math.abs(low) * 0.1 || 0.5; high += Math.abs(high) * 0.1 || 0.5; }
  context.fillText(shortNumber(high), 2, 13);
  context.fillText(shortNumber(low), 2, tall + 4);
  const toY = (value) => 5 + (1 - (value - low) / (high - low)) * tall;
  context.strokeStyle = context.fillStyle = color;
  context.beginPath();
  let isDrawing = false;
  plot.values.forEach((value, index) => {
    if (value === null) { isDrawing = false; return; }
    const x = toX(plot.seconds[index]), y = toY(value);
    if (isDrawing) context.lineTo(x, y); else { context.moveTo(x, y); context.fillRect(x - 1, y - 1, 2, 2); }
    isDrawing = true;
  });
  context.stroke();
}

showers.push(showPlots);
openers["plot-panel"] = () => send({ op: "plot_topics" });
$("plot-topic").addEventListener("change", () => { $("plot-field").value = ""; askPlotFields(); });
$("plot-field").addEventListener("keydown", (event) => { if (event.key === "Enter") addPlot(); });
$("plot-add").addEventListener("click", addPlot);

// Plots of numeric fields over time, by uPlot. The server keeps the numbers, and sends as many as a plot has columns.
"use strict";

const PLOT_COLORS = ["#4aa3ff", "#ffd166", "#6bdd6b", "#ff7ab8", "#c39bff", "#ff9f5a", "#5ad1c8", "#ff6b6b", "#a8c256", "#e0a0ff", "#8fb4ff", "#d9b38c"];
const SIDES = ["left", "right"];
const CLICK_MS = 250;         // the second click of a double one comes within
const WHEEL_MS = 400;         // what the wheel asks for holds until the server has said so
const charts = new Map();     // by number of the plot
const plotRows = new Map();   // by topic and field
let asked = null;             // the time that the wheel asked for last, and until when it counts

takers.plot_topics = (topics) => {
  $("plot-topics").replaceChildren(...topics.map(([name, type]) => element("option", { value: name, label: type })));
};

takers.plot_fields = ({ topic, fields }) => {
  if (topic !== $("plot-topic").value.trim()) return;
  $("plot-fields").replaceChildren(...fields.map((value) => element("option", { value })));
};

takers.plot_csv = ({ plot, text }) => {
  const link = element("a", { href: URL.createObjectURL(new Blob([text], { type: "text/csv" })), download: `plot_${plot}.csv` });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  say(`the numbers are saved as plot_${plot}.csv`);
};

function askPlotFields() {
  $("plot-fields").replaceChildren();
  const topic = $("plot-topic").value.trim();
  if (topic) send({ op: "plot_fields", topic });
}

function addPlot() {
  const topic = $("plot-topic").value.trim(), field = $("plot-field").value.trim();
  const plot = Number($("plot-place").value) || null;
  if (topic && field) send({ op: "plot", topic, field, plot, on: true });
}

const nameOf = (series) => `${series.topic} ${series.field}`;
const colorOf = (series) => PLOT_COLORS[state.plots.indexOf(series) % PLOT_COLORS.length];

function showPlots() {
  const numbers = [...new Set(state.plots.map((series) => series.plot))].sort((a, b) => a - b);
  setOptions($("plot-place"), ["a new plot", ...numbers.map((number) => `${number}`)], $("plot-place").value || "a new plot");
  showPlotRows(numbers);
  for (const [number, chart] of [...charts]) if (!numbers.includes(number)) { dropChart(chart); charts.delete(number); }
  for (const number of numbers) {
    if (!charts.has(number)) charts.set(number, makeChart(number));
    showChart(charts.get(number), state.plots.filter((series) => series.plot === number));
  }
  $("plot-bar").hidden = !numbers.length;
  setText($("plot-pause"), state.plot_time.is_paused ? "Follow" : "Pause");
  $("plot-pause").hidden = !state.is_live;
}

// What is chosen for each field.

function showPlotRows(numbers) {
  const kept = new Set(state.plots.map(nameOf));
  for (const [name, parts] of [...plotRows]) if (!kept.has(name)) { parts.row.remove(); plotRows.delete(name); }
  for (const series of state.plots) {
    let parts = plotRows.get(nameOf(series));
    if (!parts) { parts = makePlotRow(series); plotRows.set(nameOf(series), parts); }
    const places = [...numbers, Math.max(...numbers) + 1].map((number) => `${number}`);
    setOptions(parts.place, places, `${series.plot}`);
    setOptions(parts.axis, SIDES, series.axis);
    parts.unroll.checked = series.unroll;
    setText(parts.status, series.status);
  }
}

function makePlotRow({ topic, field }) {
  const choose = () => send({ op: "plot_choice", topic, field, plot: Number(parts.place.value), axis: parts.axis.value, unroll: parts.unroll.checked });
  const select = (title) => element("select", { title, onchange: (event) => { choose(); event.target.blur(); } });
  const parts = { place: select("number of the plot"), axis: select("side of its axis"), status: element("span", { className: "status" }),
    unroll: element("input", { type: "checkbox", onchange: choose }) };
  parts.row = element("div", { className: "display" }, element("label", { textContent: `${topic} ${field}` }), parts.place, parts.axis,
    element("label", { className: "unroll", title: "an angle in rad that goes on beyond half a turn" }, parts.unroll, "unroll"),
    element("button", { textContent: "×", title: "end this plot", onclick: () => send({ op: "plot", topic, field, on: false }) }), parts.status);
  $("plot-rows").append(parts.row);
  return parts;
}

// A plot. uPlot is made anew where its fields or their axes change.

function makeChart(number) {
  const legend = element("div"), status = element("div", { className: "status" }), plot = element("div", { className: "plot" });
  const head = element("div", { className: "bar" }, element("b", { textContent: `${number}` }),
    element("button", { textContent: "CSV", title: "save the numbers that are shown", onclick: () => send({ op: "plot_csv", plot: number }) }));
  const box = element("div", { className: "curve" }, head, legend, plot, status);
  box.dataset.plot = number;
  $("plots-right").append(box);
  const chart = { number, box, legend, status, plot, key: "", uplot: null, values: [], fields: [], zoom: {}, isPressed: false };
  new ResizeObserver(() => { if (chart.uplot) chart.uplot.setSize(sizeOf(chart)); }).observe(plot);
  return chart;
}

function dropChart(chart) {
  if (chart.uplot) chart.uplot.destroy();
  chart.uplot = null;
  chart.box.remove();
}

const sizeOf = (chart) => ({ width: Math.max(chart.plot.clientWidth, 120), height: charts.size > 2 ? 150 : 210 });

function showChart(chart, fields) {
  chart.fields = fields;
  const key = JSON.stringify(fields.map((series) => [nameOf(series), series.axis, colorOf(series)]));
  if (chart.key !== key) { chart.key = key; buildChart(chart); }
  setText(chart.status, fields.filter((series) => series.status).map((series) => `${series.field}: ${series.status}`).join("\n"));
  const size = sizeOf(chart);
  if (size.width !== chart.uplot.width || size.height !== chart.uplot.height) chart.uplot.setSize(size);
  if (!chart.isPressed) chart.uplot.setData(dataOf(fields));
  showValues(chart);
}

function dataOf(fields) {
  const tables = fields.map((series) => {
    const end = Number(BigInt(series.end_ns) - BigInt(state.plot_time.zero_ns)) / 1e9;
    return [series.seconds.map((seconds) => end + seconds), series.values];
  });
  return tables.length === 1 ? tables[0] : uPlot.join(tables);
}

function buildChart(chart) {
  if (chart.uplot) chart.uplot.destroy();
  const used = SIDES.filter((side) => chart.fields.some((series) => series.axis === side));
  const scaleOf = (side) => ({ auto: true, range: (_, low, high) => chart.zoom[side] || padded(low, high) });
  const axisOf = (side) => {
    const own = chart.fields.filter((series) => series.axis === side);
    return { scale: side, side: side === "left" ? 3 : 1, stroke: own.length === 1 ? colorOf(own[0]) : "#8b93a3", size: 54, space: 24,
      font: "11px sans-serif", ticks: { show: false }, grid: { show: side === used[0], stroke: "#343945", width: 1 }, values: (_, ticks) => ticks.map(shortNumber) };
  };
  chart.uplot = new uPlot({
    ...sizeOf(chart),
    legend: { show: false },
    scales: { x: { time: false, range: () => { const { start_s, end_s } = plotTime(); return [start_s, Math.max(end_s, start_s + 1e-9)]; } },
      ...Object.fromEntries(used.map((side) => [side, scaleOf(side)])) },
    axes: [{ stroke: "#8b93a3", size: 24, space: 60, font: "11px sans-serif", ticks: { show: false }, grid: { stroke: "#343945", width: 1 },
      values: (_, ticks) => ticks.map((tick) => `${shortNumber(tick)} s`) }, ...used.map(axisOf)],
    series: [{}, ...chart.fields.map((series) => ({ scale: series.axis, stroke: colorOf(series), width: 1.25, points: { size: 4 } }))],
    cursor: { drag: { x: true, y: true, uni: 20, dist: 5, setScale: false }, points: { size: 6 },
      sync: { key: "plots", scales: ["x", null], filters: { pub: (type) => type === "mousemove" || type === "mouseleave" } } },
    hooks: { draw: [drawShownTime], setCursor: [() => showValues(chart)], setSelect: [(made) => zoomToBox(chart, made)] },
  }, dataOf(chart.fields), chart.plot);
  listenTo(chart);
  showLegend(chart);
}

function padded(low, high) {
  if (low === null || high === null) return [0, 1];
  const more = high - low <= 1e-9 * Math.max(Math.abs(low), 1e-3) ? Math.abs(low) * 0.1 || 0.5 : 0.05 * (high - low);
  return [low - more, high + more];
}

function drawShownTime(made) {
  if (state.held_ns === null) return;
  const x = made.valToPos(Number(BigInt(state.held_ns) - BigInt(state.plot_time.zero_ns)) / 1e9, "x", true);
  const { left, top, width, height } = made.bbox;
  if (x < left || x > left + width) return;
  made.ctx.strokeStyle = "#ffffff80";
  made.ctx.lineWidth = 1;
  made.ctx.beginPath(); made.ctx.moveTo(x, top); made.ctx.lineTo(x, top + height); made.ctx.stroke();
}

// The legend has the values under the cursor, or those of the time that is shown.

function showLegend(chart) {
  chart.values = chart.fields.map(() => element("b", { className: "plot-value" }));
  chart.legend.replaceChildren(...chart.fields.map((series, index) => {
    const mark = element("span", { className: "plot-mark", textContent: "━ " });
    mark.style.color = colorOf(series);
    const line = element("div", { className: "topic" }, mark, nameOf(series), " ", chart.values[index]);
    line.dataset.series = nameOf(series);
    return line;
  }));
}

function showValues(chart) {
  const { uplot, fields, values } = chart;
  const isUnderCursor = uplot && uplot.cursor.left >= 0;
  fields.forEach((series, index) => {
    const place = isUnderCursor ? uplot.cursor.idxs[index + 1] : null;
    const found = place === null || place === undefined ? null : uplot.data[index + 1][place];
    const value = isUnderCursor ? found : series.shown;
    if (values[index]) setText(values[index], value === null || value === undefined ? "" : String(value));
  });
  if (isUnderCursor) setText($("plot-at"), `at ${shortNumber(uplot.posToVal(uplot.cursor.left, "x"))} s`);
  else if (![...charts.values()].some((one) => one.uplot && one.uplot.cursor.left >= 0)) setText($("plot-at"), "");
}

// Zoom. The time is that of all plots on all pages, of which the server then sends more numbers; values are each page's.

function plotTime() {
  return asked && performance.now() < asked.until ? asked : state.plot_time;
}

function askTime(start, end, follows) {
  const length = Math.max(end - start, 1e-6);
  asked = { start_s: end - length, end_s: end, until: performance.now() + WHEEL_MS };
  for (const chart of charts.values()) if (chart.uplot) chart.uplot.setData(chart.uplot.data);
  send({ op: "plot_time", length_s: length, end_ns: follows ? null : stampAt(end) });
}

function stampAt(seconds) {
  const stamp = BigInt(state.plot_time.zero_ns) + BigInt(Math.round(seconds * 1e9));
  return String(stamp < 0n ? 0n : stamp);
}

function zoomToBox(chart, made) {
  const { left, top, width, height } = made.select;
  if (!width && !height) return;
  const tall = made.over.clientHeight, wide = made.over.clientWidth;
  if (height && height < tall) {
    for (const side of SIDES.filter((one) => made.scales[one])) {
      chart.zoom[side] = [made.posToVal(top + height, side), made.posToVal(top, side)];
    }
  }
  const ends = [made.posToVal(left, "x"), made.posToVal(left + width, "x")];
  made.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
  if (width && width < wide) askTime(...ends, false);
  else made.setData(made.data);
}

function zoomByWheel(chart, event) {
  event.preventDefault();
  const made = chart.uplot, box = made.over.getBoundingClientRect();
  const x = event.clientX - box.left, y = event.clientY - box.top;
  const turned = event.deltaY || event.deltaX, factor = turned < 0 ? 0.8 : 1.25;
  const overAxis = x < 0 ? "left" : x > box.width ? "right" : "";
  if (event.shiftKey || overAxis) {
    for (const side of SIDES.filter((one) => made.scales[one] && (!overAxis || one === overAxis))) {
      const at = made.posToVal(y, side), { min, max } = made.scales[side];
      chart.zoom[side] = [at - (at - min) * factor, at + (max - at) * factor];
    }
    made.setData(made.data);
    return;
  }
  const { start_s: start, end_s: end } = plotTime(), follows = state.is_live && !state.plot_time.is_paused;
  if (!event.deltaY && !follows) {   // sideways
    const step = 0.1 * (end - start) * Math.sign(event.deltaX);
    askTime(start + step, end + step, false);
  } else if (factor > 1 && (end - start) * factor >= state.plot_time.whole_s) {
    asked = null;
    send({ op: "plot_time", length_s: null, end_ns: follows || !state.is_live ? null : stampAt(end) });
  } else if (follows) askTime(end - (end - start) * factor, end, true);
  else {
    const at = made.posToVal(Math.max(0, Math.min(box.width, x)), "x");
    askTime(at - (at - start) * factor, at + (end - at) * factor, false);
  }
}

function showAllOfPlots() {
  asked = null;
  for (const chart of charts.values()) chart.zoom = {};
  send({ op: "plot_time", length_s: null, end_ns: null });
}

function listenTo(chart) {
  const over = chart.uplot.over;
  let clicked = 0;
  over.addEventListener("pointerdown", () => { chart.isPressed = true; });
  over.addEventListener("click", (event) => {
    clearTimeout(clicked);
    if (event.detail > 1) return;
    const stamp = stampAt(chart.uplot.posToVal(event.clientX - over.getBoundingClientRect().left, "x"));
    clicked = setTimeout(() => send({ op: "hold", stamp_ns: stamp }), CLICK_MS);
  });
  over.addEventListener("dblclick", () => { clearTimeout(clicked); showAllOfPlots(); });
  chart.uplot.root.addEventListener("wheel", (event) => zoomByWheel(chart, event), { passive: false });
}

function pausePlots() {
  const { is_paused, is_zoomed, start_s, end_s } = state.plot_time;
  asked = null;
  send({ op: "plot_time", length_s: is_zoomed ? end_s - start_s : null, end_ns: is_paused ? null : stampAt(end_s) });
}

function shortNumber(value) {
  const size = Math.abs(value);
  return size !== 0 && (size < 1e-3 || size >= 1e6) ? value.toExponential(2) : String(Number(value.toPrecision(5)));
}

showers.push(showPlots);
openers["plot-panel"] = () => send({ op: "plot_topics" });
for (const name of ["pointerup", "pointercancel", "blur"]) addEventListener(name, () => { for (const chart of charts.values()) chart.isPressed = false; });
$("plot-topic").addEventListener("change", () => { $("plot-field").value = ""; askPlotFields(); });
$("plot-field").addEventListener("keydown", (event) => { if (event.key === "Enter") addPlot(); });
$("plot-add").addEventListener("click", addPlot);
$("plot-pause").addEventListener("click", pausePlots);
$("plot-all").addEventListener("click", showAllOfPlots);

// The page around viser's scene. All texts come from the wire, so they are only ever set as text, never as HTML.
"use strict";

const $ = (id) => document.getElementById(id);
const query = new URLSearchParams(location.search);

let socket = null;
let page = "";
let state = null;
let isDragging = false;      // the slider
// What the other scripts of the page add: by the key of a message, what takes it; by panel, what opening it asks for.
const takers = {};
const openers = {};
const onPage = [];          // what the parts of the page do when a connection has been opened, the first or a further one
const showers = [];           // called with each new state

function send(command) {
  if (socket && socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify(command));
}

function element(tag, properties = {}, ...children) {
  const made = document.createElement(tag);
  for (const [name, value] of Object.entries(properties)) {
    if (name === "className") made.className = value;
    else if (name.startsWith("on")) made.addEventListener(name.slice(2), value);
    else if (name in made) made[name] = value;
    else made.setAttribute(name, value);
  }
  made.append(...children);
  return made;
}

function say(text) {
  $("message").textContent = text;
  $("message").title = text;
}

// The connection. It is opened again when the server is.

function connect() {
  const scheme = location.protocol === "https:" ? "wss" : "ws";
  socket = new WebSocket(`${scheme}://${location.host}/api`);
  socket.onopen = () => say("");
  socket.onmessage = (event) => take(JSON.parse(event.data));
  socket.onclose = () => {
    say("the connection is lost; trying again …");
    stop();
    document.body.dataset.ready = "";
    setTimeout(connect, 1000);
  };
}

function take(message) {
  if (message.page !== undefined) { openScene(message.page, message.camera); openAskedPanel(); for (const act of onPage) act(); }
  if (message.state !== undefined) { state = message.state; show(); }
  if (message.log !== undefined) addLines(message.log);
  if (message.error !== undefined) say(message.error);
  if (message.done !== undefined) say(message.done);
  if (message.parameters !== undefined) showParameters(message.parameters);
  for (const [key, taker] of Object.entries(takers)) if (message[key] !== undefined) taker(message[key], message);
}

// The layout as a file of the browser, where the server was not told where to write it.
takers.layout = (text, { name, said }) => {
  const link = element("a", { href: URL.createObjectURL(new Blob([text], { type: "application/yaml" })), download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), 10000);
  say(said);
};

function openScene(id, saved) {
  page = id;
  const scheme = location.protocol === "https:" ? "wss" : "ws";
  const server = `${scheme}://${location.host}/scene/ws?page=${encodeURIComponent(id)}`;
  const camera = query.get("camera") || (saved ? saved.position.join() : "-3,-4,4");
  const lookAt = query.get("look_at") || (saved ? saved.look_at.join() : "0,0,0");
  $("scene").src = `/scene/?darkMode&hideViserLogo&initialCameraPosition=${encodeURIComponent(camera)}` +
    `&initialCameraLookAt=${encodeURIComponent(lookAt)}` +
    (query.get("dpr") ? `&fixedDpr=${encodeURIComponent(query.get("dpr"))}` : "") +
    `&websocket=${encodeURIComponent(server)}`;
  if (!saved && !query.get("camera")) send({ op: "fit_start" });
}

// What the server says of the view.

function show() {
  showFixed();
  showRows();
  showDisplays();
  showFindings();
  showTime();
  showSelection();
  showPictures();
  showDriveTopics();
  for (const shower of showers) shower();
  if (document.activeElement !== $("axes")) $("axes").value = state.axes_m;
  $("names").checked = state.with_names;
  document.body.dataset.ready = "yes";
}

function setOptions(select, values, chosen) {
  if (document.activeElement === select) return;
  const key = JSON.stringify(values);
  if (select.dataset.key !== key) {
    select.dataset.key = key;
    select.replaceChildren(...values.map((value) => element("option", { value, textContent: value })));
  }
  select.value = chosen;
}

function showFixed() {
  const frames = state.frames.includes(state.fixed_frame) ? state.frames : [...state.frames, state.fixed_frame];
  setOptions($("fixed"), frames, state.fixed_frame);
}

// A row is built once and then changed: a table that is built anew twice a second would lose clicks.
const rows = new Map();

function showRows() {
  const selected = state.selection ? state.selection.frames : [];
  const shown = [];
  const seen = new Map();
  const publishers = new Map();   // of each frame so far: parents come before their children
  for (const row of state.rows) {
    const count = seen.get(row.frame) || 0;
    seen.set(row.frame, count + 1);
    const key = `${row.frame}\u0000${count}`;
    let cells = rows.get(key);
    if (!cells) {
      cells = makeRow(row.frame);
      rows.set(key, cells);
    }
    setText(cells.name, row.prefix + row.name);
    setText(cells.rate, row.rate_hz ? row.rate_hz.toFixed(1) : row.health === "static" ? "static" : "");
    setText(cells.age, row.age_s === null ? "" : `${row.age_s.toFixed(2)} s`);
    setText(cells.publisher, row.publisher === publishers.get(row.parent) ? "" : row.publisher);
    publishers.set(row.frame, row.publisher);
    cells.line.title = [row.frame, row.publisher, row.note].filter(Boolean).join("\n");
    cells.line.className = [row.health, selected.includes(row.frame) ? "selected" : "", state.marked.includes(row.frame) ? "marked" : ""].join(" ");
    cells.trail.checked = state.trails.includes(row.frame);
    shown.push([key, cells.line]);
  }
  const keys = new Set(shown.map(([key]) => key));
  for (const key of [...rows.keys()]) if (!keys.has(key)) rows.delete(key);
  const lines = shown.map(([, line]) => line);
  const body = $("rows");
  if (lines.length !== body.children.length || lines.some((line, index) => body.children[index] !== line)) {
    body.replaceChildren(...lines);
  }
}

function setText(node, text) {
  if (node.textContent !== text) node.textContent = text;
}

function makeRow(frame) {
  const name = element("td", { className: "name" });
  const rate = element("td", { className: "number" });
  const age = element("td", { className: "number" });
  const publisher = element("td", { className: "publisher" });
  const trail = element("input", { type: "checkbox", title: "trail",
    onchange: () => send({ op: "trail", frame, on: trail.checked }) });
  const last = element("td", { onclick: (event) => event.stopPropagation() }, trail);
  const line = element("tr", { onclick: () => send({ op: "select", frame }) }, name, rate, age, publisher, last);
  line.dataset.frame = frame;
  return { line, name, rate, age, publisher, trail };
}

const displays = new Map();

function showDisplays() {
  const lines = [];
  for (const row of state.displays) {
    let parts = displays.get(row.topic);
    if (!parts) {
      const box = element("input", { type: "checkbox",
        onchange: () => send({ op: "display", topic: row.topic, on: box.checked }) });
      const kind = element("span", { className: "kind" });
      const choice = element("select", { title: "coloured by",
        onchange: () => send({ op: "choose", topic: row.topic, choice: choice.value }) });
      const status = element("span", { className: "status" });
      const line = element("div", { className: "display" },
        element("label", {}, box, " ", row.topic), choice, kind, status);
      line.dataset.topic = row.topic;
      parts = { line, box, kind, choice, status };
      displays.set(row.topic, parts);
    }
    parts.box.checked = row.on;
    setText(parts.kind, row.kind);
    setText(parts.status, row.status);
    parts.choice.hidden = !row.on || !row.choices.length;
    if (row.choices.length) setOptions(parts.choice, ["", ...row.choices], row.choice);
    lines.push(parts.line);
  }
  const names = new Set(state.displays.map((row) => row.topic));
  for (const name of [...displays.keys()]) if (!names.has(name)) displays.delete(name);
  const body = $("display-rows");
  if (lines.length !== body.children.length || lines.some((line, index) => body.children[index] !== line)) {
    body.replaceChildren(...lines);
  }
}

function showFindings() {
  setText($("finding-count"), state.findings.length ? String(state.findings.length) : "");
  const key = JSON.stringify(state.findings);
  if ($("findings").dataset.key === key) return;
  $("findings").dataset.key = key;
  const boxes = state.findings.map((finding) => element("div", {
    className: `finding ${finding.severity}`,
    onclick: () => { send({ op: "mark", frames: finding.frames }); openPanel("frames"); },
  }, element("b", { textContent: `${finding.code} ` }), finding.summary,
     element("div", { className: "mend", textContent: finding.mend })));
  $("findings").replaceChildren(...(boxes.length ? boxes : [element("p", { className: "hint", textContent: "no findings" })]));
}

// Time. Stamps are nanoseconds, beyond what a number of JavaScript holds, so they are BigInts.

function showTime() {
  const button = $("live");
  button.textContent = state.is_live ? "Live" : state.is_playing ? "Pause" : "Play";
  button.classList.toggle("on", state.is_live ? state.held_ns === null : state.is_playing);
  $("slider").disabled = button.disabled = state.span === null;
  if (state.span === null) { setText($("clock"), "nothing moves"); return; }
  const [start, end] = state.span.map(BigInt);
  const shown = state.held_ns === null ? end : BigInt(state.held_ns);
  const length = Number(end - start) / 1e9;
  if (!isDragging) {
    $("slider").max = String(Math.max(length, 0.001));
    $("slider").step = "0.01";
    $("slider").value = String(Number(shown - start) / 1e9);
  }
  setText($("clock"), state.is_live
    ? (state.held_ns === null ? `live, ${length.toFixed(1)} s kept` : `${(Number(shown - end) / 1e9).toFixed(2)} s`)
    : `${(Number(shown - start) / 1e9).toFixed(2)} of ${length.toFixed(2)} s`);
}

function holdAtSlider() {
  if (!state || state.span === null) return;
  const start = BigInt(state.span[0]);
  const stamp = start + BigInt(Math.round(Number($("slider").value) * 1e9));
  send({ op: "hold", stamp_ns: String(stamp) });
}

// The transform between two frames.

function showSelection() {
  const selection = state.selection;
  $("selection").hidden = !selection;
  $("right").classList.toggle("on", Boolean(selection) || state.plots.length > 0 || state.displays.some((row) => row.on && row.is_image));
  if (!selection) return;
  const isPair = selection.frames.length === 2;
  const first = selection.frames[0];
  setText($("selection-title"), isPair ? `tf2_echo ${selection.frames.join(" ")}` : first === state.fixed_frame ? first : `${first} in ${state.fixed_frame}`);
  setText($("selection-text"), isPair ? selection.text : `${selection.text}\n\nClick another frame for the transform between them.`);
  $("plot").hidden = $("unroll-label").hidden = !selection.plot;
  if (selection.plot) drawPlot(selection.plot);
}

const CURVES = [["x", "#ff6b6b", "x [m]"], ["y", "#6bdd6b", "y [m]"], ["z", "#6ba8ff", "z [m]"], ["yaw_deg", "#ffd166", "yaw [°]"]];

function drawPlot(plot) {
  const canvas = $("plot"), context = canvas.getContext("2d");
  const left = 46, height = canvas.height / CURVES.length;
  context.clearRect(0, 0, canvas.width, canvas.height);
  context.font = "11px sans-serif";
  const first = plot.seconds[0], span = Math.max(-first, 1e-6);
  CURVES.forEach(([name, color, label], index) => {
    const isRolled = name === "yaw_deg" && !$("unroll").checked;   // the server's goes on beyond half a turn
    const values = isRolled ? plot[name].map((yaw) => yaw - 360 * Math.round(yaw / 360)) : plot[name], top = index * height + 4, tall = height - 10;
    let low = Math.min(...values), high = Math.max(...values);
    if (high - low < 1e-6) { low -= 0.5; high += 0.5; }
    context.fillStyle = "#8b93a3";
    context.fillText(label, 2, top + 10);
    context.fillText(high.toFixed(2), 2, top + 22);
    context.fillText(low.toFixed(2), 2, top + tall);
    context.strokeStyle = color;
    context.beginPath();
    values.forEach((value, place) => {
      const x = left + (plot.seconds[place] - first) / span * (canvas.width - left - 4);
      const y = top + tall - (value - low) / (high - low) * tall;
      if (place) context.lineTo(x, y); else context.moveTo(x, y);
    });
    context.stroke();
  });
  if (state.held_ns !== null) {
    const at = Number(BigInt(state.held_ns) - BigInt(plot.end_ns)) / 1e9;
    const x = left + (at - first) / span * (canvas.width - left - 4);
    context.strokeStyle = "#ffffff80";
    context.beginPath(); context.moveTo(x, 0); context.lineTo(x, canvas.height); context.stroke();
  }
}

// Images. Each is asked for when the one before has come: a slow page gets fewer.

const pictures = new Map();

function showPictures() {
  const topics = state.displays.filter((row) => row.on && row.is_image).map((row) => row.topic);
  for (const [topic, picture] of [...pictures]) {
    if (!topics.includes(topic)) { picture.isOver = true; picture.box.remove(); pictures.delete(topic); }
  }
  for (const topic of topics) {
    if (pictures.has(topic)) continue;
    const image = element("img", { alt: "" });
    const box = element("div", { className: "picture" }, element("div", { className: "topic", textContent: topic }), image);
    box.dataset.topic = topic;
    const picture = { image, box, isOver: false };
    pictures.set(topic, picture);
    $("pictures").append(box);
    loadPicture(topic, picture);
  }
}

async function loadPicture(topic, picture) {
  while (!picture.isOver) {
    try {
      const response = await fetch(`/image?topic=${encodeURIComponent(topic)}`, { cache: "no-store" });
      if (response.status === 200) {
        const url = URL.createObjectURL(await response.blob());
        const before = picture.image.src;
        picture.image.src = url;
        await picture.image.decode().catch(() => {});
        if (before) URL.revokeObjectURL(before);
      }
    } catch { /* the server is gone; the connection says so */ }
    await new Promise((resolve) => setTimeout(resolve, 100));
  }
}

// The log.

const MAX_LINES = 2000;
let lines = [];

function addLines(added) {
  lines = [...lines, ...added].slice(-MAX_LINES);
  const box = $("log-lines");
  for (const line of added) if (isWanted(line)) box.append(makeLine(line));
  while (box.children.length > MAX_LINES) box.firstChild.remove();
  if (followsLog) scrollLog();
}

// A new connection gets the last lines from the beginning, which the page may have had from the one before.
onPage.push(() => { lines = []; $("log-lines").replaceChildren(); });

let followsLog = true;        // until its user scrolls up, and again from the end

function isAtEnd(box) { return box.scrollHeight - box.scrollTop - box.clientHeight < 30; }

function scrollLog() { $("log-lines").scrollTop = $("log-lines").scrollHeight; }

function isWanted(line) {
  const node = $("log-node").value.trim();
  const words = $("log-text").value.trim().toLowerCase();
  return line.level >= Number($("log-level").value) && (!node || line.name.includes(node)) &&
    (!words || line.text.toLowerCase().includes(words));
}

function makeLine(line) {
  const level = line.level >= 40 ? "error" : line.level >= 30 ? "warn" : line.level < 20 ? "debug" : "info";
  const time = new Date(Number(BigInt(line.stamp_ns) / 1000000n)).toISOString().slice(11, 23);
  return element("div", { className: `line ${level}`, textContent: `${time} [${line.name}] ${line.text}` });
}

function filterLines() {
  $("log-lines").replaceChildren(...lines.filter(isWanted).map(makeLine));
  followsLog = true;
  scrollLog();
}

// Parameters, edited in place.

function showParameters(found) {
  setOptions($("parameter-node"), found.nodes, found.node);
  const lines = found.values.map(({ name, value, is_editable }) => {
    const input = element("input", { value, disabled: !is_editable, title: value,
      onchange: () => send({ op: "set_parameter", node: found.node, name, value: input.value }) });
    const line = element("div", { className: "parameter" }, element("span", { textContent: name }), input);
    line.dataset.parameter = name;
    return line;
  });
  $("parameter-rows").replaceChildren(...lines);
}

// Tools on the floor: a transparent pad over the scene takes the pointer.

let tool = "";
let pressed = null;

function chooseTool(name) {
  tool = name;
  for (const button of document.querySelectorAll("#tools [data-tool]")) button.classList.toggle("on", button.dataset.tool === name);
  const isOnFloor = ["goal", "initial", "point", "measure", "focus"].includes(name);
  if (name !== "measure") send({ op: "end_measure" });
  $("pad").hidden = !isOnFloor;
  if (isOnFloor) layPad();
  $("stick").hidden = $("drive-topic-box").hidden = name !== "drive";
  stop();
}

function layPad() {
  const scene = $("scene").getBoundingClientRect(), main = $("main").getBoundingClientRect();
  Object.assign($("pad").style, { left: `${scene.left - main.left}px`, top: `${scene.top - main.top}px`,
    width: `${scene.width}px`, height: `${scene.height}px` });
  drawPad(null, null);
}

function padPoint(event) {
  const box = $("pad").getBoundingClientRect();
  return [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
}

function drawPad(from, to) {
  const box = $("pad").getBoundingClientRect();
  for (const id of ["pad-line", "pad-dot"]) $(id).style.display = from ? "" : "none";
  if (!from) return;
  const end = to || from;
  for (const [name, value] of [["x1", from[0] * box.width], ["y1", from[1] * box.height], ["x2", end[0] * box.width], ["y2", end[1] * box.height]]) {
    $("pad-line").setAttribute(name, value);
  }
  $("pad-dot").setAttribute("cx", from[0] * box.width);
  $("pad-dot").setAttribute("cy", from[1] * box.height);
}

// Driving, by keys, stick and gamepad. It is said again and again while it lasts: the server stops a robot of whose page
// it hears nothing. Nothing here may stay deflected when its user has let go of it, or can't be known to hold it.

const DRIVE_MS = 100;
const MAX_GAP_MS = 500;       // the server's, too
const held = new Set();
let stick = [0, 0];
let stickPointer = null;      // the finger or the mouse that holds the stick
let driven = "";              // the topic that is driven
let lastTick = Date.now();
let clock = 0;                // counts up when performance.now() may have stood still, as it does in machines that sleep
const KEYS = { ArrowUp: "up", KeyW: "up", ArrowDown: "down", KeyS: "down", ArrowLeft: "left", KeyA: "left", ArrowRight: "right", KeyD: "right" };

function wish() {
  let ahead = (held.has("up") ? 1 : 0) - (held.has("down") ? 1 : 0) - stick[1];
  let left = (held.has("left") ? 1 : 0) - (held.has("right") ? 1 : 0) - stick[0];
  // Browsers stop reading gamepads of pages that are not looked at: the stick would stay where it was.
  const isLookedAt = !document.hidden && document.hasFocus();
  for (const gamepad of isLookedAt && navigator.getGamepads ? navigator.getGamepads() : []) {
    if (!gamepad) continue;
    if (Math.abs(gamepad.axes[1]) > 0.1) ahead -= gamepad.axes[1];
    if (Math.abs(gamepad.axes[0]) > 0.1) left -= gamepad.axes[0];
  }
  const clamp = (value) => Math.max(-1, Math.min(1, value));
  return [clamp(ahead), clamp(left)];
}

// With the time at which it is said: what has waited on its way is no longer meant.
function sayVelocity(topic, ahead, left) {
  send({ op: "drive", topic, ahead, left, at: performance.now() / 1000, clock });
}

function drive() {
  if (tool !== "drive") return;
  const [ahead, left] = document.hidden ? [0, 0] : wish();
  const topic = $("drive-topic").value;
  if (driven && (driven !== topic || !(ahead || left))) sayVelocity(driven, 0, 0);
  driven = ahead || left ? topic : "";
  if (driven) sayVelocity(driven, ahead, left);
}

function tick() {
  // A page that did not run, as in a machine that slept, has not heard that a key was released.
  const now = Date.now();
  if (Math.abs(now - lastTick) > MAX_GAP_MS) { clock += 1; stop(); }
  lastTick = now;
  drive();
}

function stop() {
  held.clear();
  stickPointer = null;
  moveKnob(0, 0);
  if (driven) { sayVelocity(driven, 0, 0); driven = ""; }
}

function moveKnob(x, y) {
  const length = Math.max(1, Math.hypot(x, y));
  stick = [x / length, y / length];
  $("knob").style.transform = `translate(${stick[0] * 45}px, ${stick[1] * 45}px)`;
}

function showDriveTopics() {
  const topics = state.drive_topics || [], chosen = $("drive-topic").value;
  // The list would choose another robot, which a key that is held, or the next one, would drive.
  if (tool === "drive" && chosen && !topics.includes(chosen)) {
    say(`nobody subscribes to velocities on ${chosen} any more`);
    chooseTool("");
  }
  setOptions($("drive-topic"), topics, topics.includes($("drive-topic").value) ? $("drive-topic").value : topics[0]);
}

function takeKey(event, isDown) {
  const key = KEYS[event.code];
  if (tool !== "drive" || !key) return;
  if (!isDown) held.delete(key);   // wherever the focus is now
  if (event.target instanceof HTMLInputElement) return;
  if (isDown && (event.ctrlKey || event.altKey || event.metaKey)) return;   // a shortcut of the browser
  event.preventDefault();
  event.stopPropagation();
  if (isDown) held.add(key);
  if (!event.repeat) drive();
}

// Panels.

function openPanel(name) {
  for (const button of document.querySelectorAll("#tabs [data-panel]")) button.classList.toggle("on", button.dataset.panel === name);
  for (const panel of document.querySelectorAll(".panel")) panel.classList.toggle("on", panel.id === name);
  if (openers[name]) openers[name]();
  if (name === "parameters") send({ op: "parameters", node: $("parameter-node").value });
}

// The panel that the address asks for, as `?panel=graph`: once, because a connection that is opened again is not a new page.
let askedPanel = query.get("panel") === "plots" ? "plot-panel" : query.get("panel");
function openAskedPanel() {
  const panels = [...document.querySelectorAll(".panel")].map((panel) => panel.id);
  if (panels.includes(askedPanel)) {
    openPanel(askedPanel);
    document.body.classList.add("drawer");
    $("left").classList.toggle("wide", ["graph", "log"].includes(askedPanel));
  }
  askedPanel = null;
}

for (const button of document.querySelectorAll("#tabs [data-panel]")) button.addEventListener("click", () => openPanel(button.dataset.panel));
// On a narrow screen the panels are a drawer over the scene.
$("menu").addEventListener("click", () => document.body.classList.toggle("drawer"));
$("shade").addEventListener("click", () => document.body.classList.remove("drawer"));
for (const button of document.querySelectorAll("#tools [data-tool]")) button.addEventListener("click", () => chooseTool(button.dataset.tool));
$("fixed").addEventListener("change", () => { send({ op: "fixed_frame", frame: $("fixed").value }); $("fixed").blur(); });
$("names").addEventListener("change", () => send({ op: "names", on: $("names").checked }));
$("axes").addEventListener("change", () => send({ op: "axes", length: Number($("axes").value) }));
$("save-layout").addEventListener("click", () => send({ op: "layout" }));
$("save-rviz").addEventListener("click", () => send({ op: "layout", form: "rviz" }));
$("unroll").addEventListener("change", () => { if (state) showSelection(); });
$("unselect").addEventListener("click", () => send({ op: "unselect" }));
$("slider").addEventListener("pointerdown", () => { isDragging = true; });
for (const name of ["pointerup", "pointercancel", "blur"]) addEventListener(name, () => { isDragging = false; });
$("slider").addEventListener("input", holdAtSlider);
$("live").addEventListener("click", () => send(state && !state.is_live ? { op: "play", on: !state.is_playing } : { op: "hold", stamp_ns: null }));
$("log-level").addEventListener("change", filterLines);
$("log-node").addEventListener("input", filterLines);
$("log-text").addEventListener("input", filterLines);
// A panel that is not shown has no height, and its end is not where it was.
$("log-lines").addEventListener("scroll", () => { if ($("log-lines").clientHeight) followsLog = isAtEnd($("log-lines")); });
openers.log = () => { if (followsLog) scrollLog(); };
$("parameter-refresh").addEventListener("click", () => send({ op: "parameters", node: $("parameter-node").value }));
$("parameter-node").addEventListener("change", () => { send({ op: "parameters", node: $("parameter-node").value }); $("parameter-node").blur(); });
$("pad").addEventListener("pointerdown", (event) => { pressed = padPoint(event); $("pad").setPointerCapture(event.pointerId); drawPad(pressed, null); });
$("pad").addEventListener("pointermove", (event) => { if (pressed) drawPad(pressed, padPoint(event)); });
for (const name of ["pointercancel", "lostpointercapture"]) $("pad").addEventListener(name, () => { pressed = null; drawPad(null, null); });
$("pad").addEventListener("pointerup", (event) => {
  if (!pressed) return;
  if (tool === "measure" || tool === "focus") send({ op: tool, at: padPoint(event) });
  else send({ op: "floor", tool, from: pressed, to: padPoint(event) });
  if (tool === "focus") chooseTool("");
  pressed = null;
  drawPad(null, null);
});
$("stick").addEventListener("pointerdown", (event) => {
  if (stickPointer !== null) return;   // a second finger
  stickPointer = event.pointerId;
  $("stick").setPointerCapture(event.pointerId);
  followStick(event);
});
$("stick").addEventListener("pointermove", (event) => { if (event.pointerId === stickPointer) followStick(event); });
for (const name of ["pointerup", "pointercancel", "lostpointercapture"]) {
  $("stick").addEventListener(name, (event) => {
    if (event.pointerId !== stickPointer) return;
    stickPointer = null;
    moveKnob(0, 0);
    drive();
  });
}
// A finger that rests on the stick does not ask for a menu, which would let the stick go.
$("stick").addEventListener("contextmenu", (event) => { event.preventDefault(); event.stopPropagation(); });
function followStick(event) {
  const box = $("stick").getBoundingClientRect();
  moveKnob((event.clientX - box.left - 70) / 45, (event.clientY - box.top - 70) / 45);
  drive();
}
addEventListener("keydown", (event) => takeKey(event, true), true);
addEventListener("keyup", (event) => takeKey(event, false), true);
for (const name of ["blur", "pagehide", "freeze", "offline", "contextmenu"]) addEventListener(name, stop);
for (const name of ["visibilitychange", "freeze", "resume"]) document.addEventListener(name, stop);
addEventListener("resize", () => { if (!$("pad").hidden) layPad(); });
// Keys that are pressed while the scene has the focus arrive there: it is of this server too, so they can be heard.
$("scene").addEventListener("load", () => {
  try {
    $("scene").contentWindow.addEventListener("keydown", (event) => takeKey(event, true), true);
    $("scene").contentWindow.addEventListener("keyup", (event) => takeKey(event, false), true);
    for (const name of ["blur", "pagehide", "contextmenu"]) $("scene").contentWindow.addEventListener(name, stop);
  } catch { /* the scene is not loaded */ }
});
setInterval(tick, DRIVE_MS);
addEventListener("DOMContentLoaded", connect);   // when the other scripts have run, too

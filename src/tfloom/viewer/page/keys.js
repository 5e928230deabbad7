// Keys for what the buttons do, the list of them, and what a scene without anything says.
"use strict";

const TOOL_KEYS = { KeyM: "", KeyG: "goal", KeyP: "initial", KeyC: "point", KeyV: "drive", KeyR: "measure", KeyK: "focus" };
const KEY_TEXTS = [
  ["M", "move: turn, shift and zoom"], ["G", "goal pose"], ["P", "initial pose"], ["C", "point"], ["V", "drive"],
  ["arrows, W A S D", "drive ahead, back and around, while V is chosen"], ["F", "see all that is shown"],
  ["double click", "see all of what is at this place"],
  ["O, T, I", "camera: orbit, from above, out of the selected frame"], ["L", "follow the selected frame; again: and its yaw; again: none"],
  ["R", "measure: two clicks; a third one or Esc clears"], ["K", "click on what the camera is to turn about"],
  ["B", "cameras and saved views"],
  ["space", "play or pause a recording; the newest time of a graph"], ["Esc", "select no frame, and move"], ["?", "this list"],
];

const OWN_TOPICS = ["/goal_pose", "/initialpose", "/clicked_point"];   // of the tools of this page

function takeShortcut(event) {
  if (event.repeat || event.ctrlKey || event.altKey || event.metaKey) return;
  const tag = event.target.tagName, isMark = tag === "INPUT" && ["range", "checkbox"].includes(event.target.type);
  if (/^(INPUT|SELECT|TEXTAREA)$/.test(tag) && !isMark) return;   // what is typed there is no key of ours
  if (event.code === "Space" && (isMark || tag === "BUTTON")) return;
  if (event.key === "?") toggleKeys();
  else if (event.code === "Escape") leave();
  else if (event.code in CAMERA_KEYS) CAMERA_KEYS[event.code]();
  else if (event.code === "KeyF") send({ op: "fit" });
  else if (event.code === "Space") { event.preventDefault(); $("live").click(); }
  else if (event.code in TOOL_KEYS) chooseByKey(TOOL_KEYS[event.code]);
}

function chooseByKey(name) {
  if (!document.querySelector(`#tools [data-tool="${name}"]`).offsetParent) return;   // a file or a recording has no floor
  chooseTool(name);
}

function leave() {
  if ($("keys").open) { $("keys").close(); return; }
  if ($("camera-box").open) { $("camera-box").close(); return; }
  if (tool) chooseTool("");
  else send({ op: "unselect" });
}

function toggleKeys() {
  if ($("keys").open) $("keys").close();
  else $("keys").show();
}

function showEmpty() {
  const box = $("empty");
  box.hidden = !state.empty;
  if (!state.empty) return;
  setText($("empty-text"), state.empty);
  const isOffered = (row) => !row.on && !OWN_TOPICS.includes(row.topic);
  const topics = state.displays.filter(isOffered).slice(0, 6).map((row) => row.topic);
  const key = JSON.stringify(topics);
  if (box.dataset.key === key) return;
  box.dataset.key = key;
  $("empty-offers").replaceChildren(...topics.map((topic) => element("button", {
    textContent: `show ${topic}`, onclick: () => send({ op: "display", topic, on: true }) })));
}

showers.push(showEmpty);
$("key-rows").replaceChildren(...KEY_TEXTS.map(([key, text]) => element("tr", {},
  element("td", {}, element("kbd", { textContent: key })), element("td", { textContent: text }))));
$("fit").addEventListener("click", () => send({ op: "fit" }));
$("show-keys").addEventListener("click", toggleKeys);
$("close-keys").addEventListener("click", () => $("keys").close());
addEventListener("keydown", takeShortcut);
$("scene").addEventListener("load", () => {
  try { $("scene").contentWindow.addEventListener("keydown", takeShortcut); } catch { /* the scene is not loaded */ }
});

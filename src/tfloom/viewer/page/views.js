// What the pointer does in the scene, how the camera moves, and saved views.
"use strict";

const POINTER_MS = 100;
let pointerPlace = null;      // [across, down], each from 0 to 1; null where the pointer isn't in the scene
let pointerTold = "";

function placeIn(event) {
  const view = $("scene").contentWindow;
  return [event.clientX / view.innerWidth, event.clientY / view.innerHeight];
}

function tellPointer() {
  const view = $("scene").contentWindow;
  if (!state || !view || !view.innerWidth || !view.innerHeight) return;
  const told = { op: "pointer", at: pointerPlace, width: view.innerWidth, height: view.innerHeight };
  const key = JSON.stringify(told);
  if (key === pointerTold) return;
  pointerTold = key;
  send(told);
}

$("scene").addEventListener("load", () => {
  pointerTold = "";
  try {
    const view = $("scene").contentWindow;
    view.addEventListener("pointermove", (event) => { pointerPlace = placeIn(event); }, true);
    view.document.addEventListener("pointerleave", () => { pointerPlace = null; });
    view.addEventListener("pointerdown", () => holdCamera(null), true);
    for (const name of ["pointerup", "pointercancel", "blur"]) view.addEventListener(name, () => holdCamera(AFTER_MS), true);
    view.addEventListener("wheel", () => holdCamera(AFTER_MS), { capture: true, passive: true });
    view.addEventListener("keydown", (event) => { if (MOVING_KEYS.test(event.code)) holdCamera(1000); }, true);
    view.addEventListener("dblclick", (event) => send({ op: "look", at: placeIn(event) }), true);
  } catch { /* the scene is not loaded */ }
});
// While its user moves a camera that follows something, it is the user's; then it goes on from there.

const AFTER_MS = 300;         // a camera swings on for a moment
const MOVING_KEYS = /^(Key[WASDQE]|Arrow\w+)$/;
let ownCamera = { kind: "orbit", frame: "", turns: false, is_gone: false };
let heldUntil = null;         // the timer that ends it

function holdCamera(length_ms) {
  if (ownCamera.kind === "orbit" && !ownCamera.frame) return;
  clearTimeout(heldUntil);
  send({ op: "held", on: true });
  if (length_ms !== null) heldUntil = setTimeout(() => send({ op: "held", on: false }), length_ms);
}

takers.own_camera = (told) => {
  ownCamera = told;
  showCamera();
};

function selectedFrame() { return state && state.selection ? state.selection.frames[state.selection.frames.length - 1] : ""; }

function setCamera(change) {
  const { kind, frame, turns } = { ...ownCamera, ...change };
  send({ op: "camera", kind, frame, turns });
}

function followNext() {
  const frame = selectedFrame() || ownCamera.frame;
  if (!frame) say("select a frame, which the camera is to follow");
  else if (ownCamera.frame !== frame) setCamera({ frame, turns: false });
  else if (!ownCamera.turns) setCamera({ turns: true });
  else setCamera({ kind: ownCamera.kind === "first_person" ? "orbit" : ownCamera.kind, frame: "", turns: false });
}

const CAMERA_KEYS = {
  KeyO: () => setCamera({ kind: "orbit", frame: ownCamera.kind === "first_person" ? "" : ownCamera.frame }),
  KeyT: () => setCamera({ kind: "top", frame: ownCamera.kind === "first_person" ? "" : ownCamera.frame }),
  KeyI: () => setCamera({ kind: "first_person", frame: selectedFrame() || ownCamera.frame }),
  KeyL: followNext,
  KeyB: () => { if ($("camera-box").open) $("camera-box").close(); else { $("camera-box").show(); showCamera(); } },
};

function showCamera() {
  const said = ownCamera.is_gone ? `${ownCamera.frame} is gone: the camera stays where it is`
    : ownCamera.frame ? `the camera ${ownCamera.kind === "first_person" ? "is in" : "follows"} ${ownCamera.frame}` : "";
  if ($("camera-state").textContent !== said && (ownCamera.is_gone || $("message").textContent === $("camera-state").textContent)) say(said);
  setText($("camera-state"), said);
  if (!$("camera-box").open || !state) return;
  $("camera-kind").value = ownCamera.kind;
  setOptions($("camera-frame"), ["", ...state.frames], ownCamera.frame);
  $("camera-turns").checked = ownCamera.turns;
  const key = JSON.stringify(state.views);
  if ($("view-rows").dataset.key === key) return;
  $("view-rows").dataset.key = key;
  $("view-rows").replaceChildren(...state.views.map((name) => element("div", { className: "view" },
    element("span", { textContent: name, title: "look from there", onclick: () => send({ op: "show_view", name }) }),
    element("button", { textContent: "×", title: "forget this view", onclick: () => send({ op: "forget_view", name }) }))));
}

showers.push(showCamera);
$("camera-open").addEventListener("click", CAMERA_KEYS.KeyB);
$("camera-close").addEventListener("click", () => $("camera-box").close());
$("camera-kind").addEventListener("change", () => setCamera({ kind: $("camera-kind").value, frame: ownCamera.frame || (
  $("camera-kind").value === "first_person" ? selectedFrame() : "") }));
$("camera-frame").addEventListener("change", () => { setCamera({ frame: $("camera-frame").value }); $("camera-frame").blur(); });
$("camera-turns").addEventListener("change", () => setCamera({ turns: $("camera-turns").checked }));
$("view-save").addEventListener("click", () => { send({ op: "save_view", name: $("view-name").value }); $("view-name").value = ""; });
onPage.push(() => { ownCamera = { kind: "orbit", frame: "", turns: false, is_gone: false }; showCamera(); });
onPage.push(() => { pointerTold = ""; });
setInterval(tellPointer, POINTER_MS);

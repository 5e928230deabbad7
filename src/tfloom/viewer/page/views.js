// What the pointer does in the scene: the name of the frame that it is at is shown, and a double click fits the camera.
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
    view.addEventListener("dblclick", (event) => send({ op: "look", at: placeIn(event) }), true);
  } catch { /* the scene is not loaded */ }
});
onPage.push(() => { pointerTold = ""; });
setInterval(tellPointer, POINTER_MS);

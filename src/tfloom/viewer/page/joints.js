// The joints of a robot: a slider for each, with its limits.
"use strict";

const jointRows = new Map();
let heldJoint = "";           // the joint whose slider is being moved: what the server says of it is late

function jointText(joint, position) {
  if (joint.unit === "m") return `${position.toFixed(3)} m`;
  return `${position.toFixed(3)} rad, ${(position * 180 / Math.PI).toFixed(1)}°`;
}

function makeJointRow(joint) {
  const slider = element("input", { type: "range", className: "joint-slider", step: "any", title: joint.name });
  slider.setAttribute("aria-label", joint.name);
  slider.addEventListener("pointerdown", () => { heldJoint = joint.key; });
  for (const name of ["pointerup", "pointercancel", "blur"]) slider.addEventListener(name, () => { heldJoint = ""; });
  slider.addEventListener("input", () => send({ op: "joint", name: joint.key, position: Number(slider.value) }));
  const value = element("span", { className: "joint-value" });
  const ends = element("div", { className: "joint-ends" });
  const line = element("div", { className: "joint" },
    element("div", { className: "joint-head" }, element("span", { className: "joint-name", textContent: joint.name, title: joint.name }), value),
    slider, ends);
  line.dataset.joint = joint.key;
  return { line, slider, value, ends };
}

function showJoints() {
  const joints = state.joints;
  const tab = document.querySelector("#tabs [data-panel=joints]");
  // What nobody is there for.
  document.body.classList.toggle("alone", Boolean(joints) && !state.is_live && !state.is_recording);
  if (!joints) {  // also of a page that was one of a robot, of a viewer that has ended
    if (!tab.hidden) { tab.hidden = true; jointRows.clear(); $("joint-rows").replaceChildren(); openPanel("frames"); }
    return;
  }
  if (tab.hidden) { tab.hidden = false; if (!query.get("panel")) openPanel("joints"); }
  const keys = new Set(joints.map((joint) => joint.key));
  for (const key of [...jointRows.keys()]) if (!keys.has(key)) jointRows.delete(key);
  const lines = joints.map((joint) => {
    if (!jointRows.has(joint.key)) jointRows.set(joint.key, makeJointRow(joint));
    const row = jointRows.get(joint.key);
    row.slider.min = String(joint.least);
    row.slider.max = String(joint.greatest);
    row.slider.disabled = Boolean(joint.follows) || joint.least === joint.greatest;
    if (heldJoint !== joint.key) row.slider.value = String(joint.position);
    setText(row.value, jointText(joint, joint.position));
    setText(row.ends, joint.follows ? `follows ${joint.follows}`
      : `${jointText(joint, joint.least)} to ${jointText(joint, joint.greatest)}`);
    return row.line;
  });
  const body = $("joint-rows");
  if (lines.length !== body.children.length || lines.some((line, index) => body.children[index] !== line)) {
    body.replaceChildren(...lines);
  }
  const robot = state.displays.find((row) => row.kind === "RobotModel" && row.on);
  setText($("robot-status"), robot ? robot.status : joints.length ? "" : "no robot yet");
}

showers.push(showJoints);
$("pose-rest").addEventListener("click", () => send({ op: "pose", to: "rest" }));
$("pose-random").addEventListener("click", () => send({ op: "pose", to: "random" }));

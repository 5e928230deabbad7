// The settings of displays and of frames: a control for each, made of what the server says of it.
"use strict";

let known = null;             // by the label of a kind of display, its settings; those of frames
const opened = new Map();     // by the display's name, its controls
let isFramesOpen = false;

takers.settings = (told) => { known = told; fillPlain(); if (state) show(); };
onPage.push(() => send({ op: "settings" }));

const hex = (color) => `#${color.map((part) => part.toString(16).padStart(2, "0")).join("")}`;
const unhex = (text) => [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16));

// A control shows a value, and calls a function with what its user has chosen; null is the usual value.
const MAKERS = {
  number: (setting, say) => {
    const input = element("input", { type: "number", min: setting.least, max: setting.greatest,
      step: setting.is_whole ? "1" : "any", onchange: () => say(input.value === "" ? null : Number(input.value)) });
    return [input, (value) => { input.value = Number(value.toPrecision(7)); }];
  },
  color: (setting, say) => {
    const input = element("input", { type: "color", onchange: () => say(unhex(input.value)) });
    return [input, (value) => { input.value = hex(value); }];
  },
  flag: (setting, say) => {
    const input = element("input", { type: "checkbox", onchange: () => say(input.checked) });
    return [input, (value) => { input.checked = value; }];
  },
  choice: (setting, say) => {
    const select = element("select", { onchange: () => { say(select.value); select.blur(); } },
      ...setting.options.map((value) => element("option", { value, textContent: value.replaceAll("_", " ") })));
    return [select, (value) => { select.value = value; }];
  },
  text: (setting, say) => {
    const input = element("input", { onchange: () => say(input.value) });
    return [input, (value) => { input.value = value; }];
  },
  names: (setting, say) => {
    const box = element("div", { className: "names" });
    return [box, (hidden, parts) => {
      const names = [...new Set([...parts, ...hidden])];
      const key = JSON.stringify([names, hidden]);
      if (box.dataset.key === key) return;
      box.dataset.key = key;
      box.replaceChildren(...names.map((name) => {
        const mark = element("input", { type: "checkbox", checked: !hidden.includes(name),
          onchange: () => say(mark.checked ? hidden.filter((one) => one !== name) : [...hidden, name]) });
        const label = element("label", {}, mark, ` ${name || "(no name)"}`);
        label.dataset.part = name;
        return label;
      }));
    }];
  },
};

function makeControls(settings, say) {
  const shown = {};
  const lines = Object.entries(settings).map(([name, setting]) => {
    const [control, set] = MAKERS[setting.kind](setting, (value) => say(name, value));
    const text = element("span", { className: "setting-name", textContent: name.replaceAll("_", " "),
      title: `double click: as usual (${setting.usual})`, ondblclick: () => say(name, null) });
    shown[name] = { control, set };
    const line = element("div", { className: "setting" }, text, control);
    line.dataset.setting = name;
    return line;
  });
  return { box: element("div", { className: "settings" }, ...lines), shown };
}

function setControls(controls, values, parts) {
  for (const [name, { control, set }] of Object.entries(controls.shown)) {
    if (name in values && !control.contains(document.activeElement)) set(values[name], parts);
  }
}

// Behind each display that is on: what opens its settings, and another display of its topic.
function showSettings() {
  if (!known) return;
  for (const row of state.displays) {
    const parts = displays.get(row.topic);
    if (!parts) continue;
    if (!parts.more) {
      parts.more = element("button", { textContent: "…", title: "settings", className: "more", onclick: () => toggleSettings(row.topic) });
      parts.again = element("select", { title: "show this topic once more", className: "again",
        onchange: () => { send({ op: "another", topic: parts.of, kind: parts.again.value }); parts.again.value = "+"; parts.again.blur(); } });
      parts.line.append(parts.again, parts.more);
    }
    parts.of = row.of_topic;
    const settings = known.kinds[row.kind] || {};
    parts.more.hidden = !row.on || !Object.keys(settings).length;
    parts.again.hidden = !row.on || !row.kinds.length;
    setOptions(parts.again, ["+", ...row.kinds], "+");
    let controls = opened.get(row.topic);
    if (controls && (parts.more.hidden || controls.kind !== row.kind)) { closeSettings(row.topic); controls = null; }
    if (controls) setControls(controls, row.values, row.parts);
  }
  for (const name of [...opened.keys()]) if (!state.displays.some((row) => row.topic === name)) closeSettings(name);
  if (isFramesOpen) setControls(frameControls(), state.frame_settings, state.frames);
}

function closeSettings(name) {
  opened.get(name).box.remove();
  opened.delete(name);
}

function toggleSettings(name) {
  if (opened.has(name)) { closeSettings(name); return; }
  const row = state.displays.find((one) => one.topic === name);
  const controls = makeControls(known.kinds[row.kind], (setting, value) => send({ op: "set", topic: name, setting, value }));
  controls.kind = row.kind;
  opened.set(name, controls);
  displays.get(name).line.append(controls.box);
  setControls(controls, row.values, row.parts);
}

let made = null;
function frameControls() {
  if (!made) {
    made = makeControls(known.frames, (setting, value) => send({ op: "set_frames", setting, value }));
    $("frame-settings").append(made.box);
  }
  return made;
}

$("frames-more").addEventListener("click", () => {
  isFramesOpen = !isFramesOpen;
  $("frame-settings").hidden = !isFramesOpen;
  if (isFramesOpen && known) setControls(frameControls(), state.frame_settings, state.frames);
});

// Displays without a topic.
function fillPlain() {
  const names = ["add …", ...known.plain];
  $("add-plain").replaceChildren(...names.map((value) => element("option", { value, textContent: value })));
}
$("add-plain").addEventListener("change", () => {
  if ($("add-plain").value !== "add …") send({ op: "another", topic: "", kind: $("add-plain").value });
  $("add-plain").value = "add …";
  $("add-plain").blur();
});

showers.push(showSettings);

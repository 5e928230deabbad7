// Forms made from any type: to publish, to call a service, to send a goal. What is filled in is read back as values of
// JSON, in which numbers are texts: the server checks them, and knows those of 64 bits.
"use strict";

const EMPTY_FORM_NAMES = { names: [], types: [] };
const MAX_ROWS = 200;          // of an array whose elements have rows of their own
let formNames = EMPTY_FORM_NAMES;
let form = null;               // what is filled in: { what, name, type, read() }
let formKey = "";              // the page's own name of what was sent last
let formCount = 0;
let sendingKey = "";           // of what is published at a rate
let formAsked = "";            // of which name and type the form is, or was asked for

const SEND_WORDS = { topic: "Publish", service: "Call", action: "Send goal" };

function formWhat() { return $("form-what").value; }

function askFormNames() { send({ op: "form_names", what: formWhat() }); }

takers.form_names = (found) => {
  if (found.what !== formWhat()) return;
  formNames = found;
  $("form-names").replaceChildren(...found.names.map(([name, type]) => element("option", { value: name, label: type })));
  $("form-types").replaceChildren(...found.types.map((type) => element("option", { value: type })));
};

function askForm() {
  const name = $("form-name").value.trim();
  const known = formNames.names.find(([other]) => other === name || other === `/${name}`);
  if (known) $("form-type").value = known[1];
  if (!name || (!known && !$("form-type").value.trim())) return;
  const type = $("form-type").value.trim();
  const asked = JSON.stringify([name.replace(/^\/?/, "/"), type]);
  if (asked === formAsked) return;   // it stays as it is filled in
  formAsked = asked;
  formSay("");
  send({ op: "form", what: formWhat(), name, type, key: "form" });
}

takers.form = (made) => {
  if (made.what !== formWhat()) return;
  $("form-name").value = made.name;
  $("form-type").value = made.type;
  formAsked = JSON.stringify([made.name, made.type]);
  const fields = makeFields(made, made.root);
  form = { what: made.what, name: made.name, type: made.type, read: fields.read };
  $("form-fields").replaceChildren(fields.node);
  $("form-send").textContent = SEND_WORDS[made.what];
  $("form-rate-label").hidden = made.what !== "topic";
  $("form-send").disabled = false;
};

function dropForm() {
  form = null;
  formAsked = "";
  $("form-fields").replaceChildren();
  $("form-send").disabled = true;
}

// Each of these returns { node, read() }; `read` gives the value, or undefined where nothing is to be said.

function makeFields(made, type) {
  const parts = made.types[type].map((field) => [field, makeField(made, field)]);
  const node = element("div", { className: "fields" });
  for (const [field, part] of parts) {
    const title = `${field.type}${field.bound ? `, at most ${field.bound} characters` : ""}`;
    const line = element("div", { className: "field" }, element("span", { className: "field-name", textContent: field.name, title }), part.node);
    line.dataset.field = field.name;
    node.append(line);
  }
  if (!parts.length) node.append(element("span", { className: "hint", textContent: "no fields" }));
  return { node, read: () => {
    const values = {};
    for (const [field, part] of parts) {
      const value = part.read();
      if (value !== undefined) values[field.name] = value;
    }
    return values;
  } };
}

function makeField(made, field) {
  if (!field.shape) return makeValue(made, field, field.value);
  if (["integer", "float", "bool"].includes(field.kind)) return makeNumbers(field);
  return makeRows(made, field);
}

// An array of numbers is one line of text.
function makeNumbers(field) {
  const input = element("input", { value: (field.value || []).join(", "), title: field.type, placeholder: field.type });
  return { node: input, read: () => {
    const parts = input.value.split(/[\s,;[\]]+/).filter(Boolean);
    return parts.length || field.shape !== "array" ? parts : undefined;   // an empty array of fixed length: its default
  } };
}

// An array of texts or messages has a row for each element, which are added and removed, if its length isn't fixed.
function makeRows(made, field) {
  const rows = [];
  const box = element("div", { className: "rows" });
  const most = field.shape === "bounded" ? Math.min(field.length, MAX_ROWS) : MAX_ROWS;
  const isFixed = field.shape === "array";
  const add = (value) => {
    if (rows.length >= (isFixed ? Math.min(field.length, MAX_ROWS) : most)) return;
    const part = makeValue(made, field, value);
    const row = element("div", { className: "row" });
    const remove = element("button", { textContent: "−", title: "remove", onclick: () => {
      rows.splice(rows.findIndex((other) => other.part === part), 1);
      row.remove();
    } });
    row.append(...(isFixed ? [] : [remove]), part.node);
    rows.push({ part });
    box.append(row);
  };
  const defaults = field.value || [];
  if (isFixed && field.length <= MAX_ROWS) for (let index = 0; index < field.length; ++index) add(defaults[index] || "");
  else defaults.forEach(add);
  const more = element("button", { className: "add", textContent: "+", title: `add an element of ${field.type}`, onclick: () => add("") });
  const node = element("div", {}, box, ...(isFixed ? [] : [more]));
  return { node, read: () => (rows.length || !isFixed ? rows.map(({ part }) => part.read()) : undefined) };
}

let listCount = 0;

function makeValue(made, field, value) {
  if (field.kind === "message") {
    const inner = makeFields(made, field.base);
    return { node: element("details", { open: true }, element("summary", { textContent: field.base }), inner.node), read: inner.read };
  }
  if (field.kind === "time") return makeTime(field);
  if (field.kind === "bool") {
    const box = element("input", { type: "checkbox", checked: value === "true" });
    return { node: box, read: () => box.checked };
  }
  const range = field.kind === "integer" ? `${field.min} to ${field.max}` : field.type;
  const input = element("input", { value: value || "", title: field.kind === "integer" ? `${field.type}: ${range}` : field.type });
  if (field.kind === "text" && field.bound) input.maxLength = field.bound;
  if (field.kind !== "text") input.className = "one-number";
  if (!field.choices.length) return { node: input, read: () => readText(field, input) };
  const list = element("datalist", { id: `choices-${++listCount}` },
    ...field.choices.map(([name, choice]) => element("option", { value: choice, label: `${name} = ${choice}` })));
  input.setAttribute("list", list.id);
  // The name of what is chosen stands beside it.
  const chosen = element("span", { className: "hint" });
  const showChosen = () => {
    const names = field.choices.filter(([, choice]) => choice === input.value.trim()).map(([name]) => name);
    chosen.textContent = names.join(", ");
  };
  input.addEventListener("input", showChosen);
  showChosen();
  return { node: element("span", {}, input, list, " ", chosen), read: () => readText(field, input) };
}

function readText(field, input) {
  const text = input.value;
  return field.kind === "text" ? text : text.trim() || "0";
}

function makeTime(field) {
  const now = element("input", { type: "checkbox", checked: !field.shape });
  const sec = element("input", { value: "0", className: "one-number", title: "seconds" });
  const nanosec = element("input", { value: "0", className: "one-number", title: "nanoseconds" });
  const showNow = () => { sec.disabled = nanosec.disabled = now.checked; };
  now.addEventListener("change", showNow);
  showNow();
  const node = element("span", {}, ...(field.shape ? [] : [element("label", {}, now, " now ")]), sec, nanosec);
  return { node, read: () => (now.checked ? "now" : { sec: sec.value.trim() || "0", nanosec: nanosec.value.trim() || "0" }) };
}

// Sending, and what comes of it.

function formSay(text, isError = false) {
  $("form-answer").textContent = text;
  $("form-answer").classList.toggle("error", isError);
}

function sendForm() {
  if (!form) return;
  const key = `${page}-${++formCount}`;
  const command = { op: "send", key, what: form.what, name: form.name, type: form.type, values: form.read() };
  const rate = form.what === "topic" ? Number($("form-rate").value) : 0;
  if (!(rate >= 0)) { formSay("a rate is a number, in Hz", true); return; }
  if (rate) command.rate_hz = rate;
  if (JSON.stringify(command).length > 60000) { formSay("a form may be 60,000 characters long", true); return; }
  // What is refused above leaves what is published at a rate as it is, and "Stop" is of that.
  if (sendingKey) send({ op: "cancel", key: sendingKey });
  formKey = key;
  sendingKey = rate ? key : "";
  formSay("…");
  $("form-state").textContent = "";
  $("form-cancel").hidden = form.what !== "action" && !rate;
  $("form-cancel").textContent = rate ? "Stop" : "Cancel";
  send(command);
}

takers.sent = ({ key, state: sentState, text }) => {
  if (key === "form") { dropForm(); formSay(text, true); return; }
  if (key !== formKey) return;
  if (sentState === "accepted") { $("form-state").textContent = text; return; }
  if (sentState === "waiting") return;
  // A count doesn't hide why a further form was refused.
  if (sentState !== "feedback" || !$("form-answer").classList.contains("error")) formSay(text, sentState === "error");
  if (sentState === "feedback") $("form-state").textContent = sendingKey === key ? "publishing" : "feedback";
  if (["done", "error"].includes(sentState)) {
    formKey = sendingKey = "";
    $("form-cancel").hidden = true; $("form-state").textContent = ""; }
};

// A connection that is opened anew is another page for the server, which has ended what that before had begun.
onPage.push(() => {
  if (formKey) takers.sent({ key: formKey, state: "error", text: "the connection was lost, which has ended it" });
});

openers.send = askFormNames;
$("form-what").addEventListener("change", () => {
  formNames = EMPTY_FORM_NAMES;
  $("form-name").value = $("form-type").value = "";
  dropForm();
  formSay("");
  askFormNames();
});
$("form-name").addEventListener("change", () => {
  if (form && form.name !== $("form-name").value.trim().replace(/^\/?/, "/")) { dropForm(); $("form-type").value = ""; }
  askForm();
});
$("form-type").addEventListener("change", askForm);
$("form-name").addEventListener("focus", askFormNames);
$("form-send").addEventListener("click", sendForm);
$("form-cancel").addEventListener("click", () => send({ op: "cancel", key: formKey }));

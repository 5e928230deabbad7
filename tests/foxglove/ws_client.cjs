// Drives the client @foxglove/ws-protocol: each line of the input is [method, ...arguments], each line of the output
// {event, value}, where the event "method()" is what a method returned. Bytes are {hex} in the input, and texts of
// hexadecimal digits in the output.
"use strict";

const { FoxgloveClient } = require("@foxglove/ws-protocol");
const WebSocket = require("ws");

const EVENTS = [
  "open", "error", "serverInfo", "status", "message", "advertise", "advertiseServices", "parameterValues",
  "serviceCallResponse", "serviceCallFailure", "connectionGraphUpdate", "fetchAssetResponse",
];

function sendable(_, value) {
  if (typeof value === "bigint") return value.toString();
  if (value instanceof Error) return value.message;
  if (!ArrayBuffer.isView(value)) return value;
  return Buffer.from(value.buffer, value.byteOffset, value.byteLength).toString("hex");
}

function print(event, value) {
  process.stdout.write(JSON.stringify({ event, value }, sendable) + "\n");
}

function reviver(_, value) {
  if (value === null || typeof value.hex !== "string") return value;
  const bytes = Uint8Array.from(Buffer.from(value.hex, "hex"));
  return new DataView(bytes.buffer);
}

const [port, subprotocol] = process.argv.slice(2);
const ws = new WebSocket(`ws://127.0.0.1:${port}`, [subprotocol || FoxgloveClient.SUPPORTED_SUBPROTOCOL]);
const client = new FoxgloveClient({ ws });
for (const event of EVENTS) client.on(event, (value) => print(event, value));
client.on("close", () => process.exit(0));
require("node:readline").createInterface({ input: process.stdin }).on("line", (line) => {
  const [method, ...args] = JSON.parse(line, reviver);
  if (method === "sendMessage") args[1] = new Uint8Array(args[1].buffer);
  print(`${method}()`, client[method](...args));
}).on("close", () => client.close());

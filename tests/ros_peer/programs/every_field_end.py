"""Messages of test_msgs with all fields filled; tfloom and the real rclpy run it unchanged.

serialize                    print the octets of each as JSON
deserialize                  print the names of those whose octets, JSON on stdin, are read as the filled message
compare                      print how many octets of each, JSON on stdin, differ in more than padding
publish, receive             publish them, and serve the services; receive them, and call the services
"""

from __future__ import annotations

import contextlib
import json
import sys
from collections.abc import Iterator
from typing import Any

import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.serialization import deserialize_message, serialize_message
from rosidl_parser.definition import (
    AbstractNestedType,
    AbstractSequence,
    AbstractWString,
    BasicType,
    NamespacedType,
)
from test_msgs import action, msg, srv

MESSAGES = {name: getattr(msg, name) for name in sorted(dir(msg)) if name[0].isupper()}
SERVICES = {name: getattr(srv, name) for name in ("Arrays", "BasicTypes", "Empty")}
PARTS = {
    f"{name}_{part}": getattr(cls, part) for name, cls in SERVICES.items() for part in ("Request", "Response")
} | {f"Nested_{part}": getattr(action.NestedMessage, part) for part in ("Goal", "Result", "Feedback")}
ALL = MESSAGES | PARTS
RANGES = {
    f"{sign}int{bits}": (0 if sign else -(2 ** (bits - 1)), 2 ** (bits - (not sign)) - 1)
    for sign in ("", "u")
    for bits in (8, 16, 32, 64)
}
QUALITY = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def filled(cls: Any, seed: int = 3) -> Any:
    """Return a message whose fields all hold values that differ from one another."""
    message = cls()
    names = list(cls.get_fields_and_field_types())
    for number, (name, type_) in enumerate(zip(names, cls.SLOT_TYPES, strict=True)):
        value = value_of(type_, seed * 31 + number, getattr(message, name))
        if name != "structure_needs_at_least_one_member":
            setattr(message, name, value)
    return message


def value_of(type_: Any, seed: int, present: Any) -> Any:
    if isinstance(type_, AbstractNestedType):
        count = min(getattr(type_, "size", 99), getattr(type_, "maximum_size", 99), 3 + seed % 2)
        if isinstance(type_, AbstractSequence):
            count = max(1, count - seed % 2)
        return [value_of(type_.value_type, seed + index, None) for index in range(count)]
    if isinstance(type_, NamespacedType):
        return filled(getattr(msg, type_.name) if present is None else type(present), seed)
    if not isinstance(type_, BasicType):
        text = f"hällo ハ {seed}" if isinstance(type_, AbstractWString) else f"text {seed}"
        return text[: getattr(type_, "maximum_size", None)]
    if type_.typename == "boolean":
        return seed % 2 == 1
    if type_.typename == "octet":
        return bytes([seed % 256])
    if type_.typename in RANGES:
        least, most = RANGES[type_.typename]
        return most - seed % 5 if seed % 2 else least + seed % 7
    return seed + 0.5


def serialize() -> Iterator[tuple[str, str]]:
    for name, cls in ALL.items():
        yield name, serialize_message(filled(cls)).hex()


def deserialize(octets: dict[str, str]) -> Iterator[str]:
    for name, cls in ALL.items():
        if deserialize_message(bytes.fromhex(octets[name]), cls) == filled(cls):
            yield name


def compare(octets: dict[str, str]) -> Iterator[tuple[str, int]]:
    """Yield the number of differing octets on which a message's content depends."""
    for name, cls in ALL.items():
        ours, theirs = serialize_message(filled(cls)), bytes.fromhex(octets[name])
        places = [place for place, (our, their) in enumerate(zip(ours, theirs, strict=False)) if our != their]
        yield name, sum(matters(cls, ours, place) for place in places) + max(0, len(ours) - len(theirs))


def matters(cls: Any, octets: bytes, place: int) -> bool:
    changed = bytearray(octets)
    changed[place] ^= 0xFF
    try:
        return bool(deserialize_message(bytes(changed), cls) != deserialize_message(octets, cls))
    except ValueError:
        return True


def publish(node: Node) -> None:
    def serve(request: Any, response: Any) -> Any:
        print("request", request == filled(type(request)), flush=True)
        return filled(type(response))

    for name, cls in SERVICES.items():
        node.create_service(cls, f"service_{name}", serve)
    for name, cls in MESSAGES.items():
        node.create_publisher(cls, f"topic_{name}", QUALITY).publish(filled(cls))
    print("ready", flush=True)
    rclpy.spin(node)


def receive(node: Node) -> None:
    waiting = set(MESSAGES)

    def take(name: str, message: Any) -> None:
        if name in waiting:
            waiting.discard(name)
            print("message", name, message == filled(ALL[name]), flush=True)

    for name in sorted(waiting):
        node.create_subscription(
            ALL[name], f"topic_{name}", lambda each, name=name: take(name, each), QUALITY
        )
    while waiting:
        rclpy.spin_once(node)
    for name, cls in SERVICES.items():
        client = node.create_client(cls, f"service_{name}")
        while not client.wait_for_service(1.0):
            print("waiting for", name, flush=True)
        future = client.call_async(filled(cls.Request))
        rclpy.spin_until_future_complete(node, future)
        print("response", name, future.result() == filled(cls.Response), flush=True)


def main() -> None:
    verb, *arguments = sys.argv[1:]
    if verb == "serialize":
        print(json.dumps(dict(serialize())))
    elif verb == "compare":
        print(json.dumps(dict(compare(json.loads(sys.stdin.read())))))
    elif verb == "deserialize":
        print(json.dumps(list(deserialize(json.loads(sys.stdin.read())))))
    else:
        rclpy.init(args=arguments)
        node = rclpy.create_node(f"end_that_{verb}s")
        with contextlib.suppress(ExternalShutdownException):
            {"publish": publish, "receive": receive}[verb](node)
        node.destroy_node()
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()

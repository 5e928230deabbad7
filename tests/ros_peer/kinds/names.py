"""Names of nodes, namespaces, topics and services: their rules, their expansion, and what remap rules make of them."""

from __future__ import annotations

import random
from collections.abc import Callable
from functools import cache
from typing import Any

import rclpy
from rclpy.expand_topic_name import expand_topic_name
from rclpy.node import Node
from rclpy.topic_or_service_is_hidden import topic_or_service_is_hidden
from rclpy.utilities import remove_ros_args
from rclpy.validate_full_topic_name import validate_full_topic_name
from rclpy.validate_namespace import validate_namespace
from rclpy.validate_node_name import validate_node_name
from rclpy.validate_topic_name import validate_topic_name

WORDS = [
    "a",
    "b",
    "chat",
    "ns",
    "node",
    "x1",
    "_h",
    "__x",
    "1",
    "a_b",
    "A",
    "nd",
    "é",
    "rostopic",
    "a__b",
    "_",
    "__",
]
PIECES = [
    *WORDS,
    "/",
    "/",
    "/",
    "~",
    "~/",
    "{node}",
    "{ns}",
    "{namespace}",
    "{x}",
    "{",
    "}",
    " ",
    "-",
    ".",
    ":",
    "=",
    "",
]
SPECIAL = ["__node", "__name", "__ns", "__log_level", "__params", "__enclave"]
CHECKS: dict[str, Callable[..., Any]] = {
    "node": validate_node_name,
    "namespace": validate_namespace,
    "topic": validate_topic_name,
    "service": lambda name: validate_topic_name(name, is_service=True),
    "full topic": validate_full_topic_name,
    "full service": lambda name: validate_full_topic_name(name, is_service=True),
    "hidden": topic_or_service_is_hidden,
}
TOPICS = ["chat", "/chat", "~/chat", "a/b", "/a/b", "/ns/chat", "~", "{node}/chat", "/nd/chat"]


def draw(random: random.Random) -> Any:
    door = random.choice(["check", "expand", "rules", "rules", "words", "node"])
    if door == "check":
        return ["check", random.choice(list(CHECKS)), _name(random)]
    if door == "expand":
        return ["expand", _name(random), _mostly(random, "nd", _name), _mostly(random, "/ns", _name)]
    if door == "node":
        return ["node", _mostly(random, "nd", _name), _mostly(random, "/ns", _name), _name(random)]
    rules = [_rule(random) for _ in range(random.randint(1, 4))]
    if door == "words":
        words = [random.choice([rule, "word", "--ros-args", "--", "-r", "--remap", "--x"]) for rule in rules]
        return ["words", ["program", *words]]
    return ["rules", rules, random.choice(["/", "/ns", "/ns/sub"])]


def run(case: Any) -> Any:
    door, *rest = case
    return {"check": _check, "expand": _expand, "rules": _rules, "words": _words, "node": _node_names}[door](
        *rest
    )


def _mostly(random: random.Random, usual: str, draw_other: Callable[[random.Random], str]) -> str:
    return usual if random.random() < 0.7 else draw_other(random)


def _name(random: random.Random) -> str:
    if random.random() < 0.03:
        return random.choice(["/", ""]) + "a" * random.choice([244, 245, 246, 247, 248, 254, 255, 256])
    return "".join(random.choices(PIECES, k=random.randint(0, 5)))


def _sound_name(random: random.Random) -> str:
    start = random.choice(["", "/", "~/", "{node}/", "{ns}/", "/{node}/"])
    return start + "/".join(random.choices(["a", "b", "chat", "ns", "nd"], k=random.randint(1, 2)))


def _rule(random: random.Random) -> str:
    node = random.choice(["", "", "", "nd:", "other:", "q:", f"{random.choice(WORDS)}:"])
    scheme = random.choice(["", "", "", "", "rostopic://", "rosservice://", "rosaction://", "rostopic:"])
    chosen = random.random()
    if chosen < 0.2:
        return (
            f"{node}{random.choice(SPECIAL)}:={random.choice(['q', '/s', '/s/t', 's', '/', _name(random)])}"
        )
    if chosen < 0.7:
        return f"{node}{scheme}{_sound_name(random)}:={_sound_name(random)}"
    return f"{node}{scheme}{_name(random)}{random.choice([':=', ':=', ':=', '=', ':'])}{_name(random)}"


# Running


def _told(error: Exception) -> Any:
    return [type(error).__name__, str(error)]


def _check(check: str, name: str) -> Any:
    try:
        return CHECKS[check](name)
    except Exception as error:  # noqa: BLE001  # it is the answer
        return _told(error)


def _expand(name: str, node: str, namespace: str) -> Any:
    try:
        return expand_topic_name(name, node, namespace)
    except ValueError:  # of a class derived from it, here
        return "ValueError"


@cache
def _context() -> Any:
    context = rclpy.Context()
    rclpy.init(args=[], context=context)
    return context


def _node(arguments: list[str], name: str = "nd", namespace: str = "/") -> Node:
    return Node(
        name,
        namespace=namespace,
        context=_context(),
        cli_args=arguments,
        use_global_arguments=False,
        enable_rosout=False,
        start_parameter_services=False,
    )


def _names_of(node: Node, topics: list[str]) -> Any:
    try:
        answer: dict[str, Any] = {"node": node.get_name(), "namespace": node.get_namespace()}
        answer["full"] = node.get_fully_qualified_name()
        answer["logger"] = node.get_logger().name
        for resolve in (node.resolve_topic_name, node.resolve_service_name):
            for topic in topics:
                try:
                    answer[f"{resolve.__name__} {topic}"] = resolve(topic)
                except Exception as error:  # noqa: BLE001  # it is the answer
                    answer[f"{resolve.__name__} {topic}"] = [type(error).__name__]
        return answer
    finally:
        node.destroy_node()


def _rules(rules: list[str], namespace: str) -> Any:
    words = [word for rule in rules for word in ("-r", rule)]
    return _names_of(_node(["--ros-args", *words], namespace=namespace), TOPICS)


def _words(words: list[str]) -> Any:
    return [remove_ros_args(words), _names_of(_node(words), TOPICS[:3])]


def _node_names(name: str, namespace: str, topic: str) -> Any:
    return _names_of(_node([], name, namespace), [topic])


# Differences on purpose


def _is_resolved(case: Any, theirs: Any, ours: Any) -> bool:
    """Return whether only the classes of errors of `resolve_…` differ."""
    their_names, our_names = (answer[1] if case[0] == "words" else answer for answer in (theirs, ours))
    if "node" not in their_names or "node" not in our_names:
        return False
    different = {key for key in our_names if our_names[key] != their_names.get(key)}
    return all(
        their_names[key] == ["RCLError"] and our_names[key][0].startswith("Invalid") for key in different
    )


def _is_length(case: Any, theirs: Any, ours: Any) -> bool:
    """Return whether their text has the name of a number, or their place is that of a byte."""
    if case[0] != "check" or not isinstance(theirs, list) or not isinstance(ours, list):
        return False
    lines = [text.splitlines()[0].partition("exceed") for _, text in (theirs, ours)]
    is_at_byte = not case[2].isascii() or lines[0][1] == "exceed"
    return theirs[0] == ours[0] and is_at_byte and lines[0][:2] == lines[1][:2]


def _is_late(case: Any, theirs: Any, ours: Any) -> bool:
    classes = ("RCLInvalidROSArgsError", "InvalidServiceNameException", "InvalidNamespaceException")
    if theirs == {"error": "RCLError"}:
        return ours in [{"error": name} for name in classes]
    rules = case[1] if case[0] in {"rules", "words"} else []
    is_of_other = any("__ns:=" in rule and (rule.endswith("/") or len(rule) > 240) for rule in rules)
    return is_of_other and ours == {"error": classes[0]}


KNOWN = {"names-resolve-error": _is_resolved, "names-length-text": _is_length, "names-remap-late": _is_late}

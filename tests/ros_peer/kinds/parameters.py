"""Values of parameters and whole parameter files: through -p, --params-file and the setting of parameters.

A case is a door and what passes it. The answer has the type and the value of each parameter that the node has then.
"""

from __future__ import annotations

import random
import re
import tempfile
from collections.abc import Callable, Sequence
from functools import cache
from pathlib import Path
from typing import Any

import rclpy
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor
from rclpy.node import Node
from rclpy.parameter import Parameter

Draw = Callable[[random.Random], str]
NODE = "the_node"
WORDS = [
    "y",
    "n",
    "yes",
    "no",
    "on",
    "off",
    "true",
    "false",
    "null",
    "~",
    "inf",
    "nan",
    "infinity",
    ".inf",
    ".nan",
]
WORDS += [
    "nan(1)",
    "abc",
    "a b",
    "x/y",
    "0b1",
    "0o7",
    "1_000",
    "1:30",
    "2024-01-01",
    "=",
    "<<",
    "é",
    "😀",
    "-",
    "a-b",
]
EDGES = [
    "0",
    "1",
    "7",
    "8",
    "9",
    "08",
    "017",
    "0777",
    "9223372036854775807",
    "9223372036854775808",
    "1e308",
    "1e309",
]
EDGES += [
    "4.9e-324",
    "2.3e-308",
    "0x7fffffffffffffff",
    "0xffffffffffffffff",
    "18446744073709551616",
    "1" * 30,
]
# No name is another's beginning, because the reference's answer to one that is there twice depends on both types.
NAMES = [
    "x",
    "y",
    "a.b",
    "c",
    "speed",
    "on",
    "5",
    "x y",
    "a-b",
    "use_sim_time",
    "'q'",
    '"r.s"',
    "/x",
    "~",
    "é",
]
RULE_NAMES = [
    "x",
    "a.b",
    "a/b",
    "_x",
    "x1.y2",
    "__x",
    "a..b",
    "x-y",
    "5",
    "",
    ".x",
    "x.",
    "/x",
    "x/",
    "a b",
    "é",
    "~/x",
]
NODES = [
    "/**",
    "'/**'",
    NODE,
    f"/{NODE}",
    "/*",
    f"/**/{NODE}",
    "/other",
    "/ns",
    "/",
    f"/ns/{NODE}",
    "'*'",
    "a*",
    "//a",
]
RULE_NODES = [NODE, "other", f"/{NODE}", "/**", "*", "a.b", "__node", "_a", "5", ""]
INSERTED = [
    "\t",
    "\t",
    "\t",
    " ",
    "\n",
    "'",
    '"',
    "#",
    " # c",
    ":",
    ": ",
    ",",
    "[",
    "]",
    "{",
    "}",
    "-",
    "- ",
    "!",
    "&",
]
INSERTED += [
    "*a",
    "|",
    ">",
    "%",
    "@",
    "`",
    "?",
    "\\",
    "\r",
    "\u2028",
    "\u0085",
    "\u007f",
    "---\n",
    "...\n",
]


def draw(random: random.Random) -> Any:
    door = random.choice(["rule", "rule", "file", "file", "set"])
    if door == "set":
        return ["set", _declaration(random), [_python_value(random) for _ in range(random.randint(1, 3))]]
    if door == "rule":
        node = f"{random.choice(RULE_NODES)}:" if random.random() < 0.15 else ""
        name = random.choice(RULE_NAMES) if random.random() < 0.2 else "x"
        return ["rule", f"{node}{name}:={_spoilt(random, _value(random, 0))}"]
    return ["file", _spoilt(random, _document(random))]


def run(case: Any) -> Any:
    door, *rest = case
    return {"rule": _rule, "file": _file, "set": _set}[door](*rest)


# Texts that are drawn


def _number(random: random.Random) -> str:
    sign = random.choice(["", "", "", "-", "+"])
    digits = "".join(random.choices("0123456789", k=random.choice([1, 1, 2, 3, 6, 19, 22])))
    forms = [
        lambda: digits,
        lambda: f"{digits}.{random.choice(['', '0', '5', '125'])}",
        lambda: f".{digits}",
        lambda: (
            f"{digits}e{random.choice(['', '+', '-'])}{random.choice([0, 1, 3, 20, 300, 308, 309, 320, 324, 400])}"
        ),
        lambda: f"{digits}.5E{random.randint(-330, 330)}",
        lambda: (
            f"0x{random.choice(['', 'f', '1F', '10', 'g', '1.8', '.8', 'ffffffffffffffff', '1p3', '1.8P-3', 'p1'])}"
        ),
        lambda: f"0x1p{random.choice(['-1074', '-1075', '1023', '1024', '+2'])}",
        lambda: f"0{random.choice(['7', '8', '17', '08', '0'])}",
        lambda: random.choice(EDGES),
    ]
    return sign + random.choice(forms)()


def _word(random: random.Random) -> str:
    word = random.choice(WORDS)
    return random.choice(
        [word, word, word.upper(), word.capitalize(), word.swapcase(), f"-{word}", f"+{word}"]
    )


def _text(random: random.Random) -> str:
    return "".join(random.choices("abyn01.e-+ :,#'\"\\/é~_!|>*&%@", k=random.randint(0, 6)))


def _double_quoted(random: random.Random) -> str:
    escapes = [
        "\\n",
        "\\t",
        '\\"',
        "\\\\",
        "\\x41",
        "\\u00e9",
        "\\q",
        "\\ ",
        "\\e",
        "\\N",
        "\\/",
        "\\U0001F600",
    ]
    parts = [random.choice([*escapes, "a", "5", " ", "'", ": ", "#"]) for _ in range(random.randint(0, 4))]
    return f'"{"".join(parts)}"'


def _plain(random: random.Random) -> str:
    return random.choice([_number, _number, _word, _word, _text])(random)


def _scalar(random: random.Random) -> str:
    drawn = _plain(random)
    forms = [
        lambda: drawn,
        lambda: drawn,
        lambda: drawn,
        lambda: "'{}'".format(drawn.replace("'", "''")),
        lambda: _double_quoted(random),
        lambda: f"{random.choice(['!!str', '!!int', '!!float', '!!bool', '!!null', '!x', '!'])} {drawn}",
        lambda: f"&a {drawn}",
    ]
    return random.choice(forms)()


def _value(random: random.Random, indent: int) -> str:
    space = " " * indent
    chosen = random.random()
    if chosen < 0.6:
        return _scalar(random)
    if chosen < 0.85:
        same = random.choice(
            [_number, _word, _plain, _scalar, lambda generator: random.choice(["1", "2.5", "inf"])]
        )
        items = [same(random) for _ in range(random.randint(0, 4))]
        if random.random() < 0.5:
            return f"[{random.choice([', ', ',', ' , ']).join(items)}{random.choice(['', '', ',', ' '])}]"
        return "".join(f"\n{space}- {item}" for item in items) if items else "[]"
    if chosen < 0.93:
        lines = [f"\n{space}  {_plain(random)}" for _ in range(random.randint(1, 3))]
        return random.choice(["|", "|-", ">", ">-", "|+", ""]) + "".join(lines)
    return _mapping(random, indent + 2, depth=2) if indent else f"{{a: {_scalar(random)}}}"


def _mapping(random: random.Random, indent: int, depth: int, names: Sequence[str] = NAMES) -> str:
    lines = []
    for name in random.sample(names, random.randint(1, 3)):
        is_deep = depth > 1 and random.random() < 0.2
        value = _mapping(random, indent + 2, depth - 1) if is_deep else _value(random, indent)
        lines.append(f"\n{' ' * indent}{name}:{'' if value[:1] == chr(10) else ' '}{value}")
    return "".join(lines)


def _document(random: random.Random) -> str:
    parts = []
    for part in range(random.choice([1, 1, 1, 2])):
        parameters = _mapping(random, 4, 2, NAMES[part::2])
        key = random.choice(["ros__parameters"] * 12 + ["ros__parameter", "x"])
        parts.append(f"{random.choice(NODES) if random.random() < 0.5 else '/**'}:\n  {key}:{parameters}\n")
    return random.choice(["", "", "", "# c\n", "---\n"]) + random.choice(["", "---\n", "# d\n"]).join(parts)


def _spoilt(random: random.Random, text: str) -> str:
    if random.random() < 0.5:
        return text
    for _ in range(random.randint(1, 2)):
        at = random.randint(0, len(text))
        text = text[:at] + random.choice(INSERTED) + text[at + random.choice([0, 0, 1]) :]
    return text


# What a program declares and sets


def _python_value(random: random.Random) -> Any:
    scalars: list[Callable[[], Any]] = [
        lambda: random.choice([True, False]),
        lambda: random.choice([0, 1, 5, -1, 2**63 - 1, -(2**63), 10]),
        lambda: random.choice([0.0, 0.5, 1.0, -1.5, float("inf"), float("nan"), 1e308, 10.0]),
        lambda: random.choice(["", "a", "5", "y"]),
    ]
    chosen = random.randrange(10)
    if chosen < 6:
        return random.choice(scalars)()
    if chosen < 9:
        scalar = random.choice(scalars)
        return [scalar() for _ in range(random.randint(0, 3))]
    return random.choice([None, [1, 2.5], ["a", 1], {"a": 1}, [[1]], [None]])


def _declaration(random: random.Random) -> Any:
    options: dict[str, Any] = {}
    if random.random() < 0.2:
        options["read_only"] = True
    if random.random() < 0.2:
        options["dynamic_typing"] = True
    if random.random() < 0.4:
        options["integer_range"] = [
            random.choice([0, -5, 1]),
            random.choice([5, 10, 0]),
            random.choice([0, 1, 2, 3]),
        ]
    if random.random() < 0.4:
        options["floating_point_range"] = [
            random.choice([0.0, -1.0, 1.0]),
            random.choice([1.0, 10.0, 0.0]),
            random.choice([0.0, 0.5, 0.3]),
        ]
    return [_python_value(random), options]


# Running


@cache
def _context() -> Any:
    context = rclpy.Context()
    rclpy.init(args=[], context=context)
    return context


def _node(arguments: list[str], **options: Any) -> Node:
    return Node(
        NODE,
        context=_context(),
        cli_args=arguments,
        use_global_arguments=False,
        enable_rosout=False,
        start_parameter_services=False,
        **options,
    )


def _told(parameter: Parameter) -> Any:
    value = parameter.value
    return [parameter.type_.name, list(value) if parameter.type_.name.endswith("ARRAY") else value]


def _parameters(arguments: list[str]) -> Any:
    node = _node(arguments, automatically_declare_parameters_from_overrides=True)
    try:
        found = node.get_parameters_by_prefix("")
        return {
            name: _told(parameter)
            for name, parameter in found.items()
            if name not in {"use_sim_time", "start_type_description_service"}
        }
    finally:
        node.destroy_node()


def _rule(text: str) -> Any:
    return _parameters(["--ros-args", "-p", text])


def _file(text: str) -> Any:
    with tempfile.NamedTemporaryFile("w", suffix=".yaml", encoding="utf-8", newline="", delete=False) as file:
        file.write(text)
    try:
        return _parameters(["--ros-args", "--params-file", file.name])
    finally:
        Path(file.name).unlink()


def _set(declaration: Any, values: list[Any]) -> Any:
    default, options = declaration
    descriptor = ParameterDescriptor(
        read_only=options.get("read_only", False), dynamic_typing=options.get("dynamic_typing", False)
    )
    if "integer_range" in options:
        low, high, step = options["integer_range"]
        descriptor.integer_range = [IntegerRange(from_value=low, to_value=high, step=step)]
    if "floating_point_range" in options:
        low, high, step = options["floating_point_range"]
        descriptor.floating_point_range = [FloatingPointRange(from_value=low, to_value=high, step=step)]
    node = _node([])
    try:
        answers: list[Any] = [_told(node.declare_parameter("x", default, descriptor))]
        for value in values:
            try:
                (result,) = node.set_parameters([Parameter("x", value=value)])
                answers.append([result.successful, _told(node.get_parameter_or("x"))])
            except Exception as error:  # noqa: BLE001  # its class is a part of the answer
                answers.append(type(error).__name__)
        return answers
    finally:
        node.destroy_node()


# Differences on purpose


REFUSED = {"error": "RCLInvalidROSArgsError"}
NO_VALUE = {"error": "ValueError"}
FLOW = r"[\[{]"


def _text_of(case: Any) -> str:
    return case[1] if case[0] != "set" else ""


def _kinds(answer: Any) -> set[str]:
    return (
        {value[0] for value in answer.values()}
        if isinstance(answer, dict) and "error" not in answer
        else set()
    )


def _is_pattern(case: Any, theirs: Any, ours: Any) -> bool:
    pattern = re.match(r"[^:=]*[/*][^:=]*:(?!=)", _text_of(case))
    return case[0] == "rule" and theirs == REFUSED and pattern is not None


def _has_mixed_numbers(case: Any, theirs: Any, ours: Any) -> bool:
    return theirs == REFUSED and any(map(_has_mixed_list, _nodes(case)))


def _has_mixed_list(node: Any) -> bool:
    import yaml

    if isinstance(node, yaml.SequenceNode):
        plain = [item.value for item in node.value if isinstance(item, yaml.ScalarNode) and not item.style]
        integers = [re.fullmatch(r"[-+]?(0[xX][0-9a-fA-F]+|[0-9]+)", text) is not None for text in plain]
        return any(integers) and len(plain) == len(node.value)
    return isinstance(node, yaml.MappingNode) and any(_has_mixed_list(value) for _, value in node.value)


def _is_empty(case: Any, theirs: Any, ours: Any) -> bool:
    text = _text_of(case)
    is_blank = case[0] == "rule" and re.search(r":=\s*(#|$)", text) is not None
    if is_blank and ours == REFUSED:
        return theirs in (NO_VALUE, {})  # the latter of another node
    return theirs == NO_VALUE and (is_blank or re.search(r"\[\s*\]|\{\s*\}", text) is not None)


def _is_read_here(case: Any, theirs: Any, ours: Any) -> bool:
    text = _text_of(case)
    return ours != REFUSED and re.search(r"\*a|<<|!!binary|^%|\\0|\\x00|\0", text, re.MULTILINE) is not None


def _is_xml(case: Any, theirs: Any, ours: Any) -> bool:
    return case[0] == "rule" and re.search(r":=\s*<", _text_of(case)) is not None and "error" not in ours


def _is_misread_there(case: Any, theirs: Any, ours: Any) -> bool:
    """Return whether a list has a list or a mapping in it, or a key only begins with `ros__parameters`."""
    is_longer = re.search(r"ros__parameters([^:\n]|:[^ \n])", _text_of(case)) is not None
    return ours == REFUSED and (is_longer or any(map(_has_structure, _nodes(case))))


def _has_structure(node: Any) -> bool:
    import yaml

    if isinstance(node, yaml.SequenceNode):
        return any(not isinstance(item, yaml.ScalarNode) for item in node.value)
    if isinstance(node, yaml.MappingNode):
        return any(_has_structure(value) for _, value in node.value)
    return False


def _nodes(case: Any) -> list[Any]:
    import yaml

    text = _text_of(case).replace("&a ", "")  # which PyYAML has not twice
    try:
        return list(
            yaml.compose_all(text.partition(":=")[2] if case[0] == "rule" else text, yaml.CSafeLoader)
        )
    except yaml.YAMLError:
        return []


def _is_dotted(case: Any, theirs: Any, ours: Any) -> bool:
    return any(map(_has_dotted_mapping, _nodes(case)))


def _has_dotted_mapping(node: Any) -> bool:
    import yaml

    return isinstance(node, yaml.MappingNode) and any(
        ("." in str(key.value) and isinstance(value, yaml.MappingNode)) or _has_dotted_mapping(value)
        for key, value in node.value
    )


def _is_of_libyaml(case: Any, theirs: Any, ours: Any) -> bool:
    """Return whether libyaml 0.2 agrees with ours: it reads what theirs refuses, or refuses what theirs reads."""
    import yaml

    if case[0] == "set":
        return False
    text = _text_of(case)
    if re.search(r"![^ ]*[],[]", text):  # a tag with a bracket or a comma
        return True
    try:
        list(yaml.parse(text.partition(":=")[2] if case[0] == "rule" else text, yaml.CSafeLoader))
    except yaml.YAMLError:
        return theirs != REFUSED and ours == REFUSED
    is_of_old = re.search(r"\\/|%YAML|[\[{,].*[:?]", text) is not None  # what libyaml 0.1 doesn't know
    return is_of_old and theirs == REFUSED and ours != REFUSED


KNOWN = {
    "param-rule-patterns": _is_pattern,
    "param-mixed-numbers": _has_mixed_numbers,
    "param-empty": _is_empty,
    "param-yaml-read": _is_read_here,
    "param-xml": _is_xml,
    "param-yaml-refused": _is_misread_there,
    "param-dotted-mapping": _is_dotted,
    "param-libyaml": _is_of_libyaml,
}

"""Messages: what a field takes and holds, equality, repr, and what arrives of it.

A case sets one field of a message to a value, which may be of any class that programs have numbers, texts and lists in.
"""

from __future__ import annotations

import array
import collections
import copy
import enum
import functools
import importlib
import math
import pickle
import random
import warnings
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from typing import Any

DEFINITIONS = True  # test_msgs, which has a field of each type

BITS = (8, 16, 32, 64)
INTEGERS = {
    **{f"int{bits}": (-(2 ** (bits - 1)), 2 ** (bits - 1) - 1) for bits in BITS},
    **{f"uint{bits}": (0, 2**bits - 1) for bits in BITS},
    "char": (0, 255),
}
CODES = dict(zip(INTEGERS, "bhiqBHIQB", strict=True)) | {"float32": "f", "float64": "d"}
BASE_TYPES = ["bool", "byte", "float32", "float64", *INTEGERS]
FIELDS = {
    "test_msgs/BasicTypes": {f"{base}_value": base for base in BASE_TYPES},
    "test_msgs/Defaults": {f"{base}_value": base for base in BASE_TYPES},
    **{
        f"test_msgs/{name}": {
            **{f"{base}_values": f"{base}{shape}" for base in [*BASE_TYPES, "string"]},
            **{f"{base}_values_default": f"{base}{shape}" for base in ["bool", "float32", "int64"]},
            "basic_types_values": f"test_msgs/BasicTypes{shape}",
        }
        for name, shape in [("Arrays", "[3]"), ("BoundedSequences", "[<=3]"), ("UnboundedSequences", "[]")]
    },
    "test_msgs/Strings": {"string_value": "string", "bounded_string_value": "string<=22"},
    "test_msgs/WStrings": {
        "wstring_value": "wstring",
        "array_of_wstrings": "wstring[3]",
        "bounded_sequence_of_wstrings": "wstring[<=3]",
        "unbounded_sequence_of_wstrings": "wstring[]",
    },
    "test_msgs/Nested": {"basic_types_value": "test_msgs/BasicTypes", "basic_types_value.int8_value": "int8"},
    **{
        f"std_msgs/{name}": {"data": name.lower()}
        for name in ["Bool", "Byte", "Char", "String"]
        + [f"{sign}Int{bits}" for sign in ("", "U") for bits in BITS]
        + ["Float32", "Float64"]
    },
    **{
        f"std_msgs/{name}MultiArray": {"data": f"{name.lower()}[]", "layout.data_offset": "uint32"}
        for name in ["Byte", "UInt8", "Int16", "UInt64", "Float32", "Float64"]
    },
    "geometry_msgs/Point": {"x": "float64"},
    "geometry_msgs/PoseWithCovarianceStamped": {
        "header.frame_id": "string",
        "header.stamp.sec": "int32",
        "header.stamp.nanosec": "uint32",
        "pose.pose.position.x": "float64",
        "pose.pose.orientation": "geometry_msgs/Quaternion",
    },
    "geometry_msgs/PoseArray": {"poses": "geometry_msgs/Pose[]"},
    "sensor_msgs/LaserScan": {"ranges": "float32[]", "angle_min": "float32"},
    "sensor_msgs/JointState": {"name": "string[]", "position": "float64[]"},
    "sensor_msgs/CameraInfo": {"k": "float64[9]", "roi.do_rectify": "bool", "d": "float64[]"},
    "unique_identifier_msgs/UUID": {"uuid": "uint8[16]"},
    "rcl_interfaces/ParameterValue": {
        "type": "uint8",
        "bool_array_value": "bool[]",
        "byte_array_value": "byte[]",
        "integer_array_value": "int64[]",
        "string_array_value": "string[]",
    },
}
"""The type of each field by its path, of each message."""

NUMPY_INTEGERS = [f"{sign}int{bits}" for sign in ("", "u") for bits in BITS]
NUMPY_FLOATS = ["float16", "float32", "float64", "longdouble"]
TEXTS = [
    "",
    "a",
    "é",
    "😀",
    "y",
    "1e3",
    " ",
    "a\nb",
    "\t",
    "\x07",
    "\x85",
    "null",
    "'\"",
    "x" * 22,
    "x" * 23,
    "\ud800",
    "a\0b",
]


# Differences on purpose


def rows_of(case: Any, theirs: Any, ours: Any) -> set[str | None]:
    """Return the rows of docs/deviations.md that explain the differences of an answer; None for what none explains."""
    if "ended" in ours or "stalled" in ours:
        return {None}
    # What the real one refuses when it checks its fields, it sends as what it finds in memory, or it ends.
    is_mistyped = "ended" in theirs or theirs.get("checked") == "error AssertionError" or is_odd_byte(case)
    if is_mistyped and ours.get("arrives") is not True and "received" in ours:
        return {None}
    differing = [key for key in theirs.keys() | ours.keys() if repr(ours.get(key)) != repr(theirs.get(key))]
    return {_row_of(key, case, theirs, ours, is_mistyped=is_mistyped) for key in differing}


def _row_of(key: str, case: Any, theirs: Any, ours: Any, *, is_mistyped: bool) -> str | None:
    here, there = ours.get(key), theirs.get(key)
    is_array = case["kind"].partition("[")[0] in CODES
    lossy_row = "messages-float32-arrays" if case["kind"].startswith("float") else "messages-integer-arrays"
    if (
        is_array
        and ours.get("held") in ["error OverflowError", "error ValueError"]
        and is_lossy(case, "value")
    ):
        return lossy_row
    if "ended" in theirs:
        return "messages-mistyped"
    if key == "equal" and None in (here, there):  # one could not be set
        return None
    if key in {"equal", "equal to what is received"} and is_refused_there(
        here, there, is_by_numpy=case["kind"][-2:-1].isdigit() or holds_array(case)
    ):
        return "messages-array-equality"
    if key == "equal" and is_lossy(case, "other") and str(here["to another"]).startswith("error"):
        return lossy_row
    if key == "checked" and is_array and case["way"] == "keyword":
        return "messages-array-checks"
    if key in SENT and "string" in case["kind"] and "\0" in repr(case["value"]):
        return "messages-nul"
    if is_mistyped and (key in SENT or (key == "checked" and is_odd_byte(case))):
        return "messages-mistyped"
    return None


SENT = {"sent", "received", "arrives", "all that is received", "equal to what is received", "published again"}


def is_error(outcome: Any, *names: str) -> bool:
    """Return whether an outcome is an error, of one of these classes if there are any."""
    return str(outcome).startswith("error") and (not names or outcome in [f"error {name}" for name in names])


def holds_array(case: Any) -> bool:
    """Return whether a field of a single value was given an array of numpy."""
    return "[" not in case["kind"] and any(case[part][0].startswith("ndarray") for part in ("value", "other"))


def is_refused_there(here: Any, there: Any, *, is_by_numpy: bool) -> bool:
    """Return whether the real one can't compare arrays where ours answers."""
    if isinstance(there, str):
        return there == "error ValueError"
    # numpy compares each element of one array with the only one of the other.
    refused = [[True, True, False, True]] if is_by_numpy else []
    return (
        isinstance(here, dict)
        and isinstance(there, dict)
        and all(
            repr(here[key]) == repr(there[key])
            or (
                (there[key] in refused or is_error(there[key], "ValueError", "UnicodeDecodeError"))
                and not is_error(here[key])
            )
            for key in there
        )
    )


def is_odd_byte(case: Any) -> bool:
    """Return whether a byte is a bytearray, or not of length 1: the real one checks that less, and misreads it."""
    elements = case["value"][1] if isinstance(case["value"][-1], list) else [case["value"]]
    return case["kind"].startswith("byte") and any(
        element[0] == "bytearray"
        or (element[0] in {"bytes", "np.bytes_"} and len(element[1].strip("\0")) != 1)
        for element in elements
    )


def is_lossy(case: Any, part: str) -> bool:
    """Return whether a number of an array is not one of its field's type."""
    base, bracket, _ = case["kind"].partition("[")
    if not bracket:
        return False
    elements = case[part][-1]
    if not isinstance(elements, list):
        elements = [elements]  # of a single number numpy makes an array, too
    if any(isinstance(element, list) and element[0] in {"np.float16", "np.float32"} for element in elements):
        return True  # which round
    numbers = [element[1] if isinstance(element, list) else element for element in elements]
    numbers = [number for number in numbers if isinstance(number, (int, float))]
    if base == "float32":
        return any(3.4028235677973366e38 <= abs(number) < math.inf for number in numbers)
    least, greatest = INTEGERS.get(base, (-math.inf, math.inf))
    return base in INTEGERS and not all(
        number == number // 1 and least <= number <= greatest for number in numbers
    )


KNOWN = {
    row: functools.partial(
        lambda row, *answers: None not in (found := rows_of(*answers)) and row in found, row
    )
    for row in [
        "messages-mistyped",
        "messages-float32-arrays",
        "messages-integer-arrays",
        "messages-array-equality",
        "messages-array-checks",
        "messages-nul",
    ]
}


# Drawing: a value is drawn as JSON, which `made` makes


def draw(random: random.Random) -> Any:
    """Return a message's type, the field, how it is set, and two values."""
    name = random.choice(list(FIELDS))
    path = random.choice(list(FIELDS[name]))
    kind = FIELDS[name][path]
    ways = ["keyword", "attribute"] if "." not in path else ["attribute"]
    way = "unknown" if random.random() < 0.01 else random.choice(ways)
    value = drawn_value(random, kind)
    # The second is often the same number, of another class.
    other = drawn_twin(random, kind, value) if random.random() < 0.5 else drawn_value(random, kind)
    return {"type": name, "path": path, "kind": kind, "way": way, "value": value, "other": other}


def drawn_value(random: random.Random, kind: str) -> list[Any]:
    """Return a value for a field; one in ten is of any other kind."""
    if random.random() < 0.1:
        kind = random.choice(
            [*BASE_TYPES, "string", "none", "float64[]", "int8[3]", "string[]", "std_msgs/Header"]
        )
    base, bracket, shape = kind.partition("[")
    if not bracket:
        return drawn_element(random, base)
    length = random.choice([0, 1, 2, 3, 3, 3, 4])
    if shape[:-1].isdigit() and random.random() < 0.9:
        length = int(shape[:-1])
    return drawn_list(random, base, length)


def drawn_element(random: random.Random, base: str) -> list[Any]:
    if base == "none":
        return random.choice([["None"], ["dict"], ["complex", "1j"], ["Fraction", "1/2"], ["Decimal", "1.5"]])
    if base.startswith(("string", "wstring")):
        return [random.choice(["str"] * 6 + ["np.str_", "sub str", "bytes"]), random.choice(TEXTS)]
    if base == "bool":
        return [random.choice(["bool"] * 4 + ["np.bool_", "int"]), random.choice([0, 1])]
    if base == "byte":
        classes = ["bytes"] * 6 + ["bytearray", "np.bytes_", "int", "str"]
        return [
            random.choice(classes),
            random.choice(["\0", "\x02", "7", "a", "\x7f", "\x85", "\xff", "ab", ""]),
        ]
    if base in INTEGERS:
        least, greatest = INTEGERS[base]
        number = random.choice(
            [0, 1, 7, 50, least, greatest, random.randint(least, greatest), greatest + 1, least - 1]
        )
        classes = ["int"] * 4 + [
            "sub int",
            "IntEnum",
            "bool",
            "float",
            "np 0d",
            *(f"np.{name}" for name in NUMPY_INTEGERS),
        ]
        return fitting(random, classes, number)
    if base in {"float32", "float64"}:
        special = [0.0, -0.0, 1.0, 0.1, 1e-50, 1e50, 3.4028234663852886e38, math.inf, -math.inf, math.nan]
        number = random.choice([*special, random.uniform(-9, 9), 0.5, 300.0, 2.0**53])
        classes = ["float"] * 4 + ["int", "sub float", "np 0d", *(f"np.{name}" for name in NUMPY_FLOATS * 2)]
        return fitting(random, [*classes, "np.int32", "np.uint8"], number)
    return ["message", base, random.choice([0, 1])]


def fitting(random: random.Random, classes: list[str], number: Any) -> list[Any]:
    """Return a number of a class that can hold it."""
    while True:
        name = random.choice(classes)
        is_whole = float(number).is_integer()
        limits = INTEGERS.get(name.removeprefix("np."))
        if limits is not None and not (is_whole and limits[0] <= int(number) <= limits[1]):
            continue
        if name in {"int", "sub int", "IntEnum"} and not is_whole:
            continue
        if name in {"bool", "np.bool_"} and number not in (0, 1):
            continue
        return [name, number]


def drawn_list(random: random.Random, base: str, length: int) -> list[Any]:
    if base in CODES and random.random() < 0.4:
        elements = [drawn_element(random, base)[1] for _ in range(length)]
        dtype = base.replace("char", "uint8")
        if random.random() < 0.3:
            dtype = random.choice(["int64", "float64", "float32", "uint8", "int16"])
        if dtype.startswith("float"):
            return ["ndarray", dtype, [float(element) for element in elements]]
        least, greatest = INTEGERS[dtype]
        whole = [
            int(number)
            for number in elements
            if float(number).is_integer() and least <= float(number) <= greatest
        ]
        whole = [min(number, greatest) for number in whole] + [0] * (length - len(whole))
        if random.random() < 0.5:
            return ["array", CODES[dtype], whole]
        return ["ndarray", dtype, whole]
    elements = [drawn_element(random, base) for _ in range(length)]
    if base in {"bool", "string"} and random.random() < 0.1:
        return ["ndarray of", elements]
    return [random.choice(["list"] * 6 + ["tuple", "range", "deque"]), elements]


def drawn_twin(random: random.Random, kind: str, value: list[Any]) -> list[Any]:
    """Return a value that equals another one, and may be of another class."""
    base, bracket, _ = kind.partition("[")
    if bracket and value[0] in {"list", "tuple"}:
        return [random.choice(["list", "tuple"]), [drawn_twin(random, base, element) for element in value[1]]]
    if bracket and value[0] in {"ndarray", "array"} and base in CODES:
        return ["list", [["float" if base.startswith("float") else "int", number] for number in value[-1]]]
    twins = {"str": ["str", "np.str_"], "bytes": ["bytes", "np.bytes_"], "bool": ["bool", "np.bool_"]}
    if base in INTEGERS or base in {"float32", "float64"}:
        if len(value) != 2 or isinstance(value[1], (list, type(None))):
            return value
        try:
            return fitting(
                random, ["int", "float", "np.int64", "np.float64", "np.float32", "np.uint8"], value[1]
            )
        except ValueError:  # a text
            return value
    return [random.choice(twins.get(value[0], [value[0]])), *value[1:]]


# Running


class Text(str):  # noqa: SLOT000  # as programs write it
    """A class of a program's own."""


class Whole(int):
    """As above."""


class Real(float):
    """As above."""


def made(spec: list[Any]) -> Any:
    """Return the value that was drawn."""
    name, value, *rest = [*spec, None]
    if name.startswith("np.") and name not in {"np.bytes_", "np.str_"}:
        import numpy as np

        with np.errstate(all="ignore"):
            return getattr(np, name[3:])(value)
    return MAKERS[name](value, *rest[:-1])


def made_message(name: str, is_changed: int) -> Any:
    cls = class_of(name)
    message = cls()
    first = next(iter(cls.get_fields_and_field_types()), None)
    if is_changed and first is not None and isinstance(getattr(message, first), (float, bool)):
        setattr(message, first, type(getattr(message, first))(1))
    return message


def made_numpy(name: str) -> Callable[..., Any]:
    def make(*arguments: Any) -> Any:
        import numpy as np

        if name == "array of":
            return np.array([made(element) for element in arguments[0]])
        return getattr(np, name)(*reversed(arguments))

    return make


def made_elements(cls: Callable[[list[Any]], Any]) -> Callable[..., Any]:
    return lambda elements: cls([made(element) for element in elements])


def octets(text: str) -> bytes:
    return text.encode("latin-1", "replace")


def class_of(name: str) -> Any:
    package, _, kind = name.partition("/")
    return getattr(importlib.import_module(f"{package}.msg"), kind)


MAKERS: dict[str, Callable[..., Any]] = {
    "None": lambda _: None,
    "dict": lambda _: {},
    "complex": complex,
    "Fraction": Fraction,
    "Decimal": Decimal,
    "bool": bool,
    "int": int,
    "float": float,
    "str": str,
    "bytes": octets,
    "bytearray": lambda text: bytearray(octets(text)),
    "np.bytes_": lambda text: made_numpy("bytes_")(octets(text)),
    "np.str_": made_numpy("str_"),
    "sub str": Text,
    "sub int": lambda number: Whole(int(number)),
    "sub float": lambda number: Real(float(number)),
    "IntEnum": lambda number: enum.IntEnum("Enum", {"NAME": int(number)})(int(number)),
    "np 0d": made_numpy("array"),
    "message": made_message,
    "array": array.array,
    "ndarray": made_numpy("array"),
    "ndarray of": made_numpy("array of"),
    "list": made_elements(list),
    "tuple": made_elements(tuple),
    "deque": made_elements(collections.deque),
    "range": lambda elements: range(len(elements)),
}


def run(case: Any) -> Any:
    """Set the field; compare, print, send and publish again."""
    warnings.simplefilter("ignore")
    cls = class_of(case["type"])
    answer: dict[str, Any] = {
        "checked": outcome(lambda: built(cls, case, case["value"], check_fields=True) and "taken")
    }
    try:
        message = built(cls, case, case["value"])
        answer["held"] = held(message, case["path"])
    except Exception as error:  # noqa: BLE001
        return answer | {"held": failure(error)}
    answer["repr"] = outcome(lambda: repr(message))
    answer["equal"] = {
        "to one like it": outcome(lambda: both(message, built(cls, case, case["value"]))),
        "to another": outcome(lambda: both(message, built(cls, case, case["other"]))),
        "to a new one": outcome(lambda: both(message, cls())),
        "to a copy": outcome(lambda: both(message, copy.deepcopy(message))),
        "to a pickle": outcome(lambda: both(message, pickle.loads(pickle.dumps(message)))),
        "to none": both(message, None),
    }
    return answer | sent(message, case["path"])


def sent(message: Any, path: str) -> dict[str, Any]:
    """Return what is received of a message, and whether it is the message again.

    Not its bytes: the real one leaves in the gaps between fields what was in memory.
    """
    from rclpy.serialization import deserialize_message, serialize_message

    data = outcome(lambda: serialize_message(message))
    if not isinstance(data, bytes):
        return {"sent": data}
    received = deserialize_message(data, type(message))
    return {
        "received": held(received, path),
        "all that is received": repr(received),
        "arrives": outcome(lambda: are_same(part_of(received, path), part_of(message, path))),
        "equal to what is received": outcome(lambda: both(received, message)),
        "published again": outcome(lambda: republished(received)),
    }


def republished(message: Any) -> Any:
    """Return True if the YAML of `topic echo` can be published, and gives the same; otherwise what it gives.

    PyPI has no real `rosidl_runtime_py` that could be asked.
    """
    try:
        from rosidl_runtime_py import message_to_yaml, set_message_fields
    except ImportError:
        return True
    import yaml
    from rclpy.serialization import deserialize_message, serialize_message

    new = type(message)()
    set_message_fields(new, yaml.safe_load(message_to_yaml(message)))
    again = repr(deserialize_message(serialize_message(new), type(message)))
    return again == repr(message) or again


def built(cls: Any, case: Any, spec: list[Any], **options: bool) -> Any:
    """Return a message whose field is set as the case says."""
    value = made(spec)
    if case["way"] == "unknown":
        return cls(no_such_field=value, **options)
    if case["way"] == "keyword":
        return cls(**{case["path"]: value}, **options)
    message = part = cls(**options)
    *parents, name = case["path"].split(".")
    for parent in parents:
        part = getattr(part, parent)
        if options:
            part._check_fields = True
    setattr(part, name, value)
    return message


def part_of(message: Any, path: str) -> Any:
    for name in path.split("."):
        message = getattr(message, name)
    return message


def held(message: Any, path: str) -> Any:
    """Return a field's value, in a form that tells its class and survives as JSON."""
    return shown(part_of(message, path))


def are_same(received: Any, sent: Any) -> bool:
    """Return whether a value stands for another one, of whatever class, as far as the field's type can."""
    if hasattr(received, "__len__") and not isinstance(received, (str, bytes)):
        return len(received) == getattr(sent, "__len__", int)() and all(
            are_same(*both) for both in zip(received, sent, strict=True)
        )
    if hasattr(received, "SLOT_TYPES"):
        return repr(received) == repr(sent)
    if isinstance(received, bytes):
        return isinstance(sent, (bytes, bytearray)) and received == bytes(sent)
    if isinstance(received, str):
        return isinstance(sent, str) and received == sent.partition("\0")[0]
    if isinstance(sent, (str, bytes, bytearray)) or not hasattr(sent, "__float__"):
        return False
    there, here = float(received), float(sent)
    return (
        there == here
        or (there != there and here != here)
        or math.isclose(there, here, rel_tol=1e-7, abs_tol=1e-45)
    )


def shown(value: Any) -> Any:
    if isinstance(value, (list, tuple)):
        return [type(value).__name__, *(shown(element) for element in value)]
    if hasattr(value, "SLOT_TYPES") or type(value).__name__ in {"deque", "range"}:
        return repr(value)
    return [type(value).__name__, repr(value)]


def both(message: Any, other: Any) -> list[Any]:
    """Return whether two are equal, asked from both, whether they differ, and whether one is in a list of the other."""
    return [message == other, other == message, message != other, message in [None, other]]


def outcome(call: Any) -> Any:
    """Return what a call returns, or the class of its error."""
    try:
        return call()
    except Exception as error:  # noqa: BLE001
        return failure(error)


def failure(error: Exception) -> str:
    """Return the first class of Python's own that an error is of."""
    return next(f"error {cls.__name__}" for cls in type(error).__mro__ if cls.__module__ == "builtins")

"""Static transforms as a file in YAML: a list, each item with its frames, a translation [m] and a rotation."""

from __future__ import annotations

import math
from collections.abc import Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any

from tfloom.tf2_tools.static_transform import StaticTransform, quaternion_from_rpy

__all__ = ["StaticFileError", "encoded", "file_text", "read_statics"]

KEY = "static_transforms"
ITEM_KEYS = ("frame_id", "child_frame_id", "translation", "rotation")
AXES = ("x", "y", "z")
QUATERNION = ("x", "y", "z", "w")
EULER = ("roll", "pitch", "yaw")
MAX_NORM_ERROR = 0.01
"""A rotation whose length differs more from 1 is an error; one that differs less is normalised."""
ROUNDING = 1e-9
"""A difference that digits of a file may leave: the rotation is used as it is."""

HEADING = """\
# Static transforms. `tfloom tf publish FILE` publishes them; `tfloom tf diff` compares them.
# translation [m]; rotation as a quaternion x, y, z, w, or as roll, pitch, yaw [rad].
"""


class StaticFileError(ValueError):
    """A file holds no static transforms; the text has the file, the line and the reason."""


def file_text(transforms: Iterable[StaticTransform], *, ascii_only: bool = False) -> str:
    """Return the text of a file with these transforms, in order of their children's names.

    Args:
        transforms: The transforms.
        ascii_only: Whether other letters are YAML's escape sequences.
    """
    import yaml

    items = [
        {
            "frame_id": entry.frame_id,
            "child_frame_id": entry.child_frame_id,
            "translation": dict(zip(AXES, entry.translation, strict=True)),
            "rotation": dict(zip(QUATERNION, entry.rotation_xyzw, strict=True)),
        }
        for entry in sorted(transforms, key=lambda transform: transform.child_frame_id)
    ]
    text = yaml.safe_dump(
        {KEY: items}, sort_keys=False, allow_unicode=not ascii_only, width=200, default_flow_style=None
    )
    return HEADING + text


def encoded(transforms: Iterable[StaticTransform], stamp_ns: int) -> bytes:
    """Return a tf2_msgs/msg/TFMessage with these transforms, all with one stamp [ns since epoch]."""
    from tfloom.interfaces.geometry_msgs.msg import TransformStamped
    from tfloom.interfaces.tf2_msgs.msg import TFMessage
    from tfloom.rosidl import cdr

    message = TFMessage()
    for transform in transforms:
        stamped = TransformStamped(child_frame_id=transform.child_frame_id)
        stamped.header.frame_id = transform.frame_id
        stamped.header.stamp.sec, stamped.header.stamp.nanosec = divmod(stamp_ns, 1_000_000_000)
        moved, turned = stamped.transform.translation, stamped.transform.rotation
        moved.x, moved.y, moved.z = transform.translation
        turned.x, turned.y, turned.z, turned.w = transform.rotation_xyzw
        message.transforms.append(stamped)
    return cdr.encode(message)


def read_statics(path: Path) -> list[StaticTransform]:
    """Read a file of static transforms.

    Raises:
        StaticFileError: it isn't UTF-8 or YAML, has other keys, lacks a value, has a number that isn't finite or a
            rotation that is none, names a frame twice as a child, or closes a loop.
        OSError: it can't be read.
    """
    from tfloom.common.yaml import YamlError, load_placed

    try:
        value, lines = load_placed(path.read_bytes().decode("utf-8-sig"))
    except UnicodeDecodeError as error:
        raise StaticFileError(f"{path}: octet {error.start} isn't UTF-8 text") from None
    except YamlError as error:
        where = f"{path}:{error.line}" if error.line is not None else f"{path}"
        raise StaticFileError(f"{where}: {error.problem}") from None
    return _Reader(path, lines).transforms(value)


class _Reader:
    def __init__(self, path: Path, lines: Mapping[int, int]) -> None:
        self._path = path
        self._lines = lines

    def _error(self, value: object, reason: str) -> StaticFileError:
        line = self._lines.get(id(value))
        return StaticFileError(f"{self._path}{'' if line is None else f':{line}'}: {reason}")

    def transforms(self, value: object) -> list[StaticTransform]:
        if not isinstance(value, dict) or list(value) != [KEY] or not isinstance(value[KEY], list):
            raise self._error(
                value, f"a file of static transforms has one key, {KEY}, with a list of transforms"
            )
        transforms = [self._transform(item) for item in value[KEY]]
        self._check_tree(value[KEY], transforms)
        return transforms

    def _transform(self, item: object) -> StaticTransform:
        if not isinstance(item, dict):
            raise self._error(
                item, f"an item of {KEY} is a mapping with {', '.join(ITEM_KEYS)}, not {item!r}"
            )
        if unknown := [key for key in item if key not in ITEM_KEYS]:
            raise self._error(item, f"unknown key {unknown[0]!r}: the keys are {', '.join(ITEM_KEYS)}")
        return StaticTransform(
            self._frame(item, "frame_id"),
            self._frame(item, "child_frame_id"),
            self._translation(item),
            self._rotation(item),
        )

    def _frame(self, item: dict[str, Any], key: str) -> str:
        name = item.get(key)
        if not isinstance(name, str) or not name:
            quoted = "" if name is None else f", not {name!r}: put it in quotes if it is a name"
            raise self._error(item, f"{key} must be the name of a frame{quoted}")
        if name.startswith("/"):
            raise self._error(
                item, f"{key} {name!r} starts with a slash, which tf2 rejects: write {name.lstrip('/')!r}"
            )
        return name

    def _translation(self, item: dict[str, Any]) -> tuple[float, float, float]:
        value = item.get("translation", {})
        x, y, z = self._numbers(item, "translation", value, (AXES,), dict.fromkeys(AXES, 0.0))
        return x, y, z

    def _rotation(self, item: dict[str, Any]) -> tuple[float, float, float, float]:
        value = item.get("rotation", {})
        if isinstance(value, dict) and value.keys() & set(EULER):
            roll, pitch, yaw = self._numbers(item, "rotation", value, (EULER,), dict.fromkeys(EULER, 0.0))
            return quaternion_from_rpy(roll, pitch, yaw)
        defaults = {} if value else {"x": 0.0, "y": 0.0, "z": 0.0, "w": 1.0}
        x, y, z, w = self._numbers(item, "rotation", value, (QUATERNION, EULER), defaults)
        length = math.hypot(x, y, z, w)
        if abs(length - 1.0) > MAX_NORM_ERROR:
            raise self._error(value, f"the rotation's quaternion has the length {length:g}, not 1")
        if abs(length - 1.0) > ROUNDING:
            return x / length, y / length, z / length, w / length
        return x, y, z, w

    def _numbers(
        self,
        item: object,
        key: str,
        value: object,
        forms: Sequence[Sequence[str]],
        defaults: Mapping[str, float],
    ) -> list[float]:
        """Return the numbers of the first form; missing ones are in `defaults`, or an error."""
        names = forms[0]
        if not isinstance(value, dict) or not value.keys() <= set(names):
            keys = " or ".join(", ".join(form) for form in forms)
            place = value if isinstance(value, (dict, list)) else item
            raise self._error(place, f"{key} is a mapping with {keys}, not {value!r}")
        numbers = []
        for name in names:
            number = value.get(name, defaults.get(name))
            if number is None:
                raise self._error(value, f"{key} lacks {name}")
            if isinstance(number, bool) or not isinstance(number, (int, float)):
                raise self._error(value, f"{key}.{name} must be a finite number, not {number!r}")
            numbers.append(self._finite(value, f"{key}.{name}", number))
        return numbers

    def _finite(self, given: object, name: str, number: float) -> float:
        try:
            if math.isfinite(number):
                return float(number)
        except OverflowError:  # an integer beyond all floating-point numbers
            raise self._error(given, f"{name} must be a finite number, not one beyond 1.8e308") from None
        raise self._error(given, f"{name} must be a finite number, not {number!r}")

    def _check_tree(self, items: Sequence[object], transforms: Sequence[StaticTransform]) -> None:
        parents: dict[str, str] = {}
        for item, (parent, child, *_) in zip(items, transforms, strict=True):
            if child in parents:
                raise self._error(
                    item, f"the child frame {child!r} is there twice, with the parent {parents[child]!r}"
                )
            above: str | None = parent
            while above is not None and above != child:
                above = parents.get(above)
            if above == child:
                raise self._error(item, f"{parent!r} -> {child!r} closes a loop")
            parents[child] = parent

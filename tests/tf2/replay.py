"""Replay of recorded runs of tf2_py on tfloom's buffer, by operation, and whether two buffers answer alike."""

from __future__ import annotations

import gzip
import json
import math
from collections.abc import Callable, Container, Iterable, Iterator
from pathlib import Path
from typing import Any

from tfloom.tf2.buffer import Buffer
from tfloom.tf2.errors import TransformException

GOLDEN = Path(__file__).parents[1] / "golden"


def traces() -> list[dict[str, Any]]:
    with gzip.open(GOLDEN / "tf2_traces.jsonl.gz", "rt") as lines:
        return [json.loads(line) for line in lines]


def velocities() -> list[dict[str, Any]]:
    with gzip.open(GOLDEN / "tf2_velocity.json.gz", "rt") as text:
        runs: list[dict[str, Any]] = json.load(text)
    return runs


def is_close(ours: object, theirs: object) -> bool:
    """Compare floats within 1e-7·(1+|x|), all else exactly."""
    if isinstance(theirs, float):
        return isinstance(ours, float) and math.isclose(ours, theirs, rel_tol=1e-7, abs_tol=1e-7)
    if isinstance(theirs, list):
        return (
            isinstance(ours, list)
            and len(ours) == len(theirs)
            and all(is_close(a, b) for a, b in zip(ours, theirs, strict=True))
        )
    if isinstance(theirs, dict):
        return (
            isinstance(ours, dict)
            and ours.keys() == theirs.keys()
            and all(is_close(ours[k], theirs[k]) for k in theirs)
        )
    return type(ours) is type(theirs) and ours == theirs


def answer(buffer: Buffer, op: dict[str, Any], deviations: Container[str]) -> dict[str, Any]:
    """Return the result of an operation on `buffer`, in the recording's form except for the `deviations`."""
    try:
        result = OPERATIONS[op["op"]](buffer, op)
    except TransformException as error:
        kind = kind_of(error, deviations)
        if op["op"] == "latest_common_time" and op.get("raises") == "TransformException":
            kind = "TransformException"  # the base class in tf2_py and in BufferCore
        return {"raises": kind, "text": str(error)}
    return {} if result is None else {"ok": result}


def kind_of(error: TransformException, deviations: Container[str]) -> str:
    """Return the name of an error's class, or of its base if tfloom's class is more specific than the recorded."""
    kind, above = (error_class.__name__ for error_class in type(error).__mro__[:2])
    return above if above == "ExtrapolationException" and "tf2-extrapolation-kinds" in deviations else kind


def expected(op: dict[str, Any]) -> dict[str, Any]:
    return {key: op[key] for key in ("ok", "raises", "text") if key in op}


def mismatches(
    trace: dict[str, Any], deviations: Container[str]
) -> Iterator[tuple[int, dict[str, Any], dict[str, Any]]]:
    buffer = Buffer(round(trace["cache_time_s"] * 1e9))
    buffer.set_log_callback(None)
    for index, op in enumerate(trace["ops"]):
        ours = answer(buffer, op, deviations)
        if not is_close(ours, expected(op)):
            yield index, op, ours


def _set(static: bool) -> Callable[[Buffer, dict[str, Any]], None]:
    def run(buffer: Buffer, op: dict[str, Any]) -> None:
        buffer.set(
            op["frame_id"],
            op["child_frame_id"],
            op["stamp_ns"],
            op["translation"],
            op["rotation_xyzw"],
            op["authority"],
            static=static,
        )

    return run


def _as_dict(found: Any) -> dict[str, Any]:
    return {
        "stamp_ns": found.stamp_ns,
        "frame_id": found.frame_id,
        "child_frame_id": found.child_frame_id,
        "translation": list(found.translation),
        "rotation_xyzw": list(found.rotation_xyzw),
    }


def _names(op: dict[str, Any]) -> tuple[str, str, int]:
    return op["target_frame"], op["source_frame"], op["stamp_ns"]


def _full(op: dict[str, Any]) -> tuple[str, int, str, int, str]:
    return op["target_frame"], op["target_ns"], op["source_frame"], op["source_ns"], op["fixed_frame"]


def _verdict(obstacle: str | None) -> list[object]:
    return [obstacle is None, obstacle or ""]


OPERATIONS: dict[str, Callable[[Buffer, dict[str, Any]], object]] = {
    "set_transform": _set(static=False),
    "set_transform_static": _set(static=True),
    "lookup": lambda buffer, op: _as_dict(buffer.lookup(*_names(op))),
    "lookup_full": lambda buffer, op: _as_dict(buffer.lookup_full(*_full(op))),
    "can": lambda buffer, op: _verdict(buffer.find_obstacle(*_names(op))),
    "can_full": lambda buffer, op: _verdict(buffer.find_obstacle_full(*_full(op))),
    "latest_common_time": lambda buffer, op: buffer.latest_common_time(
        op["target_frame"], op["source_frame"]
    ),
    "all_frames_as_yaml": lambda buffer, op: buffer.all_frames_as_yaml(),
    "all_frames_as_string": lambda buffer, op: buffer.all_frames_as_string(),
    "all_frames_as_dot": lambda buffer, op: buffer.all_frames_as_dot(),
    "frame_names": lambda buffer, op: buffer.frame_names(),
    "clear": lambda buffer, op: buffer.clear(),
}


def outcome(buffer: Buffer, target: str, source: str, stamp_ns: int) -> object:
    """Return the stamp and the transform of a lookup, or the class and the text of its error."""
    try:
        transform = buffer.lookup(target, source, stamp_ns)
    except TransformException as error:
        return type(error), str(error)
    return transform.stamp_ns, transform.transform


def require_equal(live: Buffer, mapped: Buffer, queries: Iterable[tuple[str, str, int]]) -> None:
    """Check that two buffers answer the queries alike, and have the same frames, listing and frozen bytes."""
    for query in queries:
        assert outcome(live, *query) == outcome(mapped, *query)
    assert mapped.all_frames_as_yaml(200.0) == live.all_frames_as_yaml(200.0)
    assert mapped.frame_names() == live.frame_names()
    assert mapped.cache_time_ns == live.cache_time_ns
    assert mapped.frozen() == live.frozen()

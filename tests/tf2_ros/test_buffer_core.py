"""tf2_py's interface: the recorded runs with messages; and the accepted times and messages."""

from __future__ import annotations

from collections.abc import Container
from types import SimpleNamespace
from typing import Any

import pytest
from tests.tf2.replay import expected, is_close, kind_of, traces, velocities
from tests.tf2_ros.conftest import SECOND, transform_stamped

from tfloom.interfaces.builtin_interfaces.msg import Time as TimeMessage
from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.node.values.duration import Duration
from tfloom.node.values.time import Time
from tfloom.tf2.errors import TransformException
from tfloom.tf2_ros.buffer_core import BufferCore

TRACES = traces()
VELOCITIES = velocities()


def at(stamp_ns: int) -> SimpleNamespace:
    return SimpleNamespace(nanoseconds=stamp_ns)


def as_dict(message: TransformStamped) -> dict[str, Any]:
    stamp, p, q = message.header.stamp, message.transform.translation, message.transform.rotation
    return {
        "stamp_ns": stamp.sec * SECOND + stamp.nanosec,
        "frame_id": message.header.frame_id,
        "child_frame_id": message.child_frame_id,
        "translation": [p.x, p.y, p.z],
        "rotation_xyzw": [q.x, q.y, q.z, q.w],
    }


def run(buffer: BufferCore, op: dict[str, Any]) -> object:
    kind = op["op"]
    if kind.startswith("set_transform"):
        message = transform_stamped(
            op["frame_id"], op["child_frame_id"], op["stamp_ns"], op["translation"], op["rotation_xyzw"]
        )
        return getattr(buffer, kind)(message, op["authority"])
    if kind in ("lookup", "can"):
        names = op["target_frame"], op["source_frame"], at(op["stamp_ns"])
        if kind == "can":
            return list(buffer.can_transform_core(*names))
        return as_dict(buffer.lookup_transform_core(*names))
    if kind in ("lookup_full", "can_full"):
        query = (
            op["target_frame"], at(op["target_ns"]), op["source_frame"], at(op["source_ns"]), op["fixed_frame"]
        )  # fmt: skip
        if kind == "can_full":
            return list(buffer.can_transform_full_core(*query))
        return as_dict(buffer.lookup_transform_full_core(*query))
    if kind == "latest_common_time":
        return buffer.get_latest_common_time(op["target_frame"], op["source_frame"]).nanoseconds
    plain = {"frame_names": "_getFrameStrings", "all_frames_as_dot": "_allFramesAsDot"}
    return getattr(buffer, plain.get(kind, kind))()


def answer(buffer: BufferCore, op: dict[str, Any], deviations: Container[str]) -> dict[str, Any]:
    try:
        result = run(buffer, op)
    except TransformException as error:
        return {"raises": kind_of(error, deviations), "text": str(error)}
    return {} if result is None else {"ok": result}


@pytest.mark.parametrize("trace", TRACES, ids=[f"seed{trace['seed']}" for trace in TRACES])
def test_every_result_matches_the_recording(
    trace: dict[str, Any], deviations: dict[str, dict[str, str]]
) -> None:
    buffer = BufferCore(Duration(seconds=trace["cache_time_s"]))
    buffer.set_log_callback(None)
    for op in trace["ops"]:
        ours = answer(buffer, op, deviations)
        assert is_close(ours, expected(op)), op


@pytest.mark.parametrize(
    "time", [Time(seconds=5), TimeMessage(sec=5), SimpleNamespace(sec=5, nanosec=0), Duration(seconds=5)]
)
def test_times_have_nanoseconds_or_sec_and_nanosec(time: object) -> None:
    buffer = BufferCore(SimpleNamespace(sec=20, nanosec=7))
    assert buffer.cache_time_ns == 20 * SECOND + 7
    buffer.set_transform(transform_stamped("a", "b", 5 * SECOND), "me")
    assert buffer.can_transform_core("a", "b", time) == (True, "")


@pytest.mark.parametrize("time", [None, 5, 1.5, "now"])
def test_invalid_time_raises(time: object) -> None:
    buffer = BufferCore()
    for ask in (
        lambda: buffer.lookup_transform_core("a", "b", time),
        lambda: buffer.can_transform_core("a", "b", time),
        lambda: buffer.lookup_transform_full_core("a", time, "b", Time(), "a"),
        lambda: buffer.lookup_transform_full_core("a", Time(), "b", time, "a"),
    ):
        with pytest.raises(TypeError) as raised:
            ask()
        assert str(raised.value) == "time must have sec and nanosec, or nanoseconds."


def test_stamp_can_be_an_rclpy_time_and_numbers_can_be_ints() -> None:
    message = transform_stamped("a", "b", 0, (1, 2, 3), (0, 0, 0, 1))
    message.header.stamp = Time(seconds=3)
    buffer = BufferCore()
    buffer.set_transform(message, "me")
    assert as_dict(buffer.lookup_transform_core("a", "b", Time()))["stamp_ns"] == 3 * SECOND


def test_messages_of_any_class_are_accepted() -> None:
    message = SimpleNamespace(
        header=SimpleNamespace(frame_id="a", stamp=SimpleNamespace(sec=3, nanosec=4)),
        child_frame_id="b",
        transform=SimpleNamespace(
            translation=SimpleNamespace(x=1, y=2, z=3), rotation=SimpleNamespace(x=0, y=0, z=0, w=1)
        ),
    )
    buffer = BufferCore()
    buffer.set_transform_static(message, "me")
    assert as_dict(buffer.lookup_transform_core("a", "b", Time(seconds=9)))["translation"] == [1.0, 2.0, 3.0]


@pytest.mark.parametrize(
    ("spoil", "text"),
    [
        (lambda m: setattr(m.header, "stamp", 5), "time must have sec and nanosec, or nanoseconds."),
        (lambda m: setattr(m.transform, "translation", 5), "transform.translation must have members x, y, z"),
        (lambda m: setattr(m.transform, "rotation", 5), "transform.rotation must have members x, y, z, w"),
    ],
)
def test_a_message_without_its_parts_is_a_type_error(spoil: Any, text: str) -> None:
    message = transform_stamped("a", "b", SECOND)
    spoil(message)
    with pytest.raises(TypeError) as raised:
        BufferCore().set_transform(message, "me")
    assert str(raised.value) == text


def test_invalid_cache_time_raises() -> None:
    with pytest.raises(TypeError, match="duration must have sec and nanosec, or nanoseconds"):
        BufferCore(5)
    assert BufferCore(cache_time=Duration(seconds=1)).cache_time_ns == 10 * SECOND


def test_negative_times_are_returned_unchanged() -> None:
    buffer = BufferCore()
    buffer.set_transform(transform_stamped("a", "b", -SECOND), "me")
    assert as_dict(buffer.lookup_transform_core("a", "b", Time()))["stamp_ns"] == -SECOND


def test_chain_of_frames() -> None:
    buffer = BufferCore()
    for parent, child in (("map", "odom"), ("odom", "base"), ("base", "cam")):
        buffer.set_transform(transform_stamped(parent, child, SECOND), "me")
    zero = Time()
    assert buffer._chain("map", zero, "cam", zero, "map") == ["cam", "base", "odom"]
    assert buffer._chain("cam", zero, "map", zero, "cam") == []
    assert buffer._frameExists("NO_PARENT")


def test_rejections_are_logged(capfd: pytest.CaptureFixture[str]) -> None:
    BufferCore().set_transform(transform_stamped("a", "a", SECOND), "me")
    assert "[tf2_buffer]: TF_SELF_TRANSFORM: Ignoring transform" in capfd.readouterr().err


def test_unsupported_arguments_raise(deviations: dict[str, dict[str, str]]) -> None:
    assert "tf2-extra-arguments" in deviations
    buffer = BufferCore()
    for call in (buffer.clear, buffer.all_frames_as_string):
        with pytest.raises(TypeError):
            call("x")
    buffer.set_transform(transform_stamped("a", "b", SECOND), "me")
    assert "transform_delay: 4.000" in buffer.all_frames_as_yaml(5.0)


@pytest.mark.parametrize("run", VELOCITIES, ids=range(len(VELOCITIES)))
def test_every_velocity_matches_the_recording(
    run: dict[str, Any], deviations: dict[str, dict[str, str]]
) -> None:
    buffer = BufferCore()
    for frame, child, stamp, xyz, xyzw, *is_static in run["sets"]:
        store = buffer.set_transform_static if is_static else buffer.set_transform
        store(transform_stamped(frame, child, stamp, xyz, xyzw), "me")
    for query in run["queries"]:
        time, interval = at(query["stamp_ns"]), at(round(query["interval_s"] * 1e9))
        frames = {key: query[key] for key in ("tracking_frame", "observation_frame")}
        try:
            if "reference_frame" in query:
                rest = [query[f"reference_{key}"] for key in ("frame", "point", "point_frame")]
                velocity = buffer.lookupVelocityFullCore(*frames.values(), *rest, time, interval)
            else:
                velocity = buffer.lookupVelocityCore(**frames, time=time, averaging_interval=interval)
        except TransformException as error:
            ours: dict[str, Any] = {"raises": kind_of(error, deviations), "text": str(error)}
        else:
            ours = {"ok": [list(map(float, part)) for part in velocity]}
        assert is_close(ours, expected(query)), query

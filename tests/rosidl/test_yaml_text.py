"""Text as `ros2 topic echo` prints it (tests/golden/cli), and values as `ros2 topic pub` takes them."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
import yaml
from tests.recorded_outputs import recorded_output

from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.geometry_msgs.msg import (
    Polygon,
    PoseWithCovariance,
    Quaternion,
    Transform,
    TransformStamped,
    Twist,
    Vector3,
)
from tfloom.interfaces.rcl_interfaces.msg import Log, ParameterValue
from tfloom.interfaces.sensor_msgs.msg import JointState, PointCloud2
from tfloom.interfaces.shape_msgs.msg import SolidPrimitive
from tfloom.interfaces.std_msgs.msg import Bool, Byte, ByteMultiArray, Header, Int8, String
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.interfaces.turtlesim.msg import Pose
from tfloom.rosidl.yaml_text import (
    message_to_csv,
    message_to_ordereddict,
    message_to_yaml,
    set_message_fields,
)


def printed(name: str) -> str:
    """Return what a golden command printed, without its first line, `---` and the exit code."""
    lines = recorded_output(name).splitlines()[1:]
    return "\n".join(line for line in lines if line != "---" and not line.startswith("[exit")) + "\n"


@pytest.fixture
def camera() -> TFMessage:
    return TFMessage(
        transforms=[
            TransformStamped(
                header=Header(stamp=Time(sec=1795257442, nanosec=127281577), frame_id="world"),
                child_frame_id="camera",
                transform=Transform(
                    translation=Vector3(x=1.0, y=2.0, z=3.0),
                    rotation=Quaternion(x=0.0, y=0.0, z=0.707106771713121, w=0.707106790659974),
                ),
            )
        ]
    )


@pytest.fixture
def pose() -> Pose:
    return Pose(x=5.544444561004639, y=5.544444561004639)


def test_yaml_block_style_matches_the_golden(camera: TFMessage, pose: Pose) -> None:
    assert message_to_yaml(camera) == printed("topic_echo_tf_static")
    assert message_to_yaml(pose) == printed("topic_echo_once")


def test_yaml_flow_style_matches_the_golden(camera: TFMessage) -> None:
    assert message_to_yaml(camera, flow_style=True) == printed("topic_echo_flow")
    assert message_to_yaml(Twist(), flow_style=True).startswith("linear:\n  x: 0.0\n")


def test_yaml_of_a_log_matches_the_golden() -> None:
    log = Log(
        stamp=Time(sec=1795257453, nanosec=352914069),
        level=20,
        name="talker",
        msg='Publishing: "Hello World: 10"',
        file="<prefix>/lib/python3.11/site-packages/demo_nodes_py/topics/talker.py",
        function="timer_callback",
        line=35,
    )
    assert message_to_yaml(log, no_arr=True) == printed("topic_echo_noarr")


def test_csv_matches_the_golden(pose: Pose) -> None:
    assert message_to_csv(pose) + "\n" == printed("topic_echo_csv")
    assert message_to_csv(JointState(name=["a"], position=[1.0, 2.0])) == "0,0,,a,1.0,2.0"


def test_truncated_text_matches_the_golden() -> None:
    joints = JointState(name=["shoulder", "elbow"], position=[1.0, 2.0, 3.0])
    values = message_to_ordereddict(joints, truncate_length=2)
    assert values["name"] == ["sh...", "el..."]
    assert values["position"] == [1.0, 2.0, "..."]


def test_no_arr_and_no_str_show_lengths() -> None:
    assert (
        message_to_ordereddict(PoseWithCovariance(), no_arr=True)["covariance"] == "<array type: double[36]>"
    )
    assert message_to_ordereddict(Polygon(), no_arr=True)["points"] == (
        "<sequence type: geometry_msgs/msg/Point32, length: 0>"
    )
    box = SolidPrimitive(dimensions=[1.0, 2.0])
    assert message_to_ordereddict(box, no_arr=True)["dimensions"] == "<sequence type: double[3], length: 2>"
    assert message_to_ordereddict(String(data="hello"), no_str=True)["data"] == "<string length: <5>>"


def test_bytes_are_shown_as_characters() -> None:
    assert message_to_ordereddict(Byte(data=b"a"))["data"] == "a"
    assert message_to_ordereddict(ByteMultiArray(data=[b"a", b"\xff"]))["data"] == ["a", "\xff"]


def test_non_ascii_text_is_unchanged() -> None:
    assert message_to_yaml(String(data="né ☂")) == "data: né ☂\n"


@pytest.mark.parametrize("name", ["badfield", "badvalue"])
def test_errors_have_the_texts_of_the_reference(name: str) -> None:
    command, said = recorded_output(f"topic_pub_{name}").splitlines()[:2]
    values = yaml.safe_load(command.split("'")[1])
    with pytest.raises((AttributeError, ValueError)) as raised:
        set_message_fields(Twist(), values)
    assert said == f"Failed to populate field: {raised.value}"


def test_set_changes_nested_fields_only() -> None:
    twist = Twist(linear=Vector3(y=2.0))
    assert set_message_fields(twist, {"linear": {"x": 1}, "angular": {"z": "0.5"}}) == []
    assert twist == Twist(linear=Vector3(x=1.0, y=2.0), angular=Vector3(z=0.5))
    set_message_fields(twist, None)
    assert twist.linear.x == 1.0


def test_fields_of_what_is_no_message_are_set_by_the_types_that_they_hold() -> None:
    twist = SimpleNamespace(linear=SimpleNamespace(x=0.0, y=1.0), name="", numbers=[], stamp=Time())
    values = {"linear": {"x": 1}, "name": 5, "numbers": (1, 2), "stamp": {"sec": "3"}}
    assert set_message_fields(twist, values) == []
    assert twist == SimpleNamespace(
        linear=SimpleNamespace(x=1.0, y=1.0), name="5", numbers=[1, 2], stamp=Time(sec=3)
    )
    assert type(twist.linear.x) is float
    with pytest.raises(AttributeError, match="no attribute 'angular'"):
        set_message_fields(twist, {"angular": {"x": 1}})


def test_arrays_are_set() -> None:
    message = TFMessage()
    set_message_fields(message, {"transforms": [{"child_frame_id": "a"}, TransformStamped()]})
    assert [transform.child_frame_id for transform in message.transforms] == ["a", ""]
    cloud = PointCloud2()
    set_message_fields(cloud, {"data": [1, 2], "is_dense": "true", "fields": [{"name": "x", "count": "1"}]})
    assert (list(cloud.data), cloud.is_dense, cloud.fields[0].count) == ([1, 2], True, 1)
    covariance = PoseWithCovariance()
    set_message_fields(covariance, {"covariance": [1] * 36})
    assert covariance.covariance.dtype == np.float64
    value = ParameterValue()
    set_message_fields(value, {"byte_array_value": [1, 255]})
    assert value.byte_array_value == [b"\x01", b"\xff"]


@pytest.mark.parametrize(
    ("message", "values", "text"),
    [
        (Int8(), {"data": 300}, "300 is outside int8's range [-128, 127]"),
        (Int8(), {"data": 1.5}, "1.5 is not a whole number, and the field's type is int8"),
        (Int8(), {"data": "x"}, "invalid literal for int() with base 10: 'x'"),
        (Bool(), {"data": "maybe"}, "'maybe' is neither true nor false"),
        (Byte(), {"data": 256}, "256 is outside byte's range [0, 255]"),
        (Twist(), {"linear": 3}, "Value '3' is expected to be a dictionary but is a int"),
        (Twist(), [1], "Value '[1]' is expected to be a dictionary but is a list"),
        (TFMessage(), {"transforms": 3}, "Value '3' is expected to be a list but is a int"),
        (Twist(), {"linear": None}, "Value 'None' is expected to be a dictionary but is a NoneType"),
    ],
)
def test_unfitting_values_raise(message: Any, values: Any, text: str) -> None:
    with pytest.raises((TypeError, ValueError)) as raised:
        set_message_fields(message, values)
    assert str(raised.value) == text


def test_auto_and_now_return_setters() -> None:
    message = TransformStamped()
    setters = set_message_fields(message, {"header": "auto"}, expand_header_auto=True)
    for setter in setters:
        setter(Time(sec=7))
    assert message.header.stamp.sec == 7
    header = Header()
    (setter,) = set_message_fields(header, {"stamp": "now"}, expand_time_now=True)
    setter(Time(sec=8))
    assert header.stamp.sec == 8
    with pytest.raises(TypeError, match="expected to be a dictionary but is a str"):
        set_message_fields(header, {"stamp": "now"})

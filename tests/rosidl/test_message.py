"""The Python interface of messages, as in a real rclpy (tests/golden/python_messages.json and its cases)."""

from __future__ import annotations

import array
import copy
import importlib
import json
import math
import pickle
import re
from collections import deque
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import numpy as np
import pytest
from tests.each import for_each
from tests.rosidl.workspaces import run_python, snake

from tfloom.interfaces.action_msgs.msg import GoalStatus
from tfloom.interfaces.geometry_msgs import msg as geometry_msgs
from tfloom.interfaces.geometry_msgs.msg import TransformStamped, Twist, Vector3
from tfloom.interfaces.rcl_interfaces.msg import ParameterValue
from tfloom.interfaces.sensor_msgs import msg as sensor_msgs
from tfloom.interfaces.sensor_msgs.msg import (
    CameraInfo,
    Image,
    JointState,
    LaserScan,
    NavSatStatus,
    PointField,
)
from tfloom.interfaces.shape_msgs.msg import SolidPrimitive
from tfloom.interfaces.std_msgs import msg as std_msgs
from tfloom.interfaces.std_msgs.msg import ColorRGBA, Empty, Header, String
from tfloom.interfaces.unique_identifier_msgs.msg import UUID
from tfloom.rosidl import cdr
from tfloom.rosidl.dynamic import define
from tfloom.rosidl.message import Message
from tfloom.rosidl.registry import get_message_class
from tfloom.rosidl.spec import FLOATS

GOLDEN = Path(__file__).parents[1] / "golden"
FACES: dict[str, dict[str, Any]] = json.loads((GOLDEN / "python_messages.json").read_text("utf-8"))
CASES: list[dict[str, str]] = json.loads((GOLDEN / "python_message_cases.json").read_text("utf-8"))
DEVIATIONS = (Path(__file__).parents[2] / "docs" / "deviations.md").read_text("utf-8")
NAMES = {**vars(std_msgs), **vars(sensor_msgs), **vars(geometry_msgs), "np": np, "array": array}


def kind_of(value: object) -> str:
    """Return the type of a field's value by the golden's names."""
    if isinstance(value, np.ndarray):
        return f"numpy.ndarray[{value.dtype}]"
    if isinstance(value, array.array):
        return f"array.array[{value.typecode}]"
    if isinstance(value, Message):
        package, kind, name = value._TYPE_NAME.split("/")
        base = name.partition("_")[0] if kind != "msg" else name
        return f"{package}.{kind}._{snake(base)}.{name}"
    return type(value).__name__


@for_each(FACES)
def test_public_attributes_match_the_golden(name: str) -> None:
    golden, cls = FACES[name], get_message_class(name)
    message = cls()
    assert cls.get_fields_and_field_types() == golden["fields"]
    assert cls.__slots__ == golden["slots"]
    assert repr(message) == golden["repr_default"]
    assert [type(slot_type).__name__ for slot_type in cls.SLOT_TYPES] == [
        face["slot_type"] for face in golden["python"].values()
    ]
    for field, face in golden["python"].items():
        assert kind_of(getattr(message, field)) == face["python"]
        assert getattr(message, field) is getattr(message, f"_{field}")
    assert cls.__name__ == golden["class"].rpartition(".")[2]


@for_each(FACES)
def test_repr_is_the_source_of_the_message(name: str) -> None:
    text = FACES[name]["repr_filled"]
    names: dict[str, Any] = {
        "array": np.array,
        **{f"{sign}int{n}": f"{sign}int{n}" for sign in ("", "u") for n in (8, 32)},
    }
    for package, kind in {tuple(path.split(".")[:2]) for path in re.findall(r"\w+\.\w+\.\w+(?=\()", text)}:
        room = names.setdefault(package, SimpleNamespace())
        setattr(room, kind, importlib.import_module(f"tfloom.interfaces.{package}.{kind}"))
    assert repr(eval(text, names)) == text


@pytest.mark.parametrize("case", CASES, ids=lambda case: case["code"])
def test_recorded_case_gives_the_same_result(case: dict[str, str]) -> None:
    deviates = f"`{case['code']}`" in DEVIATIONS
    assert (answer(case["code"]) != expected(case)) is deviates, "docs/deviations.md says otherwise"


def answer(code: str) -> tuple[str, str]:
    try:
        return "ok", repr(eval(code, NAMES.copy()))
    except Exception as error:  # noqa: BLE001 the golden names the type
        return type(error).__name__, str(error)


def expected(case: dict[str, str]) -> tuple[str, str]:
    return (case["raises"], case["text"]) if "raises" in case else ("ok", case["ok"])


def test_constants_are_on_class_and_instance() -> None:
    assert (PointField.FLOAT32, PointField().FLOAT32) == (7, 7)


# As in a real Jazzy: every `…__DEFAULT` of these classes.
DEFAULTS = {
    "geometry_msgs/msg/Quaternion": {
        "W__DEFAULT": 1.0,
        "X__DEFAULT": 0.0,
        "Y__DEFAULT": 0.0,
        "Z__DEFAULT": 0.0,
    },
    "rcl_interfaces/msg/ParameterDescriptor": {"DYNAMIC_TYPING__DEFAULT": False, "READ_ONLY__DEFAULT": False},
    "rcl_interfaces/msg/SetParametersResult": {},
    "type_description_interfaces/msg/FieldType": {"TYPE_ID__DEFAULT": 0},
    "type_description_interfaces/srv/GetTypeDescription_Request": {"INCLUDE_TYPE_SOURCES__DEFAULT": True},
}


@pytest.mark.parametrize("name", DEFAULTS)
def test_defaults_are_on_class_and_instance(name: str) -> None:
    cls = get_message_class(name)
    for owner in (cls, cls()):
        names = [attribute for attribute in dir(owner) if attribute.endswith("__DEFAULT")]
        assert {attribute: getattr(owner, attribute) for attribute in names} == DEFAULTS[name]


@pytest.mark.parametrize(
    "name",
    ["geometry_msgs/msg/TransformStamped", "sensor_msgs/msg/CameraInfo", "turtlesim/srv/Spawn_Request"],
)
@pytest.mark.parametrize(
    "copied", [copy.copy, copy.deepcopy, lambda message: pickle.loads(pickle.dumps(message))]
)
def test_copies_are_equal_and_independent(name: str, copied: Callable[[Message], Message]) -> None:
    message = get_message_class(name)()
    twin = copied(message)
    assert twin == message
    assert twin is not message
    assert type(twin) is type(message)


def test_a_deep_copy_shares_nothing() -> None:
    twist = Twist()
    twin = copy.deepcopy(twist)
    twin.linear.x = 1.0
    assert twist.linear.x == 0.0


def test_default_values_are_not_shared() -> None:
    first, second = CameraInfo(), CameraInfo()
    first.k[0] = 1.0
    first.d.append(1.0)
    assert (second.k[0], len(second.d)) == (0.0, 0)
    TransformStamped().header.frame_id = "a"
    assert TransformStamped().header.frame_id == ""
    joints = JointState()
    joints.name.append("a")
    assert JointState().name == []


def test_arrays_are_converted_when_assigned() -> None:
    joints = JointState()
    joints.position = [1, 2]
    assert joints.position == array.array("d", [1.0, 2.0])
    joints.position = np.array([3.0, 4.0])
    assert joints.position == array.array("d", [3.0, 4.0])
    kept = array.array("d", [5.0])
    joints.position = kept
    assert joints.position is kept
    info = CameraInfo()
    info.k = range(9)
    assert info.k.dtype == np.float64
    numbers = std_msgs.Int64MultiArray(data=np.arange(3))
    assert numbers.data == array.array("q", [0, 1, 2])
    image = Image()
    image.data = np.arange(6, dtype=np.uint8).reshape(2, 3)
    assert image.data.tobytes() == bytes(range(6))
    for number in (np.float64(1.0), np.array(1.0)):
        with pytest.raises(TypeError):
            joints.position = number
    with pytest.raises(TypeError):
        image.data = "abc"  # type: ignore[assignment]


def test_equality_compares_fields_and_class() -> None:
    assert CameraInfo() == CameraInfo()
    assert CameraInfo(k=[1.0] * 9) != CameraInfo()
    assert CameraInfo(k=[1.0] * 8) != CameraInfo()
    assert Vector3(x=float("nan")) != Vector3(x=float("nan"))
    assert Vector3() != 5
    assert JointState(position=[1.0]) != JointState(position=[1.0, 2.0])


NUMPY_NUMBERS = [np.dtype(code).type for code in np.typecodes["AllInteger"] + np.typecodes["Float"] + "?"]
"""numpy's number types, each once for each of its codes."""


@pytest.mark.parametrize("number", NUMPY_NUMBERS, ids=lambda number: number.__name__)
def test_a_number_of_numpy_equals_what_is_received_of_it(number: type[np.generic]) -> None:
    for name in (
        "Bool",
        "Char",
        "Float32",
        "Float64",
        *(f"{u}Int{bits}" for u in ("", "U") for bits in (8, 16, 32, 64)),
    ):
        cls = getattr(std_msgs, name)
        (kind,) = cls._FIELDS.values()
        is_bool = number is np.bool_
        takes = (
            is_bool if kind == "bool" else kind in FLOATS or not (is_bool or issubclass(number, np.floating))
        )
        message = cls(data=number(1))
        if takes:
            received = cdr.decode(cls, cdr.encode(message))
            assert type(received.data) is not number
            assert received == message == cls(data=received.data), name
            assert (message != received) is False, name
            assert [cls(), received].index(message) == 1
        elif not (is_bool and hasattr(number, "__index__")):  # older numpy takes it for a number, and warns
            with pytest.raises(cdr.EncodeError):
                cdr.encode(message)
        assert message != cls(data=number(0)), name


def test_a_number_of_numpy_counts_in_nested_messages_lists_and_texts() -> None:
    numbers = np.array([1.0, 2.0, 3.0])
    pose = geometry_msgs.Pose(position=geometry_msgs.Point(x=numbers[0], y=numbers[1], z=numbers[2]))
    same = geometry_msgs.Pose(position=geometry_msgs.Point(x=1.0, y=2.0, z=3.0))
    assert pose == same == pose
    assert geometry_msgs.PoseArray(poses=[pose, pose]) == geometry_msgs.PoseArray(poses=[same, same])
    assert geometry_msgs.PoseArray(poses=[pose, pose]) != geometry_msgs.PoseArray(poses=[same, pose, pose])
    assert [same, same].index(pose) == 0
    assert (
        std_msgs.String(data=np.str_("a")) == std_msgs.String(data="a") != std_msgs.String(data=np.str_("b"))
    )
    assert (
        std_msgs.Byte(data=np.bytes_(b"7")) == std_msgs.Byte(data=b"7") == std_msgs.Byte(data=bytearray(b"7"))
    )
    assert PointField(offset=np.array(3)) == PointField(offset=3)
    assert std_msgs.Float64(data=np.float64("nan")) != std_msgs.Float64(data=np.float64("nan"))
    assert (std_msgs.Float64(data=1.0) == std_msgs.Float64(data=np.array([1.0]))) is False
    for number in (np.uint32(5), np.float64(5)):
        wrong = JointState(name=number)  # type: ignore[arg-type]
        for names in ([], ["5"], ["5", "6"]):
            assert (wrong == JointState(name=names)) is (JointState(name=names) == wrong) is False


def test_the_repr_of_integers_of_eight_bytes_has_no_type_that_numpy_has_by_itself() -> None:
    fixed = define("array_msgs/msg/Eight", "int64[2] data\nuint64[1] natural")
    shown = "array_msgs.msg.Eight(data=array([1, 2]), natural=array([0], dtype=uint64))"
    for numbers in ([1, 2], array.array("q", [1, 2]), np.array([1, 2]), np.array([1, 2], np.longlong)):
        message = fixed(data=numbers)
        assert (repr(message), repr(cdr.decode(fixed, cdr.encode(message)))) == (shown, shown)


def test_only_numeric_sequences_are_printed_as_lists() -> None:
    assert repr(String(data=array.array("b", [1]))) == "std_msgs.msg.String(data=array('b', [1]))"  # type: ignore[arg-type]
    assert "position=[1.0]" in repr(JointState(position=[1.0]))


def test_an_array_of_numpy_in_a_list_field_equals_the_list_that_is_received() -> None:
    joints = JointState(name=np.array(["a", "b"]))
    assert cdr.decode(JointState, cdr.encode(joints)) == joints == JointState(name=["a", "b"])
    assert joints != JointState(name=["a"])
    assert joints != JointState(name=["a", "c"])
    assert joints == JointState(name=np.array(["a", "b"]))
    assert joints != JointState(name=np.array([["a"], ["b"]]))
    assert joints != JointState(name="ab")
    assert joints != JointState(name=5)  # type: ignore[arg-type]
    assert ParameterValue(bool_array_value=np.array([True, False])) == ParameterValue(
        bool_array_value=[True, False]
    )
    poses = np.array([geometry_msgs.Pose(), geometry_msgs.Pose()])
    assert geometry_msgs.PoseArray(poses=poses) == geometry_msgs.PoseArray(poses=list(poses))


@pytest.mark.parametrize(
    "numbers", [[1e50], [0.0, -1e39], [1, 2**200], [float("nan"), 1e50], [np.float64(1e50)]]
)
def test_arrays_of_float32_refuse_what_one_float32_refuses(numbers: list[float]) -> None:
    values = (numbers, tuple(numbers), (number for number in numbers), np.array(numbers, "d"))
    for value in values:
        with pytest.raises(
            OverflowError, match=r"beyond the range of float32: LaserScan\.ranges is float32\[\], got "
        ):
            LaserScan(ranges=value)
    fixed = define("array_msgs/msg/Fixed", f"float32[{len(numbers)}] data")
    for value in (numbers, np.array(numbers, "d")):
        with pytest.raises(OverflowError, match=r"beyond the range of float32: Fixed\.data"):
            fixed(data=value)


def test_arrays_of_float32_take_what_is_infinite_and_what_rounds_to_the_greatest() -> None:
    numbers = [math.inf, -math.inf, 3.4028235e38, 0.1]
    assert LaserScan(ranges=numbers).ranges == array.array("f", numbers)
    assert LaserScan(ranges=np.array(numbers)).ranges == array.array("f", numbers)
    assert LaserScan(ranges=(number for number in numbers)).ranges == array.array("f", numbers)
    assert LaserScan(ranges=b"\0\0\x80\x7f").ranges == array.array("f", [math.inf])
    fixed = define("array_msgs/msg/FixedFour", "float32[4] data")
    np.testing.assert_array_equal(fixed(data=numbers).data, np.array(numbers, "f"))


@pytest.mark.parametrize(
    ("numbers", "error"),
    [(np.full(16, 300), OverflowError), (np.full(16, -1), OverflowError), ([300] * 16, OverflowError),
     ([1.5] * 16, ValueError), (np.full(16, np.nan), ValueError), (np.full(16, np.inf), ValueError),
     ([np.int64(300)] * 16, OverflowError)],
)  # fmt: skip
def test_arrays_of_integers_refuse_what_they_would_change(numbers: Any, error: type[Exception]) -> None:
    with pytest.raises(error, match=r"UUID\.uuid is uint8\[16\], got "):
        UUID(uuid=numbers)
    assert (
        UUID(uuid=np.full(16, 255)).uuid.tolist() == UUID(uuid=np.full(16, 255.0)).uuid.tolist() == [255] * 16
    )


def test_an_unknown_keyword_warns_once_and_names_the_line() -> None:
    class_text = "std_msgs/msg/UInt8 has no field"
    with pytest.warns(
        UserWarning, match=f"{class_text} 'dat', so this keyword is ignored; its fields are data"
    ) as caught:
        assert std_msgs.UInt8(dat=1) == std_msgs.UInt8()
    assert [warning.filename for warning in caught] == [__file__]
    std_msgs.UInt8(dat=1)  # warnings are errors here
    std_msgs.UInt8(data=1, check_fields=None)
    std_msgs.UInt8(date=1, check_fields=False)
    with pytest.warns(UserWarning, match=f"{class_text} 'date'"):
        std_msgs.UInt8(dat=1, date=1)
    with pytest.warns(UserWarning, match="std_msgs/msg/Int8 has no field 'dat'"):
        std_msgs.Int8(dat=1)
    with pytest.warns(
        UserWarning, match="std_msgs/msg/Empty has no field 'a', so this keyword is ignored; it has no"
    ):
        std_msgs.Empty(a=1)


@pytest.mark.parametrize(
    ("make", "text"),
    [
        (lambda: Twist(foo=1, bar=2, check_fields=True), "Invalid arguments passed to constructor: bar, foo"),
        (
            lambda: Twist(linear=3, check_fields=True),
            "The 'linear' field must be a sub message of type 'Vector3'",
        ),
        (
            lambda: PointField(count=-1, check_fields=True),
            "The 'count' field must be an unsigned integer in [0, 4294967295]",
        ),
        (
            lambda: ColorRGBA(r=1e39, check_fields=True),
            "The 'r' field must be a float in [-3.402823466e+38, 3.402823466e+38]",
        ),
        (
            lambda: JointState(name=[1], check_fields=True),
            "The 'name' field must be a set or sequence and each value of type 'str'",
        ),
        (
            lambda: setattr(JointState(check_fields=True), "position", array.array("f")),
            "The 'position' array.array() must have the type code of 'd'",
        ),
        (
            lambda: setattr(JointState(check_fields=True), "position", np.zeros(0)),
            (
                "The 'position' field must be a set or sequence and each value of type 'float' and each double in "
                "[-1.7976931348623157e+308, 1.7976931348623157e+308]"
            ),
        ),
        (
            lambda: JointState(name=np.array(["a"]), check_fields=True),
            "The 'name' field must be a set or sequence and each value of type 'str'",
        ),
        (
            lambda: JointState(name=np.int64(5), check_fields=True),
            "The 'name' field must be a set or sequence and each value of type 'str'",
        ),
        (
            lambda: JointState(name={"a": 1}, check_fields=True),
            "The 'name' field must be a set or sequence and each value of type 'str'",
        ),
        (
            lambda: std_msgs.ByteMultiArray(data=[bytearray(b"a")], check_fields=True),
            "The 'data' field must be a set or sequence and each value of type 'bytes'",
        ),
        (lambda: setattr(String(check_fields=True), "data", 5), "The 'data' field must be of type 'str'"),
        (
            lambda: setattr(SolidPrimitive(check_fields=True), "dimensions", (0.0,) * 4),
            (
                "The 'dimensions' field must be a set or sequence with length <= 3 and each value of type 'float' and "
                "each double in [-1.7976931348623157e+308, 1.7976931348623157e+308]"
            ),
        ),
    ],
)
def test_check_fields_rejects_invalid_values(make: Callable[[], object], text: str) -> None:
    with pytest.raises(AssertionError) as raised:
        make()
    assert str(raised.value) == text


def test_check_fields_accepts_valid_values() -> None:
    message = CameraInfo(check_fields=True)
    message.k = [1.0] * 9
    message.d = [1.0]
    message.width = 640
    message.distortion_model = "plumb_bob"
    message.k = np.ones(9)
    JointState(name=deque(["a"]), position=array.array("d", [1.0]), check_fields=True)
    assert message.width == 640


def test_check_fields_from_the_environment() -> None:
    code = """
        from tfloom.interfaces.std_msgs.msg import String
        from tfloom.rosidl.cdr import decode, encode
        for use in (lambda: String(data=5), lambda: setattr(decode(String, encode(String())), "data", 5)):
            try:
                use()
            except AssertionError as error:
                print(error)
    """
    said = run_python(code, ROS_PYTHON_CHECK_FIELDS=1).stdout
    assert said.splitlines() == ["The 'data' field must be of type 'str'"] * 2


def test_positional_arguments_are_rejected() -> None:
    with pytest.raises(TypeError, match="Vector3 takes its fields by keyword"):
        Vector3(1.0)  # type: ignore[call-arg]


def test_unknown_attributes_raise() -> None:
    with pytest.raises(AttributeError):
        Vector3().q = 1.0  # type: ignore[attr-defined]


def test_message_package_imports_few_modules() -> None:
    code = (
        "import sys; before = set(sys.modules); import tfloom.interfaces.geometry_msgs.msg\n"
        "heavy = {'numpy', 'yaml', 're', 'inspect', 'dataclasses', 'typing', 'enum', 'pathlib', 'json'}\n"
        "print(sorted(heavy & (set(sys.modules) - before)))\n"
        "from tfloom.interfaces.tf2_msgs.msg import TFMessage; from tfloom.rosidl.cdr import encode\n"
        "encode(TFMessage())\n"
        "print('numpy' in sys.modules)"
    )
    assert run_python(code).stdout.splitlines() == ["[]", "False"]


def test_constants_and_defaults_can_not_be_assigned() -> None:
    class Derived(GoalStatus):
        pass

    for cls in (GoalStatus, Derived):
        with pytest.raises(
            AttributeError,
            match=r"^property 'STATUS_UNKNOWN' of 'Metaclass_GoalStatus' object has no setter$",
        ):
            cls.STATUS_UNKNOWN = 5
        with pytest.raises(
            AttributeError,
            match=r"^property 'STATUS_UNKNOWN' of 'Metaclass_GoalStatus' object has no deleter$",
        ):
            del cls.STATUS_UNKNOWN
    with pytest.raises(
        AttributeError, match="'STATUS__DEFAULT' of 'Metaclass_NavSatStatus' object has no deleter"
    ):
        del NavSatStatus.STATUS__DEFAULT
    with pytest.raises(AttributeError, match="NO_SUCH"):
        del GoalStatus.NO_SUCH
    with pytest.raises(AttributeError, match="'STATUS_UNKNOWN' is read-only"):
        GoalStatus().STATUS_UNKNOWN = 5
    with pytest.raises(AttributeError, match="'STATUS__DEFAULT' of 'Metaclass_NavSatStatus'"):
        NavSatStatus.STATUS__DEFAULT = 1
    assert (GoalStatus.STATUS_UNKNOWN, NavSatStatus.STATUS__DEFAULT) == (0, -2)
    Derived.OF_THE_PROGRAM = 1  # a name that the definition doesn't have
    Derived.OF_THE_PROGRAM = 2
    del Derived.OF_THE_PROGRAM


def test_fields_and_types_by_the_name_that_programs_read() -> None:
    assert Header._fields_and_field_types == {"stamp": "builtin_interfaces/Time", "frame_id": "string"}
    assert Header()._fields_and_field_types == Header.get_fields_and_field_types()
    assert (Empty._fields_and_field_types, Empty.SLOT_TYPES, Empty.__slots__) == ({}, (), ["_check_fields"])
    assert (Empty()._check_fields, Empty(check_fields=True)._check_fields) == (False, True)

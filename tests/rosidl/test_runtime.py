"""`rosidl_runtime_py` and `rosidl_parser` by ROS's names."""

from __future__ import annotations

import importlib
import re
from typing import Any

import pytest
from tests.rosidl.workspaces import run_python

import tfloom
from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.interfaces.sensor_msgs.msg import CameraInfo
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.interfaces.std_srvs.srv import SetBool
from tfloom.interfaces.turtlesim.action import RotateAbsolute
from tfloom.interfaces.turtlesim.srv import Spawn
from tfloom.ros_imports.distributions import INTERFACES
from tfloom.ros_imports.ros_distro import TURTLESIM_PACKAGE
from tfloom.rosidl import definition, runtime, sources
from tfloom.rosidl.definition import UnboundedSequence
from tfloom.rosidl.definition_files import interface_names
from tfloom.rosidl.fill import set_message_fields


def test_types_are_found_by_name() -> None:
    assert runtime.get_message("geometry_msgs/Twist") is Twist
    assert runtime.get_service("turtlesim/srv/Spawn") is Spawn
    assert runtime.get_action("turtlesim/action/RotateAbsolute") is RotateAbsolute
    assert runtime.get_interface("turtlesim/srv/Spawn") is Spawn
    named = runtime.get_message_namespaced_type("geometry_msgs/Twist")
    assert named.namespaced_name() == ("geometry_msgs", "msg", "Twist")
    assert runtime.import_message_from_namespaced_type(named) is Twist
    assert runtime.import_message_from_namespaced_type(UnboundedSequence(named)) is Twist


def test_fields_of_an_object_that_is_no_message_are_set_later_by_word() -> None:
    class Duck:
        def __init__(self) -> None:
            self.header, self.at, self.value = Header(), Time(), 1

    duck = Duck()
    values = {"header": "auto", "at": "now", "value": 3}
    setters = set_message_fields(duck, values, expand_header_auto=True, expand_time_now=True)  # type: ignore[arg-type]
    for set_time in setters:
        set_time(Time(sec=7))
    assert (duck.header.stamp.sec, duck.at.sec, duck.value) == (7, 7, 3)


@pytest.mark.parametrize(
    ("find", "name", "error", "text"),
    [
        (runtime.get_message, "Twist", ValueError, "Invalid name 'Twist'. Expected at least two parts"),
        (runtime.get_message, "geometry_msgs//Twist", ValueError, "Must not contain empty parts"),
        (runtime.get_message, "geometry_msgs/Nope", AttributeError, "module 'geometry_msgs.msg' has no attr"),
        (runtime.get_message, "nope_msgs/msg/Twist", ModuleNotFoundError, "No module named 'nope_msgs'"),
        (
            runtime.get_message,
            "turtlesim/srv/Spawn",
            ValueError,
            "Expected the full name of a message, got 'turtlesim/srv/Spawn'",
        ),
        (
            runtime.get_service,
            "geometry_msgs/msg/Twist",
            ValueError,
            "Expected the full name of a service, got 'geometry_msgs/msg/Twist'",
        ),
        (
            runtime.get_action,
            "turtlesim/srv/Spawn",
            ValueError,
            "Expected the full name of an action, got 'turtlesim/srv/Spawn'",
        ),
        (runtime.get_interface, "geometry_msgs", ValueError, "Expected at least two parts"),
    ],
)
def test_unknown_names_raise(find: Any, name: str, error: type[Exception], text: str) -> None:
    with pytest.raises(error, match=re.escape(text)):
        find(name)


def test_kinds_of_classes_are_recognised() -> None:
    assert [runtime.is_message(candidate) for candidate in (Twist, Twist(), Spawn, RotateAbsolute, int)] == [
        *(True, True, False, False, False)
    ]
    assert runtime.is_service(Spawn)
    assert runtime.is_action(RotateAbsolute)


IN_THEIR_PACKAGES = {
    "std_srvs/srv/SetBool": SetBool,
    "std_srvs/srv/SetBool_Request": SetBool.Request,
    "turtlesim/action/RotateAbsolute": RotateAbsolute,
    "turtlesim/action/RotateAbsolute_Goal": RotateAbsolute.Goal,
    "turtlesim/action/RotateAbsolute_FeedbackMessage": RotateAbsolute.Impl.FeedbackMessage,
    "geometry_msgs/msg/Twist": Twist,
}


@pytest.mark.parametrize("name", IN_THEIR_PACKAGES)
def test_classes_of_services_and_actions_are_imported_too(name: str) -> None:
    named = runtime.get_namespaced_type(name)
    assert runtime.import_message_from_namespaced_type(named) is IN_THEIR_PACKAGES[name]


def test_what_cannot_be_imported() -> None:
    with pytest.raises(ModuleNotFoundError, match="No module named 'nope'"):
        runtime.import_message_from_namespaced_type(runtime.get_namespaced_type("nope/msg/Twist"))
    with pytest.raises(AttributeError, match=r"module 'std_msgs\.msg' has no attribute 'Nope'"):
        runtime.import_message_from_namespaced_type(runtime.get_namespaced_type("std_msgs/msg/Nope"))


def test_slot_types_are_definition_objects() -> None:
    types = runtime.get_message_slot_types(CameraInfo())
    assert types["k"] == definition.Array(definition.BasicType("double"), 9)
    assert types["d"] == definition.UnboundedSequence(definition.BasicType("double"))
    assert types["roi"] == definition.NamespacedType(["sensor_msgs", "msg"], "RegionOfInterest")
    assert types["roi"] != types["header"]
    assert types["distortion_model"].has_maximum_size() is False
    assert repr(types["k"]) == "Array(BasicType('double'), 9)"


def test_definitions_convert_to_objects() -> None:
    message = definition.to_definition(sources.find_interface("geometry_msgs/msg/Quaternion"))
    members = message.structure.members
    assert [member.name for member in members] == ["x", "y", "z", "w"]
    assert members[3].get_annotation_value("default") == {"value": 1.0}
    service = definition.to_definition(sources.find_interface("std_srvs/srv/Empty"))
    assert [member.name for member in service.request_message.structure.members] == [
        definition.EMPTY_STRUCTURE_REQUIRED_MEMBER_NAME
    ]
    event = [member.name for member in service.event_message.structure.members]
    assert event == ["info", "request", "response"]
    action = definition.to_definition(sources.find_interface("example_interfaces/action/Fibonacci"))
    assert action.send_goal_service.namespaced_type.name == "Fibonacci_SendGoal"
    assert action.feedback_message.structure.members[1].type.name == "Fibonacci_Feedback"


def test_facades_export_the_functions() -> None:
    code = (
        "import tfloom; tfloom.use_ros_names()\n"
        "from geometry_msgs.msg import Twist\n"
        "from rosidl_parser.definition import BasicType, NamespacedType\n"
        "from rosidl_runtime_py import message_to_yaml, set_message_fields\n"
        "from rosidl_runtime_py.utilities import get_message, get_service\n"
        "from turtlesim.srv import Spawn\n"
        "twist = get_message('geometry_msgs/msg/Twist')()\n"
        "assert set_message_fields(twist, {'linear': {'x': 2.0}}) == []\n"
        "assert isinstance(twist, Twist) and isinstance(Twist.SLOT_TYPES[0], NamespacedType)\n"
        "assert get_service('turtlesim/srv/Spawn') is Spawn\n"
        "print(message_to_yaml(twist.linear), end='')"
    )
    run = run_python(code)
    assert (run.stdout, run.stderr) == ("x: 2.0\ny: 0.0\nz: 0.0\n", "")


@pytest.mark.parametrize("kind", ["msg", "srv", "action"])
def test_every_interface_has_a_facade(kind: str) -> None:
    tfloom.use_ros_names()
    for package in {name.split("/")[0] for name in interface_names(kind)}:
        facade = importlib.import_module(f"{package}.{kind}")
        root = "tfloom_interfaces" if package in INTERFACES.ros_packages else "tfloom"
        # One set of classes, by two names.
        home = TURTLESIM_PACKAGE if package in {"turtlesim", "turtlesim_msgs"} else package
        room = importlib.import_module(f"{root}.interfaces.{home}.{kind}")
        assert facade.__all__ == room.__all__
        assert all(getattr(facade, name) is getattr(room, name) for name in room.__all__)

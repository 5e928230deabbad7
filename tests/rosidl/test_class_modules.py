"""Classes say where they come from as ROS's do: `geometry_msgs.msg._pose_stamped`."""

from __future__ import annotations

import copy
import inspect
import json
import os
import pickle
import random
import textwrap
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest
from tests.each import for_each
from tests.rosidl.workspaces import run_python, snake, write_files

from tfloom.ros_imports.distributions import INTERFACES, find_prefix
from tfloom.ros_imports.modules import module_leaf
from tfloom.rosidl.dynamic import define
from tfloom.rosidl.registry import find_class, get_action_class, get_message_class, get_service_class

FACES: dict[str, Any] = json.loads(
    Path(__file__).parents[1].joinpath("golden", "python_messages.json").read_text("utf-8")
)
PICKLES: dict[str, dict[str, str]] = json.loads(Path(__file__).with_name("pickles.json").read_text("utf-8"))
"""What tfloom wrote while classes had the modules that define them, and what rclpy 7.1.6 writes."""
DEFINITIONS = {
    "my_interfaces/msg/Sphere.msg": "float64 radius\n",
    "my_interfaces/srv/Weigh.srv": "Sphere sphere\n---\nfloat64 mass\n",
    "my_interfaces/action/RollOver.action": "float64 distance\n---\nfloat64 rolled\n---\nfloat64 now\n",
}


@for_each(FACES)
def test_classes_have_the_path_that_they_have_in_ros(name: str) -> None:
    cls = find_class(name)
    assert f"{cls.__module__}.{cls.__qualname__}" == FACES[name]["class"]
    assert getattr(import_module(cls.__module__), cls.__name__) is cls


def test_names_of_modules() -> None:
    choose = random.Random(1).choice
    names = {choose("AB") + "".join(choose("ABab12") for _ in range(7)) for _ in range(5000)}
    names |= {name[:length] for name in names for length in range(1, 8)}
    assert {name: module_leaf(name) for name in names} == {name: f"_{snake(name)}" for name in names}


def test_parts_of_services_and_actions() -> None:
    service, action = get_service_class("std_srvs/SetBool"), get_action_class("example_interfaces/Fibonacci")
    for cls in (service, service.Request, service.Response, service.Event):
        assert cls.__module__ == "std_srvs.srv._set_bool"
    carriers = [action.Impl.SendGoalService, action.Impl.GetResultService]
    parts = [
        part for carrier in carriers for part in (carrier, carrier.Request, carrier.Response, carrier.Event)
    ]
    own = [action, action.Goal, action.Result, action.Feedback, action.Impl, action.Impl.FeedbackMessage]
    for cls in (*own, *parts):
        assert cls.__module__ == "example_interfaces.action._fibonacci"
        assert pickle.loads(pickle.dumps(cls)) is cls
    assert repr(action.Impl) == "<class 'example_interfaces.action._fibonacci.Fibonacci.Impl'>"
    assert action.Impl.CancelGoalService.__module__ == "action_msgs.srv._cancel_goal"


def test_the_module_has_the_classes_and_their_metaclasses() -> None:
    module = import_module("std_srvs.srv._set_bool")
    assert import_module("std_srvs").srv._set_bool is module
    names = [name for name in dir(module) if not name.startswith("_")]
    classes = ["SetBool", "SetBool_Event", "SetBool_Request", "SetBool_Response"]
    assert names == sorted(f"{prefix}{name}" for name in classes for prefix in ("", "Metaclass_"))
    assert module.__all__ == classes
    assert repr(module.Metaclass_SetBool) == "<class 'std_srvs.srv._set_bool.Metaclass_SetBool'>"
    assert pickle.loads(pickle.dumps(module.Metaclass_SetBool)) is module.Metaclass_SetBool
    assert issubclass(module.Metaclass_SetBool, type)
    module.Metaclass_SetBool.__import_type_support__()
    for absent in ("Trigger", "Metaclass_Trigger", "Message", "__version__"):
        assert not hasattr(module, absent)
    with pytest.raises(ModuleNotFoundError, match=r"std_srvs\.srv\._set_bol"):
        import_module("std_srvs.srv._set_bol")


def test_source_and_copies() -> None:
    pose = get_message_class("geometry_msgs/PoseStamped")
    assert inspect.getsource(pose).startswith("class PoseStamped(_Message):")
    assert inspect.getmodule(pose) is import_module("geometry_msgs.msg._pose_stamped")
    message = pose(header=get_message_class("std_msgs/Header")(frame_id="map"))
    for copied in (copy.copy(message), copy.deepcopy(message), pickle.loads(pickle.dumps(message))):
        assert copied == message


@pytest.mark.skipif(find_prefix(INTERFACES) is None, reason="tfloom-interfaces is not installed")
def test_classes_of_tfloom_interfaces() -> None:
    goal = get_action_class("nav2_msgs/NavigateToPose").Goal
    assert goal.__module__ == "nav2_msgs.action._navigate_to_pose"
    assert pickle.loads(pickle.dumps(goal())) == goal()


@pytest.mark.parametrize("writer", PICKLES)
def test_pickles_of_others_are_read(writer: str) -> None:
    define("my_msgs/msg/Custom", "float64[<=3] ranges\nstring name")
    values = {name: pickle.loads(bytes.fromhex(text)) for name, text in PICKLES[writer].items()}
    pose, scan = values["PoseStamped"], values["LaserScan"]
    assert (pose.header.frame_id, pose.header.stamp.sec, pose.pose.position.x) == ("map", 7, 1.5)
    assert (scan.header.frame_id, list(scan.ranges)) == ("laser", [1.0, 2.5])
    assert values["SetBool_Request"].data is True
    assert values["Fibonacci_Goal"].order == 5
    assert values["Fibonacci_FeedbackMessage_class"].__name__ == "Fibonacci_FeedbackMessage"
    assert values["PoseStamped_class"] is type(pose)
    assert values["SetBool_class"].Request is type(values["SetBool_Request"])
    if writer == "tfloom":
        assert list(values["my_msgs/msg/Custom"].ranges) == [1.0, 2.0]
    else:
        assert pickle.dumps(values["SetBool_Request"], protocol=4).hex() == PICKLES[writer]["SetBool_Request"]


def run(code: str, *path: Path, **environment: object) -> str:
    done = run_python(code, PYTHONPATH=os.pathsep.join(map(str, path)), **environment)
    assert done.returncode == 0, done.stderr
    return done.stdout


OWN = ["tfloom.interfaces.geometry_msgs.msg", "tfloom.interfaces.std_srvs.srv", "tfloom.rosidl.dynamic"]
ROUND_TRIP = """
    import pickle
    from tfloom.interfaces.geometry_msgs.msg import Pose
    from tfloom.interfaces.std_srvs.srv import Trigger
    from tfloom.rosidl.dynamic import define
    Custom = define("my_msgs/msg/Custom", "float64 x")
    for cls in (Pose, Trigger.Request, Custom):
        assert pickle.loads(pickle.dumps(cls())) == cls()
        print(cls.__module__)
"""


def test_beside_a_real_ros_they_keep_a_path_that_leads_to_them(tmp_path: Path) -> None:
    write_files(
        tmp_path, {f"{package}/__init__.py": "" for package in ("rclpy", "geometry_msgs", "std_srvs")}
    )
    assert run(ROUND_TRIP, tmp_path).split() == OWN


def test_without_facades_they_keep_a_path_that_leads_to_them() -> None:
    code = "import sys; sys.path = [path for path in sys.path if not path.endswith('ros_names')]\n"
    assert run(code + textwrap.dedent(ROUND_TRIP)).split() == OWN


def test_made_classes_have_a_package_in_this_process() -> None:
    thing = define("made_msgs/msg/NearThing", "float64 x")
    module: Any = import_module("made_msgs.msg._near_thing")
    assert module.NearThing is thing
    assert import_module("made_msgs").msg.NearThing is thing
    assert not hasattr(import_module("made_msgs.msg"), "Other")
    assert repr(thing) == "<class 'made_msgs.msg._near_thing.NearThing'>"
    again = define("made_msgs/msg/NearThing", "float64 y")
    assert pickle.loads(pickle.dumps(again(y=1.0))) == again(y=1.0)


def test_a_definition_in_the_place_of_tflooms_own_leads_to_itself() -> None:
    code = """
        import pickle
        from tfloom.rosidl.dynamic import define
        made = define("std_msgs/msg/Bool", "float64 x")
        from std_msgs.msg import Bool
        assert made is not Bool
        for cls in (made, Bool):
            assert pickle.loads(pickle.dumps(cls)) is cls
        print(made.__module__, Bool.__module__)
    """
    assert run(code) == "tfloom.rosidl.dynamic std_msgs.msg._bool\n"


def test_a_workspaces_classes(tmp_path: Path) -> None:
    write_files(tmp_path / "share", DEFINITIONS)
    code = """
        from my_interfaces.msg._sphere import Sphere, Metaclass_Sphere
        import my_interfaces.srv._weigh, pickle, my_interfaces.action
        from my_interfaces.action import RollOver
        print(Sphere, my_interfaces.srv._weigh.Weigh.Request, my_interfaces.action._roll_over.RollOver.Impl)
        print(pickle.dumps([Sphere(radius=2.0), RollOver.Impl.SendGoalService.Request()]).hex())
    """
    classes, pickled = run(code, AMENT_PREFIX_PATH=tmp_path).splitlines()
    assert classes == (
        "<class 'my_interfaces.msg._sphere.Sphere'> <class 'my_interfaces.srv._weigh.Weigh_Request'> "
        "<class 'my_interfaces.action._roll_over.RollOver.Impl'>"
    )
    read = f"import pickle; print(pickle.loads(bytes.fromhex('{pickled}'))[0])"
    assert run(read, AMENT_PREFIX_PATH=tmp_path) == "my_interfaces.msg.Sphere(radius=2.0)\n"

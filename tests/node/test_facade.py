"""`import rclpy`: exports, import time, and the guard against a real ROS."""

from __future__ import annotations

import importlib
import pickle
import re
import subprocess
import sys
from pathlib import Path

import pytest
import rclpy
from tests.conftest import run_to_end
from tests.each import for_each
from tools.facades import recorded

from tfloom.rosidl.class_modules import DefinitionModule

FACADE = Path(rclpy.__file__).parent
ASYNC_MODULES = {"rclpy.experimental"}
"""Those that need asyncio.TaskGroup, which Python 3.10 does not have."""
MODULES = sorted(
    {
        ".".join(path.relative_to(FACADE.parent).with_suffix("").parts).removesuffix(".__init__")
        for path in FACADE.rglob("*.py")
    }
    - (ASYNC_MODULES if sys.version_info < (3, 11) else set())
)


@pytest.mark.filterwarnings("ignore:importing 'qos_event'")
@for_each(MODULES)
def test_each_facade_module_re_exports_its_room(name: str) -> None:
    module = importlib.import_module(name)
    for export in getattr(
        module, "__all__", [export for export in dir(module) if not export.startswith("_")]
    ):
        thing = getattr(module, export)
        defined_in = getattr(thing, "__module__", "tfloom.node")
        if not isinstance(sys.modules.get(str(defined_in)), DefinitionModule):  # a message's, by ROS's name
            homes = ("tfloom.", "rclpy.", "typing", "builtins", "collections.abc", "types")
            assert str(defined_in).startswith(homes), export


def errors() -> set[str]:
    """Return the errors of rclpy that the façades have, by the recorded module that defines each in ROS."""
    return {
        f"{home}.{name}"
        for module in MODULES
        for name, home in recorded.imported_from(module).items()
        if home in MODULES and is_error(getattr(importlib.import_module(home), name, None), name)
    }


def is_error(value: object, name: str) -> bool:
    """Return whether a value is an error of tfloom that also has this name where it is defined."""
    is_class = isinstance(value, type) and issubclass(value, Exception)
    return is_class and value.__module__ != "builtins" and value.__name__ == name


@pytest.mark.filterwarnings("ignore:importing 'qos_event'")
@for_each(errors)
def test_errors_say_where_they_come_from_as_in_ros(error: str) -> None:
    home, _, name = error.rpartition(".")
    cls = getattr(importlib.import_module(home), name)
    assert cls.__module__ == home
    assert pickle.loads(pickle.dumps(cls)) is cls


def test_errors_lead_to_themselves_beside_another_rclpy(tmp_path: Path) -> None:
    (tmp_path / "rclpy").mkdir()
    (tmp_path / "rclpy" / "__init__.py").touch()
    code = (
        f"import sys; sys.path.insert(0, {str(tmp_path)!r})\n"
        "import pickle\nfrom tfloom.node.values.exceptions import RCLError\n"
        "assert pickle.loads(pickle.dumps(RCLError)) is RCLError\nprint(RCLError.__module__)"
    )
    assert run(code).stdout == "tfloom.node.values.exceptions\n"


def test_a_traceback_shows_the_name_that_ros_shows() -> None:
    result = run("import rclpy; rclpy.init(); rclpy.create_node('a b')")
    assert "\nrclpy.exceptions.InvalidNodeNameException: Invalid node name" in result.stderr


def test_objects_show_the_names_that_ros_shows() -> None:
    result = run(
        "import inspect, launch, launch_ros.actions\n"
        "import rclpy, rclpy.action, rclpy.executors, rclpy.task, rclpy.time_source\n"
        "from launch import LaunchDescription, LaunchIntrospector, actions, conditions, events, substitutions\n"
        "from std_msgs.msg import String; from std_srvs.srv import Empty\n"
        "from example_interfaces.action import Fibonacci\n"
        "rclpy.init(); node = rclpy.create_node('a'); print(node)\n"
        "print(node.create_publisher(String, 'a', 1), node.create_subscription(String, 'a', print, 1))\n"
        "print(node.create_client(Empty, 'b'), node.create_service(Empty, 'b', print))\n"
        "print(node.create_timer(1, print), node.create_guard_condition(print), node.create_rate(1))\n"
        "print(rclpy.action.ActionClient(node, Fibonacci, 'c'))\n"
        "print(rclpy.action.ActionServer(node, Fibonacci, 'c', print))\n"
        "print(node.context, node.default_callback_group, rclpy.executors.SingleThreadedExecutor())\n"
        "print(rclpy.task.Future(), rclpy.time_source.TimeSource(), launch.LaunchContext(), launch.LaunchService())\n"
        "print([*node.get_publishers_info_by_topic('/a'), rclpy.executors.MultiThreadedExecutor()])\n"
        "print(actions.LogInfo(msg=''), conditions.IfCondition('1'), events.Shutdown())\n"
        "print(launch_ros.actions.SetParameter('a', 1), substitutions.TextSubstitution(text=''))\n"
        "print(LaunchIntrospector().format_launch_description(LaunchDescription([actions.GroupAction([])])))\n"
        "class Own(launch.Action): pass\n"
        "print(Own(), inspect.getsource(rclpy.node.Node).startswith('class Node'))"
    )
    assert re.findall(r"<(\S+) object at 0x[0-9a-f]+>", result.stdout) == [
        "rclpy.node.Node",
        "rclpy.publisher.Publisher",
        "rclpy.subscription.Subscription",
        "rclpy.client.Client",
        "rclpy.service.Service",
        "rclpy.timer.Timer",
        "rclpy.guard_condition.GuardCondition",
        "rclpy.timer.Rate",
        "rclpy.action.client.ActionClient",
        "rclpy.action.server.ActionServer",
        "rclpy.context.Context",
        "rclpy.callback_groups.MutuallyExclusiveCallbackGroup",
        "rclpy.executors.SingleThreadedExecutor",
        "rclpy.task.Future",
        "rclpy.time_source.TimeSource",
        "launch.launch_context.LaunchContext",
        "launch.launch_service.LaunchService",
        "rclpy.topic_endpoint_info.TopicEndpointInfo",
        "rclpy.executors.MultiThreadedExecutor",
        "launch.actions.log_info.LogInfo",
        "launch.conditions.if_condition.IfCondition",
        "launch.events.shutdown.Shutdown",
        "launch_ros.actions.set_parameter.SetParameter",
        "launch.substitutions.text_substitution.TextSubstitution",
        "launch.launch_description.LaunchDescription",
        "launch.actions.group_action.GroupAction",
        "__main__.Own",
    ], result.stderr
    assert result.stdout.endswith(" True\n")


def test_an_error_of_missing_arguments_shows_the_name_that_ros_shows() -> None:
    result = run("import rclpy; rclpy.init(); rclpy.create_node('a').create_publisher('a')")
    error = result.stderr.splitlines()[-1]
    assert error.startswith("TypeError: Node.create_publisher() missing 2 required positional arguments: ")


def test_an_error_of_a_types_argument_shows_the_names_that_ros_shows() -> None:
    result = run(
        "from launch.actions import LogInfo; from launch.action import Action\n"
        "from launch.utilities import ensure_argument_type\n"
        "ensure_argument_type(LogInfo(msg=''), [str, Action, int][::2], 'x')"
    )
    assert (
        "to be one of [<class 'str'>, <class 'int'>], but got '<launch.actions.log_info.LogInfo"
        in result.stderr
    )
    assert "of type '<class 'launch.actions.log_info.LogInfo'>'" in result.stderr


LAUNCH_ERRORS = [
    "launch.substitutions.substitution_failure.SubstitutionFailure",
    "launch.conditions.invalid_condition_expression_error.InvalidConditionExpressionError",
    "launch.invalid_launch_file_error.InvalidLaunchFileError",
    "launch.frontend.parser.InvalidFrontendLaunchFileError",
    "launch_ros.utilities.plugin_support.PluginException",
    "launch_testing.util.proc_lookup.NoMatchingProcessException",
    "ament_index_python.packages.PackageNotFoundError",
    "tf2_ros.buffer_interface.TypeException",
]


@for_each(LAUNCH_ERRORS)
def test_errors_of_other_packages_say_where_they_come_from(error: str) -> None:
    home, _, name = error.rpartition(".")
    cls = getattr(importlib.import_module(home), name)
    assert cls.__module__ == home
    assert pickle.loads(pickle.dumps(cls)) is cls


def run(code: str, *options: str) -> subprocess.CompletedProcess[str]:
    return run_to_end([sys.executable, *options, "-c", code])


def test_messages_are_available_after_importing_their_package_alone() -> None:
    result = run(
        "import std_msgs, turtlesim; print(std_msgs.msg.Bool(data=True), turtlesim.srv.Spawn); std_msgs.srv"
    )
    assert result.stdout.startswith("std_msgs.msg.Bool(data=True) <class"), result.stderr
    assert "AttributeError: module 'std_msgs' has no attribute 'srv'" in result.stderr


def test_deferred_name_is_imported_on_first_use() -> None:
    code = (
        "import sys, rclpy.client, rclpy.node, tf2_ros\n"
        "late = 'tfloom.node.executing.executor', 'tfloom.node.action.client', 'tfloom.interfaces.sensor_msgs.msg'\n"
        "print([name in sys.modules for name in late])\n"
        "from rclpy.node import Executor\n"
        "from tf2_ros import ActionClient, MsgStamped\n"
        "print([name in sys.modules for name in late])\n"
        "print(Executor is rclpy.executors.Executor, 'Executor' in vars(rclpy.node))\n"
        "rclpy.node.Nope\n"
    )
    result = run(code)
    lines = result.stdout.splitlines()
    assert lines == ["[True, False, False]", "[True, True, True]", "True True"], result.stderr
    assert "AttributeError: module 'rclpy.node' has no attribute 'Nope'" in result.stderr


def test_import_loads_no_heavy_module() -> None:
    heavy = ["numpy", "yaml", "asyncio", "inspect", "dataclasses", "logging", "argparse", "subprocess"]
    code = f"import sys, rclpy, rclpy.node, rclpy.executors; print([m for m in {heavy} if m in sys.modules])"
    result = run(code)
    assert result.stdout.strip() == "[]", result.stderr


def test_facade_beside_a_real_ros_raises_import_error(tmp_path: Path) -> None:
    (tmp_path / "rclpy").mkdir()
    (tmp_path / "rclpy" / "__init__.py").write_text("")
    claim = "from tfloom.ros_imports.guard import claim; claim('tf2_ros')"
    code = f"import sys; sys.path.insert(0, {str(tmp_path)!r}); {claim}"
    result = run(code)
    assert result.returncode == 1
    last = result.stderr.strip().splitlines()[-1]
    assert last.startswith("ImportError: 'tf2_ros' would come from tfloom, but 'rclpy' comes from ")
    assert str(tmp_path) in last


def test_guard_accepts_tflooms_rclpy() -> None:
    assert run("import rclpy; from tfloom.ros_imports.guard import claim; claim('tf2_ros')").returncode == 0
    assert run("from tfloom.ros_imports.guard import claim; claim('tf2_ros')").returncode == 0


def test_submodules_are_available_after_import_rclpy() -> None:
    result = run(
        "import rclpy; print(rclpy.time.Time(), rclpy.executors.ExternalShutdownException.__name__); rclpy.nope"
    )
    assert result.stdout == "Time(nanoseconds=0, clock_type=SYSTEM_TIME) ExternalShutdownException\n"
    assert "AttributeError: module 'rclpy' has no attribute 'nope'" in result.stderr

"""The drop-in classes take the arguments of tf2_ros's, work with tfloom's own rclpy, and raise tf2_py's exceptions."""

from __future__ import annotations

import inspect
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.drop_in.conftest import Peer
from tests.tf2_ros.test_api import API, ours, recorded

from tfloom import drop_in
from tfloom.drop_in import buffer as drop_in_buffer
from tfloom.drop_in import real_ros, transform_listener
from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.node.node import Node
from tfloom.node.values.time import Time
from tfloom.tf2_ros import buffer as tf2_ros_buffer
from tfloom.tf2_ros import transform_listener as tf2_ros_listener

CLASSES = {
    "Buffer": drop_in_buffer.Buffer,
    "BufferInterface": drop_in_buffer.Buffer,
    "TransformListener": transform_listener.TransformListener,
}
CALLS = {
    f"{name}.{member}": signature
    for name in CLASSES
    for member, signature in {
        **API["tf2_ros"][name]["members"],
        "__init__": API["tf2_ros"][name]["init"],
    }.items()
    if f"{name}.{member}" != "BufferInterface.__init__"
}

STAND_INS = {
    "tf2_py.py": """
import ctypes
create = ctypes.pythonapi.PyErr_NewException  # as tf2_py's extension creates them
create.restype, create.argtypes = ctypes.py_object, [ctypes.c_char_p, ctypes.py_object, ctypes.py_object]
TransformException = create(b"tf2.TransformException", Exception, {})
names = ["Connectivity", "Lookup", "Extrapolation", "InvalidArgument", "Timeout"]
for name in [f"{stem}Exception" for stem in names]:
    globals()[name] = create(f"tf2.{name}".encode(), TransformException, {})
""",
    "tf2_ros.py": """
from tf2_py import *
class TypeException(Exception): pass
class TransformRegistration:
    functions = {}
    def add(self, key, callback):
        self.functions[key] = callback
    def get(self, key):
        try:
            return self.functions[key]
        except KeyError:
            raise TypeException(f"Type {key} is not loaded or supported")
def convert(a, b_type):
    return ("converted", a, b_type)
""",
}
"""The interface of tf2_py and tf2_ros that the drop-in uses: they have no wheels, so these stand for them."""

BESIDE_TF2 = """
import pickle
import tf2_ros
from geometry_msgs.msg import PointStamped, PoseStamped, TransformStamped
from rclpy.time import Time
from tfloom.drop_in import Buffer, ExtrapolationException
import tfloom.tf2.errors

buffer = Buffer()
message = TransformStamped(child_frame_id="turtle")
message.header.frame_id = "world"
message.transform.translation.x = 1.0
buffer.set_transform_static(message, "test")
buffer.set_transform(TransformStamped(header=message.header, child_frame_id="other"), "test")
try:
    buffer.lookup_transform("world", "nowhere", Time())
except tf2_ros.LookupException as error:
    assert isinstance(error, tfloom.tf2.errors.LookupException)
    assert "nowhere" in str(error)
    assert type(pickle.loads(pickle.dumps(error))) is type(error)
try:
    buffer.lookup_transform("world", "other", Time(seconds=5))
except tf2_ros.TransformException as error:
    assert isinstance(error, tf2_ros.ExtrapolationException) and isinstance(error, ExtrapolationException)
    assert error.requested_ns == 5_000_000_000
future = buffer.wait_for_transform_async("world", "", Time())
assert isinstance(future.exception(), tf2_ros.InvalidArgumentException), future.exception()
tf2_ros.TransformRegistration().add(PointStamped, lambda point, transform: ("theirs", transform.header.frame_id))
point, pose = PointStamped(), PoseStamped()
point.header.frame_id = pose.header.frame_id = "turtle"
assert buffer.transform(point, "world") == ("theirs", "world")
assert buffer.transform(point, "world", new_type=int) == ("converted", ("theirs", "world"), int)
assert buffer.transform(pose, "world").pose.position.x == 1.0
try:
    buffer.transform(Time(), "world")
except tf2_ros.TypeException:
    print("passed")
"""


@pytest.mark.parametrize("place", CALLS)
def test_signatures_accept_the_arguments_of_tf2_ros(place: str) -> None:
    name, _, member = place.partition(".")
    theirs, mine = recorded(CALLS[place]), ours(getattr(CLASSES[name], member))
    names = [parameter for parameter, _ in theirs]
    assert [parameter for parameter, _ in mine if parameter in names] == names
    defaults = dict(mine)
    assert {parameter: defaults[parameter] for parameter, default in theirs if default is not None} == {
        parameter: default for parameter, default in theirs if default is not None
    }
    assert all(
        default is not None or parameter == "*" for parameter, default in mine if parameter not in names
    )


def test_methods_have_the_signatures_of_tfloom_s_own_classes() -> None:
    for kind, own in (
        (drop_in_buffer.Buffer, tf2_ros_buffer.Buffer),
        (transform_listener.TransformListener, tf2_ros_listener.TransformListener),
        (transform_listener.StaticTransformListener, tf2_ros_listener.StaticTransformListener),
    ):
        for name, member in inspect.getmembers(own, inspect.isfunction):
            if not name.startswith("_"):
                parameters = inspect.signature(member).parameters
                assert list(inspect.signature(getattr(kind, name)).parameters) == list(parameters), name


def test_with_tfloom_s_rclpy_the_names_are_its_own(make_node: Callable[..., Node]) -> None:
    assert drop_in.Buffer is tf2_ros_buffer.Buffer
    node = make_node("under_test")
    buffer = drop_in.Buffer()
    listener = drop_in.TransformListener(buffer, node, raw=True)
    assert isinstance(listener, tf2_ros_listener.TransformListener)
    buffer.set_transform_static(_static(), "test")
    assert buffer.can_transform("a", "b", Time())
    with pytest.raises(drop_in.LookupException):
        buffer.lookup_transform("a", "c", Time())
    drop_in.StaticTransformListener(buffer, node, raw=False).unregister()
    listener.unregister()


def _static() -> TransformStamped:
    message = TransformStamped(child_frame_id="b")
    message.header.frame_id = "a"
    return message


@pytest.mark.ros
def test_exceptions_and_conversions_are_those_of_an_installed_tf2_ros(real_ros: Peer, tmp_path: Path) -> None:
    for name, text in STAND_INS.items():
        (tmp_path / name).write_text(text, "utf-8")
    program = real_ros.start(BESIDE_TF2, domain_id=0, paths=[tmp_path, *real_ros.sites])
    assert program.wait() == 0, program.output
    assert program.lines == ["passed"]


def test_import_of_the_room_alone_needs_no_ros() -> None:
    code = "import sys; import tfloom.drop_in.buffer; print('rclpy' in sys.modules)"
    done = subprocess.run(
        [sys.executable, "-c", code], capture_output=True, text=True, check=True, timeout=60
    )
    assert done.stdout == "False\n"


def test_no_real_rclpy_is_found_in_the_environment_of_tfloom_alone() -> None:
    assert not real_ros.has_rclpy()
    assert real_ros.find("tf2_py") is None
    with pytest.raises(
        ImportError, match="'tf2_msgs' is not installed for the ROS 2 that 'rclpy' comes from"
    ):
        real_ros.message_class("tf2_msgs", "TFMessage")

"""What is fuzzed: functions of bytes that return whether they were accepted, and raise only what is a finding."""

from __future__ import annotations

import json
import tempfile
import warnings
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path
from types import SimpleNamespace
from typing import Any

from tfloom._native import StateTransforms
from tfloom.bag import BagError, frames, open_bag
from tfloom.bag.message_classes import class_of
from tfloom.cli.shared.errors import CommandError
from tfloom.cli.shared.interfaces import fill_message, parse_yaml
from tfloom.interfaces.diagnostic_msgs.msg import DiagnosticArray
from tfloom.interfaces.nav_msgs.msg import OccupancyGrid
from tfloom.interfaces.sensor_msgs.msg import JointState
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.interfaces.type_description_interfaces.msg import TypeDescription
from tfloom.rmw.cyclone import discovery_info
from tfloom.rmw.cyclone.graph import CycloneGraph
from tfloom.robot.model import RobotModel
from tfloom.robot.robot_transforms import RobotTransforms
from tfloom.robot.urdf import UrdfError, parse_urdf
from tfloom.rosidl import cdr, class_table, described, sources
from tfloom.rosidl.idl_spec import parse_idl
from tfloom.rosidl.parse import ParseError, parse_interface
from tfloom.rosidl.recorded import recorded_class
from tfloom.rosidl.yaml_text import message_to_yaml
from tfloom.workspace.cmake_lists import read_plan
from tfloom.workspace.cmake_syntax import CMakeSyntaxError

KINDS = ("msg", "srv", "action")
QUALITY = (1, 1, 1, 1, 0, 0, 1, 0)
DESCRIBED = "fuzz_msgs/msg/Fuzz"


def _refused(error: Exception, *, is_clear: bool) -> bool:
    """Return False, for an input that was refused; a refusal without a reason is a finding."""
    assert is_clear, f"the error has no reason or place: {error!r}"
    return False


def definitions(data: bytes) -> bool:
    """Parse a definition; the first octet selects its kind."""
    if not data:
        return False
    kind = KINDS[data[0] % len(KINDS)]
    try:
        interface = parse_interface(data[1:].decode("utf-8", "replace"), f"fuzz_msgs/{kind}/Fuzz")
    except ParseError as error:
        place = (error.path, error.line >= 1, error.column >= 1)
        return _refused(error, is_clear=place == (f"fuzz_msgs/{kind}/Fuzz.{kind}", True, True))
    assert interface.name == f"fuzz_msgs/{kind}/Fuzz"
    return True


def idl(data: bytes) -> bool:
    """Parse an .idl file of a message."""
    try:
        interface = parse_idl(data.decode("utf-8", "replace"), "fuzz_msgs/msg/Fuzz", "Fuzz.idl")
    except ParseError as error:
        return _refused(
            error, is_clear=(error.path, error.line >= 1, error.column >= 1) == ("Fuzz.idl", True, True)
        )
    assert interface.name == "fuzz_msgs/msg/Fuzz"
    return True


def descriptions(data: bytes) -> bool:
    """Make the class of a type description, with the hash that it has itself."""
    try:
        description = cdr.decode(TypeDescription, data)
    except ValueError:
        return False
    description.type_description.type_name = DESCRIBED
    names = {DESCRIBED, *(referenced.type_name for referenced in description.referenced_type_descriptions)}
    known = {name for name in names if sources.find_source(name) is not None} if _are_types(names) else set()
    try:
        hashes = {DESCRIBED: _own_hash(description)}
        described.define_described(DESCRIBED, description, hashes)
    except described.DescriptionError:
        return False
    finally:
        for name in names - known if _are_types(names) else ():
            sources.replace(name, None)
            class_table.forget(name)
    return True


def _are_types(names: set[str]) -> bool:
    return all(name.count("/") == 2 for name in names)


def _own_hash(description: TypeDescription) -> str:
    types = described._table(description)
    described.check_size(DESCRIBED, types)
    return described.hash_of(DESCRIBED, types)


def graph(data: bytes) -> bool:
    """Read what a participant and an endpoint announce: six parts, each with its length before it."""
    parts = [b""] * 6
    rest = data
    for number in range(len(parts)):
        size = rest[0] if rest else 0
        parts[number], rest = rest[1 : 1 + size], rest[1 + size :]
    participant_data, topic, type_name, user_data, gid, node_list = (*parts[:5], rest or parts[5])
    participant, endpoint = gid[:16].ljust(16, b"\0"), gid[-16:].ljust(16, b"\1")
    found = CycloneGraph.__new__(CycloneGraph)
    found._endpoints = {}
    found._native = SimpleNamespace(
        snapshot=lambda: (
            [(participant, participant_data, node_list)],
            [(endpoint, participant, bool(gid[:1]), topic, type_name, user_data, QUALITY)],
        )
    )
    view = found._read(1)
    assert len(view.raw_endpoints) == 1
    for name, _ in view.enclaves:
        assert name.full.startswith(("/", "")), name
    try:
        owner, nodes = discovery_info.decode(node_list)
    except discovery_info.NodeListError:
        return False
    assert discovery_info.decode(discovery_info.encode(owner, nodes)) == (owner, nodes)
    return True


def yaml(data: bytes) -> bool:
    """Fill messages with values as `topic pub` does; the first octet selects the message."""
    if not data:
        return False
    message = (JointState, DiagnosticArray, OccupancyGrid)[data[0] % 3]()
    try:
        fill_message(message, parse_yaml(data[1:].decode("utf-8", "replace")))
    except CommandError as error:
        return _refused(error, is_clear=bool(str(error).strip()))
    cdr.decode(type(message), cdr.encode(message))
    message_to_yaml(message)
    return True


def cdr_bytes(data: bytes) -> bool:
    """Decode a message of one of the common classes, and write it again; the first octet selects the class."""
    if not data:
        return False
    cls: Any = (JointState, DiagnosticArray, OccupancyGrid, TypeDescription)[data[0] % 4]
    try:
        message = cdr.decode(cls, data[1:])
    except ValueError:
        return False
    again = cdr.encode(message)
    assert cdr.encode(cdr.decode(cls, again)) == again
    json.dumps(message_to_yaml(message, truncate_length=8))
    return True


def mcap(data: bytes) -> bool:
    """Read an MCAP file."""
    return _recording(data, "fuzz.mcap")


def ros1(data: bytes) -> bool:
    """Read a bag of ROS 1."""
    return _recording(data, "fuzz.bag")


def _recording(data: bytes, name: str) -> bool:
    """Read a recording: its topics, its messages, its transforms and the classes of its types.

    What it declares and doesn't hold is told of, and so is a message that a part of the time lacks.
    """
    with tempfile.TemporaryDirectory() as folder, warnings.catch_warnings(record=True) as caught:
        warnings.simplefilter("always")
        path = Path(folder) / name
        path.write_bytes(data)
        try:
            bag = open_bag(path)
            messages = list(bag.messages())
            stamps = [message.log_time_ns for message in messages]
            assert stamps == sorted(stamps) or caught
            if stamps:
                part = list(bag.messages(None, stamps[len(stamps) // 2], stamps[-1]))
                assert sorted(part) == sorted(messages[-len(part) :]) or caught
            assert len(messages) == bag.message_count or caught or name.endswith(".mcap")
            frames(bag)
            for topic in bag.topics.values():
                if topic.serialization_format == "cdr":
                    class_of(path, topic)
        except BagError as error:
            return _refused(error, is_clear=error.path == str(path))
        assert all(str(path) in str(warning.message) for warning in caught)
    return bool(messages)


def cmake(data: bytes) -> bool:
    """Read a CMakeLists.txt."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "CMakeLists.txt"
        path.write_bytes(data)
        try:
            read_plan(path.parent, path.parent / "install")
        except CMakeSyntaxError as error:
            return _refused(error, is_clear=str(error).startswith(f"{path}:"))
    return True


def recorded_definitions(data: bytes) -> bool:
    """Make the class of a type that a recording defines; the first octet selects the form."""
    if not data:
        return False
    encoding = ("ros2msg", "ros2idl")[data[0] % 2]
    before = sources._defined.copy()
    try:
        made = recorded_class("fuzz_msgs/msg/Fuzz", encoding, data[1:].decode("utf-8", "replace"))
        cdr.decode(made, cdr.encode(made()))
    except described.DescriptionError as error:
        return _refused(error, is_clear="fuzz_msgs/msg/Fuzz" in str(error))
    finally:
        for name in sources._defined.keys() - before.keys():
            sources.replace(name, None)
            class_table.forget(name)
    return True


def urdf(data: bytes) -> bool:
    """Read a robot's description, and compute where its links are."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of what can be read, and is not as it should be
            model = RobotModel.from_urdf(b"<" + data.lstrip()[1:])
    except UrdfError as error:
        return _refused(error, is_clear=error.line >= 1 and bool(error.reason.strip()))
    poses = model.forward([0.0] * len(model.variables))
    assert poses.shape == (len(model.links), 7)
    RobotTransforms(model.description)
    return True


def joint_states(data: bytes) -> bool:
    """Convert the states of an arm's joints to transforms."""
    try:
        message = _arm().convert(data, 10**18, None)
    except ValueError as error:
        return _refused(error, is_clear=str(error).startswith("JointState: byte "))
    if message is not None:
        for transform in cdr.decode(TFMessage, message).transforms:
            turn = transform.transform.rotation
            assert abs(turn.x**2 + turn.y**2 + turn.z**2 + turn.w**2 - 1) < 1e-6
    return True


@lru_cache(maxsize=1)
def _arm() -> StateTransforms:
    path = Path(__file__).parents[1] / "golden" / "arm.urdf"
    return RobotTransforms(parse_urdf(path.read_bytes())).states


TARGETS: dict[str, Callable[[bytes], bool]] = {
    "cdr": cdr_bytes,
    "cmake": cmake,
    "definitions": definitions,
    "descriptions": descriptions,
    "graph": graph,
    "idl": idl,
    "joint_states": joint_states,
    "urdf": urdf,
    "mcap": mcap,
    "ros1": ros1,
    "recorded_definitions": recorded_definitions,
    "yaml": yaml,
}

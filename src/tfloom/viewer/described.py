"""The viewer of a robot's description, a file, without a graph."""

from __future__ import annotations

import re
import tempfile
import time
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple

from tfloom.common.files import open_regular, read_at_most
from tfloom.interfaces.std_msgs.msg import String
from tfloom.robot.mended_xml import decoded
from tfloom.robot.model import RobotModel
from tfloom.robot.urdf import parse_urdf
from tfloom.robot.urdf_faults import Remarks, UrdfError
from tfloom.robot.xacro_program import main as expand_xacro
from tfloom.rosidl import cdr
from tfloom.tf2.buffer import Buffer
from tfloom.tf2_tools.static_file import encoded
from tfloom.tf2_tools.static_transform import StaticTransform
from tfloom.tf2_tools.watch.recorded import observe_recorded
from tfloom.tf2_tools.watch.sources import Still
from tfloom.viewer.joints import AUTHORITY, DescribedJoints
from tfloom.viewer.layout.layout import Layout
from tfloom.viewer.program import Viewer
from tfloom.viewer.shapes import DisplayError
from tfloom.viewer.topic_log import Cursor, TopicLog
from tfloom.workspace.ament import PackageNotFoundError
from tfloom.workspace.resource_retriever import PACKAGE_PREFIX, get_filename

__all__ = [
    "DESCRIPTION_TOPIC",
    "DescriptionError",
    "RobotFile",
    "described_viewer",
    "read_robot",
    "robot_layout",
]

MAX_BYTES = 64 * 1024 * 1024
"""Size of the largest file [bytes]."""
XACRO_ELEMENT = b"<xacro:"
HINT = "; arguments of xacro follow the file, as NAME:=VALUE"
DECLARED = "; it has {names}"
ARGUMENT = re.compile(rb"""<xacro:arg\s[^>]*?\bname\s*=\s*["'](\w+)["']""")
MAX_NAMES = 12
"""Number of arguments that are named."""
DESCRIPTION_TOPIC = "/robot_description"
MIN_AXES_M = 0.01
AXES_PER_EXTENT = 0.06
"""Length of the axes of frames, for each meter of the robot."""


class DescriptionError(Exception):
    """A file is not a robot's description; the text has the file and the reason."""


class RobotFile(NamedTuple):
    """A robot's description from a file."""

    text: str
    model: RobotModel
    folder: Path
    """Where the file is: its meshes are looked for around it."""


def read_robot(name: str, arguments: Sequence[str] = ()) -> RobotFile:
    """Read a robot's description; one of xacro, also in a file that ends in .urdf, is expanded.

    Args:
        name: A path, or `package://PACKAGE/PATH`.
        arguments: Those of xacro, each `NAME:=VALUE`.

    Raises:
        DescriptionError: it can't be read, or is not valid.
    """
    try:
        path = Path(get_filename(name, use_protocol=False) if name.startswith(PACKAGE_PREFIX) else name)
        with open_regular(path) as file:
            content = read_at_most(file, MAX_BYTES)
        if content is None:
            raise DescriptionError(f"{name} has more than {MAX_BYTES} bytes")
        is_xacro = path.suffix.lower() == ".xacro"
        if is_xacro or (XACRO_ELEMENT in content and find_spec("xacro") is not None):
            content = _expanded(path, arguments)
        elif arguments:
            raise DescriptionError(f"{name} is not a file of xacro: it takes no argument, as {arguments[0]}")
        text = decoded(content, Remarks())
        return RobotFile(text, RobotModel(parse_urdf(text)), path.absolute().parent)
    except UrdfError as error:
        raise DescriptionError(f"{name}: {error}") from None
    except PackageNotFoundError as error:
        raise DescriptionError(f"{name}: there is no package {error}: source its workspace before") from None
    except (OSError, ValueError) as error:
        raise DescriptionError(f"{name} can't be read: {getattr(error, 'strerror', None) or error}") from None


def _expanded(path: Path, arguments: Sequence[str]) -> bytes:
    """Return the URDF of a file of xacro.

    Raises:
        DescriptionError: it can't be expanded; the library has printed why.
    """
    with tempfile.TemporaryDirectory(prefix="tfloom_view_") as folder:
        out = Path(folder, "robot.urdf")
        try:
            code = expand_xacro([str(path), *arguments, "-o", str(out)], path.absolute().parent)
        except SystemExit as end:
            code = 1 if end.code is None else int(end.code)
        if code:
            raise DescriptionError(f"{path} can't be expanded: the reason is above{_hint(path, arguments)}")
        return out.read_bytes()


def _hint(path: Path, arguments: Sequence[str]) -> str:
    """Return what helps where a file of xacro can't be expanded: that it takes arguments, and those it declares."""
    given = {word.partition(":=")[0] for word in arguments}
    with open_regular(path) as file:
        declared = ARGUMENT.findall(read_at_most(file, MAX_BYTES) or b"")
    names = [name for name in dict.fromkeys(name.decode() for name in declared) if name not in given]
    if not names:
        return "" if arguments else HINT
    shown = ", ".join(names[:MAX_NAMES]) + (" and others" if len(names) > MAX_NAMES else "")
    return HINT + DECLARED.format(names=shown)


class DescribedTopics:
    """The one topic of a description that nobody publishes.

    Args:
        text: The description.
    """

    def __init__(self, text: str) -> None:
        self._log = TopicLog(0, lambda data: cdr.decode(String, data))
        self._log.add(time.time_ns(), cdr.encode(String(data=text)))

    def types(self) -> Mapping[str, str]:
        """Return the type of each topic, by its name."""
        return {DESCRIPTION_TOPIC: "std_msgs/msg/String"}

    def open(self, topic: str, depth: int = 0) -> Cursor:  # nothing waits here
        """Return a reader of the topic."""
        return self._log.open()

    def message_class(self, topic: str) -> type[String]:
        """Return the class of the topic's message.

        Raises:
            DisplayError: it is another topic.
        """
        if topic != DESCRIPTION_TOPIC:
            raise DisplayError(f"there is no topic {topic}")
        return String

    def silence(self, topic: str, type_name: str) -> str:
        """Return an empty text: nothing keeps a description away."""
        return ""

    def poll(self) -> None:
        """Do nothing: the description is there."""

    def begin_anew(self) -> None:
        """Do nothing: a description holds at all times."""


@contextmanager
def described_viewer(robot: RobotFile, *, fixed_frame: str = "") -> Iterator[Viewer]:
    """Open a viewer of a robot, whose joints pages move, for the block.

    Args:
        robot: The robot.
        fixed_frame: The fixed frame; empty: the robot's root.
    """
    buffer = Buffer(None)
    buffer.set_log_callback(None)
    joints = DescribedJoints(robot.model, buffer)
    now_ns = time.time_ns()
    message = "/tf_static", now_ns, encoded(_statics(buffer), now_ns)
    source = Still(observe_recorded([message], AUTHORITY), buffer)
    root = robot.model.description.root
    with Viewer(
        source, DescribedTopics(robot.text), fixed_frame=fixed_frame or root, joints=joints
    ) as viewer:
        viewer.view.near = robot.folder
        viewer.apply(robot_layout(robot, fixed_frame or root))
        yield viewer


def robot_layout(robot: RobotFile, fixed_frame: str) -> Layout:
    """Return how a robot is shown from the start: its frames small, so that they don't hide it, and without names."""
    poses = robot.model.forward([0.0] * len(robot.model.variables))[:, :3]
    size_m = float((poses.max(axis=0) - poses.min(axis=0)).max())
    return Layout(fixed_frame, with_names=False, axes_m=min(max(AXES_PER_EXTENT * size_m, MIN_AXES_M), 0.3))


def _statics(buffer: Buffer) -> list[StaticTransform]:
    statics = []
    for edge in buffer.edges():
        frames = edge.frame_id, edge.child_frame_id
        transform = buffer.lookup(*frames).transform
        statics.append(StaticTransform(*frames, transform.translation, transform.rotation_xyzw))
    return statics

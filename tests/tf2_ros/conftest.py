"""A node's buffer, broadcaster, executor and simulated time on the in-process wire; and messages."""

from __future__ import annotations

from collections.abc import Callable, Iterator

import pytest

from tfloom.interfaces.builtin_interfaces.msg import Time as TimeMessage
from tfloom.interfaces.geometry_msgs.msg import Quaternion, Transform, TransformStamped, Vector3
from tfloom.interfaces.sensor_msgs.msg import PointField
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.values.time import Time
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster
from tfloom.tf2_ros.transform_listener import TransformListener

SECOND = 1_000_000_000


def transform_stamped(
    frame_id: str,
    child_frame_id: str,
    stamp_ns: int,
    xyz: tuple[float, ...] = (1.0, 2.0, 3.0),
    xyzw: tuple[float, ...] = (0.0, 0.0, 0.0, 1.0),
) -> TransformStamped:
    sec, nanosec = divmod(stamp_ns, SECOND)
    return TransformStamped(
        header=Header(stamp=TimeMessage(sec=sec, nanosec=nanosec), frame_id=frame_id),
        child_frame_id=child_frame_id,
        transform=Transform(
            translation=Vector3(x=xyz[0], y=xyz[1], z=xyz[2]),
            rotation=Quaternion(x=xyzw[0], y=xyzw[1], z=xyzw[2], w=xyzw[3]),
        ),
    )


def field(name: str, offset: int = 0, datatype: int = PointField.FLOAT32, count: int = 1) -> PointField:
    return PointField(name=name, offset=offset, datatype=datatype, count=count)


@pytest.fixture
def buffer(node: Node) -> Buffer:
    """Return a buffer that a listener of `node` fills."""
    buffer = Buffer()
    TransformListener(buffer, node)
    return buffer


@pytest.fixture
def broadcaster(node: Node) -> TransformBroadcaster:
    return TransformBroadcaster(node)


@pytest.fixture
def executor(node: Node) -> Iterator[SingleThreadedExecutor]:
    """Return an executor that has `node`."""
    with SingleThreadedExecutor(context=node.context) as executor:
        executor.add_node(node)
        yield executor


@pytest.fixture
def set_time(node: Node) -> Callable[[float], None]:
    """Return a function that sets the time of `node` [s], which is simulated from the first call on."""
    clock = node.get_clock()

    def set_to(seconds: float) -> None:
        clock.set_ros_time_is_active(True)
        clock.set_ros_time_override(Time(seconds=seconds, clock_type=clock.clock_type))

    return set_to

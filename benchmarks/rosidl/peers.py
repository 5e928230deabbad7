"""TFMessage with n transforms, encoded and decoded by tfloom, rosbags and cyclonedds' IdlStruct."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from rosbags.typesys import Stores, get_typestore

from benchmarks.node.cyclone_types import TFMessage as IdlTFMessage
from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.geometry_msgs.msg import Quaternion, Transform, TransformStamped, Vector3
from tfloom.interfaces.std_msgs.msg import Header
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.rosidl import cdr


class Peer(NamedTuple):
    """What is timed: both take nothing and give something."""

    name: str
    encode: Callable[[], Any]
    decode: Callable[[], Any]


def tfloom_message(count: int) -> TFMessage:
    return TFMessage(
        transforms=[
            TransformStamped(
                header=Header(stamp=Time(sec=1_700_000_000 + i, nanosec=123_456_789), frame_id="world"),
                child_frame_id=f"turtle{i}",
                transform=Transform(
                    translation=Vector3(x=1.5 * i, y=2.0, z=0.25), rotation=Quaternion(z=0.6, w=0.8)
                ),
            )
            for i in range(count)
        ]
    )


def tfloom_peer(count: int) -> Peer:
    message = tfloom_message(count)
    data = cdr.encode(message)
    return Peer("tfloom", lambda: cdr.encode(message), lambda: cdr.decode(TFMessage, data))


def rosbags_peer(count: int) -> Peer:
    store = get_typestore(Stores.ROS2_JAZZY)
    data = cdr.encode(tfloom_message(count))
    name = "tf2_msgs/msg/TFMessage"
    message = store.deserialize_cdr(data, name)
    return Peer(
        "rosbags", lambda: store.serialize_cdr(message, name), lambda: store.deserialize_cdr(data, name)
    )


def cyclonedds_peer(count: int) -> Peer:
    data = cdr.encode(tfloom_message(count))
    message = IdlTFMessage.deserialize(data)
    return Peer("cyclonedds IdlStruct", message.serialize, lambda: IdlTFMessage.deserialize(data))


PEERS = (tfloom_peer, rosbags_peer, cyclonedds_peer)

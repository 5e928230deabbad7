"""The tutorials' nodes, in this process, without a network."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator

import pytest
from tests import spun

from tfloom.demos.turtle_tf2_py import static_turtle_tf2_broadcaster
from tfloom.demos.turtle_tf2_py.dynamic_frame_tf2_broadcaster import DynamicFrameBroadcaster
from tfloom.demos.turtle_tf2_py.fixed_frame_tf2_broadcaster import FixedFrameBroadcaster
from tfloom.demos.turtle_tf2_py.static_turtle_tf2_broadcaster import StaticFramePublisher
from tfloom.demos.turtle_tf2_py.turtle_tf2_broadcaster import FramePublisher
from tfloom.demos.turtle_tf2_py.turtle_tf2_message_broadcaster import PointPublisher
from tfloom.interfaces.geometry_msgs.msg import PointStamped, TransformStamped
from tfloom.interfaces.tf2_msgs.msg import TFMessage
from tfloom.interfaces.turtlesim.msg import Pose
from tfloom.node.node import Node
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile


class Stage(spun.Stage):
    """A demo's node, and a node that receives its messages."""

    def __init__(self, make: Callable[[], Node], *args: str) -> None:
        super().__init__(args)
        self.transforms: list[TransformStamped] = []
        kept = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.ear = Node("ear")
        self.ear.create_subscription(TFMessage, "/tf", self._hear, 10)
        self.ear.create_subscription(TFMessage, "/tf_static", self._hear, kept)
        self.add(make())
        self.add(self.ear)

    def _hear(self, message: TFMessage) -> None:
        self.transforms += message.transforms

    def first(self) -> TransformStamped:
        self.spin_until(lambda: self.transforms, turns=500)
        return self.transforms[0]


@pytest.fixture
def start() -> Iterator[Callable[..., Stage]]:
    with spun.staging(Stage) as start:
        yield start


def ends(transform: TransformStamped) -> tuple[str, str]:
    return transform.header.frame_id, transform.child_frame_id


def where(transform: TransformStamped) -> tuple[float, float, float]:
    translation = transform.transform.translation
    return translation.x, translation.y, translation.z


def turn(transform: TransformStamped) -> tuple[float, float, float, float]:
    rotation = transform.transform.rotation
    return rotation.x, rotation.y, rotation.z, rotation.w


def test_pose_of_a_turtle_becomes_a_transform(start: Callable[..., Stage]) -> None:
    stage = start(FramePublisher, "-p", "turtlename:=turtle2")
    stage.ear.create_publisher(Pose, "/turtle2/pose", 1).publish(Pose(x=1.0, y=2.0, theta=math.pi / 2))
    transform = stage.first()
    assert ends(transform) == ("world", "turtle2")
    assert where(transform) == (1.0, 2.0, 0.0)
    assert turn(transform) == pytest.approx((0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5)))
    assert transform.header.stamp.sec > 0


@pytest.mark.parametrize("pose", [Pose(x=math.nan), Pose(y=math.inf), Pose(theta=math.inf)])
def test_a_pose_that_is_no_number_is_not_broadcast(start: Callable[..., Stage], pose: Pose) -> None:
    stage = start(FramePublisher)
    turtle = stage.ear.create_publisher(Pose, "/turtle1/pose", 1)
    turtle.publish(pose)
    for _ in range(3):  # its subscription, and a turn of each node
        stage.executor.spin_once(timeout_sec=0.05)
    turtle.publish(Pose(x=1.0))
    assert where(stage.first()) == (1.0, 0.0, 0.0)


def test_fixed_frame_is_beside_the_turtle(start: Callable[..., Stage]) -> None:
    transform = start(FixedFrameBroadcaster).first()
    assert ends(transform) == ("turtle1", "carrot1")
    assert where(transform) == (0.0, 2.0, 0.0)
    assert turn(transform) == (0.0, 0.0, 0.0, 1.0)


def test_dynamic_frame_circles_the_turtle(start: Callable[..., Stage]) -> None:
    transform = start(DynamicFrameBroadcaster).first()
    assert ends(transform) == ("turtle1", "carrot1")
    side = 10.0 if transform.header.stamp.sec % 2 == 0 else -10.0
    assert where(transform) == pytest.approx((0.0, side, 0.0), abs=1e-4)


def test_static_frame_is_broadcast(start: Callable[..., Stage]) -> None:
    transform = start(lambda: StaticFramePublisher("shelf", [1.0, 2.0, 3.0, 0.0, 0.0, math.pi])).first()
    assert ends(transform) == ("world", "shelf")
    assert where(transform) == (1.0, 2.0, 3.0)
    assert turn(transform) == pytest.approx((0.0, 0.0, 1.0, 0.0))


@pytest.mark.parametrize(
    ("words", "code"),
    [([], 1), (["world", *"123456"], 2), (["shelf", *"12345"], 1), (["shelf", *"12345", "far"], 1)],
)
def test_invalid_static_frame_is_rejected(
    words: list[str], code: int, capsys: pytest.CaptureFixture[str]
) -> None:
    assert static_turtle_tf2_broadcaster.main(words) == code
    assert capsys.readouterr().err


def test_pose_of_a_turtle_becomes_a_point(start: Callable[..., Stage]) -> None:
    stage = start(PointPublisher)
    points: list[PointStamped] = []
    stage.ear.create_subscription(PointStamped, "/turtle3/turtle_point_stamped", points.append, 1)
    stage.ear.create_publisher(Pose, "/turtle3/pose", 1).publish(Pose(x=1.5, y=2.5))
    stage.spin_until(lambda: points, turns=500)
    assert points[0].header.frame_id == "world"
    assert (points[0].point.x, points[0].point.y, points[0].point.z) == (1.5, 2.5, 0.0)

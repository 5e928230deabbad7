"""A node as in rclpy programs."""

import rclpy
from geometry_msgs.msg import TransformStamped, Twist, Vector3
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.time import Time
from tf2_ros import (
    Buffer,
    StaticTransformBroadcaster,
    TransformBroadcaster,
    TransformException,
    TransformListener,
)
from turtlesim.msg import Pose


class Broadcaster(Node):
    """Broadcasts a pose as a transform."""

    def __init__(self) -> None:
        super().__init__("broadcaster")
        self.declare_parameter("child", "turtle1")
        self.child: str = self.get_parameter("child").value
        self.latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.publisher = self.create_publisher(Twist, "cmd_vel", 10)
        self.subscription = self.create_subscription(Pose, "pose", self.on_pose, self.latched)
        self.timer = self.create_timer(0.1, self.on_timer)
        self.broadcaster = TransformBroadcaster(self)
        self.static_broadcaster = StaticTransformBroadcaster(self)
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)

    def on_pose(self, message: Pose) -> None:
        """Send the transform."""
        transform = TransformStamped(child_frame_id=self.child)
        transform.header.stamp = self.get_clock().now().to_msg()
        transform.transform.translation = Vector3(x=message.x, y=message.y)
        self.broadcaster.sendTransform(transform)
        self.static_broadcaster.sendTransform([transform])

    def on_timer(self) -> None:
        """Look up the pose of the turtle."""
        try:
            found = self.buffer.lookup_transform("world", self.child, Time(), timeout=Duration(seconds=1.0))
        except TransformException as error:
            self.get_logger().warning(str(error))
            return
        distance: float = found.transform.translation.x
        self.publisher.publish(Twist(linear=Vector3(x=distance)))


def main(args: list[str] | None = None) -> None:
    """Run the node."""
    rclpy.init(args=args)
    try:
        rclpy.spin(Broadcaster())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()

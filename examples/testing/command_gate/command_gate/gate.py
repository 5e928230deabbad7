"""A node between a planner and a motor driver: it passes commands on while that is safe."""

import rclpy
import tf2_geometry_msgs  # noqa: F401, registers PointStamped
from geometry_msgs.msg import PointStamped, Twist
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from tf2_ros import Buffer, TransformException, TransformListener

LONGEST_SILENCE = Duration(seconds=0.5)


def distance_ahead(buffer, point):
    """Return how far ahead of the robot a point is [m], or None if it is behind or beside it."""
    in_base = buffer.transform(point, "base_link").point
    return in_base.x if in_base.x > 0 and abs(in_base.y) < 0.3 else None


class Gate(Node):
    """Passes /plan on to /cmd_vel, and stops if /obstacle is near or /plan is silent."""

    def __init__(self):
        super().__init__("gate")
        self.clearance = self.declare_parameter("clearance", 0.5).value
        self.buffer = Buffer(node=self)
        self.listener = TransformListener(self.buffer, self)
        self.is_blocked = False
        self.last_plan = None
        self.commands = self.create_publisher(Twist, "cmd_vel", 10)
        self.create_subscription(Twist, "plan", self.on_plan, 10)
        self.create_subscription(PointStamped, "obstacle", self.on_obstacle, 10)
        self.create_timer(0.1, self.watch)

    def on_plan(self, plan):
        self.last_plan = self.get_clock().now()
        self.commands.publish(Twist() if self.is_blocked else plan)

    def on_obstacle(self, point):
        try:
            distance = distance_ahead(self.buffer, point)
        except TransformException as error:
            self.get_logger().warning(f"ignored an obstacle: {error}")
            return
        self.is_blocked = distance is not None and distance < self.clearance
        if self.is_blocked:
            self.commands.publish(Twist())

    def watch(self):
        if self.last_plan is not None and self.get_clock().now() - self.last_plan > LONGEST_SILENCE:
            self.last_plan = None
            self.commands.publish(Twist())


def main(args=None):
    try:
        with rclpy.init(args=args):
            rclpy.spin(Gate())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass


if __name__ == "__main__":
    main()

"""Print the distance of the robot's true pose from that by its odometry, and by the corrected odometry."""

from __future__ import annotations

import math

import rclpy
from nav_msgs.msg import Odometry
from planar import Pose2D, of_pose, of_transform
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, TransformException, TransformListener


class PoseErrors(Node):
    """Compares /ground_truth, which a simulation has, with the frames; `period` is the time between lines [s]."""

    def __init__(self) -> None:
        super().__init__("pose_errors")
        self.prefix = str(self.declare_parameter("frame_prefix", "").value)
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.truth: Odometry | None = None
        self.before: Pose2D | None = None
        self.way = 0.0
        self.create_subscription(Odometry, "ground_truth", self.on_truth, 10)
        self.create_timer(float(self.declare_parameter("period", 5.0).value), self.on_timer)

    def on_truth(self, message: Odometry) -> None:
        pose = of_pose(message.pose.pose)
        if self.before is not None:
            self.way += math.hypot(pose.x - self.before.x, pose.y - self.before.y)
        self.before, self.truth = pose, message

    def on_timer(self) -> None:
        if self.truth is None:
            return
        by_odometry = self.find_error("odom")
        corrected = self.find_error("map")
        if by_odometry is not None:
            text = "not known" if corrected is None else f"off by {corrected:.2f} m"
            self.get_logger().info(
                f"After {self.way:.1f} m: odometry is off by {by_odometry:.2f} m, the corrected pose {text}"
            )

    def find_error(self, frame: str) -> float | None:
        """Return how far the pose in a frame is from the truth [m]; the odometry begins where the map does."""
        if self.truth is None:
            return None
        stamp = Time.from_msg(self.truth.header.stamp, self.get_clock().clock_type)
        names = self.prefix + frame, self.prefix + "base_link"
        try:
            found = self.buffer.lookup_transform(*names, stamp)
        except TransformException:
            # The correction of this very time isn't there yet: compare the newest that is.
            try:
                found = self.buffer.lookup_transform(*names, Time())
            except TransformException:
                return None
        pose, truth = of_transform(found.transform), of_pose(self.truth.pose.pose)
        return math.hypot(pose.x - truth.x, pose.y - truth.y)


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    try:
        rclpy.spin(PoseErrors())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()

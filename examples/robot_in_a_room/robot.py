"""Simulate a robot in a room: it obeys /cmd_vel, and publishes drifting odometry, scans and joint states."""

from __future__ import annotations

import math

import numpy as np
import rclpy
from differential_drive import DifferentialDrive
from geometry_msgs.msg import Twist
from nav_msgs.msg import Odometry
from planar import Pose2D, fill_pose, transform_message
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import qos_profile_sensor_data
from rclpy.time import Time
from room import Room
from sensor_msgs.msg import JointState, LaserScan
from tf2_ros import TransformBroadcaster

RATE_HZ = 30.0
STEPS_PER_SCAN = 5
COMMAND_TIMEOUT_S = 0.6
"""Time without a command after which the robot stops."""
MAX_GAP_S = 0.5
"""Longest time that is simulated in one step, as after a time in which this process didn't run."""
BASE_FROM_LASER = Pose2D(0.12, 0.0, 0.0)
"""As in robot.urdf."""
RAYS = 360
MIN_RANGE_M, MAX_RANGE_M = 0.1, 8.0
RANGE_NOISE_M = 0.01
ARM = {"arm_turn": (0.0, 1.2, 0.5), "arm_lift": (0.6, 0.5, 0.8), "arm_bend": (1.2, 0.6, 1.1)}
"""How the joints of the arm swing: middle [rad], amplitude [rad], angular frequency [rad/s]."""


class Robot(Node):
    """The simulation; `laser` switches the laser off and on, and `frame_prefix` is for a second robot."""

    def __init__(self) -> None:
        super().__init__("robot")
        seed = int(self.declare_parameter("seed", 1).value)
        self.prefix = str(self.declare_parameter("frame_prefix", "").value)
        self.declare_parameter("laser", True)
        self.drive = DifferentialDrive(Room(), seed=seed)
        self.random = np.random.default_rng(seed)
        self.angles = np.linspace(-math.pi, math.pi, RAYS, endpoint=False)
        self.broadcaster = TransformBroadcaster(self)
        self.odometry = self.create_publisher(Odometry, "odom", 10)
        self.truth = self.create_publisher(Odometry, "ground_truth", 10)
        self.joints = self.create_publisher(JointState, "joint_states", 10)
        self.scans = self.create_publisher(LaserScan, "scan", qos_profile_sensor_data)
        self.create_subscription(Twist, "cmd_vel", self.on_command, 10)
        self.last = self.commanded = self.started = self.get_clock().now()
        self.steps = 0
        self.was_blocked, self.was_alone = False, True
        self.create_timer(1.0 / RATE_HZ, self.on_timer)
        self.create_timer(1.0, self.on_second)

    def on_command(self, message: Twist) -> None:
        try:
            self.drive.drive(message.linear.x, message.angular.z)
        except ValueError as error:
            self.get_logger().error(f"A command is ignored: {error}", throttle_duration_sec=1.0)
            return
        self.commanded = self.get_clock().now()

    def on_timer(self) -> None:
        now = self.get_clock().now()
        seconds = (now - self.last).nanoseconds / 1e9
        self.last = now
        if seconds < 0.0:
            self.get_logger().warn(f"The time jumped back by {-seconds:.1f} s; the robot stays where it is")
            self.commanded = now
        if seconds <= 0.0:
            return
        if (now - self.commanded).nanoseconds > COMMAND_TIMEOUT_S * 1e9:
            self.drive.drive(0.0, 0.0)
        self.drive.step(min(seconds, MAX_GAP_S))
        if self.drive.is_blocked and not self.was_blocked:
            self.get_logger().warn("The robot stands against something, and its wheels slip")
        self.was_blocked = self.drive.is_blocked
        self.publish_state(now)
        self.steps += 1
        if self.steps % STEPS_PER_SCAN == 0 and self.get_parameter("laser").value:
            self.scans.publish(self.scan(now))

    def on_second(self) -> None:
        """Log an error if another robot uses the same names, because their transforms would contradict each other."""
        is_alone = self.count_publishers("odom") <= 1
        if self.was_alone and not is_alone:
            self.get_logger().error(
                f"Another node publishes {self.odometry.topic_name}, too: start a second robot under "
                "another name, as by `room.launch.py name:=second`"
            )
        self.was_alone = is_alone

    def publish_state(self, now: Time) -> None:
        drive, stamp = self.drive, now.to_msg()
        for publisher, frame, pose in (
            (self.odometry, "odom", drive.odometry),
            (self.truth, "map", drive.truth),
        ):
            message = Odometry(child_frame_id=self.prefix + "base_link")
            message.header.stamp, message.header.frame_id = stamp, self.prefix + frame
            fill_pose(message.pose.pose, pose)
            message.twist.twist.linear.x, message.twist.twist.angular.z = drive.speed
            publisher.publish(message)
        self.broadcaster.sendTransform(
            transform_message(self.prefix + "odom", self.prefix + "base_link", stamp, drive.odometry)
        )
        seconds = (now - self.started).nanoseconds / 1e9
        states = JointState(name=["left_wheel_joint", "right_wheel_joint", *ARM])
        states.header.stamp = stamp
        arm = [middle + swing * math.sin(seconds * speed) for middle, swing, speed in ARM.values()]
        states.position = [*drive.wheels.tolist(), *arm]
        self.joints.publish(states)

    def scan(self, now: Time) -> LaserScan:
        laser = self.drive.truth @ BASE_FROM_LASER
        ranges = self.drive.room.ranges((laser.x, laser.y), self.angles + laser.yaw)
        ranges += self.random.normal(0.0, RANGE_NOISE_M, RAYS)
        ranges[(ranges < MIN_RANGE_M) | (ranges > MAX_RANGE_M)] = math.inf
        message = LaserScan(
            angle_min=-math.pi,
            angle_max=math.pi - math.tau / RAYS,
            angle_increment=math.tau / RAYS,
            scan_time=STEPS_PER_SCAN / RATE_HZ,
            range_min=MIN_RANGE_M,
            range_max=MAX_RANGE_M,
        )
        message.header.stamp, message.header.frame_id = now.to_msg(), self.prefix + "laser"
        message.ranges = ranges.astype(np.float32).tolist()
        return message


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    try:
        rclpy.spin(Robot())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()

"""Drive the robot round its room by /cmd_vel, from place to place; other publishers of /cmd_vel take precedence."""

from __future__ import annotations

import math
from collections import deque

import rclpy
from geometry_msgs.msg import Twist
from planar import Pose2D, of_transform
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.time import Time
from tf2_ros import Buffer, TransformException, TransformListener

PLACES = (
    *((1.0, -0.6), (3.0, -1.5), (5.8, -1.4), (6.2, 0.8), (6.0, 3.0), (4.2, 3.4), (3.0, 2.4)),
    *((3.0, 0.7), (1.2, 0.6), (1.1, 3.4), (-1.2, 3.6), (-2.2, 1.4), (-1.2, -1.2), (0.0, 0.0)),
)
"""A round of the room, in `map` [m]."""
RATE_HZ = 10.0
NEAR_M = 0.25
TURN_RAD_S = 1.2
OTHERS_S = 3.0
"""How long the tour waits after the last command of another publisher."""
OLD_S = 1.0
"""Age of the robot's pose above which the robot stands."""
STUCK_S, STUCK_M = 4.0, 0.15
"""A robot that has moved less than this way in this time is stuck."""
BACK_S = 1.5


class Tour(Node):
    """The driver; `laps` is the number of rounds, without end if 0."""

    def __init__(self) -> None:
        super().__init__("tour")
        prefix = str(self.declare_parameter("frame_prefix", "").value)
        self.map_frame, self.base_frame = prefix + "map", prefix + "base_link"
        self.speed = float(self.declare_parameter("speed", 0.5).value)
        self.laps = int(self.declare_parameter("laps", 0).value)
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.publisher = self.create_publisher(Twist, "cmd_vel", 10)
        self.create_subscription(Twist, "cmd_vel", self.on_command, 10)
        self.sent: deque[tuple[float, float]] = deque(maxlen=20)
        """The last commands of this node, which its own subscription receives, too."""
        self.paused_until: Time | None = None
        self.place = 0
        self.lap = 0
        self.is_lost = False
        self.checked: tuple[Time, Pose2D] | None = None
        self.back_until: Time | None = None
        self.create_timer(1.0 / RATE_HZ, self.on_timer)

    @property
    def is_over(self) -> bool:
        return 0 < self.laps <= self.lap

    def on_command(self, message: Twist) -> None:
        if (message.linear.x, message.angular.z) in self.sent:
            return
        now = self.get_clock().now()
        if self.paused_until is None:
            self.get_logger().info("Someone else drives: the tour waits")
        self.paused_until = Time(nanoseconds=now.nanoseconds + int(OTHERS_S * 1e9), clock_type=now.clock_type)
        self.checked = None

    def on_timer(self) -> None:
        now = self.get_clock().now()
        if self.is_over or self.is_paused(now):
            return
        pose = self.find_pose(now)
        if pose is None:
            self.send(0.0, 0.0)
        elif self.back_until is not None and now < self.back_until:
            self.send(-self.speed / 2.0, 0.0)
        else:
            self.back_until = None
            self.drive(now, pose)

    def is_paused(self, now: Time) -> bool:
        if self.paused_until is None:
            return False
        # A pause that lies far ahead is from before a jump back of the time.
        if 0 < (self.paused_until - now).nanoseconds <= OTHERS_S * 1e9:
            return True
        self.paused_until = None
        self.get_logger().info("The tour goes on")
        return False

    def find_pose(self, now: Time) -> Pose2D | None:
        """Return the robot's pose in the map; None if it is unknown, or too old."""
        try:
            found = self.buffer.lookup_transform(self.map_frame, self.base_frame, Time())
            age_s = (now - Time.from_msg(found.header.stamp, now.clock_type)).nanoseconds / 1e9
            pose, problem = of_transform(found.transform), ""
            if abs(age_s) >= OLD_S:
                problem = f"its pose is {age_s:.1f} s old"
        except TransformException as error:
            pose, problem = None, str(error)
        if problem and not self.is_lost:
            self.get_logger().warn(f"The robot stands and waits: {problem}")
        elif self.is_lost and not problem:
            self.get_logger().info("The robot's pose is known: it drives on")
        self.is_lost = bool(problem)
        if problem:
            self.checked = None
            return None
        return pose

    def drive(self, now: Time, pose: Pose2D) -> None:
        """Drive to the next place: first turn, then ahead, slower where it has to turn."""
        x, y = PLACES[self.place]
        if math.hypot(x - pose.x, y - pose.y) < NEAR_M:
            self.next_place()
            if self.is_over:
                self.send(0.0, 0.0)
                return
            x, y = PLACES[self.place]
        if self.is_stuck(now, pose):
            self.get_logger().warn(f"Stuck at {pose.x:.2f}, {pose.y:.2f}: back, and to the next place")
            self.back_until = Time(nanoseconds=now.nanoseconds + int(BACK_S * 1e9), clock_type=now.clock_type)
            self.next_place()
            return
        off = math.remainder(math.atan2(y - pose.y, x - pose.x) - pose.yaw, math.tau)
        ahead = self.speed * max(0.0, math.cos(off)) ** 3
        self.send(ahead, max(-TURN_RAD_S, min(2.0 * off, TURN_RAD_S)))

    def next_place(self) -> None:
        self.place = (self.place + 1) % len(PLACES)
        if self.place == 0:
            self.lap += 1
            self.get_logger().info(f"Round {self.lap} is complete")

    def is_stuck(self, now: Time, pose: Pose2D) -> bool:
        if self.checked is None or now < self.checked[0]:
            self.checked = now, pose
            return False
        since, before = self.checked
        if math.hypot(pose.x - before.x, pose.y - before.y) > STUCK_M or abs(pose.yaw - before.yaw) > 0.5:
            self.checked = now, pose
            return False
        if (now - since).nanoseconds < STUCK_S * 1e9:
            return False
        self.checked = None
        return True

    def send(self, linear: float, angular: float) -> None:
        message = Twist()
        message.linear.x, message.angular.z = linear, angular
        self.sent.append((linear, angular))
        self.publisher.publish(message)


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    try:
        tour = Tour()
        while not tour.is_over:
            rclpy.spin_once(tour, timeout_sec=0.5)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()

"""Map a room: match each scan with the map so far, correct `map` → `odom` by it, and publish /map."""

from __future__ import annotations

import math

import numpy as np
import rclpy
from geometry_msgs.msg import PoseWithCovarianceStamped
from matching import NEAR, WIDE, Match, match
from nav_msgs.msg import OccupancyGrid
from occupancy import RESOLUTION_M, GridError, OccupancyMap
from planar import Pose2D, of_pose, of_transform, transform_message, turned
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile, qos_profile_sensor_data
from rclpy.time import Time
from sensor_msgs.msg import LaserScan
from tf2_ros import Buffer, TransformBroadcaster, TransformException, TransformListener

RATE_HZ = 20.0
MAP_PERIOD_S = 1.0
SILENCE_S = 2.0
"""A laser that sends no scan for this time is reported."""
MIN_MOVE_M, MIN_TURN_RAD = 0.1, 0.08
"""How far the laser has to move or turn after a scan until the next one is used."""
LOST_SCANS = 5
"""Number of scans without a fit after which the search covers a wider range."""
JUMP_BACK_S = 0.5
MAX_RANGE_M = 12.0
MAX_RAYS = 1500
"""If a scan has more, only every second or third ray … is used, because neighbours measure almost the same."""


class Mapper(Node):
    """Builds the map, which begins with the first scan, at the pose of the odometry.

    A scan that can't be matched changes nothing: `map` → `odom` stays as it was, and one line reports it until scans
    fit again. The pose on /initialpose, which RViz and `tfloom view` publish, replaces the robot's pose.
    """

    def __init__(self) -> None:
        super().__init__("mapper")
        prefix = str(self.declare_parameter("frame_prefix", "").value)
        self.map_frame, self.odom_frame, self.base_frame = (
            prefix + name for name in ("map", "odom", "base_link")
        )
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.publisher = self.create_publisher(OccupancyGrid, "map", latched)
        self.broadcaster = TransformBroadcaster(self)
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.grid = OccupancyMap()
        self.map_from_odom = Pose2D()
        self.scan: LaserScan | None = None
        self.used: Pose2D | None = None
        """The laser's pose in `odom` at the last scan that was used."""
        self.heard: Time | None = None
        """When a scan was received last; None after a report of silence."""
        self.lost = 0
        self.problem = ""
        self.others = 0
        """Number of other nodes that publish the map."""
        self.has_changed = False
        self.create_subscription(LaserScan, "scan", self.on_scan, qos_profile_sensor_data)
        self.create_subscription(PoseWithCovarianceStamped, "initialpose", self.on_initial_pose, 1)
        self.heard = self.get_clock().now()
        self.stamp = Time(clock_type=self.heard.clock_type)
        self.create_timer(1.0 / RATE_HZ, self.on_timer)
        self.create_timer(MAP_PERIOD_S, self.publish_map)

    def on_scan(self, message: LaserScan) -> None:
        """Keep the newest scan until its transform is there, too."""
        if self.heard is None:
            self.get_logger().info("Scans are received again")
        self.heard = self.get_clock().now()
        stamp = Time.from_msg(message.header.stamp, self.heard.clock_type)
        back_s = (self.stamp - stamp).nanoseconds / 1e9
        self.stamp = stamp
        if back_s > JUMP_BACK_S:
            # A simulation or a recording began anew, and the robot may be where it was at its begin.
            self.get_logger().warn(f"The time of the scans jumped back by {back_s:.1f} s")
            self.used, self.lost = None, LOST_SCANS
            self.buffer.clear()
        self.scan = message

    def on_timer(self) -> None:
        now = self.get_clock().now()
        if self.scan is not None:
            self.use_scan(self.scan)
        # Sent also without scans, so that the chain of frames ends nowhere.
        self.broadcaster.sendTransform(
            transform_message(self.map_frame, self.odom_frame, now.to_msg(), self.map_from_odom)
        )
        if self.heard is not None and (now - self.heard).nanoseconds > SILENCE_S * 1e9:
            self.heard = None
            self.get_logger().warn(f"No scan for {SILENCE_S:.0f} s: map → odom stays as it is")

    def use_scan(self, scan: LaserScan) -> None:
        """Match a scan, and add it to the map, if its transform is known and the robot has moved."""
        try:
            transform = self.buffer.lookup_transform(self.odom_frame, scan.header.frame_id, self.stamp)
        except TransformException:
            return  # the odometry of the scan's time is still on its way
        self.scan = None
        odom_from_laser = of_transform(transform.transform)
        if self.used is not None:
            moved = self.used.inverse() @ odom_from_laser
            if math.hypot(moved.x, moved.y) < MIN_MOVE_M and abs(moved.yaw) < MIN_TURN_RAD:
                return
        hits, passes = rays(scan)
        self.used = odom_from_laser
        expected = self.map_from_odom @ odom_from_laser
        problem = ""
        if self.grid.log_odds.size:
            found = self.search(hits, odom_from_laser)
            problem = found.problem
            if not found.is_found:
                self.lost += 1
                self.report(f"{problem}; map → odom stays as it is")
                return
            self.lost = 0
            expected = found.pose
            self.map_from_odom = expected @ odom_from_laser.inverse()
        elif not len(hits):
            self.used = None
            self.report("the laser sees nothing, so the map can't begin")
            return
        try:
            self.grid.insert(expected, hits, passes)
            self.has_changed = True
        except GridError as error:
            problem = str(error)
        self.report(problem)

    def search(self, hits: np.ndarray, odom_from_laser: Pose2D) -> Match:
        """Return the best pose of the laser: near the expected one, or farther if scans haven't fitted lately."""
        expected = self.map_from_odom @ odom_from_laser
        if self.lost < LOST_SCANS:
            return match(self.grid, hits, expected, NEAR)
        # The odometry itself is tried, too, for a robot that is again where it began.
        starts = (expected, odom_from_laser)
        return max((match(self.grid, hits, start, WIDE) for start in starts), key=lambda found: found.fit)

    def report(self, problem: str) -> None:
        """Log a problem when it begins, and its end; numbers in its text may change meanwhile."""
        kind = problem.partition(":")[0]
        if kind == self.problem:
            return
        self.problem = kind
        if problem:
            self.get_logger().warn(problem[0].upper() + problem[1:])
        else:
            self.get_logger().info("Scans fit the map again")

    def report_others(self, others: int) -> None:
        """Log how many other nodes map on this domain, when their number changes: each corrects the same frames."""
        if others > self.others:
            topic = self.publisher.topic_name
            self.get_logger().warn(
                f"{topic} has {others} more publisher(s): map → odom jumps between their corrections and this one's. "
                "Stop the others, or use another ROS_DOMAIN_ID"
            )
        self.others = others

    def on_initial_pose(self, message: PoseWithCovarianceStamped) -> None:
        """Set the robot's pose to the one that a person has chosen; the next scan corrects it."""
        frame = message.header.frame_id
        pose = of_pose(message.pose.pose)
        if frame != self.map_frame or not all(map(math.isfinite, pose)):
            self.get_logger().error(
                f"An initial pose is ignored: it has to be finite, and in {self.map_frame}, not in {frame!r}"
            )
            return
        try:
            transform = self.buffer.lookup_transform(self.odom_frame, self.base_frame, Time())
        except TransformException as error:
            self.get_logger().error(f"An initial pose is ignored: {error}")
            return
        correction = pose @ of_transform(transform.transform).inverse()
        self.map_from_odom = Pose2D(correction.x, correction.y, turned(correction.yaw))
        self.used, self.lost = None, LOST_SCANS
        self.get_logger().info(f"The robot is at {pose.x:.2f}, {pose.y:.2f}, {math.degrees(pose.yaw):.0f}°")

    def publish_map(self) -> None:
        self.report_others(self.count_publishers("map") - 1)
        if not self.has_changed:
            return
        self.has_changed = False
        message = OccupancyGrid()
        message.header.frame_id, message.header.stamp = self.map_frame, self.get_clock().now().to_msg()
        message.info.resolution = RESOLUTION_M
        message.info.height, message.info.width = self.grid.log_odds.shape
        message.info.origin.position.x, message.info.origin.position.y = self.grid.origin.tolist()
        message.info.origin.orientation.w = 1.0
        message.data = self.grid.percentages().ravel().tolist()
        self.publisher.publish(message)


def rays(scan: LaserScan) -> tuple[np.ndarray, np.ndarray]:
    """Return where rays met something, and how far others are known to be free (each (N, 2)), in the laser's frame [m].

    REP 117: a ray of range inf met nothing; nan, -inf, 0 and others outside of the limits are not measurements.
    """
    stride = -(-len(scan.ranges) // MAX_RAYS) or 1
    ranges = np.asarray(scan.ranges[::stride], float)
    if not np.isfinite([scan.angle_min, scan.angle_increment, scan.range_min, scan.range_max]).all():
        return np.empty((0, 2)), np.empty((0, 2))
    angles = scan.angle_min + scan.angle_increment * stride * np.arange(len(ranges))
    limit = max(0.0, min(scan.range_max, MAX_RANGE_M))
    directions = np.stack((np.cos(angles), np.sin(angles)), axis=1)
    is_hit = (ranges >= max(scan.range_min, 1e-3)) & (ranges < limit)
    is_free = (ranges == np.inf) | ((ranges >= limit) & (ranges <= scan.range_max))
    return directions[is_hit] * ranges[is_hit, np.newaxis], directions[is_free] * limit


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    try:
        rclpy.spin(Mapper())
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()

"""A robot on a circle, with everything that pages show: for tests in a browser, pictures and benchmarks."""

from __future__ import annotations

import math
import sys
import time
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parents[2]))

from tests.viewer.messages import cloud, header, marker, pose

from tfloom.interfaces.geometry_msgs.msg import Point, PoseStamped, Quaternion, TransformStamped, Vector3
from tfloom.interfaces.nav_msgs.msg import MapMetaData, OccupancyGrid, Odometry
from tfloom.interfaces.nav_msgs.msg import Path as NavPath
from tfloom.interfaces.sensor_msgs.msg import CameraInfo, Image, LaserScan, PointCloud2
from tfloom.interfaces.std_msgs.msg import String
from tfloom.interfaces.visualization_msgs.msg import Marker, MarkerArray
from tfloom.node.client_library import spin
from tfloom.node.node import Node
from tfloom.node.program import run_program
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile
from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
from tfloom.tf2_ros.transform_broadcaster import TransformBroadcaster

EVIL = "<img src=x onerror=alert(1)>"
RADIUS_M = 2.0
SPEED_RAD_S = 0.4
HALF = (12.0, 8.0)
"""Sides of the room [m]."""
URDF = """<robot name="cart">
<material name="orange"><color rgba="1 0.5 0.1 1"/></material>
<material name="dark"><color rgba="0.15 0.15 0.18 1"/></material>
<link name="base_link">
<visual><origin xyz="0 0 0.18"/><geometry><box size="0.7 0.45 0.2"/></geometry><material name="orange"/></visual>
<visual><origin xyz="0.2 0.25 0.1" rpy="1.5708 0 0"/>
<geometry><cylinder radius="0.1" length="0.06"/></geometry><material name="dark"/></visual>
<visual><origin xyz="0.2 -0.25 0.1" rpy="1.5708 0 0"/>
<geometry><cylinder radius="0.1" length="0.06"/></geometry><material name="dark"/></visual>
<visual><origin xyz="-0.25 0 0.06"/><geometry><sphere radius="0.06"/></geometry><material name="dark"/></visual>
</link>
<link name="laser">
<visual><geometry><cylinder radius="0.08" length="0.12"/></geometry><material name="dark"/></visual>
</link></robot>"""


def transform(parent, child, x, y, z, yaw, stamp):
    message = TransformStamped(child_frame_id=child)
    message.header.frame_id, message.header.stamp = parent, stamp
    message.transform.translation = Vector3(x=x, y=y, z=z)
    message.transform.rotation = Quaternion(z=math.sin(yaw / 2), w=math.cos(yaw / 2))
    return message


class Robot(Node):
    """Drives on a circle in a room of 12 by 8 metres, whose walls its laser sees."""

    def __init__(self) -> None:
        super().__init__("robot")
        self.started = time.monotonic()
        self.tf = TransformBroadcaster(self)
        self.static = StaticTransformBroadcaster(self)
        now = self.get_clock().now().to_msg()
        optical = transform("camera", "camera_optical", 0.0, 0.0, 0.0, 0.0, now)
        optical.transform.rotation = Quaternion(x=-0.5, y=0.5, z=-0.5, w=0.5)  # z ahead, x to the right
        self.static.sendTransform(
            [
                optical,
                transform("map", "odom", 0.5, 0.2, 0.0, 0.1, now),
                transform("base_link", "laser", 0.2, 0.0, 0.34, 0.0, now),
                transform("base_link", "camera", 0.35, 0.0, 0.25, 0.0, now),
                transform("base_link", EVIL, -0.3, 0.0, 0.3, 0.0, now),
            ]
        )
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.map = self.create_publisher(OccupancyGrid, "map", latched)
        self.description = self.create_publisher(String, "robot_description", latched)
        self.scan = self.create_publisher(LaserScan, "scan", 10)
        self.points = self.create_publisher(PointCloud2, "points", 10)
        self.markers = self.create_publisher(MarkerArray, "markers", 10)
        self.plan = self.create_publisher(NavPath, "plan", 10)
        self.odom = self.create_publisher(Odometry, "odom", 10)
        self.image = self.create_publisher(Image, "camera/image", 10)
        self.camera = self.create_publisher(CameraInfo, "camera/camera_info", 10)
        self.description.publish(String(data=URDF))
        self.map.publish(self.room())
        self.create_timer(0.02, self.move)
        self.create_timer(0.2, self.look)

    def where(self) -> tuple[float, float, float]:
        angle = (time.monotonic() - self.started) * SPEED_RAD_S
        return RADIUS_M * math.cos(angle), RADIUS_M * math.sin(angle), angle + math.pi / 2

    def room(self) -> OccupancyGrid:
        cells = np.zeros((80, 120), np.int8)
        cells[[0, -1], :] = cells[:, [0, -1]] = 100
        cells[45:55, 90:94] = 100
        cells[:12, :12] = -1
        info = MapMetaData(resolution=0.1, width=120, height=80, origin=pose(-6.0, -4.0))
        return OccupancyGrid(header=header("map"), info=info, data=cells.ravel())

    def move(self) -> None:
        x, y, yaw = self.where()
        self.tf.sendTransform(transform("odom", "base_link", x, y, 0.0, yaw, self.get_clock().now().to_msg()))

    def look(self) -> None:
        stamp = self.get_clock().now().to_msg()
        x, y, yaw = self.where()

        def head(frame):
            made = header(frame)
            made.stamp = stamp
            return made

        # The walls as the laser sees them: the nearest of four lines along each beam, in the map's frame.
        turned = yaw + 0.1
        mx = 0.5 + x * math.cos(0.1) - y * math.sin(0.1) + 0.2 * math.cos(turned)
        my = 0.2 + x * math.sin(0.1) + y * math.cos(0.1) + 0.2 * math.sin(turned)
        angles = np.linspace(-2.2, 2.2, 300)
        cos, sin = np.cos(angles + turned), np.sin(angles + turned)
        with np.errstate(divide="ignore"):
            ranges = np.minimum((np.sign(cos) * 5.9 - mx) / cos, (np.sign(sin) * 3.9 - my) / sin)
        self.scan.publish(
            LaserScan(
                header=head("laser"),
                angle_min=-2.2,
                angle_max=2.2,
                angle_increment=4.4 / 299,
                range_min=0.05,
                range_max=30.0,
                ranges=ranges.astype(np.float32),
            )
        )
        random = np.random.default_rng(1).normal(0.0, 1.0, (4000, 3)).astype(np.float32)
        table = np.zeros(4000, [("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("intensity", "<f4")])
        table["x"], table["y"] = 3.4 + 0.5 * random[:, 0], 2.4 + 0.5 * random[:, 1]
        table["z"], table["intensity"] = np.abs(0.5 * random[:, 2]), random[:, 0]
        points = cloud(table)
        points.header = head("map")
        self.points.publish(points)
        several = [Point(x=0.3 * step, z=0.15 * step) for step in range(3)]
        kinds = (Marker.CUBE, Marker.SPHERE, Marker.CYLINDER, Marker.LINE_STRIP, Marker.SPHERE_LIST)
        markers = [
            marker(
                kind,
                kind,
                header=head("map"),
                pose=pose(-5.0 + place, 2.8, 0.4),
                scale=Vector3(x=0.4, y=0.4, z=0.4),
                points=several,
            )
            for place, kind in enumerate(kinds)
        ]
        markers.append(
            marker(
                Marker.TEXT_VIEW_FACING,
                99,
                header=head("map"),
                pose=pose(-3.0, 2.8, 1.2),
                scale=Vector3(z=0.35),
                text="shelf <b>A</b>",
            )
        )
        self.markers.publish(MarkerArray(markers=markers))
        circle = [
            PoseStamped(pose=pose(RADIUS_M * math.cos(0.1 * step), RADIUS_M * math.sin(0.1 * step)))
            for step in range(64)
        ]
        self.plan.publish(NavPath(header=head("odom"), poses=circle))
        odometry = Odometry(header=head("odom"), child_frame_id="base_link")
        odometry.pose.pose = pose(x, y, 0.0, (0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2)))
        odometry.pose.covariance[0], odometry.pose.covariance[7], odometry.pose.covariance[14] = (
            0.04,
            0.09,
            1e-4,
        )
        odometry.twist.twist.linear.x = RADIUS_M * SPEED_RAD_S
        self.odom.publish(odometry)
        pixels = np.zeros((120, 160, 3), np.uint8)
        pixels[:, :, 0] = np.linspace(40, 220, 160)
        pixels[:, :, 2] = np.linspace(200, 60, 120)[:, np.newaxis]
        at = int((math.sin(yaw) + 1.0) * 70)
        pixels[40:80, at : at + 20] = 255
        self.camera.publish(
            CameraInfo(
                header=head("camera_optical"),
                width=160,
                height=120,
                k=[80.0, 0, 80.0, 0, 80.0, 60.0, 0, 0, 1],
            )
        )
        self.image.publish(
            Image(
                header=head("camera_optical"),
                width=160,
                height=120,
                step=480,
                encoding="rgb8",
                data=pixels.tobytes(),
            )
        )
        self.get_logger().info(f"at {x:.2f}, {y:.2f}")


def main() -> int:
    return run_program(None, lambda: spin(Robot()))


if __name__ == "__main__":
    sys.exit(main())

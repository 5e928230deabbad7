"""Broadcast the frame of each turtle of the train."""

from functools import partial
import math

from geometry_msgs.msg import TransformStamped
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from tf2_ros import TransformBroadcaster
from train_interfaces.msg import TrainState
from turtlesim.msg import Pose


class Frames(Node):
    """Subscribe to the poses of all turtles that the train names, and broadcast them."""

    def __init__(self):
        super().__init__('frames')
        self.world = self.declare_parameter('world', 'world').value
        self.broadcaster = TransformBroadcaster(self)
        self.poses = {}
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.states = self.create_subscription(TrainState, 'train_state', self.on_state, latched)

    def on_state(self, state):
        for name in state.turtles:
            if name not in self.poses:
                callback = partial(self.on_pose, name)
                self.poses[name] = self.create_subscription(Pose, f'/{name}/pose', callback, 10)
                self.get_logger().info(f'Broadcasting {self.world} to {name}')

    def on_pose(self, name, pose):
        transform = TransformStamped()
        transform.header.stamp = self.get_clock().now().to_msg()
        transform.header.frame_id = self.world
        transform.child_frame_id = name
        transform.transform.translation.x = pose.x
        transform.transform.translation.y = pose.y
        # A turn about z by theta is the quaternion (0, 0, sin(theta / 2), cos(theta / 2)).
        transform.transform.rotation.z = math.sin(pose.theta / 2)
        transform.transform.rotation.w = math.cos(pose.theta / 2)
        self.broadcaster.sendTransform(transform)


def main():
    """Broadcast until Ctrl-C."""
    rclpy.init()
    node = Frames()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()

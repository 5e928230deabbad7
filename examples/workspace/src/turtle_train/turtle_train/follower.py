"""Have a wagon follow the turtle before it."""

from geometry_msgs.msg import Twist
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.time import Time
from tf2_ros import Buffer, TransformException, TransformListener
from train_interfaces.msg import TrainState
from turtle_train.steering import follow


class Follower(Node):
    """Steer the turtle of the parameter `wagon` after the turtle of the parameter `before`."""

    def __init__(self):
        super().__init__('follower')
        self.wagon = self.declare_parameter('wagon', 'wagon1').value
        self.before = self.declare_parameter('before', 'turtle1').value
        self.declare_parameter('speed_gain', 2.0)  # [1/s]
        self.declare_parameter('turn_gain', 4.0)  # [1/s]
        self.gap = None
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.states = self.create_subscription(TrainState, 'train_state', self.on_state, latched)
        self.commands = self.create_publisher(Twist, f'/{self.wagon}/cmd_vel', 1)
        self.timer = self.create_timer(0.05, self.on_timer)

    def on_state(self, state):
        self.gap = state.gap

    def on_timer(self):
        if self.gap is None:
            return  # the train has no state yet
        try:
            there = self.buffer.lookup_transform(self.wagon, self.before, Time())
        except TransformException:
            return  # no pose yet
        place = there.transform.translation
        speed_gain, turn_gain = (
            self.get_parameter(name).value for name in ('speed_gain', 'turn_gain'))
        twist = Twist()
        twist.linear.x, twist.angular.z = follow(place.x, place.y, self.gap, speed_gain, turn_gain)
        self.commands.publish(twist)


def main():
    """Follow until Ctrl-C."""
    rclpy.init()
    node = Follower()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()

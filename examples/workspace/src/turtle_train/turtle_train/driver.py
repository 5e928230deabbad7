"""Drive the leading turtle in a circle."""

from geometry_msgs.msg import Twist
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class Driver(Node):
    """Command the turtle of the parameter `turtle` at a speed and a turning rate."""

    def __init__(self):
        super().__init__('driver')
        turtle = self.declare_parameter('turtle', 'turtle1').value
        self.declare_parameter('speed', 0.8)  # [m/s]
        self.declare_parameter('turn', 0.3)  # [rad/s]
        self.publisher = self.create_publisher(Twist, f'/{turtle}/cmd_vel', 1)
        self.timer = self.create_timer(0.1, self.on_timer)

    def on_timer(self):
        twist = Twist()
        twist.linear.x = self.get_parameter('speed').value
        twist.angular.z = self.get_parameter('turn').value
        self.publisher.publish(twist)


def main():
    """Drive until Ctrl-C."""
    rclpy.init()
    node = Driver()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()

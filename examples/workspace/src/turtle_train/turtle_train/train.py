"""
Spawn the wagons of a train, and have each follow the turtle before it.

With the parameter `steers` false, a `follower` steers each wagon.
"""

from geometry_msgs.msg import Twist
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.time import Time
from tf2_ros import Buffer, TransformException, TransformListener
from train_interfaces.msg import TrainState
from train_interfaces.srv import SetGap
from turtle_train.steering import follow
from turtlesim.srv import Spawn

LEADER = 'turtle1'
SMALLEST_GAP = 0.2


class Train(Node):
    """Spawn wagons behind turtle1 by turtlesim's service, and steer them by their frames."""

    def __init__(self):
        super().__init__('train')
        self.wagons = self.declare_parameter('wagons', 10).value
        self.steers = self.declare_parameter('steers', True).value
        self.declare_parameter('gap', 0.5)  # [m]
        self.declare_parameter('speed_gain', 2.0)  # [1/s]
        self.declare_parameter('turn_gain', 4.0)  # [1/s]
        self.turtles = [LEADER]
        self.commands = {}
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.states = self.create_publisher(TrainState, 'train_state', latched)
        self.setter = self.create_service(SetGap, 'set_gap', self.on_set_gap)
        self.spawner = self.create_client(Spawn, 'spawn')
        self.spawning = None
        self.timer = self.create_timer(0.05, self.on_timer)

    def on_timer(self):
        if len(self.turtles) <= self.wagons and self.spawning is None:
            self.spawn()
        if not self.steers:
            return
        for before, wagon in zip(self.turtles, self.turtles[1:]):
            self.steer(before, wagon)

    def spawn(self):
        if not self.spawner.service_is_ready():
            self.get_logger().info('Waiting for turtlesim', once=True)
            return
        number = len(self.turtles)
        request = Spawn.Request(x=5.5 - 0.5 * number, y=5.5, theta=0.0, name=f'wagon{number}')
        self.spawning = self.spawner.call_async(request)
        self.spawning.add_done_callback(self.on_spawned)

    def on_spawned(self, future):
        self.spawning = None
        name = future.result().name or f'wagon{len(self.turtles)}'  # empty if it is there already
        self.turtles.append(name)
        self.commands[name] = self.create_publisher(Twist, f'/{name}/cmd_vel', 1)
        self.publish_state()
        if len(self.turtles) > self.wagons:
            self.get_logger().info(f'The train has {self.wagons} wagons')

    def publish_state(self):
        state = TrainState(turtles=self.turtles, gap=self.get_parameter('gap').value)
        state.stamp = self.get_clock().now().to_msg()
        self.states.publish(state)

    def steer(self, before, wagon):
        try:
            there = self.buffer.lookup_transform(wagon, before, Time()).transform.translation
        except TransformException:
            return  # no pose yet
        gap, speed_gain, turn_gain = (
            self.get_parameter(name).value for name in ('gap', 'speed_gain', 'turn_gain'))
        twist = Twist()
        twist.linear.x, twist.angular.z = follow(there.x, there.y, gap, speed_gain, turn_gain)
        self.commands[wagon].publish(twist)

    def on_set_gap(self, request, response):
        response.accepted = request.gap >= SMALLEST_GAP
        if response.accepted:
            self.set_parameters([Parameter('gap', value=request.gap)])
            self.publish_state()
        else:
            response.reason = f'the smallest gap is {SMALLEST_GAP} m'
        return response


def main():
    """Run the train until Ctrl-C."""
    rclpy.init()
    node = Train()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()

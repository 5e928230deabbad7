"""A lifecycle node, /managed, that logs its transitions, publishes, and fails or raises as set by its parameter."""

import rclpy
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn
from std_msgs.msg import String


class Managed(LifecycleNode):
    def __init__(self):
        super().__init__("managed", enable_logger_service=True)
        self.declare_parameter("configure", "success")
        self.out = self.create_lifecycle_publisher(String, "chatter", 10)
        self.create_timer(0.02, lambda: self.out.publish(String(data="active")))

    def on_configure(self, state):
        self.get_logger().info(f"configure from {state.label}")
        self.get_logger().debug("in detail")
        wish = self.get_parameter("configure").value
        if wish == "raise":
            raise ValueError("broken")
        if wish == "failure":
            return TransitionCallbackReturn.FAILURE
        return super().on_configure(state)

    def on_error(self, state):
        self.get_logger().error("cleaning up")
        return TransitionCallbackReturn.SUCCESS


rclpy.init()
node = Managed()
print("ready", flush=True)
rclpy.spin(node)

"""A node with parameters of every type, /ns/remote; its ROS arguments come from the command line."""

import rclpy
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor, SetParametersResult
from rclpy.parameter import Parameter
from rclpy.qos_overriding_options import QoSOverridingOptions
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node("remote", namespace="/ns")
defaults = {
    "bool": True,
    "integer": 5,
    "double": 1.5,
    "string": "text",
    "byte_array": [b"\x01", b"\x02"],
    "bool_array": [True, False],
    "integer_array": [1, -2],
    "double_array": [0.5, -0.25],
    "string_array": ["a", "b"],
}
for name, value in defaults.items():
    node.declare_parameter(name, value)
integers = ParameterDescriptor(
    description="a number", integer_range=[IntegerRange(from_value=0, to_value=10, step=2)]
)
node.declare_parameter("limited", 4, integers)
doubles = ParameterDescriptor(floating_point_range=[FloatingPointRange(from_value=0.0, to_value=1.0)])
node.declare_parameter("part", 0.5, doubles)
node.declare_parameter("fixed", 1, ParameterDescriptor(read_only=True))
node.declare_parameter("free", 1, ParameterDescriptor(dynamic_typing=True))
node.declare_parameter("unset", Parameter.Type.STRING)
node.declare_parameter("from_file", "")
node.declare_parameter("group.inner.deep", 1)


def no_thirteen(parameters):
    good = all(parameter.value != 13 for parameter in parameters)
    return SetParametersResult(successful=good, reason="" if good else "thirteen is unlucky")


node.add_on_set_parameters_callback(no_thirteen)
node.create_publisher(
    String, "chatter", 10, qos_overriding_options=QoSOverridingOptions.with_default_policies()
)
print("ready", flush=True)
rclpy.spin(node)

"""Public functions that programs call, with wrong arguments: the text says what was meant, near the program's line.

The rows are lines as programs have them. `test_misuse` has the cases that need more than one line.
"""

from __future__ import annotations

import inspect
import re
import traceback
from importlib import import_module
from pathlib import Path
from typing import Any

import pytest
from tests.each import for_each

import tfloom
from tfloom.node.context.context import Context
from tfloom.node.node import Node

MODULES = (
    "rclpy",
    "rclpy.action",
    "rclpy.callback_groups",
    "rclpy.clock",
    "rclpy.context",
    "rclpy.duration",
    "rclpy.executors",
    "rclpy.lifecycle",
    "rclpy.node",
    "rclpy.parameter",
    "rclpy.qos",
    "rclpy.serialization",
    "rclpy.time",
    "tf2_ros",
    "message_filters",
    "tf2_geometry_msgs",
    "tf_transformations",
    "ament_index_python",
    "rosbag2_py",
    "geometry_msgs.msg",
    "std_msgs.msg",
    "std_srvs.srv",
    "sensor_msgs.msg",
    "turtlesim.action",
    "launch",
    "launch.actions",
    "launch.conditions",
    "launch.event_handlers",
    "launch.substitutions",
    "launch_ros.substitutions",
)
"""Where the names of the rows come from; a name is that of the first module that has it."""

NO_CALLBACK = (
    "got None: if it is the result of a call, as of `callback()`, write `callback`, without brackets"
)
NO_FRAME = "the name of a frame or a publisher must be a str, not None of class NoneType"
ROWS = {
    # Nodes
    "Node(1)": "TypeError: a node name must be a str, not 1 of class int",
    "Node('a b')": "InvalidNodeNameException: must not contain characters other than alphanumerics or '_'",
    "Node('a', namespace='a b')": "InvalidNamespaceException: Invalid namespace",
    "Node('a', namespace=1)": "TypeError: a namespace must be a str, not 1 of class int",
    "Node('a', parameter_overrides={'x': 1})": "TypeError: got 'x' of class str: write [Parameter('name', value=1.0)]",
    "Node('a', parameter_overrides=Parameter('x', value=1))": "TypeError: put it in brackets, [Parameter(…)]",
    "Node('a', context=Context())": "NotInitializedException: rclpy.init() has not been called",
    "create_node(None)": "TypeError: a node name must be a str, not None",
    "LifecycleNode(None)": "TypeError: a node name must be a str, not None",
    # Topics
    "node.create_publisher('chatter', String, 10)": "AttributeError: got 'chatter' of class str",
    "node.create_publisher(str, 'a', 1)": (
        "AttributeError: expected a message class, such as std_msgs.msg.String, got the class builtins.str"
    ),
    "node.create_publisher(String(data='x'), 'a', 1)": (
        "AttributeError: got std_msgs.msg.String(data='x') of class String: give the class, String, without brackets"
    ),
    "node.create_publisher(SetBool, 'a', 1)": "RuntimeError: this might be a service or action",
    "node.create_publisher(String, 5, 1)": "TypeError: a topic name must be a str, not 5 of class int",
    "node.create_publisher(String, '', 1)": "InvalidTopicNameException: topic name must not be empty",
    "node.create_publisher(String, 'a//b', 1)": "InvalidTopicNameException: must not contain repeated '/'",
    "node.create_publisher(String, '{x}', 1)": "InvalidTopicNameException: unknown substitution: {x}",
    "node.create_publisher(String, 'a', '10')": "TypeError: received <class 'str'>: a depth is a number, as 10",
    "node.create_publisher(String, 'a', -1)": "ValueError: history depth must be greater than or equal to zero",
    "node.create_publisher(String, 'a', 1, callback_group=1)": "AttributeError: as ReentrantCallbackGroup(), got 1",
    "node.create_publisher(String, 'a b', 1)": "InvalidTopicNameException: Invalid topic name",
    "node.create_publisher(String, 'a', 1).publish('hello')": (
        "TypeError: got <class 'str'>: publish a message, String(data='hello')"
    ),
    "node.create_publisher(String, 'a', 1).publish(None)": (
        "TypeError: got <class 'NoneType'>: publish a message, String(data=…)"
    ),
    "node.create_publisher(Twist, 'a', 1).publish(2.0)": (
        "TypeError: got <class 'float'>: publish a message, Twist(linear=…, angular=…)"
    ),
    "node.create_publisher(String, 'a', 1).publish(String)": "TypeError: : publish a message, String(…), not its class",
    "node.create_publisher(String, 'a', 1).publish(Twist())": "TypeError: : this topic has std_msgs.msg.String",
    "node.create_publisher(Empty, 'a', 1).publish('x')": "TypeError: : this topic has std_msgs.msg.Empty",
    "node.create_publisher(Header, 'a', 1).publish(Header(stamp=Time(seconds=1)))": (
        "EncodeError: got Time(nanoseconds=1000000000, clock_type=SYSTEM_TIME) (Time): append .to_msg()"
    ),
    "node.create_publisher(String, 'a', 1).publish({'data': 'x'})": "TypeError: String(data={'data': 'x'})",
    "node.create_publisher(String, 'a', 1).publish(String(data=5))": "EncodeError: String.data must be a str, got 5",
    "node.create_subscription('String', 'a', print, 1)": "AttributeError: got 'String' of class str",
    "node.create_subscription(String, None, print, 1)": "TypeError: a topic name must be a str, not None",
    "node.create_subscription(String, 'a', 10, print)": "TypeError: Expected QoSProfile or int",
    "node.create_subscription(String, 'a b', print, 1)": "InvalidTopicNameException: Invalid topic name",
    "node.create_subscription(String, 'a', None, 10)": f"RuntimeError: {NO_CALLBACK}",
    "node.create_subscription(String, 'a', lambda a, b, c: None, 1)": (
        "RuntimeError: callable with one argument(to get only the message) or two (to get message and message info); "
        "got <function"
    ),
    "node.create_subscription(String, 'a', print, 1, callback_group=ReentrantCallbackGroup)": (
        "AttributeError: got the class ReentrantCallbackGroup: write ReentrantCallbackGroup()"
    ),
    "LifecycleNode('a', context=node.context).create_lifecycle_publisher('x', 'a', 1)": "AttributeError: got 'x'",
    # Services
    "node.create_service('a', SetBool, print)": "AttributeError: expected a service class, such as std_srvs",
    "node.create_service(String, 'a', print)": "RuntimeError: this might be a message or action",
    "node.create_service(SetBool, None, print)": "TypeError: a service name must be a str, not None",
    "node.create_service(SetBool, 'a b', print)": "InvalidServiceNameException: Invalid service name",
    "node.create_service(SetBool, 'a', None)": f"TypeError: {NO_CALLBACK}",
    "node.create_service(SetBool, 'a', 3)": "TypeError: got 3 of class int, which can't be called",
    "node.create_client('a', SetBool)": "AttributeError: expected a service class, such as std_srvs",
    "node.create_client(SetBool, None)": "TypeError: a service name must be a str, not None",
    "node.create_client(SetBool, 'a b')": "InvalidServiceNameException: Invalid service name",
    "node.create_client(SetBool, 'a').call(True)": "TypeError: send a request, SetBool.Request(data=True)",
    "node.create_client(SetBool, 'a').call_async(True)": "TypeError: send a request, SetBool.Request(data=True)",
    "node.create_client(SetBool, 'a').call_async(None)": "TypeError: send a request, SetBool.Request(data=…)",
    "node.create_client(SetBool, 'a').call_async(SetBool.Request)": "TypeError: SetBool.Request(…), not its class",
    "node.create_client(SetBool, 'a').call_async(SetBool.Response())": "TypeError: send a request, SetBool.Request(",
    "node.create_client(SetBool, 'a').wait_for_service('1')": "TypeError: a timeout in seconds, as 0.5, got '1'",
    # Actions
    "ActionClient('n', RotateAbsolute, 'a')": "TypeError: ActionClient() needs a node, got 'n' of class str",
    "ActionClient(RotateAbsolute, node, 'a')": "AttributeError: expected an action class",
    "ActionClient(node, String, 'a')": "RuntimeError: this might be a message or service",
    "ActionClient(node, RotateAbsolute, None)": "TypeError: a service name must be a str, not None",
    "ActionClient(node, RotateAbsolute, 'a b')": "InvalidServiceNameException: Invalid service name",
    "ActionClient(node, RotateAbsolute, 'a//b')": "InvalidServiceNameException: must not contain repeated '/'",
    "ActionClient(node, RotateAbsolute, 'a').send_goal_async(1.0)": "TypeError: RotateAbsolute.Goal(theta=1.0)",
    "ActionClient(node, RotateAbsolute, 'a').send_goal(None)": "TypeError: send a goal, RotateAbsolute.Goal(theta=…)",
    "ActionClient(node, RotateAbsolute, 'a').send_goal_async(RotateAbsolute.Goal(), feedback_callback=3)": (
        "TypeError: send_goal_async() needs a feedback callback, got 3"
    ),
    "ActionClient(node, RotateAbsolute, 'a').wait_for_server('x')": "TypeError: a timeout in seconds, as 0.5, got 'x'",
    "ActionServer(None, RotateAbsolute, 'a', print)": "TypeError: ActionServer() needs a node, got None",
    "ActionServer(node, String, 'a', print)": "RuntimeError: this might be a message or service",
    "ActionServer(node, RotateAbsolute, None, print)": "TypeError: a service name must be a str, not None",
    "ActionServer(node, RotateAbsolute, 'a', 3)": "TypeError: Failed to register goal execution callback",
    "ActionServer(node, RotateAbsolute, 'a', print, goal_callback=3)": "TypeError: goal callback: not callable, got 3",
    # Timers, rates and clocks
    "node.create_timer(Duration(seconds=1), print)": "TypeError: needs a period in seconds, as 0.5, got Duration",
    "node.create_timer(-1, print)": "ValueError: timer period must be non-negative, not -1.0 s",
    "node.create_timer(print, 1.0)": "TypeError: create_timer() needs a period in seconds",
    "node.create_timer(None, print)": "TypeError: create_timer() needs a period in seconds, as 0.5, got None of class",
    "node.create_timer('fast', print)": "ValueError: create_timer() needs a period in seconds, as 0.5, got 'fast' of",
    "node.create_timer(1.0, 'f')": "TypeError: create_timer() needs a callback, got 'f' of class str, which can't be",
    "node.create_timer(1.0, print, 1)": "AttributeError: expected a callback group",
    "node.create_guard_condition(print, 1)": "AttributeError: expected a callback group",
    "node.create_rate(0)": "ValueError: frequency must be > 0",
    "node.create_rate('x')": "TypeError: create_rate() needs a frequency in Hz, as 0.5, got 'x' of class str",
    "node.create_rate(None)": "TypeError: create_rate() needs a frequency in Hz, as 0.5, got None",
    "node.get_clock().sleep_for(1.0)": "TypeError: got 1.0 of class float: write Duration(seconds=1.0)",
    "node.get_clock().sleep_until(1.0)": "AttributeError: sleep_until() needs a Time, got 1.0 of class float",
    "Clock(clock_type='x')": "TypeError: Clock type must be a ClockType enum",
    "Time(seconds='x')": "TypeError: Time needs seconds, as 0.5, got 'x' of class str",
    "Time(seconds=None)": "TypeError: Time needs seconds, as 0.5, got None of class NoneType",
    "Time(nanoseconds='x')": "TypeError: Time needs nanoseconds, as 500, got 'x' of class str",
    "Time(seconds=-1)": "ValueError: Seconds value must not be negative",
    "Time(nanoseconds=-1)": "ValueError: Nanoseconds value must not be negative",
    "Time.from_msg(1.5)": "TypeError: Must pass a builtin_interfaces.msg.Time object, got 1.5 of class float",
    "Time.from_msg(Time())": "TypeError: which is one of rclpy: use it as it is",
    "Duration(seconds=None)": "TypeError: Duration needs seconds, as 0.5, got None of class NoneType",
    "Duration(seconds='2')": "ValueError: Duration needs seconds, as 0.5, got '2' of class str",
    "Duration.from_msg(1)": "TypeError: Must pass a builtin_interfaces.msg.Duration object, got 1 of class int",
    # Parameters
    "node.declare_parameter(None)": "TypeError: Expected string as name at index 0",
    "node.declare_parameter('', 1)": "InvalidParameterException: Invalid parameter name",
    "node.declare_parameter('a', object())": "TypeError: The given value is not one of the allowed types",
    "node.declare_parameter('a', {'a': 1})": "TypeError: DOUBLE_ARRAY, STRING_ARRAY'. It is {'a': 1} of class dict.",
    "node.declare_parameter('a', 1, 'a description')": "TypeError: Expected a ParameterDescriptor as third item",
    "node.declare_parameter('use_sim_time', True)": "ParameterAlreadyDeclaredException: ['use_sim_time']",
    "node.declare_parameters('', {'a': 1})": "TypeError: at index 0 in parameters list: a: write ('speed', 1.0)",
    "node.declare_parameters('', [('a', 1, None, 2)])": "TypeError: Invalid parameter tuple length at index 0",
    "node.declare_parameters('', [('a', [1, 'x'])])": "TypeError: It is [1, 'x'] of class list",
    "node.get_parameter('nope')": "ParameterNotDeclaredException: undeclared parameter(s): nope",
    "node.get_parameters(['nope'])": "ParameterNotDeclaredException: undeclared parameter(s): nope",
    "node.get_parameters([1])": "TypeError: All names must be instances of type str",
    "node.get_parameter_type('nope')": "ParameterNotDeclaredException: undeclared parameter(s): nope",
    "node.undeclare_parameter('nope')": "ParameterNotDeclaredException: undeclared parameter(s): nope",
    "node.describe_parameter('nope')": "ParameterNotDeclaredException: undeclared parameter(s): nope",
    "node.set_parameters({'a': 1})": "TypeError: got 'a' of class str: write [Parameter('name', value=1.0)]",
    "node.set_parameters(Parameter('a', value=1))": "TypeError: put it in brackets, [Parameter(…)]",
    "node.set_parameters([Parameter('nope', value=1)])": "ParameterNotDeclaredException: ['nope']",
    "node.set_parameters_atomically(Parameter('a', value=1))": "TypeError: put it in brackets, [Parameter(…)]",
    "node.set_parameters_atomically([Parameter('nope', value=1)])": "ParameterNotDeclaredException: ['nope']",
    "node.add_pre_set_parameters_callback(None)": f"TypeError: {NO_CALLBACK}",
    "node.add_on_set_parameters_callback(None)": f"TypeError: {NO_CALLBACK}",
    "node.add_post_set_parameters_callback(None)": f"TypeError: {NO_CALLBACK}",
    "Parameter('a', Parameter.Type.INTEGER, 'x')": "ValueError: Type 'Type.INTEGER' and value 'x' do not agree",
    "Parameter('a', int, 1)": "TypeError: Parameter.Type",
    "Parameter('a', value=object())": "TypeError: The given value is not one of the allowed types",
    # QoS
    "QoSProfile()": "InvalidQoSProfileException: History and/or depth settings are required",
    "QoSProfile(depht=1)": "TypeError: Invalid arguments passed to constructor: depht",
    "QoSProfile(depth='x')": "TypeError: depth must be an int, as 10, got 'x' of class str",
    "QoSProfile(depth=-1)": "ValueError: depth must be greater than or equal to zero",
    "QoSProfile(depth=1, reliability='reliable')": "ValueError: write ReliabilityPolicy.NAME, with a name of",
    "QoSProfile(depth=1, deadline=1.0)": "TypeError: got 1.0 of class float: write Duration(seconds=1.0)",
    # The graph, and logging
    "node.resolve_topic_name('a b')": "InvalidTopicNameException: Invalid topic name",
    "node.resolve_service_name('a b')": "InvalidServiceNameException: Invalid service name",
    "node.count_publishers(None)": "TypeError: a topic name must be a str, not None",
    "node.count_subscribers('a b')": "InvalidTopicNameException: topic name 'a b' is invalid: ",
    "node.count_publishers('a//b')": "InvalidTopicNameException: must not contain repeated '/'",
    "node.count_services(None)": "TypeError: a topic name must be a str, not None",
    "node.count_clients('a b')": "InvalidTopicNameException: topic name 'a b' is invalid: ",
    "node.get_publishers_info_by_topic(None)": "TypeError: a topic name must be a str, not None",
    "node.get_subscriptions_info_by_topic(None)": "TypeError: a topic name must be a str, not None",
    "node.wait_for_node(None, 1.0)": "TypeError: the full name of a node, as '/turtlesim', got None",
    "node.get_logger().set_level('loud')": "ValueError: 'loud' is not a valid LoggingSeverity: write",
    "node.get_logger().info('a', throttle_duration_sec='x')": "TypeError: must be a number of seconds, not str",
    # Executors
    "spin(None)": "TypeError: spin() needs a node, got None: does the function that creates it return it?",
    "spin(Node)": "TypeError: spin() needs a node, got the class Node: write Node(…)",
    "spin(node, 5)": "TypeError: spin() needs an executor, got 5 of class int",
    "spin_once(None)": "TypeError: spin_once() needs a node",
    "spin_once(node, executor=SingleThreadedExecutor)": (
        "TypeError: spin_once() needs an executor, got the class SingleThreadedExecutor: write SingleThreadedExecutor()"
    ),
    "spin_until_future_complete(None, None)": "TypeError: needs a node, got None",
    "spin_until_future_complete(node, None)": "TypeError: needs a future, as `call_async` returns it, got None",
    "spin_until_future_complete(node, Future(), 5)": (
        "TypeError: spin_until_future_complete() needs an executor, got 5 of class int"
    ),
    "spin_once(node, timeout_sec=Duration(seconds=1))": "TypeError: of class Duration: write 1",
    "spin_until_future_complete(node, print)": "TypeError: needs a future, as `call_async` returns it, got <built-in",
    "SingleThreadedExecutor(context=node.context).add_node(Node)": "TypeError: got the class Node: write Node(…)",
    "SingleThreadedExecutor(context=node.context).spin_once(timeout_sec='x')": "TypeError: in seconds, as 0.5, got 'x'",
    "SingleThreadedExecutor(context=node.context).spin_until_future_complete(None)": "TypeError: needs a future",
    "MultiThreadedExecutor(num_threads='x', context=node.context)": "TypeError: a number of threads, as 4, got 'x'",
    # Messages
    "String('hello')": "TypeError: String takes its fields by keyword: write String(data=…)",
    "LaserScan(ranges=['far'])": (
        "TypeError: must be real number, not str: LaserScan.ranges is float32[], got ['far'] of class list"
    ),
    "LaserScan(ranges=None)": "TypeError: LaserScan.ranges is float32[], got None of class NoneType",
    "Vector3(1.0, 2.0, 3.0)": "TypeError: write Vector3(x=…, y=…, z=…)",
    "serialize_message(None)": "AttributeError: needs a message, as String(data='hello'), got None",
    "serialize_message(String)": "AttributeError: write String(…)",
    "deserialize_message('x', String)": "TypeError: needs bytes, as serialize_message() returns them, got 'x'",
    "deserialize_message(String, b'')": "AttributeError: expected a message class, such as std_msgs.msg.String, got b",
    "deserialize_message(b'', String)": "DecodeError: a sample has a header of 4 bytes, this one ends after 0",
    # tf2
    "Buffer(1.5)": "TypeError: got 1.5 of class float: write rclpy.duration.Duration(seconds=1.5)",
    "Buffer(node)": "TypeError: of class Node: write rclpy.duration.Duration(seconds=…)",
    "Buffer(node='x')": "TypeError: Buffer() needs a node, got 'x' of class str",
    "Buffer(Duration(seconds=-1))": "ValueError: cache_time must not be negative, got Duration(nanoseconds=-1",
    "TransformListener(node, node)": "TypeError: TransformListener(buffer, node) needs a tf2_ros.Buffer first",
    "TransformListener(Buffer(), 'x')": "TypeError: TransformListener() needs a node, got 'x' of class str",
    "TransformListener(Buffer(), node, qos='x')": "TypeError: received <class 'str'>: a depth is a number, as 10",
    "TransformBroadcaster(None)": "TypeError: TransformBroadcaster(node) needs the node that publishes, got None",
    "TransformBroadcaster(Node)": "TypeError: TransformBroadcaster(node) needs the node that publishes, got <class",
    "TransformBroadcaster(node, qos='x')": "TypeError: a depth is a number, as 10",
    "TransformBroadcaster(node).sendTransform(None)": (
        "TypeError: sendTransform() needs a geometry_msgs.msg.TransformStamped, or several, got None of class NoneType"
    ),
    "TransformBroadcaster(node).sendTransform(Transform())": "TypeError: or several, got geometry_msgs",
    "TransformBroadcaster(node).sendTransform([1])": "TypeError: or several, got 1 of class int",
    "TransformBroadcaster(node).sendTransform(TransformStamped(child_frame_id=1))": "EncodeError: must be a str, got 1",
    "StaticTransformBroadcaster('x')": "TypeError: StaticTransformBroadcaster(node) needs the node that publishes, got",
    "StaticTransformBroadcaster(node).sendTransform([TransformStamped(), Twist()])": "TypeError: of class Twist",
    "StaticTransformBroadcaster(Node)": "TypeError: needs the node that publishes, got <class",
    "BufferClient(node, None)": "TypeError: a service name must be a str, not None",
    "BufferClient('x', 'a')": "TypeError: BufferClient() needs a node, got 'x' of class str",
    "Buffer().set_transform(None, 'me')": (
        "TypeError: set_transform() needs a geometry_msgs.msg.TransformStamped, got None"
    ),
    "Buffer().set_transform(TransformStamped(), None)": f"TypeError: {NO_FRAME}",
    "Buffer().set_transform_static('x', 'me')": (
        "TypeError: set_transform_static() needs a geometry_msgs.msg.TransformStamped, got 'x'"
    ),
    "Buffer().set_transform(Transform(), 'me')": "TypeError: needs a geometry_msgs.msg.TransformStamped",
    "Buffer().lookup_transform('a', 'b', 0.0)": "TypeError: write rclpy.time.Time(seconds=0.0), or Time() for",
    "Buffer().lookup_transform(None, 'b', Time())": f"TypeError: {NO_FRAME}",
    "Buffer().lookup_transform('a', None, Time())": f"TypeError: {NO_FRAME}",
    "Buffer().lookup_transform('/a', 'b', Time())": "InvalidArgumentException: cannot start with a '/'",
    "Buffer().lookup_transform('a', 'b', Time())": 'LookupException: "a" passed to lookupTransform argument',
    "Buffer().lookup_transform('a', 'b', Time(), 1.5)": "TypeError: write rclpy.duration.Duration(seconds=1.5)",
    "Buffer().lookup_transform_full('a', Time(), 'b', Time(), None)": "TypeError: must be a str, not None",
    "Buffer().can_transform(None, 'b', Time())": "TypeError: must be a str, not None",
    "Buffer().can_transform_full('a', 1, 'b', Time(), 'c')": "TypeError: write rclpy.time.Time(seconds=1)",
    "Buffer().get_latest_common_time('a', None)": "TypeError: must be a str, not None",
    "Buffer().transform(PointStamped(), None)": "TypeError: must be a str, not None of class NoneType",
    "Buffer().transform('map', PointStamped())": "TypeError: must be a str, not geometry_msgs",
    "Buffer().transform(None, 'map')": "TypeException: Type <class 'NoneType'> is not loaded or supported",
    "Buffer().transform(Point(), 'map')": "TypeException: a Point has no frame: transform a PointStamped",
    "Buffer().transform(PointStamped(), 'map', 1.5)": "TypeError: write rclpy.duration.Duration(seconds=1.5)",
    "Buffer().transform(PointStamped(), 'map', new_type=5)": "TypeException: Type 5 is not loaded or supported",
    "Buffer().transform_full(PointStamped(), 'map', 1.0, 'odom')": "TypeError: write rclpy.time.Time(seconds=1.0)",
    "convert(PointStamped(), int)": "TypeException: Type <class 'int'> is not loaded or supported",
    "do_transform_point(TransformStamped(), PointStamped())": "AttributeError: got TransformStamped and PointStamped",
    "do_transform_vector3(Vector3Stamped(), None)": "AttributeError: a Vector3, and a TransformStamped, got Vector3St",
    "do_transform_pose(PoseStamped(), TransformStamped())": "AttributeError: needs a Pose, and a TransformStamped, got",
    "do_transform_pose_stamped(Pose(), TransformStamped())": "AttributeError: needs a PoseStamped, and a TransformSt",
    "do_transform_pose_with_covariance_stamped(None, TransformStamped())": "AttributeError: got NoneType and",
    "do_transform_polygon_stamped(Polygon(), TransformStamped())": "AttributeError: needs a PolygonStamped, and",
    "do_transform_wrench(None, TransformStamped())": "AttributeError: needs a Wrench, and a TransformStamped, got None",
    "euler_from_quaternion(Quaternion())": "TypeError: write [q.x, q.y, q.z, q.w]",
    "euler_from_quaternion([0.0, 1.0])": "ValueError: a quaternion is four numbers x, y, z, w, got [0.0, 1.0]",
    "quaternion_multiply(None, [0, 0, 0, 1])": "TypeError: a quaternion is four numbers x, y, z, w, got None",
    "Subscriber(None, String, 'a')": "TypeError: Subscriber() needs a node, got None",
    "Subscriber('a', String)": "TypeError: Subscriber needs a node, a type and a topic, got 2 arguments",
    "Subscriber(node, 'a', String)": "AttributeError: expected a message class",
    "TimeSynchronizer(None, 10)": "TypeError: write [Subscriber(node, Image, 'image'), …]",
    "TimeSynchronizer([1], 10)": "AttributeError: needs filters, which have registerCallback, got 1 of class int",
    "ApproximateTimeSynchronizer([Subscriber(node, String, 'a')], 'x', 0.1)": "TypeError: a queue size, as 10, got 'x'",
    "Subscriber(node, String, 'a').registerCallback(None)": "TypeError: write `callback`, without brackets",
    # Packages and recordings
    "get_package_share_directory('no_such')": "PackageNotFoundError: package 'no_such' not found",
    "get_package_share_directory(None)": "TypeError: a package's name must be a str, not None",
    "get_package_prefix('')": "ValueError: '' is not a valid package name",
    "SequentialReader().open(None, None)": "TypeError: got NoneType and NoneType",
    "SequentialReader().open('a_bag', ConverterOptions())": "TypeError: needs StorageOptions(uri='…', ",
    "SequentialReader().open(StorageOptions('/no/such'), ConverterOptions())": "BagError: there is no such file",
    "SequentialReader().read_next()": "BagError: no bag is open: call open() before",
    "SequentialReader().has_next()": "BagError: no bag is open: call open() before",
    "SequentialWriter().open('a_bag', 'cdr')": "TypeError: got str and str",
    "SequentialWriter().write('a', b'', 0)": "BagError: no bag is open: call open() before",
    "bag.open_bag('/no/such')": "BagError: there is no such file or folder",
    "bag.frames('/no/such')": "BagError: there is no such file or folder",
    "NumpyBuffer(1.5)": "TypeError: an int of nanoseconds, as int(seconds * 1e9) or a Duration's nanoseconds, not 1.5",
    "NumpyBuffer().set('a', 'b', 1, (0, 0), (0, 0, 0, 1))": "TypeError: three numbers, x, y, z, not (0, 0)",
    "NumpyBuffer().lookup('a', 'b', 1.5)": "TypeError: a stamp must be an int of nanoseconds, as int(seconds * 1e9)",
    "NumpyBuffer().lookup_many('a', 'b', [1.5])": "TypeError: nanoseconds since the epoch, not float64",
    "NumpyBuffer().trajectory('a', 'b', rate_hz='x')": "TypeError: must be a number, as 20, not 'x' of class str",
    "NumpyBuffer().trajectory('a', 'b', rate_hz=0)": "ValueError: rate_hz must be above 0 and below 1e9, not 0",
    # Launch files
    "LaunchDescription(LogInfo(msg='a'))": "TypeError: LaunchDescription needs a list, write [LogInfo(…)]",
    "LaunchDescription([None])": "TypeError: got None: does the function that creates it return it?",
    "LaunchDescription().add_action('x')": "TypeError: LaunchDescription needs actions, got 'x' of class str",
    "LaunchNode(package=1, executable='b')": "TypeError: package: '1' of type 'int' is neither a text",
    "LaunchNode(package='a', executable=None)": "TypeError: executable: 'None' of type 'NoneType' is neither a text",
    "LaunchNode(package='a', executable='b', parameter=[])": "TypeError: 'parameter': did you mean 'parameters'?",
    "LaunchNode(package='a', executable='b', parameters={'x': 1})": "TypeError: write parameters=[{'x': 1}]",
    "LaunchNode(package='a', executable='b', parameters=[{'x': {'y': None}}])": "TypeError: to the parameter 'y'",
    "LaunchNode(package='a', executable='b', parameters=[1])": "TypeError: Expecting a file, a dictionary or a Param",
    "LaunchNode(package='a', executable='b', remappings=['a:=b'])": "TypeError: write remappings=[('from', 'to')]",
    "LaunchNode(package='a', executable='b', remappings=[('a',)])": "TypeError: a tuple of length 2, got length 1",
    "LaunchNode(package='a', executable='b', arguments='x y')": "TypeError: got 'x y': write ['x', 'y']",
    "LaunchNode(package='a', executable='b', arguments=[1])": "TypeError: neither a text nor a Substitution",
    "ExecuteProcess(cmd='ls -l')": "TypeError: cmd is a list of words, got 'ls -l': write ['ls', '-l']",
    "ExecuteProcess(cmd=['a', 1])": "TypeError: a word of cmd: '1' of type 'int' is neither a text",
    "ExecuteProcess(cmd=['a'], outptu='screen')": "TypeError: 'outptu': did you mean 'output'?",
    "DeclareLaunchArgument('a', default_value=True)": "TypeError: 'True' of type 'bool' is neither a text",
    "DeclareLaunchArgument('a', default_value='x', choices=['y'])": 'RuntimeError: "x" is not in provided choices',
    "IncludeLaunchDescription(None)": "TypeError: 'None' of type 'NoneType' is neither a text",
    "IncludeLaunchDescription('x', launch_arguments={'a': 'b'})": "TypeError: `launch_arguments={...}.items()`",
    "TimerAction(period='x', actions=[])": "ValueError: could not convert string to float: 'x'",
    "TimerAction(period=1.0, actions=LogInfo(msg='a'))": "TypeError: TimerAction needs a list, write [LogInfo(…)]",
    "OpaqueFunction(function=None)": "TypeError: expected a callable for 'function', got 'None'",
    "OnProcessExit(on_exit=5)": "TypeError: give actions, or a function that returns them, not 5",
    "OnProcessExit(target_action='x', on_exit=[])": "TypeError: action_matcher must be an 'ExecuteLocal' instance",
    "LogInfo(msg=1)": "TypeError: neither a text nor a Substitution nor a list of them: write '1'",
    "SetEnvironmentVariable('A', 1)": "TypeError: '1' of type 'int' is neither a text",
    "IfCondition(True)": "TypeError: 'True' of type 'bool' is neither a text",
    "LaunchConfiguration(None)": "TypeError: 'None' of type 'NoneType' is neither a text",
    "PathJoinSubstitution([None])": "TypeError: a part of the path: 'None' of type 'NoneType' is neither a text",
    "FindPackageShare(None)": "TypeError: 'None' of type 'NoneType' is neither a text",
    "LaunchParameterValue('a', value_type='x')": "ValueError: it is one of int, float, bool, str, or a list of one",
}
"""What a program writes: the kind of the error, and what its text, or a note, has in it."""

TIMES = {
    "Buffer().lookup_transform('a', 'b', 1.5)": (
        "got 1.5 of class float: write rclpy.time.Time(seconds=1.5), or Time() for the latest transform"
    ),
    "Buffer().lookup_transform_full('a', Time(), 'b', 'now', 'c')": (
        "got 'now' of class str: write rclpy.time.Time(seconds=…), or Time() for the latest transform"
    ),
    "Buffer().can_transform('a', 'b', None)": "got None of class NoneType: write",
    "Buffer().wait_for_transform_async('a', 'b', 1)": "rclpy.time.Time(seconds=1)",
    "Buffer().lookup_transform('a', 'b', Time(), timeout=1.5)": (
        "got 1.5 of class float: write rclpy.duration.Duration(seconds=1.5)"
    ),
    "Buffer().can_transform('a', 'b', Time(), 2)": "got 2 of class int: write rclpy.duration.Duration(seconds=2)",
}
"""What has the reference's text, and what its note has in it."""

MAX_FRAMES = 2
"""How many frames of tfloom may stand between the program's line and the text."""

FOLDER = str(Path(inspect.getfile(tfloom)).parent)

NEEDS_ROWS = re.compile(
    r"create_(?!lifecycle)|declare_|get_parameters?$|set_parameters(_atomically)?$|count_|resolve_|get_.*_info_by_topic$"
)
"""Methods of Node that users call with their own arguments."""


class _Names(dict[str, Any]):
    """The names of the rows, looked up when a row has them, because some modules warn of old names."""

    def __missing__(self, name: str) -> Any:
        for module in map(import_module, MODULES):
            if hasattr(module, name):
                return getattr(module, name)
        raise KeyError(name)


def _names(node: Node) -> _Names:
    return _Names(
        node=node,
        Node=Node,
        LaunchNode=import_module("launch_ros.actions").Node,
        LaunchParameterValue=import_module("launch_ros.parameter_descriptions").ParameterValue,
        bag=import_module("tfloom.bag"),
        NumpyBuffer=import_module("tfloom.tf2.buffer").Buffer,
    )


def _misuse(line: str, node: Node) -> BaseException:
    with pytest.raises(Exception) as caught:
        eval(line, {}, _names(node))
    return caught.value


def _misuse_of_a_new_node(line: str) -> BaseException:
    with Context() as context, Node("tester", context=context) as node:
        return _misuse(line, node)


@for_each(ROWS)
def test_error_says_what_was_given_near_the_line(line: str) -> None:
    error = _misuse_of_a_new_node(line)
    kind, _, text = ROWS[line].partition(": ")
    assert type(error).__name__ == kind
    assert text in "\n".join([str(error), *getattr(error, "__notes__", ())])
    _check_frames(error)


@for_each(TIMES)
def test_number_in_place_of_a_time_has_a_note(line: str) -> None:
    error = _misuse_of_a_new_node(line)
    assert isinstance(error, TypeError)
    assert str(error) in {
        f"{kind} must have sec and nanosec, or nanoseconds." for kind in ("time", "duration")
    }
    (note,) = error.__notes__  # type: ignore[attr-defined]
    assert TIMES[line] in note
    _check_frames(error)


def _check_frames(error: BaseException) -> None:
    frames = traceback.extract_tb(error.__traceback__)
    inside = [f"{frame.filename}:{frame.lineno}" for frame in frames if frame.filename.startswith(FOLDER)]
    assert len(inside) <= MAX_FRAMES, inside


def test_each_method_that_takes_arguments_has_a_row() -> None:
    methods = {name for name, _ in inspect.getmembers(Node, callable) if NEEDS_ROWS.match(name)}
    assert {"create_publisher", "declare_parameter", "count_clients"} <= methods
    assert not {name for name in methods if not any(f"node.{name}(" in line for line in ROWS)}


def test_each_transformation_of_messages_counts_its_frames(node: Node) -> None:
    """They are made by one decorator, so that one without it is found here."""
    geometry = import_module("tf2_geometry_msgs")
    names = [name for name in dir(geometry) if name.startswith("do_transform_")]
    assert len(names) > 10
    for name in names:
        error = _misuse(f"{name}(None, None)", node)
        assert f"{name}() needs" in str(error)

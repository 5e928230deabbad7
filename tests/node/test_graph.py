"""A node's queries of the graph, on both wires."""

from __future__ import annotations

import threading
from collections.abc import Callable

import pytest
from tests.conftest import wait_until

from tfloom.interfaces.example_interfaces.srv import AddTwoInts
from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.context.context import Context
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.qos.endpoint_info import TopicEndpointInfo, TopicEndpointTypeEnum
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile
from tfloom.node.values.exceptions import NodeNameNonExistentError

MakeNode = Callable[..., Node]
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


@pytest.fixture
def context(context_on_each_wire: Context) -> Context:
    return context_on_each_wire


def test_no_demangle_returns_dds_names(make_node: MakeNode) -> None:
    node = make_node("me", namespace="/here", start_parameter_services=False)
    node.create_publisher(String, "chatter", 10)
    node.create_subscription(String, "chatter", lambda msg: None, 10)
    node.create_client(AddTwoInts, "add")
    everything = dict(node.get_topic_names_and_types(no_demangle=True))
    assert everything["rt/here/chatter"] == ["std_msgs::msg::dds_::String_"]
    assert everything["rq/here/addRequest"] == ["example_interfaces::srv::dds_::AddTwoInts_Request_"]
    written = dict(node.get_publisher_names_and_types_by_node("me", "/here", no_demangle=True))
    assert {"rt/here/chatter", "rt/rosout", "rq/here/addRequest"} <= written.keys()
    assert "rr/here/addReply" not in written
    assert "rr/here/addReply" in dict(node.get_subscriber_names_and_types_by_node("me", "/here", True))
    [info] = node.get_publishers_info_by_topic("rt/here/chatter", no_mangle=True)
    assert (info.node_name, info.topic_type) == ("me", "std_msgs::msg::dds_::String_")
    assert node.get_subscriptions_info_by_topic("chatter", no_mangle=True) == []
    with pytest.raises(NodeNameNonExistentError, match="no node '/nobody' on the graph"):
        node.get_client_names_and_types_by_node("nobody", "/")


def test_enclaves_are_on_the_graph(context: Context, make_node: MakeNode) -> None:
    node = make_node("plain")
    assert ("plain", "/", "/") in node.get_node_names_and_namespaces_with_enclaves()
    guarded_context = Context()
    guarded_context.init(["prog", "--ros-args", "--enclave", "/robot/arm"])
    try:
        make_node("guarded", context=guarded_context)
        wanted = ("guarded", "/", "/robot/arm")
        wait_until(lambda: wanted in node.get_node_names_and_namespaces_with_enclaves())
    finally:
        guarded_context.destroy()


def test_wait_for_node_returns_when_the_node_appears(make_node: MakeNode) -> None:
    node = make_node("me", namespace="/here")
    assert node.wait_for_node("/here/me", timeout=1.0)
    assert node.wait_for_node("here/me", timeout=0.0)
    assert not node.wait_for_node("/me", timeout=0.05)
    thread = threading.Timer(0.05, lambda: make_node("late"))
    thread.start()
    assert node.wait_for_node("late", timeout=20.0)
    thread.join()


def test_topic_can_avoid_ros_namespace_conventions(make_node: MakeNode) -> None:
    """As in other DDS programs: without ROS's prefix, and separate from a ROS topic of that name."""
    node = make_node()
    native = QoSProfile(
        depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL, avoid_ros_namespace_conventions=True
    )
    publisher = node.create_publisher(String, "/sensor", native)
    heard = {"native": [], "ros": []}
    node.create_subscription(String, "/sensor", heard["native"].append, native)
    node.create_subscription(String, "/sensor", heard["ros"].append, LATCHED)
    wait_until(lambda: publisher.get_subscription_count() == 1)
    publisher.publish(String(data="raw"))
    with SingleThreadedExecutor(context=node.context) as executor:
        executor.add_node(node)
        while not heard["native"]:
            executor.spin_once(timeout_sec=1)
    assert heard == {"native": [String(data="raw")], "ros": []}
    names = dict(node.get_topic_names_and_types(no_demangle=True))
    assert names["/sensor"] == names["rt/sensor"] == ["std_msgs::msg::dds_::String_"]
    [info] = node.get_publishers_info_by_topic("/sensor", no_mangle=True)
    assert info.node_name == "tester"
    assert node.count_publishers("/sensor") == 0
    assert publisher.topic_name == "/sensor"


def test_endpoint_info_can_be_constructed() -> None:
    kinds = TopicEndpointTypeEnum
    mine = TopicEndpointInfo(node_name="talker", endpoint_type=kinds.PUBLISHER, endpoint_gid=[1] * 16)
    assert mine == TopicEndpointInfo(node_name="talker", endpoint_type=kinds.PUBLISHER, endpoint_gid=[1] * 16)
    assert mine != TopicEndpointInfo(node_name="talker")
    assert len({mine, mine}) == 1
    assert (mine.topic_type, mine.topic_type_hash.version) == ("", -1)
    assert "Endpoint type: PUBLISHER" in str(mine)
    with pytest.raises(TypeError, match="'node' is not a property of an endpoint; known are endpoint_gid, "):
        TopicEndpointInfo(node="talker")

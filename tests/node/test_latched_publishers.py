"""Many latched publishers of a topic: a listener keeps each static edge, a subscription as many as it wants."""

from __future__ import annotations

import pytest
from tests.conftest import wait_until

from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.interfaces.std_msgs.msg import Header, Int32
from tfloom.node.context.context import Context
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.qos.qos import DurabilityPolicy, HistoryPolicy, QoSProfile
from tfloom.node.values.time import Time
from tfloom.tf2_ros.buffer import Buffer
from tfloom.tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster
from tfloom.tf2_ros.transform_listener import StaticTransformListener, TransformListener

EDGES = 110
"""More than a usual depth."""
LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


@pytest.fixture
def context(context_on_each_wire: Context) -> Context:
    return context_on_each_wire


@pytest.fixture
def broadcasters(node: Node) -> list[StaticTransformBroadcaster]:
    """Return broadcasters of an edge each, which are not in the executor."""
    made = []
    for index in range(EDGES):
        made.append(StaticTransformBroadcaster(node))
        header = Header(frame_id="base")
        made[-1].sendTransform(TransformStamped(header=header, child_frame_id=f"frame_{index}"))
    return made


class SlowListener(TransformListener):
    """A listener whose messages are built, and wait for the executor."""

    def static_callback(self, data: object) -> None:
        super().static_callback(data)


@pytest.mark.parametrize("kind", [TransformListener, StaticTransformListener, SlowListener])
def test_a_late_listener_keeps_the_edge_of_each_publisher(
    kind: type[TransformListener], broadcasters: list[StaticTransformBroadcaster], context: Context
) -> None:
    node = Node("late", context=context)
    buffer = Buffer()
    listener = kind(buffer, node)
    subscription = listener.tf_static_sub
    assert subscription is not None
    wait_until(lambda: subscription.get_publisher_count() == EDGES)
    with SingleThreadedExecutor(context=context) as executor:
        executor.add_node(node)

        def has_all() -> bool:
            executor.spin_once(timeout_sec=0.1)
            return all(buffer.can_transform("base", f"frame_{index}", Time()) for index in range(EDGES))

        wait_until(has_all, what="all edges")
    # Edges that are sent from now on are kept, too.
    broadcasters[0].sendTransform(TransformStamped(header=Header(frame_id="base"), child_frame_id="another"))
    with SingleThreadedExecutor(context=context) as executor:
        executor.add_node(node)
        wait_until(
            lambda: (executor.spin_once(timeout_sec=0.1), buffer.can_transform("base", "another", Time()))[1]
        )
    listener.unregister()
    node.destroy_node()


def test_a_subscription_keeps_the_last_messages_of_all_publishers(context: Context, node: Node) -> None:
    publishers = [node.create_publisher(Int32, "latched", LATCHED) for _ in range(20)]
    for number, publisher in enumerate(publishers):
        publisher.publish(Int32(data=number))
    received: dict[HistoryPolicy, list[int]] = {HistoryPolicy.KEEP_ALL: [], HistoryPolicy.KEEP_LAST: []}
    executors = {}
    for history, numbers in received.items():
        qos = QoSProfile(history=history, depth=5, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        reader = Node(history.name.lower(), context=context)
        reader.create_subscription(
            Int32, "latched", lambda message, numbers=numbers: numbers.append(message.data), qos
        )
        executors[history] = SingleThreadedExecutor(context=context)
        executors[history].add_node(reader)
    everything, last = received.values()

    def spin_until(history: HistoryPolicy, number: int) -> None:
        def has_come() -> bool:
            executors[history].spin_once(timeout_sec=0.1)
            return number in received[history]

        wait_until(has_come)

    for number in range(20):
        spin_until(HistoryPolicy.KEEP_ALL, number)
    publishers[3].publish(Int32(data=100))
    spin_until(HistoryPolicy.KEEP_ALL, 100)
    spin_until(HistoryPolicy.KEEP_LAST, 100)
    executors[HistoryPolicy.KEEP_LAST].spin_once(timeout_sec=0.1)
    assert (len(everything), len(last)) == (21, 5)
    for executor in executors.values():
        executor.shutdown()

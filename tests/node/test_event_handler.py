"""Events of publishers and subscriptions."""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import run_to_end

from tfloom.interfaces.std_msgs.msg import Int32, String
from tfloom.node.executing.event_handler import (
    EventHandler,
    IncompatibleTypeInfo,
    PublisherEventCallbacks,
    QoSEventHandler,
    SubscriptionEventCallbacks,
    UnsupportedEventTypeError,
)
from tfloom.node.executing.event_types import QoSPublisherEventType, QoSSubscriptionEventType
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.qos.qos import (
    QoSPolicyKind,
    ReliabilityPolicy,
    qos_policy_name_from_kind,
    qos_profile_best_available,
    qos_profile_sensor_data,
)
from tfloom.node.values.duration import Duration
from tfloom.rmw.events import Count

SpinUntil = Callable[..., None]


def test_matched_events_count_peers(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    statuses: list[Any] = []
    executor.add_node(node)
    publisher = node.create_publisher(
        String, "chatter", 10, event_callbacks=PublisherEventCallbacks(matched=statuses.append)
    )
    subscription = node.create_subscription(
        String, "chatter", print, 10, event_callbacks=SubscriptionEventCallbacks(matched=statuses.append)
    )
    spin_until(lambda: len(statuses) == 2)
    assert {
        (status.total_count, status.current_count, status.current_count_change) for status in statuses
    } == {(1, 1, 1)}
    node.destroy_subscription(subscription)
    spin_until(lambda: len(statuses) == 3)
    assert (statuses[2].total_count, statuses[2].current_count, statuses[2].current_count_change) == (
        1,
        0,
        -1,
    )
    node.destroy_publisher(publisher)


def test_warning_about_incompatible_qos_has_both_policies(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil, capsys: pytest.CaptureFixture[str]
) -> None:
    executor.add_node(node)
    node.create_publisher(String, "chatter", qos_profile_sensor_data)
    node.create_subscription(String, "chatter", print, 10)
    text = ""

    def both() -> bool:
        nonlocal text
        text += capsys.readouterr().err
        return text.count("Last incompatible policy: RELIABILITY") == 2

    spin_until(both)
    sides = "(offered RELIABILITY BEST_EFFORT, requested RELIABILITY RELIABLE, peer /tester)"
    assert text.count(sides) == 2
    assert (
        "New subscription discovered on topic '/chatter', requesting incompatible QoS. No messages will be sent"
        in text
    )
    assert (
        "New publisher discovered on topic '/chatter', offering incompatible QoS. No messages will be received"
        in text
    )


def test_callback_or_opt_out_replaces_the_warning(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil, capsys: pytest.CaptureFixture[str]
) -> None:
    statuses: list[Any] = []
    executor.add_node(node)
    quiet = PublisherEventCallbacks(use_default_callbacks=False)
    node.create_publisher(String, "chatter", qos_profile_sensor_data, event_callbacks=quiet)
    loud = SubscriptionEventCallbacks(incompatible_qos=statuses.append)
    node.create_subscription(String, "chatter", print, 10, event_callbacks=loud)
    spin_until(lambda: statuses)
    kind = statuses[0].last_policy_kind
    assert (kind.name, str(kind)) == (
        "RMW_QOS_POLICY_RELIABILITY",
        "rmw_qos_policy_kind_t.RMW_QOS_POLICY_RELIABILITY",
    )
    assert repr(kind) == "<rmw_qos_policy_kind_t.RMW_QOS_POLICY_RELIABILITY: 16>"
    assert kind == QoSPolicyKind.RELIABILITY
    assert qos_policy_name_from_kind(kind) == "RELIABILITY"
    assert [one.name for one in type(kind)] == [f"RMW_QOS_POLICY_{one.name}" for one in QoSPolicyKind]
    assert list(type(kind)) == list(QoSPolicyKind)
    assert "incompatible" not in capsys.readouterr().err


def test_endpoints_have_two_handlers_by_default(node: Node) -> None:
    publisher = node.create_publisher(String, "chatter", 1)
    subscription = node.create_subscription(String, "chatter", print, 1)
    assert [len(end.event_handlers) for end in (publisher, subscription)] == [2, 2]
    kinds = (
        QoSPublisherEventType.RCL_PUBLISHER_INCOMPATIBLE_TYPE,
        QoSSubscriptionEventType.RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE,
    )
    assert (publisher.event_handlers[1].event_type, subscription.event_handlers[1].event_type) == kinds
    quiet = PublisherEventCallbacks(use_default_callbacks=False)
    assert node.create_publisher(String, "chatter", 1, event_callbacks=quiet).event_handlers == []


def test_peers_of_another_type_in_the_program_are_reported(
    node: Node,
    make_node: Callable[..., Node],
    executor: SingleThreadedExecutor,
    spin_until: SpinUntil,
    capsys: pytest.CaptureFixture[str],
) -> None:
    of_publisher: list[Count] = []
    of_subscription: list[Count] = []
    other = make_node("other")
    executor.add_node(node)
    executor.add_node(other)
    node.create_publisher(
        String, "chatter", 1, event_callbacks=PublisherEventCallbacks(incompatible_type=of_publisher.append)
    )
    node.create_publisher(Int32, "chatter", 1)  # of the same kind, which is no peer
    assert "has two types" in capsys.readouterr().err
    callbacks = SubscriptionEventCallbacks(incompatible_type=of_subscription.append)
    other.create_subscription(Int32, "chatter", print, 1, event_callbacks=callbacks)
    spin_until(lambda: of_publisher and of_subscription)
    other.create_subscription(Int32, "chatter", print, 1)
    spin_until(lambda: len(of_publisher) == 2)
    assert of_publisher == [Count(1, 1), Count(2, 1)]
    assert of_subscription == [Count(1, 1)]
    assert capsys.readouterr().err.count("has two types") == 2


def test_a_destroyed_peer_of_another_type_is_not_reported(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil, capsys: pytest.CaptureFixture[str]
) -> None:
    executor.add_node(node)
    publisher = node.create_publisher(String, "chatter", 1)
    node.destroy_publisher(publisher)
    seen: list[Count] = []
    callbacks = SubscriptionEventCallbacks(incompatible_type=seen.append)
    node.create_subscription(Int32, "chatter", print, 1, event_callbacks=callbacks)
    timer_ran: list[bool] = []
    node.create_timer(0.01, lambda: timer_ran.append(True))
    spin_until(lambda: timer_ran)
    assert seen == []
    assert "has two types" not in capsys.readouterr().err


def test_endpoint_with_unsupported_events_is_not_created(node: Node) -> None:
    with pytest.raises(UnsupportedEventTypeError, match="DEADLINE_MISSED"):
        node.create_publisher(String, "numbers", 1, event_callbacks=PublisherEventCallbacks(deadline=print))
    with pytest.raises(UnsupportedEventTypeError, match="MESSAGE_LOST"):
        node.create_subscription(
            String, "numbers", print, 1, event_callbacks=SubscriptionEventCallbacks(message_lost=print)
        )
    assert "/numbers" not in [endpoint.topic_name for endpoint in [*node.publishers, *node.subscriptions]]
    assert node.count_publishers("numbers") == node.count_subscribers("numbers") == 0


def test_acknowledgements_and_liveliness(node: Node) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    node.create_subscription(String, "chatter", print, 10)
    publisher.publish(String())
    assert publisher.wait_for_all_acked(Duration(seconds=5))
    publisher.assert_liveliness()


def test_best_available_matches_the_publishers(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    heard: list[str] = []
    executor.add_node(node)
    publisher = node.create_publisher(String, "chatter", qos_profile_sensor_data)
    node.create_subscription(
        String, "chatter", lambda msg: heard.append(msg.data), qos_profile_best_available
    )
    publisher.publish(String(data="x"))
    spin_until(lambda: heard)
    (info,) = node.get_subscriptions_info_by_topic("chatter")
    assert info.qos_profile.reliability is ReliabilityPolicy.BEST_EFFORT


def test_deprecated_name_of_event_handler_warns(node: Node) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    [watcher, *_] = publisher.event_handlers
    with pytest.warns(DeprecationWarning, match="use EventHandler instead"):
        QoSEventHandler(
            callback_group=node.default_callback_group,
            callback=lambda _: None,
            event_type=watcher.event_type,
            parent_impl=watcher._endpoint,
        )
    with pytest.warns(DeprecationWarning, match="use EventHandler instead"):

        class Mine(QoSEventHandler):
            """A derived class of a program."""


def test_handler_accepts_rclpys_event_type_and_a_handle(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    statuses: list[Any] = []
    publisher = node.create_publisher(String, "chatter", 10)
    handler = EventHandler(
        callback_group=node.default_callback_group,
        callback=statuses.append,
        event_type=QoSPublisherEventType.RCL_PUBLISHER_MATCHED,
        parent_impl=publisher.handle,
    )
    node.add_waitable(handler)
    executor.add_node(node)
    node.create_subscription(String, "chatter", print, 10)
    spin_until(lambda: statuses)
    assert statuses[0].current_count == 1
    node.remove_waitable(handler)
    with pytest.raises(ValueError, match="is not a waitable of this node"):
        node.remove_waitable(handler)
    assert handler.event_type is QoSPublisherEventType.RCL_PUBLISHER_MATCHED


@pytest.mark.parametrize(
    ("event_type", "error", "text"),
    [
        (QoSPublisherEventType.RCL_PUBLISHER_INCOMPATIBLE_TYPE, UnsupportedEventTypeError, "another type"),
        (
            QoSSubscriptionEventType.RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE,
            UnsupportedEventTypeError,
            "another type",
        ),
        (4, TypeError, "QoSPublisherEventType or QoSSubscriptionEventType, not 4"),
    ],
)
def test_handler_names_the_event_that_it_cannot_watch(
    node: Node, event_type: Any, error: type[Exception], text: str
) -> None:
    publisher = node.create_publisher(String, "chatter", 10)
    with pytest.raises(error, match=text):
        EventHandler(
            callback_group=node.default_callback_group,
            callback=print,
            event_type=event_type,
            parent_impl=publisher.handle,
        )


def test_event_types_have_rclpys_numbers() -> None:
    # as in a real Jazzy: rclpy.event_handler.QoSPublisherEventType.__members__
    assert {event_type.name: int(event_type) for event_type in QoSPublisherEventType} == {
        "RCL_PUBLISHER_OFFERED_DEADLINE_MISSED": 0,
        "RCL_PUBLISHER_LIVELINESS_LOST": 1,
        "RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS": 2,
        "RCL_PUBLISHER_INCOMPATIBLE_TYPE": 3,
        "RCL_PUBLISHER_MATCHED": 4,
    }
    assert {event_type.name: int(event_type) for event_type in QoSSubscriptionEventType} == {
        "RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED": 0,
        "RCL_SUBSCRIPTION_LIVELINESS_CHANGED": 1,
        "RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS": 2,
        "RCL_SUBSCRIPTION_MESSAGE_LOST": 3,
        "RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE": 4,
        "RCL_SUBSCRIPTION_MATCHED": 5,
    }
    assert IncompatibleTypeInfo(total_count=2, total_count_change=1).total_count_change == 1


def test_deprecated_name_of_the_module_warns() -> None:
    sys.modules.pop("rclpy.qos_event", None)
    sys.modules.pop("tfloom.node.executing.qos_event", None)
    with pytest.warns(UserWarning, match="importing 'qos_event' is deprecated; import 'event_handler'"):
        import rclpy.qos_event
    import rclpy.event_handler

    assert rclpy.qos_event.PublisherEventCallbacks is rclpy.event_handler.PublisherEventCallbacks


def test_a_module_that_lyrical_lacks_warns_there(tmp_path: Path) -> None:
    code = (
        "import warnings; warnings.simplefilter('always')\n"
        "with warnings.catch_warnings(record=True) as caught:\n"
        "    import rclpy.topic_endpoint_info as former\n"
        "import rclpy.endpoint_info as present\n"
        "assert former.TopicEndpointInfo is present.TopicEndpointInfo\n"
        "print([(one.category.__name__, str(one.message), one.filename) for one in caught])"
    )
    text = "rclpy.topic_endpoint_info is deprecated from lyrical on: use rclpy.endpoint_info"
    for name, expected in (("kilted", []), ("lyrical", [("DeprecationWarning", text, "<string>")])):
        done = run_to_end([sys.executable, "-c", code], env=os.environ | {"ROS_DISTRO": name}, cwd=tmp_path)
        assert (done.stdout.strip(), done.returncode) == (str(expected), 0), done.stderr

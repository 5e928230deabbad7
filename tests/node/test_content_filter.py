"""Content filters: what expressions mean, as live Fast DDS of Kilted answers, and which messages subscriptions get."""

from __future__ import annotations

import time
from collections.abc import Callable
from typing import Any

import pytest
from tests.conftest import wait_until
from tests.each import for_each

from tfloom.interfaces.builtin_interfaces.msg import Time
from tfloom.interfaces.example_interfaces.action import Fibonacci
from tfloom.interfaces.example_interfaces.msg import WString
from tfloom.interfaces.rcl_interfaces.msg import ParameterEvent, ParameterValue
from tfloom.interfaces.sensor_msgs.msg import JointState, LaserScan
from tfloom.interfaces.std_msgs.msg import Bool, Float32, Header, Int32, String, UInt64
from tfloom.node.action.client import ActionClient
from tfloom.node.action.server import ActionServer
from tfloom.node.builtin.parameter_event_handler import ParameterEventHandler
from tfloom.node.context.context import Context
from tfloom.node.endpoints import content_filter
from tfloom.node.endpoints.content_filter import ContentFilter, ContentFilterOptions, FilterError
from tfloom.node.endpoints.subscription import Subscription
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node
from tfloom.node.qos.qos import DurabilityPolicy, QoSProfile
from tfloom.node.values.exceptions import InvalidHandle, RCLError
from tfloom.node.wait_for_message import wait_for_message
from tfloom.rmw.local.endpoints import LocalReader
from tfloom.rosidl import cdr

SpinUntil = Callable[..., None]
NUMBERS = (3, 5, 6, 7, 16, -5)
TEXTS = ("a", "ab", "abc", "A", "b", "", "a%", "x'y", "a.c", "a\nb", "é")

# Recorded from a subscription of rclpy 9.1.2 on Fast DDS 3.2.3, to which all of NUMBERS or TEXTS were published.
OF_NUMBERS: dict[str, list[int]] = {
    "data = 5 OR data = 6 AND data = 7": [],
    "data = 7 AND data = 6 OR data = 5": [5],
    "NOT data = 5 AND data = 6": [6],
    "NOT data = 5 OR data = 5": [3, 5, 6, 7, 16, -5],
    "NOT (data = 5 OR data = 6)": [3, 7, 16, -5],
    "NOT NOT data = 5": [5],
    "data = 0x10": [16],
    "data = 0X10": [16],
    "data = 020": [16],
    "data = +5": [5],
    "data = -5": [-5],
    "data = -0x5": [-5],
    "data > 5.5": [6, 7, 16],
    "data BETWEEN 5 AND 6": [5, 6],
    "data BETWEEN 6 AND 5": [],
    "data NOT BETWEEN 5 AND 6": [3, 7, 16, -5],
    "data NOT BETWEEN 5 AND 6 AND data = 7": [7],
    "data between 5 and 6 and data = 5": [5],
    "data BETWEEN 4.5 AND 6.5": [5, 6],
    "5 < data": [6, 7, 16],
    "5 >= data": [3, 5, -5],
    "data = TRUE": [],
    "data > FALSE": [3, 5, 6, 7, 16],
    "data < 99999999999": [3, 5, 6, 7, 16, -5],
    "data = 0.5e1": [5],
    "data <1e400": [3, 5, 6, 7, 16, -5],
    "((data = 5))": [5],
    "data=5 OR data=6 OR data=7": [5, 6, 7],
    "data <> 5 and data != 6": [3, 7, 16, -5],
    "data = data": [3, 5, 6, 7, 16, -5],
    "": [3, 5, 6, 7, 16, -5],
    "data = 5 AND(data = 5)": [5],
    "data = 5\nOR\tdata = 6": [5, 6],
}
OF_TEXTS: dict[str, list[str]] = {
    "data = 'a'": ["a"],
    "data <> 'a'": ["ab", "abc", "A", "b", "", "a%", "x'y", "a.c", "a\nb", "é"],
    "data > 'a'": ["ab", "abc", "b", "a%", "x'y", "a.c", "a\nb", "é"],
    "data <= 'ab'": ["a", "ab", "A", "", "a%", "a.c", "a\nb"],
    "data LIKE 'a_'": ["ab", "a%"],
    "data LIKE 'a?'": ["ab", "a%"],
    "data LIKE '_b'": ["ab"],
    "data = ''": [""],
    "data BETWEEN 'a' AND 'abc'": ["a", "ab", "abc", "a%", "a.c", "a\nb"],
    "data = `a'": ["a"],
    "'a' = data": ["a"],
    "'a%' LIKE data": ["a%"],
    "data LIKE 'é'": ["é"],
    "data LIKE data": list(TEXTS),
    # Here by the row filter-like of docs/deviations.md.
    "data LIKE 'a%'": ["a", "ab", "abc", "a%", "a.c", "a\nb"],
    "data LIKE '*b'": ["ab", "b", "a\nb"],
    "data LIKE 'a.c'": ["a.c"],
    "data LIKE '%_'": ["a", "ab", "abc", "A", "b", "a%", "x'y", "a.c", "a\nb", "é"],
    "data LIKE '%'": list(TEXTS),
    "data LIKE '_'": ["a", "A", "b", "é"],
    "data LIKE '%b%'": ["ab", "abc", "b", "a\nb"],
    "data LIKE 'a%b'": ["ab", "a\nb"],
    "data LIKE 'a_c%'": ["abc", "a.c"],
    "NOT data LIKE 'a%'": ["A", "b", "", "x'y", "é"],
}
REFUSED = {
    "   ": "a field, a literal or a parameter is missing, at character 1",
    "data > ": "a field, a literal or a parameter is missing, at character 7",
    "data >> 5": "a field, a literal or a parameter is missing, at character 7",
    "data == 5": "a field, a literal or a parameter is missing",
    "nofield > 5": "field not found: std_msgs/msg/Int32 has no nofield, at character 1",
    "DATA = 5": "field not found",
    "data > %0": "%0 needs 1 parameters, and 0 are given",
    "data=5 aNd data<>6": "the expression should end here, or go on with AND or OR, at character 8",
    "data = 5 ANDdata = 6": "should end here",
    "data = .5": "not a part of a filter expression",
    "data = 5.": "not a part of",
    "data = 08": "not a number of 64 bits",
    "data = - 5": "not a part of",
    "data = 5u": "not a part of",
    "data = 0x1G": "not a part of",
    "data = % 0": "not a part of",
    "data = `5`": "not a part of",
    "data = 5)": "should end here",
    "(data = 5": ") is missing",
    "data = 'a'": "data, a number, can't be compared with 'a', a text",
    "data LIKE '5'": "LIKE compares texts",
    "data LIKE 5": "LIKE compares texts",
    "data IN (1,2)": "not a part of a filter expression, at character 11",
    "data IN (1)": "a comparison is missing: =, <>",
    "data MATCH 5": "a comparison is missing",
    "data NOT LIKE 5": "BETWEEN is missing",
    "5 = 5": "one side of a comparison must be a field",
    "TRUE": "a comparison is missing",
    "data": "a comparison is missing",
    "5 BETWEEN data AND 7": "BETWEEN compares a field with two literals",
    "data BETWEEN data AND 7": "BETWEEN compares a field with two literals",
    "data =5 ; x": "not a part of",
    "data = 99999999999999999999": "not a number of 64 bits",
    "data[0] = 5": "what has an index is not an array",
    "data.x = 5": "field not found",
    "data = 5 AND": "a field, a literal or a parameter is missing",
    "(" * 101 + "data = 5" + ")" * 101: "it is nested deeper than 100",
    "NOT " * 101 + "data = 5": "it is nested deeper than 100",
    "data = 5 OR " * 10_000 + "data = 5": "longer than 65536 characters",
}


def options(expression: str, *parameters: str) -> ContentFilterOptions:
    return ContentFilterOptions(expression, list(parameters))


def compiled(message_class: Any, expression: str, *parameters: str) -> ContentFilter:
    return ContentFilter(message_class, options(expression, *parameters))


@for_each([*OF_NUMBERS, *OF_TEXTS])
def test_expressions_mean_what_they_mean_to_fast_dds(expression: str) -> None:
    if expression in OF_NUMBERS:
        accepts = compiled(Int32, expression).accepts
        assert [number for number in NUMBERS if accepts(Int32(data=number))] == OF_NUMBERS[expression]
    else:
        accepts = compiled(String, expression).accepts
        assert [text for text in TEXTS if accepts(String(data=text))] == OF_TEXTS[expression]


@for_each(list(REFUSED))
def test_what_is_wrong_is_named_with_its_place(expression: str) -> None:
    with pytest.raises(FilterError) as caught:
        compiled(Int32, expression)
    assert REFUSED[expression] in str(caught.value)
    assert len(str(caught.value)) < 500


def test_parameters_are_literals() -> None:
    assert compiled(Int32, "data >= %1 AND data <= %00", "6", "5").accepts(Int32(data=6))
    assert compiled(String, "data LIKE %0", "'a%'").accepts(String(data="abc"))
    for wrong in (" 5", "5 ", "", "x", "data", "%0", "'a", "AND"):
        with pytest.raises(FilterError, match="parameter 0 is neither a number, TRUE or FALSE, nor a text"):
            compiled(Int32, "data = %0", wrong)
    assert compiled(Int32, "data = %99", *["5"] * 100).accepts(Int32(data=5))
    with pytest.raises(FilterError, match=r"^The maximum of expression parameters argument number is 100$"):
        compiled(Int32, "data = %0", *["5"] * 101)
    not_options: list[Any] = [(5, []), ("data = 5", "5"), ("data = 5", [5])]
    for wrong_options in not_options:
        with pytest.raises(TypeError):
            ContentFilter(Int32, ContentFilterOptions(*wrong_options))


def test_fields_of_fields_and_of_arrays() -> None:
    scan = LaserScan(header=Header(stamp=Time(sec=7), frame_id="laser"), ranges=[1.5])
    assert compiled(LaserScan, "header.stamp.sec = 7 AND header.frame_id = 'laser'").accepts(scan)
    first = "ranges[0] > 1"
    assert compiled(LaserScan, first).accepts(scan)
    # What is not there is neither true nor false.
    missing = "ranges[1] = 1.5"
    for expression, accepted in {
        missing: False,
        f"NOT {missing}": False,
        f"{missing} OR {first}": True,
        f"{first} OR {missing}": True,
        f"{first} AND {missing}": False,
        f"NOT {first} AND {missing}": False,
        f"NOT ({missing} AND NOT {first})": True,
        "ranges[99999999999999999999999] = 1": False,
    }.items():
        assert compiled(LaserScan, expression).accepts(scan) is accepted, expression
    names = compiled(JointState, "name[1] = 'elbow'")
    assert names.accepts(JointState(name=["wrist", "elbow"]))
    assert not names.accepts(JointState(name=["elbow"]))
    nested = "new_parameters[0].value.integer_value = 3"
    assert not compiled(ParameterEvent, nested).accepts(ParameterEvent())
    for wrong, reason in {
        "header = 5": "header is a message: name one of its fields",
        "ranges = 5": "the array needs an index, as",
        "header.stamp.sec[0] = 5": "what has an index is not an array",
        "ranges[0][0] = 5": "a comparison is missing|not a part",
        "ranges[-1] = 5": "not a part|comparison is missing",
    }.items():
        with pytest.raises(FilterError, match=reason):
            compiled(LaserScan, wrong)


def test_numbers_of_each_type() -> None:
    received = cdr.decode(Float32, cdr.encode(Float32(data=0.1)))
    assert received.data != 0.1
    assert compiled(Float32, "data = 0.1 AND 0.1 >= data").accepts(received)
    assert not compiled(Float32, "data = 0.1").accepts(Float32(data=float("nan")))
    assert compiled(Float32, "data < 1e300").accepts(Float32(data=1.0))
    assert compiled(Bool, "data = true AND data = 1").accepts(Bool(data=True))
    large = UInt64(data=2**64 - 1)
    assert compiled(UInt64, "data = 0xFFFFFFFFFFFFFFFF AND data > -1").accepts(large)
    assert not compiled(UInt64, "data = 18446744073709551614").accepts(large)
    by_byte = compiled(ParameterValue, "byte_array_value[0] = 7")
    assert by_byte.accepts(ParameterValue(byte_array_value=[b"\x07"]))


def test_a_pattern_takes_no_more_than_the_lengths_multiplied() -> None:
    """Match what would take a backtracking expression ages."""
    begin = time.monotonic()
    assert not compiled(String, f"data LIKE '{'%a' * 30}b'").accepts(String(data="a" * 100_000))
    assert not compiled(String, f"data LIKE '{'%a_' * 30}b'").accepts(String(data="a" * 100_000))
    assert time.monotonic() - begin < 5


def test_a_long_expression_is_evaluated() -> None:
    whole = compiled(Int32, " OR ".join(["data = 5"] * 5_000))
    assert whole.accepts(Int32(data=5))
    assert not whole.accepts(Int32(data=6))


@pytest.fixture
def node_on_each_wire(context_on_each_wire: Context) -> Node:
    return Node("filters", context=context_on_each_wire, start_parameter_services=False)


def test_only_what_is_accepted_reaches_the_callback(
    node_on_each_wire: Node, context_on_each_wire: Context
) -> None:
    node, got = node_on_each_wire, []
    qos = QoSProfile(depth=50)
    with_info: list[tuple[int, int]] = []
    raw: list[bytes] = []
    subscription = node.create_subscription(
        Int32,
        "numbers",
        lambda message: got.append(message.data),
        qos,
        content_filter_options=options("data > %0", "5"),
    )
    node.create_subscription(
        Int32,
        "numbers",
        lambda message, info: with_info.append((message.data, info["source_timestamp"])),
        qos,
        content_filter_options=options("data = 8"),
    )
    node.create_subscription(
        Int32, "numbers", raw.append, qos, raw=True, content_filter_options=options("data = 9")
    )
    publisher = node.create_publisher(Int32, "numbers", qos)
    with SingleThreadedExecutor(context=context_on_each_wire) as executor:
        executor.add_node(node)

        def publish_all(until: Callable[[], object]) -> None:
            end = time.monotonic() + 20
            while publisher.get_subscription_count() < 3 and time.monotonic() < end:
                executor.spin_once(timeout_sec=0.05)
            for number in range(10):
                publisher.publish(Int32(data=number))
            while not until() and time.monotonic() < end:
                executor.spin_once(timeout_sec=0.05)

        publish_all(lambda: len(got) == 4 and with_info and raw)
        assert got == [6, 7, 8, 9]
        assert [number for number, _ in with_info] == [8]
        assert [data[4:8] for data in raw] == [b"\x09\x00\x00\x00"]
        subscription.set_content_filter("data < %0", ["3"])
        got.clear()
        publish_all(lambda: len(got) == 3 and len(raw) == 2)
        assert got == [0, 1, 2]


def test_setting_and_getting(node: Node) -> None:
    plain = node.create_subscription(Int32, "a", print, 10)
    assert plain.is_cft_supported
    assert not plain.is_cft_enabled
    with pytest.raises(RCLError, match=r"^Failed to get cft expression parameters: "):
        plain.get_content_filter()
    with pytest.raises(RCLError, match=r"^Failed to set cft expression parameters: .* at character 7 of"):
        plain.set_content_filter("data >> 5", [])
    assert not plain.is_cft_enabled
    plain.set_content_filter("data > %0", ["5"])
    assert plain.is_cft_enabled
    with pytest.raises(RCLError):
        plain.set_content_filter("data <<", [])
    assert plain.get_content_filter() == options("data > %0", "5")
    plain.set_content_filter("", [])
    assert not plain.is_cft_enabled
    with pytest.raises(RCLError):
        plain.get_content_filter()
    with pytest.raises(RCLError, match=r"^Failed to set content_filter_options: field not found"):
        node.create_subscription(Int32, "a", print, 10, content_filter_options=options("x = 1"))
    with pytest.raises(TypeError, match="must be ContentFilterOptions, got 'data > 5'"):
        node.create_subscription(Int32, "a", print, 10, content_filter_options="data > 5")
    assert [subscription.topic for subscription in node.subscriptions].count("a") == 1
    node.destroy_subscription(plain)
    for use in (
        lambda: plain.is_cft_enabled,
        plain.get_content_filter,
        lambda: plain.set_content_filter("data > 5", []),
    ):
        with pytest.raises(InvalidHandle):
            use()


def test_a_filter_that_is_set_while_the_node_spins(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    got: list[int] = []
    subscription = node.create_subscription(Int32, "a", lambda message: got.append(message.data), 10)
    publisher = node.create_publisher(Int32, "a", 10)
    executor.add_node(node)
    executor.spin_once(timeout_sec=0)
    subscription.set_content_filter("data = 2", [])
    for number in (1, 2):
        publisher.publish(Int32(data=number))
    spin_until(lambda: got)
    subscription.set_content_filter("", [])
    publisher.publish(Int32(data=3))
    spin_until(lambda: len(got) == 2)
    assert got == [2, 3]


def test_a_flood_ahead_of_a_filter_that_is_set_while_the_node_spins(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(content_filter, "MAX_REJECTED", 5)
    got: list[int] = []
    qos = QoSProfile(depth=1000)
    subscription = node.create_subscription(Int32, "a", lambda message: got.append(message.data), qos)
    publisher = node.create_publisher(Int32, "a", qos)
    executor.add_node(node)
    executor.spin_once(timeout_sec=0)
    subscription.set_content_filter("data = 99", [])
    for number in range(100):
        publisher.publish(Int32(data=number))
    spin_until(lambda: got)
    assert got == [99]


def test_each_message_is_that_of_its_own_sample(node: Node) -> None:
    got: list[int] = []
    subscription = node.create_subscription(
        Int32, "a", lambda message: got.append(message.data), 10, content_filter_options=options("data > 0")
    )
    publisher = node.create_publisher(Int32, "a", 10)
    for number in range(4):
        publisher.publish(Int32(data=number))
    assert (
        subscription.has_next()
    )  # keeps the first one, and the filter accepts the others behind it meanwhile
    for _ in range(3):
        subscription.run(subscription.take())
    assert got == [1, 2, 3]


def test_a_flood_of_rejected_messages_holds_up_nobody(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(content_filter, "MAX_REJECTED", 5)
    got: list[int] = []
    qos = QoSProfile(depth=1000)
    subscription = node.create_subscription(
        Int32, "a", lambda message: got.append(message.data), qos, content_filter_options=options("data = 99")
    )
    publisher = node.create_publisher(Int32, "a", qos)
    for number in range(100):
        publisher.publish(Int32(data=number))
    assert subscription.take() is None  # after five
    executor.add_node(node)
    spin_until(lambda: got)
    assert got == [99]


def test_what_cannot_be_decoded_is_rejected_with_a_warning(
    node: Node, executor: SingleThreadedExecutor, spin_until: SpinUntil, capfd: pytest.CaptureFixture[str]
) -> None:
    got: list[Any] = []
    for raw in (False, True):
        node.create_subscription(
            Int32, "a", got.append, 10, raw=raw, content_filter_options=options("data <> 1")
        )
    publisher = node.create_publisher(Int32, "a", 10)
    executor.add_node(node)
    publisher.publish(b"\x00\x01\x00\x00\x05")
    publisher.publish(Int32(data=2))
    spin_until(lambda: len(got) == 2)
    assert {type(item) for item in got} == {Int32, bytes}
    assert "is not a valid std_msgs/msg/Int32" in capfd.readouterr().err


def test_messages_that_are_taken_without_an_executor(node: Node) -> None:
    subscription: Subscription[Int32] = node.create_subscription(
        Int32, "a", print, 10, content_filter_options=options("data > 5")
    )
    publisher = node.create_publisher(Int32, "a", 10)
    for number in (1, 6, 2, 7):
        publisher.publish(Int32(data=number))
    assert subscription.has_next()
    taken = [subscription.handle.take_message(Int32, raw) for raw in (False, True, False)]
    assert taken[0] is not None
    assert taken[0][0] == Int32(data=6)
    assert taken[1] is not None
    assert taken[1][0][4:5] == b"\x07"
    assert taken[2] is None


def test_waiting_for_a_message_ignores_filters_of_others(node: Node) -> None:
    latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    node.create_publisher(Int32, "a", latched).publish(Int32(data=1))
    node.create_subscription(Int32, "a", print, latched, content_filter_options=options("data > 5"))
    assert wait_for_message(Int32, node, "a", qos_profile=latched, time_to_wait=5) == (True, Int32(data=1))


def test_events_of_some_nodes_alone(
    node: Node, make_node: Callable[..., Node], executor: SingleThreadedExecutor, spin_until: SpinUntil
) -> None:
    near, far = make_node("near"), make_node("far", namespace="/away")
    handler = ParameterEventHandler(node)
    got: list[tuple[str, str]] = []
    handler.add_parameter_event_callback(lambda event: got.append((event.node, event.new_parameters[0].name)))
    executor.add_node(node)
    assert handler.configure_nodes_filter(["near", "/away/nobody"])
    near.declare_parameter("a", 1)
    far.declare_parameter("b", 1)
    near.declare_parameter("c", 1)
    spin_until(lambda: len(got) == 2)
    assert got == [("/near", "a"), ("/near", "c")]
    with pytest.raises(RCLError, match="maximum of expression parameters"):
        handler.configure_nodes_filter([f"n{number}" for number in range(101)])
    for wrong in ("near", [3]):
        with pytest.raises(TypeError, match="needs a list of names of nodes"):
            handler.configure_nodes_filter(wrong)  # type: ignore[arg-type]
    nothing: list[list[str] | None] = [None, []]
    for none in nothing:
        assert handler.configure_nodes_filter(["near"])
        assert not handler.configure_nodes_filter(none)
    far.declare_parameter("d", 1)
    spin_until(lambda: len(got) == 3)
    assert got[2] == ("/away/far", "d")


@pytest.mark.parametrize("is_optimised", [False, True])
def test_feedback_of_other_clients_is_dropped_by_its_id(
    is_optimised: bool,
    make_node: Callable[..., Node],
    executor: SingleThreadedExecutor,
    finish: Callable[[Any], Any],
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    node = make_node()

    def execute(handle: Any) -> Fibonacci.Result:
        handle.publish_feedback(Fibonacci.Feedback(sequence=[handle.request.order]))
        handle.succeed()
        return Fibonacci.Result()

    ActionServer(node, Fibonacci, "count", execute)
    client = ActionClient(node, Fibonacci, "count", enable_feedback_msg_optimization=is_optimised)
    other = ActionClient(node, Fibonacci, "count")
    decoded: list[Any] = []
    message = client._feedback._message

    def noting(sample: Any) -> Any:
        decoded.append(sample)
        return message(sample)

    monkeypatch.setattr(client._feedback, "_message", noting)
    executor.add_node(node)
    got: dict[Any, list[int]] = {client: [], other: []}
    for sender, order in ((other, 1), (client, 2), (other, 3)):

        def note(feedback: Any, orders: list[int] = got[sender]) -> None:
            orders.extend(feedback.feedback.sequence)

        goal = finish(sender.send_goal_async(Fibonacci.Goal(order=order), note))
        finish(goal.get_result_async())
    executor.spin_once(timeout_sec=0)
    assert got == {client: [2], other: [1, 3]}
    assert len(decoded) == (1 if is_optimised else 3)


def test_writers_are_told_of_what_they_filter_alike(node: Node, monkeypatch: pytest.MonkeyPatch) -> None:
    """A pattern and a `wstring` mean something else to them: they are told to send all."""
    told: list[tuple[str, list[str]]] = []
    monkeypatch.setattr(
        LocalReader,
        "announce_filter",
        lambda _, expression, parameters: told.append((expression, parameters)),
    )
    subscription = node.create_subscription(String, "words", print, 10)
    subscription.set_content_filter("data LIKE 'a%'", [])
    assert told == []
    subscription.set_content_filter("data = %0", ["'a'"])
    assert told == [("data = %0", ["'a'"])]
    subscription.set_content_filter("data = 'b' OR data LIKE 'a%'", [])
    assert told[1:] == [("", [])]
    subscription.set_content_filter("data = 'b'", [])
    subscription.set_content_filter("", [])
    assert told[2:] == [("data = 'b'", []), ("", [])]
    told.clear()
    with pytest.raises(RCLError):
        subscription.set_content_filter("data =", [])
    assert told == []
    node.create_subscription(
        String, "other", print, 10, content_filter_options=ContentFilterOptions("data <> 'a'", [])
    )
    assert told == [("data <> 'a'", [])]
    assert not ContentFilter(WString, ContentFilterOptions("data = 'a'", [])).is_announced


@pytest.mark.parametrize("parameters", [None, "5", 5, [5], {"5"}])
def test_parameters_that_are_no_list_of_texts(node: Node, parameters: Any) -> None:
    with pytest.raises(TypeError, match="expression parameters must be a list of str, got "):
        node.create_subscription(
            String, "words", print, 10, content_filter_options=ContentFilterOptions("data = %0", parameters)
        )


@pytest.mark.wire
def test_filters_are_announced_on_dds_until_the_reader_is_closed(domain_id: int) -> None:
    """Another participant sees each announcement; no sample is kept from a writer that can't filter."""
    context, other = Context(), Context()
    context.init(args=[], domain_id=domain_id)
    other.init(args=[], domain_id=domain_id)
    try:
        node, peer = Node("filtering", context=context), Node("publishing", context=other)
        subscription = node.create_subscription(
            Int32, "numbers", lambda message: got.append(message.data), 10
        )
        publisher = peer.create_publisher(Int32, "numbers", 10)
        got: list[int] = []
        wait_until(lambda: publisher.get_subscription_count() == 1)
        with SingleThreadedExecutor(context=context) as executor:
            executor.add_node(node)
            for first, expression, expected in (
                (0, "data > 5", [6, 7]),
                (10, "data BETWEEN 10 AND 12 OR data = 17", [10, 11, 12, 17]),
                (20, "", list(range(20, 28))),
            ):
                subscription.set_content_filter(expression, [])
                for number in range(first, first + 8):
                    publisher.publish(Int32(data=number))
                end = time.monotonic() + 10.0
                while not got or got[-1] != expected[-1]:
                    assert time.monotonic() < end
                    executor.spin_once(0.05)
                assert [number for number in got if number >= first] == expected
        (info,) = peer.get_subscriptions_info_by_topic("/numbers")
        assert info.node_name == "filtering"
        subscription.set_content_filter("data > 5", [])
        reader = subscription._endpoint
        subscription.destroy()
        reader.announce_filter("data > 6", [])  # after its end: nothing happens
    finally:
        context.try_shutdown()
        other.try_shutdown()

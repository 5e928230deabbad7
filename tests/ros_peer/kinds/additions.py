"""Small programs for what Kilted has added, and what Jazzy's updates have that Kilted's wheel has, too."""

from __future__ import annotations

import math
import threading
from typing import Any

from tests.ros_peer.programs.stage import Stage, outcome, result_of, until

RELEASES = ("kilted",)
DEFINITIONS = True
WIRE = "rmw_cyclonedds_cpp"
SECONDS = 60.0


def sums_of_durations() -> Any:
    """Add, subtract and multiply durations."""
    from rclpy.duration import Duration

    long, short = Duration(seconds=3), Duration(seconds=0, nanoseconds=500)
    cases = {
        "sum": lambda: long + short,
        "difference": lambda: short - long,
        "times": lambda: long * 3,
        "half": lambda: long * 0.5,
        "negative": lambda: short * -2,
        "infinite": lambda: long * math.inf,
        "minus infinite": lambda: long * -math.inf,
        "nan": lambda: long * math.nan,
        "too long": lambda: long * 10**18,
        "with a number": lambda: long + 1,
        "by a duration": lambda: long * short,
        "from the left": lambda: 2 * long,
        "by a text": lambda: long * "2",
    }
    return {name: outcome(lambda case=case: str(case()))[0].partition(":")[0] for name, case in cases.items()}


def times_of_a_timers_call() -> Any:
    """Get the times of a timer's calls, and what is wrong in asking for them."""
    from rclpy.clock import ClockType
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.timer import TimerInfo

    got: list[Any] = []

    def annotated(info: TimerInfo) -> None:
        got.append(info)

    annotated.__annotations__["info"] = TimerInfo

    def unannotated(info) -> None:  # type: ignore[no-untyped-def]  # the case
        got.append(info)

    with Stage() as stage:
        node = stage.node("ticks", start_parameter_services=False)
        timer = node.create_timer(0.02, annotated)
        until(lambda: len(got) > 2)
        timer.cancel()
        ordered = [
            info.expected_call_time <= info.actual_call_time and type(info) is TimerInfo for info in got[:3]
        ]
        kinds = sorted({info.actual_call_time.clock_type.name for info in got[:3]})
    with Stage(spins=False) as stage, SingleThreadedExecutor(context=stage.context) as executor:
        node = stage.node("ticks", start_parameter_services=False)
        executor.add_node(node)
        node.create_timer(0.001, unannotated)
        error = outcome(lambda: until(lambda: executor.spin_once(timeout_sec=1.0)))[0]
    made = TimerInfo(expected_call_time=5, actual_call_time=7, clock_type=ClockType.STEADY_TIME)
    return [
        ordered,
        kinds,
        error.partition("() ")[0][:9],
        error.rpartition("() ")[2],
        [str(made.expected_call_time), str(made.actual_call_time)],
        outcome(lambda: TimerInfo(actual_call_time=-1)),
        outcome(lambda: TimerInfo(clock_type=1)),
    ]


def quality_of_the_log() -> Any:
    """Give nodes a quality of service for /rosout, as a profile and as a depth."""
    from rclpy.qos import DurabilityPolicy, QoSPresetProfiles, QoSProfile, qos_profile_rosout_default

    given = {
        "first": QoSProfile(depth=3, durability=DurabilityPolicy.VOLATILE),
        "second": 7,
        "third": QoSPresetProfiles.ROSOUT_DEFAULT.value,
    }
    names = ("reliability", "durability", "lifespan", "liveliness")
    with Stage() as stage:
        for name, profile in given.items():
            node = stage.node(name, rosout_qos_profile=profile, start_parameter_services=False)
        until(lambda: node.count_publishers("/rosout") == len(given))
        listed = sorted(
            [info.node_name, *(str(getattr(info.qos_profile, name)) for name in names)]
            for info in node.get_publishers_info_by_topic("/rosout")
        )
        default = qos_profile_rosout_default
        return [
            listed,
            [str(default.depth), str(default.history), *(str(getattr(default, name)) for name in names)],
            outcome(lambda: stage.node("wrong", rosout_qos_profile="best"))[0].partition(":")[0],
        ]


def events_of_an_action() -> Any:
    """Publish the service events of an action's client and server."""
    from rclpy.action import ActionClient, ActionServer
    from rclpy.qos import qos_profile_system_default
    from rclpy.service_introspection import ServiceIntrospectionState
    from service_msgs.msg import ServiceEventInfo
    from test_msgs.action import Fibonacci

    def execute(goal: Any) -> Any:
        goal.succeed()
        return Fibonacci.Result(sequence=[5])

    services = {"send_goal": "SendGoalService", "get_result": "GetResultService"}
    with Stage() as stage:
        node = stage.node("acts", start_parameter_services=False)
        listener = stage.node("listens", start_parameter_services=False)
        server = ActionServer(node, Fibonacci, "numbers", execute)
        client = ActionClient(listener, Fibonacci, "numbers")
        heard: dict[str, list[Any]] = {name: [] for name in services}
        for name, service in services.items():
            listener.create_subscription(
                getattr(Fibonacci.Impl, service).Event,
                f"/numbers/_action/{name}/_service_event",
                heard[name].append,
                10,
            )
        server.configure_introspection(
            node.get_clock(), qos_profile_system_default, ServiceIntrospectionState.CONTENTS
        )
        client.configure_introspection(
            listener.get_clock(), qos_profile_system_default, ServiceIntrospectionState.METADATA
        )
        assert client.wait_for_server(10.0)
        for name in heard:
            until(lambda name=name: node.count_publishers(f"/numbers/_action/{name}/_service_event") == 2)
            until(lambda name=name: node.count_subscribers(f"/numbers/_action/{name}/_service_event") == 1)
        goal = result_of(client.send_goal_async(Fibonacci.Goal(order=4)))
        result_of(goal.get_result_async())
        until(lambda: all(len(events) == 4 for events in heard.values()))
        client.configure_introspection(
            listener.get_clock(), qos_profile_system_default, ServiceIntrospectionState.OFF
        )
        server.configure_introspection(
            node.get_clock(), qos_profile_system_default, ServiceIntrospectionState.OFF
        )
        result_of(client.send_goal_async(Fibonacci.Goal(order=4)))
        names = {
            value: name
            for name, value in vars(type(ServiceEventInfo)).get("_TypeSupport", {}).items()
            if isinstance(value, int)
        } or {
            getattr(ServiceEventInfo, name): name
            for name in ("REQUEST_SENT", "REQUEST_RECEIVED", "RESPONSE_SENT", "RESPONSE_RECEIVED")
        }
        goals = [list(event.request[0].goal_id.uuid) for event in heard["send_goal"] if event.request]
        return [
            {
                name: sorted(
                    [names[event.info.event_type], len(event.request), len(event.response)]
                    for event in events
                )
                for name, events in heard.items()
            },
            [event.request[0].goal.order for event in heard["send_goal"] if event.request],
            [list(event.response[0].result.sequence) for event in heard["get_result"] if event.response],
            goals == [list(goal.goal_id.uuid)],
        ]


def messages_that_a_filter_accepts() -> Any:
    """Filter the messages of a topic, by several expressions one after the other."""
    from rclpy.subscription_content_filter_options import ContentFilterOptions
    from std_msgs.msg import Int32

    with Stage() as stage:
        node = stage.node("talks", start_parameter_services=False)
        listener = stage.node("listens", start_parameter_services=False)
        publisher = node.create_publisher(Int32, "numbers", 50)
        heard: list[int] = []
        control: list[int] = []
        subscription = listener.create_subscription(
            Int32,
            "numbers",
            lambda message: heard.append(message.data),
            50,
            content_filter_options=ContentFilterOptions("data > %0", ["5"]),
        )
        listener.create_subscription(Int32, "numbers", lambda message: control.append(message.data), 50)
        until(lambda: publisher.get_subscription_count() == 2)

        def accepted(*change: Any) -> list[int]:
            if change:
                subscription.set_content_filter(*change)
            heard.clear()
            control.clear()
            for number in range(10):
                publisher.publish(Int32(data=number))
            until(lambda: len(control) == 10)
            publisher.publish(Int32(data=1000))  # which each of the filters accepts
            # In both, because one that comes later would be counted among the next ten.
            until(lambda: 1000 in heard and 1000 in control)
            return sorted(heard)

        answers = [accepted()]
        for change in (
            ("data < %0 OR data = 1000", ["3"]),
            ("data BETWEEN %0 AND %1 OR data >= 9", ["2", "4"]),
            ("NOT (data <> 7 AND data <= 999)", []),
            ("data = %1 OR data = %0", ["1000", "6"]),
        ):
            answers.append(accepted(*change))
            answers.append([subscription.is_cft_enabled, *subscription.get_content_filter()])
        answers += [accepted("", []), subscription.is_cft_enabled]
        return [*answers, outcome(subscription.get_content_filter)[0].partition(":")[0]]


def filters_that_are_wrong() -> Any:
    """Set filters with mistakes, and look at what stays."""
    from rclpy.subscription_content_filter_options import ContentFilterOptions
    from std_msgs.msg import String

    with Stage() as stage:
        node = stage.node("listens", start_parameter_services=False)
        plain = node.create_subscription(String, "texts", print, 1)
        filtered = node.create_subscription(
            String,
            "texts",
            print,
            1,
            content_filter_options=ContentFilterOptions(
                filter_expression="data LIKE %0", expression_parameters=["'a%'"]
            ),
        )
        answers: list[Any] = [plain.is_cft_enabled, filtered.is_cft_enabled, filtered.get_content_filter()]
        for change in (("nothing = 1", []), ("data =", []), ("data = %5", [])):
            error = outcome(lambda change=change: filtered.set_content_filter(*change))[0]
            answers.append(str(error).partition(":")[0])
        wrong = ContentFilterOptions("(", [])
        error = outcome(
            lambda: node.create_subscription(String, "texts", print, 1, content_filter_options=wrong)
        )[0]
        answers.append(str(error).partition(":")[0])
        return [*answers, filtered.is_cft_enabled, list(filtered.get_content_filter())]


def blocks_that_end_things() -> Any:
    """Use nodes, their ends, and a context in `with`."""
    import rclpy
    from rclpy.executors import SingleThreadedExecutor
    from std_msgs.msg import String
    from std_srvs.srv import Empty

    def after(call: Any) -> str:
        try:
            return str(call())
        except Exception as error:  # noqa: BLE001  # its class is the answer
            return type(error).__name__

    answers: list[Any] = []
    with rclpy.init(args=[]) as initialised:
        context = initialised.context
        answers += [
            type(initialised).__name__,
            context.ok(),
            rclpy.ok(),
            rclpy.get_default_context() is context,
        ]
        with rclpy.create_node("within") as node:
            with node.create_publisher(String, "texts", 1) as publisher:
                publisher.publish(String(data="text"))
                answers.append(publisher.topic_name)
            with node.create_subscription(String, "texts", print, 1) as subscription:
                answers.append(subscription.topic_name)
            with node.create_client(Empty, "empty") as client:
                answers.append(client.service_is_ready())
            with node.create_service(Empty, "empty", lambda _, response: response) as service:
                answers.append(service.service_name)
            with node.create_timer(10.0, print) as timer:
                answers.append(timer.is_canceled())
            with SingleThreadedExecutor() as executor:
                answers += [executor.add_node(node), len(executor.get_nodes())]
        answers += [
            after(lambda: publisher.publish(String())),
            after(lambda: subscription.topic_name),
            after(client.service_is_ready),
            after(lambda: service.service_name),
            after(timer.is_canceled),
            after(lambda: node.count_publishers("texts")),
        ]
    answers += [context.ok(), rclpy.ok(), outcome(rclpy.try_shutdown)[0]]
    return [*answers, outcome(rclpy.shutdown)[0]]


def types_of_parameters() -> Any:
    """Use the types of parameters as numbers, which Kilted allows."""
    from rcl_interfaces.msg import ParameterType
    from rclpy.parameter import Parameter

    kinds = Parameter.Type
    parameter: Any = Parameter("speed", value=[1.5])
    return {
        "equal": [
            kinds.INTEGER == 2,
            kinds(8) is kinds.DOUBLE_ARRAY,
            ParameterType.PARAMETER_STRING == kinds.STRING,
        ],
        "order": [kinds.BOOL < kinds.STRING, min([kinds.STRING, kinds.NOT_SET]).name],
        "number": [int(kinds.BYTE_ARRAY), {2: "two"}[kinds.INTEGER]],
        "message": [parameter.to_parameter_msg().value.type, parameter.type_.name, repr(kinds.BOOL)],
        "from a value": [
            kinds.from_parameter_value(value).name for value in (1, 1.0, "1", [], True, None, [b"1"])
        ],
        "wrong": outcome(lambda: kinds(99))[0],
    }


def facts_of_a_message() -> Any:
    """Take the facts about messages beside them."""
    from rclpy.subscription import MessageInfo
    from std_msgs.msg import Int32

    with Stage() as stage:
        node = stage.node("talks", start_parameter_services=False)
        publisher = node.create_publisher(Int32, "numbers", 10)
        heard: list[Any] = []
        node.create_subscription(
            Int32, "numbers", lambda message, info: heard.append((message.data, info)), 10
        )
        until(lambda: publisher.get_subscription_count() == 1)
        before = node.get_clock().now().nanoseconds
        for number in range(3):
            publisher.publish(Int32(data=number))
        until(lambda: len(heard) == 3)
        after = node.get_clock().now().nanoseconds
        names = ("source_timestamp", "received_timestamp")
        return [
            sorted(MessageInfo.__annotations__),
            [number for number, _ in heard],
            [type(info).__name__ for _, info in heard],
            [sorted(name for name in info if name != "publisher_gid") for _, info in heard],
            [all(before <= info[name] <= after for name in names) for _, info in heard],
        ]


def threads_of_an_executor() -> Any:
    """Shut down an executor of several threads with and without waiting for its work."""
    from rclpy.executors import MultiThreadedExecutor

    answers: list[Any] = []
    for waits in (True, False):
        with Stage(spins=False) as stage:
            node = stage.node("works", start_parameter_services=False)
            executor = MultiThreadedExecutor(2, context=stage.context)
            executor.add_node(node)
            begun, free = threading.Event(), threading.Event()

            def work(begun: Any = begun, free: Any = free) -> None:
                begun.set()
                free.wait(10.0)

            node.create_timer(0.001, work)
            thread = threading.Thread(target=executor.spin, daemon=True)
            thread.start()
            assert begun.wait(10.0)
            threading.Timer(0.6, free.set).start()
            is_shut = executor.shutdown(timeout_sec=10.0, wait_for_threads=waits)
            answers.append([waits, is_shut, free.is_set()])
            free.set()
            thread.join(10.0)
    return answers


def publisher_of_a_lifecycle_node() -> Any:
    """Create a managed publisher with Kilted's keywords, and publish through it in each state."""
    from rclpy.lifecycle import LifecycleNode
    from std_msgs.msg import String

    with Stage() as stage:
        node = stage.node("managed", LifecycleNode)
        listener = stage.node("listens", start_parameter_services=False)
        publisher = node.create_lifecycle_publisher(msg_type=String, topic="texts", qos_profile=10)
        heard: list[str] = []
        listener.create_subscription(String, "texts", lambda message: heard.append(message.data), 10)
        until(lambda: publisher.get_subscription_count() == 1)
        answers: list[Any] = [publisher.is_activated]
        publisher.publish(String(data="inactive"))
        node.trigger_configure()
        node.trigger_activate()
        answers.append(publisher.is_activated)
        publisher.publish(String(data="active"))
        until(lambda: heard)
        node.trigger_deactivate()
        answers.append(publisher.is_activated)
        return [*answers, heard, outcome(lambda: node.destroy_lifecycle_publisher(publisher))[0]]


def names_for_type_checkers() -> Any:
    """Use the names that annotations of newer programs have, at run time."""
    from rclpy import type_support
    from rclpy.action import ActionClient, ActionServer
    from rclpy.client import Client
    from rclpy.parameter import Parameter
    from rclpy.publisher import Publisher
    from rclpy.service import Service
    from rclpy.subscription import Subscription
    from rclpy.task import Future, Task
    from std_msgs.msg import String
    from std_srvs.srv import Empty
    from test_msgs.action import Fibonacci

    generic = [
        Publisher[String],
        Subscription[String],
        Client[Empty.Request, Empty.Response],
        Service[Empty.Request, Empty.Response],
        ActionClient[Fibonacci.Goal, Fibonacci.Result, Fibonacci.Feedback],
        Future[int],
        Task[int],
        Parameter[float],
    ]
    protocols = (
        "Msg",
        "Srv",
        "Action",
        "EventMessage",
        "FeedbackMessage",
        "SendGoalService",
        "GetResultService",
    )
    variables = ("MsgT", "SrvT", "SrvRequestT", "SrvResponseT", "ActionT", "GoalT", "ResultT", "FeedbackT")
    return [
        [isinstance(getattr(type_support, name), type) for name in protocols],
        [str(getattr(type_support, name)) for name in variables],
        [each.__origin__.__name__ for each in generic],
        outcome(lambda: Publisher[String].__origin__ is Publisher)[0],  # type: ignore[attr-defined]
        outcome(lambda: type_support.check_is_valid_msg_type(String))[0],
        outcome(lambda: type_support.check_is_valid_srv_type(Empty))[0],
        [ActionServer.__name__, type(Future[int]()).__name__],
    ]


def explains_end(case: Any, theirs: Any, ours: Any) -> bool:
    """Return whether the answers differ only in that work is waited for without its threads, too."""
    return bool(
        case == "threads_of_an_executor"
        and theirs[1] == [False, True, False]
        and ours == [theirs[0], [False, True, True]]
    )


KNOWN = {"node-executor-end": explains_end}
PROGRAMS = [
    sums_of_durations,
    times_of_a_timers_call,
    quality_of_the_log,
    events_of_an_action,
    messages_that_a_filter_accepts,
    filters_that_are_wrong,
    blocks_that_end_things,
    types_of_parameters,
    facts_of_a_message,
    threads_of_an_executor,
    publisher_of_a_lifecycle_node,
    names_for_type_checkers,
]
EVERY = [program.__name__ for program in PROGRAMS]


def run(case: str) -> Any:
    """Run a program by its name."""
    return globals()[case]()

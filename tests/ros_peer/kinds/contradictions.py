"""Small programs for what Kilted does otherwise than Jazzy, or what a program for both sees of it.

They are run beside each release, which tfloom follows there: `docs/distributions.md`.
"""

from __future__ import annotations

import tempfile
import threading
from pathlib import Path
from typing import Any

from tests.ros_peer.programs.stage import Stage, outcome, result_of, until

RELEASES = ("jazzy", "kilted")
DEFINITIONS = True
WIRE = "rmw_cyclonedds_cpp"
SECONDS = 60.0


def call_that_takes_too_long() -> Any:
    """Call a service that answers late, with and without the time for it."""
    from rclpy.callback_groups import ReentrantCallbackGroup
    from std_srvs.srv import Trigger

    free = threading.Event()
    with Stage() as stage:
        node = stage.node("asks", start_parameter_services=False)
        group = ReentrantCallbackGroup()

        def serve(_: Any, response: Any) -> Any:
            free.wait(10.0)
            response.message = "late"
            return response

        node.create_service(Trigger, "late", serve, callback_group=group)
        client = node.create_client(Trigger, "late", callback_group=group)
        assert client.wait_for_service(10.0)
        first = outcome(lambda: client.call(Trigger.Request(), timeout_sec=0.2))
        free.set()
        return [first, outcome(lambda: client.call(Trigger.Request(), timeout_sec=10.0).message)]


def result_that_was_kept() -> Any:
    """Ask for the result of a goal that ended a minute of simulated time ago."""
    from rclpy.action import ActionClient, ActionServer
    from rclpy.parameter import Parameter
    from rclpy.time import Time
    from rosgraph_msgs.msg import Clock
    from test_msgs.action import Fibonacci

    def execute(goal: Any) -> Any:
        goal.succeed()
        return Fibonacci.Result(sequence=[1, 2, 3])

    with Stage() as stage:
        simulation = stage.node("simulation", start_parameter_services=False)
        simulated = [Parameter("use_sim_time", value=True)]
        node = stage.node("serves", parameter_overrides=simulated, start_parameter_services=False)
        clock = simulation.create_publisher(Clock, "/clock", 10)
        ActionServer(node, Fibonacci, "numbers", execute)
        client = ActionClient(simulation, Fibonacci, "numbers")
        assert client.wait_for_server(10.0)

        def set_time(seconds: int) -> None:
            def is_set() -> bool:
                clock.publish(Clock(clock=Time(seconds=seconds).to_msg()))
                return node.get_clock().now().nanoseconds == seconds * 10**9

            until(is_set)

        set_time(100)
        goal = result_of(client.send_goal_async(Fibonacci.Goal(order=3)))
        answers = []
        for seconds in (100, 105, 160, 2000):
            set_time(seconds)
            # The server drops results beside its other work, so that the answer may still be the old one.
            for _ in range(30 if seconds > 105 else 1):
                answer = result_of(goal.get_result_async())
                if answer.status == 0:
                    break
            answers.append([seconds, answer.status, list(answer.result.sequence)])
        return answers


def parameter_with_only_a_name() -> Any:
    """Declare parameters by their names alone."""
    with Stage() as stage:
        node = stage.node("declares", start_parameter_services=False)
        return [
            outcome(lambda: node.declare_parameter("alone").value),
            outcome(lambda: [each.value for each in node.declare_parameters("many", [("one",), ("two", 2)])]),
            outcome(lambda: node.declare_parameter("alone")),
            node.has_parameter("many.two"),
        ]


def old_name_of_a_warning() -> Any:
    """Log by `warn`, as many programs do."""
    from rcl_interfaces.msg import Log

    with Stage() as stage:
        node = stage.node("logs", start_parameter_services=False)
        listener = stage.node("listens", start_parameter_services=False)
        texts: list[Any] = []
        listener.create_subscription(Log, "/rosout", lambda log: texts.append([log.msg, log.level]), 100)
        until(lambda: node.count_subscribers("/rosout") == 1)
        answers = [
            outcome(lambda: node.get_logger().warn("by warn")),
            outcome(lambda: node.get_logger().warning("by warning")),
        ]

        def heard() -> list[Any]:
            node.get_logger().warning("again")
            return [text for text in texts if text[0] == "again"]

        until(heard)
        return [answers, sorted(text for text in texts if text[0] == "by warn")]


def context_without_init() -> Any:
    """Enter contexts before and after their `init`."""
    from rclpy.context import Context

    def enter(is_ready: bool) -> Any:
        context = Context()
        if is_ready:
            context.init([])
        with context as entered:
            inside = entered is context and entered.ok()
        return [inside, context.ok()]

    return [outcome(lambda: enter(False)), outcome(lambda: enter(True))]


def feedback_while_canceling() -> Any:
    """Publish feedback of a goal that is being canceled."""
    from rclpy.action import ActionClient, ActionServer, CancelResponse
    from rclpy.callback_groups import ReentrantCallbackGroup
    from test_msgs.action import Fibonacci

    canceled = threading.Event()

    def execute(goal: Any) -> Any:
        goal.publish_feedback(Fibonacci.Feedback(sequence=[1]))
        until(lambda: goal.is_cancel_requested)
        goal.publish_feedback(Fibonacci.Feedback(sequence=[1, 2]))
        canceled.wait(10.0)
        goal.canceled()
        return Fibonacci.Result(sequence=[3])

    with Stage() as stage:
        node = stage.node("acts", start_parameter_services=False)
        group = ReentrantCallbackGroup()
        ActionServer(
            node,
            Fibonacci,
            "numbers",
            execute,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
            callback_group=group,
        )
        client = ActionClient(node, Fibonacci, "numbers", callback_group=group)
        assert client.wait_for_server(10.0)
        heard: list[Any] = []
        goal = result_of(
            client.send_goal_async(Fibonacci.Goal(), lambda each: heard.append(list(each.feedback.sequence)))
        )
        until(lambda: heard)
        answer = result_of(goal.cancel_goal_async())
        until(lambda: len(heard) == 2)
        canceled.set()
        result = result_of(goal.get_result_async())
        return [heard, len(answer.goals_canceling), result.status, list(result.result.sequence)]


def events_of_a_lifecycle_node() -> Any:
    """Listen to the transitions of a lifecycle node, and to their times."""
    from lifecycle_msgs.msg import TransitionEvent
    from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn

    class Managed(LifecycleNode):
        def on_activate(self, state: Any) -> Any:
            return TransitionCallbackReturn.FAILURE

    with Stage() as stage:
        listener = stage.node("listens", start_parameter_services=False)
        managed = stage.node("managed", Managed)
        events: list[Any] = []
        listener.create_subscription(TransitionEvent, "/managed/transition_event", events.append, 10)
        until(lambda: managed.count_subscribers("/managed/transition_event") == 1)
        results = [
            getattr(managed, f"trigger_{name}")().name for name in ("configure", "activate", "cleanup")
        ]
        until(lambda: len(events) == 6)
        return [
            TransitionEvent.get_fields_and_field_types(),
            results,
            [
                [event.timestamp, event.transition.label, event.start_state.label, event.goal_state.label]
                for event in events
            ],
        ]


def numbers_of_a_file_of_parameters() -> Any:
    """Read numbers with tags, and patterns of nodes, from a file of parameters."""
    text = """
/**:
  ros__parameters: {tagged: !!float 10, plain: 10, text: !!str 10, hexadecimal: !!float 0x10, of_all: 1}
/*/reads:
  ros__parameters: {of_all: 2}
/here/reads:
  ros__parameters: {of_one: [1.0, 2.5]}
"""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "parameters.yaml"
        path.write_text(text)
        with Stage("--ros-args", "--params-file", str(path)) as stage:
            node = stage.node(
                "reads",
                namespace="/here",
                automatically_declare_parameters_from_overrides=True,
                start_parameter_services=False,
            )
            return {
                name: [parameter.type_.name, str(parameter.value)]
                for name, parameter in node.get_parameters_by_prefix("").items()
                if name in {"tagged", "plain", "text", "hexadecimal", "of_all", "of_one"}
            }


def states_of_a_goal() -> Any:
    """Listen to the status of goals, one of which is rejected."""
    from action_msgs.msg import GoalStatusArray
    from rclpy.action import ActionClient, ActionServer, GoalResponse
    from rclpy.qos import DurabilityPolicy, QoSProfile
    from test_msgs.action import Fibonacci

    # With the default depth, which is 1, a state may be replaced by the next one before it is taken.
    quality = QoSProfile(depth=10, durability=DurabilityPolicy.TRANSIENT_LOCAL)
    free = threading.Event()

    def execute(goal: Any) -> Any:
        free.wait(10.0)
        goal.succeed()
        return Fibonacci.Result()

    def decide(request: Any) -> Any:
        return GoalResponse.ACCEPT if request.order > 0 else GoalResponse.REJECT

    with Stage() as stage:
        node = stage.node("acts", start_parameter_services=False)
        listener = stage.node("listens", start_parameter_services=False)
        ActionServer(
            node, Fibonacci, "numbers", execute, goal_callback=decide, status_pub_qos_profile=quality
        )
        client = ActionClient(listener, Fibonacci, "numbers")
        states: list[int] = []

        def hear(message: Any) -> None:
            states.extend(status.status for status in message.status_list)

        listener.create_subscription(GoalStatusArray, "/numbers/_action/status", hear, quality)
        assert client.wait_for_server(10.0)
        until(lambda: node.count_subscribers("/numbers/_action/status") == 2)
        refused = result_of(client.send_goal_async(Fibonacci.Goal(order=0)))
        goal = result_of(client.send_goal_async(Fibonacci.Goal(order=1)))
        until(lambda: states)
        free.set()
        result = result_of(goal.get_result_async())
        until(lambda: 4 in states)
        return [refused.accepted, goal.accepted, result.status, states[0], states[-1], sorted({*states})]


def goal_of_another_class() -> Any:
    """Send a goal of another class, and a request and a message of one."""
    from rclpy.action import ActionClient
    from std_msgs.msg import String
    from std_srvs.srv import Empty, Trigger
    from test_msgs.action import Fibonacci

    with Stage() as stage:
        node = stage.node("mistakes", start_parameter_services=False)
        action = ActionClient(node, Fibonacci, "numbers")
        client = node.create_client(Trigger, "trigger")
        publisher = node.create_publisher(String, "texts", 1)
        calls = (
            lambda: action.send_goal_async(Fibonacci.Result()),
            lambda: client.call_async(Empty.Request()),
            lambda: publisher.publish(Trigger.Request()),
        )
        return [outcome(call)[0].partition(":")[0] for call in calls]


def defaults_of_the_log() -> Any:
    """Look up with which quality of service a node logs, and what of its parameters it announces."""
    with Stage() as stage:
        node = stage.node("logs")
        until(lambda: node.count_publishers("/rosout") == 1)
        return {
            topic: [
                str(getattr(info.qos_profile, name))
                for info in node.get_publishers_info_by_topic(topic)
                for name in ("reliability", "durability", "lifespan", "deadline", "liveliness")
            ]
            for topic in ("/rosout", "/parameter_events")
        }


def explains_entered(case: Any, theirs: Any, ours: Any) -> bool:
    """Return whether the answers differ only in that Jazzy refuses to enter a context that was initialised."""
    if case != "context_without_init":
        return False
    expected = [theirs[0], ["RuntimeError: Context.init() must only be called once", []]]
    return bool(theirs == expected and ours == [theirs[0], [[True, False], []]])


def explains_events(case: Any, theirs: Any, ours: Any) -> bool:
    """Return whether the answers differ only in times and names of transitions, which the reference leaves out."""
    if case != "events_of_a_lifecycle_node" or not all(event[0] > 0 and event[1] for event in ours[2]):
        return False
    return bool([*ours[:2], [[0, "", *event[2:]] for event in ours[2]]] == theirs)


KNOWN = {"node-entered-context": explains_entered, "lifecycle-event-fields": explains_events}
PROGRAMS = [
    call_that_takes_too_long,
    result_that_was_kept,
    parameter_with_only_a_name,
    old_name_of_a_warning,
    context_without_init,
    feedback_while_canceling,
    events_of_a_lifecycle_node,
    numbers_of_a_file_of_parameters,
    states_of_a_goal,
    goal_of_another_class,
    defaults_of_the_log,
]
EVERY = [program.__name__ for program in PROGRAMS]


def run(case: str) -> Any:
    """Run a program by its name."""
    return globals()[case]()

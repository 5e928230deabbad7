"""Small programs for what Lyrical, and Jazzy's last updates, have added; `newest.py NAME …` prints their answers.

They use only ROS's names, as a user's. No such release can be installed here, so the test has the answers.
"""

from __future__ import annotations

import asyncio
import json
import os
import sys
import tempfile
import threading
import time
from datetime import datetime
from pathlib import Path
from typing import Any

sys.path.append(str(Path(__file__).parents[2]))
from tests.ros_peer.programs.stage import Stage, outcome, result_of, until


def plain(name: str, stage: Stage, **options: Any) -> Any:
    """Return a node without services of parameters."""
    return stage.node(name, start_parameter_services=False, **options)


# Lyrical


def node_of_asyncio() -> Any:
    """Talk, listen, serve, call and tick in one loop of asyncio, without an executor."""
    import rclpy
    from rclpy.experimental import AsyncNode
    from std_msgs.msg import String
    from std_srvs.srv import SetBool

    heard: list[str] = []
    ticks: list[str] = []

    async def serve(request: Any, response: Any) -> Any:
        await asyncio.sleep(0.01)
        response.success, response.message = request.data, "served"
        return response

    async def main() -> Any:
        async with AsyncNode("everything") as node:
            publisher = node.create_publisher(String, "texts", 10)
            node.create_subscription(String, "texts", lambda message: heard.append(message.data), 10)
            node.create_service(SetBool, "switch", serve)
            client = node.create_client(SetBool, "switch")
            node.create_timer(0.01, lambda info: ticks.append(type(info).__name__))
            await client.wait_for_service()
            await node.wait_for_node("everything")
            answers = await asyncio.gather(
                *(client.call(SetBool.Request(data=bool(i % 2))) for i in range(4))
            )
            while not heard or not ticks:
                publisher.publish(String(data="text"))
                await asyncio.sleep(0.02)
            return [[answer.success for answer in answers], answers[0].message, heard[0], ticks[0]]

    with rclpy.init(args=[]):
        return asyncio.run(main())


def mistakes_with_asyncio() -> Any:
    """Use nodes of asyncio after their end, twice at once, and with a timer's callback of two arguments."""
    import rclpy
    from rclpy.experimental import AsyncNode
    from std_msgs.msg import String
    from std_srvs.srv import Empty

    async def error_of(work: Any) -> str:
        try:
            result = work()
            if asyncio.iscoroutine(result):
                await result
        except Exception as error:  # noqa: BLE001  # it is the answer
            return f"{type(error).__name__}: {error}"
        return "nothing"

    async def main() -> Any:
        node = AsyncNode("mistakes")
        async with node:
            again = await error_of(node.run)
            callback = await error_of(lambda: node.create_timer(1.0, lambda a, b: None))
            clock = node.get_clock()
        node.destroy_node()
        return [
            again,
            callback,
            await error_of(node.__aenter__),
            await error_of(lambda: node.create_publisher(String, "texts", 1)),
            await error_of(lambda: node.create_subscription(String, "texts", print, 1)),
            await error_of(lambda: node.create_client(Empty, "empty")),
            await error_of(lambda: node.create_service(Empty, "empty", print)),
            await error_of(lambda: clock.sleep(0.01)),
        ]

    with rclpy.init(args=[]):
        return asyncio.run(main())


def sleeping_by_simulated_time() -> Any:
    """Sleep by a clock whose time is simulated, and that of another source."""
    import rclpy
    from rclpy.exceptions import TimeSourceChangedError
    from rclpy.experimental import AsyncNode
    from rclpy.parameter import Parameter
    from rclpy.time import Time
    from rosgraph_msgs.msg import Clock

    async def main() -> Any:
        async with AsyncNode("sleeps") as node, AsyncNode("simulation") as simulation:
            source = simulation.create_publisher(Clock, "/clock", 10)
            clock = node.get_clock()
            real = asyncio.create_task(clock.sleep(1000.0))
            await asyncio.sleep(0.05)
            node.set_parameters([Parameter("use_sim_time", value=True)])
            try:
                await real
                changed = "slept"
            except TimeSourceChangedError as error:
                changed = type(error).__name__

            async def until_time(seconds: int) -> None:
                while clock.now().nanoseconds != seconds * 10**9:
                    source.publish(Clock(clock=Time(seconds=seconds).to_msg()))
                    await asyncio.sleep(0.02)

            await until_time(100)
            simulated = asyncio.create_task(clock.sleep(50.0))
            await until_time(149)
            early = simulated.done()
            await until_time(151)
            await asyncio.wait_for(simulated, 10.0)
            return [changed, early, simulated.done()]

    with rclpy.init(args=[]):
        return asyncio.run(main())


def ends_of_a_service() -> Any:
    """Look up which nodes serve and call, and with which quality of service."""
    from rclpy.endpoint_info import EndpointTypeEnum, ServiceEndpointInfo
    from std_srvs.srv import Trigger

    with Stage() as stage:
        server, caller = plain("serves", stage), plain("calls", stage, namespace="/here")
        server.create_service(Trigger, "/trigger", lambda _, response: response)
        caller.create_client(Trigger, "/trigger")
        until(lambda: server.count_clients("/trigger") and caller.count_services("/trigger"))
        both = until(
            lambda: [
                *caller.get_servers_info_by_service("/trigger"),
                *server.get_clients_info_by_service("/trigger"),
            ]
        )
        return [
            [
                [
                    isinstance(info, ServiceEndpointInfo),
                    info.node_name,
                    info.node_namespace,
                    info.service_type,
                    info.endpoint_type.name,
                    info.endpoint_count,
                    len(info.endpoint_gids),
                    {profile.reliability.name for profile in info.qos_profiles} == {"RELIABLE"},
                ]
                for info in both
            ],
            {kind.name: kind.value for kind in EndpointTypeEnum},
        ]


def actions_of_the_graph() -> Any:
    """List actions by a node's own methods, and by the functions that these replace."""
    from example_interfaces.action import Fibonacci
    from rclpy.action import ActionClient, ActionServer, get_action_names_and_types

    with Stage() as stage:
        server, caller = plain("serves", stage), plain("calls", stage)
        ActionServer(server, Fibonacci, "numbers", print)
        ActionClient(caller, Fibonacci, "numbers").wait_for_server(10.0)
        until(lambda: server.get_action_client_names_and_types_by_node("calls", "/"))
        [value, warned] = outcome(lambda: get_action_names_and_types(caller))
        return [
            caller.get_action_names_and_types(),
            caller.get_action_server_names_and_types_by_node("serves", "/"),
            server.get_action_client_names_and_types_by_node("calls", "/"),
            server.get_action_server_names_and_types_by_node("calls", "/"),
            value == caller.get_action_names_and_types(),
            [text.partition(":")[0] for text in warned],
        ]


def dates_of_times() -> Any:
    """Turn times into dates of Python."""
    from rclpy.clock import ClockType
    from rclpy.time import Time

    date = Time(seconds=86400 * 365, nanoseconds=250_000_000).to_datetime()
    return [
        date == datetime.fromtimestamp(86400 * 365 + 0.25),  # noqa: DTZ006  # as the method has it
        date.tzinfo is None,
        Time(clock_type=ClockType.ROS_TIME).to_datetime().year in {1969, 1970},
        outcome(lambda: Time(clock_type=ClockType.STEADY_TIME).to_datetime())[0],
    ]


def parameters_with_tags() -> Any:
    """Read a file of parameters with tags, and declare parameters by their names alone."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "parameters.yaml"
        text = "{tagged: !!float 10, list: [!!float 1, !!float 2], octets: !!binary AAH/, text: !!str 10}"
        file.write_text(f"/**: {{ros__parameters: {text}}}\n")
        with Stage("--ros-args", "--params-file", str(file)) as stage:
            node = plain("reads", stage, automatically_declare_parameters_from_overrides=True)
            values = {
                name: [node.get_parameter(name).type_.name, str(node.get_parameter(name).value)]
                for name in ("tagged", "list", "octets", "text")
            }
            refusal = outcome(lambda: node.declare_parameter("alone"))
            return [values, refusal[0].partition(". You")[0], refusal[1], node.has_parameter("alone")]


def feedback_too_late() -> Any:
    """Publish feedback before a goal is executed, and while it is being canceled."""
    from example_interfaces.action import Fibonacci
    from rcl_interfaces.msg import Log
    from rclpy.action import ActionClient, ActionServer, CancelResponse
    from rclpy.callback_groups import ReentrantCallbackGroup

    goals: list[Any] = []
    free = threading.Event()

    def execute(goal: Any) -> Any:
        goal.publish_feedback(Fibonacci.Feedback(sequence=[1]))
        until(lambda: goal.is_cancel_requested)
        goal.publish_feedback(Fibonacci.Feedback(sequence=[1, 2]))
        free.wait(10.0)
        goal.canceled()
        return Fibonacci.Result()

    def accept(goal: Any) -> None:
        goal.publish_feedback(Fibonacci.Feedback(sequence=[0]))
        goals.append(goal)
        goal.execute()

    with Stage() as stage:
        node, listener = plain("acts", stage), plain("listens", stage)
        ActionServer(
            node,
            Fibonacci,
            "numbers",
            execute,
            handle_accepted_callback=accept,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
            callback_group=ReentrantCallbackGroup(),
        )
        logged: list[str] = []
        listener.create_subscription(Log, "/rosout", lambda log: logged.append(log.msg), 100)
        client = ActionClient(listener, Fibonacci, "numbers")
        assert client.wait_for_server(10.0)
        until(lambda: node.count_subscribers("/rosout") == 1)
        heard: list[Any] = []
        sent = client.send_goal_async(
            Fibonacci.Goal(), lambda message: heard.append(list(message.feedback.sequence))
        )
        goal = result_of(sent)
        until(lambda: heard)
        result_of(goal.cancel_goal_async())
        until(lambda: len([text for text in logged if "publish_feedback" in text]) == 2)
        free.set()
        status = result_of(goal.get_result_async()).status
        return [heard, status, sorted({text for text in logged if "publish_feedback" in text})]


def events_of_some_nodes() -> Any:
    """Listen to the changes of parameters of one node alone, and then of all."""
    from rclpy.parameter_event_handler import ParameterEventHandler

    with Stage() as stage:
        first, second = plain("first", stage), plain("second", stage)
        listener = plain("listens", stage)
        handler = ParameterEventHandler(listener)
        heard: list[str] = []
        handle = handler.add_parameter_event_callback(lambda event: heard.append(event.node))
        until(lambda: first.count_subscribers("/parameter_events") == 1)
        until(lambda: second.count_subscribers("/parameter_events") == 1)
        answers: list[Any] = [handler.configure_nodes_filter(["/second"])]
        for node in (first, second):
            node.declare_parameter("number", 1)
        until(lambda: heard)
        answers += [sorted(set(heard)), handler.configure_nodes_filter([])]
        for node in (first, second):
            node.declare_parameter("other", 1)
        until(lambda: "/first" in heard)
        answers.append(sorted(set(heard)))
        handler.remove_parameter_event_callback(handle)
        return answers


def feedback_of_ones_own_goal() -> Any:
    """Listen to feedback with a filter by the goal, beside another client of the action."""
    from example_interfaces.action import Fibonacci
    from rclpy.action import ActionClient, ActionServer
    from rclpy.callback_groups import ReentrantCallbackGroup

    def execute(goal: Any) -> Any:
        for _ in range(3):
            goal.publish_feedback(Fibonacci.Feedback(sequence=[goal.request.order]))
        goal.succeed()
        return Fibonacci.Result(sequence=[goal.request.order])

    with Stage() as stage:
        server, caller = plain("serves", stage), plain("calls", stage)
        ActionServer(server, Fibonacci, "numbers", execute, callback_group=ReentrantCallbackGroup())
        heard: dict[int, list[int]] = {1: [], 2: []}
        clients = {
            number: ActionClient(caller, Fibonacci, "numbers", enable_feedback_msg_optimization=True)
            for number in heard
        }
        goals = {}
        for number, client in clients.items():
            assert client.wait_for_server(10.0)
            goals[number] = client.send_goal_async(
                Fibonacci.Goal(order=number),
                lambda message, number=number: heard[number].extend(message.feedback.sequence),
            )
        results = [result_of(result_of(goal).get_result_async()) for goal in goals.values()]
        return [heard, [list(result.result.sequence) for result in results]]


def changes_of_a_lifecycle_node() -> Any:
    """Listen to the transitions of a lifecycle node, which have times."""
    from lifecycle_msgs.msg import TransitionEvent
    from rclpy.lifecycle import LifecycleNode

    with Stage() as stage:
        listener, managed = plain("listens", stage), stage.node("managed", LifecycleNode)
        events: list[Any] = []
        listener.create_subscription(TransitionEvent, "/managed/transition_event", events.append, 10)
        until(lambda: managed.count_subscribers("/managed/transition_event") == 1)
        before_s = int(time.time())
        managed.trigger_configure()
        until(lambda: len(events) == 2)
        return [
            TransitionEvent.get_fields_and_field_types()["stamp"],
            [event.goal_state.label for event in events],
            all(before_s <= event.stamp.sec <= time.time() for event in events),
        ]


def names_that_are_gone() -> Any:
    """Use names that Lyrical has deprecated or removed."""
    import importlib

    from message_filters import Cache, SimpleFilter
    from rclpy.clock import Clock, ClockType, ROSClock

    with Stage() as stage:
        node = plain("uses", stage)
        calls = [
            lambda: type(ROSClock()) is type(Clock(clock_type=ClockType.ROS_TIME)),
            lambda: importlib.import_module("rclpy.qos_event").QoSEventHandler.__name__,
            lambda: Cache(SimpleFilter(), 1).getLastestTime(),
            lambda: node.get_logger().warn("text"),
            lambda: type(node.get_clock()) is ROSClock,
        ]
        return [[value, [text.partition(":")[0] for text in warned]] for value, warned in map(outcome, calls)]


def launched_with_newer_actions() -> Any:
    """Launch with loops, a boolean argument, an environment of its own and a log file's name."""
    from launch import LaunchContext, LaunchDescription, LaunchService
    from launch.actions import (
        DeclareBooleanLaunchArgument,
        ForEach,
        ForLoop,
        LogInfo,
        OpaqueFunction,
        ReplaceEnvironmentVariables,
    )
    from launch.substitutions import LaunchConfiguration, StringJoinSubstitution

    told: list[Any] = []

    def tell_environment(context: LaunchContext) -> None:
        told.append(sorted(context.environment.items()))

    description = LaunchDescription(
        [
            DeclareBooleanLaunchArgument("fast", default_value=True),
            OpaqueFunction(
                function=lambda context: told.append(
                    context.perform_substitution(LaunchConfiguration("fast"))
                )
            ),
            ForLoop("2", function=lambda i: [tell_text(told, f"turtle{i}")]),
            ForEach(
                "{name: first, x: 1};{name: second, x: 2}",
                function=lambda name, x: [tell_text(told, f"{name} {x}")],
            ),
            OpaqueFunction(
                function=lambda context: told.append(
                    StringJoinSubstitution([["a"], ["b", "c"]], delimiter="-").perform(context)
                )
            ),
            ReplaceEnvironmentVariables({"ONLY": "this"}),
            OpaqueFunction(function=tell_environment),
            LogInfo(msg="launched"),
        ]
    )
    with tempfile.TemporaryDirectory() as folder:
        os.environ["ROS_LOG_DIR"] = folder
        service = LaunchService(log_file_name="own.log")
        service.include_launch_description(description)
        code = service.run()
        return [code, told, sorted(path.name for path in Path(folder).rglob("own.log"))]


def tell_text(told: list[Any], text: str) -> Any:
    """Return an action that notes a text."""
    from launch.actions import OpaqueFunction

    return OpaqueFunction(function=lambda _: told.append(text))


# Jazzy's last updates


def executor_that_spins() -> Any:
    """Ask an executor whether it spins, and spin it twice."""
    from rclpy.executors import SingleThreadedExecutor

    with Stage(spins=False) as stage, SingleThreadedExecutor(context=stage.context) as executor:
        node = plain("spins", stage)
        executor.add_node(node)
        seen: list[Any] = [executor.is_spinning]
        node.create_timer(0.01, lambda: seen.append(executor.is_spinning))
        thread = threading.Thread(target=executor.spin, daemon=True)
        thread.start()
        until(lambda: len(seen) > 1)
        again = outcome(executor.spin)[0][:40]
        executor.shutdown(5.0)
        thread.join(5.0)
        return [seen[:2], again, executor.is_spinning]


def server_without_a_callback() -> Any:
    """Execute a goal by the callback that `execute` gets."""
    from example_interfaces.action import Fibonacci
    from rclpy.action import ActionClient, ActionServer

    def execute(goal: Any) -> Any:
        goal.succeed()
        return Fibonacci.Result(sequence=[goal.request.order])

    with Stage() as stage:
        node = plain("acts", stage)
        ActionServer(
            node, Fibonacci, "numbers", None, handle_accepted_callback=lambda goal: goal.execute(execute)
        )
        client = ActionClient(node, Fibonacci, "numbers")
        assert client.wait_for_server(10.0)
        goal = result_of(client.send_goal_async(Fibonacci.Goal(order=7)))
        result = result_of(goal.get_result_async())
        return [result.status, list(result.result.sequence)]


def task_that_awaits() -> Any:
    """Await one of two futures in a task: the other one doesn't wake it."""
    from rclpy.executors import SingleThreadedExecutor
    from rclpy.task import Future, FutureState

    with Stage(spins=False) as stage, SingleThreadedExecutor(context=stage.context) as executor:
        first, second = Future(executor=executor), Future(executor=executor)
        steps: list[str] = []

        async def work() -> str:
            steps.append("begun")
            steps.append(await first)
            return "done"

        task = executor.create_task(work)
        executor.spin_once(timeout_sec=0.1)
        second.set_result("second")
        executor.spin_once(timeout_sec=0.1)
        before = [*steps, task.done()]
        first.set_result("first")
        until(lambda: executor.spin_once(timeout_sec=0.1) or task.done())
        return [before, steps, task.result(), [state.name for state in FutureState]]


if __name__ == "__main__":
    print(json.dumps({name: globals()[name]() for name in sys.argv[1:]}))
    sys.stdout.flush()
    os._exit(0)  # the ends of what a program leaves are no subject

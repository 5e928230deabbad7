"""Walks: sequences of twenty calls on nodes, executors, timers, futures, tasks, topics, services and actions.

Whatever a walk has created stays at hand after it was destroyed. A `spin` runs callbacks until none has run for a
while, and answers which have, in order of their names, because the order of what is ready at one time is free.
"""

from __future__ import annotations

import contextlib
import functools
import itertools
import random
import threading
import time
from collections.abc import Callable
from typing import Any

WIRE = "tfloom_local"
SECONDS = 60.0

STEPS = 20
QUIET_S = 0.06
"""How long no callback has run when a spin ends [s]."""
QUIET_ROUNDS = 8
"""How many spins of each executor have run no callback when a spin ends: the machine may be busy for long."""
MAX_SPIN_S = 5.0
MATCH_S = 5.0


# Drawing: each step is [operation, numbers]; a number selects one of what there is, modulo their count


def draw(random: random.Random) -> Any:
    """Return the steps of a walk, which begins with a node in an executor."""
    focus = random.choice(list(FOCUSES))
    weights = {name: 1 + 6 * (name in FOCUSES[focus]) for name in OPERATIONS}
    names = random.choices(list(weights), list(weights.values()), k=STEPS - 2)
    steps = [["create_node", 0], ["create_executor", random.randrange(2)], ["add_node", 0, 0]]
    return [*steps, *([name, *(random.randrange(1000) for _ in range(3))] for name in names)][:STEPS]


FOCUSES = {
    "everything": (),
    "nodes": ("create_node", "destroy_node", "names", "graph", "parameters", "create_any", "getters", "spin"),
    "timers": (
        "create_timer",
        "timer",
        "timer_state",
        "destroy_timer",
        "create_guard",
        "trigger",
        "destroy_guard",
        "spin",
    ),
    "futures": ("create_future", "future", "future_callback", "create_task", "task", "spin", "spin_until"),
    "executors": (
        "create_executor",
        "add_node",
        "remove_node",
        "shutdown_executor",
        "wait",
        "nested",
        "trigger",
        "spin",
    ),
    "topics": (
        "create_publisher",
        "create_subscription",
        "publish",
        "destroy_topic_end",
        "wait",
        "getters",
        "spin",
    ),
    "services": (
        "create_service",
        "create_client",
        "call",
        "call_and_wait",
        "destroy_service_end",
        "getters",
        "spin",
    ),
    "actions": (
        "create_action_server",
        "create_action_client",
        "send_goal",
        "goal",
        "destroy_action_end",
        "spin",
    ),
    "groups": ("create_group", "members", "create_timer", "create_client", "create_action_client", "nested"),
}


# Running


class Nothing(Exception):  # noqa: N818  # no error: the walk has nothing for the operation yet
    """There is none of what an operation needs."""


class Ours(Exception):  # noqa: N818
    """Raised by a callback of a walk."""


class Walk:
    """What a walk has created."""

    def __init__(self) -> None:
        import rclpy
        from rclpy.context import Context

        self.context = Context()
        rclpy.init(context=self.context)
        self.nodes: list[Any] = []
        self.executors: list[Any] = []
        self.groups: list[Any] = []
        self.timers: list[Any] = []
        self.guards: list[Any] = []
        self.futures: list[Any] = []
        self.tasks: list[Any] = []
        self.publishers: list[Any] = []
        self.subscriptions: list[Any] = []
        self.services: list[Any] = []
        self.clients: list[Any] = []
        self.servers: list[Any] = []
        self.action_clients: list[Any] = []
        self.goals: list[Any] = []
        self.gone: set[int] = set()
        """The ids of what was destroyed."""
        self.owners: dict[int, Any] = {}
        self.offered: list[Any] = []
        self.heard: list[str] = []
        self.numbers = itertools.count()

    def hear(self, name: str) -> None:
        self.heard.append(name)

    def is_gone(self, thing: Any) -> bool:
        return id(thing) in self.gone or id(self.owners.get(id(thing))) in self.gone

    def own(self, node: Any, things: list[Any], thing: Any) -> Any:
        self.owners[id(thing)] = node
        things.append(thing)
        return type(thing).__name__

    def homes(self, node: Any) -> list[Any]:
        """Return the executors that are to run a node."""
        return [executor for executor in self.executors if node in executor.get_nodes()]

    def is_spun(self, thing: Any) -> bool:
        """Return whether exactly one executor runs what belongs to a thing's node."""
        return len(self.homes(self.owners[id(thing)])) == 1

    def end(self) -> None:
        for executor in self.executors:
            with contextlib.suppress(Exception):
                executor.shutdown(timeout_sec=1.0)
        for node in self.nodes:
            with contextlib.suppress(Exception):
                node.destroy_node()
        with contextlib.suppress(Exception):
            self.context.try_shutdown()


def pick(things: list[Any], number: int) -> Any:
    if not things:
        raise Nothing
    return things[number % len(things)]


def of_kind(answer: Any) -> Any:
    """Return a value as JSON that both sides share."""
    if answer is None or isinstance(answer, (bool, int, float, str)):
        return answer
    if isinstance(answer, (list, tuple)):
        return [of_kind(item) for item in answer]
    return type(answer).__name__


def told(access: Callable[[], Any]) -> Any:
    """Return a value, or the class of what its access raises."""
    try:
        return of_kind(access())
    except Nothing:
        raise
    except BaseException as error:  # noqa: BLE001  # its class is the answer
        return f"raised {type(error).__name__}"


OPERATIONS: dict[str, Callable[..., Any]] = {}


def operation(function: Callable[..., Any]) -> Callable[..., Any]:
    OPERATIONS[function.__name__] = function
    return function


def run(case: Any) -> Any:
    """Return what each step answered."""
    walk = Walk()
    answers: list[Any] = []
    try:
        for name, *drawn in case:
            step = functools.partial(OPERATIONS[name], walk, *[*drawn, 0, 0, 0][:3])
            try:
                answers.append([name, told(step)])
            except Nothing:
                answers.append([name, "nothing"])
    finally:
        walk.end()
    return answers


# Nodes


@operation
def create_node(walk: Walk, a: int, *_: int) -> Any:
    if len(walk.nodes) > 2:
        raise Nothing
    from rclpy.lifecycle import LifecycleNode
    from rclpy.node import Node

    node = (LifecycleNode if a % 5 == 4 else Node)(
        f"walker{len(walk.nodes)}", context=walk.context, namespace=["/", "/ns"][a % 2]
    )
    walk.nodes.append(node)
    return type(node).__name__


@operation
def destroy_node(walk: Walk, a: int, b: int, *_: int) -> Any:
    if b % 3:  # rarely, or most walks would end early
        raise Nothing
    node = pick(walk.nodes, a)
    # Where a service has a goal or a request in hand, what becomes of it depends on the time.
    answer = node.destroy_node()
    walk.gone.add(id(node))
    return answer


@operation
def names(walk: Walk, a: int, b: int, *_: int) -> Any:
    node = pick(walk.nodes, a)
    accesses = [
        node.get_name,
        node.get_namespace,
        node.get_fully_qualified_name,
        lambda: node.resolve_topic_name("~/x"),
        lambda: node.resolve_service_name("x"),
        lambda: node.get_logger().name,
        lambda: node.get_clock().now(),
        lambda: node.get_logger().get_effective_level(),
        lambda: node.executor is not None,
        lambda: node.context is walk.context,
        lambda: node.handle.__enter__() and None,
        lambda: node.default_callback_group,
    ]
    return told(pick(accesses, b))


@operation
def graph(walk: Walk, a: int, b: int, *_: int) -> Any:
    node = pick(walk.nodes, a)
    accesses = [
        lambda: type(node.get_topic_names_and_types()),
        lambda: type(node.get_service_names_and_types()),
        lambda: type(node.get_node_names()),
        lambda: type(node.get_node_names_and_namespaces()),
        lambda: type(node.get_node_names_and_namespaces_with_enclaves()),
        lambda: type(node.count_publishers("t")),
        lambda: type(node.count_subscribers("t")),
        lambda: type(node.get_publishers_info_by_topic("t")),
        lambda: type(node.get_subscriptions_info_by_topic("t")),
        lambda: type(node.count_clients("s")),
        lambda: type(node.count_services("s")),
    ]
    return told(lambda: pick(accesses, b)().__name__)


@operation
def parameters(walk: Walk, a: int, b: int, c: int) -> Any:
    from rclpy.parameter import Parameter

    node = pick(walk.nodes, a)
    name = f"p{c % 3}"
    accesses = [
        lambda: node.declare_parameter(name, c).value,
        lambda: node.get_parameter(name).value,
        lambda: node.has_parameter(name),
        lambda: [result.successful for result in node.set_parameters([Parameter(name, value=c)])],
        lambda: node.set_parameters_atomically([Parameter(name, value=c)]).successful,
        lambda: node.undeclare_parameter(name),
        lambda: [found for found in node.list_parameters([], 0).names if found[0] == "p"],
    ]
    return told(pick(accesses, b))


@operation
def create_any(walk: Walk, a: int, b: int, c: int) -> Any:
    return pick(
        [create_timer, create_guard, create_publisher, create_subscription, create_service, create_client], b
    )(walk, a, c, 0)


@operation
def getters(walk: Walk, a: int, b: int, *_: int) -> Any:
    of_kinds = {
        "publishers": ("topic_name", "logger_name", "topic"),
        "subscriptions": ("topic_name", "logger_name", "topic", "raw"),
        "clients": ("service_name", "logger_name", "srv_name"),
        "services": ("service_name", "logger_name", "srv_name"),
        "timers": ("timer_period_ns", "clock"),
    }
    kind = pick(list(of_kinds), a)
    thing = pick(getattr(walk, kind), a // 5)
    return told(lambda: getattr(thing, pick(list(of_kinds[kind]), b)))


# Timers and guard conditions


def group_for(walk: Walk, number: int) -> Any:
    return walk.groups[number % len(walk.groups)] if walk.groups and number % 3 == 0 else None


@operation
def create_timer(walk: Walk, a: int, b: int, c: int) -> Any:
    """Create a timer that is never due, or one that is due once: what is due at one time is a matter of the machine."""
    node = pick(walk.nodes, a)
    name = f"timer {next(walk.numbers)}"
    is_once, is_late = b % 2 == 0, walk.is_gone(node)
    ticked: list[str] = []

    def tick() -> None:
        # Several threads may run it before it is cancelled; and what is created of a destroyed node runs there alone.
        if not ticked and not is_late:
            ticked.append(name)
            walk.hear(name)
        if b % 4 == 0:
            timer.cancel()
        else:
            node.destroy_timer(timer)
            walk.gone.add(id(timer))

    timer = node.create_timer(0.001 if is_once else 1000.0, tick, callback_group=group_for(walk, c))
    walk.own(node, walk.timers, timer)
    timer_is_once[id(timer)] = is_once
    return type(timer).__name__


timer_is_once: dict[int, bool] = {}


@operation
def timer(walk: Walk, a: int, b: int, *_: int) -> Any:
    thing = pick(walk.timers, a)
    if timer_is_once[id(thing)]:  # it may be due just now
        return told(thing.cancel)
    return told(pick([thing.cancel, thing.reset, thing.is_canceled, thing.is_ready], b))


@operation
def timer_state(walk: Walk, a: int, b: int, *_: int) -> Any:
    thing = pick(walk.timers, a)
    if timer_is_once[id(thing)]:
        raise Nothing
    accesses = [
        lambda: thing.time_until_next_call() is None,
        lambda: thing.time_since_last_call() < 100e9,
        lambda: thing.timer_period_ns,
        lambda: setattr(thing, "timer_period_ns", 500 * 10**9 + b),
        lambda: thing.handle.__enter__() and None,
        lambda: thing.clock is thing.clock,
    ]
    return told(pick(accesses, b))


@operation
def destroy_timer(walk: Walk, a: int, *_: int) -> Any:
    thing = pick(walk.timers, a)
    node = walk.owners[id(thing)]
    answer = node.destroy_timer(thing)
    walk.gone.add(id(thing))
    return answer


@operation
def create_guard(walk: Walk, a: int, b: int, *_: int) -> Any:
    node = pick(walk.nodes, a)
    name = f"guard {next(walk.numbers)}"
    is_late = walk.is_gone(node)  # as for a timer
    guard = node.create_guard_condition(
        lambda: None if is_late else walk.hear(name), callback_group=group_for(walk, b)
    )
    return walk.own(node, walk.guards, guard)


@operation
def trigger(walk: Walk, a: int, *_: int) -> Any:
    return told(pick(walk.guards, a).trigger)


@operation
def destroy_guard(walk: Walk, a: int, *_: int) -> Any:
    thing = pick(walk.guards, a)
    answer = walk.owners[id(thing)].destroy_guard_condition(thing)
    walk.gone.add(id(thing))
    return answer


# Groups


@operation
def create_group(walk: Walk, a: int, *_: int) -> Any:
    from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup

    walk.groups.append([MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup][a % 2]())
    return type(walk.groups[-1]).__name__


@operation
def members(walk: Walk, a: int, *_: int) -> Any:
    import gc

    group = pick(walk.groups, a)
    gc.collect()
    things = [*walk.timers, *walk.guards, *walk.clients, *walk.action_clients]
    return [group.has_entity(thing) for thing in things] + [
        sorted(
            type(member()).__name__ for member in group.entities if any(member() is thing for thing in things)
        )
    ]


# Futures and tasks


@operation
def create_future(walk: Walk, a: int, *_: int) -> Any:
    from rclpy.task import Future

    executor = walk.executors[a % len(walk.executors)] if walk.executors and a % 2 else None
    walk.futures.append(Future(executor=executor))
    if executor is not None:
        walk.owners[id(walk.futures[-1])] = executor
    return len(walk.futures)


@operation
def future(walk: Walk, a: int, b: int, c: int) -> Any:
    thing = pick(walk.futures, a)
    accesses = [
        thing.done,
        thing.cancelled,
        thing.result,
        thing.exception,
        thing.cancel,
        lambda: thing.set_result(c),
        lambda: thing.set_exception(Ours()),
    ]
    answer = told(pick(accesses, b))
    with contextlib.suppress(BaseException):
        thing.exception()  # it is fetched: nothing is printed when it goes
    return answer


@operation
def future_callback(walk: Walk, a: int, b: int, *_: int) -> Any:
    thing = pick(walk.futures, a)
    name = f"done {next(walk.numbers)}"

    def callback(done: Any) -> None:
        walk.hear(f"{name} {done.done()} {done.cancelled()}")

    answer = told(lambda: thing.add_done_callback(callback))
    if b % 4 == 0:
        return [answer, told(lambda: thing.remove_done_callback(callback))]
    return answer if id(thing) in walk.owners else [answer, walk.heard[-1:]]


@operation
def create_task(walk: Walk, a: int, b: int, c: int) -> Any:
    executor = pick([executor for executor in walk.executors if not is_shut(executor)], a)
    name = f"task {next(walk.numbers)}"
    awaited = walk.futures[c % len(walk.futures)] if walk.futures else None

    def function() -> int:
        walk.hear(name)
        return c

    async def coroutine() -> Any:
        walk.hear(f"{name} begins")
        if awaited is not None:
            await awaited
        walk.hear(f"{name} ends")
        return c

    task = executor.create_task([function, coroutine][b % 2])
    walk.tasks.append(task)
    return type(task).__name__


@operation
def task(walk: Walk, a: int, b: int, *_: int) -> Any:
    thing = pick(walk.tasks, a)
    return told(
        pick([thing.done, thing.cancelled, thing.result, thing.exception, thing.cancel, thing.executing], b)
    )


# Executors


@operation
def create_executor(walk: Walk, a: int, *_: int) -> Any:
    from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor

    if len(walk.executors) > 1:
        raise Nothing
    if a % 2:
        walk.executors.append(MultiThreadedExecutor(4, context=walk.context))
    else:
        walk.executors.append(SingleThreadedExecutor(context=walk.context))
    return type(walk.executors[-1]).__name__


@operation
def add_node(walk: Walk, a: int, b: int, *_: int) -> Any:
    executor, node = pick(walk.executors, a), pick(walk.nodes, b)
    if any(other is not executor for other in walk.homes(node)):  # two would run it at random there
        raise Nothing
    if is_shut(executor) or walk.is_gone(node):
        raise Nothing
    return told(lambda: executor.add_node(node))


def is_shut(executor: Any) -> bool:
    return bool(executor._is_shutdown)


@operation
def remove_node(walk: Walk, a: int, b: int, *_: int) -> Any:
    if b % 2:
        raise Nothing
    executor, node = pick(walk.executors, a), pick(walk.nodes, b)
    return [told(lambda: executor.remove_node(node)), count_nodes(walk, executor)]


@operation
def shutdown_executor(walk: Walk, a: int, b: int, *_: int) -> Any:
    if b % 4:
        raise Nothing
    executor = pick(walk.executors, a)
    return [told(lambda: executor.shutdown(timeout_sec=5.0)), count_nodes(walk, executor)]


def count_nodes(walk: Walk, executor: Any) -> int:
    """Return the number of an executor's nodes; there, one that was destroyed is still one of them."""
    return sum(not walk.is_gone(node) for node in executor.get_nodes())


def drain(walk: Walk, until: Callable[[], bool] = lambda: True) -> list[str]:
    """Spin all executors until a condition is true, and then until nothing has run for a while.

    Return the names of what has run, and of what spins raised.
    """
    end_s = time.monotonic() + MAX_SPIN_S
    quiet_since_s, rounds, count = time.monotonic(), 0, len(walk.heard)

    def is_quiet() -> bool:
        return rounds >= QUIET_ROUNDS and time.monotonic() >= quiet_since_s + QUIET_S

    while time.monotonic() < end_s and not (is_quiet() and until()):
        rounds += 1
        for executor in walk.executors:
            if is_shut(executor):
                continue
            try:
                executor.spin_once(timeout_sec=0.005)
            except Exception as error:  # noqa: BLE001
                walk.hear(f"raised {type(error).__name__}")
        if len(walk.heard) != count:
            quiet_since_s, rounds, count = time.monotonic(), 0, len(walk.heard)
    heard, walk.heard = sorted(walk.heard), []
    return heard


@operation
def spin(walk: Walk, *_: int) -> Any:
    return drain(walk)


@operation
def spin_until(walk: Walk, a: int, b: int, *_: int) -> Any:
    executor, thing = pick(walk.executors, a), pick(walk.futures, b)
    drain(walk)
    return [told(lambda: executor.spin_until_future_complete(thing, timeout_sec=0.01)), thing.done()]


@operation
def wait(walk: Walk, a: int, b: int, c: int) -> Any:
    """Get the task of a guard condition by the ways in which programs' own executors do, and run it or not."""
    executor, guard = pick(walk.executors, a), pick(walk.guards, b)
    node = walk.owners[id(guard)]
    if is_shut(executor) or walk.is_gone(guard) or walk.homes(node) != [executor]:
        raise Nothing
    drain(walk)
    guard.trigger()
    ways = [
        lambda: executor.wait_for_ready_callbacks(1.0, None, lambda: False),
        lambda: executor.wait_for_ready_callbacks(1.0, [node]),
        lambda: executor.wait_for_ready_callbacks(timeout_sec=1.0, nodes=[node]),
        lambda: executor.wait_for_ready_callbacks(timeout_sec=1.0),
    ]
    seen: list[Any] = []

    def look() -> Any:
        for _ in range(100):
            task, entity, of = ways[c % len(ways)]()
            if entity is guard:
                seen.append([of is node, task.done()])
                if c % 2:
                    task()
                    seen.append(task.done())
                else:
                    walk.offered.append(task)
                return seen
            task()
        return seen

    answer = told(look)
    return [answer, drain(walk)]


@operation
def nested(walk: Walk, a: int, b: int, *_: int) -> Any:
    """Spin an executor of several threads inside a task of it, until another of its tasks has completed a future."""
    from rclpy.executors import MultiThreadedExecutor
    from rclpy.task import Future

    threaded = [executor for executor in walk.executors if isinstance(executor, MultiThreadedExecutor)]
    executor = pick([executor for executor in threaded if not is_shut(executor)], a)
    drain(walk)
    awaited = Future()

    # Two threads spin there, and share a generator: the one that finds it running raises a ValueError.
    def outer() -> bool:
        executor.create_task(awaited.set_result, 1)
        end_s = time.monotonic() + 2.0
        while not awaited.done() and time.monotonic() < end_s:
            with contextlib.suppress(ValueError):
                if b % 2:
                    executor.spin_until_future_complete(awaited, timeout_sec=2.0)
                else:
                    executor.spin_once(timeout_sec=0.05)
        return awaited.done()

    task = executor.create_task(outer)
    end_s = time.monotonic() + 4.0
    while not task.done() and time.monotonic() < end_s:
        with contextlib.suppress(ValueError):
            executor.spin_once(timeout_sec=0.05)
    return [task.done(), told(task.result), drain(walk)]


# Topics


@operation
def create_publisher(walk: Walk, a: int, b: int, *_: int) -> Any:
    from std_msgs.msg import Int32

    node = pick(walk.nodes, a)
    return walk.own(node, walk.publishers, node.create_publisher(Int32, f"topic{b % 2}", 10))


@operation
def create_subscription(walk: Walk, a: int, b: int, c: int) -> Any:
    from std_msgs.msg import Int32

    node = pick(walk.nodes, a)
    name = f"subscription {next(walk.numbers)}"
    subscription = node.create_subscription(
        Int32,
        f"topic{b % 2}",
        lambda msg: walk.hear(f"{name}: {msg.data}"),
        10,
        callback_group=group_for(walk, c),
    )
    return walk.own(node, walk.subscriptions, subscription)


def resolved_topic(walk: Walk, end: Any) -> str:
    node = walk.owners[id(end)]
    return node.resolve_topic_name(end.topic)


def alive_subscriptions(walk: Walk, publisher: Any) -> list[Any]:
    topic = resolved_topic(walk, publisher)
    alive = [end for end in walk.subscriptions if not walk.is_gone(end)]
    return [end for end in alive if resolved_topic(walk, end) == topic]


@operation
def publish(walk: Walk, a: int, b: int, *_: int) -> Any:
    from std_msgs.msg import Int32

    publisher = pick(walk.publishers, a)
    if walk.is_gone(publisher):
        return told(lambda: publisher.publish(Int32(data=b)))
    subscriptions = alive_subscriptions(walk, publisher)
    end_s = time.monotonic() + MATCH_S
    while publisher.get_subscription_count() != len(subscriptions) and time.monotonic() < end_s:
        time.sleep(0.002)
    answer = told(lambda: publisher.publish(Int32(data=b)))
    # All is delivered now, or lost with what is destroyed next.
    spun = [end for end in subscriptions if walk.is_spun(end)]
    heard: list[str] = drain(walk)
    return [answer, publisher.get_subscription_count(), len(spun), heard]


@operation
def destroy_topic_end(walk: Walk, a: int, b: int, *_: int) -> Any:
    if a % 2:
        thing = pick(walk.publishers, b)
        answer = walk.owners[id(thing)].destroy_publisher(thing)
    else:
        thing = pick(walk.subscriptions, b)
        answer = walk.owners[id(thing)].destroy_subscription(thing)
    walk.gone.add(id(thing))
    return answer


# Services


@operation
def create_service(walk: Walk, a: int, b: int, *_: int) -> Any:
    from std_srvs.srv import Trigger

    node = pick(walk.nodes, a)
    if any(not walk.is_gone(end) for end in walk.services):  # of two servers, either may answer first
        raise Nothing
    name = f"service {next(walk.numbers)}"

    def serve(_: Any, response: Any) -> Any:
        walk.hear(name)
        response.success = b % 2 == 0
        return response

    return walk.own(node, walk.services, node.create_service(Trigger, "/service", serve))


@operation
def create_client(walk: Walk, a: int, b: int, *_: int) -> Any:
    from std_srvs.srv import Trigger

    node = pick(walk.nodes, a)
    client = node.create_client(Trigger, "/service", callback_group=group_for(walk, b))
    return walk.own(node, walk.clients, client)


def server_of(walk: Walk, servers: list[Any]) -> Any:
    """Return the one that is alive and spun."""
    return pick([end for end in servers if not walk.is_gone(end) and walk.is_spun(end)], 0)


@operation
def call(walk: Walk, a: int, b: int, *_: int) -> Any:
    from std_srvs.srv import Trigger

    client = pick(walk.clients, a)
    if walk.is_gone(client):
        accesses = [
            lambda: client.call_async(Trigger.Request()),
            client.service_is_ready,
            lambda: client.wait_for_service(timeout_sec=0.0),
            lambda: client.call(Trigger.Request(), timeout_sec=0.01),
            lambda: client.handle.__enter__() and None,
        ]
        return told(pick(accesses, b))
    server_of(walk, walk.services)
    if not walk.is_spun(client):
        raise Nothing
    ready = client.wait_for_service(timeout_sec=MATCH_S)
    answer = client.call_async(Trigger.Request())
    if b % 4 == 0:
        answer.cancel()
        return [ready, answer.done(), answer.cancelled(), bool(drain(walk))]
    heard = drain(walk, until=answer.done)
    return [ready, answer.done(), told(lambda: answer.result().success), heard]


@operation
def call_and_wait(walk: Walk, a: int, b: int, *_: int) -> Any:
    """Call on another thread, while this one spins."""
    from std_srvs.srv import Trigger

    client = pick(walk.clients, a)
    if walk.is_gone(client) or not walk.is_spun(client):
        raise Nothing
    server_of(walk, walk.services)
    ready = client.wait_for_service(timeout_sec=MATCH_S)
    answers: list[Any] = []
    thread = threading.Thread(
        target=lambda: answers.append(client.call(Trigger.Request()).success), daemon=True
    )
    thread.start()
    heard = drain(walk, until=lambda: bool(answers))
    thread.join(MATCH_S)
    return [ready, answers, heard]


@operation
def destroy_service_end(walk: Walk, a: int, b: int, *_: int) -> Any:
    if a % 2:
        thing = pick(walk.services, b)
        answer = walk.owners[id(thing)].destroy_service(thing)
    else:
        thing = pick(walk.clients, b)
        answer = walk.owners[id(thing)].destroy_client(thing)
    walk.gone.add(id(thing))
    return answer


# Actions


@operation
def create_action_server(walk: Walk, a: int, b: int, *_: int) -> Any:
    from example_interfaces.action import Fibonacci
    from rclpy.action import ActionServer, CancelResponse, GoalResponse

    node = pick(walk.nodes, a)
    if any(not walk.is_gone(end) for end in walk.servers):
        raise Nothing
    name = f"server {next(walk.numbers)}"

    def execute(handle: Any) -> Any:
        walk.hear(f"{name} executes")
        if b % 3 == 0:
            handle.publish_feedback(Fibonacci.Feedback(sequence=[1, 2]))
        if b % 4 == 1:
            handle.abort()
        elif b % 4 != 2:
            handle.succeed()
        return Fibonacci.Result(sequence=[b])

    server = ActionServer(
        node,
        Fibonacci,
        "/action",
        execute,
        goal_callback=lambda _: GoalResponse.REJECT if b % 5 == 0 else GoalResponse.ACCEPT,
        cancel_callback=lambda _: CancelResponse.ACCEPT,
    )
    return walk.own(node, walk.servers, server)


@operation
def create_action_client(walk: Walk, a: int, b: int, *_: int) -> Any:
    from example_interfaces.action import Fibonacci
    from rclpy.action import ActionClient

    node = pick(walk.nodes, a)
    client = ActionClient(node, Fibonacci, "/action", callback_group=group_for(walk, b))
    return walk.own(node, walk.action_clients, client)


@operation
def send_goal(walk: Walk, a: int, b: int, *_: int) -> Any:
    from example_interfaces.action import Fibonacci

    client = pick(walk.action_clients, a)
    if walk.is_gone(client):
        return told(lambda: client.wait_for_server(timeout_sec=0.0))
    server_of(walk, walk.servers)
    if not walk.is_spun(client):
        raise Nothing
    name = f"feedback {next(walk.numbers)}"
    ready = client.wait_for_server(timeout_sec=MATCH_S)
    sent = client.send_goal_async(
        Fibonacci.Goal(order=b),
        feedback_callback=lambda msg: walk.hear(f"{name} {list(msg.feedback.sequence)}"),
    )
    heard = drain(walk, until=sent.done)
    goal = sent.result()
    if goal is not None:
        walk.goals.append((client, goal))
    return [ready, sent.done(), goal is not None and goal.accepted, heard]


@operation
def goal(walk: Walk, a: int, b: int, *_: int) -> Any:
    client, handle = pick([goal for goal in walk.goals if goal[1].accepted], a)
    if walk.is_gone(client) or not walk.is_spun(client):
        raise Nothing
    server_of(walk, walk.servers)
    if b % 2:
        answer = handle.get_result_async()
        heard = drain(walk, until=answer.done)
        return [
            answer.done(),
            told(lambda: [answer.result().status, list(answer.result().result.sequence)]),
            heard,
        ]
    answer = handle.cancel_goal_async()
    heard = drain(walk, until=answer.done)
    return [
        answer.done(),
        told(lambda: [answer.result().return_code, len(answer.result().goals_canceling)]),
        heard,
    ]


@operation
def destroy_action_end(walk: Walk, a: int, b: int, *_: int) -> Any:
    thing = pick(walk.servers if a % 2 else walk.action_clients, b)
    if walk.is_gone(thing):
        raise Nothing
    drain(walk)
    answer = told(thing.destroy)
    walk.gone.add(id(thing))
    walk.goals = [goal for goal in walk.goals if goal[0] is not thing] if a % 2 == 0 else []
    return answer


# Differences on purpose


def row_of(theirs: Any, ours: Any, is_shut: bool) -> str | None:
    """Return the row of docs/deviations.md that explains the difference of a step's answers.

    Args:
        theirs: The step and its answer, of the real rclpy.
        ours: Of tfloom.
        is_shut: Whether an executor was shut down before.
    """
    if theirs[0] == "send_goal" and theirs[1] == "raised RCLError" and ours[1] == "raised InvalidHandle":
        return "node-destroyed-actions"
    if is_shut and theirs[0] in {"future", "task"} and theirs[1] == "raised AttributeError":
        return "node-shut-executor-task"
    return None


def rows_of(theirs: Any, ours: Any) -> set[str | None]:
    if not (isinstance(theirs, list) and isinstance(ours, list)):
        return {None}
    shut_at = next((at for at, step in enumerate(theirs) if step[0] == "shutdown_executor"), len(theirs))
    return {
        row_of(*step, at > shut_at)
        for at, step in enumerate(zip(theirs, ours, strict=True))
        if step[0] != step[1]
    }


def explains(row: str, case: Any, theirs: Any, ours: Any) -> bool:
    found = rows_of(theirs, ours)
    return None not in found and row in found


KNOWN = {
    row: functools.partial(explains, row) for row in ["node-destroyed-actions", "node-shut-executor-task"]
}

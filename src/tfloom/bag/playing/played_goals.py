"""Recorded goals, sent again to action servers: a player as the action client that its bag has recorded."""

from __future__ import annotations

import time
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from typing import TYPE_CHECKING, Any

from tfloom._native import ReadyQueue
from tfloom.bag.topic_choice import action_of
from tfloom.interfaces.action_msgs.msg import GoalInfo
from tfloom.interfaces.service_msgs.msg import ServiceEventInfo
from tfloom.interfaces.unique_identifier_msgs.msg import UUID
from tfloom.node.base.node_base import open_endpoint
from tfloom.node.qos.qos import qos_profile_services_default
from tfloom.node.values.duration import S_TO_NS
from tfloom.rmw.errors import WireError
from tfloom.rmw.shared.waiting import wait_until_ready
from tfloom.rmw.typed_names import (
    CANCEL_GOAL,
    GET_RESULT,
    SEND_GOAL,
    SERVICE_EVENTS,
    key_of,
    new_goal_id,
    service_of,
)
from tfloom.rosidl import cdr
from tfloom.rosidl.registry import get_action_class

if TYPE_CHECKING:
    from collections.abc import Iterable, Mapping

    from tfloom.bag.values import Topic
    from tfloom.node.node import Node
    from tfloom.rmw.base import NodeName, Participant, Requester, Response, Service
    from tfloom.rosidl.service import Action

__all__ = ["PlayedGoals"]

SERVER_S = 3.0
"""How long playing waits for servers after the player was made, because discovery may take as long [s]."""
ANSWER_S = 3.0
"""How long the end of playing waits for the answers to goals, and then for those to cancellations [s]."""
_EVENT_TYPE = "_SendGoal_Event"
_NEWS = 1
"""The token of responses, and of what the player has put into the inbox."""
_ALL_GOALS = bytes(16)
"""The id by which a cancellation means all goals, or all up to a time."""


class PlayedGoals:
    """Sends the goals, cancellations and result requests that events of actions' introspection hold.

    They are sent on the thread that calls `run`, because a cancellation and a result request have to wait until the
    server has accepted their goal, which must not delay the rest of the bag. The player calls the other methods, `add`
    before playing.

    Args:
        node: The node that has the clients.
        is_client_source: Whether events of clients are used, not those of servers.
        is_stopped: Returns whether playing was stopped; waits then end early.
    """

    def __init__(self, node: Node, is_client_source: bool, is_stopped: Callable[[], bool]) -> None:
        self._node = node
        self._is_client_source = is_client_source
        self._is_stopped = is_stopped
        self._queue = ReadyQueue()
        self._inbox: deque[Callable[[], None]] = deque()
        """What the thread is to do next; adding and taking are single operations."""
        self._actions: dict[str, _PlayedAction] = {}
        """By their names in the bag."""
        self.names: set[str] = set()
        """The topics that are read, by their names in the bag."""
        self._is_ending = False
        self._cancels = False

    def add(self, topics: Iterable[Topic], remaps: Mapping[str, str]) -> None:
        """Create the clients of the actions that topics belong to.

        Args:
            topics: The wanted topics of actions; those of feedback and status are left out, as the server has its own.
            remaps: Other names of actions, by those in the bag.
        """
        topics = list(topics)
        goal_types = {
            action_of(topic.name): topic.type.removesuffix(_EVENT_TYPE)
            for topic in topics
            if topic.name.endswith(SEND_GOAL + SERVICE_EVENTS)
        }
        for name in sorted({action_of(topic.name) for topic in topics}):
            try:
                action_type = _action_type(goal_types.get(name, ""))
            except LookupError as error:
                self._node.get_logger().warning(f"Goals of '{name}' can't be sent: {error}")
                continue
            self._actions[name] = _PlayedAction(
                self._node,
                remaps.get(name, name),
                action_type,
                self._is_client_source,
                self._is_stopped,
                self._queue,
            )
        names = (topic.name for topic in topics if topic.name.endswith(SERVICE_EVENTS))
        self.names = {name for name in names if action_of(name) in self._actions}

    def wait_for_servers(self) -> None:
        """Wait for the servers of all actions, where discovery may not have ended; otherwise do nothing.

        Goals that waited for a server would be sent at once, and not when they were recorded.
        """
        for action in self._actions.values():
            action.wait_for_server()

    def send(self, topic: str, data: bytes) -> None:
        """Send the request in an event of a topic of `names`, if it has one of the wanted source."""
        name = action_of(topic)
        service = topic.removeprefix(name).removesuffix(SERVICE_EVENTS)
        self._do(partial(self._actions[name].on_event, service, data))

    def restart(self) -> None:
        """Cancel the goals that have not ended: what is played next does not go on from them."""
        for action in self._actions.values():
            self._do(action.restart)

    def end(self, *, cancels: bool) -> None:
        """Have `run` return once all was sent.

        Args:
            cancels: Whether goals are cancelled that have not ended; after a stop they are in any case.
        """

        def end() -> None:
            self._is_ending, self._cancels = True, cancels

        self._do(end)

    def run(self) -> None:
        """Send what the player asks for, until `end`."""
        self._is_ending = False
        while not self._is_ending:
            self._queue.wait(-1)
            self._work()
        actions = self._actions.values()
        self._work_until(lambda: not any(action.unanswered for action in actions))
        if self._cancels or self._is_stopped():
            for action in actions:
                action.restart()
            self._work_until(lambda: not any(action.is_cancelling for action in actions))
        for action in actions:
            action.report_unanswered()

    def _do(self, task: Callable[[], None]) -> None:
        self._inbox.append(task)
        self._queue.post(_NEWS)

    def _work(self) -> None:
        """Take all responses, and do what is in the inbox, in the order in which the bag has it."""
        while True:
            for action in self._actions.values():
                action.take_responses()
            if self._is_ending or not self._inbox:
                return
            self._inbox.popleft()()

    def _work_until(self, is_done: Callable[[], bool]) -> None:
        end_s = time.monotonic() + ANSWER_S
        self._work()
        while not is_done() and (left_s := end_s - time.monotonic()) > 0.0:
            self._queue.wait(int(left_s * S_TO_NS) + 1)
            self._work()


@dataclass(eq=False)
class _Goal:
    """A goal that was sent."""

    goal_id: UUID
    """Another one than the recorded, because a server that knows that one would reject it."""
    sent_ns: int
    """When it was sent, as recorded [ns since the epoch]."""
    is_accepted: bool = False
    is_cancelled: bool = False
    waiting: list[tuple[str, Any]] = field(default_factory=list)
    """The requests that are sent when it is accepted, with their services."""


class _PlayedAction:
    """The client of one action. One thread uses it.

    Args:
        node: The node that has it.
        name: Name of the action.
        action_type: Its class.
        is_client_source: Whether events of clients are used, not those of servers.
        is_stopped: Returns whether playing was stopped.
        queue: Gets `_NEWS` when a response has arrived.
    """

    def __init__(
        self,
        node: Node,
        name: str,
        action_type: type[Action],
        is_client_source: bool,
        is_stopped: Callable[[], bool],
        queue: ReadyQueue,
    ) -> None:
        self._logger = node.get_logger()
        self._name = name
        self._is_stopped = is_stopped
        info = ServiceEventInfo
        self._source = "clients" if is_client_source else "servers"
        self._other_source = "servers" if is_client_source else "clients"
        self._wanted = info.REQUEST_SENT if is_client_source else info.REQUEST_RECEIVED
        self._last_of_others = info.RESPONSE_SENT if is_client_source else info.RESPONSE_RECEIVED
        """The event by which the other source shows that no event of the wanted one has been recorded before."""
        impl: Any = action_type.Impl
        self._services = {
            SEND_GOAL: impl.SendGoalService,
            CANCEL_GOAL: impl.CancelGoalService,
            GET_RESULT: impl.GetResultService,
        }
        self._requesters: dict[str, Requester] = {}
        for suffix, kind in self._services.items():
            service = service_of(kind, name + suffix)

            def create(participant: Participant, whose: NodeName, service: Service = service) -> Requester:
                return participant.create_requester(whose, service, qos_profile_services_default.to_wire())

            self._requesters[suffix] = open_endpoint(node, self, create)
            self._requesters[suffix].notify(queue, _NEWS)
        self._server_end_s = time.monotonic() + SERVER_S
        self._has_wanted = False
        self._goals: dict[bytes, _Goal] = {}
        """The goals of this course of the bag, by their recorded ids."""
        self.unanswered: dict[int, _Goal] = {}
        """The goals that the server has not answered, by the numbers of their requests."""
        self._active: dict[bytes, _Goal] = {}
        """The goals that were accepted and are not known to have ended, by the ids with which they were sent."""
        self._results: dict[int, _Goal] = {}
        """The goals whose result was requested, by the numbers of these requests."""
        self._cancellations: set[int] = set()
        """The requests to cancel that have no response."""
        self._warned: set[str] = set()

    @property
    def is_cancelling(self) -> bool:
        """Whether a request to cancel has no response."""
        return bool(self._cancellations)

    def wait_for_server(self) -> None:
        """Wait for a server, unless that was waited for before, or playing was stopped."""
        wait_until_ready(
            self._requesters[SEND_GOAL],
            self._has_server,
            self._server_end_s,
            is_open=lambda: not self._is_stopped(),
        )

    def on_event(self, service: str, data: bytes) -> None:
        """Send what an event of one of the three services has recorded."""
        try:
            event: Any = cdr.decode(self._services[service].Event, data)
        except cdr.DecodeError as error:
            self._warn("unreadable", f"An event of '{self._name}{service}' can't be read: {error}")
            return
        kind = event.info.event_type
        if kind != self._wanted:
            if kind == self._last_of_others and not self._has_wanted:
                source = f"{self._other_source[:-1]}_introspection".replace("server", "service")
                self._warn(
                    "source",
                    f"The goals of '{self._name}' were recorded by its {self._other_source}, not by its {self._source}:"
                    f" they are sent with --service-requests-source {source}",
                )
            return
        self._has_wanted = True
        if not event.request:
            self._warn(
                "metadata",
                f"The events of '{self._name}' have no requests, because its introspection was set to metadata only.",
            )
            return
        request = event.request[0]
        if service == SEND_GOAL:
            self._send_goal(request, _nanoseconds(event.info.stamp))
        elif service == CANCEL_GOAL:
            self._cancel_recorded(request)
        elif (goal := self._goals.get(key_of(request.goal_id))) is not None:
            request.goal_id = goal.goal_id
            self._send_when_accepted(goal, GET_RESULT, request)

    def restart(self) -> None:
        """Cancel all goals that are not known to have ended, and forget which recorded goals they were."""
        self._goals.clear()
        self._cancel([*self._active.values(), *self.unanswered.values()])

    def take_responses(self) -> None:
        """Take all responses that have arrived."""
        for service, requester in self._requesters.items():
            while (response := requester.take()) is not None:
                try:
                    self._on_response(service, response)
                except cdr.DecodeError as error:
                    self._warn("response", f"A response of '{self._name}{service}' can't be read: {error}")

    def report_unanswered(self) -> None:
        """Warn of goals that the server has not answered, and forget them."""
        if self.unanswered:
            self._warn(
                "unanswered",
                f"The server of '{self._name}' has not answered {len(self.unanswered)} of the goals.",
            )
            self.unanswered.clear()

    def destroy(self) -> None:
        """Close the clients."""
        for requester in self._requesters.values():
            requester.close()

    def _send_goal(self, request: Any, sent_ns: int) -> None:
        recorded_id = key_of(request.goal_id)
        if not self._has_server():
            self._warn("server", f"There is no action server of '{self._name}'; goals for it are left out.")
            return
        goal = _Goal(new_goal_id(), sent_ns)
        request.goal_id = goal.goal_id
        number = self._send(SEND_GOAL, request)
        if number is not None:
            self._goals[recorded_id] = goal
            self.unanswered[number] = goal

    def _has_server(self) -> bool:
        return all(requester.is_ready() for requester in self._requesters.values())

    def _cancel_recorded(self, request: Any) -> None:
        """Cancel what a recorded request means of the goals that were sent: one, all up to a time, or all."""
        recorded_id = key_of(request.goal_info.goal_id)
        until_ns = _nanoseconds(request.goal_info.stamp)
        # Each is cancelled by its id, because a request for all would end the goals of other clients, too.
        is_for_all = recorded_id == _ALL_GOALS and not until_ns
        self._cancel(
            [
                goal
                for goal_id, goal in self._goals.items()
                if is_for_all or goal_id == recorded_id or goal.sent_ns <= until_ns
            ],
            is_repeated=True,
        )

    def _cancel(self, goals: Iterable[_Goal], *, is_repeated: bool = False) -> None:
        for goal in goals:
            if is_repeated or not goal.is_cancelled:
                goal.is_cancelled = True
                request = self._services[CANCEL_GOAL].Request(goal_info=GoalInfo(goal_id=goal.goal_id))
                self._send_when_accepted(goal, CANCEL_GOAL, request)

    def _send_when_accepted(self, goal: _Goal, service: str, request: Any) -> None:
        if not goal.is_accepted:
            goal.waiting.append((service, request))
            return
        number = self._send(service, request)
        if number is None:
            return
        if service == GET_RESULT:
            self._results[number] = goal
        else:
            self._cancellations.add(number)

    def _send(self, service: str, request: Any) -> int | None:
        """Send a request, and return its number; None after a warning, if it can't be sent."""
        try:
            return self._requesters[service].send(cdr.encode(request))
        except WireError as error:
            self._warn("unsent", f"A request to '{self._name}{service}' can't be sent: {error}")
            return None

    def _on_response(self, service: str, response: Response) -> None:
        number = response.id.sequence_number
        if service == CANCEL_GOAL:
            self._cancellations.discard(number)
            return
        if service == GET_RESULT:
            ended = self._results.pop(number, None)
            if ended is not None:
                self._active.pop(key_of(ended.goal_id), None)
            return
        goal = self.unanswered.pop(number, None)
        if goal is None:
            return
        if not cdr.decode(self._services[SEND_GOAL].Response, response.data).accepted:
            self._warn("rejected", f"The server of '{self._name}' has rejected a goal.")
            return
        goal.is_accepted = True
        self._active[key_of(goal.goal_id)] = goal
        waiting, goal.waiting = goal.waiting, []
        for waiting_service, request in waiting:
            self._send_when_accepted(goal, waiting_service, request)

    def _warn(self, kind: str, text: str) -> None:
        """Warn, unless a warning of this kind was logged before."""
        if kind not in self._warned:
            self._warned.add(kind)
            self._logger.warning(text)


def _nanoseconds(stamp: Any) -> int:
    return int(stamp.sec * S_TO_NS + stamp.nanosec)


def _action_type(name: str) -> type[Action]:
    """Return the class of an action.

    Raises:
        LookupError: there is none of this name, or it is empty, because the bag has no goals.
    """
    if not name:
        raise LookupError(
            "the bag has no events of goals, which its server and its client publish after configure_introspection()"
        )
    return get_action_class(name)

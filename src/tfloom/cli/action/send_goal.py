"""Send a goal to an action server and print its result."""

from __future__ import annotations

import argparse
import math
import time
from collections.abc import Callable
from contextlib import ExitStack, suppress
from typing import Any

from tfloom.cli.parser import help_since
from tfloom.cli.shared import graph, numbers
from tfloom.cli.shared.calls import Client, service_client
from tfloom.cli.shared.errors import CommandError, standard_input
from tfloom.cli.shared.interfaces import action_class, fill_message, parse_yaml
from tfloom.cli.shared.listen import cli_node, decoded, shown_node
from tfloom.cli.shared.names import full_topic_name
from tfloom.rmw.base import NodeName, Participant, Reader
from tfloom.rmw.qos import QoS
from tfloom.rmw.typed_names import (
    CANCEL_GOAL,
    CANCEL_REFUSALS,
    FEEDBACK,
    GET_RESULT,
    GOAL_STATUS,
    SEND_GOAL,
    key_of,
    new_goal_id,
    topic_of,
)
from tfloom.rosidl.yaml_text import message_to_yaml

CANCEL_TIMEOUT_S = 5.0
FEEDBACK_TIMEOUT_S = 2.0


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `action send_goal`."""
    parser.add_argument("action_name", help="name of the action")
    parser.add_argument("action_type", help="its type, for example turtlesim/action/RotateAbsolute")
    parser.add_argument(
        "goal", nargs="?", default="{}", help="the goal's fields in YAML, for example '{theta: 1.57}'"
    )
    parser.add_argument("--stdin", action="store_true", help="read the goal's YAML from standard input")
    parser.add_argument("-f", "--feedback", action="store_true", help="print the feedback")
    parser.add_argument(
        "-t",
        "--timeout",
        type=numbers.positive,
        default=math.inf,
        metavar="N",
        help=help_since(
            "kilted",
            "seconds to wait until the goal is accepted, and then for its result; after that, it is cancelled",
        ),
    )


def main(args: argparse.Namespace) -> int:
    """Send the goal and wait for its end; Ctrl-C cancels it. Return 1 if it did not succeed."""
    name = full_topic_name(args.action_name, "action")
    cls = action_class(args.action_type, search_graph=True)
    goal = cls.Goal()
    fill_message(goal, parse_yaml(standard_input().read() if args.stdin else args.goal))
    with ExitStack() as ends:
        participant = ends.enter_context(graph.joined_participant())
        node = ends.enter_context(shown_node(participant, cli_node()))
        client = _ActionClient(participant, node, name, cls, ends, with_feedback=args.feedback)
        print("Waiting for an action server to become available...")
        client.wait_for_server()
        print(f"Sending goal:\n     {message_to_yaml(goal)}")
        try:
            is_accepted = client.send(goal, args.timeout)
        except TimeoutError:
            print(f"Timed out waiting for goal acceptance after {args.timeout:g} seconds.")
            with suppress(CommandError):  # it does not respond: there is nothing more to say
                client.cancel()  # the goal may have been accepted, with a response that is late
            return 1
        if not is_accepted:
            print("Goal was rejected.")
            return 1
        try:  # from here on, because a user who reads that the goal is accepted may press Ctrl-C at once
            print(f"Goal accepted with ID: {key_of(client.goal_id).hex()}\n")
            response = client.result(args.timeout)
        except TimeoutError:
            print(f"Timed out waiting for the result after {args.timeout:g} seconds. Canceling goal...")
            print(client.cancel())
            return 1
        except KeyboardInterrupt:
            print("Canceling goal...")
            print(client.cancel())
            raise
        print(f"Result:\n    {message_to_yaml(response.result)}")
        status = (
            GOAL_STATUS[response.status] if 0 <= response.status < len(GOAL_STATUS) else f"{response.status}"
        )
        print(f"Goal finished with status: {status}")
        return int(status != "SUCCEEDED")


class _ActionClient:
    """A client of one action, for one goal.

    Args:
        participant: Where its ends are created.
        node: The node that they are shown to belong to.
        name: The full name of the action.
        cls: The action's class.
        ends: Closes them.
        with_feedback: Print feedback while waiting for the result.
    """

    def __init__(
        self,
        participant: Participant,
        node: NodeName,
        name: str,
        cls: type[Any],
        ends: ExitStack,
        *,
        with_feedback: bool,
    ) -> None:
        self._feedback: Reader | None = None
        if with_feedback:
            # Before the services, because a server discovers ends in the order of their creation: one that responds to
            # a goal then sends its feedback here, too.
            feedback_class = cls.Impl.FeedbackMessage
            self._feedback = participant.create_reader(node, topic_of(feedback_class, name + FEEDBACK), QoS())
            ends.callback(self._feedback.close)

        def client(service: str, service_class: type[Any]) -> Client:
            return ends.enter_context(service_client(participant, node, name + service, service_class))

        self.goal_id = new_goal_id()
        self._key = key_of(self.goal_id)
        self._class = cls
        self._send_goal = client(SEND_GOAL, cls.Impl.SendGoalService)
        self._get_result = client(GET_RESULT, cls.Impl.GetResultService)
        self._cancel_goal = client(CANCEL_GOAL, cls.Impl.CancelGoalService)
        self._unprinted: list[Any] = []
        """Feedback that has arrived and isn't printed yet."""

    def wait_for_server(self) -> None:
        """Wait until all three services of the action are ready, and the publisher of its feedback is matched."""
        for client in (self._send_goal, self._get_result, self._cancel_goal):
            client.wait_for_server()
        # Services can be ready before the feedback's publisher is matched, and what it sends before would be lost.
        # After the timeout, go on without feedback: the result doesn't depend on it.
        end_s = time.monotonic() + FEEDBACK_TIMEOUT_S
        while self._feedback and not self._feedback.matched_count() and time.monotonic() < end_s:
            time.sleep(0.005)

    def send(self, goal: Any, timeout_s: float = math.inf) -> bool:
        """Send the goal and return whether it was accepted; TimeoutError if that takes longer."""
        request = self._class.Impl.SendGoalService.Request(goal_id=self.goal_id, goal=goal)
        self._send_goal.send(request)
        # Feedback may arrive before the response, and is printed after the goal's id.
        return bool(self._send_goal.receive(_until(timeout_s, self._take_feedback)).accepted)

    def result(self, timeout_s: float = math.inf) -> Any:
        """Wait for the goal's end and return status and result; TimeoutError if that takes longer."""
        request = self._class.Impl.GetResultService.Request(goal_id=self.goal_id)
        self._get_result.send(request)
        response = self._get_result.receive(_until(timeout_s, self._print_feedback))
        # The last feedback may still be in the reader when the result arrives: print it before the result.
        self._print_feedback()
        return response

    def cancel(self) -> str:
        """Request the goal's cancellation, and return the server's response as a sentence."""
        from tfloom.interfaces.action_msgs.msg import GoalInfo

        request = self._class.Impl.CancelGoalService.Request(goal_info=GoalInfo(goal_id=self.goal_id))
        response = self._cancel_goal.call(request, CANCEL_TIMEOUT_S)
        if any(key_of(goal.goal_id) == self._key for goal in response.goals_canceling):
            return "Goal canceled."
        return f"The server did not cancel the goal: {CANCEL_REFUSALS.get(response.return_code, 'no reason given')}"

    def _print_feedback(self) -> None:
        self._take_feedback()
        for feedback in self._unprinted:
            print(f"Feedback:\n    {message_to_yaml(feedback)}")
        self._unprinted.clear()

    def _take_feedback(self) -> None:
        while self._feedback and (sample := self._feedback.take()):
            message = decoded(self._class.Impl.FeedbackMessage, sample)
            if message is not None and key_of(message.goal_id) == self._key:
                self._unprinted.append(message.feedback)


def _until(timeout_s: float, meanwhile: Callable[[], None]) -> Callable[[], None]:
    """Return what calls `meanwhile`, and raises TimeoutError once a time is over."""
    end_s = time.monotonic() + timeout_s

    def look() -> None:
        meanwhile()
        if time.monotonic() > end_s:
            raise TimeoutError

    return look

"""Parameters of nodes, read and set for pages on a separate thread, because a node may be slow to respond."""

from __future__ import annotations

import queue
import threading
from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from tfloom._native import ReadyQueue
from tfloom.interfaces.rcl_interfaces import srv
from tfloom.interfaces.rcl_interfaces.msg import Parameter, ParameterDescriptor, ParameterValue
from tfloom.node.parameters.parameter import get_parameter_value, parameter_value_to_python
from tfloom.node.parameters.parameter_file import give_types, untyped_names
from tfloom.node.values.value_text import value_text as _value_text
from tfloom.rmw.shared.service_request import ServiceRequest, ServiceRequestError
from tfloom.rosidl import cdr
from tfloom.viewer.displays.display import shown_text
from tfloom.viewer.page_command import PageError, text

if TYPE_CHECKING:
    from tfloom.rmw.base import NodeName, Participant

__all__ = ["Parameters"]

TIMEOUT_S = 2.0
"""The longest wait for a node, and again for its response [s]."""
MAX_QUESTIONS = 20
"""Number of questions that wait; a further one is refused."""
MAX_PARAMETERS = 500
"""Number of a node's parameters that are shown."""
MAX_VALUE = 2000
"""Length of a value that is shown whole [characters]; of a longer one, the beginning is shown."""
LIST_SERVICE = "/list_parameters"

Answer = Callable[[dict[str, Any]], None]


class Parameters:
    """Asks nodes for their parameters.

    Args:
        participant: The participant that asks.
        node: The node whose clients these are, which was added to the participant.
    """

    def __init__(self, participant: Participant, node: NodeName) -> None:
        self._participant = participant
        self._node = node
        self._questions: queue.Queue[tuple[Mapping[str, Any], Answer] | None] = queue.Queue(MAX_QUESTIONS)
        self._is_closed = False
        self._thread = threading.Thread(target=self._run, name="tfloom_view_parameters", daemon=True)
        self._thread.start()

    def ask(self, command: Mapping[str, Any], answer: Answer) -> None:
        """Do a page's command, and give it the answer later, on another thread.

        Raises:
            PageError: too many questions wait.
        """
        try:
            self._questions.put_nowait((command, answer))
        except queue.Full:
            raise PageError("too many questions to nodes wait for a response") from None

    def close(self) -> None:
        """End the thread; a wait for a node ends at its timeout."""
        self._is_closed = True
        self._questions.put(None)
        self._thread.join(3.0 * TIMEOUT_S)

    def _run(self) -> None:
        while (question := self._questions.get()) is not None:
            command, answer = question
            if self._is_closed:
                continue
            try:
                answer(self._answer(command))
            except PageError as error:
                answer({"error": shown_text(str(error), 500)})
            except Exception as error:  # of one question: those after it are still answered
                answer({"error": shown_text(f"{type(error).__name__}: {error}", 500)})

    def _answer(self, command: Mapping[str, Any]) -> dict[str, Any]:
        if command.get("op") == "set_parameter":
            return self._set(text(command, "node"), text(command, "name"), text(command, "value"))
        nodes = self._nodes()
        node = text(command, "node")
        if node not in nodes:
            if not nodes:
                raise PageError("no node has parameters")
            node = nodes[0]
        return {"parameters": {"node": node, "nodes": nodes, "values": self._values(node)}}

    def _nodes(self) -> list[str]:
        served = {end.name for end in self._participant.graph.service_ends() if end.is_server}
        return sorted(
            name.removesuffix(LIST_SERVICE)
            for name in served
            if name.endswith(LIST_SERVICE) and "/_" not in name
        )

    def _values(self, node: str) -> list[dict[str, Any]]:
        listed = self._call(node, "list_parameters", srv.ListParameters, srv.ListParameters.Request())
        names = sorted(listed.result.names)[:MAX_PARAMETERS]
        request = srv.GetParameters.Request(names=names)
        values = list(self._call(node, "get_parameters", srv.GetParameters, request).values)
        asked = srv.DescribeParameters.Request(names=names)
        described = list(self._call(node, "describe_parameters", srv.DescribeParameters, asked).descriptors)
        if not len(values) == len(described) == len(names):
            raise PageError(f"{node} did not respond with all of its parameters")
        return [_row(*found) for found in zip(names, values, described, strict=True)]

    def _set(self, node: str, name: str, value: str) -> dict[str, Any]:
        try:
            parsed = get_parameter_value(value)
        except ValueError as error:
            raise PageError(f"the value of {name} can't be used: {error}") from None
        parameters = [Parameter(name=name, value=parsed)]
        if untyped_names(parameters):
            asked = srv.DescribeParameters.Request(names=[name])
            described = self._call(node, "describe_parameters", srv.DescribeParameters, asked).descriptors
            give_types(parameters, {found.name: found.type for found in described})
        request = srv.SetParameters.Request(parameters=parameters)
        results = self._call(node, "set_parameters", srv.SetParameters, request).results
        if len(results) != 1 or not results[0].successful:
            reason = results[0].reason if results else "no result"
            raise PageError(f"{node} did not set {name}: {reason}")
        return {"done": shown_text(f"{name} of {node} is {value}")}

    def _call(self, node: str, service: str, service_class: type[Any], request: Any) -> Any:
        asked = ServiceRequest(
            self._participant, self._node, f"{node}/{service}", service_class, ReadyQueue()
        )
        try:
            asked.ask(cdr.encode(request), response_s=TIMEOUT_S, server_s=TIMEOUT_S)
            return asked.wait()
        except ServiceRequestError as error:
            raise PageError(str(error)) from None
        finally:
            asked.close()


def _row(name: str, value: ParameterValue, descriptor: ParameterDescriptor) -> dict[str, Any]:
    whole = _value_text(parameter_value_to_python(value))
    shown = {"name": shown_text(name), "value": shown_text(whole, MAX_VALUE)}
    # What is shown in part would be set in part.
    is_whole = (name, whole) == (shown["name"], shown["value"])
    return {**shown, "is_editable": is_whole and not descriptor.read_only}

"""The parameters of all nodes, by the names `/node.parameter`."""

from __future__ import annotations

import time
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from foxglove import Parameter, ParameterType, ParameterValue

from tfloom.foxglove.calls import Call
from tfloom.interfaces.rcl_interfaces import msg, srv
from tfloom.node.parameters import parameter as ros

if TYPE_CHECKING:
    from tfloom.foxglove.calls import Calls
    from tfloom.foxglove.settings import Settings
    from tfloom.node.node import Node

__all__ = ["MAX_PARAMETERS", "ParameterError", "Parameters", "from_message"]

TIMEOUT_S = 2.0
"""The longest wait for all nodes' responses to one of the steps [s]."""
MAX_PARAMETERS = 10_000
"""Number of parameters that a client gets."""
MAX_SET = 1000
"""Number of parameters that a client sets by one request."""
SET_S = 10.0
"""How long that may take [s]: each is set by itself, and a node may not respond."""
LIST = "/list_parameters"


class ParameterError(Exception):
    """A parameter was not set; the text says why."""


class Parameters:
    """Gets and sets parameters, on threads of the SDK."""

    def __init__(self, node: Node, calls: Calls, settings: Settings) -> None:
        self._node = node
        self._calls = calls
        self._settings = settings
        self._silent: set[str] = set()
        """Nodes that did not respond, which are asked again when they were away."""

    def get(self, names: Sequence[str]) -> list[Parameter]:
        """Return parameters by their names; without names, those of all nodes.

        A node that does not respond, and a parameter that is not declared, are left out.
        """
        if not names:
            names = self._all_names()
        by_node: dict[str, list[str]] = {}
        for name in names[:MAX_PARAMETERS]:
            node, _, parameter = name.partition(".")
            if parameter and name in self._settings.parameters:
                by_node.setdefault(node, []).append(parameter)
        nodes = [node for node in self._nodes() if node in by_node]
        requests = {node: srv.GetParameters.Request(names=by_node[node]) for node in nodes}
        responses = self._ask("get_parameters", srv.GetParameters, requests)
        return [
            from_message(f"{node}.{parameter}", value)
            for node, response in responses
            for parameter, value in zip(by_node[node], response.values, strict=False)
            if value.type != msg.ParameterType.PARAMETER_NOT_SET
        ]

    def set(self, parameters: Sequence[Parameter]) -> list[str]:
        """Set parameters; return a sentence for each that was not set, before them one for all beyond the limits."""
        end_s = time.monotonic() + SET_S
        errors: list[str] = []
        for number, parameter in enumerate(parameters):
            if number >= MAX_SET or time.monotonic() > end_s:
                left = len(parameters) - number
                text = (
                    f"{left} of {len(parameters)} parameters are not set: a request may have {MAX_SET}, "
                    f"and take {SET_S:g} s"
                )
                return [text, *errors]
            if error := self._try_to_set(parameter):
                errors.append(error)
        return errors

    def _try_to_set(self, parameter: Parameter) -> str:
        try:
            self._set(parameter)
        except ParameterError as error:
            return str(error)
        return ""

    def _set(self, parameter: Parameter) -> None:
        node, _, name = parameter.name.partition(".")
        if parameter.name not in self._settings.parameters:
            raise ParameterError(f"clients may not set {parameter.name}")
        if not name or node not in self._nodes():
            raise ParameterError(f"no node has the parameter {parameter.name}")
        request = srv.GetParameters.Request(names=[name])
        present = self._ask("get_parameters", srv.GetParameters, {node: request})
        kind = present[0][1].values[0].type if present and present[0][1].values else 0
        try:
            value = _to_message(parameter.get_value(), kind)
        except (TypeError, ValueError, AssertionError) as error:
            raise ParameterError(f"{parameter.name} can't have this value: {error}") from None
        change = srv.SetParameters.Request(parameters=[msg.Parameter(name=name, value=value)])
        responses = self._ask("set_parameters", srv.SetParameters, {node: change})
        if not responses:
            raise ParameterError(f"{node} did not respond")
        results = responses[0][1].results
        if len(results) != 1 or not results[0].successful:
            raise ParameterError(
                f"{node} did not set {name}: {results[0].reason if results else 'no result'}"
            )

    def _all_names(self) -> list[str]:
        nodes = [node for node in self._nodes() if node not in self._silent]
        requests = dict.fromkeys(nodes, srv.ListParameters.Request())
        responses = self._ask("list_parameters", srv.ListParameters, requests)
        if self._settings.skips_silent_nodes:
            self._silent |= set(nodes) - {node for node, _ in responses}
        return [f"{node}.{name}" for node, response in responses for name in sorted(response.result.names)]

    def _nodes(self) -> list[str]:
        services = self._node.get_service_names_and_types()
        nodes = [name.removesuffix(LIST) for name, _ in services if name.endswith(LIST)]
        self._silent &= set(nodes)
        return [node for node in nodes if self._settings.include_hidden or "/_" not in node]

    def _ask(
        self, service: str, service_class: type[Any], requests: Mapping[str, Any]
    ) -> list[tuple[str, Any]]:
        """Send nodes their requests; return the responses of those nodes that respond, with the nodes."""
        calls = [Call(service_class, f"{node}/{service}", request) for node, request in requests.items()]
        responses = zip(requests, self._calls.call_all(calls, TIMEOUT_S), strict=True)
        return [(node, response) for node, response in responses if response is not None]


def from_message(name: str, value: msg.ParameterValue) -> Parameter:
    """Return the SDK's parameter of a value."""
    kind = value.type
    if kind == msg.ParameterType.PARAMETER_DOUBLE:
        return Parameter(name, value=ParameterValue.Float64(value.double_value), type=ParameterType.Float64)
    if kind == msg.ParameterType.PARAMETER_DOUBLE_ARRAY:
        numbers: list[Any] = [ParameterValue.Float64(float(number)) for number in value.double_array_value]
        return Parameter(name, value=ParameterValue.Array(numbers), type=ParameterType.Float64Array)
    if kind == msg.ParameterType.PARAMETER_BYTE_ARRAY:
        return Parameter(name, value=b"".join(value.byte_array_value))
    try:
        plain = ros.parameter_value_to_python(value)
    except RuntimeError:  # of no known type
        plain = None
    is_list = plain is not None and not isinstance(plain, (bool, int, float, str))
    return Parameter(name, value=list(plain) if is_list else plain)


def _to_message(value: Any, kind: int) -> msg.ParameterValue:
    """Return a client's value as a message; whole numbers are doubles where the parameter is one (`kind`)."""
    if kind == msg.ParameterType.PARAMETER_DOUBLE and isinstance(value, int) and not isinstance(value, bool):
        value = float(value)
    if kind == msg.ParameterType.PARAMETER_DOUBLE_ARRAY and isinstance(value, list):
        value = [float(number) for number in value]
    if isinstance(value, bytes):
        value = [bytes((byte,)) for byte in value]
    if isinstance(value, list) and not value:
        empty = msg.ParameterValue(type=kind)
        if kind < msg.ParameterType.PARAMETER_BYTE_ARRAY:
            raise ValueError("an empty list has no type")
        return empty
    return ros.Parameter("value", None, value).get_parameter_value()

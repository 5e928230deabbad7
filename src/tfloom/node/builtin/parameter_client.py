"""Clients for the parameters of another node."""

from __future__ import annotations

import time
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any

from tfloom.common.seconds import checked_timeout
from tfloom.interfaces.rcl_interfaces.msg import Parameter as ParameterMsg
from tfloom.interfaces.rcl_interfaces.msg import ParameterEvent
from tfloom.interfaces.rcl_interfaces.srv import (
    DescribeParameters,
    GetParameters,
    GetParameterTypes,
    ListParameters,
    SetParameters,
    SetParametersAtomically,
)
from tfloom.node.executing.task import Future
from tfloom.node.parameters.parameter import Parameter, ParameterType, parameter_dict
from tfloom.node.parameters.parameter_file import EVERY_NODE, give_types, read_parameter_file, untyped_names
from tfloom.node.qos.qos import QoSProfile, qos_profile_parameter_events, qos_profile_services_default
from tfloom.node.values.names import full_node_name

if TYPE_CHECKING:
    from tfloom.node.base.node_base import NodeBase
    from tfloom.node.endpoints.client import Client
    from tfloom.node.endpoints.subscription import Subscription
    from tfloom.node.executing.callback_groups import CallbackGroup

__all__ = ["AsyncParameterClient"]

_Callback = Callable[[Future[Any]], Any]
_SetAll = Callable[[list[ParameterMsg], "_Callback | None"], Future[Any]]


class AsyncParameterClient:
    """Calls the parameter services of another node; each method returns the future of the service's response.

    Args:
        node: The node that calls.
        remote_node_name: The other node's name; a relative one is in the namespace of `node`.
        qos_profile: QoS of the services.
        callback_group: Group of the clients.
    """

    def __init__(
        self,
        node: NodeBase,
        remote_node_name: str,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> None:
        self.remote_node_name = remote_node_name
        is_absolute = remote_node_name.startswith("/")
        self._full_name = (
            remote_node_name if is_absolute else full_node_name(node.get_namespace(), remote_node_name)
        )
        self.node = node

        def client(srv_type: type[Any], name: str) -> Client:
            return node.create_client(
                srv_type, f"{remote_node_name}/{name}", qos_profile=qos_profile, callback_group=callback_group
            )

        self._get = client(GetParameters, "get_parameters")
        self._list = client(ListParameters, "list_parameters")
        self._set = client(SetParameters, "set_parameters")
        self._get_types = client(GetParameterTypes, "get_parameter_types")
        self._describe = client(DescribeParameters, "describe_parameters")
        self._set_atomically = client(SetParametersAtomically, "set_parameters_atomically")

    def _clients(self) -> list[Client]:
        return [self._list, self._set, self._get, self._get_types, self._describe, self._set_atomically]

    def services_are_ready(self) -> bool:
        """Return whether all six services are ready."""
        return all(client.service_is_ready() for client in self._clients())

    def wait_for_services(self, timeout_sec: float | None = None) -> bool:
        """Wait for all six services; False if they aren't ready after `timeout_sec` [s] (None: no limit)."""
        timeout_s = checked_timeout("wait_for_services", timeout_sec)
        end = None if timeout_s is None else time.monotonic() + timeout_s
        for client in self._clients():
            left_s = None if end is None else max(0.0, end - time.monotonic())
            if not client.wait_for_service(left_s):
                return False
        return True

    def list_parameters(
        self,
        prefixes: list[str] | None = None,
        depth: int | None = None,
        callback: _Callback | None = None,
    ) -> Future[Any]:
        """Request the names below prefixes (None: all names), at most `depth` parts deep (None: no limit)."""
        return _call_service(
            self._list, ListParameters.Request(prefixes=prefixes or [], depth=depth or 0), callback
        )

    def get_parameters(self, names: list[str], callback: _Callback | None = None) -> Future[Any]:
        """Request the values of parameters."""
        return _call_service(self._get, GetParameters.Request(names=names), callback)

    def set_parameters(
        self, parameters: Sequence[Parameter | ParameterMsg], callback: _Callback | None = None
    ) -> Future[Any]:
        """Set parameters one by one."""
        return _call_service(
            self._set, SetParameters.Request(parameters=_parameter_messages(parameters)), callback
        )

    def set_parameters_atomically(
        self, parameters: Sequence[Parameter | ParameterMsg], callback: _Callback | None = None
    ) -> Future[Any]:
        """Set all parameters or none."""
        request = SetParametersAtomically.Request(parameters=_parameter_messages(parameters))
        return _call_service(self._set_atomically, request, callback)

    def describe_parameters(self, names: list[str], callback: _Callback | None = None) -> Future[Any]:
        """Request the descriptors of parameters."""
        return _call_service(self._describe, DescribeParameters.Request(names=names), callback)

    def get_parameter_types(self, names: list[str], callback: _Callback | None = None) -> Future[Any]:
        """Request the types of parameters."""
        return _call_service(self._get_types, GetParameterTypes.Request(names=names), callback)

    def delete_parameters(self, names: list[str], callback: _Callback | None = None) -> Future[Any]:
        """Undeclare parameters; this succeeds for those of dynamic type only."""
        return self.set_parameters([Parameter(name, ParameterType.NOT_SET) for name in names], callback)

    def load_parameter_file(
        self, parameter_file: str, use_wildcard: bool = False, callback: _Callback | None = None
    ) -> Future[Any]:
        """Set one by one the parameters that a YAML file has for the other node, and for `/**` if `use_wildcard`.

        If it has none for that node, set those that it has for other nodes. An empty list gets the type that the other
        node has for it, which is asked for first.

        Raises:
            OSError: the file can't be read.
            ValueError: it isn't a parameter file.
            RuntimeError: it has no parameters.
        """
        return self._load(self.set_parameters, self._read_parameters(parameter_file, use_wildcard), callback)

    def load_parameter_file_atomically(
        self, parameter_file: str, use_wildcard: bool = False, callback: _Callback | None = None
    ) -> Future[Any]:
        """Set all parameters of a YAML file, or none; otherwise as `load_parameter_file`."""
        return self._load(
            self.set_parameters_atomically, self._read_parameters(parameter_file, use_wildcard), callback
        )

    def _load(
        self, set_all: _SetAll, parameters: list[ParameterMsg], callback: _Callback | None
    ) -> Future[Any]:
        names = untyped_names(parameters)
        if not names:
            return set_all(parameters, callback)
        end: Future[Any] = Future()
        if callback is not None:
            end.add_done_callback(callback)

        def set_typed(types: dict[str, int]) -> None:
            give_types(parameters, types)
            set_all(parameters, lambda future: _pass_on(future, end, end.set_result))

        self._ask_types(names, {}, end, set_typed)
        return end

    def _ask_types(
        self, names: list[str], types: dict[str, int], end: Future[Any], then: Callable[[dict[str, int]], Any]
    ) -> None:
        """Ask for the declared types one by one: a node gives none if one of several names isn't declared."""
        if not names:
            then(types)
            return
        name, *others = names

        def go_on(response: Any) -> None:
            types.update((found.name, found.type) for found in response.descriptors)
            self._ask_types(others, types, end, then)

        self.describe_parameters([name], lambda future: _pass_on(future, end, go_on))

    def _read_parameters(self, parameter_file: str, use_wildcard: bool) -> list[ParameterMsg]:
        rules = [
            rule for rule in read_parameter_file(parameter_file) if use_wildcard or rule.node != EVERY_NODE
        ]
        own_rules = [rule for rule in rules if rule.is_for(self._full_name)]
        return list(parameter_dict(own_rules or rules).values())

    def on_parameter_event(
        self,
        callback: Callable[[ParameterEvent], Any],
        qos_profile: QoSProfile = qos_profile_parameter_events,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: Any = None,
        qos_overriding_options: Any = None,
        raw: bool = False,
    ) -> Subscription[ParameterEvent]:
        """Subscribe to the parameter changes of all nodes."""
        return self.node.create_subscription(
            ParameterEvent,
            "/parameter_events",
            callback,
            qos_profile,
            callback_group=callback_group,
            event_callbacks=event_callbacks,
            qos_overriding_options=qos_overriding_options,
            raw=raw,
        )


def _call_service(client: Client, request: Any, callback: _Callback | None) -> Future[Any]:
    future = client.call_async(request)
    if callback is not None:
        future.add_done_callback(callback)
    return future


def _pass_on(future: Future[Any], end: Future[Any], go_on: Callable[[Any], Any]) -> None:
    """Go on with a future's result; end with its exception, or that of going on, or as it was cancelled."""
    if future.cancelled():
        end.cancel()
        return
    if end.cancelled():
        return
    try:
        go_on(future.result())
    except Exception as error:  # it belongs to whoever waits for the end
        end.set_exception(error)


def _parameter_messages(parameters: Sequence[Parameter | ParameterMsg]) -> list[ParameterMsg]:
    return [
        parameter.to_parameter_msg() if isinstance(parameter, Parameter) else parameter
        for parameter in parameters
    ]

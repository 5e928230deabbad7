"""Callbacks for parameter changes of any node."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Callable, Iterable
from functools import partial
from typing import TYPE_CHECKING, Any

from tfloom.interfaces.rcl_interfaces.msg import Parameter, ParameterEvent
from tfloom.node.qos.qos import QoSProfile, qos_profile_parameter_events
from tfloom.node.values.callback_errors import call_all
from tfloom.node.values.names import full_node_name

if TYPE_CHECKING:
    from tfloom.node.base.node_base import NodeBase
    from tfloom.node.executing.callback_groups import CallbackGroup
    from tfloom.node.executing.event_handler import SubscriptionEventCallbacks

__all__ = ["ParameterCallbackHandle", "ParameterEventCallbackHandle", "ParameterEventHandler"]


class ParameterCallbackHandle:
    """One parameter of one node, and the callback for its changes."""

    def __init__(self, parameter_name: str, node_name: str, callback: Callable[[Parameter], None]) -> None:
        self.parameter_name = parameter_name
        self.node_name = node_name
        self.callback = callback


class ParameterEventCallbackHandle:
    """The callback for every change."""

    def __init__(self, callback: Callable[[ParameterEvent], None]) -> None:
        self.callback = callback


class _Callbacks:
    """The callbacks of a ParameterEventHandler, by rclpy's names, because programs' tests read them."""

    def __init__(self) -> None:
        self.parameter_callbacks: defaultdict[tuple[str, str], list[ParameterCallbackHandle]] = defaultdict(
            list
        )
        """By the names of parameter and node; of each, the last added is first."""
        self.event_callbacks: list[ParameterEventCallbackHandle] = []

    def event_callback(self, event: ParameterEvent) -> None:
        """Call the callbacks of the parameters that an event set, then those for every event."""
        # Collected before any is called, because a callback may add or remove others. Another thread may, too.
        calls: list[Callable[[], None]] = []
        for (parameter_name, node_name), handles in list(self.parameter_callbacks.items()):
            parameter = ParameterEventHandler.get_parameter_from_event(event, parameter_name, node_name)
            if parameter is not None:
                calls += [partial(handle.callback, parameter) for handle in handles]
        calls += [partial(handle.callback, event) for handle in self.event_callbacks]
        call_all(calls)


class ParameterEventHandler:
    """Calls callbacks for the events on /parameter_events.

    Args:
        node: The node that subscribes.
        qos_profile: QoS of the subscription.
        callback_group: Group of the callbacks.
        event_callbacks: Callbacks for the subscription's events.
        qos_overriding_options: As for a subscription.
        raw: Not supported, because callbacks take messages.
    """

    def __init__(
        self,
        node: NodeBase,
        qos_profile: QoSProfile = qos_profile_parameter_events,
        callback_group: CallbackGroup | None = None,
        event_callbacks: SubscriptionEventCallbacks | None = None,
        qos_overriding_options: Any = None,
        raw: bool = False,
    ) -> None:
        if raw:
            raise NotImplementedError(
                "ParameterEventHandler has no raw=True, because its callbacks take messages"
            )
        self.node = node
        self.qos_profile = qos_profile
        self._callbacks = _Callbacks()
        self.parameter_event_subscription = node.create_subscription(
            ParameterEvent,
            "/parameter_events",
            self._callbacks.event_callback,
            qos_profile,
            callback_group=callback_group,
            event_callbacks=event_callbacks,
            qos_overriding_options=qos_overriding_options,
        )

    def add_parameter_callback(
        self, parameter_name: str, node_name: str, callback: Callable[[Parameter], None]
    ) -> ParameterCallbackHandle:
        """Call `callback(parameter)` with the message when a parameter is set; the last added is called first.

        Args:
            parameter_name: The parameter.
            node_name: The node; a relative name is in this node's namespace.
            callback: Called with the parameter's message.
        """
        handle = ParameterCallbackHandle(parameter_name, self._full_name(node_name), callback)
        self._callbacks.parameter_callbacks[_key(handle)].insert(0, handle)
        return handle

    def _full_name(self, node_name: str) -> str:
        if not node_name:
            return self.node.get_fully_qualified_name()
        return (
            node_name if node_name.startswith("/") else full_node_name(self.node.get_namespace(), node_name)
        )

    def add_parameter_event_callback(
        self, callback: Callable[[ParameterEvent], None]
    ) -> ParameterEventCallbackHandle:
        """Call `callback(event)` with every change; the last added is called first."""
        handle = ParameterEventCallbackHandle(callback)
        self._callbacks.event_callbacks.insert(0, handle)
        return handle

    def remove_parameter_callback(self, handle: ParameterCallbackHandle) -> None:
        """Undo one `add_parameter_callback`; RuntimeError if that has been done."""
        _remove_handle(self._callbacks.parameter_callbacks[_key(handle)], handle)

    def remove_parameter_event_callback(self, handle: ParameterEventCallbackHandle) -> None:
        """Undo one `add_parameter_event_callback`; RuntimeError if that has been done."""
        _remove_handle(self._callbacks.event_callbacks, handle)

    def configure_nodes_filter(self, node_names: list[str] | None = None) -> bool:
        """Receive only the events of some nodes, by a content filter; None, or no name: those of all.

        Args:
            node_names: The nodes; a relative name is in this node's namespace.

        Returns:
            Whether the subscription has a content filter now.

        Raises:
            TypeError: a name is not a text, or there is a text in place of the list.
            RCLError: there are more names than an expression may have parameters; the filter is as before.
        """
        if isinstance(node_names, str) or not all(isinstance(name, str) for name in node_names or ()):
            raise TypeError(f"configure_nodes_filter() needs a list of names of nodes, got {node_names!r}")
        names = [self._full_name(name) for name in node_names or ()]
        expression = " OR ".join(f"node = %{number}" for number in range(len(names)))
        self.parameter_event_subscription.set_content_filter(expression, [f"'{name}'" for name in names])
        return self.parameter_event_subscription.is_cft_enabled

    def destroy(self) -> None:
        """Stop listening: destroy the subscription."""
        self.node.destroy_subscription(self.parameter_event_subscription)

    @staticmethod
    def get_parameter_from_event(
        event: ParameterEvent, parameter_name: str, node_name: str
    ) -> Parameter | None:
        """Return the parameter that an event set, by name and node, or None."""
        if event.node != node_name:
            return None
        for parameter in ParameterEventHandler.get_parameters_from_event(event):
            if parameter.name == parameter_name:
                return parameter
        return None

    @staticmethod
    def get_parameters_from_event(event: ParameterEvent) -> Iterable[Parameter]:
        """Return all parameters that an event set, new and changed ones."""
        yield from event.new_parameters
        yield from event.changed_parameters


def _key(handle: ParameterCallbackHandle) -> tuple[str, str]:
    return handle.parameter_name, handle.node_name


def _remove_handle(handles: list[Any], handle: Any) -> None:
    if handle not in handles:
        raise RuntimeError("Callback doesn't exist")
    handles.remove(handle)

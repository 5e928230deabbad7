"""Lifecycle nodes, whose state services return and change, and a topic publishes."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from typing import TYPE_CHECKING, Any, cast

from tfloom.interfaces.lifecycle_msgs.msg import TransitionDescription, TransitionEvent
from tfloom.interfaces.lifecycle_msgs.srv import (
    ChangeState,
    GetAvailableStates,
    GetAvailableTransitions,
    GetState,
)
from tfloom.node.lifecycle.managed_entity import LifecyclePublisher, ManagedEntity, TransitionCallbackReturn
from tfloom.node.lifecycle.state_machine import (
    ACTIVATING,
    CLEANINGUP,
    CONFIGURING,
    DEACTIVATING,
    ERRORPROCESSING,
    SHUTTINGDOWN,
    STATES,
    STEPS,
    LifecycleState,
    StateMachine,
    Step,
)
from tfloom.node.node import Node
from tfloom.node.values.callback_errors import print_error
from tfloom.node.values.exceptions import InvalidHandle, RCLError
from tfloom.ros_imports import ros_distro

if TYPE_CHECKING:
    from tfloom.node.endpoints.publisher import Publisher
    from tfloom.node.executing.callback_groups import CallbackGroup

__all__ = ["LifecycleNode", "LifecycleNodeMixin", "LifecycleState"]


class LifecycleNodeMixin(ManagedEntity):
    """The lifecycle of a node; a base class before Node, initialised after it.

    Args:
        enable_communication_interface: Whether it has the services that change its state, and the topic of it.
        callback_group: Group of these services; None: the node's own.
    """

    def __init__(
        self, *, enable_communication_interface: bool = True, callback_group: CallbackGroup | None = None
    ) -> None:
        self._state_machine = StateMachine()
        self.__entities: list[ManagedEntity] = []
        self.__events: Publisher[TransitionEvent] | None = None
        self.__callbacks: dict[LifecycleState, Callable[[LifecycleState], TransitionCallbackReturn]] = {
            CONFIGURING: self.on_configure,
            CLEANINGUP: self.on_cleanup,
            SHUTTINGDOWN: self.on_shutdown,
            ACTIVATING: self.on_activate,
            DEACTIVATING: self.on_deactivate,
            ERRORPROCESSING: self.on_error,
        }
        if enable_communication_interface:
            self.__serve(callback_group)

    def __serve(self, callback_group: CallbackGroup | None) -> None:
        node = self.__node
        self.__events = node.create_publisher(TransitionEvent, "~/transition_event", 10)
        services: tuple[tuple[Any, str, Callable[[Any, Any], Any]], ...] = (
            (ChangeState, "change_state", self.__on_change_state),
            (GetState, "get_state", self.__on_get_state),
            (GetAvailableStates, "get_available_states", self.__on_get_available_states),
            (GetAvailableTransitions, "get_available_transitions", self.__on_get_available_transitions),
            (GetAvailableTransitions, "get_transition_graph", self.__on_get_transition_graph),
        )
        for srv_type, name, callback in services:
            service = node.create_service(srv_type, f"~/{name}", callback, callback_group=callback_group)
            setattr(self, f"_service_{name}", service)

    @property
    def __node(self) -> Node:
        if not isinstance(self, Node):
            raise TypeError(f"{type(self).__name__} must derive from Node as well as from LifecycleNodeMixin")
        return self

    # Transition callbacks

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Configure; by default, the managed entities. `state` is the state before the transition, here as below."""
        return self.__call_entities("on_configure", state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Undo `on_configure`; by default, of the managed entities."""
        return self.__call_entities("on_cleanup", state)

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Clean up before the finalized state; by default, the managed entities."""
        return self.__call_entities("on_shutdown", state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Start working; by default, the managed entities."""
        return self.__call_entities("on_activate", state)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Stop working; by default, the managed entities."""
        return self.__call_entities("on_deactivate", state)

    def on_error(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Clean up after an error; by default, the managed entities."""
        return self.__call_entities("on_error", state)

    def __call_entities(self, name: str, state: LifecycleState) -> TransitionCallbackReturn:
        for entity in self.__entities:
            result = getattr(entity, name)(state)
            if result is not TransitionCallbackReturn.SUCCESS:
                return TransitionCallbackReturn(result)
        return TransitionCallbackReturn.SUCCESS

    # Managed entities

    def add_managed_entity(self, entity: ManagedEntity) -> None:
        """Add an entity, whose callbacks are called at each transition."""
        self.__entities.append(entity)

    def create_lifecycle_publisher(
        self, *args: Any, publisher_class: type[LifecyclePublisher[Any]] | None = None, **kwargs: Any
    ) -> LifecyclePublisher[Any]:
        """Create a publisher that publishes while the node is active; see `Node.create_publisher`.

        Args:
            args: Type of the messages, topic, QoS.
            publisher_class: Class of the publisher, which derives from LifecyclePublisher; None: this one.
            kwargs: Further arguments of `Node.create_publisher`.

        Raises:
            TypeError: `publisher_class` doesn't derive from LifecyclePublisher.
        """
        own_class = LifecyclePublisher if publisher_class is None else publisher_class
        if not (isinstance(own_class, type) and issubclass(own_class, LifecyclePublisher)):
            raise TypeError(
                "create_lifecycle_publisher() needs a publisher_class that derives from LifecyclePublisher, "
                f"got {own_class!r}"
            )
        publisher = cast(
            "LifecyclePublisher[Any]",
            self.__node.create_publisher(*args, **kwargs, publisher_class=own_class),
        )
        self.add_managed_entity(publisher)
        return publisher

    def destroy_lifecycle_publisher(self, publisher: LifecyclePublisher[Any]) -> bool:
        """Destroy a lifecycle publisher; False if it isn't this node's."""
        if publisher in self.__entities:
            self.__entities.remove(publisher)
        return self.__node.destroy_publisher(publisher)

    # Transitions

    def trigger_configure(self) -> TransitionCallbackReturn:
        """Change from unconfigured to inactive; RCLError in any other state."""
        return self.__trigger("configure")

    def trigger_cleanup(self) -> TransitionCallbackReturn:
        """Change from inactive to unconfigured; RCLError in any other state."""
        return self.__trigger("cleanup")

    def trigger_shutdown(self) -> TransitionCallbackReturn:
        """Change to finalized; RCLError in that state."""
        return self.__trigger("shutdown")

    def trigger_activate(self) -> TransitionCallbackReturn:
        """Change from inactive to active; RCLError in any other state."""
        return self.__trigger("activate")

    def trigger_deactivate(self) -> TransitionCallbackReturn:
        """Change from active to inactive; RCLError in any other state."""
        return self.__trigger("deactivate")

    def __trigger(self, label: str) -> TransitionCallbackReturn:
        return self.__make_transition(self._state_machine.find(0, label))

    def __make_transition(self, step: Step) -> TransitionCallbackReturn:
        """Make a transition to its end, and return the result of its first callback."""
        # A transition leads to a state that lasts while its callback runs, whose result decides on the state after it.
        # An error leads to one more such state, in which `on_error` decides whether the node can be configured again.
        self.__enter_state(step)
        result = self.__run_callback(step.start)
        self.__enter_state(self._state_machine.outcome(result))
        if self._state_machine.state == ERRORPROCESSING:
            self.__enter_state(self._state_machine.outcome(self.__run_callback(step.start)))
        return result

    def __run_callback(self, previous: LifecycleState) -> TransitionCallbackReturn:
        try:
            return TransitionCallbackReturn(self.__callbacks[self._state_machine.state](previous))
        except Exception as error:  # on_error follows
            state = self._state_machine.state.label
            self.__node.get_logger().error(f"Error raised while {state}: {error}")
            print_error(error)
            return TransitionCallbackReturn.ERROR

    def __enter_state(self, step: Step) -> None:
        self._state_machine.state = step.goal
        if self.__events is None:
            return
        event = TransitionEvent(
            transition=step.transition_msg(), start_state=step.start.to_msg(), goal_state=step.goal.to_msg()
        )
        now = self.__node.get_clock().now()
        if ros_distro.HAS_LATER_DEFINITIONS:
            event.stamp = now.to_msg()  # type: ignore[attr-defined]  # type checkers see Jazzy's form
        else:
            event.timestamp = now.nanoseconds
        with suppress(InvalidHandle):  # a node that was destroyed still changes its state
            self.__events.publish(event)

    # Services

    def __on_change_state(self, request: Any, response: Any) -> Any:
        try:
            step = self._state_machine.find(request.transition.id, request.transition.label)
        except RCLError as error:
            self.__node.get_logger().warning(str(error))
            response.success = False
            return response
        response.success = self.__make_transition(step) is TransitionCallbackReturn.SUCCESS
        return response

    def __on_get_state(self, request: Any, response: Any) -> Any:
        response.current_state = self._state_machine.state.to_msg()
        return response

    def __on_get_available_states(self, request: Any, response: Any) -> Any:
        response.available_states = [state.to_msg() for state in STATES]
        return response

    def __on_get_available_transitions(self, request: Any, response: Any) -> Any:
        response.available_transitions = [
            _transition_description(step) for step in self._state_machine.available()
        ]
        return response

    def __on_get_transition_graph(self, request: Any, response: Any) -> Any:
        response.available_transitions = [_transition_description(step) for step in STEPS]
        return response


def _transition_description(step: Step) -> TransitionDescription:
    return TransitionDescription(
        transition=step.transition_msg(), start_state=step.start.to_msg(), goal_state=step.goal.to_msg()
    )


class LifecycleNode(LifecycleNodeMixin, Node):
    """A node with a lifecycle: unconfigured, inactive, active, finalized.

    Args:
        node_name: Its name.
        enable_communication_interface: Whether it has the services that change its state, and the topic of it.
        kwargs: As for Node.
    """

    def __init__(self, node_name: str, *, enable_communication_interface: bool = True, **kwargs: Any) -> None:
        Node.__init__(self, node_name, **kwargs)
        LifecycleNodeMixin.__init__(self, enable_communication_interface=enable_communication_interface)

"""The action that starts a lifecycle node, follows its state and changes it."""

from __future__ import annotations

import functools
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any, cast

from tfloom.launch.actions.opaque import OpaqueFunction
from tfloom.launch.core.base_classes import LaunchDescriptionEntity, SomeSubstitutionsType
from tfloom.launch.core.entity import Entity, ParsesActions
from tfloom.launch.core.event import Event
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.entities.event_handler import EventHandler
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.logs.logging import get_logger
from tfloom.launch.ros.actions.node import Node
from tfloom.launch.ros.lifecycle_events import ChangeState, StateTransition
from tfloom.launch.ros.ros_adapters import get_ros_node
from tfloom.launch.ros.service_calls import call_service

if TYPE_CHECKING:
    from tfloom.node.endpoints.client import Client

__all__ = ["LifecycleNode"]


@expose_action("lifecycle_node")
class LifecycleNode(Node):
    """Starts a lifecycle node; emits StateTransition after its transitions, and handles ChangeState.

    Args:
        name: Name of the node.
        namespace: Namespace of the node.
        kwargs: As for Node.
    """

    def __init__(
        self, *, name: SomeSubstitutionsType, namespace: SomeSubstitutionsType, **kwargs: Any
    ) -> None:
        super().__init__(name=name, namespace=namespace, **kwargs)
        self._transition_logger = get_logger("launch_ros.actions.lifecycle_node")
        self._client: Client | None = None
        # One thread, so that requests arrive in the order of their events.
        self._calls = ThreadPoolExecutor(max_workers=1, thread_name_prefix="change_state")

    @classmethod
    def parse(
        cls, entity: Entity, parser: ParsesActions, ignore: list[str] | None = None
    ) -> tuple[type[Action], dict[str, Any]]:
        """Return the class, and the arguments that the element of a launch file gives its constructor.

        Without the attribute `namespace` the node is in that of PushROSNamespace.
        """
        _, kwargs = super().parse(entity, parser, ignore)
        kwargs["name"] = parser.parse_substitution(entity.get_attr("name"))
        kwargs.setdefault("namespace", "")
        return cls, kwargs

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Start the process, and follow its state."""
        from tfloom.interfaces.lifecycle_msgs.msg import TransitionEvent
        from tfloom.interfaces.lifecycle_msgs.srv import ChangeState as ChangeStateService

        self._perform_substitutions(context)
        if not self.is_node_name_fully_specified():
            raise RuntimeError("node_name unexpectedly incomplete for lifecycle node")
        node = get_ros_node(context)
        node.create_subscription(
            TransitionEvent,
            f"{self.node_name}/transition_event",
            functools.partial(self._on_transition_event, context),
            10,
        )
        self._client = node.create_client(ChangeStateService, f"{self.node_name}/change_state")
        context.register_event_handler(
            EventHandler(matcher=self._is_for_this, entities=[OpaqueFunction(function=self._change_state)])
        )
        return super().execute(context)

    def _on_transition_event(self, context: LaunchContext, message: Any) -> None:
        """Emit the event on the launch's thread; called on the thread of the launch's node."""
        loop = context.asyncio_loop
        if loop is None or context.is_shutdown:
            return
        event = StateTransition(action=self, msg=message)
        try:
            loop.call_soon_threadsafe(context.emit_event_sync, event)
        except RuntimeError as error:  # the loop was closed
            self._transition_logger.debug("Exception in handling of 'lifecycle.StateTransition': %r", error)

    def _is_for_this(self, event: Event) -> bool:
        return isinstance(event, ChangeState) and bool(event.lifecycle_node_matcher(self))

    def _change_state(self, context: LaunchContext) -> None:
        """Call the service on a thread, which the launch waits for."""
        event = cast("ChangeState", context.locals.event)
        loop = context.asyncio_loop
        if loop is None:
            raise RuntimeError("a ChangeState event can only be handled while the launch runs")
        # On the launch's own thread, the wait for the service would hold up all events, the shutdown among them. The
        # future keeps the launch from its idle end until the call has returned.
        context.add_completion_future(
            loop.run_in_executor(self._calls, self._call_change_state, event.transition_id, context)
        )

    def _call_change_state(self, transition_id: int, context: LaunchContext) -> None:
        from tfloom.interfaces.lifecycle_msgs.srv import ChangeState as ChangeStateService

        if self._client is None:
            return
        request = ChangeStateService.Request()
        request.transition.id = transition_id
        response = call_service(self._client, request, context, self._transition_logger)
        if response is None or not response.success:
            self._transition_logger.error(
                "Failed to make transition '%s' for LifecycleNode '%s'",
                ChangeState.valid_transitions[transition_id],
                self.node_name,
            )

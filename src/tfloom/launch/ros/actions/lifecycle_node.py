"""The action that starts a lifecycle node, follows its state and changes it."""

from __future__ import annotations

import functools
from concurrent.futures import ThreadPoolExecutor
from typing import TYPE_CHECKING, Any, cast

from tfloom.launch.action import Action
from tfloom.launch.actions.opaque import OpaqueFunction
from tfloom.launch.event import Event
from tfloom.launch.event_handler import EventHandler
from tfloom.launch.frontend.entity import Entity, ParsesActions
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.launch_description_entity import LaunchDescriptionEntity
from tfloom.launch.logging import get_logger
from tfloom.launch.ros.actions.node import Node
from tfloom.launch.ros.events.lifecycle_events import ChangeState, StateTransition
from tfloom.launch.ros.ros_adapters import get_ros_node
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType

if TYPE_CHECKING:
    from tfloom.node.endpoints.client import Client

__all__ = ["LifecycleNode"]

_POLL_S = 0.2
"""The longest time until a wait notices the shutdown of the launch [s]."""


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
        from tfloom.node.values.exceptions import InvalidHandle

        client = self._client
        if client is None:
            return
        request = ChangeStateService.Request()
        request.transition.id = transition_id
        # Both waits are polls, because nothing wakes them at the shutdown. The launch's thread destroys the node of the
        # client then, maybe in the middle of a call: hence InvalidHandle.
        try:
            while not client.wait_for_service(timeout_sec=_POLL_S):
                if context.is_shutdown:
                    self._warn_of_abandoned_wait(f"'{client.srv_name}' service")
                    return
            future = client.call_async(request)
            if not _wait(future, context):
                self._warn_of_abandoned_wait(f"'{client.srv_name}' service response")
                return
            response = future.result()
        except InvalidHandle:  # the launch was shut down in between
            return
        if response is None or not response.success:
            self._transition_logger.error(
                "Failed to make transition '%s' for LifecycleNode '%s'",
                ChangeState.valid_transitions[transition_id],
                self.node_name,
            )

    def _warn_of_abandoned_wait(self, what: str) -> None:
        self._transition_logger.warning("Abandoning wait for the %s, due to shutdown.", what)


def _wait(future: Any, context: LaunchContext) -> bool:
    """Wait for a reply, and return whether it came before the shutdown of the launch."""
    import threading

    done = threading.Event()
    future.add_done_callback(lambda _: done.set())
    while not done.wait(_POLL_S):
        if context.is_shutdown:
            return False
    return True

"""Service introspection: events about the requests and responses of a service or client."""

from __future__ import annotations

from collections.abc import Callable
from enum import IntEnum
from typing import TYPE_CHECKING, Any

from tfloom.interfaces.service_msgs.msg import ServiceEventInfo
from tfloom.node.qos.qos import QoSProfile
from tfloom.rmw.typed_names import SERVICE_EVENTS
from tfloom.rosidl.message import Message
from tfloom.rosidl.service import Service as ServiceType

if TYPE_CHECKING:
    from tfloom.node.clock.clock import Clock
    from tfloom.node.endpoints.publisher import Publisher
    from tfloom.rmw.base import RequestId

__all__ = ["Introspection", "ServiceIntrospectionState"]


class ServiceIntrospectionState(IntEnum):
    """The events that are published."""

    OFF = 0
    METADATA = 1
    """The id of each request or response sent or received, and its stamp."""
    CONTENTS = 2
    """The request or response, too."""


class Introspection:
    """Publishes the events of one endpoint of a service.

    Args:
        srv_type: The service's class.
        srv_name: Its full name.
        create_publisher: Creates a publisher of a type, on a topic, with a QoS.
        destroy_publisher: Destroys it.
    """

    def __init__(
        self,
        srv_type: type[ServiceType],
        srv_name: str,
        create_publisher: Callable[[type[Message], str, QoSProfile], Publisher[Any]],
        destroy_publisher: Callable[[Publisher[Any]], bool],
    ) -> None:
        self._event_type: type[Any] = srv_type.Event
        self._topic = srv_name + SERVICE_EVENTS
        self._create = create_publisher
        self._destroy = destroy_publisher
        self._publisher: Publisher[Any] | None = None
        self._clock: Clock | None = None
        self._with_contents = False

    def configure(self, clock: Clock, qos_profile: QoSProfile, state: ServiceIntrospectionState) -> None:
        """Set what is published, with which clock and QoS."""
        self.close()
        self._clock = clock
        self._with_contents = state is ServiceIntrospectionState.CONTENTS
        if state is not ServiceIntrospectionState.OFF:
            self._publisher = self._create(self._event_type, self._topic, qos_profile)

    def request_sent(self, request: Message, request_id: RequestId) -> None:
        """Publish that a client sent a request."""
        self._publish(ServiceEventInfo.REQUEST_SENT, request_id, request=request)

    def request_received(self, request: Message, request_id: RequestId) -> None:
        """Publish that a server received a request."""
        self._publish(ServiceEventInfo.REQUEST_RECEIVED, request_id, request=request)

    def response_sent(self, response: Message, request_id: RequestId) -> None:
        """Publish that a server sent a response."""
        self._publish(ServiceEventInfo.RESPONSE_SENT, request_id, response=response)

    def response_received(self, response: Message, request_id: RequestId) -> None:
        """Publish that a client received a response."""
        self._publish(ServiceEventInfo.RESPONSE_RECEIVED, request_id, response=response)

    def _publish(self, event_type: int, request_id: RequestId, **contents: Message) -> None:
        if self._publisher is None or self._clock is None:
            return
        info = ServiceEventInfo(
            event_type=event_type,
            stamp=self._clock.now().to_msg(),
            client_gid=list(request_id.client_gid),
            sequence_number=request_id.sequence_number,
        )
        parts = {name: [message] for name, message in contents.items()} if self._with_contents else {}
        self._publisher.publish(self._event_type(info=info, **parts))

    def close(self) -> None:
        """Stop publishing, and destroy the publisher."""
        if self._publisher is not None:
            self._destroy(self._publisher)
            self._publisher = None

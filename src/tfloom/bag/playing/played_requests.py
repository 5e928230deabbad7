"""Recorded requests, sent again to a service."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tfloom.interfaces.service_msgs.msg import ServiceEventInfo
from tfloom.node.base.node_base import open_endpoint
from tfloom.node.qos.qos import qos_profile_services_default
from tfloom.rmw.errors import WireError
from tfloom.rmw.typed_names import service_of
from tfloom.rosidl import cdr
from tfloom.rosidl.registry import get_service_class

if TYPE_CHECKING:
    from tfloom.node.node import Node
    from tfloom.rmw.base import Requester

__all__ = ["PlayedRequests"]


class PlayedRequests:
    """Sends the requests that events of a service's introspection hold.

    Args:
        node: The node that has the client.
        service: Name of the service.
        type_name: `package/srv/Name`.
        is_client_source: Whether events of clients are used, not those of servers.
    """

    def __init__(self, node: Node, service: str, type_name: str, is_client_source: bool) -> None:
        self._node = node
        self._service = service
        self._wanted = (
            ServiceEventInfo.REQUEST_SENT if is_client_source else ServiceEventInfo.REQUEST_RECEIVED
        )
        self._event: Any = None
        self._requester: Requester | None = None
        self._has_warned = False
        try:
            kind = get_service_class(type_name)
        except LookupError as error:
            self._warn(f"Requests to '{service}' can't be sent: {error}")
            return
        self._event = kind.Event
        self._requester = open_endpoint(
            node,
            self,
            lambda participant, node_name: participant.create_requester(
                node_name, service_of(kind, service), qos_profile_services_default.to_wire()
            ),
        )

    def send(self, data: bytes) -> None:
        """Send the request in an event, if it has one of the wanted source."""
        if self._requester is None:
            return
        try:
            event = cdr.decode(self._event, data)
        except cdr.DecodeError as error:
            self._warn(f"An event of '{self._service}' can't be read: {error}")
            return
        if event.info.event_type != self._wanted:
            return
        if not event.request:
            self._warn(
                f"The events of '{self._service}' have no requests, because its introspection was set to metadata only."
            )
        elif not self._requester.is_ready():
            self._warn(f"There is no server of '{self._service}'; requests to it are left out.")
        else:
            self._send(self._requester, cdr.encode(event.request[0]))

    def _send(self, requester: Requester, request: bytes) -> None:
        try:
            requester.send(request)
            while requester.take() is not None:
                pass
        except WireError as error:
            self._warn(f"A request to '{self._service}' can't be sent: {error}")

    def destroy(self) -> None:
        """Close the client, if one could be made."""
        if self._requester is not None:
            self._requester.close()

    def _warn(self, text: str) -> None:
        """Warn, unless a warning about this service was logged before."""
        if not self._has_warned:
            self._has_warned = True
            self._node.get_logger().warning(text)

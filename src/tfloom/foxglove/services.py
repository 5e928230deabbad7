"""The services of a graph, which clients call."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from foxglove import MessageSchema, Service, ServiceRequest, ServiceSchema

from tfloom.foxglove.calls import Call
from tfloom.foxglove.channels import schema_of
from tfloom.foxglove.shares import Load
from tfloom.rosidl import cdr

if TYPE_CHECKING:
    from foxglove.websocket import WebSocketServer

    from tfloom.foxglove.calls import Calls
    from tfloom.foxglove.known_types import KnownTypes
    from tfloom.foxglove.settings import Settings

__all__ = ["Services"]

TIMEOUT_S = 5.0
"""The longest wait for a response [s]."""
MAX_CALLS = 256
"""Number of calls of all clients that wait for a response; further ones fail at once."""
MAX_CALL_BYTES = 100_000_000
"""Sum of the sizes of their requests."""


class TooManyCallsError(Exception):
    """A client has as many calls under way as it may have."""


class Services:
    """Keeps the server's services as those of the graph. Used on the node's thread, but for the calls.

    Args:
        server: The server.
        calls: Calls them.
        settings: Which of them clients see.
        types: Finds their types.
        warn: Tells clients and the log a sentence, on any thread.
    """

    def __init__(
        self,
        server: WebSocketServer,
        calls: Calls,
        settings: Settings,
        types: KnownTypes,
        warn: Callable[[str], None],
    ) -> None:
        self._server = server
        self._calls = calls
        self._settings = settings
        self._offered: dict[str, str] = {}
        """The type of each service that clients see, by its name."""
        self._types = types
        self._warn = warn
        self._under_way = Load(MAX_CALLS, MAX_CALL_BYTES)

    def update(self, served: Mapping[str, str]) -> None:
        """Offer new services, and take back those that are gone.

        Args:
            served: The type of each service that has a server, by its name.
        """
        services = {
            name: type_name
            for name, type_name in served.items()
            if self._settings.shows(name, self._settings.services)
        }
        gone = [name for name, type_name in self._offered.items() if services.get(name) != type_name]
        if gone:
            self._server.remove_services(gone)
            for name in gone:
                del self._offered[name]
        new = [
            service
            for name, type_name in sorted(services.items())
            if name not in self._offered and (service := self._service(name, type_name)) is not None
        ]
        if new:
            self._server.add_services(new)
            self._offered |= {service.name: service.schema.name for service in new}

    def _service(self, name: str, type_name: str) -> Service | None:
        service_class = self._types.find(type_name, "srv", f"{name} is not offered")
        if service_class is None:
            return None
        schema = ServiceSchema(
            type_name, request=_schema(f"{type_name}_Request"), response=_schema(f"{type_name}_Response")
        )
        return Service(name, schema=schema, handler=self._handler(name, service_class))

    def _handler(self, name: str, service_class: type[Any]) -> Callable[[ServiceRequest], bytes]:
        def handle(request: ServiceRequest) -> bytes:
            if request.encoding != "cdr":
                raise ValueError(f"requests to {name} have to be cdr, not {request.encoding}")
            client, size = request.client_id, len(request.payload)
            if not self._under_way.take(client, size):
                text = f"client {client} calls {name} while as many calls wait for a response as it may have"
                self._warn(text)
                raise TooManyCallsError(text)
            try:
                decoded = cdr.decode(service_class.Request, bytes(request.payload))
                return cdr.encode(self._calls.call(Call(service_class, name, decoded), TIMEOUT_S))
            finally:
                self._under_way.give_back(client, size)

        return handle


def _schema(type_name: str) -> MessageSchema:
    return MessageSchema(encoding="cdr", schema=schema_of(type_name))

"""The bridge's own client, by which it publishes the connection graph and changed parameters.

The SDK calls the listener while it holds a lock: when the connection graph gets its first subscriber or loses its last
one, and when parameters are subscribed to. Its functions in Python that publish these wait for the same lock with the
GIL held, so that the listener, which needs the GIL, would never return: the whole program would hang. With this client
neither happens. It stays subscribed to the connection graph, so that no other client is the first or the last. It also
asks to set what has changed; the listener answers with the new values, and the SDK publishes them on a thread of its
own, which doesn't hold the GIL.
"""

from __future__ import annotations

import json
import threading
from collections.abc import Iterable
from secrets import token_hex
from typing import TYPE_CHECKING

from websockets.exceptions import WebSocketException
from websockets.sync.client import connect
from websockets.typing import Subprotocol

if TYPE_CHECKING:
    from foxglove import ConnectionGraph, Parameter
    from foxglove.websocket import WebSocketServer
    from websockets.sync.connection import Connection

    from tfloom.common.inner_port import InnerPort
    from tfloom.node.log.rcutils_logger import RcutilsLogger

__all__ = ["OwnClient"]

SUBPROTOCOL = Subprotocol("foxglove.sdk.v1")
RETRY_S = 1.0
"""Time between a failure to connect and the next try [s]."""
OPEN_S = 10.0
"""The longest wait for a connection [s]."""
NOT_CONNECTED = (
    "Clients get no connection graph and no changed parameters until the bridge is connected to itself"
)
CLOSE_S = 1.0
"""The longest wait for the connection's and the thread's end [s]."""


class OwnClient:
    """A client of the bridge's server, which reads on a separate thread, and connects again where that fails.

    Args:
        server: The bridge's server.
        inner: Its port.
        capabilities: Those of the bridge.
        logger: The bridge's.
    """

    def __init__(
        self,
        server: WebSocketServer,
        inner: InnerPort,
        capabilities: Iterable[str],
        logger: RcutilsLogger,
    ) -> None:
        self._server = server
        self._inner = inner
        self._capabilities = set(capabilities)
        self._logger = logger
        self._secret = token_hex()
        """The id of its requests, by which the listener knows them from those of others."""
        self._lock = threading.Lock()
        """Guards the members below."""
        self._is_subscribed = False
        self._changed: dict[str, Parameter] = {}
        self._connection: Connection | None = None
        self._is_closed = threading.Event()
        self._thread = threading.Thread(target=self._run, name="foxglove_bridge_client", daemon=True)

    def start(self) -> None:
        """Connect, and stay connected.

        Raises:
            RuntimeError: the system gives no thread.
        """
        self._thread.start()

    def publish_connections(self, connections: ConnectionGraph) -> bool:
        """Publish the connection graph, if this client is subscribed to it; return whether it was."""
        with self._lock:  # `close` waits for it: from then on the last subscriber can be another client
            if self._is_subscribed:
                self._server.publish_connection_graph(connections)
            return self._is_subscribed

    def publish_parameters(self, parameters: Iterable[Parameter]) -> None:
        """Publish parameters to the clients that subscribe to them, soon."""
        with self._lock:
            is_asked = bool(self._changed)
            self._changed |= {parameter.name: parameter for parameter in parameters}
            connection = self._connection
        # One request is on its way at most, so that sending never has to wait for the server.
        if connection is not None and self._changed and not is_asked:
            self._ask(connection)

    def changed_parameters(self, request_id: str | None) -> list[Parameter] | None:
        """Return what is to be published for a request of this client; None for a request of another."""
        if request_id != self._secret:
            return None
        with self._lock:
            changed, self._changed = self._changed, {}
        return list(changed.values())

    def close(self) -> None:
        """Close the connection. Nothing is published after."""
        self._is_closed.set()
        with self._lock:
            self._is_subscribed = False
            connection = self._connection
        if connection is not None:
            connection.close()
        if self._thread.ident is not None:
            self._thread.join(CLOSE_S)

    def _ask(self, connection: Connection) -> None:
        try:
            connection.send(json.dumps({"op": "setParameters", "parameters": [], "id": self._secret}))
        except WebSocketException:
            return  # the thread connects again, and asks then

    # On its own thread.

    def _run(self) -> None:
        is_reported = False
        while not self._is_closed.is_set():
            try:
                self._serve()
            except (OSError, WebSocketException) as error:
                if not self._is_closed.is_set() and not is_reported:
                    is_reported = True
                    text = f"{NOT_CONNECTED}: {type(error).__name__}: {error}"
                    self._logger.warning(text)
            with self._lock:
                self._is_subscribed = False
                self._connection = None
            self._is_closed.wait(RETRY_S)

    def _serve(self) -> None:
        """Connect, and read until the connection ends."""
        with (
            self._inner.connect(OPEN_S) as way_in,
            connect(
                f"ws://{self._inner.host}:{self._inner.port}",
                sock=way_in,
                subprotocols=[SUBPROTOCOL],
                open_timeout=OPEN_S,
                close_timeout=CLOSE_S,
                ping_interval=None,
                max_size=None,
                proxy=None,
            ) as connection,
        ):
            with self._lock:
                self._connection = connection
                has_changed = bool(self._changed)
            if self._is_closed.is_set():
                return
            if has_changed:
                self._ask(connection)
            if "connectionGraph" in self._capabilities:
                connection.send(json.dumps({"op": "subscribeConnectionGraph"}))
            for message in connection:
                # The first update answers the subscription.
                if (
                    not self._is_subscribed
                    and isinstance(message, str)
                    and "connectionGraphUpdate" in message
                ):
                    with self._lock:
                        self._is_subscribed = not self._is_closed.is_set()

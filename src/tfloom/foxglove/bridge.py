"""The node that serves its graph to clients."""

from __future__ import annotations

import threading
import time
from collections import defaultdict
from collections.abc import Callable, Iterable
from functools import partial
from typing import TYPE_CHECKING

import foxglove
from foxglove import ConnectionGraph, Context
from foxglove.websocket import Capability, ServerListener

from tfloom.common.access import ClientAccess
from tfloom.common.inner_port import InnerPort
from tfloom.foxglove.assets import AssetError, read_asset
from tfloom.foxglove.calls import Calls
from tfloom.foxglove.channels import Channels
from tfloom.foxglove.client_topics import ClientTopic, ClientTopicError, ClientTopics
from tfloom.foxglove.commands import Commands
from tfloom.foxglove.complaints import Complaints
from tfloom.foxglove.known_types import KnownTypes
from tfloom.foxglove.own_client import OwnClient
from tfloom.foxglove.parameters import MAX_PARAMETERS, Parameters, from_message
from tfloom.foxglove.relay import Relay, listen
from tfloom.foxglove.services import Services
from tfloom.foxglove.settings import TIME, Settings
from tfloom.interfaces.rcl_interfaces.msg import ParameterEvent
from tfloom.interfaces.rosgraph_msgs.msg import Clock as ClockMessage
from tfloom.node.clock.clock import Clock
from tfloom.node.node import Node
from tfloom.node.qos.qos import QoSProfile
from tfloom.node.values.time import ClockType
from tfloom.rmw.qos import ReliabilityPolicy

if TYPE_CHECKING:
    from foxglove import Parameter, SystemInfoPublisher
    from foxglove.websocket import ChannelView, Client, ClientChannel, WebSocketServer

    from tfloom.node.context.context import Context as RosContext

__all__ = ["BridgeError", "FoxgloveBridge"]

UPDATE_S = 0.25
"""Period at which the graph is looked at [s]."""
CONNECTIONS_S = 1.0
"""Period at which the connection graph is published, where it has changed [s]."""
STOP_S = 2.0
"""The longest wait for clients to take what was sent to them before the end [s]."""
OPEN_INSIDE = (
    "This system has no way to close the port at which foxglove-sdk listens behind this one: a page of any site that "
    "finds it in this machine's browser can drive robots"
)
MAX_ASKING = 4
"""Number of requests for parameters that wait for nodes at once."""
SLOT_S = 0.5
"""How long a further one waits for its turn [s]."""
MAX_ASSETS = 4
"""Number of files that are read at once for all clients."""
MAX_ASSET_BYTES = 512 * 1024 * 1024
"""Size of the files that go to clients while one of them takes nothing."""
STUCK_S = 5.0
"""How long a client may take nothing then, until it is cut off [s]."""
MAX_REFUSALS = 100
"""Number of reasons for which connections are refused that are logged."""
CAPABILITIES = {
    "clientPublish": Capability.ClientPublish,
    "parameters": Capability.Parameters,
    "services": Capability.Services,
    "connectionGraph": Capability.ConnectionGraph,
}


class BridgeError(Exception):
    """The bridge can't be started; the text says why."""


class FoxgloveBridge(Node):
    """Serves topics, services, parameters and the connection graph.

    Args:
        context: Its context; None: the default one.

    Raises:
        SettingsError: a parameter can't be used.
        BridgeError: the address can't be used.
    """

    def __init__(self, context: RosContext | None = None) -> None:
        super().__init__("foxglove_bridge", context=context)
        self.server: WebSocketServer | None = None
        self.own_client: OwnClient | None = None
        self._relay: Relay | None = None
        self._sysinfo: SystemInfoPublisher | None = None
        self._complaints = Complaints(self.get_logger())
        self.parameter_slots = threading.BoundedSemaphore(MAX_ASKING)
        self._asset_slots = threading.BoundedSemaphore(MAX_ASSETS)
        self._asset_lock = threading.Lock()
        """Guards the member below."""
        self._asset_bytes = 0
        """Size of the files that went to clients since none of them left anything waiting."""
        self._refusals: set[str] = set()
        """Why connections were refused; each reason is logged once, because pages try again and again."""
        try:
            self._start()
        except BaseException:
            self.close()
            raise

    def _start(self) -> None:
        self.settings = settings = Settings(self)
        self.commands = Commands(self, self.warn)
        sdk_context = Context()
        self._types = KnownTypes(self)
        self.channels = Channels(self, sdk_context, settings, self._types)
        self.client_topics = ClientTopics(self, settings)
        self.calls = Calls(self)
        self.parameters_of_nodes = Parameters(self, self.calls, settings)
        self._seen_changes = self._published_changes = -1
        capabilities = [CAPABILITIES[name] for name in sorted(settings.capabilities & CAPABILITIES.keys())]
        self._is_simulated = bool(self.get_parameter("use_sim_time").value)
        if self._is_simulated or TIME in settings.capabilities:
            capabilities.append(Capability.Time)
        self._access = ClientAccess(settings.address, settings.origins)
        try:
            listener = listen(settings.address, settings.port)
        except (OSError, UnicodeError) as error:
            # `create_server` adds the address to the system's words.
            reason = (getattr(error, "strerror", None) or str(error)).partition(" (while")[0]
            raise BridgeError(f"can't listen at {settings.address}:{settings.port}: {reason}") from None
        inner = InnerPort()
        self._relay = Relay(listener, settings.tls, inner, self._refusal)
        try:
            self.server = foxglove.start_server(
                name="foxglove_bridge",
                host=inner.host,
                port=0,
                capabilities=capabilities,
                server_listener=_Listener(self),
                supported_encodings=["cdr"],
                asset_handler=self._read_asset if "assets" in settings.capabilities else None,
                context=sdk_context,
                message_backlog_size=settings.backlog,
            )
            if not inner.close_to_others(self.server.port):
                self.get_logger().warning(OPEN_INSIDE)
            self._relay.start()
        except (OSError, RuntimeError, ValueError, foxglove_error()) as error:
            raise BridgeError(f"can't serve at {settings.address}:{settings.port}: {error}") from None
        if settings.sysinfo_topic:
            self._sysinfo = foxglove.start_sysinfo_publisher(
                topic=settings.sysinfo_topic, refresh_interval=settings.sysinfo_s, context=sdk_context
            )
        publishes_parameters = settings.capabilities >= {"parameters", "parametersSubscribe"}
        if publishes_parameters or "connectionGraph" in settings.capabilities:
            self._start_own_client(self.server, inner)
        self._services = Services(self.server, self.calls, settings, self._types, self.warn)
        # Clients see the graph of now, whatever /clock says.
        steady = Clock(clock_type=ClockType.STEADY_TIME)
        self.create_timer(UPDATE_S, self._update, clock=steady)
        if "connectionGraph" in settings.capabilities:
            self.create_timer(CONNECTIONS_S, self.publish_connections, clock=steady)
        self._update()
        if self._is_simulated:
            best_effort = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
            self.create_subscription(ClockMessage, "/clock", self._broadcast_time, best_effort)
        if publishes_parameters:
            self.create_subscription(ParameterEvent, "/parameter_events", self._publish_parameters, 100)

    def _start_own_client(self, server: WebSocketServer, inner: InnerPort) -> None:
        client = OwnClient(server, inner, self.settings.capabilities, self.get_logger())
        try:
            client.start()
        except RuntimeError as error:
            self.get_logger().warning(f"Clients get no connection graph and no changed parameters: {error}")
            return
        self.own_client = client

    @property
    def port(self) -> int:
        """The port at which clients connect."""
        return 0 if self._relay is None else self._relay.port

    def close(self) -> None:
        """Close all connections and the port, and destroy the node.

        A connection whose client takes nothing is cut after a while.
        """
        if self.own_client is not None:
            self.own_client.close()
        if self._sysinfo is not None:
            self._sysinfo.stop()
        if self._relay is not None and self.server is None:
            self._relay.close(0.0)
        elif self._relay is not None and self.server is not None:
            self._relay.refuse_more()
            self._stop(self.server, self._relay)
            self.channels.close()
            self._types.close()
        self.destroy_node()

    def _stop(self, server: WebSocketServer, relay: Relay) -> None:
        """Stop the server and the relay, within `STOP_S` or little more."""
        # `stop` returns when each client has taken the closing message. One that takes nothing never does: the relay
        # cuts its connection after a while, and then `stop` returns, too.
        end_s = time.monotonic() + STOP_S
        stopping = threading.Thread(target=server.stop, name="foxglove_bridge_stop", daemon=True)
        try:
            stopping.start()
        except RuntimeError:  # no thread is left
            relay.close(0.0)
            server.stop()
            return
        stopping.join(STOP_S)
        if not relay.close(max(0.0, end_s - time.monotonic())):
            self.get_logger().warning("A client takes nothing: its connection is cut")
        stopping.join(STOP_S)

    def warn(self, text: str) -> None:
        """Log a warning, which all clients get, too; on any thread. Of many at once, some are left out."""
        self._complaints.say(text, self.server)

    # On the node's thread.

    def _update(self) -> None:
        """Follow the graph, if it has changed, or more types of it are known."""
        graph = self._wire()[0].graph
        changes = graph.changes()
        has_searched = self._types.poll()
        if changes == self._seen_changes and not has_searched:
            return
        own_name = self.get_fully_qualified_name()
        is_done = self.channels.update(
            {
                (end.topic.name, end.topic.type_name)
                for end in graph.endpoints()
                # A topic that only this bridge still reads, for its clients, is gone.
                if end.is_writer or end.node is None or end.node.full != own_name
            }
        )
        if is_done:
            self._seen_changes = changes
        served = {end.name: end.type_name for end in graph.service_ends() if end.is_server}
        if "services" in self.settings.capabilities:
            self._services.update(served)
        self.calls.forget(served.keys())

    def publish_connections(self) -> None:
        """Publish which node publishes, subscribes to and serves what, if that has changed."""
        graph = self._wire()[0].graph
        changes = graph.changes()
        if self.own_client is None or changes == self._published_changes:
            return
        settings = self.settings
        published, subscribed, served = (defaultdict[str, set[str]](set) for _ in range(3))
        for end in graph.endpoints():
            if end.node is not None and settings.shows(end.topic.name, settings.topics):
                (published if end.is_writer else subscribed)[end.topic.name].add(end.node.full)
        for service in graph.service_ends():
            is_shown = service.is_server and settings.shows(service.name, settings.services)
            if service.node is not None and is_shown:
                served[service.name].add(service.node.full)
        connections = ConnectionGraph()
        for topic, nodes in published.items():
            connections.set_published_topic(topic, sorted(nodes))
        for topic, nodes in subscribed.items():
            connections.set_subscribed_topic(topic, sorted(nodes))
        for name, nodes in served.items():
            connections.set_advertised_service(name, sorted(nodes))
        if self.own_client.publish_connections(connections):
            self._published_changes = changes

    def _broadcast_time(self, message: ClockMessage) -> None:
        if self.server is not None:
            self.server.broadcast_time(max(0, message.clock.sec * 1_000_000_000 + message.clock.nanosec))

    def _publish_parameters(self, event: ParameterEvent) -> None:
        parameters = [
            from_message(name, parameter.value)
            for parameter in (*event.new_parameters, *event.changed_parameters)
            if (name := f"{event.node}.{parameter.name}") in self.settings.parameters
        ]
        if parameters and self.own_client is not None:
            self.own_client.publish_parameters(parameters)

    # On the relay's thread.

    def _refusal(self, headers: Iterable[tuple[str, str]]) -> str:
        reason = self._access.refusal(headers)
        if reason and reason not in self._refusals and len(self._refusals) < MAX_REFUSALS:
            self._refusals.add(reason)
            self.get_logger().warning(f"A connection is refused: {reason}")
        return reason

    # On threads of the SDK.

    def _read_asset(self, uri: str) -> bytes | None:
        try:
            with self._asset_slots:
                content = read_asset(uri, self.settings)
                self._count_asset(uri, len(content))
        except AssetError as error:
            self.warn(str(error))
            return None
        return content

    def _count_asset(self, uri: str, size: int) -> None:
        """Note that a file goes to a client.

        The SDK keeps all files that its clients have asked for and not taken. It doesn't say whose a request is, so
        one client that takes nothing counts for all, until its connection is cut.

        Raises:
            AssetError: too much waits.
        """
        with self._asset_lock:
            self._asset_bytes += size
            if self._asset_bytes <= MAX_ASSET_BYTES or self._relay is None:
                return
            cut, waiting = self._relay.cut_stuck(STUCK_S)
            if cut:  # not by `warn`, which leaves some out
                text = f"{cut} clients take nothing of the files they asked for: they are cut off"
                self.get_logger().warning(text)
            if not waiting:
                self._asset_bytes = size
                return
            self._asset_bytes -= size
        raise AssetError(f"{uri} is not sent while clients don't take the files before: ask again")


def foxglove_error() -> type[Exception]:
    """Return the SDK's own class of errors."""
    error: type[Exception] = getattr(foxglove._foxglove_py, "FoxgloveError", RuntimeError)  # noqa: SLF001  # nowhere else
    return error


class _Listener(ServerListener):
    """What clients ask for; its methods are called on threads of the SDK."""

    def __init__(self, bridge: FoxgloveBridge) -> None:
        self._bridge = bridge

    def on_subscribe(self, client: Client, channel: ChannelView) -> None:
        self._subscribe(client.id, channel.id, self._bridge.channels.subscribe)

    def on_unsubscribe(self, client: Client, channel: ChannelView) -> None:
        self._subscribe(client.id, channel.id, self._bridge.channels.unsubscribe)

    def _subscribe(self, client: int, channel: int, command: Callable[[int, int], None]) -> None:
        self._bridge.commands.put_latest((client, channel), partial(command, client, channel))

    def on_client_advertise(self, client: Client, channel: ClientChannel) -> None:
        topics, key = self._bridge.client_topics, (client.id, channel.id)
        topic = ClientTopic(channel.topic, channel.schema_name, channel.encoding)
        try:
            topics.note(*key, topic)
        except ClientTopicError as error:
            self._bridge.warn(str(error))
            return
        if not self._bridge.commands.put_request(
            client.id, self._told(partial(topics.advertise, *key, topic))
        ):
            topics.forget(*key)

    def on_client_unadvertise(self, client: Client, client_channel_id: int) -> None:
        topics, key = self._bridge.client_topics, (client.id, client_channel_id)
        if topics.forget(*key):
            self._bridge.commands.put_end(partial(topics.unadvertise, *key))

    def on_message_data(self, client: Client, client_channel_id: int, data: bytes) -> None:
        topics, key = self._bridge.client_topics, (client.id, client_channel_id)
        if topics.is_noted(*key):
            command = self._told(partial(topics.publish, *key, bytes(data)))
            self._bridge.commands.put_message(client.id, len(data), command)

    def _told(self, command: partial[None]) -> Callable[[], None]:
        """Return a function that does something, and tells clients why it can't be done."""

        def run() -> None:
            try:
                command()
            except ClientTopicError as error:
                self._bridge.warn(str(error))

        return run

    def on_get_parameters(
        self,
        client: Client,
        param_names: list[str],
        request_id: str | None = None,
    ) -> list[Parameter]:
        if len(param_names) > MAX_PARAMETERS:
            self._bridge.warn(
                f"client {client.id} asks for {len(param_names)} parameters at once, and gets {MAX_PARAMETERS} at most"
            )
        return self._asked(client, partial(self._bridge.parameters_of_nodes.get, param_names))

    def on_set_parameters(
        self,
        client: Client,
        parameters: list[Parameter],
        request_id: str | None = None,
    ) -> list[Parameter]:
        own = self._bridge.own_client
        if own is not None and (changed := own.changed_parameters(request_id)) is not None:
            return changed

        def set_all() -> list[Parameter]:
            for error in self._bridge.parameters_of_nodes.set(parameters):
                self._bridge.warn(error)
            return self._bridge.parameters_of_nodes.get([parameter.name for parameter in parameters])

        return self._asked(client, set_all)

    def _asked(self, client: Client, ask: Callable[[], list[Parameter]]) -> list[Parameter]:
        """Return the parameters of a client's request; none, with a warning, while too many others wait for nodes.

        The SDK has a few threads for all clients, one of which waits here.
        """
        slots = self._bridge.parameter_slots
        if not slots.acquire(timeout=SLOT_S):
            self._bridge.warn(
                f"client {client.id} asks for parameters while {MAX_ASKING} other requests wait for nodes: ask again"
            )
            return []
        try:
            return ask()
        finally:
            slots.release()

"""Observe a service: server and client publish an event for each request and response."""

from __future__ import annotations

import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup
from rclpy.executors import ExternalShutdownException, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.qos import qos_profile_system_default
from rclpy.service_introspection import ServiceIntrospectionState
from service_msgs.msg import ServiceEventInfo

KINDS = {
    ServiceEventInfo.REQUEST_SENT: "request sent",
    ServiceEventInfo.REQUEST_RECEIVED: "request received",
    ServiceEventInfo.RESPONSE_SENT: "response sent",
    ServiceEventInfo.RESPONSE_RECEIVED: "response received",
}


class WatchedAdder(Node):
    """Calls its own service, with introspection on."""

    def __init__(self) -> None:
        super().__init__("watched_adder")
        self.service = self.create_service(
            AddTwoInts, "watched_add", self.on_request, callback_group=MutuallyExclusiveCallbackGroup()
        )
        group = MutuallyExclusiveCallbackGroup()  # not the timer's, whose callback waits
        self.client = self.create_client(AddTwoInts, "watched_add", callback_group=group)
        for end in (self.service, self.client):
            end.configure_introspection(
                self.get_clock(), qos_profile_system_default, ServiceIntrospectionState.CONTENTS
            )
        self.timer = self.create_timer(0.5, self.on_timer)
        self.count = 0

    def on_request(self, request: AddTwoInts.Request, response: AddTwoInts.Response) -> AddTwoInts.Response:
        response.sum = request.a + request.b
        return response

    async def on_timer(self) -> None:
        if self.client.service_is_ready():
            self.count += 1
            await self.client.call_async(AddTwoInts.Request(a=self.count, b=self.count))


class Watcher(Node):
    """Prints the events of the service."""

    def __init__(self) -> None:
        super().__init__("watcher")
        self.subscription = self.create_subscription(
            AddTwoInts.Event, "watched_add/_service_event", self.on_event, 10
        )

    def on_event(self, event: AddTwoInts.Event) -> None:
        contents = [f"{part.a} + {part.b}" for part in event.request] + [
            str(part.sum) for part in event.response
        ]
        self.get_logger().info(f"{KINDS[event.info.event_type]}: {', '.join(contents)}")


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    executor = SingleThreadedExecutor()
    try:
        executor.add_node(WatchedAdder())
        executor.add_node(Watcher())
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()

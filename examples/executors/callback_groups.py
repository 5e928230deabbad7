"""Call a service from a timer's callback while another timer runs, with callback groups and threads."""

from __future__ import annotations

import time

import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor
from rclpy.node import Node
from std_srvs.srv import Trigger


class SlowServer(Node):
    """Responds after 0.5 s, to several requests at once."""

    def __init__(self) -> None:
        super().__init__("slow_server")
        self.service = self.create_service(
            Trigger, "slow", self.on_request, callback_group=ReentrantCallbackGroup()
        )

    def on_request(self, request: Trigger.Request, response: Trigger.Response) -> Trigger.Response:
        time.sleep(0.5)
        response.success = True
        response.message = "at last"
        return response


class Caller(Node):
    """Waits for the response in a callback; a second callback group lets the other timer run meanwhile."""

    def __init__(self) -> None:
        super().__init__("caller")
        self.client = self.create_client(Trigger, "slow", callback_group=MutuallyExclusiveCallbackGroup())
        self.timer = self.create_timer(0.1, self.on_timer, callback_group=MutuallyExclusiveCallbackGroup())
        self.heart = self.create_timer(0.1, self.on_beat, callback_group=MutuallyExclusiveCallbackGroup())
        self.beats = 0

    def on_timer(self) -> None:
        if not self.client.service_is_ready():
            return
        before = self.beats
        response = self.client.call(Trigger.Request())
        if response is not None:
            self.get_logger().info(f"The answer: {response.message}; {self.beats - before} beats meanwhile")

    def on_beat(self) -> None:
        self.beats += 1


def main(args: list[str] | None = None) -> None:
    rclpy.init(args=args)
    executor = MultiThreadedExecutor(num_threads=4)
    try:
        executor.add_node(SlowServer())
        executor.add_node(Caller())
        executor.spin()
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    main()

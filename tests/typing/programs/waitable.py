"""A waitable, a custom executor, and rclpy's classes for both."""

from typing import Any

import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import Executor, TimeoutException
from rclpy.experimental import EventsExecutor
from rclpy.impl.implementation_singleton import rclpy_implementation as _rclpy
from rclpy.node import Node
from rclpy.waitable import NumberOfEntities, Waitable


class Trigger(Waitable):
    def __init__(self, node: Node) -> None:
        super().__init__(ReentrantCallbackGroup())
        with node.context.handle:
            self.guard = _rclpy.GuardCondition(node.context.handle)
        self.index: int | None = None
        self.ready = False

    def is_ready(self, wait_set: _rclpy.WaitSet) -> bool:
        if wait_set.is_ready("guard_condition", self.index):
            self.ready = True
        return self.ready

    def take_data(self) -> str:
        self.ready = False
        return "triggered"

    async def execute(self, taken_data: Any) -> None:
        print(taken_data)

    def get_num_entities(self) -> NumberOfEntities:
        return NumberOfEntities(num_gcs=1)

    def add_to_wait_set(self, wait_set: _rclpy.WaitSet) -> None:
        self.index = wait_set.add_guard_condition(self.guard)


class Counting(Executor):
    count = 0

    def spin_once(self, timeout_sec: float | None = None) -> None:
        try:
            handler, _, _ = self.wait_for_ready_callbacks(timeout_sec=timeout_sec)
        except TimeoutException:
            return
        handler()
        self.count += 1


def main() -> None:
    with rclpy.init():
        node = Node("triggered")
        waitable = Trigger(node)
        node.add_waitable(waitable)
        waitable.guard.trigger_guard_condition()
        executor = Counting()
        executor.add_node(node)
        executor.spin_once(timeout_sec=1.0)
        rclpy.spin_once(node, executor=EventsExecutor(), timeout_sec=0.0)


if __name__ == "__main__":
    main()

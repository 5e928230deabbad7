"""The action that waits by ROS's time, then executes others."""

from __future__ import annotations

import asyncio
from typing import Any, cast

from tfloom.launch.actions.timer_action import TimerAction
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.events.launch_events import TimerEvent
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.ros.ros_adapters import get_ros_node

__all__ = ["ROSTimer", "RosTimer"]


@expose_action("ros_timer")
class ROSTimer(TimerAction):
    """Waits for a period by the clock of the launch's node, and executes actions then.

    After SetUseSimTime(True) that is the time of the topic /clock.
    """

    async def _wait_to_fire_event(self, context: LaunchContext) -> None:
        loop = asyncio.get_running_loop()
        canceled = cast("asyncio.Future[bool]", self._canceled_future)
        fired: asyncio.Future[None] = loop.create_future()

        def fire() -> None:  # called on the thread of the launch's node
            loop.call_soon_threadsafe(_set, fired)

        period_s = self._period_s(context)
        node = get_ros_node(context)
        timer = None if period_s is None else node.create_timer(period_s, fire)
        waited: list[asyncio.Future[Any]] = [canceled, fired]
        await asyncio.wait(waited, return_when=asyncio.FIRST_COMPLETED)
        if timer is not None:
            node.destroy_timer(timer)
        if canceled.done():
            self._complete(context)
        else:
            await context.emit_event(TimerEvent(timer_action=self))


RosTimer = ROSTimer
"""Former name of ROSTimer, which launch files still use."""


def _set(future: asyncio.Future[Any]) -> None:
    if not future.done():
        future.set_result(None)

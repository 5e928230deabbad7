"""Change the state of a managed node, through its whole life cycle."""

from __future__ import annotations

import sys

import rclpy
from lifecycle_msgs.msg import State, Transition
from lifecycle_msgs.srv import ChangeState, GetState
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.wait_for_message import wait_for_message
from std_msgs.msg import Float64

CONFIGURE = Transition.TRANSITION_CONFIGURE
ACTIVATE = Transition.TRANSITION_ACTIVATE
DEACTIVATE = Transition.TRANSITION_DEACTIVATE
CLEANUP = Transition.TRANSITION_CLEANUP
SHUTDOWN = Transition.TRANSITION_UNCONFIGURED_SHUTDOWN


class Manager(Node):
    """Changes the sensor's state."""

    def __init__(self) -> None:
        super().__init__("manager")
        self.changer = self.create_client(ChangeState, "sensor/change_state")
        self.getter = self.create_client(GetState, "sensor/get_state")

    def change(self, transition: int) -> bool:
        """Request a transition; return False if the node does not have it in its state, or fails in it."""
        request = ChangeState.Request(transition=Transition(id=transition))
        future = self.changer.call_async(request)
        rclpy.spin_until_future_complete(self, future)
        response = future.result()
        return response is not None and response.success

    def state(self) -> State:
        """Return the node's state."""
        future = self.getter.call_async(GetState.Request())
        rclpy.spin_until_future_complete(self, future)
        response = future.result()
        return response.current_state if response is not None else State()

    def drive(self) -> bool:
        """Go through all states; return False if one is not reached."""
        log = self.get_logger()
        if not (self.changer.wait_for_service(10.0) and self.getter.wait_for_service(10.0)):
            log.error("There is no sensor")
            return False
        log.info(f"The sensor is {self.state().label}")
        for transition in (CONFIGURE, ACTIVATE, DEACTIVATE, CLEANUP, SHUTDOWN):
            if not self.change(transition):
                log.error(f"It would not go on from {self.state().label}")
                return False
            state = self.state()
            log.info(f"The sensor is {state.label}")
            if state.id == State.PRIMARY_STATE_ACTIVE:
                found, measured = wait_for_message(Float64, self, "measured", time_to_wait=10.0)
                log.info(f"It measured {measured.data}" if found else "It measured nothing")
        return True


def main(args: list[str] | None = None) -> int:
    rclpy.init(args=args)
    try:
        return 0 if Manager().drive() or not rclpy.ok() else 1
    except (KeyboardInterrupt, ExternalShutdownException):
        return 0
    finally:
        rclpy.try_shutdown()


if __name__ == "__main__":
    sys.exit(main())

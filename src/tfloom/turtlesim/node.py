"""The node `turtlesim`: turtles that follow velocity commands and publish their poses."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tfloom.common.terminal import report
from tfloom.interfaces.rcl_interfaces.msg import SetParametersResult
from tfloom.interfaces.std_srvs.srv import Empty
from tfloom.node.client_library import spin
from tfloom.node.clock.clock import Clock
from tfloom.node.context.utilities import remove_ros_args, try_shutdown
from tfloom.node.cpp_nodes import EVENT_OVERRIDING, listen_to_parameter_events
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.program import run_program
from tfloom.node.turtlesim_types import Kill, Spawn
from tfloom.node.values.names import NameValidationException
from tfloom.node.values.time import ClockType
from tfloom.turtlesim import parameters
from tfloom.turtlesim.endpoints import TurtleEndpoints, check_names
from tfloom.turtlesim.record import FRAME_MS, SIDE_PX, Recorder, RecordingError, open_recorder
from tfloom.turtlesim.rotations import RotationServer
from tfloom.turtlesim.simulation import TurtleSim
from tfloom.turtlesim.world import STEP_S, Event, Moved, RotationStep, Turtle, WallHit, is_usable

if TYPE_CHECKING:
    from tfloom.turtlesim.picture import Picture
    from tfloom.turtlesim.window import Window

FRAME_S = 1 / 60
"""Time between two pictures in the window [s]."""


class TurtlesimNode(Node):
    """Steps a world of turtles 62.5 times a second and connects it to topics."""

    _parameter_event_overriding = EVENT_OVERRIDING

    def __init__(self) -> None:
        super().__init__("turtlesim")
        parameters.declare(self)
        listen_to_parameter_events(self)
        self.get_logger().info(f"Starting turtlesim with node name {self.get_fully_qualified_name()}")
        self.sim = TurtleSim(lambda: self.get_clock().now().nanoseconds)
        self._endpoints: dict[str, TurtleEndpoints] = {}
        self._rotations: dict[str, RotationServer] = {}
        for turtle in self.sim.world.turtles.values():
            self._show(turtle)
        self.create_service(Empty, "clear", self._on_clear)
        self.create_service(Empty, "reset", self._on_reset)
        self.create_service(Spawn, "spawn", self._on_spawn)
        self.create_service(Kill, "kill", self._on_kill)
        # Real time, because simulated time may be derived from these turtles.
        self._timer = self.create_timer(STEP_S, self._step, clock=Clock(clock_type=ClockType.STEADY_TIME))

    def set_parameters_atomically(self, parameter_list: list[Parameter]) -> SetParametersResult:
        """Set all parameters, or none of them if one is rejected, with the reference's reason."""
        for parameter in parameter_list:
            if reason := parameters.rejection_reason(self, parameter):
                return SetParametersResult(successful=False, reason=reason)
        return super().set_parameters_atomically(parameter_list)

    def render(self, size_px: int) -> Picture:
        """Return the picture of the world, `size_px` by `size_px`."""
        self._follow_background()
        return self.sim.render(size_px)

    def _follow_background(self) -> None:
        self.sim.canvas.background = parameters.background(self)

    def show_in(self, window: Window) -> None:
        """Update the picture in `window`; when the user closes it, shut down."""

        def refresh() -> None:
            self._follow_background()
            if not window.show(self.sim.render, self.sim.scene()):
                window.close()
                try_shutdown(context=self.context)

        self.create_timer(FRAME_S, refresh, clock=Clock(clock_type=ClockType.STEADY_TIME))

    def record_to(self, recorder: Recorder) -> None:
        """Add a picture to `recorder` now and every FRAME_MS."""

        def add() -> None:
            recorder.add(lambda: self.render(SIDE_PX))

        add()
        self.create_timer(FRAME_MS / 1000, add, clock=Clock(clock_type=ClockType.STEADY_TIME))

    def _show(self, turtle: Turtle) -> None:
        self.get_logger().info(
            f"Spawning turtle [{turtle.name}] at x=[{turtle.x:f}], y=[{turtle.y:f}], theta=[{turtle.theta:f}]"
        )
        # The action server of a killed turtle of this name stays for a while, until its goals' results are fetched. A
        # second server of that name would receive the same requests, so the new turtle uses the one that is there.
        rotations = self._rotations.get(turtle.name)
        if rotations is None or rotations.is_destroyed:
            rotations = self._rotations[turtle.name] = RotationServer(self, turtle.name)
        self._endpoints[turtle.name] = TurtleEndpoints(self, self.sim, turtle, rotations)

    def _on_clear(self, _: Any, response: Any) -> Any:
        self.get_logger().info("Clearing turtlesim.")
        self.sim.clear()
        return response

    def _on_reset(self, _: Any, response: Any) -> Any:
        self.get_logger().info("Resetting turtlesim.")
        for name in list(self._endpoints):
            self._endpoints.pop(name).destroy()
        self._show(self.sim.reset())
        return response

    def _on_spawn(self, request: Any, response: Any) -> Any:
        if not is_usable(request.x, request.y, request.theta):
            where = f"x=[{request.x}], y=[{request.y}], theta=[{request.theta}]"
            self.get_logger().error(f"A turtle can't be spawned at {where}: these are not all numbers")
            return response
        # The world chooses a name where the request has none, so the turtle exists before its name can be checked, and
        # leaves again if no topics can have that name.
        turtle = self.sim.world.spawn(request.x, request.y, request.theta, request.name)
        if turtle is None:
            self.get_logger().error(f"A turtle named [{request.name}] already exists")
            return response
        try:
            check_names(self, turtle.name)
        except NameValidationException as error:
            self.sim.world.kill(turtle.name)
            self.get_logger().error(f"A turtle can't be named [{turtle.name}]: {error.error_msg}")
            return response
        self._show(turtle)
        response.name = turtle.name
        return response

    def _on_kill(self, request: Any, response: Any) -> Any:
        if self.sim.world.kill(request.name) is None:
            self.get_logger().error(f"Tried to kill turtle [{request.name}], which does not exist")
        else:
            self._endpoints.pop(request.name).destroy()
        return response

    def _step(self) -> None:
        self.sim.step(self._take)

    def _take(self, event: Event) -> None:
        if isinstance(event, Moved):
            self._endpoints[event.turtle.name].publish()
        elif isinstance(event, RotationStep):
            self._endpoints[event.turtle].report_rotation(event.rotation)
        elif isinstance(event, WallHit):
            self.get_logger().warning(str(event))


def open_window(node: Node) -> Window | None:
    """Open the window; if that is impossible, log the reason and return None."""
    try:
        from tfloom.turtlesim.window import NoDisplayError, Window
    except ImportError as error:
        node.get_logger().info(f"Running headless: {error}")
        return None
    try:
        return Window()
    except NoDisplayError as error:
        node.get_logger().info(f"Running headless: {error}")
        return None


def parse_arguments(words: list[str]) -> argparse.Namespace:
    """Read a command line without its ROS arguments; exit with a usage text if it is invalid."""
    parser = argparse.ArgumentParser(
        prog="turtlesim_node",
        description="Simulate turtles. Each subscribes to NAME/cmd_vel (geometry_msgs/msg/Twist) and publishes "
        "NAME/pose (turtlesim/msg/Pose), 62.5 times a second; the first is turtle1.",
    )
    parser.add_argument("--headless", action="store_true", help="open no window")
    parser.add_argument(
        "--record",
        type=Path,
        metavar="FILE",
        help="record the picture: an animation (.gif, .webp), the last picture, written each second (.png), or a film "
        "(.mp4, by ffmpeg)",
    )
    return parser.parse_args(words)


def main(args: list[str] | None = None) -> int:
    """Simulate until stopped or the window is closed; return the exit code."""
    args = sys.argv[1:] if args is None else args
    options = parse_arguments(remove_ros_args(args))
    try:
        recorder = None if options.record is None else open_recorder(options.record)
        try:
            return run_program(args, lambda: simulate(recorder, headless=options.headless))
        finally:
            if recorder is not None:
                recorder.finish()
    except RecordingError as error:
        report(f"turtlesim_node: {error}")
        return 1


def simulate(recorder: Recorder | None, *, headless: bool) -> None:
    """Simulate until stopped or the window is closed."""
    node = TurtlesimNode()
    if recorder is not None:
        node.record_to(recorder)
    window = None if headless else open_window(node)
    if window is not None:
        node.show_in(window)
    spin(node)

"""A world and its picture: turtles for a notebook, a page or a test, without ROS.

sim = TurtleSim()
turtle = sim.world.turtles["turtle1"]
for _ in range(100):
    sim.world.command(turtle, 2.0, None, 1.0)
    sim.step()
sim  # a notebook shows the picture
"""

from __future__ import annotations

from collections.abc import Callable

from tfloom.turtlesim.canvas import Canvas
from tfloom.turtlesim.picture import Picture
from tfloom.turtlesim.world import STEP_S, WINDOW_PX, Event, Stroke, Turtle, World


class TurtleSim:
    """A world and its picture.

    Args:
        clock_ns: As for `World`.
    """

    def __init__(self, clock_ns: Callable[[], int] | None = None) -> None:
        self.world = World(clock_ns)
        self.canvas = Canvas()

    def step(self, on_event: Callable[[Event], object] | None = None, dt_s: float = STEP_S) -> None:
        """Advance by `dt_s`, and call `on_event` with each event in order, at the picture of the event's time."""
        for event in self.world.step(dt_s):
            if on_event is not None:
                on_event(event)
            if isinstance(event, Stroke):
                self.canvas.paint(event)

    def clear(self) -> None:
        """Remove all strokes from the picture; the turtles stay."""
        self.canvas.clear()

    def reset(self) -> Turtle:
        """Reset to turtle1 alone on an empty picture; return it."""
        self.clear()
        return self.world.reset()

    def render(self, size_px: int = WINDOW_PX) -> Picture:
        """Return the picture, RGB, `size_px` by `size_px`."""
        return self.canvas.render(self.world.turtles.values(), size_px)

    def scene(self) -> object:
        """Return what the picture depends on, to compare it: of equal scenes of this simulation, it is the same."""
        turtles = self.world.turtles.values()
        return (
            self.canvas.background,
            self.canvas.changes,
            sorted((turtle.name, turtle.kind, turtle.x, turtle.y, turtle.theta) for turtle in turtles),
        )

    def _repr_png_(self) -> bytes:
        """Show the picture in a notebook."""
        return self.canvas.png(self.world.turtles.values())

"""A world with its picture, without ROS."""

from __future__ import annotations

import io
import sys

from PIL import Image
from tests.conftest import run_to_end

from tfloom.turtlesim.simulation import TurtleSim
from tfloom.turtlesim.world import Moved, Stroke


def test_notebook_shows_the_picture() -> None:
    with Image.open(io.BytesIO(TurtleSim()._repr_png_())) as picture:
        assert picture.size == (500, 500)


def test_events_are_drawn_in_order() -> None:
    sim = TurtleSim()
    turtle = sim.world.turtles["turtle1"]
    sim.world.command(turtle, 20.0, None, 0.0)
    seen = []
    sim.step(lambda event: seen.append((type(event), sim.canvas.color_at(turtle.x, turtle.y))))
    assert seen == [(Moved, (255, 255, 255)), (Stroke, (255, 255, 255))]
    assert sim.canvas.color_at(turtle.x, turtle.y) == turtle.pen.color


def test_scene_changes_with_the_picture() -> None:
    sim = TurtleSim()
    turtle = sim.world.turtles["turtle1"]
    scenes = [sim.scene()]

    def has_changed() -> bool:
        scenes.append(sim.scene())
        return scenes[-1] != scenes[-2]

    sim.step()
    assert not has_changed()
    turtle.theta += 0.1
    assert has_changed()
    turtle.x += 0.1
    assert has_changed()
    sim.canvas.paint(Stroke((1.0, 1.0), (2.0, 2.0), (1, 2, 3), 3))
    assert has_changed()
    sim.clear()
    assert has_changed()
    sim.canvas.background = (1, 2, 3)
    assert has_changed()
    sim.world.spawn(1.0, 1.0, 0.0)
    assert has_changed()
    sim.world.kill("turtle1")
    assert has_changed()


def test_reset_clears_the_picture_and_the_world() -> None:
    sim = TurtleSim()
    turtle = sim.world.turtles["turtle1"]
    sim.world.spawn(1.0, 1.0, 0.0)
    sim.world.command(turtle, 2.0, None, 0.0)
    sim.step()
    fresh = sim.reset()
    assert list(sim.world.turtles.values()) == [fresh]
    assert sim.canvas.color_at(turtle.x, turtle.y) == (255, 255, 255)


def test_simulation_imports_no_ros_module() -> None:
    code = "import sys, tfloom.turtlesim.simulation; print(*sys.modules)"
    loaded = run_to_end([sys.executable, "-c", code]).stdout.split()
    assert "tfloom.turtlesim.simulation" in loaded
    assert not [
        name for name in loaded if name.startswith(("tfloom.node", "tfloom.rmw", "tfloom.rosidl", "pygame"))
    ]

"""Pictures of the world: positions and smoothness of strokes and turtles, in any size."""

from __future__ import annotations

import io
from pathlib import Path

import pytest
from PIL import Image, ImageChops, ImageStat

from tfloom.turtlesim.art import LOOKS, sprite
from tfloom.turtlesim.canvas import DEFAULT_BACKGROUND, NOTHING_DRAWN, Canvas
from tfloom.turtlesim.world import PX_PER_M, WORLD_SIZE_M, Stroke, World

GOLDEN = Path(__file__).parents[1] / "golden" / "turtlesim_canvas.png"
RED = (200, 30, 40)


def difference(one: Image.Image, other: Image.Image) -> float:
    """Return the mean difference of a channel's value, of 255."""
    return max(ImageStat.Stat(ImageChops.difference(one, other)).mean)


def scene() -> tuple[World, Canvas]:
    """Return a world and a picture: one turtle has drawn an arc and a red line, and there is another turtle."""
    world, canvas = World(), Canvas()
    turtle = world.turtles["turtle1"]
    world.spawn(2.0, 8.0, 2.5)
    for _ in range(150):
        world.command(turtle, 3.0, None, 1.5)
        for event in world.step():
            if isinstance(event, Stroke):
                canvas.paint(event)
    turtle.set_pen(RED, 6, off=False)
    turtle.teleport(9.0, 2.0, 0.5)
    for event in world.step():
        if isinstance(event, Stroke):
            canvas.paint(event)
    return world, canvas


def test_an_empty_world_is_its_background() -> None:
    picture = Canvas((1, 2, 3)).render([])
    assert picture.size == (500, 500)
    assert picture.getcolors() == [(250_000, (1, 2, 3))]


def test_strokes_follow_the_path_of_the_turtle() -> None:
    canvas = Canvas()
    canvas.paint(Stroke((1.0, 2.0), (4.0, 2.0), RED, 3))
    picture = canvas.render([])
    row = round((WORLD_SIZE_M - 2.0) * PX_PER_M)
    assert picture.getpixel((round(2.5 * PX_PER_M), row)) == RED
    assert picture.getpixel((round(2.5 * PX_PER_M), row - 4)) == DEFAULT_BACKGROUND
    assert picture.getpixel((round(5.0 * PX_PER_M), row)) == DEFAULT_BACKGROUND


def test_strokes_are_smooth() -> None:
    canvas = Canvas()
    canvas.paint(Stroke((1.0, 2.0), (9.0, 5.0), RED, 3))
    colors = canvas.render([]).getcolors() or []
    assert len(colors) > 10, "shades between pen and background"


def test_sensor_reads_strokes_only() -> None:
    canvas = Canvas()
    assert canvas.color_at(2.0, 2.0) == NOTHING_DRAWN
    canvas.paint(Stroke((1.0, 2.0), (4.0, 2.0), RED, 3))
    assert canvas.color_at(2.0, 2.0) == RED
    assert canvas.color_at(2.0, 2.2) == NOTHING_DRAWN
    canvas.clear()
    assert canvas.color_at(2.0, 2.0) == NOTHING_DRAWN
    assert canvas.color_at(99.0, -99.0) == NOTHING_DRAWN


@pytest.mark.parametrize("size_px", [500, 333, 1234])
def test_incremental_rendering_gives_the_same_picture(size_px: int) -> None:
    whole, parts = Canvas(), Canvas()
    strokes = [Stroke((i / 7, 1 + i / 9), (i / 3, 10 - i / 5), (i * 9, 80, 90), 1 + i % 5) for i in range(12)]
    for stroke in strokes:
        whole.paint(stroke)
        parts.paint(stroke)
        parts.render([], size_px)
    assert difference(whole.render([], size_px), parts.render([], size_px)) < 0.01


def test_turtle_is_drawn_at_its_position() -> None:
    world = World()
    bare, picture = Canvas().render([]), Canvas().render(world.turtles.values())
    left, top, right, bottom = ImageChops.difference(bare, picture).getbbox() or (0, 0, 0, 0)
    assert (left + right) / 2 == pytest.approx(249.5, abs=3)
    assert (top + bottom) / 2 == pytest.approx(249.5, abs=3)
    assert right - left == pytest.approx(PX_PER_M, abs=5)


def test_turtles_at_the_edge_are_clipped() -> None:
    world = World()
    for x, y in ((0.0, 0.0), (WORLD_SIZE_M, WORLD_SIZE_M), (0.0, WORLD_SIZE_M)):
        world.spawn(x, y, 1.0)
    world.spawn(50.0, -50.0, 1.0)
    assert Canvas().render(world.turtles.values()).size == (500, 500)


def test_ten_turtles_look_different() -> None:
    sprites = [sprite(kind, 0.3, 45).convert("RGB") for kind in range(10)]
    assert len(LOOKS) == 10
    for i, one in enumerate(sprites):
        for other in sprites[:i]:
            assert difference(one, other) > 5.0
    assert sprite(10, 0.3, 45) is sprite(0, 0.3, 45)


def test_turtles_turn_smoothly() -> None:
    assert sprite(0, 0.0, 45) is not sprite(0, 0.05, 45)
    assert difference(sprite(0, 0.0, 45).convert("RGB"), sprite(0, 0.035, 45).convert("RGB")) < 8.0


def test_picture_matches_the_golden() -> None:
    world, canvas = scene()
    with Image.open(GOLDEN) as golden:
        assert difference(canvas.render(world.turtles.values()), golden.convert("RGB")) < 0.5


def test_png_is_decodable() -> None:
    world, canvas = scene()
    with Image.open(io.BytesIO(canvas.png(world.turtles.values(), 700))) as picture:
        assert picture.format == "PNG"
        assert picture.size == (700, 700)

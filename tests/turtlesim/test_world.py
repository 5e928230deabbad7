"""The turtles' physics against numbers computed by hand, and against a run of the reference."""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tfloom.turtlesim.world import (
    STEP_S,
    WORLD_SIZE_M,
    Moved,
    Pen,
    RotationStep,
    Stroke,
    Turtle,
    WallHit,
    World,
    is_usable,
    normalize_angle,
    to_float32,
)

CENTRE = 499 / 45 / 2


@pytest.fixture
def world() -> World:
    return World()


@pytest.fixture
def turtle(world: World) -> Turtle:
    return world.turtles["turtle1"]


def steps(world: World, count: int) -> list:
    return [event for _ in range(count) for event in world.step()]


def test_turtle1_starts_at_the_centre(turtle: Turtle) -> None:
    # The output of the reference's `ros2 topic echo /turtle1/pose`.
    assert to_float32(turtle.x) == to_float32(turtle.y) == 5.544444561004639
    assert turtle.theta == 0.0


def test_straight_line(world: World, turtle: Turtle) -> None:
    world.command(turtle, 2.0, None, 0.0)
    steps(world, 10)
    assert turtle.x == pytest.approx(CENTRE + 10 * 0.016 * 2.0, abs=1e-6)
    assert turtle.y == pytest.approx(CENTRE, abs=1e-6)
    assert turtle.linear_velocity == 2.0


def test_turtle_moves_along_its_new_heading(world: World, turtle: Turtle) -> None:
    world.command(turtle, 1.0, None, 1.0)
    world.step(0.5)
    assert turtle.theta == pytest.approx(0.5)
    assert turtle.x == pytest.approx(CENTRE + 0.5 * math.cos(0.5), abs=1e-6)
    assert turtle.y == pytest.approx(CENTRE + 0.5 * math.sin(0.5), abs=1e-6)


def test_arc(world: World, turtle: Turtle) -> None:
    world.command(turtle, 1.0, None, 2.0)
    steps(world, 50)
    # A polygon whose k-th side has length v·dt and heading k·ω·dt: a geometric series in the complex plane.
    turn = complex(math.cos(0.032), math.sin(0.032))
    end = complex(CENTRE, CENTRE) + 0.016 * turn * (turn**50 - 1) / (turn - 1)
    assert (turtle.x, turtle.y) == pytest.approx((end.real, end.imag), abs=1e-6)
    assert turtle.theta == pytest.approx(1.6)


def test_heading_wraps_around(world: World, turtle: Turtle) -> None:
    world.command(turtle, 0.0, None, 4.0)
    steps(world, 60)
    assert turtle.theta == pytest.approx(3.84 - 2 * math.pi, abs=1e-6)


def test_a_command_lasts_one_second(world: World, turtle: Turtle) -> None:
    world.command(turtle, 2.0, None, 0.5)
    steps(world, 63)
    assert turtle.linear_velocity == 2.0
    steps(world, 1)
    assert (turtle.linear_velocity, turtle.angular_velocity) == (0.0, 0.0)
    travelled = [event for event in steps(world, 10) if isinstance(event, Stroke)]
    assert travelled == []


def test_one_key_press_is_two_metres(world: World, turtle: Turtle) -> None:
    world.command(turtle, 2.0, None, 0.0)
    steps(world, 100)
    assert turtle.x == pytest.approx(CENTRE + 63 * 0.032, abs=1e-6)


def test_commands_age_by_the_given_clock() -> None:
    now_ns = 5
    world = World(lambda: now_ns)
    turtle = world.turtles["turtle1"]
    world.command(turtle, 1.0, None, 0.0)
    now_ns += 1_000_000_000
    world.step()
    assert turtle.linear_velocity == 1.0
    now_ns += 1
    world.step()
    assert turtle.linear_velocity == 0.0


@pytest.mark.parametrize(
    ("theta", "edge"),
    [
        (0.0, (WORLD_SIZE_M, CENTRE)),
        (math.pi / 2, (CENTRE, WORLD_SIZE_M)),
        (math.pi, (0.0, CENTRE)),
        (-math.pi / 2, (CENTRE, 0.0)),
    ],
)
def test_walls_stop_a_turtle(world: World, turtle: Turtle, theta: float, edge: tuple[float, float]) -> None:
    turtle.theta = theta
    world.command(turtle, 1000.0, None, 0.0)
    hits = [event for event in world.step() if isinstance(event, WallHit)]
    assert len(hits) == 1
    assert (turtle.x, turtle.y) == pytest.approx(edge, abs=1e-6)
    assert turtle.linear_velocity == 1000.0, "the pose goes on telling the command"


def test_the_wall_warns_in_screen_coordinates(world: World, turtle: Turtle) -> None:
    turtle.theta = math.pi / 2
    world.command(turtle, 500.0, None, 0.0)
    (hit,) = (event for event in world.step() if isinstance(event, WallHit))
    assert str(hit) == "Oh no! I hit the wall! (Clamping from [x=5.544445, y=-2.455555])"


def test_only_holonomic_turtles_move_sideways(world: World, turtle: Turtle) -> None:
    world.command(turtle, 3.0, 4.0, 0.0)
    world.step(0.1)
    assert (turtle.x, turtle.y) == pytest.approx((CENTRE + 0.3, CENTRE + 0.4), abs=1e-6)
    assert turtle.linear_velocity == pytest.approx(5.0)
    world.command(turtle, 0.0, None, 0.0)
    assert turtle.linear_velocity == 4.0, "what went sideways stays until a holonomic command or the timeout"


def test_teleports_are_applied_in_order_at_the_next_step(world: World, turtle: Turtle) -> None:
    turtle.teleport(1.0, 2.0, math.pi / 2)
    turtle.teleport_relative(3.0, -math.pi / 2)
    assert turtle.x == pytest.approx(CENTRE, abs=1e-6)
    strokes = [event for event in world.step() if isinstance(event, Stroke)]
    assert (turtle.x, turtle.y, turtle.theta) == pytest.approx((4.0, 2.0, 0.0), abs=1e-6)
    assert [stroke.end for stroke in strokes] == [pytest.approx((1.0, 2.0)), pytest.approx((4.0, 2.0))]


def test_teleport_above_the_world_ends_on_its_edge_without_a_warning(world: World, turtle: Turtle) -> None:
    turtle.teleport(1.0, 99.0, 7.0)
    assert not [event for event in world.step() if isinstance(event, WallHit)]
    assert (turtle.x, turtle.y) == (1.0, WORLD_SIZE_M)
    assert turtle.theta == pytest.approx(7.0 - 2 * math.pi, abs=1e-6)


def test_teleport_below_the_world_hits_the_wall(world: World, turtle: Turtle) -> None:
    turtle.teleport(-1.0, -1.0, 0.0)
    hits = [event for event in world.step() if isinstance(event, WallHit)]
    assert [hit.x for hit in hits] == [-1.0]
    assert (turtle.x, turtle.y) == (0.0, 0.0)


def test_rotation_goal_replays_the_reference(world: World, turtle: Turtle) -> None:
    # `ros2 action send_goal --feedback /turtle1/rotate_absolute … '{theta: 1.4}'` printed these.
    remaining = [
        -0.15681469440460205,
        -0.14081478118896484,
        -0.12481474876403809,
        -0.10881471633911133,
        -0.09281468391418457,
        -0.07681477069854736,
        -0.060814738273620605,
        -0.04481470584869385,
        -0.02881467342376709,
        -0.012814760208129883,
    ]
    # The reference's heading had more digits than float32: a quarter of the last place more.
    turtle.theta = to_float32(1.4) + 0.15681469440460205 + 0.25 * 2**-23
    rotation, aborted = turtle.rotate_to(1.4)
    assert aborted is None
    seen = []
    while rotation.state == "active":
        assert any(isinstance(event, RotationStep) for event in world.step())
        seen.append(rotation.remaining)
    assert seen == remaining
    assert rotation.delta == 0.14399999380111694
    assert rotation.state == "succeeded"
    assert turtle.angular_velocity == 0.0


def test_rotation_takes_the_shorter_way(world: World, turtle: Turtle) -> None:
    turtle.theta = 3.0
    turtle.rotate_to(-3.0)
    world.step()
    assert turtle.angular_velocity == 1.0
    assert turtle.theta == pytest.approx(3.016)


def test_rotation_outlasts_the_command_timeout(world: World, turtle: Turtle) -> None:
    rotation, _ = turtle.rotate_to(3.0)
    steps(world, 200)
    assert rotation.state == "succeeded"
    assert turtle.theta == pytest.approx(3.0, abs=0.02)


def test_rotation_ends_for_a_command_a_cancel_and_a_newer_one(world: World, turtle: Turtle) -> None:
    first, _ = turtle.rotate_to(1.0)
    assert world.command(turtle, 1.0, None, 0.0) is first
    assert first.state == "aborted"
    second, _ = turtle.rotate_to(1.0)
    third, aborted = turtle.rotate_to(2.0)
    assert aborted is second
    world.step()
    third.cancel_requested = True
    world.step()
    assert third.state == "canceled"
    assert turtle.angular_velocity == 0.0
    assert turtle.rotation is None


def test_pen_draws_with_its_colour_and_width(world: World, turtle: Turtle) -> None:
    world.command(turtle, 1.0, None, 0.0)
    moved, stroke = world.step()
    assert moved == Moved(turtle)
    assert isinstance(stroke, Stroke)
    assert (stroke.color, stroke.width_px) == ((179, 184, 255), 3)
    assert stroke.start == pytest.approx((CENTRE, CENTRE), abs=1e-6)
    turtle.set_pen((1, 2, 3), 0, off=False)
    assert turtle.pen == Pen((1, 2, 3), 1, is_on=True)
    turtle.set_pen((9, 9, 9), 9, off=True)
    assert turtle.pen == Pen((1, 2, 3), 1, is_on=False)
    assert world.step() == [Moved(turtle)]


def test_spawn_names(world: World) -> None:
    assert world.spawn(1.0, 1.0, 0.0, "turtle2") is not None
    assert world.spawn(1.0, 1.0, 0.0, "turtle1") is None
    third = world.spawn(2.0, 2.0, 0.0)
    assert third is not None
    assert third.name == "turtle3"
    assert world.kill("turtle3") is third
    assert world.kill("turtle3") is None
    world.reset()
    assert list(world.turtles) == ["turtle1"]
    fourth = world.spawn(2.0, 2.0, 0.0)
    assert fourth is not None
    assert fourth.name == "turtle2"


def test_spawned_outside_lands_on_the_edge_at_the_next_step(world: World) -> None:
    turtle = world.spawn(20.0, -3.0, 0.0)
    assert turtle is not None
    assert turtle.x == 20.0
    world.step()
    assert (turtle.x, turtle.y) == (WORLD_SIZE_M, 0.0)


def test_turtles_are_stepped_in_order_of_name(world: World) -> None:
    for name in ("zoe", "amy"):
        spawned = world.spawn(99.0, 1.0, 0.0, name)
        assert spawned is not None
    assert [event.turtle for event in world.step() if isinstance(event, WallHit)] == ["amy", "zoe"]


def test_usable_numbers() -> None:
    assert is_usable(0.0, -3e38)
    assert not is_usable(1.0, math.nan)
    assert not is_usable(math.inf)
    assert not is_usable(1e39)


@settings(max_examples=40)
@given(st.floats(-3.4e38, 3.4e38))
def test_normalized_headings(angle: float) -> None:
    heading = normalize_angle(angle)
    assert -math.pi - 1e-8 <= heading <= math.pi
    if abs(angle) < 100:
        assert math.cos(heading) == pytest.approx(math.cos(angle), abs=1e-6)
        assert math.sin(heading) == pytest.approx(math.sin(angle), abs=1e-6)


NUMBERS = st.floats(width=32, allow_nan=False, allow_infinity=False)
ORDERS = st.lists(
    st.one_of(
        st.tuples(st.just("command"), NUMBERS, st.none() | NUMBERS, NUMBERS),
        st.tuples(st.just("teleport"), NUMBERS, NUMBERS, NUMBERS),
        st.tuples(st.just("teleport_relative"), NUMBERS, NUMBERS),
        st.tuples(st.just("rotate_to"), NUMBERS),
        st.just(("step",)),
    ),
    max_size=20,
)


@settings(max_examples=40)
@given(ORDERS)
def test_a_turtle_never_leaves_the_world(orders: list) -> None:
    world = World()
    turtle = world.turtles["turtle1"]
    for verb, *numbers in orders:
        if verb == "command":
            world.command(turtle, *numbers)
        elif verb != "step":
            getattr(turtle, verb)(*numbers)
        world.step(STEP_S)
        assert 0.0 <= turtle.x <= WORLD_SIZE_M
        assert 0.0 <= turtle.y <= WORLD_SIZE_M
        assert -math.pi - 1e-8 <= turtle.theta <= math.pi

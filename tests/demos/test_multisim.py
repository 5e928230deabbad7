"""Two turtlesims in two namespaces, over DDS."""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from tfloom.interfaces.geometry_msgs.msg import Twist
from tfloom.interfaces.turtlesim.msg import Pose
from tfloom.node.client_library import init
from tfloom.node.context.utilities import try_shutdown
from tfloom.node.executing.executors import SingleThreadedExecutor
from tfloom.node.node import Node

MULTISIM = ("tfloom", "run", "turtlesim", "multisim", "--headless")
NAMESPACES = ("turtlesim1", "turtlesim2")


class User:
    """Subscribes to the poses of both turtles, and commands one."""

    def __init__(self) -> None:
        init(args=[])
        self._node = Node("user")
        self.poses: dict[str, list[Pose]] = {name: [] for name in NAMESPACES}
        for name, poses in self.poses.items():
            self._node.create_subscription(Pose, f"/{name}/turtle1/pose", poses.append, 10)
        self.commands = self._node.create_publisher(Twist, "/turtlesim2/turtle1/cmd_vel", 10)
        self._executor = SingleThreadedExecutor()
        self._executor.add_node(self._node)

    def sees(self, condition: Callable[[], object]) -> Callable[[], object]:
        """Return a condition that is evaluated after waiting messages were received."""

        def look() -> object:
            self._executor.spin_once(timeout_sec=0.01)
            return condition()

        return look

    def nodes(self) -> set[tuple[str, str]]:
        named = self._node.get_node_names_and_namespaces()
        return {(name, namespace) for name, namespace in named if name == "turtlesim"}

    def end(self) -> None:
        self._executor.shutdown()
        self._node.destroy_node()
        try_shutdown()


@pytest.fixture
def user(domain_id: int) -> Iterator[User]:
    user = User()
    yield user
    user.end()


def test_each_turtlesim_has_its_turtle(
    user: User, start_program: Callable[..., Any], wait_until: Callable[..., None]
) -> None:
    start_program(*MULTISIM)
    wait_until(user.sees(lambda: all(user.poses.values())))
    assert user.nodes() == {("turtlesim", "/turtlesim1"), ("turtlesim", "/turtlesim2")}

    def driven() -> bool:
        user.commands.publish(Twist())
        twist = Twist()
        twist.linear.x = 2.0
        user.commands.publish(twist)
        return user.poses["turtlesim2"][-1].x > 6.0

    wait_until(user.sees(driven))
    assert user.poses["turtlesim1"][-1].x == pytest.approx(5.544445)


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM, signal.SIGKILL])
def test_turtlesims_end_with_the_program(
    user: User, start_program: Callable[..., Any], wait_until: Callable[..., None], number: int
) -> None:
    program = start_program(*MULTISIM)
    wait_until(user.sees(lambda: all(user.poses.values())))
    program.signal(number)
    assert program.wait() == (-signal.SIGKILL if number == signal.SIGKILL else 0), program.output
    wait_until(user.sees(lambda: not user.nodes()))
    assert "Traceback" not in program.output


def test_invalid_arguments_are_reported(domain_id: int, start_program: Callable[..., Any]) -> None:
    program = start_program(*MULTISIM, "--headles_s")
    assert program.wait() == 2
    assert "multisim: error: unrecognized arguments: --headles_s" in program.lines

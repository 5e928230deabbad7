"""The plug-in of pytest, which each pytest loads: fixtures for tests of ROS packages. PYTEST_DONT_REWRITE.

It imports nothing else until a test asks for a fixture. docs/testing.md describes the fixtures.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from tfloom.node.context.context import Context
    from tfloom.node.executing.executor import Executor
    from tfloom.node.node import Node
    from tfloom.testing.graph import RosGraph
    from tfloom.testing.simulated_time import SimulatedTime
    from tfloom.tf2_ros.buffer import Buffer

__all__ = [
    "pytest_addoption",
    "pytest_configure",
    "ros_context",
    "ros_domain",
    "ros_executor",
    "ros_graph",
    "ros_node",
    "ros_time",
    "tf_buffer_from",
    "wait_for_message",
]

_WIRES = ("local", "dds")
_MARKER = "ros_wire"
_SIMULATED = ["--ros-args", "-p", "use_sim_time:=true"]


def pytest_addoption(parser: Any) -> None:
    """Add the option that selects the wire of all tests."""
    parser.addoption(
        "--ros-wire",
        choices=_WIRES,
        default="local",
        help="wire of the ros_… fixtures: inside the process (local), or DDS on the loopback interface (dds)",
    )


def pytest_configure(config: Any) -> None:
    """Register the marker by which a test chooses its wire."""
    config.addinivalue_line("markers", f'{_MARKER}(name): wire of the ros_… fixtures, "local" or "dds"')


def _wire(request: pytest.FixtureRequest) -> str:
    marker = request.node.get_closest_marker(_MARKER)
    if marker is None:
        return str(request.config.getoption("--ros-wire"))
    if len(marker.args) != 1 or marker.kwargs or marker.args[0] not in _WIRES:
        pytest.fail(f'write @pytest.mark.{_MARKER}("local") or @pytest.mark.{_MARKER}("dds")', pytrace=False)
    return str(marker.args[0])


def _expect_own_rclpy() -> None:
    from importlib.util import find_spec

    from tfloom.ros_imports.guard import is_elsewhere

    if is_elsewhere("rclpy"):
        spec = find_spec("rclpy")
        pytest.fail(
            f"the ros_… fixtures of tfloom are for tfloom's rclpy, and this one is {spec and spec.origin}: take that "
            "ROS out of PYTHONPATH to run this test on tfloom alone",
            pytrace=False,
        )


def _expect_dds() -> None:
    from tfloom.rmw.cyclone.library import find_library
    from tfloom.rmw.errors import NoBackendError

    try:
        find_library()
    except NoBackendError as error:
        pytest.skip(f"needs DDS: {error}")


@pytest.fixture(scope="session")
def _ros_log_folder(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("ros_log")


@pytest.fixture
def ros_domain(request: pytest.FixtureRequest, _ros_log_folder: Path) -> Iterator[int]:
    """Give the test a wire and a domain that nobody shares, and return the domain's number.

    `rclpy` is not initialised, so that the test, or a `main` that it calls, can do so. All contexts that are
    initialised in the test are shut down at its end.
    """
    _expect_own_rclpy()
    wire = _wire(request)
    if wire == "dds":
        _expect_dds()
    from tfloom.testing.isolation import isolated

    with isolated(wire, _ros_log_folder) as domain:
        yield domain


@pytest.fixture
def ros_context(request: pytest.FixtureRequest, ros_domain: int) -> Iterator[Context]:
    """Initialise `rclpy`, without handlers of signals, and return the context, which is the default one.

    With `ros_time`, all nodes have `use_sim_time`.
    """
    from tfloom.node.context.utilities import get_default_context

    context = get_default_context()
    context.init(args=_SIMULATED if "ros_time" in request.fixturenames else [], domain_id=ros_domain)
    try:
        yield context
    finally:
        context.destroy()


@pytest.fixture
def ros_graph(ros_context: Context) -> Iterator[RosGraph]:
    """Return the test's graph: `add(node)`, `spin_until(condition)`, `collect(…)`, `broadcast(table)`."""
    from tfloom.testing.graph import RosGraph

    graph = RosGraph(ros_context)
    try:
        yield graph
    finally:
        graph.close()


@pytest.fixture
def ros_executor(ros_graph: RosGraph) -> Executor:
    """Return the graph's executor, which spins while one of the graph's methods waits."""
    return ros_graph.executor


@pytest.fixture
def ros_node(ros_graph: RosGraph) -> Node:
    """Return a node named `test_node`, which is spun with the graph."""
    return ros_graph.create_node("test_node")


@pytest.fixture
def ros_time(request: pytest.FixtureRequest, ros_graph: RosGraph) -> SimulatedTime:
    """Return simulated time, which starts at 100 s: `step(seconds)`, `set(seconds)`, `now`."""
    if "ros_time" not in request.fixturenames:
        pytest.fail(
            "name ros_time among the test's arguments, because it must be there before rclpy is initialised"
        )
    from tfloom.testing.simulated_time import SimulatedTime

    return SimulatedTime(ros_graph)


@pytest.fixture
def wait_for_message(ros_graph: RosGraph) -> Callable[..., Any]:
    """Return a function: `wait_for_message(msg_type, topic, timeout_s=5.0, where=None)` returns the message."""
    return ros_graph.wait_for_message


@pytest.fixture
def tf_buffer_from() -> Callable[[str], Buffer]:
    """Return a function that fills a `tf2_ros.Buffer` from a table of transforms."""
    from tfloom.testing.transform_table import buffer_of

    return buffer_of

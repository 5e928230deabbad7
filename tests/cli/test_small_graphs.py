"""What the verbs print of a graph with nobody on it, and of one with twins."""

from __future__ import annotations

import json
from collections.abc import Callable, Iterator

import pytest

from tfloom.cli import main as cli
from tfloom.interfaces.std_msgs.msg import String
from tfloom.node.context.context import Context
from tfloom.node.node import Node


@pytest.fixture(autouse=True)
def local_wire(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("RMW_IMPLEMENTATION", "tfloom_local")
    monkeypatch.setattr("tfloom.cli.shared.graph.MIN_WAIT_S", 0.0)
    monkeypatch.setattr("tfloom.cli.shared.graph.QUIET_S", 0.0)


@pytest.fixture
def run(capsys: pytest.CaptureFixture[str]) -> Callable[..., tuple[str, str]]:
    """Run a command line that succeeds; return its output and what it printed on stderr."""

    def run(line: str) -> tuple[str, str]:
        assert cli.main(line.split()) == 0
        return tuple(capsys.readouterr())

    return run


@pytest.mark.parametrize(
    ("line", "output"),
    [
        ("topic list", "/parameter_events\n/rosout\n"),
        (
            "topic list -t",
            "/parameter_events [rcl_interfaces/msg/ParameterEvent]\n/rosout [rcl_interfaces/msg/Log]\n",
        ),
        ("topic list -c", "2\n"),
        ("topic list -v", "Published topics:\n\nSubscribed topics:\n\n"),
        ("topic type /rosout", "rcl_interfaces/msg/Log\n"),
        ("topic find rcl_interfaces/msg/ParameterEvent", "/parameter_events\n"),
        ("topic info /rosout", "Type: rcl_interfaces/msg/Log\nPublisher count: 0\nSubscription count: 0\n"),
        ("node list", ""),
    ],
)
def test_a_graph_with_nobody_has_what_every_node_has(
    line: str, output: str, run: Callable[..., tuple[str, str]]
) -> None:
    assert run(line) == (output, "")


def test_its_json_counts_nobody(run: Callable[..., tuple[str, str]]) -> None:
    topics = json.loads(run("topic list --json")[0])
    assert [(topic["name"], topic["publishers"], topic["subscribers"]) for topic in topics] == [
        ("/parameter_events", 0, 0),
        ("/rosout", 0, 0),
    ]


@pytest.fixture(params=[True, False], ids=["one process", "two"])
def twins(request: pytest.FixtureRequest) -> Iterator[None]:
    """Two nodes of one name; the first publishes /first, the second /second."""
    contexts = [Context()] if request.param else [Context(), Context()]
    for context in contexts:
        context.init(["program"])
    nodes = [Node("twin", context=context) for context in (contexts[0], contexts[-1])]
    nodes[0].create_publisher(String, "first", 10)
    nodes[1].create_publisher(String, "second", 10)
    yield
    for node in nodes:
        node.destroy_node()
    for context in contexts:
        context.destroy()


@pytest.mark.usefixtures("twins")
def test_twins(
    run: Callable[..., tuple[str, str]],
    capsys: pytest.CaptureFixture[str],
    deviations: dict[str, dict[str, str]],
) -> None:
    capsys.readouterr()  # what the creation of the second logged
    warning = (
        "WARNING: Be aware that there are nodes in the graph that share an exact name, "
        "which can have unintended side effects.\n"
    )
    assert run("node list") == ("/twin\n/twin\n", warning)
    assert "cli-twins" in deviations
    output, told = run("node info /twin")
    assert told == (
        'There are 2 nodes in the graph with the exact name "/twin". '
        "You are seeing information about all of them.\n"
    )
    assert "    /first: std_msgs/msg/String\n" in output
    assert "    /second: std_msgs/msg/String\n" in output

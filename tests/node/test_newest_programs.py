"""Small programs of the newest releases, which no peer can run here: their answers are from what is known of them."""

from __future__ import annotations

import json
import os
import sys
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import run_to_end

PROGRAMS = Path(__file__).parents[1] / "programs" / "newest.py"
ACTIONS = [["/numbers", ["example_interfaces/action/Fibonacci"]]]
ONLY_A_NAME = "declaring a parameter only providing its name"
GONE = ["DeprecationWarning"]
ANSWERS: dict[str, dict[str, Any]] = {
    "lyrical": {
        "node_of_asyncio": [[False, True, False, True], "served", "text", "TimerInfo"],
        "mistakes_with_asyncio": [
            "RuntimeError: Node is already running",
            "RuntimeError: Timer callback must accept zero arguments or one argument (TimerInfo)",
            "RuntimeError: Node has been destroyed and cannot be reentered",
            "RuntimeError: Cannot create publisher on a destroyed node",
            "RuntimeError: Cannot create subscription on a destroyed node",
            "RuntimeError: Cannot create client on a destroyed node",
            "RuntimeError: Cannot create service on a destroyed node",
            "RuntimeError: Cannot sleep on a destroyed clock",
        ],
        "sleeping_by_simulated_time": ["TimeSourceChangedError", False, True],
        "ends_of_a_service": [
            [
                [True, "serves", "/", "std_srvs/srv/Trigger", "SERVER", 2, 2, True],
                [True, "calls", "/here", "std_srvs/srv/Trigger", "CLIENT", 2, 2, True],
            ],
            {"INVALID": 0, "PUBLISHER": 1, "SUBSCRIPTION": 2, "CLIENT": 3, "SERVER": 4},
        ],
        "actions_of_the_graph": [ACTIONS, ACTIONS, ACTIONS, [], True, GONE],
        "dates_of_times": [
            True,
            True,
            True,
            "TypeError: Time object's clock type should be either ROS_TIME or SYSTEM_TIME",
        ],
        "parameters_with_tags": [
            {
                "tagged": ["DOUBLE", "10.0"],
                "list": ["DOUBLE_ARRAY", "[1.0, 2.0]"],
                "octets": ["BYTE_ARRAY", r"[b'\x00', b'\x01', b'\xff']"],
                "text": ["STRING", "10"],
            },
            f"TypeError: when declaring parameter named 'alone', {ONLY_A_NAME} is not allowed",
            [],
            False,
        ],
        "feedback_too_late": [
            [[1]],
            5,  # canceled
            ["publish_feedback() called on a goal handle not in executing state, ignoring"],
        ],
        "events_of_some_nodes": [True, ["/second"], False, ["/first", "/second"]],
        "feedback_of_ones_own_goal": [{"1": [1, 1, 1], "2": [2, 2, 2]}, [[1], [2]]],
        "changes_of_a_lifecycle_node": ["builtin_interfaces/Time", ["configuring", "inactive"], True],
        "names_that_are_gone": [
            [True, GONE],
            ["QoSEventHandler", GONE],
            [None, GONE],
            [True, GONE],
            [True, []],
        ],
        "launched_with_newer_actions": [
            0,
            ["true", "turtle0", "turtle1", "first 1", "second 2", "a-bc", [["ONLY", "this"]]],
            ["own.log"],
        ],
    },
    "jazzy": {
        "executor_that_spins": [[False, True], "RuntimeError: Executor is already spinni", False],
        "server_without_a_callback": [4, [7]],
        "task_that_awaits": [
            ["begun", False],
            ["begun", "first"],
            "done",
            ["PENDING", "CANCELLED", "FINISHED"],
        ],
    },
}
"""By the release that has them, the programs of `newest.py` and what they print."""
OF_ASYNCIO = {"node_of_asyncio", "mistakes_with_asyncio", "sleeping_by_simulated_time"}
"""They need what asyncio has from Python 3.11 on."""


@pytest.mark.wire
@pytest.mark.parametrize("wire", ["rmw_cyclonedds_cpp", "tfloom_local"])
@pytest.mark.parametrize("distribution", ANSWERS)
def test_programs_print_what_the_release_does(distribution: str, wire: str, domain_id: int) -> None:
    expected = {
        name: answer
        for name, answer in ANSWERS[distribution].items()
        if sys.version_info >= (3, 11) or name not in OF_ASYNCIO
    }
    if wire == "tfloom_local":
        expected.pop("ends_of_a_service", None)  # counts those of DDS
    environment = os.environ | {"ROS_DISTRO": distribution, "RMW_IMPLEMENTATION": wire}
    done = run_to_end([sys.executable, PROGRAMS, *expected], env=environment, timeout_s=120)
    assert done.returncode == 0, done.stderr
    assert json.loads(done.stdout.splitlines()[-1]) == expected

"""Services and actions: hashes, class paths, parts."""

from __future__ import annotations

import json
import pickle
from pathlib import Path

import pytest
from tests.each import for_each
from tests.rosidl.workspaces import run_python

from tfloom.interfaces.action_msgs.msg import GoalStatusArray
from tfloom.interfaces.action_msgs.srv import CancelGoal
from tfloom.interfaces.example_interfaces import action as example_actions
from tfloom.interfaces.example_interfaces.action import Fibonacci
from tfloom.interfaces.turtlesim import srv as turtlesim_srv
from tfloom.interfaces.turtlesim.srv import Spawn
from tfloom.interfaces.turtlesim_msgs.srv import Spawn as KiltedSpawn
from tfloom.rosidl.registry import find_class
from tfloom.rosidl.service import Service

GOLDEN = Path(__file__).parents[1] / "golden" / "jazzy_types.jsonl"
HASHES = {
    record["type"]: record["type_hash"] for record in map(json.loads, GOLDEN.read_text("utf-8").splitlines())
}


@for_each(HASHES)
def test_hashes_of_all_services_and_actions_match(name: str) -> None:
    assert HASHES[name] == find_class(name)._TYPE_HASH
    assert name == find_class(name)._TYPE_NAME


def test_service_has_request_response_and_event() -> None:
    assert Spawn.Request is turtlesim_srv.Spawn_Request
    assert Spawn.Response is turtlesim_srv.Spawn_Response
    assert Spawn.Event is turtlesim_srv.Spawn_Event
    request = Spawn.Request(x=1.0, name="bob")
    assert pickle.loads(pickle.dumps(request)) == request
    assert KiltedSpawn._TYPE_NAME == "turtlesim_msgs/srv/Spawn"
    assert KiltedSpawn._TYPE_HASH != Spawn._TYPE_HASH


def test_type_arguments_are_for_type_checkers_alone() -> None:
    assert Spawn.__bases__ == (Service,)
    assert Service[Spawn.Request, Spawn.Response] is Service
    assert not hasattr(Service, "Request")
    code = "import sys; before = {*sys.modules}; import tfloom.rosidl.service; print({*sys.modules} - before)"
    loaded = run_python(code).stdout
    assert "'tfloom.rosidl.service'" in loaded
    assert "'typing'" not in loaded


def test_action_has_goal_result_and_feedback() -> None:
    assert Fibonacci.Goal is example_actions.Fibonacci_Goal
    assert Fibonacci.Result is example_actions.Fibonacci_Result
    assert Fibonacci.Feedback is example_actions.Fibonacci_Feedback
    assert Fibonacci.Impl.SendGoalService.Request is example_actions.Fibonacci_SendGoal_Request
    assert Fibonacci.Impl.GetResultService.Response is example_actions.Fibonacci_GetResult_Response
    assert Fibonacci.Impl.FeedbackMessage is example_actions.Fibonacci_FeedbackMessage
    assert Fibonacci.Impl.CancelGoalService is CancelGoal
    assert Fibonacci.Impl.GoalStatusMessage is GoalStatusArray


def test_services_and_actions_cannot_be_instantiated() -> None:
    with pytest.raises(NotImplementedError, match="Service classes can not be instantiated"):
        Spawn()
    with pytest.raises(NotImplementedError, match="Action classes can not be instantiated"):
        Fibonacci()

"""Misuse that needs more than one line of a program; `test_wrong_arguments` has the rest."""

from __future__ import annotations

from typing import Any, cast

import pytest

from tfloom.interfaces.geometry_msgs.msg import TransformStamped
from tfloom.node.node import Node
from tfloom.node.parameters.parameter import Parameter
from tfloom.node.values.time import Time
from tfloom.tf2_ros.buffer import Buffer


def test_wait_with_a_wrong_timeout_leaves_no_request() -> None:
    buffer = Buffer()
    with pytest.raises(TypeError):
        buffer.wait_for_transform_async("a", "b", Time(), 1.5)
    transform = TransformStamped(child_frame_id="b")
    transform.header.frame_id = "a"
    transform.transform.rotation.w = 1.0
    buffer.set_transform(transform, "me")
    assert not buffer.cancel_request(1)


def test_timer_without_a_callback_warns(node: Node) -> None:
    """It is not an error, because the reference accepts it; a rate has such a timer."""
    with pytest.warns(UserWarning, match="without brackets") as caught:
        node.create_timer(1.0, None)
    assert caught[0].filename == __file__
    node.create_rate(10.0)


def test_callback_of_parameters_that_returns_nothing_is_named(node: Node) -> None:
    def without_a_return(_parameters: list[Parameter]) -> None:
        pass

    node.declare_parameter("speed", 1.0)
    node.add_on_set_parameters_callback(cast("Any", without_a_return))
    with pytest.warns(
        UserWarning, match=r"without_a_return.*: write return SetParametersResult\(successful=True\)"
    ):
        (result,) = node.set_parameters([Parameter("speed", value=2.0)])
    assert result.reason == "Callback returned an invalid type"
    assert node.get_parameter("speed").value == 1.0

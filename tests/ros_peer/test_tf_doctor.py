"""What `tfloom tf doctor` says of a node of stock rclpy on Fast DDS."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tools.ros_peer import RosPeer

pytestmark = pytest.mark.ros

NODE = Path(__file__).parent / "programs" / "faulty_stock_node.py"


def test_a_stock_node_is_named(peer: RosPeer, domain_id: int, start_program: Callable[..., Any]) -> None:
    start_program("tfloom", "run", "tf2_ros", "buffer_server")
    environment = peer.environment(domain_id, ROS_LOG_DIR=os.environ["ROS_LOG_DIR"])
    stock = start_program(peer.python, NODE, env=environment)
    stock.wait_for("asked")
    doctor = start_program("tfloom", "tf", "doctor", "--json", "--seconds", "4")
    assert doctor.wait() == 1, doctor.output
    findings = json.loads("\n".join(line for line in doctor.lines if not line.startswith("waiting")))[
        "findings"
    ]
    named = {finding["code"]: finding["nodes"] for finding in findings if "/stock" in finding["nodes"]}
    assert {code: nodes for code, nodes in named.items() if code not in {"TF404", "TF405", "TF406"}} == {
        "TF301": ["/stock"],
        "TF503": ["/stock", "/tf_buffer"],
        "TF602": ["/stock"],
    }
    assert "absent" not in stock.lines, "the server seemed to leave while the doctor read requests"

"""tfloom beside a real rclpy: it adds names and never shadows one, and its guard names the drop-in."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest
from tests.conftest import run_to_end
from tests.drop_in.conftest import Peer
from tests.wheels import release_files, wheel_of
from tools.ros_peer import RosPeer

pytestmark = pytest.mark.ros

LINE = "from tfloom.drop_in import Buffer, TransformListener"
ORIGINS = """
import json, pkgutil, sys
from importlib.machinery import PathFinder
names = {module.name for module in pkgutil.iter_modules()}
origins = {name: getattr(PathFinder.find_spec(name), "origin", None) for name in names}
print(json.dumps([origins, [path for path in sys.path if path.endswith("ros_names")] == sys.path[-1:]]))
"""
IMPORTS = """
import rclpy, geometry_msgs.msg, std_msgs.msg, sensor_msgs.msg, tf2_msgs.msg, builtin_interfaces.msg
from rclpy.type_support import check_for_type_support
for kind in (geometry_msgs.msg.TransformStamped, sensor_msgs.msg.Image, tf2_msgs.msg.TFMessage):
    check_for_type_support(kind)
rclpy.init()
node = rclpy.create_node("checks")
node.create_subscription(tf2_msgs.msg.TFMessage, "/tf", print, 10)
from tfloom.drop_in import Buffer, TransformListener
TransformListener(Buffer(node=node), node)
node.destroy_node()
rclpy.shutdown()
print("passed")
"""


def run(peer: RosPeer, code: str, *, python: Path | None = None, domain_id: int = 0, **variables: str) -> Any:
    """Run code without its own traffic, or on a domain."""
    return run_to_end(
        [python or peer.python, "-c", code], env=peer.environment(domain_id, **variables), timeout_s=120
    )


def added_as_site(site: Path, code: str) -> str:
    """Return code that first adds a folder as Python does with site-packages, its .pth files included."""
    return f"import site; site.addsitedir({str(site)!r})\n{code}"


def test_installed_tfloom_adds_names_and_shadows_none(
    peer: RosPeer, site_without_dds: Path, dds_site: Path
) -> None:
    before, _ = json.loads(run(peer, ORIGINS).stdout)
    result = run(peer, added_as_site(site_without_dds, ORIGINS), PYTHONPATH=str(dds_site))
    after, is_last = json.loads(result.stdout)
    assert is_last, result.stdout
    assert {name: after[name] for name in before} == before
    added = after.keys() - before.keys()
    assert {"tfloom", "tf2_ros", "turtlesim"} <= added
    assert {"rclpy", "geometry_msgs", "sensor_msgs", "tf2_msgs"} <= before.keys()


def test_sourced_ros_takes_precedence_over_an_installed_tfloom(peer: RosPeer, site_without_dds: Path) -> None:
    code = added_as_site(
        site_without_dds, "import rclpy, geometry_msgs; print(rclpy.__file__, geometry_msgs.__file__)"
    )
    result = run(peer, code)
    assert str(site_without_dds) not in result.stdout
    assert result.returncode == 0, result.stderr


@pytest.mark.parametrize("name", ["tf2_ros", "tf2_ros.buffer", "tf2_py"])
def test_guard_names_the_drop_in_and_prints_its_line(
    name: str, peer: RosPeer, site_without_dds: Path
) -> None:
    result = run(peer, added_as_site(site_without_dds, f"import {name}"))
    assert result.returncode == 1
    last = result.stderr.strip().splitlines()[-1]
    assert last.startswith(
        f"ImportError: '{name.partition('.')[0]}' would come from tfloom, but 'rclpy' comes from "
    )
    assert f"with the nodes of that rclpy, write `{LINE}`" in last


def test_line_of_the_guard_works(peer: RosPeer, site_without_dds: Path, dds_site: Path) -> None:
    code = added_as_site(site_without_dds, f"{LINE}; print(Buffer.__module__, TransformListener.__module__)")
    result = run(peer, code, PYTHONPATH=str(dds_site))
    assert result.stdout.split() == ["tfloom.drop_in.buffer", "tfloom.drop_in.transform_listener"], (
        result.stderr
    )


def test_missing_messages_are_named(peer: RosPeer, site_without_dds: Path, tmp_path: Path) -> None:
    (tmp_path / "rclpy").mkdir()
    (tmp_path / "rclpy" / "__init__.py").touch()
    first = [str(tmp_path), str(site_without_dds)]
    code = f"import sys; sys.path[:] = {first!r} + [path for path in sys.path if 'site-packages' not in path]"
    result = run(peer, f"{code}\n{LINE}\nBuffer()")
    last = result.stderr.strip().splitlines()[-1]
    assert last == "ImportError: 'geometry_msgs' is not installed for the ROS 2 that 'rclpy' comes from"


def test_drop_in_imports_no_window_and_no_command(real_ros: Peer) -> None:
    code = f"import sys; {LINE}; print([n for n in sys.modules if n.split('.')[0] in ('pygame', 'PIL', 'reportlab')])"
    program = real_ros.start(code, domain_id=0)
    assert program.wait() == 0
    assert program.lines == ["[]"]


@pytest.mark.slow
def test_pip_install_into_the_environment_of_a_real_rclpy(
    peer: RosPeer, dds_site: Path, tmp_path: Path, tmp_path_factory: pytest.TempPathFactory, domain_id: int
) -> None:
    environment = tmp_path / "environment"
    shutil.copytree(peer.python.parents[1], environment, symlinks=True, copy_function=os.link)
    python = environment / "bin" / "python"
    wheel = wheel_of(release_files(tmp_path_factory), "tfloom")
    before, _ = json.loads(run(peer, ORIGINS, python=python).stdout)
    pip = [python, "-m", "pip", "--disable-pip-version-check", "install", "--no-deps", "--no-index", wheel]
    subprocess.run(pip, check=True, timeout=300, env=peer.environment(domain_id))
    after, is_last = json.loads(run(peer, ORIGINS, python=python).stdout)
    assert is_last
    assert {name: after[name] for name in before} == before
    assert "rclpy" in before
    assert str(environment) in before["rclpy"]
    result = run(peer, IMPORTS, python=python, domain_id=domain_id, PYTHONPATH=str(dds_site))
    assert result.stdout.splitlines()[-1:] == ["passed"], result.stderr
    result = run(peer, "import tf2_ros", python=python)
    assert LINE in result.stderr

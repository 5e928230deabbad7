"""The real rclpy that `make ros-peer` installs, with tfloom beside it."""

from __future__ import annotations

import os
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from tools.ros_peer import NoPeerError, RosPeer, find
from tools.staged import stage, stage_dds

PROGRAMS = Path(__file__).parent / "programs"


@pytest.fixture(scope="session")
def peer() -> RosPeer:
    """Return the installed peer, with its tf2_msgs."""
    try:
        found = find()
    except NoPeerError as error:
        pytest.skip(str(error))
    if not found.has("tf2_msgs"):
        pytest.skip("tf2_msgs could not be compiled for the real rclpy")
    return found


@pytest.fixture(scope="session")
def site_without_dds(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with the installed tfloom alone."""
    return stage(tmp_path_factory.mktemp("site"))


@pytest.fixture(scope="session")
def dds_site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Return a folder with libddsc, as tfloom-ddsc installs it."""
    try:
        return stage_dds(tmp_path_factory.mktemp("dds"))
    except FileNotFoundError as error:
        pytest.skip(f"needs DDS: {error}")


class Peer:
    """Starts the programs of this folder by the real rclpy's Python, with tfloom on their path."""

    def __init__(self, peer: RosPeer, sites: list[Path], start: Callable[..., Any]) -> None:
        self.peer = peer
        self.sites = sites
        self._start = start

    def start(
        self,
        program: str,
        *arguments: object,
        domain_id: int,
        paths: list[Path] | None = None,
        **variables: str,
    ) -> Any:
        """Start `programs/<program>.py`, or the code of a text with a space in it."""
        words = ["-c", program] if " " in program else [str(PROGRAMS / f"{program}.py")]
        path = os.pathsep.join(map(str, [*(self.sites if paths is None else paths)]))
        environment = self.peer.environment(domain_id, PYTHONPATH=path, **variables)
        return self._start(self.peer.python, *words, *map(str, arguments), env=environment)


@pytest.fixture
def real_ros(
    peer: RosPeer, site_without_dds: Path, dds_site: Path, start_program: Callable[..., Any]
) -> Peer:
    return Peer(peer, [site_without_dds, dds_site], start_program)


@pytest.fixture(scope="module")
def module_real_ros(
    peer: RosPeer, site_without_dds: Path, dds_site: Path, start_module_program: Callable[..., Any]
) -> Peer:
    return Peer(peer, [site_without_dds, dds_site], start_module_program)

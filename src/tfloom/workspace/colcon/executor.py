"""The executor, which builds what can be built: a package that is left out or broken stops no other."""

from __future__ import annotations

import os
from collections import OrderedDict
from collections.abc import Mapping
from contextlib import suppress
from pathlib import Path
from typing import Any

from colcon_core.executor import Job, OnError
from colcon_core.subprocess import SIGINT_RESULT

from tfloom.workspace.cmake_lists import read_plan
from tfloom.workspace.colcon.identification import BROKEN_TYPE, READ_TYPE
from tfloom.workspace.colcon.selection import MISSING_KEY
from tfloom.workspace.colcon.tasks import LEFT_OUT_KEY, say
from tfloom.workspace.leftovers import remove_copies, remove_dangling_links
from tfloom.workspace.missing_dependencies import how_to_provide, what_is_missing

try:
    from colcon_parallel_executor.executor.parallel import ParallelExecutorExtension as Base
except ImportError:
    from colcon_core.executor.sequential import SequentialExecutor as Base


MARKERS_PLUGIN = "tfloom.workspace.pytest_markers"


class Executor(Base):
    """Process packages in parallel; those depending on a broken interface package are built."""

    PRIORITY = 120  # above that of colcon-parallel-executor

    def add_arguments(self, *, parser: Any) -> None:
        """Add no arguments, because `--parallel-workers` is the other executor's."""

    def execute(self, args: Any, jobs: Mapping[str, Job], *, on_error: OnError = OnError.interrupt) -> Any:
        """Run the jobs; return the first error, also of a job that stopped no other."""
        _add_pytest_markers()
        failed: set[str] = set()
        wrapped = OrderedDict((name, _TolerantJob(job, failed, jobs)) for name, job in jobs.items())
        return super().execute(args, wrapped, on_error=on_error) or int(bool(failed))


def _add_pytest_markers() -> None:
    """Name the plug-in with ROS's markers to the tests that jobs run."""
    named = os.environ.get("PYTEST_PLUGINS")
    if MARKERS_PLUGIN not in (named or "").split(","):
        os.environ["PYTEST_PLUGINS"] = f"{named},{MARKERS_PLUGIN}" if named else MARKERS_PLUGIN


def _remove_leftovers(context: Any) -> None:
    """Remove what an earlier build has left and colcon's own build of ament_python fails at."""
    args, name = context.args, context.pkg.name
    build, prefix = Path(args.build_base), Path(args.install_base)
    with suppress(OSError):  # the build itself then fails, with the reason
        if args.symlink_install:
            remove_copies(build, prefix)
        # The links of ament_python lead to its build folder, and those there to the sources.
        remove_dangling_links([build, prefix / "share" / name, prefix / "lib" / name])


def _has_cpp(folder: Path) -> bool:
    """Return whether the CMakeLists.txt of a package compiles; one that can't be read doesn't."""
    try:
        return bool(read_plan(folder, folder).compiled)
    except (OSError, ValueError):
        return False


class _TolerantJob:
    """A job that succeeds, for the executor, although its package can't be built by tfloom.

    Args:
        job: The job itself.
        failed: The packages of all jobs that can't be built.
        jobs: All jobs.
    """

    def __init__(self, job: Job, failed: set[str], jobs: Mapping[str, Job]) -> None:
        self._job = job
        self._failed = failed
        self._jobs = jobs
        self.identifier: str = job.identifier
        self.dependencies: set[str] = job.dependencies

    @property
    def returncode(self) -> int | None:
        """The exit code of the job itself."""
        code: int | None = self._job.returncode
        return code

    @returncode.setter
    def returncode(self, value: int) -> None:
        self._job.returncode = value

    async def __call__(self) -> Any:
        """Run the job and return its code: a number, or colcon's text for an interrupt.

        A failure that stops no other job is returned as 0.
        """
        if self._job.task.TASK_NAME == "build":
            _remove_leftovers(self._job.task_context)
        warnings = [*self._left_out(), *self._missing()]
        if warnings and self._job.task.TASK_NAME == "build":
            self._job.task = _WarnedTask(self._job.task, "\n".join(warnings))
        # The failure of a package that tfloom can't build must not stop those that depend on it, which are built all
        # the same. The package is noted, so that they report it, and so that the whole run still fails at the end.
        code = await self._job()
        if code and code != SIGINT_RESULT and self._job.task_context.pkg.type in {READ_TYPE, BROKEN_TYPE}:
            self._failed.add(self.identifier)
            return 0
        return code

    def _left_out(self) -> list[str]:
        """Return a sentence on dependencies in the workspace that are left out or failed, if there are any."""
        reasons = []
        for name in sorted(self.dependencies - {self.identifier}):
            job = self._jobs.get(name)
            reason = "failed" if name in self._failed else None
            if reason is None and job is not None:
                reason = job.task_context.pkg.metadata.get(LEFT_OUT_KEY)
            if reason:
                reasons.append(f"{name}, which {reason}")
        needs = " and ".join(reasons)
        return [f"{self.identifier} depends on {needs}: what uses it will not run"] if reasons else []

    def _missing(self) -> list[str]:
        """Return sentences on dependencies that nobody provides; of a package with C++, these don't matter."""
        package = self._job.task_context.pkg
        if package.type == READ_TYPE and _has_cpp(package.path):
            return []
        by_remedy: dict[tuple[str, str], list[str]] = {}
        for name in package.metadata.get(MISSING_KEY, ()):
            by_remedy.setdefault((what_is_missing(name), how_to_provide(name)), []).append(name)
        return [
            f"{self.identifier} asks for {', '.join(names)} in package.xml: {where}: {remedy}"
            for (where, remedy), names in by_remedy.items()
        ]

    def __str__(self) -> str:
        return self.identifier


class _WarnedTask:
    """A task that prints a warning first."""

    def __init__(self, task: Any, warning: str) -> None:
        self._task = task
        self._warning = warning

    @property
    def context(self) -> Any:
        """The context of the task itself, which extensions of colcon read when it has failed."""
        return self._task.context

    def set_context(self, *, context: Any) -> None:
        """Set the context of the task itself."""
        self._task.set_context(context=context)

    async def __call__(self, *args: Any, **kwargs: Any) -> Any:
        """Print the warning and run the task."""
        say(self.context, self._warning)
        return await self._task(*args, **kwargs)

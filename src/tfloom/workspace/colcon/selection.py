"""What concerns all packages of a workspace: those of one name, and dependencies that nobody provides."""

from __future__ import annotations

from collections import defaultdict
from typing import Any

from colcon_core.package_decorator import PackageDecorator
from colcon_core.package_descriptor import PackageDescriptor
from colcon_core.package_selection import PackageSelectionExtensionPoint

from tfloom.workspace.colcon.identification import BROKEN_TYPE, FAULT_KEY, has_real_ament_cmake
from tfloom.workspace.missing_dependencies import is_provided

MISSING_KEY = "tfloom_missing"
"""The key of the dependencies that nobody provides, in the metadata of a package's descriptor."""


class Selection(PackageSelectionExtensionPoint):
    """Replace packages of one name by one that fails with a sentence, because colcon would build nothing.

    Note the dependencies that nobody provides, too.
    """

    PRIORITY = 10  # after what the user selects

    def select_packages(self, *, args: Any, decorators: list[PackageDecorator]) -> None:
        """Leave one of the selected packages of each name, marked as broken if there are others."""
        notes = not has_real_ament_cmake()  # a real ROS has its own ways, as rosdep
        names = {decorator.descriptor.name for decorator in decorators}
        by_name = defaultdict(list)
        for decorator in decorators:
            if decorator.selected:
                by_name[decorator.descriptor.name].append(decorator)
                if notes:
                    _note_missing(decorator.descriptor, names)
        for name, unsorted in by_name.items():
            first, *others = sorted(unsorted, key=lambda decorator: str(decorator.descriptor.path))
            if not others:
                continue
            for other in others:
                other.selected = False
            paths = "".join(f"\n    {decorator.descriptor.path}" for decorator in (first, *others))
            first.descriptor.type = BROKEN_TYPE
            first.descriptor.metadata[FAULT_KEY] = (
                f"{1 + len(others)} packages are named '{name}', so none of them is built: rename one in its "
                f"package.xml, or put an empty file COLCON_IGNORE into its folder:{paths}"
            )


def _note_missing(desc: PackageDescriptor, names: set[str]) -> None:
    """Note the dependencies of a package that are neither in the workspace nor provided otherwise."""
    depends = {str(dependency) for kind in ("build", "run") for dependency in desc.dependencies[kind]}
    missing = sorted(dependency for dependency in depends - names if not is_provided(dependency))
    if missing:
        desc.metadata[MISSING_KEY] = missing

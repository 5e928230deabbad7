"""Folders of packages as substitutions: `$(find-pkg-prefix NAME)` and `$(find-pkg-share NAME)`."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.launch_context import LaunchContext
from tfloom.launch.some_substitutions_type import SomeSubstitutionsType
from tfloom.launch.substitution import Substitution
from tfloom.launch.substitutions.described import described
from tfloom.launch.utilities.nearest import did_you_mean
from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions
from tfloom.launch.utilities.perform_substitutions import perform_substitutions
from tfloom.workspace.ament import PackageNotFoundError, get_package_prefix, get_package_share_directory

__all__ = ["FindPackage", "FindPackagePrefix", "FindPackageShare"]


class FindPackage(Substitution):
    """A folder of a package; derived classes define which.

    Args:
        package: Name of the package, or substitutions for it.
    """

    def __init__(self, package: SomeSubstitutionsType) -> None:
        super().__init__()
        self._package = normalize_to_list_of_substitutions(package)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[FindPackage], dict[str, Any]]:
        """Return the class, and the arguments that the text of a launch file gives its constructor.

        Raises:
            AttributeError: there is not exactly one argument.
        """
        if len(data) != 1:
            raise AttributeError(f"{cls.__name__} substitution expects 1 argument, got {len(data)}")
        return cls, {"package": data[0]}

    @property
    def package(self) -> list[Substitution]:
        """Name of the package."""
        return self._package

    def describe(self) -> str:
        """Return a description for people."""
        return f"{type(self).__name__}(pkg={described(self._package)})"

    def find(self, package_name: str) -> str:
        """Return the folder of a package; derived classes implement it."""
        raise NotImplementedError(f"{type(self).__name__} has no method 'find', which returns the folder")

    def perform(self, context: LaunchContext) -> str:
        """Return the folder.

        Raises:
            PackageNotFoundError: there is no such package.
            ValueError: it is not a valid package name.
        """
        package = perform_substitutions(context, self._package)
        try:
            return self.find(package)
        except PackageNotFoundError as error:
            raise PackageNotFoundError(f"{error}{_nearest_package(package)}") from error


def _nearest_package(package: str) -> str:
    """Return what stands in for a package, or the package of the nearest name, as a text.

    It is empty if a workspace here has the package, or no name is near.
    """
    from tfloom.workspace import index
    from tfloom.workspace.unsourced import how_to_find

    if hint := how_to_find(package):
        # The error has how a workspace makes the package known already.
        return f"; {hint}" if hint == index.STAND_INS.get(package) else ""
    return did_you_mean(package, {*index.workspace_packages(), *index.own_packages()})


@expose_substitution("find-pkg-prefix")
class FindPackagePrefix(FindPackage):
    """The prefix that a package is installed under."""

    def find(self, package_name: str) -> str:
        """Return the prefix of a package."""
        return get_package_prefix(package_name)


@expose_substitution("find-pkg-share")
class FindPackageShare(FindPackage):
    """The folder of a package's files: `PREFIX/share/NAME`."""

    def find(self, package_name: str) -> str:
        """Return the share folder of a package."""
        return get_package_share_directory(package_name)

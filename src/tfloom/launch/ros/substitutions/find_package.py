"""Folders of packages as substitutions: `$(find-pkg-prefix NAME)` and `$(find-pkg-share NAME)`."""

from __future__ import annotations

from typing import ClassVar

from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.core.substitution import ParsedSubstitution, SomeSubstitutionsType, Substitution, described
from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.utilities.nearest import did_you_mean
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions
from tfloom.workspace.ament import PackageNotFoundError, get_package_prefix, get_package_share_directory

__all__ = ["FindPackage", "FindPackagePrefix", "FindPackageShare"]


class FindPackage(ParsedSubstitution):
    """A folder of a package; derived classes define which.

    Args:
        package: Name of the package, or substitutions for it.
    """

    _arguments: ClassVar[tuple[str, ...]] = ("package",)
    _fault = "{class_name} substitution expects 1 argument, got {count}"
    _error = AttributeError

    def __init__(self, package: SomeSubstitutionsType) -> None:
        super().__init__()
        self._package = normalize_to_list_of_substitutions(package)

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

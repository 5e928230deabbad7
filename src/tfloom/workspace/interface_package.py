"""Building an interface package: what `rosidl_generate_interfaces` installs for Python, without CMake and a compiler.

    share/my_interfaces/{msg,srv,action}/          the definitions
    share/my_interfaces/package.xml
    share/ament_index/resource_index/*/my_interfaces
    lib/python3.x/site-packages/my_interfaces/     modules, and stubs: msg/__init__.py, __init__.pyi, _sphere.py

The modules create their classes from the installed definitions, at first access. So the classes are those that the
commands use, and one that is a symbolic link into the source folder can be edited without a new build.
"""

from __future__ import annotations

import os
import sysconfig
from collections.abc import Iterator, Sequence
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple

from tfloom.common.files import write_file
from tfloom.rosidl import definition_files
from tfloom.workspace import index
from tfloom.workspace.interface_stubs import typed_modules
from tfloom.workspace.listed_files import ListedFile, find_listed
from tfloom.workspace.package_definitions import PACKAGE_XML, Manifest, PackageDefinitions, read_manifest

_BY = "colcon build"
_MODULE = '''\
"""The interfaces of {package}. Written by `{by}`: change the definitions instead."""

from tfloom.rosidl.definition_modules import fill_built_module

fill_built_module(__name__, __file__, "{prefix}")
'''


class Installed(NamedTuple):
    """The result of `install_interfaces`."""

    names: list[str]
    """`my_interfaces/msg/Sphere` of each interface, in order."""
    python_folder: Path
    """The folder that PYTHONPATH needs."""
    files: list[Path]
    """All files of the package, in order of their paths."""
    warnings: list[str]
    """A sentence for each mistake that hinders no build here."""


class InterfacePackageError(ValueError):
    """A package that can't be built. The text has a line for each mistake: file, line, column and reason."""

    def __init__(self, errors: Sequence[str]) -> None:
        super().__init__("\n".join(errors))
        self.errors = list(errors)


def install_interfaces(
    source: Path,
    name: str,
    files: Sequence[str],
    prefix: Path,
    *,
    symlink: bool = False,
    dependencies: Sequence[Path] = (),
) -> Installed:
    """Check the definitions of an interface package and install it; what a former build left is removed.

    Nothing is installed if any definition can't be built.

    Args:
        source: The package's folder.
        name: The package's name.
        files: The definitions, as `rosidl_generate_interfaces` lists them: `msg/Sphere.msg`, `srv/Weigh.srv`,
            `action/Roll.action` or `.idl` files, relative to `source`, or `/a/folder:msg/Sphere.msg`.
        prefix: Where to install.
        symlink: Whether to install links to the definitions instead of copies.
        dependencies: Prefixes of packages whose messages are used, searched before AMENT_PREFIX_PATH.

    Raises:
        InterfacePackageError: a file is missing, can't be parsed, or uses a message that is unknown.
        OSError: a file can't be read or written.
    """
    prefix = prefix.absolute()
    listed = find_listed(source.absolute(), files)
    if listed.errors:
        raise InterfacePackageError(listed.errors)
    manifest = _read_manifest(source.absolute() / PACKAGE_XML, name)
    paths = {file.name(name): file.path for file in listed.files}
    definitions = PackageDefinitions(name, paths, [*dependencies, prefix])
    if errors := list(definitions.check(manifest)):
        raise InterfacePackageError(errors)

    package = _Package(name, prefix, symlink=symlink)
    package.install_definitions(listed.files)
    package.install_source(source.absolute() / PACKAGE_XML, PACKAGE_XML)
    package.install_markers(manifest, listed.files)
    package.install_modules(definitions)
    warnings = [
        f"{source / PACKAGE_XML}: the definitions use {used}: add <depend>{used}</depend>"
        for used in definitions.undeclared(manifest)
    ]
    return Installed(sorted(paths), package.python_folder, sorted(package.files), warnings)


def python_folder(prefix: Path) -> Path:
    """Return the folder below a prefix that colcon adds to PYTHONPATH: `lib/python3.x/site-packages`."""
    schemes = [name for name in ("deb_system", "posix_prefix") if name in sysconfig.get_scheme_names()]
    scheme = "nt" if os.name == "nt" else schemes[0]
    return Path(sysconfig.get_path("purelib", scheme, {"base": str(prefix), "platbase": str(prefix)}))


def _read_manifest(path: Path, name: str) -> Manifest:
    try:
        manifest = read_manifest(path)
    except FileNotFoundError:
        raise InterfacePackageError([f"{path}: a package needs this file"]) from None
    except ValueError as error:
        raise InterfacePackageError([str(error)]) from None
    if manifest.name != name:
        raise InterfacePackageError([f"{path}: the package is called '{manifest.name}' here, not '{name}'"])
    return manifest


def _written_modules(folder: Path) -> Iterator[Path]:
    """Yield the modules and stubs in a package's Python folder that this or an earlier tfloom may have written."""
    yield from folder.glob("__init__.py*")
    for kind in definition_files.KINDS:
        yield from folder.glob(f"{kind}.py*")
        yield from folder.glob(f"{kind}/__init__.pyi")
        yield from folder.glob(f"{kind}/_*.py")


class _Package:
    """The files of one package below a prefix."""

    def __init__(self, name: str, prefix: Path, *, symlink: bool) -> None:
        self.name, self.prefix, self.symlink = name, prefix, symlink
        self.share = prefix / "share" / name
        self.index = prefix / index.RESOURCE_INDEX
        self.python_folder = python_folder(prefix)
        self.files: list[Path] = []

    def install_definitions(self, listed: Sequence[ListedFile]) -> None:
        """Install the definitions, after those that a former build installed are removed."""
        with suppress(FileNotFoundError):
            for place in (self.index / "rosidl_interfaces" / self.name).read_text("utf-8").split():
                (self.share / place).unlink(missing_ok=True)
        for file in listed:
            self.install_source(file.path, file.place)

    def install_source(self, path: Path, place: str) -> None:
        """Install a file of the source folder at its place in the package's folder."""
        target = self.share / place
        target.parent.mkdir(parents=True, exist_ok=True)
        target.unlink(missing_ok=True)
        if self.symlink:
            target.symlink_to(path.resolve())
        else:
            write_file(target, path.read_bytes())
        self.files.append(target)

    def install_markers(self, manifest: Manifest, listed: Sequence[ListedFile]) -> None:
        """Install the package's entries in the ament index."""
        places = "\n".join(file.place for file in listed)
        self._write(self.index / "packages" / self.name, "")
        self._write(self.index / "package_run_dependencies" / self.name, ";".join(manifest.run))
        self._write(self.index / "rosidl_interfaces" / self.name, places)

    def install_modules(self, definitions: PackageDefinitions) -> None:
        """Install the Python modules and their stubs; remove those of kinds that there are no longer."""
        folder = self.python_folder / self.name
        stubs = dict(self._stubs(definitions))
        for path in _written_modules(folder):
            if path.relative_to(folder).with_suffix(".pyi").as_posix() not in stubs:
                path.unlink()
        if not stubs:
            return
        for place, text in stubs.items():
            path = folder / place
            if path.stem != "__init__":  # the module of a definition, which only hands on
                self._write(path.with_suffix(".py"), text)
                continue
            to_prefix = Path(os.path.relpath(self.prefix, path.parent)).as_posix()
            module = _MODULE.format(package=self.name, by=_BY, prefix=to_prefix)
            self._write(path.with_suffix(".py"), module)
            self._write(path, text)
        self._write(folder / "py.typed", "")

    def _stubs(self, definitions: PackageDefinitions) -> Iterator[tuple[str, str]]:
        interfaces = [definitions.find_interface(name) for name in definitions.files]
        return typed_modules(self.name, interfaces, definitions.find_message, by=_BY)

    def _write(self, path: Path, text: str) -> None:
        path.parent.mkdir(parents=True, exist_ok=True)
        if path.is_symlink():
            # A link of an earlier build to a source, which writing would change.
            path.unlink()
        write_file(path, text)
        self.files.append(path)

"""An interface package that is being built: what its `package.xml` declares, and its definitions.

Among these are those of the packages that it depends on.
"""

from __future__ import annotations

import difflib
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from tfloom.rosidl import definition_files, sources, spec
from tfloom.rosidl.parse import ParseError
from tfloom.rosidl.references import UnknownMessageError, check_references

_RUN_TAGS = ("depend", "exec_depend", "run_depend", "test_depend")
PACKAGE_XML = "package.xml"


class Manifest(NamedTuple):
    """The tags of a `package.xml` that a build reads."""

    name: str
    run: tuple[str, ...]
    """The packages of `depend` and `exec_depend`, then those of `test_depend`, each once: ament's run dependencies."""
    declared: frozenset[str]
    """The packages of all tags that end in `depend`."""


def read_manifest(path: Path) -> Manifest:
    """Return what a `package.xml` declares.

    Raises:
        ValueError: it isn't XML, or has no name; the text has the file, and the line of a mistake.
        OSError: it can't be read.
    """
    from xml.etree import ElementTree as ET

    from tfloom.common.xml import read_tree

    try:
        root = read_tree(path.read_bytes())
    except ET.ParseError as error:
        line, column = error.position
        raise ValueError(f"{path}:{line}:{column + 1}: it isn't XML: {error}") from None
    tags = [(element.tag, (element.text or "").strip()) for element in root]
    names = [text for tag, text in tags if tag == "name" and text]
    if not names:
        raise ValueError(f"{path}: the package has no <name>")
    run = [text for run_tag in _RUN_TAGS for tag, text in tags if tag == run_tag]
    declared = frozenset(text for tag, text in tags if tag.endswith("depend"))
    return Manifest(names[0], tuple(dict.fromkeys(run)), declared)


class PackageDefinitions:
    """Definitions by name: those of the package are in its source folder, those of others in installed ones.

    Args:
        package: The package's name.
        files: The package's definitions, by `package/kind/Name`.
        prefixes: The prefixes of other packages, in order of precedence; AMENT_PREFIX_PATH and tfloom's own follow.
    """

    def __init__(self, package: str, files: Mapping[str, Path], prefixes: Sequence[Path]) -> None:
        self.package = package
        self.files = dict(files)
        shares = (*(prefix / "share" for prefix in prefixes), *definition_files.share_folders())
        self._shares = list(dict.fromkeys(shares))
        self._known: dict[str, spec.Interface] = {}

    def find_source(self, name: str) -> sources.Source | None:
        """Return the definition of `package/kind/Name`, or None.

        Raises:
            ParseError: its file is not UTF-8 text.
        """
        path = self.files.get(name) or self._installed(name)
        return None if path is None else sources.read_source(path)

    def _installed(self, name: str) -> Path | None:
        package, _, rest = name.partition("/")
        kind, _, base = rest.partition("/")
        if package == self.package or kind not in definition_files.KINDS or not base.isidentifier():
            return None
        paths = (definition_files.path_in(share / package, kind, base) for share in self._shares)
        return next(filter(None, paths), None)

    def find_interface(self, name: str) -> spec.Interface:
        """Return the spec of `package/kind/Name`, parsed once.

        Raises:
            LookupError: there is no such definition.
            ParseError: it can't be parsed.
            ValueError: it is not an interface name.
        """
        if name not in self._known:
            source = self.find_source(name)
            if source is None:
                raise LookupError(f"there is no definition of '{name}'")
            self._known[name] = sources.parse_source(source, name)
        return self._known[name]

    def find_message(self, name: str) -> spec.Message:
        """Return the spec of a message, or of a message that is part of a service or an action.

        Raises:
            LookupError, ParseError, ValueError: as `find_interface`.
        """
        return sources.message_of(self.find_interface(sources.definition_name(name)), name)

    def is_package(self, package: str) -> bool:
        """Return whether there is a definition of any kind in a package."""
        return any(name.startswith(f"{package}/") for name in self.files) or any(
            definition_files.names_in(share / package) for share in self._shares
        )

    def check(self, manifest: Manifest) -> Iterator[str]:
        """Yield a sentence, with file, line and column, for each definition that can't be built."""
        for name in self.files:
            if mistake := self._mistake(name, manifest):
                yield mistake

    def _mistake(self, name: str, manifest: Manifest) -> str | None:
        try:
            check_references(self.find_interface(name), self)
        except UnknownMessageError as error:
            return f"{error}{self._remedy(error.name, manifest)}"
        except ParseError as error:
            return str(error)
        except ValueError as error:  # of the name
            return f"{self.files[name]}: {error}"
        return None

    def _remedy(self, name: str, manifest: Manifest) -> str:
        """Return what to do about a message that is unknown, as a part of a sentence."""
        package = name.partition("/")[0]
        if package == self.package:
            return f"; add its file to rosidl_generate_interfaces{_nearest(name, self.files)}"
        if self.is_package(package):
            names = [
                definition_name
                for share in self._shares
                for definition_name in definition_files.names_in(share / package)
            ]
            return _nearest(name, names)
        if package in manifest.declared:
            return f"; {PACKAGE_XML} depends on it, so build or install it first, and source its setup file"
        return f"; {PACKAGE_XML} doesn't depend on it: add <depend>{package}</depend>"

    def undeclared(self, manifest: Manifest) -> list[str]:
        """Return the packages that the definitions use, and that `package.xml` doesn't depend on, sorted."""
        used = {
            reference.partition("/")[0]
            for name in self.files
            for message in _written_messages(self.find_interface(name))
            for reference in message.references
        }
        return sorted(used - manifest.declared - {self.package})


def _written_messages(interface: spec.Interface) -> tuple[spec.Message, ...]:
    """Return the messages that the definition itself writes."""
    if isinstance(interface, spec.Service):
        return (interface.request, interface.response)
    if isinstance(interface, spec.Action):
        return (interface.goal, interface.result, interface.feedback)
    return (interface,)


def _nearest(name: str, known: Iterator[str] | Mapping[str, Path] | Sequence[str]) -> str:
    near = difflib.get_close_matches(name, list(known), 1, 0.6)
    return f"; did you mean '{near[0]}'?" if near else ""

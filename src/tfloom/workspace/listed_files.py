"""The files that a package's `rosidl_generate_interfaces` lists."""

from __future__ import annotations

import difflib
from collections.abc import Iterator, Sequence
from pathlib import Path, PurePath, PurePosixPath
from typing import NamedTuple

from tfloom.rosidl.definition_files import IDL_SUFFIX, KINDS

_SUFFIXES = (*(f".{kind}" for kind in KINDS), IDL_SUFFIX)


class ListedFile(NamedTuple):
    """A definition: its file, and its place in an installed package."""

    path: Path
    place: str
    """`msg/Sphere.msg`"""

    def name(self, package: str) -> str:
        """Return `package/msg/Sphere`."""
        return f"{package}/{self.place.rpartition('.')[0]}"


class ListedFiles(NamedTuple):
    """The definitions that a package lists, and the mistakes in the list."""

    files: list[ListedFile]
    """In order of their places."""
    errors: list[str]
    """A sentence for each entry that can't be built."""


def find_listed(source: Path, entries: Sequence[str]) -> ListedFiles:
    """Return the definitions in a list.

    Args:
        source: The package's folder.
        entries: Paths relative to it, `msg/Sphere.msg`, or to their own folder, `/a/folder:msg/Sphere.msg`.
    """
    files: dict[str, ListedFile] = {}
    errors: list[str] = []
    for entry in entries:
        listed = _listed(source, entry)
        mistake = "; ".join(_mistakes(source, entry, listed))
        stem = listed.place.rpartition(".")[0]
        other = files.setdefault(stem, listed)
        if not mistake and other != listed:
            mistake = f"it defines the same interface as {other.path}"
        if mistake:
            errors.append(f"rosidl_generate_interfaces lists '{entry}': {mistake}")
    return ListedFiles(sorted(files.values(), key=lambda file: file.place), errors)


def _listed(source: Path, entry: str) -> ListedFile:
    folder, colon, relative = entry.rpartition(":")
    if not colon or (len(folder) == 1 and folder.isalpha()):  # the letter of a drive: C:/folder
        folder, relative = "", entry
    place = PurePosixPath(relative.replace("\\", "/"))
    kind = place.suffix.removeprefix(".")
    # The suffix decides, as in rosidl_adapter: slam_toolbox keeps its services in srvs/.
    parts = (kind, place.name) if kind in KINDS else place.parts[-2:]
    return ListedFile(source / folder / relative, "/".join(parts))


def _mistakes(source: Path, entry: str, listed: ListedFile) -> Iterator[str]:
    kind, _, file = listed.place.partition("/")
    if PurePath(entry).is_absolute() and ":" not in entry[2:]:
        yield "an absolute path is written 'folder:msg/Name.msg', because its last two parts are installed"
    elif listed.path.suffix not in _SUFFIXES:
        yield f"a definition ends in {', '.join(_SUFFIXES[:-1])} or {_SUFFIXES[-1]}"
    elif kind not in KINDS or not file:
        yield f"the folder of an {IDL_SUFFIX} file must be {', '.join(KINDS[:-1])} or {KINDS[-1]}"
    elif not listed.path.is_file():
        here = [
            path.relative_to(source).as_posix()
            for path in sorted(source.glob("*/*.*"))
            if path.suffix in _SUFFIXES
        ]
        near = difflib.get_close_matches(entry, here, 1, 0.6)
        yield f"there is no file {listed.path}" + (f"; did you mean '{near[0]}'?" if near else "")

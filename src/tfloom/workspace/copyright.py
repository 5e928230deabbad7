"""ament_copyright's check: a notice of copyright and a known licence at the head of each source file."""

from __future__ import annotations

import argparse
import os
import re
import sys
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import NamedTuple

from tfloom.common.terminal import report
from tfloom.workspace.licenses import LICENSES, find_license

EXTENSIONS = (".c", ".cc", ".cpp", ".cxx", ".h", ".hh", ".hpp", ".hxx", ".cmake", ".py")
REPOSITORY_FILES = ("CONTRIBUTING.md", "LICENSE")
"""Files that the top folder of a git or Mercurial repository must have."""
_YEARS = r"\d{4}(?:-\d{4})?(?:,\s*\d{4}(?:-\d{4})?)*"
_NOTICE = re.compile(
    rf"^.?\s*(?:\\copyright\s*)?copyright(?:\s+\(c\))?\s+({_YEARS}),?\s+(\S[^\n\r]*)$",
    re.MULTILINE | re.IGNORECASE,
)
_LINE_COMMENTS = re.compile(r"^(#|///|//)[^\n]*(?:\n\1[^\n]*)*", re.MULTILINE)
_BLOCK_COMMENT = re.compile(r"^/\*.*?\*/", re.MULTILINE | re.DOTALL)
_SIGNS = re.compile(r"^\s*(?:#|///|//|/\*+|\*(?!/))? ?", re.MULTILINE)


class Finding(NamedTuple):
    """What was found out about the copyright notice of one file."""

    path: str
    text: str
    is_error: bool


def main(argv: Sequence[str] | None = None) -> int:
    """Check files for copyright and licence, and print those that lack them; return 1 if there are any, else 0.

    Args:
        argv: The arguments of the command `ament_copyright`; None for those of this process.
    """
    parser = argparse.ArgumentParser(description="Check source files for copyright and licence.")
    parser.add_argument("paths", nargs="*", default=[os.curdir], help="files, or folders with source files")
    parser.add_argument("--exclude", metavar="filename", nargs="*", dest="excludes", default=[])
    parser.add_argument("--list-licenses", action="store_true", help="print the known licences")
    parser.add_argument("--verbose", action="store_true", help="print the files that have both, too")
    args = parser.parse_args(argv)
    if args.list_licenses:
        for licence in sorted(LICENSES):
            print(f"{licence.name}: {licence.spdx}")
        return 0
    paths = [path for path in _files(args.paths) if not {path, Path(path).name} & {*args.excludes}]
    if not paths:
        report("No repository roots and files found")
        return 0
    findings = [_check(path) for path in sorted(paths)]
    for finding in findings:
        if finding.is_error or args.verbose:
            print(f"{finding.path}: {finding.text}", file=sys.stderr if finding.is_error else sys.stdout)
    errors = sum(finding.is_error for finding in findings)
    if errors:
        report(f"{errors} errors, checked {len(findings)} files")
    else:
        print(f"No problems found, checked {len(findings)} files")
    return int(bool(errors))


def _files(paths: Sequence[str]) -> list[str]:
    files: dict[str, None] = {}
    for path in paths:
        if Path(path).is_dir():
            files |= dict.fromkeys(_files_in(path))
        elif Path(path).suffix in EXTENSIONS or Path(path).name in REPOSITORY_FILES:
            files[path] = None
    return list(files)


def _files_in(top: str) -> Iterator[str]:
    """Yield the source files below a folder, but for those in folders that begin with a dot or an underscore.

    The setup.py beside a package.xml needs no notice.
    """
    for folder, folders, names in os.walk(top):
        if any(Path(folder, name).exists() for name in (".git", ".hg")):
            yield from (str(Path(folder, name)) for name in REPOSITORY_FILES)
        if "AMENT_IGNORE" in names:
            folders.clear()
            continue
        folders[:] = sorted(name for name in folders if name[0] not in "._")
        for name in sorted(names):
            if Path(name).suffix in EXTENSIONS and not (name == "setup.py" and "package.xml" in names):
                yield str(Path(folder, name))


def _check(path: str) -> Finding:
    try:
        text = Path(path).read_text("utf-8-sig")
    except FileNotFoundError:
        return Finding(path, "file not found", True)
    except (OSError, UnicodeDecodeError) as error:
        return Finding(path, f"can't be read as UTF-8 text: {error}", True)
    is_source = Path(path).name not in REPOSITORY_FILES
    if not text.strip():
        return Finding(path, "file empty", not is_source)
    if not is_source:
        return Finding(path, "present", False)
    comments = [_SIGNS.sub("", comment) for comment in _comments(text)]
    notices = [match for comment in comments for match in _NOTICE.finditer(comment)]
    if not notices:
        return Finding(path, "could not find copyright notice", True)
    holders = ", ".join(f"{match[2].strip()} ({match[1]})" for match in notices)
    name = next(filter(None, map(find_license, comments)), None)
    return Finding(path, f"copyright={holders}, license={name or '<unknown>'}", name is None)


def _comments(text: str) -> list[str]:
    """Return the comments of a file that begin in a line's first column, a run of lines as one."""
    return [match[0] for pattern in (_LINE_COMMENTS, _BLOCK_COMMENT) for match in pattern.finditer(text)]

"""The checks that `colcon test` runs: flake8 and pydocstyle, with ROS's settings, mypy, and that of XML."""

from __future__ import annotations

import argparse
import os
import re
import subprocess
import sys
from collections import Counter
from collections.abc import Sequence
from importlib.util import find_spec
from pathlib import Path
from unittest import SkipTest
from xml.etree import ElementTree as ET

from tfloom.common.terminal import report
from tfloom.common.xml import read_tree

FLAKE8_SETTINGS = (
    "--extend-ignore=B902,C816,D100,D101,D102,D103,D104,D105,D106,D107,D203,D212,D404,I202",
    "--max-line-length=99",
    "--show-source",
)
"""ROS's options of flake8; those on quotes, docstrings, imports apply where flake8 has the plugins for them."""
IMPORT_ORDER = "--import-order-style=google"
"""The option of the plugin flake8-import-order."""
PEP257_IGNORED = ("D100", "D101", "D102", "D103", "D104", "D105", "D106", "D107", "D203", "D212", "D404")
"""The rules of pydocstyle that ROS leaves out."""
MYPY_SETTINGS = ("--config-file=", "--ignore-missing-imports")
"""The options of mypy without a configuration of the package's own: those of its folder don't count."""
_FLAKE8_LINE = re.compile(r"^(.+?):(\d+):(\d+): ([A-Z]+\d+) (.*)$")
_PEP257_LINE = re.compile(r"^(.+?):(\d+) (.*):$")
_PEP257_UNREADABLE = re.compile(r"^WARNING: Error in file (.+)$", re.MULTILINE)
"""What pydocstyle prints on stderr about a file that it can't read or parse: its path and the reason."""
_IGNORE_MARKER = "AMENT_IGNORE"


def flake8_main(argv: Sequence[str] | None = None) -> int:
    """Check files with flake8 and print what it finds; return 1 if that is something, else 0.

    Args:
        argv: The arguments of the command `ament_flake8`; None for those of this process.

    Raises:
        unittest.SkipTest: flake8 is not installed, and a test has called.
    """
    return flake8_main_with_errors(argv)[0]


def flake8_main_with_errors(argv: Sequence[str] | None = None) -> tuple[int, list[str]]:
    """As `flake8_main`; return the errors too, each as `path:line:column: code text`.

    Raises:
        unittest.SkipTest: flake8 is not installed, and a test has called.
    """
    parser = argparse.ArgumentParser(description="Check Python files with flake8 and ROS's settings.")
    parser.add_argument("--config", metavar="path", dest="config_file", help="settings in place of ROS's")
    parser.add_argument("--linelength", metavar="N", type=int, help="the longest line (default: 99)")
    add_paths(parser, ".py files")
    args = parser.parse_args(argv)
    if not _is_installed("flake8"):
        return 1, ["flake8 is not installed"]
    options = list(FLAKE8_SETTINGS)
    if find_spec("flake8_import_order") is not None:
        options.append(IMPORT_ORDER)
    if args.config_file:
        if not Path(args.config_file).is_file():
            report(f"Could not find config file '{args.config_file}'")
            return 1, []
        options = [f"--config={args.config_file}"]
    else:
        options.insert(0, "--isolated")  # as ROS's: the settings of the folder don't count
    if args.linelength is not None:
        options.append(f"--max-line-length={args.linelength}")
    files = files_of(args.paths, args.excludes, (".py",))
    text = _run("flake8", [*options, *files])[0] if files else ""
    print(text, end="")
    matches = [match for match in map(_FLAKE8_LINE.match, text.splitlines()) if match]
    errors = [match[0] for match in matches]
    _print_summary(files, errors)
    for kind, count in sorted(Counter(match[4][0] for match in matches).items()):
        print(f"'{kind}'-type errors: {count}")
    return int(bool(errors)), errors


def pep257_main(argv: Sequence[str] | None = None) -> int:
    """Check docstrings with pydocstyle and print what it finds; return 1 if that is something, else 0.

    Args:
        argv: The arguments of the command `ament_pep257`; None for those of this process.

    Raises:
        unittest.SkipTest: pydocstyle is not installed, and a test has called.
    """
    parser = argparse.ArgumentParser(description="Check docstrings with pydocstyle and ROS's rules.")
    rules = parser.add_mutually_exclusive_group()
    rules.add_argument("--ignore", nargs="+", help="rules to leave out, in place of ROS's")
    rules.add_argument("--select", nargs="+", help="rules to check")
    rules.add_argument("--convention", choices=("ament", "google", "numpy", "pep257"), default="ament")
    parser.add_argument("--add-ignore", nargs="+", default=[], help="more rules to leave out")
    parser.add_argument("--add-select", nargs="+", default=[], help="more rules to check")
    add_paths(parser, ".py files")
    args = parser.parse_args(argv)
    if not _is_installed("pydocstyle"):
        return 1
    files = files_of(args.paths, args.excludes, (".py",))
    text, warnings = _run("pydocstyle", [*_pep257_options(args), *files]) if files else ("", "")
    errors = [*_PEP257_UNREADABLE.findall(warnings), *_pep257_errors(text)]
    for error in errors:
        report(error)
    _print_summary(files, errors)
    return int(bool(errors))


def mypy_main(argv: Sequence[str] | None = None) -> int:
    """Check types with mypy and print what it finds; return 1 if that is something, else 0.

    Args:
        argv: The arguments of the command `ament_mypy`; None for those of this process.

    Raises:
        unittest.SkipTest: mypy is not installed, and a test has called.
    """
    parser = argparse.ArgumentParser(description="Check the types of Python files with mypy.")
    parser.add_argument("--config", metavar="path", dest="config_file", help="settings of mypy's")
    parser.add_argument(
        "--cache-dir", metavar="cache", help="where mypy keeps what it has found (default: nowhere)"
    )
    add_paths(parser, ".py and .pyi files")
    args = parser.parse_args(argv)
    if not _is_installed("mypy"):
        return 1
    options = list(MYPY_SETTINGS)
    if args.config_file:
        if not Path(args.config_file).is_file():
            report(f"Could not find config file '{args.config_file}'")
            return 1
        options = [f"--config-file={args.config_file}"]
    options.append(f"--cache-dir={args.cache_dir or os.devnull}")
    files = files_of(args.paths, args.excludes, (".py", ".pyi"))
    if not files:
        report("No files found")
        return 1
    command = [sys.executable, "-m", "mypy", *options, "--no-error-summary", "--", *files]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    print(result.stdout, end="")
    print(result.stderr, end="", file=sys.stderr)
    errors = [line for line in result.stdout.splitlines() if ": error:" in line]
    if result.returncode and not errors:  # what stops mypy itself, as settings that it can't read
        return 1
    _print_summary(files, errors)
    return int(bool(result.returncode))


def _pep257_options(args: argparse.Namespace) -> list[str]:
    if args.select:
        options = [f"--select={','.join([*args.select, *args.add_select])}"]
    elif args.ignore or args.convention == "ament":
        ignored = {*(args.ignore or PEP257_IGNORED), *args.add_ignore} - {*args.add_select}
        return [f"--ignore={','.join(sorted(ignored))}", "--match=.*", "--match-dir=.*"]
    else:
        options = [f"--convention={args.convention}"]
        options += [f"--add-select={','.join(args.add_select)}"] if args.add_select else []
    options += [f"--add-ignore={','.join(args.add_ignore)}"] if args.add_ignore else []
    return [*options, "--match=.*", "--match-dir=.*"]


def _pep257_errors(text: str) -> list[str]:
    """Return the errors, of which each has two lines: the place, then code and text."""
    errors = []
    place = ""
    for line in text.splitlines():
        if match := _PEP257_LINE.match(line):
            place = f"{match[1]}:{match[2]} {match[3]}"
        elif line.strip():
            errors.append(f"{place}: {line.strip()}" if place else line)
    return errors


def _is_installed(library: str) -> bool:
    """Return whether a library is installed; if it isn't, skip the test that runs, or print how to install it."""
    if find_spec(library) is not None:
        return True
    reason = f"{library} is not installed: pip install {library}"
    if "PYTEST_CURRENT_TEST" in os.environ:
        raise SkipTest(reason)
    report(reason)
    return False


def _run(module: str, words: Sequence[str]) -> tuple[str, str]:
    """Run a module as a program, and return what it prints on stdout and on stderr.

    Raises:
        RuntimeError: it can't run; the text has its own reason.
    """
    command = [sys.executable, "-W", "ignore", "-m", module, *words]
    result = subprocess.run(command, capture_output=True, text=True, check=False)
    has_answer = result.stdout or _PEP257_UNREADABLE.search(result.stderr)
    if result.returncode > 1 or (result.returncode and not has_answer):
        raise RuntimeError(f"{module} can't run: {result.stderr.strip() or result.stdout.strip()}")
    return result.stdout, result.stderr


def _print_summary(files: Sequence[str], errors: Sequence[str]) -> None:
    print(f"\n{len(files)} files checked")
    print(f"{len(errors)} errors" if errors else "No problems found")


def add_paths(parser: argparse.ArgumentParser, what: str) -> None:
    """Add the arguments that name files and folders.

    Args:
        parser: The parser of a check.
        what: Which files of a folder are checked.
    """
    parser.add_argument("paths", nargs="*", default=[os.curdir], help=f"files, or folders with {what}")
    parser.add_argument("--exclude", metavar="filename", nargs="*", dest="excludes", default=[])


def files_of(paths: Sequence[str], excludes: Sequence[str], endings: tuple[str, ...]) -> list[str]:
    """Return the files named, and those in the folders named whose names have one of the endings, sorted.

    Left out are folders whose names begin with a dot or an underscore, those with a file AMENT_IGNORE, and the files
    to exclude, given by path or by name.
    """
    excluded = {*excludes, *map(os.path.abspath, excludes)}
    files = []
    for path in paths:
        if not Path(path).is_dir():
            files.append(path)
            continue
        for folder, folders, names in os.walk(path):
            if _IGNORE_MARKER in names:
                folders.clear()
                continue
            folders[:] = sorted(name for name in folders if name[0] not in "._")
            files += [str(Path(folder, name)) for name in names if name.endswith(endings)]
    return sorted(
        path for path in files if not {path, str(Path(path).absolute()), Path(path).name} & excluded
    )


def xmllint_main(argv: Sequence[str] | None = None) -> int:
    """Check XML files and print what is wrong with them; return 1 if that is something, else 0.

    No schema is loaded, because the one that a package.xml names is on the web.

    Args:
        argv: The arguments of the command `ament_xmllint`; None for those of this process.
    """
    parser = argparse.ArgumentParser(description="Check whether XML files are well-formed.")
    parser.add_argument("--extensions", nargs="*", default=["xml"], help="those of the files to check")
    add_paths(parser, "files with these extensions")
    args = parser.parse_args(argv)
    endings = tuple(f".{extension}" for extension in args.extensions)
    invalid = 0
    for path in files_of(args.paths, args.excludes, endings):
        fault = _find_fault(path)
        if fault is None:
            print(f"File '{path}' is valid")
            continue
        invalid += 1
        report(f"File '{path}' is invalid\n{path}:{fault}")
    if invalid:
        report(f"{invalid} files are invalid")
        return 1
    print("No problems found")
    return 0


def _find_fault(path: str) -> str | None:
    """Return the position of a mistake, and what is wrong there; None if nothing is."""
    try:
        read_tree(Path(path).read_bytes())
    except ET.ParseError as error:
        line, column = error.position
        return f"{line}:{column + 1}: {str(error).partition(':')[0]}"
    except OSError as error:
        return f" {error.strerror}"
    return None

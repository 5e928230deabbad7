"""The command `launch_test`: runs the tests of a launch test file, without pytest."""

from __future__ import annotations

import argparse
import importlib.util
import logging
import sys
from collections.abc import Sequence
from io import BytesIO
from pathlib import Path
from types import ModuleType

from tfloom.common.files import write_file
from tfloom.common.terminal import report
from tfloom.launch.testing.arguments import print_arguments_of_launch_description
from tfloom.launch.testing.junitxml import unittestResultsToXml
from tfloom.launch.testing.loader import DescriptionError, LoadTestsFromPythonModule
from tfloom.launch.testing.test_result import FailResult
from tfloom.launch.testing.test_runner import LaunchTestRunner

__all__ = ["add_arguments", "main", "parse_arguments", "run"]


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the command's arguments to a parser."""
    parser.add_argument("launch_test_file", help="file with generate_test_description and tests")
    parser.add_argument("-v", "--verbose", action="store_true", help="print the log of the launch itself")
    parser.add_argument(
        "-s",
        "--show-args",
        "--show-arguments",
        action="store_true",
        help="print the launch arguments, and exit",
    )
    parser.add_argument("--junit-xml", dest="xmlpath", metavar="PATH", help="write the results to this file")
    parser.add_argument("--package-name", help="name of the package, for the results")
    parser.add_argument("launch_arguments", nargs="*", metavar="NAME:=VALUE", help="launch arguments")


def parse_arguments(argv: Sequence[str] | None = None) -> tuple[argparse.ArgumentParser, argparse.Namespace]:
    """Return the command's parser, and the arguments that it has read."""
    parser = argparse.ArgumentParser(prog="launch_test", description="Run the tests of a launch test file.")
    add_arguments(parser)
    return parser, parser.parse_intermixed_args(argv)  # options may stand among the launch arguments


def run(
    parser: argparse.ArgumentParser,
    args: argparse.Namespace,
    test_runner_cls: type[LaunchTestRunner] = LaunchTestRunner,
) -> int:
    """Run the tests that the arguments name.

    Args:
        parser: Reports what is wrong with the arguments, and exits.
        args: The arguments.
        test_runner_cls: What runs the launches.

    Returns:
        0, or 1 if a test failed.
    """
    path = Path(args.launch_test_file).absolute()
    if not path.is_file():
        parser.error(f"launch test file '{path}' does not exist")
    if args.verbose:
        logging.getLogger("launch").setLevel(logging.DEBUG)
    try:
        name = path.name.split(".")[0]
        full_name = f"{args.package_name or name}.{path.stem}"
        runs = LoadTestsFromPythonModule(import_file(path), name=f"{full_name}.launch_tests")
        for launch in runs:
            launch.module_name = args.package_name
        if args.show_args:
            print_arguments_of_launch_description(launch_description=runs[0].get_launch_description())
            return 0
        runner = test_runner_cls(runs, args.launch_arguments, args.verbose)
        runner.validate()
        results = runner.run()
    except DescriptionError as error:
        parser.error(f"launch test file '{path}': {error}")
    except RuntimeError as error:
        parser.error(str(error))
    if args.xmlpath:
        document = BytesIO()
        document_of = unittestResultsToXml(
            name=full_name,
            test_results={str(run): result for run, result in results.items()},
        )
        document_of.write(document, encoding="utf-8", xml_declaration=True)
        write_file(Path(args.xmlpath), document.getvalue())
    for result in results.values():
        if isinstance(result, FailResult):
            report(f"launch_test: {result.message}")
    return 0 if all(result.wasSuccessful() for result in results.values()) else 1


def main(argv: Sequence[str] | None = None) -> int:
    """Run the command, and return its exit code."""
    parser, args = parse_arguments(argv)
    try:
        return run(parser, args)
    except KeyboardInterrupt:
        return 130


def import_file(path: Path) -> ModuleType:
    """Return the module of a file, whose name may have dots.

    Raises:
        DescriptionError: it is not a file of Python.
    """
    spec = importlib.util.spec_from_file_location(path.name.replace(".", "_").removesuffix("_py"), path)
    if spec is None or spec.loader is None:
        raise DescriptionError("it is not a file of Python")
    module = importlib.util.module_from_spec(spec)
    sys.modules[spec.name] = module
    spec.loader.exec_module(module)
    return module


if __name__ == "__main__":
    sys.exit(main())

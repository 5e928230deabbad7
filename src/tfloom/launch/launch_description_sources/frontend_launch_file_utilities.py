"""The loading of launch files in other languages than Python."""

from __future__ import annotations

from tfloom.launch.frontend.parser import InvalidFrontendLaunchFileError, Parser
from tfloom.launch.launch_description import LaunchDescription
from tfloom.launch.launch_description_sources.missing_files import check_file
from tfloom.launch.utilities.error_places import describe_error

__all__ = ["get_launch_description_from_frontend_launch_file"]


def get_launch_description_from_frontend_launch_file(
    frontend_launch_file_path: str, *, parser: type[Parser] = Parser
) -> LaunchDescription:
    """Return the launch description in a file.

    Args:
        frontend_launch_file_path: Path of the file.
        parser: The parser that loads it.

    Raises:
        OSError: the file cannot be read.
        InvalidFrontendLaunchFileError: it has an error. The text has the file, the line, and what is wrong.
    """
    check_file(frontend_launch_file_path)
    try:
        root, its_parser = parser.load(frontend_launch_file_path)
        return its_parser.parse_description(root)
    except (InvalidFrontendLaunchFileError, OSError):
        raise
    except Exception as error:
        message = describe_error(error, frontend_launch_file_path)
        raise InvalidFrontendLaunchFileError.with_message(message, error) from error

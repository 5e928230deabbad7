"""Expected output."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.output import basic_output_filter as basic_output_filter
from tfloom.launch.testing.output import expect_output as expect_output
from tfloom.launch.testing.output import expected_output_from_file as expected_output_from_file
from tfloom.launch.testing.output import get_default_filtered_patterns as get_default_filtered_patterns
from tfloom.launch.testing.output import get_default_filtered_prefixes as get_default_filtered_prefixes
from tfloom.launch.testing.text import remove_ansi_escape_sequences as remove_ansi_escape_sequences

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.launch.testing.text import build_line_match as build_line_match
    from tfloom.launch.testing.text import build_text_match as build_text_match
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        build_line_match="tfloom.launch.testing.text",
        build_text_match="tfloom.launch.testing.text",
    )

"""Matches of texts."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.testing.text import build_line_match as build_line_match
from tfloom.launch.testing.text import build_text_match as build_text_match
from tfloom.launch.testing.text import normalize_lineseps as normalize_lineseps

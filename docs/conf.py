"""Sphinx's settings of the documentation: `make docs` builds it in build/docs."""

from __future__ import annotations

from tfloom import __version__

project = "tfloom"
author = "The tfloom developers"
copyright = "the tfloom developers, Apache-2.0"  # noqa: A001 Sphinx's name
version = release = __version__

extensions = ["myst_parser", "sphinx.ext.autodoc", "sphinx.ext.napoleon", "sphinx.ext.viewcode"]
exclude_patterns = ["rclpy_api_missing.txt"]
html_theme = "furo"
html_title = f"tfloom {__version__}"
html_show_sphinx = False
templates_path: list[str] = []

myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 4
suppress_warnings = ["myst.header", "ref.python"]  # the latter: several rooms have a `Buffer`

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
python_maximum_signature_line_length = 88
napoleon_google_docstring = True
napoleon_numpy_docstring = False
default_role = "py:obj"  # names in single backticks become links where they can

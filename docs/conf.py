"""Sphinx's settings of the documentation: `make docs` builds it in build/docs."""

from __future__ import annotations

import re
import sys
from pathlib import Path
from typing import TYPE_CHECKING

sys.path.insert(0, str(Path(__file__).parents[1]))  # for docs and tools, wherever the build is started

from docs import native_stub

native_stub.use_if_not_compiled()

from docs import rclpy_api  # noqa: E402

from tfloom import __version__  # noqa: E402

if TYPE_CHECKING:
    from docutils.nodes import Element
    from sphinx.addnodes import pending_xref
    from sphinx.application import Sphinx
    from sphinx.environment import BuildEnvironment

project = "tfloom"
author = "The tfloom developers"
copyright = "the tfloom developers, Apache-2.0"  # noqa: A001 Sphinx's name
version = release = __version__

extensions = [
    "myst_parser",
    "sphinx.ext.autodoc",
    "sphinx.ext.napoleon",
    "sphinx.ext.viewcode",
    "sphinx_copybutton",
]
html_theme = "furo"
html_title = f"tfloom {__version__}"
html_show_sphinx = False
html_static_path = ["_static"]
html_css_files = ["site.css"]
html_js_files = ["differences.js"]
templates_path: list[str] = []

copybutton_prompt_text = "$ "  # of a console, only its commands are copied
copybutton_exclude = ".linenos"

myst_enable_extensions = ["colon_fence"]
myst_heading_anchors = 4
nitpicky = True
nitpick_ignore_regex = [("py:.*", r"(?!tfloom\.(?:tf2|tf2_ros|bag|robot)\b).*")]
suppress_warnings = ["myst.header", "ref.python"]  # the latter: several rooms have a `Buffer`

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_typehints_format = "short"
autodoc_type_aliases = {"ArrayLike": "ArrayLike"}  # the name, not the types that it stands for
python_maximum_signature_line_length = 88
napoleon_google_docstring = True
napoleon_numpy_docstring = False
default_role = "py:obj"  # names in single backticks become links where they can


def short_signature(
    _app: Sphinx, _what: str, _name: str, _obj: object, _options: object, signature: str, returned: str
) -> tuple[str, str] | None:
    """Return a signature with arrays as in the source, and that of a native method as Python's: without `self`."""
    if not isinstance(signature, str):
        return None
    is_native = signature.startswith("(self")
    texts = []
    for text in (re.sub(r"^\(self(?:, )?", "(", signature), returned or ""):
        short = re.sub(r"\b(?:[a-z_]+\.)+(?=[A-Za-z])", "", text) if is_native else text
        short = re.sub(r"TypeAliasForwardRef\('(\w+)'\)", r"\1", short)
        short = re.sub(
            r"~?[\w.]*\bndarray\[tuple\[[^]]*\], ~?[\w.]*dtype\[([^][]+)\]\]", r"NDArray[\1]", short
        )
        texts.append(re.sub(r"\bnp\.", "", short))
    return texts[0], texts[1]


def find_by_end(
    app: Sphinx, environment: BuildEnvironment, node: pending_xref, content: Element
) -> Element | None:
    """Return a link for a class, method or function that is named without its module, as in `Bag.stamps`.

    Of several with this name, that of the page with the reference is chosen. Names of arguments are not links.
    """
    if node.get("refdomain") != "py":
        return None
    target = node["reftarget"]
    found = {
        name: entry
        for name, entry in environment.domains["py"].objects.items()
        if name.endswith(f".{target}") and not entry.aliased
        if "." in target or entry.objtype in {"class", "exception", "function"}
    }
    here = {name: entry for name, entry in found.items() if entry.docname == node["refdoc"]}
    if len(chosen := here if len(found) > 1 else found) != 1:
        return None
    [(name, entry)] = chosen.items()
    from sphinx.util.nodes import make_refnode

    return make_refnode(app.builder, node["refdoc"], entry.docname, entry.node_id, content, name)


def write_rclpy_api(app: Sphinx) -> None:
    """Write the page of the recorded names, which is not kept, unless it is there with this text."""
    path = Path(app.srcdir, "rclpy_api.md")
    text = rclpy_api.page()
    if not path.is_file() or path.read_text("utf-8") != text:  # otherwise Sphinx reads it again
        path.write_text(text, "utf-8")


def setup(app: Sphinx) -> None:
    """Connect the functions above."""
    app.connect("builder-inited", write_rclpy_api)
    app.connect("autodoc-process-signature", short_signature)
    app.connect("missing-reference", find_by_end)

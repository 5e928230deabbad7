"""TF2, turtlesim and the ROS 2 workflow around them, with no ROS installed.

`import tfloom` loads almost nothing. The rooms are `tfloom.tf2` (frames over time), `tfloom.rosidl` and
`tfloom.interfaces` (messages), `tfloom.node` (rclpy's classes), `tfloom.tf2_ros`, `tfloom.turtlesim`, `tfloom.robot`
and the commands. Programs import ROS's own names (`rclpy`, `tf2_ros`, `geometry_msgs`): a `tfloom.pth` in
site-packages puts them last on `sys.path`, so that a real ROS always takes precedence.

tfloom has a plug-in of pytest, whose assertions are not rewritten: PYTEST_DONT_REWRITE.
"""

from __future__ import annotations

import os
import sys

TYPE_CHECKING = False  # importing typing for it would cost more than this module
if TYPE_CHECKING:
    from collections.abc import Sequence

    from tfloom.viewer.inline_page import InlinePage

__version__ = "0.1.0"
__all__ = ["__version__", "use_ros_names", "view"]

_ROS_NAMES = os.path.join(os.path.dirname(__file__), "ros_names")


def use_ros_names() -> None:
    """Put `rclpy`, `tf2_ros`, `geometry_msgs` and the other ROS names last on `sys.path`.

    Packages on AMENT_PREFIX_PATH that hold definitions can be imported, too, if nothing else has their names.

    Needed only where Python did not read `tfloom.pth` from site-packages: under `-S`, after `pip install
    --target`, or in a notebook whose kernel has been running since before the install. Calling it again does
    nothing.
    """
    from tfloom.ros_imports import absent, finder
    from tfloom.ros_imports.distributions import installed_prefixes

    folders = [_ROS_NAMES, *(str(prefix / "ros_names") for prefix in installed_prefixes())]
    sys.path += [folder for folder in folders if folder not in sys.path]
    finder.install()
    absent.install()


def view(
    bag: str | os.PathLike[str] | None = None,
    *,
    fixed_frame: str = "",
    displays: Sequence[str] = (),
    history_s: float = 60.0,
    port: int = 0,
    height_px: int = 600,
) -> InlinePage:
    """Show the page of `tfloom view` in a cell of a notebook: the live graph, or a recording.

    The page is served on 127.0.0.1, by a thread of this process, until the result's `close` or the end of the process.
    A call with the same arguments gives the page that is there. Outside a notebook, open the result's `address`.

    Args:
        bag: A recording; None: the live graph of ROS_DOMAIN_ID.
        fixed_frame: The fixed frame; empty: a usual one, or the root of the largest tree.
        displays: Topics to show from the start.
        history_s: How far the time can be turned back [s].
        port: The port; 0: a free one.
        height_px: Height in the notebook.

    Raises:
        ImportError: the extra `view` is not installed.
        ValueError: an argument is out of its range.
        BagError, OSError: the recording can't be read.
        ServerError: the port can't be used.
        RuntimeError: the system has no thread left.
        ConfigurationError, NoBackendError: there is no wire to the graph.
    """
    from importlib import import_module

    # By its name, because all modules import this one, which may import none of them.
    inline = import_module("tfloom.viewer.inline")
    page: InlinePage = inline.open_page(
        bag, fixed_frame=fixed_frame, displays=displays, history_s=history_s, port=port, height_px=height_px
    )
    return page

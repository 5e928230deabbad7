"""Which display shows messages of which type."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib import import_module
from types import MappingProxyType
from typing import TYPE_CHECKING, NamedTuple

from tfloom.viewer.displays.display import Display, Latest

if TYPE_CHECKING:
    from tfloom.viewer.displays.settings import Value

__all__ = ["KEPT_TYPES", "KINDS", "NO_SETTINGS", "Kind", "kind_of", "make_display"]

NO_SETTINGS: Mapping[str, Value] = MappingProxyType({})
"""Of a display that has none, or of which a layout sets none."""


class Kind(NamedTuple):
    """A kind of display."""

    label: str
    """The name of RViz's class, by which its files are read, too."""
    module: str
    """The file of this folder, imported when it is used."""
    name: str
    """A function from a message to shapes, or a class of displays."""
    settings: Mapping[str, Value] = NO_SETTINGS
    """Its settings, with the values that count where a layout sets none."""


KEPT_TYPES = frozenset(("visualization_msgs/msg/Marker", "visualization_msgs/msg/MarkerArray"))
"""Types whose displays keep what earlier messages made."""

WRENCH_SETTINGS: Mapping[str, Value] = {
    "force_color": (204, 51, 51),
    "torque_color": (204, 204, 51),
    "opacity": 1.0,
    "force_scale": 2.0,
    "torque_scale": 2.0,
    "width": 0.5,
    "history": 1,
}
"""As in RViz. The scales are the lengths of arrows of 1 N and 1 N m; one shorter than the width is hidden."""

KINDS = {
    "sensor_msgs/msg/PointCloud2": Kind("PointCloud2", "point_cloud", "PointCloudDisplay"),
    "sensor_msgs/msg/PointCloud": Kind("PointCloud", "point_cloud", "shapes_of_old_cloud"),
    "sensor_msgs/msg/LaserScan": Kind("LaserScan", "ranges", "shapes_of_scan"),
    "sensor_msgs/msg/Range": Kind("Range", "ranges", "shapes_of_range"),
    "sensor_msgs/msg/CameraInfo": Kind("Camera", "camera_info", "CameraDisplay"),
    "sensor_msgs/msg/Image": Kind("Image", "", ""),
    "sensor_msgs/msg/CompressedImage": Kind("Image", "", ""),
    "visualization_msgs/msg/Marker": Kind("Marker", "markers", "MarkerDisplay"),
    "visualization_msgs/msg/MarkerArray": Kind("MarkerArray", "markers", "MarkerDisplay"),
    "nav_msgs/msg/Path": Kind("Path", "poses", "shapes_of_path"),
    "nav_msgs/msg/Odometry": Kind("Odometry", "poses", "shapes_of_odometry"),
    "nav_msgs/msg/OccupancyGrid": Kind("Map", "occupancy_grid", "shapes_of_grid"),
    "geometry_msgs/msg/PoseStamped": Kind("Pose", "poses", "shapes_of_pose"),
    "geometry_msgs/msg/PoseWithCovarianceStamped": Kind(
        "PoseWithCovariance", "poses", "shapes_of_pose_with_covariance"
    ),
    "geometry_msgs/msg/PoseArray": Kind("PoseArray", "poses", "shapes_of_pose_array"),
    "geometry_msgs/msg/PointStamped": Kind("PointStamped", "poses", "shapes_of_point"),
    "geometry_msgs/msg/PolygonStamped": Kind("Polygon", "poses", "shapes_of_polygon"),
    "geometry_msgs/msg/WrenchStamped": Kind("Wrench", "wrench", "WrenchDisplay", WRENCH_SETTINGS),
    "turtlesim/msg/Pose": Kind("Turtle", "turtles", "TurtleDisplay"),
    "turtlesim_msgs/msg/Pose": Kind("Turtle", "turtles", "TurtleDisplay"),
}
"""By the type of the messages."""

ROBOT = Kind("RobotModel", "robot_model", "RobotDisplay")
ROBOT_TYPE = "std_msgs/msg/String"
ROBOT_TOPIC = "robot_description"
"""A topic of this type is a robot's description where its name ends so."""


def kind_of(topic: str, type_name: str) -> Kind | None:
    """Return the display of a topic; None if there is none for its type."""
    if type_name == ROBOT_TYPE:
        return ROBOT if topic.endswith(ROBOT_TOPIC) else None
    return KINDS.get(type_name)


def make_display(kind: Kind, topic: str, settings: Mapping[str, Value] = NO_SETTINGS) -> Display | None:
    """Return a new display; None for one that is shown beside the scene.

    Args:
        kind: Its kind.
        topic: The topic that it shows.
        settings: Values for some of the kind's settings.
    """
    if not kind.module:
        return None
    made = getattr(import_module(f"tfloom.viewer.displays.{kind.module}"), kind.name)
    if not isinstance(made, type):
        return Latest(made)
    make: Callable[..., Display] = made
    if kind.settings:
        return make({**kind.settings, **settings})
    return make(topic) if kind.module == "turtles" else make()

"""Which display shows messages of which type."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from importlib import import_module
from types import MappingProxyType
from typing import TYPE_CHECKING, Any, NamedTuple

from tfloom.viewer.displays.display import Display, Latest
from tfloom.viewer.displays.settings import (
    AXES_SETTINGS,
    CELLS_SETTINGS,
    CLOUD_SETTINGS,
    EFFORT_SETTINGS,
    FRAME_SETTINGS,
    GRID_SETTINGS,
    INTERACTIVE_SETTINGS,
    MAP_SETTINGS,
    MARKER_SETTINGS,
    ODOMETRY_SETTINGS,
    PATH_SETTINGS,
    POINT_SETTINGS,
    POLYGON_SETTINGS,
    POSE_ARRAY_SETTINGS,
    POSE_SETTINGS,
    POSE_WITH_COVARIANCE_SETTINGS,
    RANGE_SETTINGS,
    ROBOT_SETTINGS,
    SCAN_SETTINGS,
    TWIST_SETTINGS,
    WRENCH_SETTINGS,
    queue_setting,
    usual_values,
)

if TYPE_CHECKING:
    from tfloom.viewer.displays.settings import Setting, Values

__all__ = [
    "INTERACTIVE",
    "KEPT_TYPES",
    "KINDS",
    "LABELS",
    "PAIRED",
    "ROBOT",
    "UPDATE_SUFFIX",
    "Kind",
    "described_settings",
    "kind_of",
    "kinds_of",
    "make_display",
]

NO_SETTINGS: Mapping[str, Setting] = MappingProxyType({})
INTERACTIVE = "InteractiveMarkers"


class Kind(NamedTuple):
    """A kind of display."""

    label: str
    """The name of RViz's class, by which its files are read, too."""
    module: str
    """The file of this folder, imported when it is used."""
    name: str
    """A function from a message to shapes, or a class of displays."""
    settings: Mapping[str, Setting] = NO_SETTINGS
    """Its settings, by their names in layouts."""
    has_topic: bool = True
    """Whether it shows a topic; if not, the frames alone."""


INTERACTIVE_TYPE = "visualization_msgs/msg/InteractiveMarkerUpdate"
KEPT_TYPES = frozenset(
    ("visualization_msgs/msg/Marker", "visualization_msgs/msg/MarkerArray", INTERACTIVE_TYPE)
)
"""Types whose displays keep what earlier messages made."""
QUEUES = {"RobotModel": "Description Topic/Depth", "DepthCloud": "Queue Size"}
"""The property of RViz with the depth of a display's topic, where that is not Topic/Depth."""
UNQUEUED = frozenset((INTERACTIVE, "Camera", "Turtle"))
"""Displays of topics without such a property."""
UPDATE_SUFFIX = "/update"
"""Follows the namespace of interactive markers in the topic of their updates."""


def _queued(kind: Kind) -> Kind:
    """Return a kind whose settings have the depth of its topic, if RViz has it, too."""
    if kind.label in UNQUEUED:
        return kind
    depth = queue_setting(QUEUES.get(kind.label, "Topic/Depth"))
    return kind._replace(settings={**kind.settings, "depth": depth})


_OF_TYPES = {
    "sensor_msgs/msg/PointCloud2": Kind("PointCloud2", "point_cloud", "PointCloudDisplay", CLOUD_SETTINGS),
    "sensor_msgs/msg/PointCloud": Kind("PointCloud", "point_cloud", "OldCloudDisplay", CLOUD_SETTINGS),
    "sensor_msgs/msg/LaserScan": Kind("LaserScan", "ranges", "LaserScanDisplay", SCAN_SETTINGS),
    "sensor_msgs/msg/Range": Kind("Range", "ranges", "shapes_of_range", RANGE_SETTINGS),
    "sensor_msgs/msg/CameraInfo": Kind("Camera", "camera_info", "CameraDisplay"),
    "sensor_msgs/msg/Image": Kind("Image", "", ""),
    "sensor_msgs/msg/CompressedImage": Kind("Image", "", ""),
    "visualization_msgs/msg/Marker": Kind("Marker", "markers", "MarkerDisplay", MARKER_SETTINGS),
    "visualization_msgs/msg/MarkerArray": Kind("MarkerArray", "markers", "MarkerDisplay", MARKER_SETTINGS),
    INTERACTIVE_TYPE: Kind(
        INTERACTIVE, "interactive_markers", "InteractiveMarkersDisplay", INTERACTIVE_SETTINGS
    ),
    "nav_msgs/msg/Path": Kind("Path", "poses", "shapes_of_path", PATH_SETTINGS),
    "nav_msgs/msg/Odometry": Kind("Odometry", "poses", "shapes_of_odometry", ODOMETRY_SETTINGS),
    "nav_msgs/msg/OccupancyGrid": Kind("Map", "occupancy_grid", "shapes_of_grid", MAP_SETTINGS),
    "nav_msgs/msg/GridCells": Kind("GridCells", "occupancy_grid", "shapes_of_cells", CELLS_SETTINGS),
    "geometry_msgs/msg/PoseStamped": Kind("Pose", "poses", "shapes_of_pose", POSE_SETTINGS),
    "geometry_msgs/msg/PoseWithCovarianceStamped": Kind(
        "PoseWithCovariance", "poses", "shapes_of_pose_with_covariance", POSE_WITH_COVARIANCE_SETTINGS
    ),
    "geometry_msgs/msg/PoseArray": Kind("PoseArray", "poses", "shapes_of_pose_array", POSE_ARRAY_SETTINGS),
    "geometry_msgs/msg/PointStamped": Kind("PointStamped", "poses", "shapes_of_point", POINT_SETTINGS),
    "geometry_msgs/msg/PolygonStamped": Kind("Polygon", "poses", "shapes_of_polygon", POLYGON_SETTINGS),
    "geometry_msgs/msg/WrenchStamped": Kind("Wrench", "wrench", "shapes_of_wrench", WRENCH_SETTINGS),
    "geometry_msgs/msg/TwistStamped": Kind("TwistStamped", "wrench", "shapes_of_twist", TWIST_SETTINGS),
    "sensor_msgs/msg/JointState": Kind("Effort", "wrench", "EffortDisplay", EFFORT_SETTINGS),
    "turtlesim/msg/Pose": Kind("Turtle", "turtles", "TurtleDisplay"),
    "turtlesim_msgs/msg/Pose": Kind("Turtle", "turtles", "TurtleDisplay"),
}
KINDS = {type_name: _queued(kind) for type_name, kind in _OF_TYPES.items()}
"""By the type of the messages."""

DEPTH_CLOUD = _queued(Kind("DepthCloud", "depth_cloud", "DepthCloudDisplay", CLOUD_SETTINGS))
FURTHER_KINDS: Mapping[str, tuple[Kind, ...]] = MappingProxyType({"sensor_msgs/msg/Image": (DEPTH_CLOUD,)})
"""What also shows messages of a type, where that is asked for."""
PAIRED = frozenset((DEPTH_CLOUD.label, "Effort"))
"""Labels of displays that need a second topic."""

ROBOT = _queued(Kind("RobotModel", "robot_model", "RobotDisplay", ROBOT_SETTINGS))
PLAIN = (
    Kind("Axes", "plain", "AxesDisplay", AXES_SETTINGS, has_topic=False),
    Kind("Grid", "plain", "GridDisplay", GRID_SETTINGS, has_topic=False),
)
"""Displays without a topic."""
ROBOT_TYPE = "std_msgs/msg/String"
ROBOT_TOPIC = "robot_description"
"""A topic of this type is a robot's description where its name ends so."""


LABELS: Mapping[str, Kind] = {kind.label: kind for kind in (*KINDS.values(), DEPTH_CLOUD, ROBOT, *PLAIN)}
"""By their labels."""


def kind_of(topic: str, type_name: str) -> Kind | None:
    """Return the display of a topic; None if there is none for its type."""
    if type_name == ROBOT_TYPE:
        return ROBOT if topic.endswith(ROBOT_TOPIC) else None
    return KINDS.get(type_name)


def kinds_of(topic: str, type_name: str) -> list[Kind]:
    """Return the displays of a topic, the usual one first."""
    usual = kind_of(topic, type_name)
    return [] if usual is None else [usual, *FURTHER_KINDS.get(type_name, ())]


def described_settings() -> dict[str, Any]:
    """Return what pages have to know of all settings, as values for JSON."""

    def described(settings: Mapping[str, Setting]) -> dict[str, Any]:
        return {name: setting.description() for name, setting in settings.items()}

    return {
        "kinds": {label: described(kind.settings) for label, kind in LABELS.items()},
        "frames": described(FRAME_SETTINGS),
        "plain": [label for label, kind in LABELS.items() if not kind.has_topic],
    }


def make_display(kind: Kind, topic: str, settings: Values | None = None) -> Display | None:
    """Return a new display; None for one that is shown beside the scene.

    Args:
        kind: Its kind.
        topic: The topic that it shows.
        settings: A value for each of the kind's settings, which may change as long as the display is not asked for
            shapes; None: the usual ones.
    """
    if not kind.module:
        return None
    values = usual_values(kind.settings) if settings is None else settings
    made = getattr(import_module(f"tfloom.viewer.displays.{kind.module}"), kind.name)
    if not isinstance(made, type):
        return Latest(values, made)
    make: Callable[..., Display] = made
    return make(values, topic) if kind.module == "turtles" else make(values)

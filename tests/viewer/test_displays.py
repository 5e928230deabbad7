"""What each kind of message looks like; and that no message, however wrong, is more than a sentence."""

from __future__ import annotations

import io
import math
from typing import Any

import numpy as np
import pytest
from tests.viewer.messages import ARM, camera_info, cloud, depth_image, efforts, header, marker, pose, wrench

from tfloom.interfaces.builtin_interfaces.msg import Duration
from tfloom.interfaces.geometry_msgs.msg import (
    Point,
    Point32,
    PointStamped,
    Polygon,
    PolygonStamped,
    PoseArray,
    PoseStamped,
    PoseWithCovariance,
    PoseWithCovarianceStamped,
    Twist,
    TwistStamped,
    TwistWithCovariance,
    Vector3,
    WrenchStamped,
)
from tfloom.interfaces.nav_msgs.msg import GridCells, MapMetaData, OccupancyGrid, Odometry, Path
from tfloom.interfaces.sensor_msgs.msg import CameraInfo, CompressedImage, Image, JointState, LaserScan, Range
from tfloom.interfaces.std_msgs.msg import ColorRGBA, String
from tfloom.interfaces.turtlesim.msg import Pose as TurtlePose
from tfloom.interfaces.visualization_msgs.msg import Marker, MarkerArray
from tfloom.tf2.transform import Transform
from tfloom.viewer import shapes
from tfloom.viewer.color_scale import rainbow
from tfloom.viewer.displays.camera_info import CameraDisplay, images_of, info_topic_of, pinhole_of
from tfloom.viewer.displays.depth_cloud import DepthCloudDisplay
from tfloom.viewer.displays.display import Display, shown_text
from tfloom.viewer.displays.kinds import KINDS, LABELS, ROBOT, kind_of, make_display
from tfloom.viewer.displays.markers import MAX_MARKERS, MarkerDisplay
from tfloom.viewer.displays.point_cloud import MAX_POINTS
from tfloom.viewer.displays.settings import (
    CLOUD_SETTINGS,
    EFFORT_SETTINGS,
    MARKER_SETTINGS,
    PATH_SETTINGS,
    WRENCH_SETTINGS,
    SettingError,
    to_file,
    usual_values,
)
from tfloom.viewer.displays.wrench import EffortDisplay
from tfloom.viewer.mesh_files import translucent
from tfloom.viewer.pictures import picture_of, small_pixels
from tfloom.viewer.topic_log import Entry

S = 1_000_000_000


def display_of(type_name: str, topic: str = "/topic", **settings: Any) -> Display:
    kind = kind_of(topic, type_name)
    assert kind is not None
    assert settings.keys() <= kind.settings.keys()
    display = make_display(kind, topic, {**usual_values(kind.settings), **settings})
    assert display is not None
    return display


def shown(message: Any, now_ns: int = S, **settings: Any) -> list[shapes.Placed]:
    display = display_of(message._TYPE_NAME, **settings)
    display.take(message, S)
    return display.shapes(now_ns)


def test_each_kind_has_a_display_except_images_which_are_beside_the_scene() -> None:
    for type_name, kind in KINDS.items():
        assert (make_display(kind, "/t") is None) == ("Image" in type_name)
    assert kind_of("/robot1/robot_description", "std_msgs/msg/String") is ROBOT
    assert kind_of("/chatter", "std_msgs/msg/String") is None
    assert kind_of("/x", "my_msgs/msg/Unknown") is None


# Point clouds.


def test_cloud_has_its_finite_points_coloured_by_a_field() -> None:
    dtype = [("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("intensity", "<f4")]
    points = np.array([(0, 0, 5, 1), (1, 2, 3, 9), (math.nan, 0, 0, 5), (0, math.inf, 0, 5)], dtype)
    display = display_of("sensor_msgs/msg/PointCloud2")
    display.take(cloud(points, "lidar"), S)
    (placed,) = display.shapes(S)
    assert (placed.frame_id, placed.stamp_ns) == ("lidar", S)
    assert isinstance(placed.shape, shapes.Points)
    assert placed.shape.positions.tolist() == [[0, 0, 5], [1, 2, 3]]
    assert placed.shape.colors.tolist() == rainbow([1, 9]).tolist()
    assert display.choices == ("x", "y", "z", "intensity")
    display.choice = "z"
    display.take(cloud(points, "lidar"), S)
    assert display.shapes(S)[0].shape.colors.tolist() == rainbow([5, 3]).tolist()


def test_cloud_with_packed_colours() -> None:
    points = np.zeros(1, [("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("rgb", "<f4")])
    points["rgb"] = np.array([0x00102030], "<u4").view("<f4")
    assert shown(cloud(points))[0].shape.colors.tolist() == [[0x10, 0x20, 0x30]]


def test_cloud_of_a_wrong_layout_is_a_sentence() -> None:
    points = np.zeros(3, [("x", "<f4"), ("y", "<f4"), ("z", "<f4")])
    short = cloud(points)
    short.data = b"\0" * 7
    with pytest.raises(shapes.DisplayError, match="its layout is wrong"):
        shown(short)
    with pytest.raises(shapes.DisplayError, match="no fields x, y and z"):
        shown(cloud(np.zeros(1, [("range", "<f4")])))
    assert shown(cloud(points[:0])) == []


def test_large_cloud_is_thinned() -> None:
    from tfloom.viewer.displays.point_cloud import MAX_POINTS

    points = np.zeros(2 * MAX_POINTS + 5, [("x", "<f4"), ("y", "<f4"), ("z", "<f4")])
    assert len(shown(cloud(points))[0].shape.positions) <= MAX_POINTS


# Laser scans, ranges, cameras.


def test_scan_has_the_points_within_its_limits() -> None:
    scan = LaserScan(
        header=header("laser"),
        angle_min=0.0,
        angle_increment=math.pi / 2,
        range_min=0.5,
        range_max=10.0,
        ranges=[2.0, 3.0, 0.1, math.inf, math.nan],
    )
    (placed,) = shown(scan)
    assert placed.shape.positions == pytest.approx(np.array([[2, 0, 0], [0, 3, 0]]), abs=1e-6)
    scan.ranges = [math.nan]
    assert shown(scan) == []


def test_range_is_a_cone_and_camera_a_pyramid() -> None:
    (cone,) = shown(Range(header=header("sonar"), field_of_view=0.5, range=2.0, min_range=0.1, max_range=5.0))
    assert cone.shape.vertices[:, 0].max() == pytest.approx(2.0)
    assert cone.shape.vertices[:, 1].max() == pytest.approx(2.0 * math.tan(0.25))
    k = [100.0, 0, 50, 0, 100.0, 40, 0, 0, 1]
    (pyramid,) = shown(CameraInfo(header=header("camera"), width=100, height=80, k=k))
    assert pyramid.shape.ends.shape == (8, 2, 3)
    assert np.abs(pyramid.shape.ends).max(axis=(0, 1)) == pytest.approx((0.25, 0.2, 0.5))
    with pytest.raises(shapes.DisplayError, match="field of view"):
        shown(Range(field_of_view=math.nan))
    with pytest.raises(shapes.DisplayError, match="not calibrated"):
        shown(CameraInfo())


def test_image_is_at_the_far_end_of_its_cameras_pyramid() -> None:
    display = CameraDisplay({})
    info = CameraInfo(header=header("camera", 7), width=4, height=2, k=[2.0, 0, 1.0, 0, 2.0, 1.0, 0, 0, 1])
    display.take(info, 0)
    pixels = np.arange(24, dtype=np.uint8)
    image = Image(width=4, height=2, step=12, encoding="rgb8", data=pixels.tobytes())
    display.set_image(Entry(1, 1, 1, False, b"", lambda _: image))
    _, placed = display.shapes(0)
    assert (placed.frame_id, placed.stamp_ns) == ("camera", 7 * S)
    assert (placed.shape.pixels == pixels.reshape(2, 4, 3)).all()
    assert placed.shape.size == pytest.approx((1.0, 0.5))

    def corner(across: float, up: float) -> Any:
        return Transform(placed.position, placed.rotation_xyzw).apply((across, up, 0.0))

    # The middle of the left upper pixel, (0.5, 0.5), and the right lower corner, half a metre before the camera.
    assert corner(0.125, 0.375) == pytest.approx(((0.5 - 1.0) / 4.0, (0.5 - 1.0) / 4.0, 0.5))
    assert corner(1.0, 0.0) == pytest.approx(((4.0 - 1.0) / 4.0, (2.0 - 1.0) / 4.0, 0.5))
    pyramid, picture = (one.shape for one in display.shapes(0))
    display.take(info, 0)  # the same calibration a moment later is drawn by what is there
    assert display.shapes(0)[0].shape is pyramid
    assert display.shapes(0)[1].shape is picture
    wider = CameraInfo(header=header("camera"), width=4, height=2, k=[1.0, 0, 1.0, 0, 1.0, 1.0, 0, 0, 1])
    display.take(wider, 0)
    assert display.shapes(0)[0].shape is not pyramid
    assert display.shapes(0)[1].shape.size == pytest.approx((2.0, 1.0))
    broken = Image(width=4, height=2, step=1, encoding="rgb8", data=b"1")
    display._next_picture_s = 0.0
    display.set_image(Entry(2, 2, 2, False, b"", lambda _: broken))
    assert len(display.shapes(0)) == 1


def test_images_of_a_camera_are_those_beside_it() -> None:
    topics = ["/cam/image_raw", "/cam/image_raw/compressed", "/cam/depth/image", "/image", "/camera/image"]
    assert images_of("/cam/camera_info", topics) == ["/cam/image_raw", "/cam/image_raw/compressed"]
    assert images_of("/camera_info", topics) == ["/image"]
    display = CameraDisplay({})
    assert (display.offer([]), list(display.choices)) == ("", [])
    assert display.offer(["/a", "/b"]) == "/a"
    display.choice = "/b"
    assert display.offer(["/a", "/b"]) == "/b"
    assert display.offer(["/a"]) == "/a"  # the chosen one is off
    display.choice = "no image"
    assert display.offer(["/a"]) == ""


def test_small_pixels_are_those_of_any_kind_of_image() -> None:
    grey = Image(width=400, height=2, step=400, encoding="mono8", data=bytes(range(200)) * 4)
    assert small_pixels(grey, 100).shape == (1, 100, 3)
    assert small_pixels(grey, 100)[0, 1].tolist() == [4, 4, 4]
    pil = pytest.importorskip("PIL.Image", reason="needs Pillow, which comes with the extra view")
    kind, data = picture_of(
        Image(width=8, height=8, step=24, encoding="rgb8", data=bytes([200, 10, 10]) * 64)
    )
    packed = CompressedImage(format="jpeg", data=data)
    assert kind == "image/jpeg"
    assert small_pixels(packed, 100)[4, 4].tolist() == pytest.approx([200, 10, 10], abs=8)
    for damaged in (data[:20], b"\x89PNG\r\n\x1a\n" + b"x" * 30, b"RIFF" + b"x" * 30):
        with pytest.raises(shapes.DisplayError, match="its file is damaged"):
            small_pixels(CompressedImage(data=damaged), 100)
    file = io.BytesIO()
    pil.new("1", (9000, 9000)).save(file, "PNG")
    with pytest.raises(shapes.DisplayError, match="9000 by 9000 pixels, too many"):
        small_pixels(CompressedImage(data=file.getvalue()), 100)


# Paths, poses, odometry, grids, turtles.


def test_path_and_polygon_are_lines() -> None:
    poses = [PoseStamped(pose=pose(x)) for x in (0.0, 1.0, math.nan, 2.0)]
    (line,) = shown(Path(header=header(), poses=poses))
    assert line.shape.ends[:, :, 0].tolist() == [[0, 1], [1, 2]]
    corners = [Point32(x=float(x)) for x in range(3)]
    (ring,) = shown(PolygonStamped(header=header(), polygon=Polygon(points=corners)))
    assert ring.shape.ends[:, :, 0].tolist() == [[0, 1], [1, 2], [2, 0]]
    assert shown(Path()) == []


def test_pose_is_an_arrow_and_its_covariance_an_ellipsoid() -> None:
    turn = (0.0, 0.0, 1.0, 0.0)
    (arrow,) = shown(PoseStamped(header=header("odom"), pose=pose(1.0, 2.0, 3.0, turn)))
    assert (arrow.frame_id, arrow.position, arrow.rotation_xyzw) == ("odom", (1.0, 2.0, 3.0), turn)
    covariance = np.zeros((6, 6))
    covariance[0, 0], covariance[1, 1], covariance[2, 2] = 4.0, 1.0, 0.25
    with_covariance = PoseWithCovariance(pose=pose(1.0), covariance=covariance.ravel())
    _, ball = shown(PoseWithCovarianceStamped(header=header(), pose=with_covariance))
    assert sorted(ball.shape.radii) == pytest.approx([0.5, 1.0, 2.0])
    twist = TwistWithCovariance(twist=Twist(linear=Vector3(x=3.0, y=4.0)))
    *_, text = shown(Odometry(header=header(), pose=with_covariance, twist=twist))
    assert text.shape.text == "5.00 m/s"
    with pytest.raises(shapes.DisplayError, match="not finite"):
        shown(PoseStamped(pose=pose(math.nan)))


@pytest.mark.parametrize("wrong", [-1.0, math.nan, math.inf])
def test_covariance_that_is_none_is_not_drawn(wrong: float) -> None:
    covariance = np.zeros((6, 6))
    covariance[0, 0] = wrong
    message = PoseWithCovarianceStamped(pose=PoseWithCovariance(pose=pose(), covariance=covariance.ravel()))
    assert [type(placed.shape) for placed in shown(message)] == [shapes.Mesh]


def test_pose_array_has_the_finite_poses_and_zero_quaternions_do_not_turn() -> None:
    (axes,) = shown(PoseArray(header=header(), poses=[pose(1.0), pose(math.inf), pose(2.0, turn=(0.0,) * 4)]))
    assert axes.shape.positions[:, 0].tolist() == [1, 2]
    assert axes.shape.rotations_xyzw.tolist() == [[0, 0, 0, 1], [0, 0, 0, 1]]
    (ball,) = shown(PointStamped(header=header(), point=Point(x=1.0)))
    assert ball.position == (1.0, 0.0, 0.0)


def test_grid_is_a_picture_with_its_first_row_below() -> None:
    info = MapMetaData(resolution=0.5, width=2, height=2, origin=pose(-1.0, -2.0))
    (placed,) = shown(OccupancyGrid(header=header(), info=info, data=[0, 100, -1, 50]))
    assert placed.position == (-1.0, -2.0, 0.0)
    assert placed.shape.size == (1.0, 1.0)
    pixels = placed.shape.pixels
    assert pixels[1, 0].tolist() == [254, 254, 254, 255]  # the first cell: left and below
    assert pixels[1, 1].tolist() == [0, 0, 0, 255]
    assert pixels[0, 0, 3] < 255  # unknown
    info.width = 3
    with pytest.raises(shapes.DisplayError, match="its data has 4 cells, and 3 by 2 require 6"):
        shown(OccupancyGrid(info=info, data=[0, 100, -1, 50]))


def test_turtle_is_on_its_water() -> None:
    display = display_of("turtlesim/msg/Pose", "/turtle1/pose")
    display.take(TurtlePose(x=2.0, y=3.0, theta=math.pi / 2), S)
    water, turtle = display.shapes(S)
    assert (water.frame_id, water.shape.size[0]) == ("world", pytest.approx(11.09, abs=0.01))
    assert water.shape.pixels.tolist() == [[[69, 86, 255]]]
    # The turtle's picture is turned by a quarter: from its middle, its corner is to the right and below.
    half = turtle.shape.size[0] / 2.0
    assert turtle.position[:2] == pytest.approx((2.0 + half, 3.0 - half))
    opaque = turtle.shape.pixels[..., 3] > 128
    assert 0.2 < opaque.mean() < 0.8
    assert np.ptp(np.flatnonzero(opaque.any(axis=0))) / 128 == pytest.approx(
        1.0, abs=0.2
    )  # a turtle is a metre long
    before = display.shapes(S)[1].shape
    display.take(TurtlePose(x=2.5, y=3.0), 2 * S)
    assert display.shapes(S)[1].shape is before  # so that the page gets a pose, not a picture
    with pytest.raises(shapes.DisplayError, match="not finite"):
        display.take(TurtlePose(x=math.nan), S)


# Depth images.


def depth_shapes(image: Image, focal: float = 2.0, **settings: Any) -> list[shapes.Placed]:
    display = DepthCloudDisplay({**usual_values(CLOUD_SETTINGS), **settings})
    display.partner = pinhole_of(camera_info(image.width, image.height, focal))
    return display.shapes_of(image)


@pytest.mark.parametrize(("encoding", "unit"), [("32FC1", 1.0), ("16UC1", 1000.0)])
def test_pixel_of_a_depth_image_is_where_its_ray_has_that_depth(encoding: str, unit: float) -> None:
    (placed,) = depth_shapes(depth_image(np.array([[1, 2, 0], [0, 4, 8]]) * unit, encoding, "lens", 7))
    assert (placed.frame_id, placed.stamp_ns) == ("lens", 7 * S)
    # By x = (u - 1) z / 2 and y = (v - 0) z / 1.
    expected = [(-0.5, 0.0, 1.0), (0.0, 0.0, 2.0), (0.0, 4.0, 4.0), (4.0, 8.0, 8.0)]
    assert placed.shape.positions == pytest.approx(np.array(expected))


def test_depth_image_of_the_other_byte_order_is_the_same_cloud() -> None:
    image = depth_image([[3000, 0, 500]], "16UC1")
    (placed,) = depth_shapes(image)
    swapped = Image(
        header=header(), height=1, width=3, step=6, encoding="16UC1", is_bigendian=1,
        data=np.array([3000, 0, 500], ">u2").tobytes(),
    )  # fmt: skip
    (again,) = depth_shapes(swapped)
    assert (again.shape.positions == placed.shape.positions).all()


def test_pixel_without_a_depth_is_no_point_and_an_image_without_any_is_nothing() -> None:
    none = [math.nan, math.inf, -math.inf, 0.0, -1.0]
    (placed,) = depth_shapes(depth_image([[*none, 2.0]]))
    assert placed.shape.positions.tolist() == [[4.0, 0.0, 2.0]]
    assert depth_shapes(depth_image([none])) == []
    assert depth_shapes(depth_image([[3e38, 1.0]]), focal=1e-300) != []


def test_cloud_of_a_depth_image_has_the_colours_that_are_set() -> None:
    image = depth_image([[1.0, 2.0]])
    (flat,) = depth_shapes(image, color_by="flat", color=(1, 2, 3))
    assert flat.shape.colors.tolist() == [1, 2, 3]
    (deep,) = depth_shapes(image)
    assert deep.shape.colors.shape == (2, 3)
    assert (deep.shape.colors[0] != deep.shape.colors[1]).any()


@pytest.mark.parametrize("size", [(2000, 1000), (1, 3_000_000)])
def test_large_depth_image_is_drawn_by_a_part_of_its_pixels(size: tuple[int, int]) -> None:
    (placed,) = depth_shapes(depth_image(np.full(size, 1000), "16UC1"))
    count = len(placed.shape.positions)
    assert MAX_POINTS / 8 < count <= MAX_POINTS
    last = placed.shape.positions[-1]  # one of the last row and column that are drawn, in its place
    assert last[1] == pytest.approx(size[0] - 1, abs=10)
    assert last[0] == pytest.approx((size[1] - 2) / 2, abs=50)


def test_depth_image_that_cant_be_drawn_is_a_sentence() -> None:
    display = DepthCloudDisplay(usual_values(CLOUD_SETTINGS))
    with pytest.raises(shapes.DisplayError, match="its camera info is not known"):
        display.shapes_of(depth_image([[1.0]]))
    display.partner = pinhole_of(camera_info(3, 1))
    with pytest.raises(shapes.DisplayError, match="it has 2 by 1 pixels, and its camera info is of 3 by 1"):
        display.shapes_of(depth_image([[1.0, 1.0]]))
    for encoding in ("rgb8", "mono8", "x" * 300):
        with pytest.raises(shapes.DisplayError, match="and that of depths is 16UC1 or 32FC1"):
            display.shapes_of(Image(width=3, height=1, step=9, encoding=encoding, data=bytes(9)))
    for sizes in ({"height": 2**32 - 1}, {"width": 2**31}, {"step": 0}, {"step": 2**32 - 1}, {"data": b""}):
        image = depth_image([[1.0, 1.0, 1.0]])
        for name, value in sizes.items():
            setattr(image, name, value)
        with pytest.raises(shapes.DisplayError, match="which don't fit"):
            display.shapes_of(image)
    with pytest.raises(shapes.DisplayError, match="no pixels"):
        display.shapes_of(Image(encoding="16UC1"))


def test_camera_info_of_an_image_is_beside_it() -> None:
    assert info_topic_of("/cam/depth/image_raw") == "/cam/depth/camera_info"
    assert info_topic_of("/image") == "/camera_info"


# Efforts.


def effort_shapes(message: Any, text: str = ARM, **settings: Any) -> list[shapes.Placed]:
    display = EffortDisplay({**usual_values(EFFORT_SETTINGS), **settings})
    display.partner = display.partner_of(String(data=text))
    return display.shapes_of(message)


def test_effort_is_an_arrow_along_the_joints_axis_as_long_as_its_share_of_the_limit() -> None:
    turning, sliding = effort_shapes(efforts(7, elbow=-5.0, rail=4.0, wheel=9.0), scale=2.0)
    assert [(one.frame_id, one.stamp_ns) for one in (turning, sliding)] == [("a", 7 * S), ("b", 7 * S)]
    low, high = turning.shape.vertices.min(axis=0), turning.shape.vertices.max(axis=0)
    assert (low[2], high[2]) == pytest.approx((-1.3, 0.01), abs=0.011)  # half of 2 m, and the head after it
    assert np.abs(turning.shape.vertices[:, :2]).max() == pytest.approx(0.25, abs=0.03)  # the ring
    low, high = sliding.shape.vertices.min(axis=0), sliding.shape.vertices.max(axis=0)
    assert (low[1], high[1]) == pytest.approx((0.0, 2.6), abs=1e-6)
    assert np.abs(sliding.shape.vertices[:, [0, 2]]).max() == pytest.approx(0.02)  # no ring
    assert (turning.shape.color, sliding.shape.color) == ((255, 255, 0), (255, 0, 0))


def test_effort_beyond_its_limit_is_longer_and_a_small_or_unknown_one_is_not_drawn() -> None:
    (over,) = effort_shapes(efforts(rail=8.0, elbow=math.nan), opacity=0.5)
    assert over.shape.vertices[:, 1].max() == pytest.approx(2.6)
    assert (over.shape.color, over.shape.opacity) == ((255, 0, 0), 0.5)
    assert effort_shapes(efforts(rail=0.08, elbow=0.0)) == []  # a length that isn't above the width


def test_effort_that_cant_be_drawn_is_a_sentence() -> None:
    for message, sentence in (
        (efforts(), "it has 0 efforts for 0 joints"),
        (JointState(name=["elbow", "rail"], effort=[1.0]), "it has 1 efforts for 2 joints"),
        (efforts(wheel=1.0, other=2.0), "none of its joints is one of the robot"),
        (efforts(rail=math.inf), "the arrow of rail is longer than"),
        (efforts(rail=-1e13), "the arrow of rail is longer than"),
    ):
        with pytest.raises(shapes.DisplayError, match=sentence):
            effort_shapes(message)
    with pytest.raises(shapes.DisplayError, match="it is not a URDF"):
        effort_shapes(efforts(rail=1.0), "<robot")
    with pytest.raises(shapes.DisplayError, match="none of its joints has a limit of its effort"):
        effort_shapes(efforts(rail=1.0), ARM.replace('effort="', 'effort="-'))
    with pytest.raises(shapes.DisplayError, match="its robot description is not known"):
        EffortDisplay(usual_values(EFFORT_SETTINGS)).shapes_of(efforts(rail=1.0))


# Wrenches.


def wrench_shapes(message: WrenchStamped, **settings: Any) -> list[shapes.Placed]:
    return shown(message, **settings)


def test_force_is_an_arrow_as_long_and_as_wide_as_in_rviz() -> None:
    (placed,) = wrench_shapes(wrench((0.0, -3.0, 0.0), frame="tool"))
    assert (placed.frame_id, placed.stamp_ns, placed.position) == ("tool", S, (0.0, 0.0, 0.0))
    arrow = placed.shape
    assert (arrow.color, arrow.opacity) == ((204, 51, 51), 1.0)
    # Twice its size, and three tenths of that for its head, which is a fifth of the width across.
    assert arrow.vertices.min(axis=0) == pytest.approx((-0.05, -7.8, -0.05), abs=0.003)
    assert arrow.vertices.max(axis=0) == pytest.approx((0.05, 0.0, 0.05), abs=0.003)
    (placed,) = wrench_shapes(wrench(force=(0.0, 0.0, 0.5)), force_scale=10.0, width=2.0, opacity=0.25)
    assert placed.shape.vertices[:, 2].max() == pytest.approx(6.5)
    assert placed.shape.vertices[:, 0].max() == pytest.approx(0.2)
    assert placed.shape.opacity == 0.25
    (placed,) = wrench_shapes(wrench(force=(9.0, 0.0, 0.0)), force_color=(1, 2, 3))
    assert placed.shape.color == (1, 2, 3)


@pytest.mark.parametrize("direction", [(0, 0, 1), (0, 0, -1), (1, 0, 0), (-1, 2, -3), (1e-9, 0, -1)])
def test_torque_is_an_arrow_with_a_ring_that_turns_by_the_right_hand(direction: tuple[float, ...]) -> None:
    along = np.array(direction) / np.linalg.norm(direction)
    x, y, z = 4.0 * along
    (placed,) = wrench_shapes(wrench(torque=(x, y, z)), torque_scale=1.0, width=0.1)
    assert placed.shape.color == (204, 204, 51)
    heights = placed.shape.vertices @ along
    assert (heights.min(), heights.max()) == pytest.approx((0.0, 5.2), abs=1e-5)
    outwards = placed.shape.vertices - heights[:, np.newaxis] * along
    is_ring = np.linalg.norm(outwards, axis=1) > 0.5
    assert heights[is_ring] == pytest.approx(np.full(is_ring.sum(), 2.0), abs=0.011)
    ring = outwards[is_ring]
    assert np.linalg.norm(ring, axis=1) == pytest.approx(np.full(len(ring), 1.0), abs=0.011)
    first, tip = ring[0], ring[-1]
    # An eighth of it is open between the tip and the first end; from there it turns about the torque.
    turned = math.atan2(np.cross(tip, first) @ along, tip @ first)
    assert turned == pytest.approx(math.pi / 4.0, abs=0.02)
    assert np.cross(ring[10], ring[20]) @ along > 0.0


def test_wrench_is_drawn_as_far_as_it_is_longer_than_its_width() -> None:
    both = wrench_shapes(wrench((1.0, 0.0, 0.0), (0.0, 1.0, 0.0)))
    assert [placed.shape.color for placed in both] == [(204, 51, 51), (204, 204, 51)]
    (force,) = wrench_shapes(wrench((1.0, 0.0, 0.0), (0.0, 0.25, 0.0)))
    assert force.shape.color == (204, 51, 51)
    with pytest.raises(shapes.DisplayError, match=r"its arrows would be shorter than their width of 0\.5$"):
        wrench_shapes(wrench((0.25, 0.0, 0.0), (0.0, 0.25, 0.0)))
    (small,) = wrench_shapes(wrench((3e-200, 4e-200, 0.0)), force_scale=1e6, width=1e-200)
    assert small.shape.vertices.max() == 0.0  # of single precision, as pages have it


@pytest.mark.parametrize("wrong", [math.nan, math.inf, -math.inf, 1e304, -1e12])
def test_wrench_that_cant_be_drawn_is_a_sentence(wrong: float) -> None:
    good = (1.0, 1.0, 1.0)
    for place in range(3):
        x, y, z = (wrong if axis == place else 1.0 for axis in range(3))
        with pytest.raises(shapes.DisplayError, match="its force is not finite, or its arrow is longer"):
            wrench_shapes(wrench((x, y, z), good))
        with pytest.raises(shapes.DisplayError, match="its torque is not finite, or its arrow is longer"):
            wrench_shapes(wrench(good, (x, y, z)))


def test_each_setting_of_a_kind_may_be_what_it_usually_is() -> None:
    for kind in LABELS.values():
        properties = [setting.rviz for setting in kind.settings.values() if setting.rviz]
        assert len(properties) == len(set(properties)), kind.label
        for name, setting in kind.settings.items():
            assert setting.taken(to_file(setting.usual)) == setting.usual, name
            assert setting.from_rviz(setting.to_rviz(setting.usual)) == setting.usual, name
            assert setting.description()["kind"], name


SETTINGS = {**PATH_SETTINGS, **CLOUD_SETTINGS, **MARKER_SETTINGS, **WRENCH_SETTINGS}


@pytest.mark.parametrize(
    ("name", "values"),
    [
        ("opacity", (-0.1, 1.1, math.nan, True, "1", None, [], 10**400)),
        ("history", (0, 1001, 1.5, math.nan, math.inf, -(10**400))),
        ("force_color", ("red", "1; 2", "1; 2; 256", "٣; 1; 1", [1, 2], [1, 2, 3.0], [1, 2, True], 3, None)),
    ],
)
def test_value_that_a_setting_cant_have_is_a_sentence(name: str, values: tuple[Any, ...]) -> None:
    for value in values:
        with pytest.raises(SettingError, match=r"^has to be .* from \d to \d+,.* not .*$") as refused:
            SETTINGS[name].taken(value)
        assert len(str(refused.value)) < 150
    assert SETTINGS["force_color"].taken("204; 51;  7") == SETTINGS["force_color"].taken([204, 51, 7])


# Markers.


@pytest.mark.parametrize(
    ("kind", "shape"),
    [
        (Marker.ARROW, shapes.Arrows),
        (Marker.CUBE, shapes.Box),
        (Marker.SPHERE, shapes.Ball),
        (Marker.CYLINDER, shapes.Cylinder),
        (Marker.LINE_STRIP, shapes.Lines),
        (Marker.LINE_LIST, shapes.Lines),
        (Marker.CUBE_LIST, shapes.Copies),
        (Marker.SPHERE_LIST, shapes.Copies),
        (Marker.POINTS, shapes.Points),
        (Marker.TEXT_VIEW_FACING, shapes.Text),
        (Marker.TRIANGLE_LIST, shapes.Mesh),
    ],
)
def test_each_kind_of_marker_has_a_shape(kind: int, shape: type) -> None:
    points = [Point(x=float(x)) for x in range(3)] if kind != Marker.ARROW else []
    (placed,) = shown(marker(kind, points=points, text="<b>text</b>"))
    assert isinstance(placed.shape, shape)


def test_markers_are_added_changed_deleted_and_end() -> None:
    display = display_of("visualization_msgs/msg/MarkerArray")
    two = [marker(Marker.CUBE, 1), marker(Marker.CUBE, 2, lifetime=Duration(sec=3))]
    display.take(MarkerArray(markers=two), 10 * S)
    assert len(display.shapes(12 * S)) == 2
    assert len(display.shapes(14 * S)) == 1
    display.take(MarkerArray(markers=[marker(Marker.SPHERE, 1)]), 11 * S)
    kinds = [type(placed.shape) for placed in display.shapes(12 * S)]
    assert sorted(kind.__name__ for kind in kinds) == ["Ball", "Box"]
    display.take(MarkerArray(markers=[marker(0, 2, action=Marker.DELETE)]), 12 * S)
    assert len(display.shapes(12 * S)) == 1
    display.take(MarkerArray(markers=[marker(0, action=Marker.DELETEALL)]), 12 * S)
    assert display.shapes(12 * S) == []


def test_markers_whose_lifetime_is_over_make_room_for_new_ones() -> None:
    display = display_of("visualization_msgs/msg/MarkerArray")
    lasting = marker(Marker.CUBE, -1)
    for number in range(MAX_MARKERS + 1):
        passing = marker(Marker.CUBE, number, lifetime=Duration(nanosec=100_000_000))
        display.take(MarkerArray(markers=[passing, lasting]), number * S)
    assert len(display.shapes(MAX_MARKERS * S)) == 2
    more = [marker(Marker.CUBE, number, ns="more") for number in range(MAX_MARKERS)]
    with pytest.raises(shapes.DisplayError, match=f"more than {MAX_MARKERS} markers"):
        display.take(MarkerArray(markers=more), MAX_MARKERS * S)
    assert len(display.shapes(MAX_MARKERS * S)) == MAX_MARKERS


def test_points_of_markers_have_their_own_colours() -> None:
    colors = [ColorRGBA(r=1.0, a=1.0), ColorRGBA(g=1.0, a=1.0)]
    (placed,) = shown(marker(Marker.POINTS, points=[Point(), Point(x=1.0)], colors=colors))
    assert placed.shape.colors.tolist() == [[255, 0, 0], [0, 255, 0]]


def test_wrong_marker_is_a_sentence_and_the_others_are_shown() -> None:
    display = display_of("visualization_msgs/msg/MarkerArray")
    wrong = (
        marker(77, 1),
        marker(Marker.CUBE, 2, pose=pose(math.nan)),
        marker(Marker.MESH_RESOURCE, 3, mesh_resource="file:///etc/passwd"),
    )
    with pytest.raises(shapes.DisplayError, match=r"marker 1 of 'test': its type is 77.* \(and 2 more\)"):
        display.take(MarkerArray(markers=[*wrong, marker(Marker.CUBE, 4)]), S)
    assert len(display.shapes(S)) == 1


# Robots.

URDF = """<robot name="r"><link name="base"><visual><origin xyz="1 2 3"/><geometry><box size="1 1 2"/></geometry>
<material name="red"><color rgba="1 0 0 0.5"/></material></visual></link>
<link name="tip"><visual><geometry><sphere radius="0.5"/></geometry><material name="red"/></visual>
<visual><geometry><mesh filename="package://no_such_package/a.stl"/></geometry></visual></link></robot>"""


def test_robot_has_the_forms_of_its_links_and_says_what_it_lacks() -> None:
    display = display_of("std_msgs/msg/String", "/robot_description")
    display.take(String(data=URDF), S)
    box, ball = display.shapes(S)
    assert (box.frame_id, box.position, box.stamp_ns) == ("base", (1.0, 2.0, 3.0), shapes.AT_VIEW)
    assert box.shape == shapes.Box((1.0, 1.0, 2.0), (255, 0, 0), 0.5)
    assert ball.shape == shapes.Ball((0.5, 0.5, 0.5), (255, 0, 0), 0.5)
    with pytest.raises(shapes.DisplayError, match="it is not a URDF: line 1"):
        display.take(String(data="<robot"), S)
    assert display.shapes(S) == []


# Texts and colours.


def test_text_from_the_wire_is_cut_and_can_be_encoded() -> None:
    assert shown_text("<script>") == "<script>"
    assert shown_text("a\ud800b").encode()
    assert len(shown_text("x" * 10_000)) == 200


def test_rainbow_of_many_values() -> None:
    """From red to violet by way of green and blue, in order, and the few extremes stretch nothing."""
    values = np.concatenate([np.linspace(0.0, 1.0, 50_000), [1e6, -1e6, np.nan]])
    colors = rainbow(values).astype(int)
    assert colors[0].tolist() == [255, 0, 0]
    assert colors[25_000].tolist() == pytest.approx([0, 255, 102], abs=6)
    assert colors[49_999].tolist() == pytest.approx([204, 0, 255], abs=6)
    assert np.abs(np.diff(colors[:50_000], axis=0)).max() <= 2
    assert colors[-3:].tolist() == [colors[49_999].tolist(), [255, 0, 0], [128] * 3]


def test_rainbow_of_anything() -> None:
    assert rainbow([]).shape == (0, 3)
    assert rainbow([math.nan, math.inf]).tolist() == [[128] * 3] * 2
    assert rainbow([1.0, 1.0]).tolist() == [[255, 0, 0]] * 2
    low, high = rainbow([-1e308, 1e308]).tolist()
    assert low != high


# Settings of clouds, poses and maps.


def a_cloud(*rows: tuple[float, float, float, float]) -> Any:
    return cloud(np.array(list(rows), [("x", "<f4"), ("y", "<f4"), ("z", "<f4"), ("intensity", "<f4")]))


def colors_of(message: Any, **settings: Any) -> Any:
    (placed,) = shown(message, **settings)
    return placed.shape.colors.tolist()


RED, VIOLET = [255, 0, 0], [204, 0, 255]


def test_cloud_is_coloured_by_an_intensity_within_its_range() -> None:
    message = a_cloud((0, 0, 0, 0), (0, 0, 0, 50), (0, 0, 0, 100))
    first, middle, last = colors_of(message)
    assert (first, last) == (RED, VIOLET)
    assert colors_of(message, auto_range=False, low=50.0, high=60.0) == [RED, RED, VIOLET]
    assert colors_of(message, invert=True) == [VIOLET, middle, RED]
    grey = {"rainbow": False, "low_color": (0, 0, 0), "high_color": (200, 100, 50)}
    assert colors_of(message, **grey) == [[0, 0, 0], [100, 50, 25], [200, 100, 50]]
    assert colors_of(message, auto_range=False, low=5.0, high=5.0) == [RED, VIOLET, VIOLET]
    assert colors_of(message, color_by="flat", color=(1, 2, 3)) == [1, 2, 3]


def test_cloud_is_coloured_by_an_axis_of_its_own_or_of_the_fixed_frame() -> None:
    message = a_cloud((0, 0, 0, 9), (1, 0, 5, 8), (2, 0, 0, 7))
    by_x = {"color_by": "axis", "axis": "x", "axis_fixed": False}
    assert colors_of(message, **by_x)[::2] == [RED, VIOLET]
    ranged = {"axis_auto_range": False, "axis_low": 1.0, "axis_high": 1.5}
    assert colors_of(message, **by_x, **ranged) == [RED, RED, VIOLET]
    (placed,) = shown(message, color_by="axis", axis="z")
    by_axis = placed.shape.by_axis
    turned = Transform.from_rpy(0.0, -math.pi / 2.0, 0.0)  # their x is up
    pose = (0.0, 0.0, 7.0), turned.rotation_xyzw
    assert by_axis.of(placed.shape.positions, pose)[::2].tolist() == [RED, VIOLET]
    assert by_axis.of(placed.shape.positions, None)[1].tolist() == VIOLET


def test_points_are_squares_boxes_or_transparent_as_set() -> None:
    message = a_cloud((0, 0, 0, 1), (1, 0, 0, 2))
    assert [shown(message, **given)[0].shape.size_px for given in ({}, {"size_px": 5.0})] == [3.0, 5.0]
    (balls,) = shown(message, style="spheres", size=0.2)
    assert (balls.shape.form, balls.shape.size_m, balls.shape.size_px) == ("circle", 0.2, None)
    (placed,) = shown(message, style="squares", size=0.2)
    assert (placed.shape.form, placed.shape.size_m, placed.shape.size_px) == ("square", 0.2, None)
    (boxes,) = shown(message, style="boxes", size=0.2)
    assert (boxes.shape.kind, boxes.shape.size, boxes.shape.opacity) == ("box", (0.2, 0.2, 0.2), 1.0)
    (faint,) = shown(message, opacity=0.25)
    assert (faint.shape.kind, faint.shape.opacity) == ("ball", 0.25)
    assert faint.shape.colors.tolist() == [RED, VIOLET]
    (flat,) = shown(message, opacity=0.25, color_by="flat", color=(1, 2, 3))
    assert flat.shape.colors.tolist() == [[1, 2, 3]] * 2


def test_scan_has_intensities_and_ranges_to_choose_from() -> None:
    scan = LaserScan(header=header(), angle_increment=0.1, range_max=9.0, ranges=[1.0, 2.0, 3.0])
    display = display_of("sensor_msgs/msg/LaserScan")
    display.take(scan, S)
    assert display.choices == ("x", "y", "z", "range")
    assert display.shapes(S)[0].shape.colors.tolist() == [255, 70, 70]
    display.choice = "range"
    display.take(scan, S)
    assert display.shapes(S)[0].shape.colors.tolist()[::2] == [RED, VIOLET]
    scan.intensities = [5.0, 5.0, 9.0]
    assert colors_of(scan) == [RED, RED, VIOLET]


def test_pose_has_the_sizes_and_the_form_that_are_set() -> None:
    message = PoseStamped(header=header(), pose=pose(1.0))
    sizes = {"shaft_length": 2.0, "head_length": 0.5, "head_radius": 0.4}
    (arrow,) = shown(message, color=(1, 2, 3), opacity=0.5, **sizes)
    assert (arrow.shape.color, arrow.shape.opacity, arrow.position) == ((1, 2, 3), 0.5, (1.0, 0.0, 0.0))
    low, high = arrow.shape.vertices.min(axis=0), arrow.shape.vertices.max(axis=0)
    assert (low[0], high[0]) == (0.0, 2.5)
    assert high[1] == pytest.approx(0.4, abs=0.02)
    (axes,) = shown(message, shape="axes", axes_length=3.0, axes_radius=0.5)
    assert (axes.shape.length_m, axes.shape.radius_m) == (3.0, 0.5)
    faint = shown(message, shape="axes", axes_length=3.0, opacity=0.5)
    assert [part.shape.vertices.max(axis=0).argmax() for part in faint] == [0, 1, 2]
    assert [part.shape.color for part in faint] == [(255, 0, 0), (0, 255, 0), (0, 0, 255)]
    turned = pose(turn=(0.0, 0.0, math.sqrt(0.5), math.sqrt(0.5)))
    (arrows,) = shown(PoseArray(header=header(), poses=[pose(5.0), turned]), shape="arrow")
    assert arrows.shape.vertices.max(axis=0)[:2] == pytest.approx((5.3, 0.3), abs=1e-6)


def test_path_is_wide_transparent_and_has_poses_as_set() -> None:
    poses = [PoseStamped(pose=pose(float(x), 2.0 * x)) for x in range(3)]
    message = Path(header=header(), poses=poses)
    (wide,) = shown(message, line="wide", width=0.5)
    assert wide.shape.width_m == 0.5
    (faint,) = shown(message, opacity=0.5, line="wide", width=0.2, color=(1, 2, 3))
    assert (faint.shape.color, faint.shape.opacity) == ((1, 2, 3), 0.5)
    assert faint.shape.vertices[:, 2].max() <= 0.1001
    assert faint.shape.vertices.max(axis=0)[:2] == pytest.approx((2.09, 4.05), abs=0.01)
    assert len(faint.shape.faces) == 2 * 8
    _, arrows = shown(message, poses="arrows", pose_color=(9, 9, 9), head_diameter=1.0)
    assert arrows.shape.color == (9, 9, 9)
    assert arrows.shape.vertices[:, 2].max() == pytest.approx(0.5, abs=0.03)
    _, axes = shown(message, poses="axes")
    assert len(axes.shape.positions) == 3


def test_map_has_the_colours_and_the_opacity_that_are_set() -> None:
    info = MapMetaData(resolution=0.5, width=4, height=1, origin=pose())
    grid = OccupancyGrid(header=header(), info=info, data=[0, 100, 50, -1])

    def pixels(**settings: Any) -> Any:
        return shown(grid, **settings)[0].shape.pixels[0].tolist()

    assert pixels(opacity=0.5)[0] == [254, 254, 254, 128]
    assert pixels(binary=True, threshold=50)[2] == [0, 0, 0, 255]
    assert pixels(binary=True, threshold=51)[2] == [254, 254, 254, 255]
    assert pixels(colors="raw") == [
        [0, 0, 0, 255],
        [100, 100, 100, 255],
        [50, 50, 50, 255],
        [255, 255, 255, 255],
    ]
    clear, lethal, middle, _ = pixels(colors="costmap")
    assert (clear[3], lethal) == (0, [255, 0, 255, 255])
    assert middle[0] > 0 < middle[2]


def test_cells_and_twist_are_drawn() -> None:
    cells = GridCells(
        header=header("map"), cell_width=0.5, cell_height=1.0, cells=[Point(x=1.0), Point(y=math.nan)]
    )
    (squares,) = shown(cells, color=(1, 2, 3), opacity=0.5)
    assert (squares.shape.color, squares.shape.opacity, len(squares.shape.faces)) == ((1, 2, 3), 0.5, 2)
    assert squares.shape.vertices.min(axis=0).tolist() == [0.75, -0.5, 0.0]
    for wrong in (0.0, -1.0, math.nan, math.inf):
        with pytest.raises(shapes.DisplayError, match="have to be above zero"):
            shown(GridCells(cell_width=wrong, cell_height=1.0, cells=[Point()]))
    twist = TwistStamped(header=header("base"), twist=Twist(linear=Vector3(x=2.0), angular=Vector3(z=1.0)))
    linear, angular = shown(twist, angular_scale=10.0)
    assert linear.shape.vertices[:, 0].max() == pytest.approx(5.2)
    assert angular.shape.vertices[:, 2].max() == pytest.approx(13.0)
    twist.twist.linear.y = math.nan
    with pytest.raises(shapes.DisplayError, match="its linear is not finite"):
        shown(twist)


def test_namespace_that_is_hidden_is_not_shown() -> None:
    markers = [marker(Marker.CUBE, number, ns=name) for number, name in enumerate(("a", "b", "b"))]
    settings: dict[str, Any] = {"hidden_namespaces": ("b",)}
    display = make_display(KINDS["visualization_msgs/msg/MarkerArray"], "/m", settings)
    assert isinstance(display, MarkerDisplay)
    display.take(MarkerArray(markers=markers), S)
    assert (len(display.shapes(S)), display.parts()) == (1, ["a", "b"])
    settings["hidden_namespaces"] = ()
    assert len(display.shapes(S)) == 3


def test_robot_has_the_opacity_and_the_links_that_are_set() -> None:
    def box(part: str) -> str:
        return f'<{part}><geometry><box size="1 1 1"/></geometry></{part}>'

    links = "".join(f'<link name="{name}">{box("visual")}{box("collision")}</link>' for name in "ab")
    robot = String(data=f'<robot name="r">{links}</robot>')

    def drawn(**settings: Any) -> list[tuple[str, float]]:
        display = make_display(ROBOT, "/r", {**usual_values(ROBOT.settings), **settings})
        assert display is not None
        display.take(robot, S)
        return [(part.frame_id, part.shape.opacity) for part in display.shapes(S)]

    assert drawn() == [("a", 1.0), ("b", 1.0)]
    assert drawn(opacity=0.5, hidden_links=("a",)) == [("b", 0.5)]
    assert drawn(visual=False) == []
    assert drawn(visual=False, collision=True) == [("a", 0.6), ("b", 0.6)]
    assert len(drawn(collision=True)) == 4


def test_mesh_that_is_transparent_is_blended_and_a_damaged_one_stays() -> None:
    trimesh = pytest.importorskip("trimesh")
    glb = trimesh.creation.box().export(file_type="glb")
    faint = translucent(glb, 0.25)
    assert int.from_bytes(faint[8:12], "little") == len(faint)
    read = trimesh.load(io.BytesIO(faint), file_type="glb", force="mesh")
    assert len(read.vertices) == 8
    assert read.visual.material.baseColorFactor[3] == pytest.approx(64, abs=1)
    assert read.visual.material.alphaMode == "BLEND"
    for damaged in (b"", glb[:30], glb[:20] + b"[" * 5000, glb[:20] + b"null" + glb[24:]):
        assert translucent(damaged, 0.5) == damaged

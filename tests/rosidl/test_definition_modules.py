"""Packages on AMENT_PREFIX_PATH that hold definitions are imported with no build."""

from __future__ import annotations

import importlib
import os
import pickle
import sys
from pathlib import Path

import pytest
from tests.rosidl.workspaces import run_python, write_files

from tfloom import use_ros_names
from tfloom.interfaces.geometry_msgs.msg import Point
from tfloom.ros_imports.finder import InterfaceFinder
from tfloom.rosidl import cdr
from tfloom.rosidl.parse import ParseError
from tfloom.rosidl.registry import get_message_class, get_service_class
from tfloom.rosidl.service import Action, Service

FILES = {
    "my_interfaces/msg/Sphere.msg": "# A ball.\ngeometry_msgs/Point center\nfloat64 radius 1.0  # [m]\nuint8 BIG=3\n",
    "my_interfaces/msg/Pile.msg": "Sphere[] spheres\n",
    "my_interfaces/srv/Weigh.srv": "Sphere sphere\n---\nfloat64 mass\n",
    "my_interfaces/action/Roll.action": "float64 distance\n---\nfloat64 rolled\n---\nfloat64 now\n",
    "my_interfaces/msg/Broken.msg": "int32 fine\n\nint33 broken\n",
    "my_interfaces/msg/UsesBroken.msg": "Broken broken\n",
    "my_interfaces/msg/Latin.msg": b"# ok\n# \xe9\nint32 a\n",
    "my_interfaces/msg/Left.msg": "int32 a\nRight right\n",
    "my_interfaces/msg/Right.msg": "Left left\n",
    "my_interfaces/msg/Far.msg": "int32 a\nnowhere_msgs/Thing thing\n",
    "my_interfaces/msg/Near.msg": "geometry_msgs/Pointt point\n",
    "other_interfaces/msg/Holder.msg": "my_interfaces/Pile pile\n",
    "no_interfaces/launch/a.launch": "",
}


@pytest.fixture
def workspace(tmp_path: Path) -> Path:
    """Write the definitions below a prefix, and return it."""
    write_files(tmp_path / "share", FILES)
    return tmp_path


@pytest.fixture
def sourced(workspace: Path, monkeypatch: pytest.MonkeyPatch, forget_interfaces: None) -> Path:
    """Have that prefix on AMENT_PREFIX_PATH; forget afterwards what was imported."""
    monkeypatch.setenv("AMENT_PREFIX_PATH", os.pathsep.join(["/nowhere", str(workspace)]))
    use_ros_names()
    return workspace


def test_a_script_imports_them_before_rclpy(workspace: Path, tmp_path: Path) -> None:
    code = """
        from my_interfaces.msg import Sphere
        from my_interfaces.action import Roll
        import my_interfaces
        import rclpy, sys
        from tfloom.ros_imports.finder import InterfaceFinder
        print(Sphere(radius=2.0), Sphere.BIG, my_interfaces.srv.Weigh.Request, Roll.Impl.FeedbackMessage().feedback)
        assert any(isinstance(finder, InterfaceFinder) for finder in sys.meta_path)
    """
    empty = tmp_path / "empty"
    empty.mkdir()
    run = run_python(code, empty, AMENT_PREFIX_PATH=workspace)
    sphere = "my_interfaces.msg.Sphere(center=geometry_msgs.msg.Point(x=0.0, y=0.0, z=0.0), radius=2.0)"
    request = "<class 'my_interfaces.srv._weigh.Weigh_Request'>"
    feedback = "my_interfaces.action.Roll_Feedback(now=0.0)"
    assert (run.stdout, run.stderr) == (f"{sphere} 3 {request} {feedback}\n", "")


def test_a_python_that_no_workspace_was_sourced_for_has_no_finder(tmp_path: Path) -> None:
    code = """
        import sys
        print([finder for finder in sys.meta_path if "ros_imports.finder" in repr(finder)],
              [name for name in sys.modules if name.startswith("tfloom.")])
    """
    assert run_python(code, tmp_path, AMENT_PREFIX_PATH="").stdout == "[] []\n"


def test_the_finder_loads_nothing_before_it_is_needed(workspace: Path, tmp_path: Path) -> None:
    code = "import sys; print(*sorted(name for name in sys.modules if name.startswith('tfloom.')))"
    assert (
        run_python(code, tmp_path, AMENT_PREFIX_PATH=workspace).stdout
        == "tfloom.ros_imports tfloom.ros_imports.finder tfloom.ros_imports.guard\n"
    )


def test_a_module_of_that_name_comes_first(workspace: Path, tmp_path: Path) -> None:
    write_files(tmp_path / "path/my_interfaces", {"__init__.py": "", "msg.py": "Sphere = 'theirs'\n"})
    code = "from my_interfaces.msg import Sphere; from my_interfaces.srv import Weigh; print(Sphere, Weigh._TYPE_NAME)"
    run = run_python(code, tmp_path, AMENT_PREFIX_PATH=workspace, PYTHONPATH=tmp_path / "path")
    assert (run.stdout, run.stderr) == ("theirs my_interfaces/srv/Weigh\n", "")


def test_nothing_is_served_beside_another_rclpy(workspace: Path, tmp_path: Path) -> None:
    write_files(tmp_path / "path", {"rclpy/__init__.py": ""})
    run = run_python(
        "import my_interfaces", tmp_path, AMENT_PREFIX_PATH=workspace, PYTHONPATH=tmp_path / "path"
    )
    assert "\nModuleNotFoundError: No module named 'my_interfaces'" in run.stderr


@pytest.mark.usefixtures("sourced")
def test_they_are_classes_like_any() -> None:
    module = importlib.import_module("my_interfaces.msg")
    pile = module.Pile(spheres=[module.Sphere(center=Point(x=1.0))])
    assert cdr.decode(module.Pile, cdr.encode(pile)) == pile
    assert pickle.loads(pickle.dumps(pile)) == pile
    assert get_message_class("my_interfaces/msg/Sphere") is module.Sphere
    assert module.Sphere.__doc__ == "A ball."
    services = importlib.import_module("my_interfaces.srv")
    assert get_service_class("my_interfaces/Weigh") is services.Weigh
    assert services.Weigh.Request is services.Weigh_Request
    assert issubclass(services.Weigh, Service)
    assert issubclass(importlib.import_module("my_interfaces.action").Roll, Action)
    holder = importlib.import_module("other_interfaces.msg").Holder
    assert type(holder(pile=pile).pile) is module.Pile


@pytest.mark.usefixtures("sourced")
def test_what_a_module_lists() -> None:
    services = importlib.import_module("my_interfaces.srv")
    assert services.__all__ == ["Weigh", "Weigh_Event", "Weigh_Request", "Weigh_Response"]
    assert {"Weigh", "Weigh_Request", "__doc__"} <= set(dir(services))
    assert "Sphere" in dir(importlib.import_module("my_interfaces.msg"))
    assert hasattr(importlib.import_module("my_interfaces"), "msg")


@pytest.mark.usefixtures("sourced")
@pytest.mark.parametrize(
    "name", ["no_interfaces", "my_interfaces.launch", "my_interfaces.msg.deeper", "nothing"]
)
def test_what_holds_no_definitions_is_no_module(name: str) -> None:
    with pytest.raises(ModuleNotFoundError):
        importlib.import_module(name)


def test_names_that_are_no_definitions(sourced: Path) -> None:
    module = importlib.import_module("my_interfaces.msg")
    expected = rf"has no attribute 'Cube': {sourced}/share/my_interfaces has no msg/Cube\.msg"
    with pytest.raises(AttributeError, match=expected):
        module.Cube  # noqa: B018
    with pytest.raises(ImportError, match=r"cannot import name 'Cube' from 'my_interfaces\.msg'"):
        exec("from my_interfaces.msg import Cube")
    with pytest.raises(AttributeError, match="module 'my_interfaces' has no attribute 'launch'"):
        importlib.import_module("my_interfaces").launch  # noqa: B018


@pytest.mark.parametrize(
    ("name", "error"),
    [
        ("Broken", "Broken.msg:3:1: 'int33' is neither a primitive type nor a message's name"),
        ("UsesBroken", "Broken.msg:3:1: 'int33' is neither a primitive type nor a message's name"),
        ("Latin", "Latin.msg:2:3: octet 0xe9 isn't UTF-8 text"),
        (
            "Left",
            (
                "Right.msg:1:1: a message contains itself: "
                "my_interfaces/msg/Left -> my_interfaces/msg/Right -> my_interfaces/msg/Left"
            ),
        ),
        (
            "Far",
            (
                "Far.msg:2:1: there is no definition of 'nowhere_msgs/msg/Thing': "
                "the package 'nowhere_msgs' is neither on AMENT_PREFIX_PATH nor one of tfloom's own"
            ),
        ),
        ("Near", "Near.msg:1:1: there is no definition of 'geometry_msgs/msg/Pointt'"),
    ],
)
def test_a_broken_definition_names_file_and_line(sourced: Path, name: str, error: str) -> None:
    module = importlib.import_module("my_interfaces.msg")
    with pytest.raises(ParseError) as raised:
        getattr(module, name)
    assert str(raised.value) == f"{sourced}/share/my_interfaces/msg/{error}"
    assert module.Sphere().radius == 1.0


def test_a_package_of_tfloom_interfaces_that_is_not_installed(
    sourced: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    (sourced / "share/my_interfaces/msg/Goal.msg").write_text("nav2_msgs/Costmap map\n")
    monkeypatch.setattr("tfloom.rosidl.definition_files.find_prefix", lambda _distribution: None)
    with pytest.raises(
        ParseError, match=r"nav2_msgs comes with the distribution tfloom-interfaces, which is not"
    ):
        importlib.import_module("my_interfaces.msg").Goal  # noqa: B018


def test_messages_nested_too_deep(sourced: Path) -> None:
    files = {f"Deep{depth}.msg": f"Deep{depth + 1} a\nDeep{depth + 1} b\n" for depth in range(150)}
    write_files(sourced / "share/my_interfaces/msg", {**files, "Deep150.msg": "int32 a\n"})
    module = importlib.import_module("my_interfaces.msg")
    with pytest.raises(ParseError, match="messages are nested more than 100 deep"):
        module.Deep0  # noqa: B018
    # Two ways down at each level, and each message is looked at once.
    assert set(module.Deep60._FIELDS.values()) == {"my_interfaces/msg/Deep61"}


def test_use_ros_names_installs_one_finder() -> None:
    use_ros_names()
    use_ros_names()
    assert [type(finder) for finder in sys.meta_path].count(InterfaceFinder) == 1


@pytest.mark.usefixtures("sourced")
def test_a_definition_made_by_the_program_wins() -> None:
    from tfloom.rosidl.dynamic import define

    cls = define("my_interfaces/msg/Sphere", "int32 other")
    assert importlib.import_module("my_interfaces.msg").Sphere is cls

"""The site of `make docs`: it builds without a warning, and its API pages have every public module."""

from __future__ import annotations

import importlib
import inspect
import re
import sys
import sysconfig
from collections import Counter
from pathlib import Path
from typing import TYPE_CHECKING

import pytest
from tests.conftest import run_to_end
from tests.docs.page import DOCS

if TYPE_CHECKING:
    from collections.abc import Callable

ROOT = DOCS.parent
ROOMS = {"tf2": "tf2", "tf2_ros": "tf2_ros"}
"""The rooms of which every module is on an API page, but for the internal ones."""
CHOSEN = {"bag", "robot"}
"""API pages with those modules of a room that programs import; the others make its commands and programs."""
INTERNAL = {
    "tf2.html": "used by notebooks",
    "tf2_ros.annotation_types": "names for annotations",
    "tf2_ros.deadlines": "used by buffer",
    "tf2_ros.far_stamps": "used by transform_listener",
    "tf2_ros.numpy_compat": "used by point_cloud2",
}
"""Modules without an entry, and why."""
PAGES = [*ROOMS, *sorted(CHOSEN)]
PARTS = {"bag.metadata", "bag.reading.bag_file", "bag.writing.storage"}
"""Modules of which a page has some classes, which values of others have."""
NO_ENTRY = {
    "bag.writing.bag_writer.open_storage_file": "used by the writer of bags",
    "robot.description.JointRange": "used by joint_state_publisher",
    "robot.description.range_of": "used by joint_state_publisher",
    "robot.urdf.UrdfError": "it is in robot.urdf_faults",
    "robot.urdf_faults.Remarks": "collects the remarks while a text is read",
    "tf2.arrays.Arrays": "its methods are Buffer's",
    "tf2.frames.Frames": "its methods are Buffer's",
    "tf2.trajectory.chosen_stamps": "used by arrays",
    "tf2.velocity.Velocities": "its methods are Buffer's",
}
"""Public names without an entry, and why."""
PACKAGES = {
    "tfloom.bag": 9,
    "tf2_ros": 18,
    "tf2_geometry_msgs": 21,
    "tf2_sensor_msgs": 2,
    "sensor_msgs_py.point_cloud2": 7,
    "message_filters": 7,
    "tf_transformations": 41,
    "tf2_kdl": 8,
}
"""Packages that programs import, and how many of their names are classes and functions of the four rooms."""


def documented(page: str) -> set[str]:
    text = (DOCS / "api" / f"{page}.md").read_text("utf-8")
    directives = re.findall(r"^\.\. auto(module|class|function|data):: tfloom\.(\S+)", text, re.MULTILINE)
    return {name if kind == "module" else name.rpartition(".")[0] for kind, name in directives}


def test_every_public_module_has_an_entry() -> None:
    modules = {
        f"{room}.{'.'.join(path.relative_to(folder).with_suffix('').parts)}"
        for room in ROOMS
        for folder in [ROOT / "src" / "tfloom" / room]
        for path in folder.rglob("*.py")
        if path.name != "__init__.py" and not path.name.startswith("_")
    }
    entries = {name for page in ROOMS.values() for name in documented(page)}
    assert modules - entries == set(INTERNAL)
    assert entries <= modules
    for page in CHOSEN:
        assert len(documented(page)) >= 3
        for name in documented(page):
            assert (ROOT / "src" / "tfloom" / f"{name.replace('.', '/')}.py").is_file(), name


@pytest.fixture(scope="module")
def site(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """Build the site, without a warning, and return its folder."""
    pytest.importorskip("sphinx", reason="sphinx is not installed: make setup")
    folder = tmp_path_factory.mktemp("site")
    done = run_to_end(
        [sys.executable, "-m", "sphinx", "-q", "-W", "--keep-going", "-b", "html", DOCS, folder],
        cwd=ROOT,
        timeout_s=1500,
    )
    assert (done.returncode, done.stderr) == (0, "")
    return folder


def test_pages_are_read_from_the_sources_where_nothing_is_compiled() -> None:
    """The folder src comes first, which has no extension."""
    code = (
        "import sys; sys.path[:0] = sys.argv[1:]\n"
        "from docs import native_stub\n"
        "assert native_stub.use_if_not_compiled()\n"
        "import tfloom._native as native, tfloom.tf2.buffer, tfloom.tf2_ros.buffer, tfloom.robot.model, tfloom.bag\n"
        "print(native.__file__, native.Sink.push.__doc__.strip())\n"
    )
    done = run_to_end(
        [sys.executable, "-I", "-S", "-c", code, str(ROOT), str(ROOT / "src"), sysconfig.get_path("purelib")]
    )
    assert done.stderr == ""
    assert done.stdout.startswith(f"{ROOT / 'src' / 'tfloom' / '_native.pyi'} Push one sample")


def api_page(site: Path, name: str) -> str:
    return (site / "api" / f"{name}.html").read_text("utf-8")


def entries(site: Path) -> set[str]:
    """Return the names of all objects that the API pages describe."""
    return {
        name
        for page in PAGES
        for name in re.findall(r'<dt class="sig[^>]* id="([^"]+)"', api_page(site, page))
    }


def public_names(module: str) -> set[str]:
    """Return `__all__` of a module, or else its classes and functions."""
    loaded = importlib.import_module(module)
    if (listed := getattr(loaded, "__all__", None)) is not None:
        return set(listed)
    found = {
        name: value
        for name, value in vars(loaded).items()
        if not name.startswith("_") and (inspect.isclass(value) or inspect.isfunction(value))
    }
    return {name for name, value in found.items() if value.__module__ == module}


def exported(package: str) -> dict[str, str]:
    """Return the names of a package of programs, each with the object's own name, of objects of the four rooms."""
    loaded = importlib.import_module(package)
    values = {name: getattr(loaded, name) for name in dir(loaded) if not name.startswith("_")}
    own = {
        name: f"{defining_module(value)}.{value.__qualname__}"
        for name, value in values.items()
        if inspect.isclass(value) or inspect.isfunction(value)
    }
    rooms = tuple(f"tfloom.{page}." for page in PAGES)
    return {name: text for name, text in own.items() if text.startswith(rooms)}


def defining_module(value: type | Callable[..., object]) -> str:
    """Return the module of tfloom that defines a class or function: an error's `__module__` is its name in ROS."""
    if value.__module__.startswith("tfloom."):
        return value.__module__
    own = f"tfloom.{value.__module__}"
    return own if getattr(sys.modules.get(own), value.__name__, None) is value else value.__module__


@pytest.mark.slow
def test_site_needs_no_network(site: Path) -> None:
    page = api_page(site, "tf2")
    assert "https://" not in "".join(re.findall(r'<(?:script|link)[^>]*(?:src|href)="([^"]*)"', page))


@pytest.mark.slow
def test_every_public_name_has_an_entry(site: Path) -> None:
    documented_names = entries(site)
    modules = {name for page in PAGES for name in documented(page)} - PARTS
    assert len(modules) > 30
    missing = {
        f"{module}.{name}"
        for module in modules
        for name in public_names(f"tfloom.{module}")
        if f"tfloom.{module}.{name}" not in documented_names
    }
    assert missing == set(NO_ENTRY)


@pytest.mark.slow
@pytest.mark.parametrize("package", PACKAGES)
def test_every_exported_name_has_an_entry(site: Path, package: str) -> None:
    names = exported(package)
    assert len(names) >= PACKAGES[package]
    assert set(names.values()) <= entries(site)


@pytest.mark.slow
def test_names_of_entries_are_links(site: Path) -> None:
    """A class, method or function that a docstring names by its whole name is a link."""
    ends = Counter(end for name in entries(site) for end in (name, ".".join(name.rsplit(".", 2)[-2:])))
    for page in PAGES:
        text = api_page(site, page)
        plain = set(
            re.findall(r'(?<!">)<code class="xref py[^"]*"><span class="pre">([^<]+)</span></code>', text)
        )
        assert {name for name in plain if ends[name] == 1} == set()
        links = re.findall(r'<a class="reference internal" href="[^"]*#tfloom\.[^"]*"', text)
        assert len(links) >= 10


@pytest.mark.slow
def test_docstrings_are_rendered(site: Path) -> None:
    for page in PAGES:
        text = api_page(site, page)
        assert "system-message" not in text
        assert "Alias for field number" not in text, "a field without a docstring"
        signatures = " ".join(re.findall(r"<dt class=\"sig.*?</dt>", text, re.DOTALL))
        shown = re.sub(r"<[^>]+>", "", signatures)
        assert not re.findall(r"TypeAliasForwardRef|_NestedSequence|ndarray\[|\(self\b| object at 0x", shown)
        typed = r'id="([^"]+)"(?:(?!<dt class="sig).)*?<dt class="field-\w+">Type<'
        assert not re.findall(typed, text, re.DOTALL), "napoleon takes what precedes a colon for a type"

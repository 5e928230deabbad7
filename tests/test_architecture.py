"""The house's rules: imports point down the shelves, one door for each library, no ROS name inside.

Each rule of `tests/architecture.py` runs over the whole tree and lists its violations; and each finds a planted
violation in a tree of a few files.
"""

from __future__ import annotations

import os
import sys
from pathlib import Path

import pytest
from tests import architecture
from tests.architecture import HOUSE_RULES, INNER_ROOMS, NATIVE_RULES, SHELVES, Rule
from tests.conftest import run_to_end
from tools.native_readme import BEGIN

ROOT = Path(__file__).parents[1]
HOUSE = ROOT / "src" / "tfloom"
NATIVE = ROOT / "native"


def name_of(rule: Rule) -> str:
    return rule.__name__


@pytest.mark.parametrize(
    ("rule", "folder"),
    [*((rule, HOUSE) for rule in HOUSE_RULES), *((rule, NATIVE) for rule in NATIVE_RULES)],
    ids=lambda value: name_of(value) if callable(value) else "",
)
def test_code_keeps_each_rule(rule: Rule, folder: Path) -> None:
    findings = rule(folder)
    assert not findings, "\n".join(["", *findings])


def plant(folder: Path, files: dict[str, str]) -> Path:
    for name, text in files.items():
        path = folder / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, "utf-8")
    return folder


def sound_house(tmp_path: Path) -> Path:
    """Return a tree that keeps every rule: each room with a file, each library behind its door."""
    files = {
        f"{room}/__init__.py": '"""A room."""\n' for shelf in SHELVES for room in shelf if room != "_native"
    }
    files |= {
        f"{outer}/{room}/__init__.py": '"""A room."""\n'
        for outer, rooms in INNER_ROOMS.items()
        for room in rooms
        if room
    }
    files["_native.pyi"] = ""
    files["__init__.py"] = "import numpy, yaml\nif TYPE_CHECKING:\n    import typing_extensions\n"
    files["ros_names/rclpy/__init__.py"] = "from tfloom.node.node import Node\n"
    files["node/node.py"] = "from tfloom.node.values.time import Time\n"
    files["node/values/time.py"] = "class Time: ...\n"
    files["cli/main.py"] = "import argparse\n"
    for library, doors in architecture.DOORS.items():
        for door in doors:
            path = door if door.endswith(".py") else f"{door}imports_{library}.py"
            files[path] = files.get(path, "") + f"import {library}\n"
    return plant(tmp_path / "tfloom", files)


@pytest.mark.parametrize("rule", HOUSE_RULES, ids=name_of)
def test_sound_tree_is_accepted(rule: Rule, tmp_path: Path) -> None:
    assert rule(sound_house(tmp_path)) == []


VIOLATIONS: list[tuple[Rule, dict[str, str], list[str]]] = [
    (
        architecture.imports_point_down,
        {"rmw/wire.py": "def late():\n    from tfloom.node.node import Node\n"},
        ["rmw/wire.py:2 imports tfloom.node.node, which doesn't stand below rmw"],
    ),
    (
        architecture.imports_point_down,
        {"tf2/cdr.py": "import tfloom.rosidl.cdr\n", "tf2_ros/x.py": "from tfloom.workspace import ament\n"},
        [
            "tf2/cdr.py:1 imports tfloom.rosidl.cdr, which doesn't stand below tf2",
            "tf2_ros/x.py:1 imports tfloom.workspace, which doesn't stand below tf2_ros",
        ],
    ),
    (
        architecture.inner_rooms_point_down,
        {
            "node/qos/qos.py": (
                "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from tfloom.node.clock import clock\n"
            ),
            "node/builtin/service.py": "from tfloom.node.node import Node\n",
            "node/program.py": "from tfloom.node.action import client\n",
            "launch/core/event.py": "from tfloom.launch.logs import logging\nimport tfloom.launch.events.process\n",
            "launch/launch_service.py": "from tfloom.launch.ros import actions\n",
        },
        [
            "launch/core/event.py:2 imports tfloom.launch.events.process, which comes after launch/core",
            "launch/launch_service.py:1 imports tfloom.launch.ros, which comes after launch/",
            "node/builtin/service.py:1 imports tfloom.node.node, which comes after node/builtin",
            "node/program.py:1 imports tfloom.node.action, which comes after node/",
            "node/qos/qos.py:3 imports tfloom.node.clock, which comes after node/qos",
        ],
    ),
    (
        architecture.no_import_of_an_own_top,
        {"node/program.py": "from tfloom.node import init\n", "node/qos/qos.py": "import tfloom.node.qos\n"},
        [
            "node/program.py:1 imports tfloom.node, its own package's top; import the file that defines the thing",
            "node/qos/qos.py:1 imports tfloom.node.qos, its own package's top; import the file that defines the thing",
        ],
    ),
    (
        architecture.no_relative_import,
        {"tf2/buffer.py": "from .transform import Transform\n"},
        ["tf2/buffer.py:1 imports transform, relatively"],
    ),
    (
        architecture.no_ros_name,
        {
            "demos/talk.py": "from rclpy.node import Node\n",
            "drop_in/real.py": "import os\nimport_module('rclpy')\n",
            "tf2_ros/x.py": "import os\nimport_module('rclpy.time')\n",
        },
        [
            "demos/talk.py:1 imports rclpy.node, a ROS name; import it from its room in tfloom",
            "tf2_ros/x.py:2 imports rclpy.time at run time, a ROS name",
        ],
    ),
    (
        architecture.one_door_for_each_library,
        {
            "tf2_tools/show.py": "import pygame\n",
            "rmw/x.py": "import cyclonedds.core\nimport_module(f'PIL.{x}')\n",
        },
        [
            "rmw/x.py:1 imports cyclonedds, a library that has no door: add one to DOORS of tests/architecture.py",
            f"rmw/x.py:2 imports PIL; its door is {' or '.join(architecture.DOORS['PIL'])}",
            "tf2_tools/show.py:1 imports pygame; its door is turtlesim/window.py",
        ],
    ),
    (
        architecture.no_type_checkers_library_at_run_time,
        {
            "tf2/x.py": "from typing_extensions import Self\n",
            "rmw/x.py": "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    from typing_extensions import Self\n",
        },
        ["tf2/x.py:1 imports typing_extensions at run time"],
    ),
    (
        architecture.no_ring,
        {
            "workspace/a.py": "import tfloom.workspace.b\n",
            "workspace/b.py": "import tfloom.workspace.c\n",
            "workspace/c.py": "import tfloom.workspace.a\n",
            "node/log/x.py": "if TYPE_CHECKING:\n    from tfloom.node.log import y\n",
            "node/log/y.py": "def f():\n    import tfloom.node.log.x\n",
            "turtlesim/x.py": "if TYPE_CHECKING:\n    import tfloom.turtlesim.y\n",
            "turtlesim/y.py": "import tfloom.turtlesim.x\n",
        },
        [
            "a ring: tfloom.node.log.x, tfloom.node.log.y",
            "a ring: tfloom.turtlesim.x, tfloom.turtlesim.y",
            "a ring: tfloom.workspace.a, tfloom.workspace.b, tfloom.workspace.c",
        ],
    ),
    (
        architecture.a_top_holds_its_docstring_alone,
        {"node/qos/__init__.py": '"""A room."""\nfrom tfloom.node.qos.qos import QoSProfile\n'},
        ["node/qos/__init__.py holds more than its docstring"],
    ),
    (
        architecture.listed_files_exist,
        {
            "rmw/__init__.py": (
                '"""A wire.\n\n- base, local*: both are there\n- old/, wire: neither is\n'
                '    with base: an example\n"""\n'
            ),
            "rmw/base.py": "",
            "rmw/local_services.py": "",
        },
        ["rmw/__init__.py lists old/, which isn't there", "rmw/__init__.py lists wire, which isn't there"],
    ),
    (
        architecture.each_room_has_its_place,
        {"stage/reader.py": "", "node/helpers/x.py": "", "launch/helpers/x.py": ""},
        [
            "launch/helpers/ has no place: add it to the list of launch/__init__.py",
            "node/helpers/ has no place: add it to the list of node/__init__.py",
            "stage/ stands on no shelf: add it to SHELVES of tests/architecture.py",
        ],
    ),
    (
        architecture.the_command_line_starts_without_the_rooms,
        {"cli/main.py": "import argcomplete\nfrom tfloom.node.node import Node\n"},
        ["cli/main.py:2 imports tfloom.node.node, which every command would load"],
    ),
    (
        architecture.one_door_for_reading_yaml,
        {
            "cli/x.py": "def f():\n    import yaml\n    return yaml.safe_load('1'), yaml.safe_dump(1)\n",
            "node/x.py": "import yaml as y\n",
            "common/yaml.py": "import yaml\nyaml.safe_load('1')\n",
            "workspace/x.py": "from yaml import CSafeLoader, safe_dump\n",
        },
        [
            "cli/x.py:3 reads YAML by yaml.safe_load",
            "node/x.py:1 reads YAML by yaml.load",
            "workspace/x.py:1 reads YAML by yaml.CSafeLoader",
        ],
    ),
    (
        architecture.files_are_written_whole,
        {
            "cli/x.py": "path.write_text('')\nopen(path, 'rb')\nopen(path, 'xb')\n",
            "tf2/x.py": "path.write_bytes(b'')\npath.open(\"w\")\n",
            "common/files.py": "open(path, 'wb')\n",
        },
        [
            f"{place} writes a file in place; use common/files.py"
            for place in ("cli/x.py:1", "cli/x.py:3", "tf2/x.py:1", "tf2/x.py:2")
        ],
    ),
    (
        architecture.services_are_asked_in_one_way,
        {
            "bag/playing/played_requests.py": "wire.create_requester(node)\n",
            "viewer/x.py": "\nopen_client(wire.create_requester)\n",
            "cli/x.py": "participant.create_requester(node, service, qos)\n",
        },
        [
            f"{place} opens a client of a wire; use rmw/shared/service_request.py"
            for place in ("cli/x.py:1", "viewer/x.py:2")
        ],
    ),
    (
        architecture.what_is_said_on_stderr_ends_nothing,
        {
            "rmw/x.py": "import sys\nprint('a', file=sys.stderr)\nsys.stderr.write('b')\n",
            "common/terminal.py": "import sys\ndef report(text):\n    print(text, file=sys.stderr)\n",
        },
        [
            "rmw/x.py:2 prints on stderr; use `report` of common/terminal.py",
            "rmw/x.py:3 prints on stderr; use `report` of common/terminal.py",
        ],
    ),
    (
        architecture.no_users_code_under_a_lock,
        {
            "rmw/local/ends.py": "def give(sink):\n    sink.push()\ndef other():\n    give(sink)\n",
            "rmw/x.py": (
                "from tfloom.rmw.local.ends import give\n"
                "def deliver(self):\n    give(self.sink)\n"
                "def write(self):\n    with self._lock:\n"
                "        later = lambda: give(self.sink)\n        self.deliver()\n"
                "    self.deliver()\n"
                "    with open(path):\n        callback()\n"
                "    with lock:\n        callback()\n"
            ),
            "rmw/y.py": "def write(self):\n    with self._lock:\n        self.deliver()\n",
        },
        [
            "rmw/x.py:12 calls callback under a lock",
            "rmw/x.py:7 calls deliver, give, push under a lock",
        ],
    ),
]


@pytest.mark.parametrize(
    ("rule", "files", "findings"), VIOLATIONS, ids=[rule.__name__ for rule, _, _ in VIOLATIONS]
)
def test_planted_violation_is_found(
    rule: Rule, files: dict[str, str], findings: list[str], tmp_path: Path
) -> None:
    assert sorted(rule(plant(sound_house(tmp_path), files))) == findings


def test_name_of_a_missing_room_or_library_is_found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    house = sound_house(tmp_path)
    monkeypatch.setattr(architecture, "SHELVES", [*SHELVES, ["stage"]])
    monkeypatch.setattr(
        architecture, "INNER_ROOMS", INNER_ROOMS | {"node": [*INNER_ROOMS["node"], "helpers"]}
    )
    monkeypatch.setattr(architecture, "DOORS", architecture.DOORS | {"rerun": ("viewer/",)})
    monkeypatch.setattr(architecture, "EVERYWHERE", architecture.EVERYWHERE | {"scipy"})
    assert architecture.nothing_is_named_that_does_not_exist(house) == [
        "SHELVES names stage",
        "INNER_ROOMS names node/helpers",
        "DOORS names rerun",
        "EVERYWHERE names scipy",
    ]


NATIVE_VIOLATIONS: list[tuple[Rule, dict[str, str], list[str]]] = [
    (
        architecture.the_readme_lists_each_file,
        {
            "README.md": f"| `core/` | queues |\n\n{BEGIN}\n## core/\n\n- `a`: A queue\n",
            "core/a.hpp": "// A queue. It has an end.\n",
            "core/b.hpp": "// Another one.\n",
        },
        ["README.md differs from the files: run `python -m tools.native_readme`"],
    ),
    (
        architecture.the_native_core_knows_no_python,
        {"core/a.hpp": "#include <Python.h>\n", "tf2/b.cpp": "dlopen();\n", "dds/c.cpp": "dlopen();\n"},
        ["core/a.hpp includes Python", "tf2/b.cpp calls dlopen; libddsc has one door, native/dds"],
    ),
    (
        architecture.native_rooms_point_down,
        {
            "core/a.hpp": '#include "core/b.hpp"\n#include "tf2/c.hpp"\n',
            "cdr/d.cpp": '#include "tf2/c.hpp"\n',
        },
        ["core/a.hpp includes tf2/"],
    ),
    (
        architecture.one_door_to_the_gil,
        {
            "bindings/gil.cpp": "PyGILState_Ensure();\n",
            "bindings/x.cpp": "nb::gil_scoped_acquire gil;\nPy_BEGIN_ALLOW_THREADS\n",
        },
        [
            "bindings/x.cpp uses Py_BEGIN_ALLOW_THREADS; use bindings/gil.hpp",
            "bindings/x.cpp uses gil_scoped_acquire; use bindings/gil.hpp",
        ],
    ),
    (
        architecture.whoever_catches_all_rethrows,
        {
            "tf2/a.cpp": (
                "try { f(); } catch (...) {\n  close();\n  throw;\n}\n"
                "try { f(); } catch (...) { log(); }\ntry { f(); } catch (...) { if (x) { throw; } }\n"
            )
        },
        ["tf2/a.cpp:5 catches all, and goes on", "tf2/a.cpp:6 catches all, and goes on"],
    ),
    (
        architecture.no_python_under_a_native_lock,
        {
            "tf2/a.hpp": (
                "using Notify = std::function<void()>;\n"
                "class Waiters {\n  void add();\n  void complete();\n  Notify notify_;\n};\n"
            ),
            "tf2/a.cpp": (
                '#include "tf2/a.hpp"\n'
                "void Waiters::complete() { notify_(); }  // without a lock\n"
                "void Waiters::add() {\n"
                "  {\n    const std::lock_guard lock(mutex_);\n    ++count_;  // notify_()\n  }\n"
                "  complete();\n"
                "  std::unique_lock lock(mutex_);\n"
                "  lock.unlock();\n  notify_();\n  lock.lock();\n"
                "  if (count_ > 0) {\n    complete();\n  }\n"
                "}\n"
            ),
            "bindings/b.cpp": (
                '#include "tf2/a.hpp"\n'
                "void take(Waiters& waiters) {\n"
                "  const ReadLock lock(mutex);\n  PyErr_Clear();\n  waiters.complete();\n}\n"
                "void store() {\n  const std::lock_guard lock(mutex);\n  sink->push(data);\n}\n"
                "void feed() {\n  const std::lock_guard lock(mutex);\n"
                "  const DeferredQueue::Scope scope(feeder);\n  sink->push(data);\n}\n"
            ),
        },
        [
            "bindings/b.cpp:3 calls PyErr_Clear under a lock",
            "bindings/b.cpp:3 calls complete, notify_ under a lock",
            "bindings/b.cpp:8 calls sink->push under a lock",
            "tf2/a.cpp:12 calls complete, notify_ under a lock",
        ],
    ),
]


@pytest.mark.parametrize(
    ("rule", "files", "findings"), NATIVE_VIOLATIONS, ids=[rule.__name__ for rule, _, _ in NATIVE_VIOLATIONS]
)
def test_planted_native_violation_is_found(
    rule: Rule, files: dict[str, str], findings: list[str], tmp_path: Path
) -> None:
    assert rule(plant(tmp_path, files)) == findings


def test_a_readme_with_every_file_is_accepted_and_a_file_without_a_comment_is_named(tmp_path: Path) -> None:
    head = f"| `core/` | queues |\n\n{BEGIN}"
    files = {
        "README.md": f"{head}\n## core/\n\n- `a`: A queue\n",
        "core/a.hpp": "// A queue. It has an end.\n",
    }
    native = plant(tmp_path, files | {"core/a.cpp": '#include "core/a.hpp"\n'})
    assert architecture.the_readme_lists_each_file(native) == []
    plant(tmp_path, {"core/b.cpp": "int b;\n"})
    assert architecture.the_readme_lists_each_file(native) == [
        "native/core/b.cpp doesn't begin with a comment that says what it is for"
    ]


def test_each_rule_has_a_planted_violation() -> None:
    planted = [rule for rule, _, _ in VIOLATIONS + NATIVE_VIOLATIONS]
    planted.append(architecture.nothing_is_named_that_does_not_exist)  # has a separate test
    assert set(planted) == {*HOUSE_RULES, *NATIVE_RULES}


def modules_loaded_by(*arguments: str, **environment: str) -> set[str]:
    """Run Python and return the names of all modules that it imported."""
    command = [sys.executable, "-X", "importtime", *arguments]
    result = run_to_end(command, timeout_s=60, env=os.environ | environment)
    assert result.returncode == 0, result.stderr
    return {
        line.rsplit("|", 1)[1].strip()
        for line in result.stderr.splitlines()
        if line.startswith("import time:")
    }


def test_tf2_alone_loads_no_messages_and_no_wire() -> None:
    loaded = modules_loaded_by("-c", "import tfloom.tf2.buffer")
    assert not {name for name in loaded if name.startswith(("tfloom.rosidl", "tfloom.rmw", "tfloom.node"))}


HEAVY = {"numpy", "pygame", "PIL", "reportlab", "yaml", "asyncio"}


@pytest.mark.parametrize(
    ("arguments", "heavy"),
    [
        (["--help"], HEAVY),
        (
            ["topic", "list", "--spin-time", "0.2"],
            HEAVY | {"pathlib", "socket", "difflib", "tfloom.rmw.shared.endpoint_text"},
        ),
        (["launch", "--help"], HEAVY | {"tfloom._native"}),
    ],
    ids=["help", "topic list", "launch"],
)
def test_quick_command_loads_no_heavy_module(arguments: list[str], heavy: set[str], domain_id: int) -> None:
    loaded = modules_loaded_by("-m", "tfloom", *arguments, ROS_DOMAIN_ID=str(domain_id))
    assert not loaded & heavy

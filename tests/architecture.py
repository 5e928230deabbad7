"""The rules of the architecture, each a function that takes a source tree and returns its violations, as texts.

`house` is the folder of a package named `tfloom`, the real one or one made by a test; `native` is the C++ folder.
"""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Callable
from functools import lru_cache
from pathlib import Path

from tests import native_locks
from tests.import_graph import Import, Kind, imports_of_file, rings
from tools import native_readme

SHELVES = [
    ["_native", "common", "ros_imports"],
    ["rosidl", "interfaces", "tf2", "kdl"],
    ["rmw"],
    ["node"],
    ["tf2_ros", "workspace"],
    ["bag"],
    ["tf2_tools", "turtlesim", "robot", "demos", "drop_in", "launch"],
    ["viewer", "foxglove"],
    ["cli", "pyinstaller", "testing"],
]
"""The rooms, from the bottom up; rooms on one shelf don't import each other, except those of UPWARDS."""

UPWARDS = {("interfaces", "rosidl"), ("ros_imports", "rosidl")}
"""Rooms that may import one not below them: the classes their base, and the import hook what makes classes."""

NODE = Path(__file__).parents[1] / "src" / "tfloom" / "node"


def rooms_in_order(folder: Path) -> list[str]:
    """Return the folders that the docstring of a room's `__init__.py` lists, and "" where its first file stands."""
    text = ast.get_docstring(ast.parse((folder / "__init__.py").read_text("utf-8"))) or ""
    names = [
        name.strip("/") if name.endswith("/") else ""
        for row in LISTED.findall(text)
        for name in row.split(", ")
    ]
    return list(dict.fromkeys(names))


LISTED = re.compile(r"^- ([\w/*]+(?:, [\w/*]+)*): ", re.MULTILINE)
"""A row of the list of files in a room's docstring: `- text/, echo: what they are for`."""
NODE_ROOMS = rooms_in_order(NODE)
"""The rooms inside node/, from the bottom up, as its docstring lists them; "" are the files beside them."""

LAUNCH_ROOMS = rooms_in_order(NODE.parent / "launch")
"""The rooms inside launch/, as NODE_ROOMS."""

INNER_ROOMS = {"node": NODE_ROOMS, "launch": LAUNCH_ROOMS}
"""The rooms that have rooms inside with an order."""

DOORS = {
    "pygame": ("turtlesim/window.py",),
    "reportlab": ("tf2_tools/drawing/",),
    "rich": ("tf2_tools/top/", "viewer/scene_server.py"),
    "argcomplete": ("cli/tab_key.py",),
    "PIL": ("turtlesim/picture.py", "tf2_tools/drawing/png.py", "viewer/pictures.py"),
    "viser": ("viewer/",),
    "websockets": (
        "viewer/page_server.py",
        "foxglove/own_client.py",
        "foxglove/relay.py",
    ),
    "msgspec": ("viewer/viser_private.py",),
    "trimesh": ("viewer/",),
    "foxglove": ("foxglove/",),
    "psutil": ("launch/processes/",),
    "transforms3d": ("tf2_ros/transformations/transformations.py",),
    "pandas": ("tf2/trajectory.py",),
    "lz4": ("bag/reading/compression.py",),
    "zstandard": ("bag/reading/compression.py",),
    "zenoh": ("rmw/zenoh/",),
    "xxhash": ("rmw/zenoh/",),
    "PyInstaller": ("pyinstaller/",),
    "xacro": ("robot/xacro_program.py",),
    "pytest": ("launch/testing/", "testing/plugin.py"),
    "catkin_pkg": ("workspace/colcon/",),
    "colcon_core": ("workspace/colcon/",),
    "colcon_parallel_executor": ("workspace/colcon/",),
    "colcon_ros": ("workspace/colcon/",),
}
"""Where each third-party library may be imported: one file or folder of a room, or files whose names begin alike."""

EVERYWHERE = {"numpy", "yaml"}
"""Third-party libraries that any file may import."""

ANNOTATIONS_ONLY = "typing_extensions"
"""The library that any file may import for type checkers alone, because tfloom doesn't install it."""

NATIVE_ROOMS = {
    "core": set[str](),
    "tf2": {"core"},
    "kdl": {"tf2"},
    "cdr": {"core", "tf2"},
    "bag": {"core", "tf2", "cdr"},
    "robot": {"core", "tf2", "cdr"},
    "rtps": {"core"},
    "dds": {"core", "rtps"},
}
"""The rooms of native/ that know no Python, and what each may include."""

ROS_DOORS = ("drop_in/", "ros_imports/guard.py")
"""Where a ROS name may be imported at run time, by a string: those of a real ROS 2, which may be absent."""

NO_ROOMS = {"__pycache__", "ros_names", "share"}
"""Folders that hold no code of the house; `share` has the files of tfloom's own packages, as launch files."""

LAUNCH_FILE = ".launch.py"
"""The end of a launch file's name. It imports ROS names, as a user's, and is not a module."""


@lru_cache(maxsize=4)
def imports(house: Path) -> list[Import]:
    """Return all imports of a source tree, of each kind, except those of the façades and of launch files."""
    return [
        statement
        for path in sorted(house.rglob("*.py"))
        if {"ros_names", "share"}.isdisjoint(path.relative_to(house).parts)
        and not path.name.endswith(LAUNCH_FILE)
        for statement in imports_of_file(path, house.parent)
    ]


@lru_cache(maxsize=4)
def libraries(house: Path) -> list[tuple[Path, int, str]]:
    """Return file, line and name of each imported top-level package, `import_module("name…")` included."""
    imported_libraries = [
        (statement.path, statement.line, statement.imported.split(".")[0])
        for statement in imports(house)
        if not statement.level
    ]
    for path in {statement.path for statement in imports(house)}:
        text = path.read_text("utf-8")
        imported_libraries += [
            (path, text.count("\n", 0, match.start()) + 1, match.group(1))
            for match in re.finditer(r"""import_module\(f?["'](\w+)""", text)
        ]
    return imported_libraries


def _where(house: Path, statement: Import) -> str:
    return f"{statement.path.relative_to(house).as_posix()}:{statement.line} imports {statement.imported}"


def _shelf(room: str) -> int | None:
    return next((number for number, rooms in enumerate(SHELVES) if room in rooms), None)


def _room(dotted: str) -> str:
    return dotted.split(".")[1] if dotted.startswith("tfloom.") else ""


def imports_point_down(house: Path) -> list[str]:
    """A room imports only rooms on lower shelves, and those that UPWARDS allows it."""
    violations = []
    for statement in imports(house):
        here, there = _room(statement.importer), _room(statement.imported)
        shelf_here, shelf_there = _shelf(here), _shelf(there)
        if shelf_here is None or shelf_there is None or here == there:
            continue
        if shelf_there >= shelf_here and (here, there) not in UPWARDS:
            violations.append(f"{_where(house, statement)}, which doesn't stand below {here}")
    return violations


def inner_rooms_point_down(house: Path) -> list[str]:
    """Inside node/ and launch/ a room imports only itself and the rooms before it in INNER_ROOMS."""

    def level(outer: str, dotted: str) -> int | None:
        parts = dotted.split(".")
        if parts[:2] != ["tfloom", outer] or len(parts) < 3:
            return None
        room = parts[2] if (house / outer / parts[2]).is_dir() else ""
        return INNER_ROOMS[outer].index(room) if room in INNER_ROOMS[outer] else None

    violations = []
    for outer, rooms in INNER_ROOMS.items():
        for statement in imports(house):
            here, there = level(outer, statement.importer), level(outer, statement.imported)
            if here is not None and there is not None and there > here:
                violations.append(f"{_where(house, statement)}, which comes after {outer}/{rooms[here]}")
    return violations


def no_import_of_an_own_top(house: Path) -> list[str]:
    """A module imports the file that defines a name, never a package that contains the module."""
    violations = []
    for statement in imports(house):
        parts = statement.path.relative_to(house.parent).with_suffix("").parts
        if statement.imported in {".".join(parts[:end]) for end in range(2, len(parts))}:
            violations.append(
                f"{_where(house, statement)}, its own package's top; import the file that defines the thing"
            )
    return violations


def no_relative_import(house: Path) -> list[str]:
    """Imports are absolute."""
    return [f"{_where(house, statement)}, relatively" for statement in imports(house) if statement.level]


def no_ros_name(house: Path) -> list[str]:
    """No module of the house imports a façade, whose names are those of `ros_names/` and of ROS.

    Names of a real ROS 2 are imported by strings, at run time, and only in ROS_DOORS.
    """
    names = {path.name for path in (house / "ros_names").glob("*") if path.is_dir()}
    violations = [
        f"{_where(house, statement)}, a ROS name; import it from its room in tfloom"
        for statement in imports(house)
        if statement.imported.split(".")[0] in names
    ]
    by_string = re.compile(r"""(?:import_module|__import__|real_ros\.\w+)\(\s*f?["']([\w.]+)""")
    for path in sorted({statement.path for statement in imports(house)}):
        place = path.relative_to(house).as_posix()
        text = path.read_text("utf-8")
        violations += [
            f"{place}:{text.count(chr(10), 0, match.start()) + 1} imports {match.group(1)} at run time, a ROS name"
            for match in by_string.finditer(text)
            if match.group(1).split(".")[0] in names and not place.startswith(ROS_DOORS)
        ]
    return violations


NEWER_STANDARD = {"annotationlib"}
"""Modules of Python that this Python may not have yet."""


def one_door_for_each_library(house: Path) -> list[str]:
    """A third-party library is imported by its doors alone, one in a room, and each has such a door."""
    known = sys.stdlib_module_names | NEWER_STANDARD | EVERYWHERE | {"tfloom", ANNOTATIONS_ONLY}
    known |= {path.name for path in (house / "ros_names").glob("*")}  # another rule's
    violations = []
    for path, line, library in libraries(house):
        place = path.relative_to(house).as_posix()
        where = f"{place}:{line} imports {library}"
        if library in known:
            continue
        doors = DOORS.get(library)
        if doors is None:
            violations.append(
                f"{where}, a library that has no door: add one to DOORS of tests/architecture.py"
            )
        elif not place.startswith(doors):
            violations.append(f"{where}; its door is {' or '.join(doors)}")
    return violations


def no_type_checkers_library_at_run_time(house: Path) -> list[str]:
    """`typing_extensions` is imported under `if TYPE_CHECKING:` alone."""
    return [
        f"{_where(house, statement)} at run time"
        for statement in imports(house)
        if statement.imported.split(".")[0] == ANNOTATIONS_ONLY and statement.kind is not Kind.ANNOTATION
    ]


def no_ring(house: Path) -> list[str]:
    """No modules import each other in a ring: neither when they are loaded or called, nor for annotations."""
    return [f"a ring: {', '.join(ring)}" for ring in rings(imports(house), Kind.ANNOTATION)]


def a_top_holds_its_docstring_alone(house: Path) -> list[str]:
    """The `__init__.py` of node/ and of its rooms holds a docstring, so that importing one file loads no others."""
    violations = []
    for path in sorted((house / "node").rglob("__init__.py")):
        body = ast.parse(path.read_text("utf-8")).body
        if any(not isinstance(statement, ast.Expr) for statement in body) or len(body) > 1:
            violations.append(f"{path.relative_to(house).as_posix()} holds more than its docstring")
    return violations


def listed_files_exist(house: Path) -> list[str]:
    """The files and folders that the docstring of a room's `__init__.py` lists are there."""
    return [
        f"{path.relative_to(house).as_posix()} lists {name}, which isn't there"
        for path in sorted(house.rglob("__init__.py"))
        if "ros_names" not in path.parts
        for names in LISTED.findall(ast.get_docstring(ast.parse(path.read_text("utf-8"))) or "")
        for name in names.split(", ")
        if not any(path.parent.glob(name.rstrip("/") if name.endswith("/") else f"{name}.py"))
    ]


def _folders(path: Path) -> set[str]:
    return {entry.name for entry in path.iterdir() if entry.is_dir()} - NO_ROOMS


def each_room_has_its_place(house: Path) -> list[str]:
    """Each folder of the house is on a shelf, and each one of node/ and launch/ in INNER_ROOMS."""
    named = {room for rooms in SHELVES for room in rooms}
    violations = [
        f"{room}/ stands on no shelf: add it to SHELVES of tests/architecture.py"
        for room in sorted(_folders(house) - named)
    ]
    violations += [
        f"{outer}/{room}/ has no place: add it to the list of {outer}/__init__.py"
        for outer, rooms in INNER_ROOMS.items()
        for room in sorted(_folders(house / outer) - set(rooms))
    ]
    return violations


def nothing_is_named_that_does_not_exist(house: Path) -> list[str]:
    """Each room of SHELVES and INNER_ROOMS exists, and each library of DOORS is imported by its door."""
    rooms = _folders(house) | {path.stem for path in house.glob("*.pyi")}
    violations = [f"SHELVES names {room}" for shelf in SHELVES for room in shelf if room not in rooms]
    violations += [
        f"INNER_ROOMS names {outer}/{room}"
        for outer, inner_rooms in INNER_ROOMS.items()
        for room in inner_rooms
        if room and not (house / outer / room).is_dir()
    ]
    used = {library for _, _, library in libraries(house)}
    violations += [f"DOORS names {library}" for library in DOORS if library not in used]
    violations += [f"EVERYWHERE names {library}" for library in sorted(EVERYWHERE - used)]
    return violations


YAML_DOOR = ("common/yaml.py", "common/yaml_scanner.py")
"""Where YAML is read: the file that has the limits, and what it reads with."""


def one_door_for_reading_yaml(house: Path) -> list[str]:
    """Only `YAML_DOOR` calls or imports a name of yaml that reads: `yaml.safe_load`, `yaml.compose`, a loader."""
    reads = re.compile(r"load|compose|parse|scan|loader", re.IGNORECASE)
    violations = []
    for path in sorted(house.rglob("*.py")):
        place = path.relative_to(house).as_posix()
        text = path.read_text("utf-8")
        if place in YAML_DOOR or not re.search(r"\byaml\b", text):
            continue
        for node in ast.walk(ast.parse(text)):
            if (
                isinstance(node, ast.Attribute)
                and isinstance(node.value, ast.Name)
                and node.value.id == "yaml"
            ):
                names = [node.attr]
            elif isinstance(node, ast.ImportFrom) and (node.module or "").split(".")[0] == "yaml":
                names = [alias.name for alias in node.names]
            elif isinstance(node, ast.Import):
                names = [alias.asname or "" for alias in node.names if alias.name.split(".")[0] == "yaml"]
                names = ["load"] if any(names) else []  # another name would hide its calls
            else:
                continue
            violations += [
                f"{place}:{node.lineno} reads YAML by yaml.{name}" for name in names if reads.search(name)
            ]
    return violations


FILE_WRITERS = {
    "common/files.py",
    "node/log/log_file.py",
    "bag/writing/compression.py",  # files that grow for as long as a recording lasts
    "bag/writing/sqlite_file.py",
}
"""What may open a file to write: the writer of whole files, and the log."""


def files_are_written_whole(house: Path) -> list[str]:
    """Only FILE_WRITERS open a file to write, because others would leave half a file on a full disk."""
    writes = re.compile(r"""\.write_(?:text|bytes)\(|\bopen\([^()]*["'][wxa]b?\+?["']""")
    violations = []
    for path in sorted(house.rglob("*.py")):
        place = path.relative_to(house).as_posix()
        if place in FILE_WRITERS:
            continue
        text = path.read_text("utf-8")
        lines = [text.count("\n", 0, match.start()) + 1 for match in writes.finditer(text)]
        violations += [f"{place}:{line} writes a file in place; use common/files.py" for line in lines]
    return violations


STDERR_WRITERS = {
    "common/terminal.py",
    "bag/progress.py",  # a line that is drawn anew, on terminals alone
    "workspace/copyright.py",  # results, some of which are errors
    "workspace/lint.py",  # the output of another program
}
"""What may print on stderr, beside the function that every warning goes through."""


def what_is_said_on_stderr_ends_nothing(house: Path) -> list[str]:
    """Only `report` prints on stderr, because `print` raises where it is full, and takes stdout where it is closed."""
    prints = re.compile(r"file=sys\.stderr|\bstderr\.write\(")
    violations = []
    for path in sorted(house.rglob("*.py")):
        place = path.relative_to(house).as_posix()
        if place in STDERR_WRITERS:
            continue
        text = path.read_text("utf-8")
        lines = [text.count("\n", 0, match.start()) + 1 for match in prints.finditer(text)]
        violations += [
            f"{place}:{line} prints on stderr; use `report` of common/terminal.py" for line in lines
        ]
    return violations


REQUESTERS = {
    "rmw/shared/service_request.py",
    "node/base/node_base.py",
    "node/implementation.py",
    "bag/playing/played_goals.py",  # sends what was recorded to servers that may never answer
    "bag/playing/played_requests.py",  # sends what was recorded, and awaits no response
}
"""What may open a client of a wire: the request without a node, a node's client, and what awaits no response."""


def services_are_asked_in_one_way(house: Path) -> list[str]:
    """Only REQUESTERS open a client of a wire, because others would judge by themselves when its server is gone."""
    opens = re.compile(r"\.create_requester\b")
    violations = []
    for path in sorted(house.rglob("*.py")):
        place = path.relative_to(house).as_posix()
        if place in REQUESTERS:
            continue
        text = path.read_text("utf-8")
        lines = [text.count("\n", 0, match.start()) + 1 for match in opens.finditer(text)]
        violations += [
            f"{place}:{line} opens a client of a wire; use rmw/shared/service_request.py" for line in lines
        ]
    return violations


CALLS_OUT = {"push", "forget", "run_waiting", "set_result", "add_done_callback", "callback", "function"}
"""Names of what calls users' functions: methods of native sinks, methods of futures, and callbacks."""


def _called(tree: ast.AST) -> list[tuple[str, int]]:
    """Return the name and line of each call in a tree, but for those in functions that it defines."""
    found = []
    for node in ast.iter_child_nodes(tree):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)):
            continue
        if isinstance(node, ast.Call) and isinstance(node.func, (ast.Attribute, ast.Name)):
            name = node.func.attr if isinstance(node.func, ast.Attribute) else node.func.id
            found.append((name, node.lineno))
        found += _called(node)
    return found


def no_users_code_under_a_lock(house: Path) -> list[str]:
    """No wire calls a function of CALLS_OUT while it holds a lock, itself or by way of other functions of rmw/.

    Such a function may write, match or close on the same wire, which would wait for the lock for ever. A name stands
    for each function that has it, in the file of the call and in those of rmw/ that this file imports.
    """
    rmw = house / "rmw"
    trees = {
        path.relative_to(rmw).with_suffix("").as_posix(): ast.parse(path.read_text("utf-8"))
        for path in sorted(rmw.rglob("*.py"))
    }
    seen = {file: {file} for file in trees}
    for statement in imports(house):
        if statement.importer.startswith("tfloom.rmw.") and statement.imported.startswith("tfloom.rmw."):
            importer, imported = (
                name.removeprefix("tfloom.rmw.").replace(".", "/")
                for name in (statement.importer, statement.imported)
            )
            seen.setdefault(importer, set()).add(imported)
    ways: dict[tuple[str, str], str] = {}

    def way(file: str, name: str) -> str:
        """Return how a call of `name` in a file calls out, empty if it doesn't."""
        if name in CALLS_OUT:
            return name
        return next((ways[other, name] for other in sorted(seen[file]) if (other, name) in ways), "")

    functions = [
        (file, node.name, _called(node))
        for file, tree in trees.items()
        for node in ast.walk(tree)
        if isinstance(node, ast.FunctionDef)
    ]
    size = -1
    while size < len(ways):  # until no further function is known to call out
        size = len(ways)
        for file, function, calls in functions:
            reached = [call_path for name, _ in calls if (call_path := way(file, name))]
            if reached:
                ways.setdefault((file, function), f"{function}, {reached[0]}")
    return [
        f"rmw/{file}.py:{line} calls {call_path} under a lock"
        for file, tree in trees.items()
        for node in ast.walk(tree)
        if isinstance(node, ast.With)
        and any(ast.unparse(item.context_expr).endswith("lock") for item in node.items)
        for name, line in _called(node)
        if (call_path := way(file, name))
    ]


def the_command_line_starts_without_the_rooms(house: Path) -> list[str]:
    """`cli/main.py` imports nothing of the house but cli itself when it is loaded."""
    return [
        f"{_where(house, statement)}, which every command would load"
        for statement in imports(house)
        if statement.importer == "tfloom.cli.main"
        and statement.kind is Kind.RUN_TIME
        and _room(statement.imported) not in {"", "cli"}
    ]


def the_readme_lists_each_file(native: Path) -> list[str]:
    """README.md lists each file of native/ by its first sentence, as `python -m tools.native_readme` writes it."""
    try:
        is_current = (native / native_readme.README).read_text("utf-8") == native_readme.readme_text(native)
    except ValueError as error:
        return [str(error)]
    return [] if is_current else ["README.md differs from the files: run `python -m tools.native_readme`"]


def the_native_core_knows_no_python(native: Path) -> list[str]:
    """Only native/bindings includes Python or nanobind, and only native/dds opens libddsc."""
    violations = []
    for folder in NATIVE_ROOMS:
        for path in sorted((native / folder).glob("*")):
            text = path.read_text("utf-8")
            where = f"{folder}/{path.name}"
            if re.search(r'#include\s*[<"](nanobind|Python\.h)', text):
                violations.append(f"{where} includes Python")
            if folder != "dds" and "dlopen" in text:
                violations.append(f"{where} calls dlopen; libddsc has one door, native/dds")
    return violations


def native_rooms_point_down(native: Path) -> list[str]:
    """A native room includes only itself and the rooms that NATIVE_ROOMS allows it."""
    return [
        f"{folder}/{path.name} includes {other}/"
        for folder, allowed in NATIVE_ROOMS.items()
        for path in sorted((native / folder).glob("*"))
        for other in re.findall(r'#include "(\w+)/', path.read_text("utf-8"))
        if other not in allowed | {folder}
    ]


def one_door_to_the_gil(native: Path) -> list[str]:
    """Only native/bindings/gil.* acquires or releases the GIL: it knows what is safe when the interpreter ends."""
    functions = (
        r"\b(gil_scoped_\w+|PyGILState_(?:Ensure|Release)|PyEval_(?:Save|Restore|Acquire|Release)Thread"
        r"|Py_(?:BEGIN|END|UN)?BLOCK_THREADS|Py_(?:BEGIN|END)_ALLOW_THREADS)\b"
    )
    return [
        f"bindings/{path.name} uses {name}; use bindings/gil.hpp"
        for path in sorted((native / "bindings").glob("*"))
        if path.stem != "gil"
        for name in sorted(set(re.findall(functions, path.read_text("utf-8"))))
    ]


def whoever_catches_all_rethrows(native: Path) -> list[str]:
    """A block of `catch (...)` ends with `throw;`.

    On glibc, `catch (...)` also catches the forced unwinding by which pthread_exit and pthread_cancel end a thread, and
    the process is ended if it isn't rethrown. Whatever our code throws is a std::exception.
    """
    return [
        f"{path.relative_to(native).as_posix()}:{text.count(chr(10), 0, match.start()) + 1} catches all, and goes on"
        for path in sorted(native.glob("*/*.[ch]pp"))
        if (text := path.read_text("utf-8"))
        for match in re.finditer(r"\bcatch\s*\(\s*\.\.\.\s*\)\s*\{([^{}]*)\}?", text)
        if not re.search(r"\bthrow;\s*$", match.group(1))
    ]


def no_python_under_a_native_lock(native: Path) -> list[str]:
    """No C++ code uses Python or calls a std::function while it holds a lock, itself or by way of other functions.

    Such a function may be a user's, which may call whatever needs the lock; and a thread that waits for the GIL with a
    lock held waits for ever for one that has the GIL and waits for the lock. See native/core/deferred_queue.hpp.
    """
    return native_locks.calls_under_locks(native)


Rule = Callable[[Path], list[str]]

HOUSE_RULES: list[Rule] = [
    imports_point_down,
    inner_rooms_point_down,
    no_import_of_an_own_top,
    no_relative_import,
    no_ros_name,
    one_door_for_each_library,
    no_type_checkers_library_at_run_time,
    no_ring,
    a_top_holds_its_docstring_alone,
    listed_files_exist,
    each_room_has_its_place,
    nothing_is_named_that_does_not_exist,
    the_command_line_starts_without_the_rooms,
    one_door_for_reading_yaml,
    files_are_written_whole,
    what_is_said_on_stderr_ends_nothing,
    services_are_asked_in_one_way,
    no_users_code_under_a_lock,
]
NATIVE_RULES: list[Rule] = [
    the_readme_lists_each_file,
    the_native_core_knows_no_python,
    native_rooms_point_down,
    one_door_to_the_gil,
    whoever_catches_all_rethrows,
    no_python_under_a_native_lock,
]

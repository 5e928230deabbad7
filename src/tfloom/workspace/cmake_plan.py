"""What the commands of a CMakeLists.txt install: the plan of a package without compiled code."""

from __future__ import annotations

import posixpath
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple

from tfloom.workspace.environment_hooks import EnvironmentHook
from tfloom.workspace.interface_package import python_folder

_PREFIX = Path("prefix")
PYTHON_FOLDER = python_folder(Path(_PREFIX)).relative_to(_PREFIX).as_posix()
"""Where Python modules are installed under a prefix, as colcon's hooks expect."""


BINARY_FOLDER = "<build>"
"""The value of CMAKE_BINARY_DIR: a folder of files that commands would generate, which are never run."""


class Remark(NamedTuple):
    """A line of CMakeLists.txt, and what is to be known of it."""

    line: int
    text: str


class Pattern(NamedTuple):
    """`PATTERN name` or `REGEX name` of an `install(DIRECTORY …)`."""

    text: str
    is_regex: bool
    excludes: bool


class Install(NamedTuple):
    """One `install` command. Paths of sources are relative to the package's folder, the destination to the prefix."""

    kind: str
    """`FILES`, `PROGRAMS` or `DIRECTORY`."""
    sources: tuple[str, ...]
    destination: str
    line: int
    rename: str | None = None
    optional: bool = False
    patterns: tuple[Pattern, ...] = ()
    only_matching: bool = False
    """Whether only what a pattern names is installed (`FILES_MATCHING`)."""


class PythonPackage(NamedTuple):
    """One `ament_python_install_package` command."""

    name: str
    folder: str
    destination: str
    line: int
    scripts_destination: str = ""
    """Where the programs of setup.cfg are installed; empty: they aren't."""
    setup_cfg: str = "setup.cfg"


class Resource(NamedTuple):
    """One `ament_index_register_resource` command: a file of the ament index."""

    kind: str
    content: str
    line: int


class PytestTest(NamedTuple):
    """One `ament_add_pytest_test` or `add_launch_test` command."""

    name: str
    path: str
    """A file or a folder, relative to the package's."""
    folder: str
    """The working directory, relative to the package's folder; empty for that itself."""
    set_variables: tuple[str, ...]
    """`NAME=value` of ENV."""
    appended_variables: tuple[str, ...]
    """`NAME=value` of APPEND_ENV."""
    line: int
    launch_arguments: tuple[str, ...] = ()
    """`name:=value` of the ARGS of `add_launch_test`."""
    launches: bool = False
    """Whether it is one of `add_launch_test`, which starts programs."""


@dataclass
class Plan:
    """What a CMakeLists.txt asks for."""

    name: str = ""
    """Of `project()`; empty without one."""
    interfaces: list[str] = field(default_factory=list)
    """Definitions of `rosidl_generate_interfaces`, as they stand there."""
    interfaces_line: int = 0
    dependencies: list[str] = field(default_factory=list)
    """Packages whose types the definitions use."""
    installs: list[Install] = field(default_factory=list)
    python_packages: list[PythonPackage] = field(default_factory=list)
    resources: list[Resource] = field(default_factory=list)
    hooks: list[EnvironmentHook] = field(default_factory=list)
    tests: list[PytestTest] = field(default_factory=list)
    """Those in `if(BUILD_TESTING)`, if that is on."""
    found: list[str] = field(default_factory=list)
    """Packages of `find_package`."""
    compiled: list[Remark] = field(default_factory=list)
    """Commands that need a C++ compiler."""
    programs: list[str] = field(default_factory=list)
    """Names of the programs that these would make."""
    generated: dict[str, bytes] = field(default_factory=dict)
    """Contents of the files of `configure_file`, by path in the build folder."""
    unknown: list[Remark] = field(default_factory=list)
    """Commands that aren't understood."""

    @property
    def is_cpp(self) -> bool:
        """Whether the package is of compiled code: it has neither interfaces nor Python nor programs as files."""
        has_more = (
            self.interfaces
            or self.python_packages
            or any(install.kind == "PROGRAMS" for install in self.installs)
        )
        return bool(self.compiled) and not has_more

    @property
    def is_left_out(self) -> bool:
        """Whether nothing but headers would be installed of a package of compiled code."""
        has_more = self.resources or self.hooks
        return self.is_cpp and not has_more and all(map(is_of_headers, self.installs))


def is_of_headers(install: Install) -> bool:
    """Return whether an `install` is for C++ compilers only."""
    return install.destination.split("/")[0] == "include"


Action = Callable[[Plan, Sequence[str], int], None]


def _words(values: Sequence[str], keywords: Iterable[str]) -> dict[str, list[str]]:
    """Return the values after each keyword, and under "" those before the first one."""
    # A keyword may come twice; its values are then one list.
    keyword_set = set(keywords)
    words: dict[str, list[str]] = {"": []}
    current = words[""]
    for value in values:
        if value in keyword_set:
            current = words.setdefault(value, [])
        else:
            current.append(value)
    return words


def _project(plan: Plan, values: Sequence[str], _line: int) -> None:
    plan.name = plan.name or next(iter(values), "")


def _find_package(plan: Plan, values: Sequence[str], _line: int) -> None:
    plan.found += values[:1]


def _generate_interfaces(plan: Plan, values: Sequence[str], line: int) -> None:
    flags = ("ADD_LINTER_TESTS", "SKIP_INSTALL", "SKIP_GROUP_MEMBERSHIP_CHECK")
    words = _words(values[1:], ("DEPENDENCIES", "LIBRARY_NAME", *flags))
    # A flag has no value: what follows it is more files.
    files = [value for key in ("", *flags) for value in words.get(key, ())]
    plan.interfaces += files
    plan.interfaces_line = plan.interfaces_line or line
    plan.dependencies += words.get("DEPENDENCIES", [])


def _python_package(plan: Plan, values: Sequence[str], line: int) -> None:
    words = _words(
        values, ("PACKAGE_DIR", "VERSION", "SETUP_CFG", "DESTINATION", "SCRIPTS_DESTINATION", "SKIP_COMPILE")
    )
    name = next(iter(words[""]), "")
    if not name:
        plan.unknown.append(Remark(line, "ament_python_install_package() without a name"))
        return
    folder = next(iter(words.get("PACKAGE_DIR", ())), name)
    destination = next(iter(words.get("DESTINATION", ())), PYTHON_FOLDER)
    scripts = next(iter(words.get("SCRIPTS_DESTINATION", ())), "")
    setup_cfg = next(iter(words.get("SETUP_CFG", ())), "setup.cfg")
    plan.python_packages.append(PythonPackage(name, folder, destination, line, scripts, setup_cfg))


def _python_module(plan: Plan, values: Sequence[str], line: int) -> None:
    plan.installs.append(Install("FILES", tuple(values[:1]), PYTHON_FOLDER, line))


def _register_resource(plan: Plan, values: Sequence[str], line: int) -> None:
    words = _words(values, ("CONTENT", "CONTENT_FILE", "PACKAGE_NAME", "SKIP_INSTALL"))
    if not words[""] or "CONTENT_FILE" in words or "PACKAGE_NAME" in words:
        plan.unknown.append(Remark(line, "this form of ament_index_register_resource() isn't understood"))
        return
    plan.resources.append(Resource(words[""][0], "".join(words.get("CONTENT", ())), line))


def _auto_package(plan: Plan, values: Sequence[str], line: int) -> None:
    for folder in _words(values, ("INSTALL_TO_PATH", "INSTALL_TO_SHARE")).get("INSTALL_TO_SHARE", ()):
        plan.installs.append(Install("DIRECTORY", (folder,), f"share/{plan.name}", line))


def _install(plan: Plan, values: Sequence[str], line: int) -> None:
    kind = next(iter(values), "")
    if kind in {"TARGETS", "EXPORT"}:
        plan.compiled.append(Remark(line, f"install({kind} …)"))
    elif kind in {"FILES", "PROGRAMS"}:
        _install_files(plan, kind, values[1:], line)
    elif kind == "DIRECTORY":
        _install_directory(plan, values[1:], line)
    else:
        plan.unknown.append(Remark(line, f"install({kind} …) isn't understood: the first word says what"))


_COMMON = (
    "DESTINATION",
    "PERMISSIONS",
    "CONFIGURATIONS",
    "COMPONENT",
    "OPTIONAL",
    "EXCLUDE_FROM_ALL",
    "TYPE",
)


def _install_files(plan: Plan, kind: str, values: Sequence[str], line: int) -> None:
    words = _words(values, (*_COMMON, "RENAME"))
    if (destination := _destination(plan, kind, words, line)) is not None:
        rename = next(iter(words.get("RENAME", ())), None)
        optional = "OPTIONAL" in words
        # Files with their own permissions are programs if these include one to execute.
        executable = any("EXECUTE" in permission for permission in words.get("PERMISSIONS", ()))
        plan.installs.append(
            Install(
                "PROGRAMS" if executable else kind,
                tuple(words[""]),
                destination,
                line,
                rename,
                optional,
            )
        )


def _install_directory(plan: Plan, values: Sequence[str], line: int) -> None:
    # What follows PATTERN or REGEX belongs to that pattern, also words as PERMISSIONS that mean the whole command
    # before.
    first = next((at for at, value in enumerate(values) if value in {"PATTERN", "REGEX"}), len(values))
    words = _words(
        values[:first],
        (
            *_COMMON,
            "FILES_MATCHING",
            "USE_SOURCE_PERMISSIONS",
            "FILE_PERMISSIONS",
            "DIRECTORY_PERMISSIONS",
            "MESSAGE_NEVER",
        ),
    )
    if (destination := _destination(plan, "DIRECTORY", words, line)) is not None:
        plan.installs.append(
            Install(
                "DIRECTORY",
                tuple(words[""]),
                destination,
                line,
                None,
                "OPTIONAL" in words,
                tuple(_patterns(values[first:])),
                "FILES_MATCHING" in words,
            )
        )


def name_in_build(source: str) -> str | None:
    """Return the path in the build folder of a source, or None for one elsewhere."""
    if source != BINARY_FOLDER and not source.startswith(f"{BINARY_FOLDER}/"):
        return None
    return posixpath.normpath(source.removeprefix(BINARY_FOLDER).strip("/"))


def drop_ungenerated(plan: Plan) -> None:
    """Remove the sources of `install` commands that other commands would generate, and remark them."""
    # At the end of the file, because `configure_file` may stand behind the `install` of what it writes.
    for at, install in enumerate(plan.installs):
        names = [name_in_build(source) for source in install.sources]
        lacking = [name for name in names if name is not None and not _is_generated(plan, name)]
        for name in lacking:
            text = f"install({install.kind} …): {name} is generated by a command that isn't run, so it is left out"
            plan.unknown.append(Remark(install.line, text))
        pairs = zip(install.sources, names, strict=True)
        sources = tuple(source for source, name in pairs if name not in lacking)
        plan.installs[at] = install._replace(sources=sources)


def _is_generated(plan: Plan, name: str) -> bool:
    return any(path == name or path.startswith(f"{name}/") or name == "." for path in plan.generated)


def _patterns(values: Sequence[str]) -> Iterable[Pattern]:
    for at, value in enumerate(values[:-1]):
        if value in {"PATTERN", "REGEX"}:
            excludes = values[at + 2 : at + 3] == ["EXCLUDE"]
            yield Pattern(values[at + 1], value == "REGEX", excludes)


def _destination(plan: Plan, kind: str, words: dict[str, list[str]], line: int) -> str | None:
    """Return the destination of an `install`; without a usable one, remark that and return None."""
    destinations = words.get("DESTINATION", [])
    if len(destinations) == 1:
        return destinations[0]
    what = "TYPE isn't understood here" if "TYPE" in words else "one DESTINATION is expected"
    plan.unknown.append(Remark(line, f"install({kind} …): {what}: write DESTINATION and a folder"))
    return None


def _add_pytest_test(plan: Plan, values: Sequence[str], line: int) -> None:
    options = (
        "PYTHON_EXECUTABLE",
        "RUNNER",
        "TIMEOUT",
        "WORKING_DIRECTORY",
        "ENV",
        "APPEND_ENV",
        "APPEND_LIBRARY_DIRS",
    )
    words = _words(values, ("SKIP_TEST", *options))
    if "SKIP_TEST" in words:
        return
    if len(words[""]) != 2:
        plan.unknown.append(Remark(line, "ament_add_pytest_test(): a name and a path are expected"))
        return
    name, path = words[""]
    folder = next(iter(words.get("WORKING_DIRECTORY", ())), "")
    variables, appended = (tuple(words.get(key, ())) for key in ("ENV", "APPEND_ENV"))
    plan.tests.append(PytestTest(name, path, folder, variables, appended, line))


def _add_launch_test(plan: Plan, values: Sequence[str], line: int) -> None:
    options = ("TARGET", "TIMEOUT", "PYTHON_EXECUTABLE", "RUNNER", "RESULT_FILE", "WORKING_DIRECTORY")
    words = _words(
        values, ("SKIP_TEST", "ARGS", "ENV", "APPEND_ENV", "APPEND_LIBRARY_DIRS", "LABELS", *options)
    )
    if "SKIP_TEST" in words:
        return
    if len(words[""]) != 1:
        plan.unknown.append(Remark(line, "add_launch_test(): a path is expected"))
        return
    (path,) = words[""]
    name = next(iter(words.get("TARGET", ())), path.replace("/", "_"))
    folder = next(iter(words.get("WORKING_DIRECTORY", ())), "")
    variables, appended, arguments = (tuple(words.get(key, ())) for key in ("ENV", "APPEND_ENV", "ARGS"))
    plan.tests.append(PytestTest(name, path, folder, variables, appended, line, arguments, launches=True))


def _compiles(name: str) -> Action:
    def action(plan: Plan, values: Sequence[str], line: int) -> None:
        plan.compiled.append(Remark(line, f"{name}({next(iter(values), '')} …)"))

    return action


def _add_executable(plan: Plan, values: Sequence[str], line: int) -> None:
    plan.compiled.append(Remark(line, f"add_executable({next(iter(values), '')} …)"))
    plan.programs += values[:1]


def _register_component(plan: Plan, values: Sequence[str], line: int) -> None:
    plan.compiled.append(Remark(line, f"rclcpp_components_register_node({next(iter(values), '')} …)"))
    plan.programs += _words(values, ("PLUGIN", "EXECUTABLE", "EXECUTOR", "RESOURCE_INDEX")).get(
        "EXECUTABLE", ()
    )


def _add_nothing(_plan: Plan, _values: Sequence[str], _line: int) -> None:
    """Add nothing to the plan."""


_COMPILED = (
    "add_library",
    "add_subdirectory",
    "ament_auto_add_library",
    "ament_vendor",
    "generate_parameter_library",
    "pybind11_add_module",
    "nanobind_add_module",
    "python_add_library",
    "python3_add_library",
    "rclcpp_components_register_nodes",
    "add_custom_target",
    "add_custom_command",
    "externalproject_add",
    "fetchcontent_makeavailable",
)

_IGNORED = (  # without effect on what is installed
    "add_compile_definitions",
    "add_compile_options",
    "add_definitions",
    "add_dependencies",
    "add_link_options",
    "ament_auto_find_build_dependencies",
    "ament_auto_find_test_dependencies",
    "ament_index_register_package",
    "ament_package",
    "autoware_package",
    "cmake_minimum_required",
    "cmake_policy",
    "configure_package_config_file",
    "enable_testing",
    "export",
    "export_windows_symbols",
    "fetchcontent_declare",
    "find_dependency",
    "find_file",
    "find_library",
    "find_path",
    "find_program",
    "generate_export_header",
    "get_target_property",
    "include_directories",
    "link_directories",
    "link_libraries",
    "mark_as_advanced",
    "moveit_package",
    "nav2_package",
    "pkg_check_modules",
    "pkg_search_module",
    "pluginlib_export_plugin_description_file",
    "rosidl_export_typesupport_libraries",
    "rosidl_export_typesupport_targets",
    "rosidl_get_typesupport_target",
    "rosidl_target_interfaces",
    "set_compiler_options",
    "set_property",
    "set_source_files_properties",
    "set_target_properties",
    "set_tests_properties",
    "write_basic_package_version_file",
)

_IGNORED_PREFIXES = ("target_", "ament_export_", "ament_add_", "ament_lint", "ament_target_", "add_test")
"""Of commands about compiled code, and about tests that CTest runs."""

_ACTIONS: dict[str, Action] = {
    "project": _project,
    "find_package": _find_package,
    "rosidl_generate_interfaces": _generate_interfaces,
    "ament_python_install_package": _python_package,
    "ament_python_install_module": _python_module,
    "ament_add_pytest_test": _add_pytest_test,
    "add_launch_test": _add_launch_test,
    "add_ros_test": _add_launch_test,
    "ament_index_register_resource": _register_resource,
    "ament_auto_package": _auto_package,
    "install": _install,
    "add_executable": _add_executable,
    "ament_auto_add_executable": _add_executable,
    "rclcpp_components_register_node": _register_component,
    **{name: _compiles(name) for name in _COMPILED},
    **dict.fromkeys(_IGNORED, _add_nothing),
}


def find_action(command: str) -> Action | None:
    """Return what a command adds to a plan, or None for one that isn't understood."""
    action = _ACTIONS.get(command)
    return _add_nothing if action is None and command.startswith(_IGNORED_PREFIXES) else action


def is_in(folder: Path, path: Path) -> bool:
    """Return whether a path stays inside a folder; neither needs to exist."""
    return path.resolve().is_relative_to(folder.resolve())

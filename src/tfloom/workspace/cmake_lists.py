"""The reader of CMakeLists.txt: follows variables, conditions and loops, and makes a plan. It never runs anything."""

from __future__ import annotations

import os
import platform
import struct
from collections.abc import Callable, Iterator, Sequence
from contextlib import contextmanager
from fnmatch import fnmatchcase
from pathlib import Path, PurePosixPath

from tfloom.ros_imports.ros_distro import ROS_DISTRO
from tfloom.workspace.cmake_configure import configured
from tfloom.workspace.cmake_plan import (
    BINARY_FOLDER,
    PYTHON_FOLDER,
    Plan,
    Remark,
    drop_ungenerated,
    find_action,
    name_in_build,
)
from tfloom.workspace.cmake_regex import RegexError
from tfloom.workspace.cmake_syntax import MAX_NESTED, CMakeSyntaxError, Command, read_commands
from tfloom.workspace.cmake_values import (
    TooMuchError,
    UnknownConditionError,
    Variables,
    expand,
    expand_all,
    is_file,
    is_folder,
    is_true,
    split_list,
)
from tfloom.workspace.environment_hooks import KINDS, EnvironmentHook
from tfloom.workspace.missing_dependencies import is_package_there

_ENDS = {
    "if": "endif",
    "foreach": "endforeach",
    "while": "endwhile",
    "function": "endfunction",
    "macro": "endmacro",
    "block": "endblock",
}
_SEARCHES = ("find_package", "find_library", "find_path", "find_file", "find_program", "pkg_check_modules")
MAX_STEPS = 20_000
"""Commands that one file may take, because loops nest."""
MAX_LOOKED_AT = 500_000
"""Commands that may be looked at for the ends and the branches of blocks, because loops may hold many."""

MAX_SOUGHT = 200
"""Characters that the name of a variable about a search may have."""
MAX_LISTED = 50_000
"""Files that `file(GLOB …)` may list, because a pattern may lead out of the package."""


def read_plan(folder: Path, prefix: Path, *, testing: bool = False) -> Plan:
    """Return what the CMakeLists.txt of a package asks for.

    Args:
        folder: The package's.
        prefix: Where it will be installed, the value of CMAKE_INSTALL_PREFIX.
        testing: The value of BUILD_TESTING, which decides whether the tests are read.

    Raises:
        CMakeSyntaxError: it can't be read, or stops itself by `message(FATAL_ERROR …)`.
        OSError: it can't be read.
    """
    path = folder / "CMakeLists.txt"
    reader = _Reader(path, prefix, testing=testing)
    reader.run(read_commands(path))
    drop_ungenerated(reader.plan)
    return reader.plan


class _Stop(Exception):  # noqa: N818  # no error: the end of the file by return()
    """Ends the reading of the file, from any depth of blocks, at a `return()`."""


class _Reader:
    """The state of reading one file: its variables, and the plan so far."""

    def __init__(self, path: Path, prefix: Path, *, testing: bool) -> None:
        self.plan = Plan()
        self._path = path
        self._folder = path.parent
        self._steps = 0
        self._looked_at = 0
        self._listed = 0
        self._depth = 0
        self._sought: dict[str, Remark] = {}
        """The searches of what isn't here, by the beginning of the variables that they set, in lower case."""
        self._failed_search: Remark | None = None
        """Such a search on which the condition of a block around the current command depends."""
        source = self._folder.as_posix()
        self._variables = Variables(
            {
                "CMAKE_CURRENT_LIST_DIR": source,
                "CMAKE_CURRENT_SOURCE_DIR": source,
                "CMAKE_SOURCE_DIR": source,
                "CMAKE_CURRENT_BINARY_DIR": BINARY_FOLDER,
                "CMAKE_BINARY_DIR": BINARY_FOLDER,
                "PROJECT_BINARY_DIR": BINARY_FOLDER,
                "CMAKE_INSTALL_PREFIX": prefix.as_posix(),
                "CMAKE_INSTALL_BINDIR": "bin",
                "CMAKE_INSTALL_LIBDIR": "lib",
                "CMAKE_INSTALL_DATADIR": "share",
                "CMAKE_INSTALL_DATAROOTDIR": "share",
                "CMAKE_INSTALL_INCLUDEDIR": "include",
                "PYTHON_INSTALL_DIR": PYTHON_FOLDER,
                **_system_variables(),
                "ROS_DISTRO": os.environ.get("ROS_DISTRO") or ROS_DISTRO,
                "BUILD_TESTING": "ON" if testing else "OFF",
            }
        )

    def run(self, commands: Sequence[Command]) -> None:
        """Run the commands of a file, up to its end or a `return()`."""
        try:
            self._run(commands)
        except _Stop:
            return

    def _run(self, commands: Sequence[Command]) -> None:
        at = 0
        while at < len(commands):
            command = commands[at]
            self._steps += 1
            if self._steps > MAX_STEPS:
                raise self._error(command, f"the file takes more than {MAX_STEPS} commands")
            if command.name in _ENDS:
                end = self._end(commands, at)
                self._run_nested(commands[at:end])
                at = end
            elif command.name in {"else", "elseif", *_ENDS.values()}:
                raise self._error(command, f"{command.name}() without what it ends")
            else:
                with self._located(command):
                    self._run_command(command)
            at += 1

    @contextmanager
    def _located(self, command: Command) -> Iterator[None]:
        """Add file and line to an error about a limit."""
        try:
            yield
        except TooMuchError as error:
            raise self._error(command, str(error)) from None

    def _run_nested(self, block: Sequence[Command]) -> None:
        """Run a block, whose last command is left out."""
        self._depth += 1
        if self._depth > MAX_NESTED:
            raise self._error(block[0], f"more than {MAX_NESTED} blocks are nested")
        with self._located(block[0]):
            self._run_block(block)
        self._depth -= 1

    def _look_at(self, block: Sequence[Command], count: int) -> None:
        self._looked_at += count
        if self._looked_at > MAX_LOOKED_AT:
            raise self._error(block[0], "too many blocks are in blocks or in loops")

    def _end(self, commands: Sequence[Command], begin: int) -> int:
        """Return the position of the command that ends the block at `begin`."""
        depth = 0
        opening, closing = commands[begin].name, _ENDS[commands[begin].name]
        for at in range(begin, len(commands)):
            depth += (commands[at].name == opening) - (commands[at].name == closing)
            if not depth:
                self._look_at(commands[begin:at], at - begin)
                return at
        raise self._error(commands[begin], f"{opening}() isn't ended by {closing}()")

    def _run_block(self, block: Sequence[Command]) -> None:
        head = block[0]
        if head.name == "if":
            self._run_branch(block)
        elif head.name == "foreach":
            self._run_loop(head, block[1:])
        elif head.name == "block":
            self._run(block[1:])
        elif head.name == "while":
            self._remark(head, "while() isn't understood")
        # The body of a function or a macro is left out; a call of it is named as not understood.

    def _run_branch(self, block: Sequence[Command]) -> None:
        """Run the first branch of an `if` whose condition is true."""
        # Only the branches of this `if` count, not those of one inside it, which has its own depth. The block has
        # the `if` itself, but not its `endif`.
        self._look_at(block, len(block))
        heads = [0]
        depth = 0
        for at, command in enumerate(block):
            depth += (command.name == "if") - (command.name == "endif")
            if depth == 1 and command.name in {"elseif", "else"}:
                heads.append(at)
        around = self._failed_search
        for head, end in zip(heads, [*heads[1:], len(block)], strict=True):
            # Also where an earlier condition of the same `if` has named the search: `else()` is its other half.
            self._failed_search = self._failed_search or self._search_in(block[head])
            if block[head].name == "else" or self._condition_holds(block[head]):
                self._run(block[head + 1 : end])
                break
        self._failed_search = around

    def _search_in(self, command: Command) -> Remark | None:
        """Return the failed search that the condition of an `if` asks about, or None."""
        for argument in command.arguments:
            # `Foo_FOUND`, `FOO_VERSION` and, of find_library, the whole name; an underscore may be in the name itself.
            words = argument.text[:MAX_SOUGHT].strip("${}").lower().split("_")
            for end in range(1, len(words) + 1):
                if (search := self._sought.get("_".join(words[:end]))) is not None:
                    return search
        return None

    def _note_search(self, command: Command, values: Sequence[str]) -> None:
        """Set the variables of a search, and note it if it finds nothing: what isn't here is taken for C++."""
        name = next(iter(values), "")
        is_there = command.name == "find_package" and is_package_there(name)
        if is_there or "REQUIRED" in values:  # without it, CMake would stop here
            self._variables |= {f"{name}_FOUND": "1", f"{name.upper()}_FOUND": "1"}
        if name and not is_there:
            self._sought[name.lower()] = Remark(command.line, f"{command.name}({name} …)")

    def _condition_holds(self, command: Command) -> bool:
        try:
            return is_true(command.arguments, self._variables, self._folder)
        except UnknownConditionError as error:
            self._remark(command, f"{error}; {command.name}() is taken as false")
            return False

    def _run_loop(self, head: Command, body: Sequence[Command]) -> None:
        values = expand_all(head.arguments, self._variables)
        if not values:
            raise self._error(head, "foreach() without a variable")
        name, *items = values
        if items[:1] == ["RANGE"]:
            self._remark(head, "foreach(… RANGE …) isn't understood")
            return
        if items[:1] == ["IN"]:
            items = self._items(items[1:])
        # As in CMake, the loop's variable has its former value again behind the loop. The items are a list by now, so
        # that what the body does to the variables changes no later round.
        before = self._variables.get(name)
        for item in items:
            self._variables[name] = item
            self._run(body)
        self._restore(name, before)

    def _items(self, words: Sequence[str]) -> list[str]:
        """Return the items of `IN LISTS a b ITEMS c d`."""
        items: list[str] = []
        lists = False
        for word in words:
            if word in {"LISTS", "ITEMS"}:
                lists = word == "LISTS"
            else:
                items += split_list(self._variables.read(word)) if lists else [word]
        return items

    def _restore(self, name: str, value: str | None) -> None:
        if value is None:
            self._variables.pop(name, None)
        else:
            self._variables[name] = value

    def _run_command(self, command: Command) -> None:
        own = _OWN.get(command.name)
        if own is not None:
            own(self, command)
            return
        action = find_action(command.name)
        if action is None:
            self._remark(command, f"{command.name}() isn't understood")
            return
        values = expand_all(command.arguments, self._variables)
        action(self.plan, values, command.line)
        if command.name in _SEARCHES:
            self._note_search(command, values)
        if command.name == "project":
            source = self._folder.as_posix()
            self._variables |= {"PROJECT_NAME": self.plan.name, "PROJECT_SOURCE_DIR": source}
            self._variables |= {"CMAKE_PROJECT_NAME": self.plan.name}

    def set_variable(self, command: Command) -> None:
        if not command.arguments:
            raise self._error(command, "set() without a variable")
        first, *rest = (expand(argument, self._variables) for argument in command.arguments)
        if len(first) != 1 or first[0].startswith("ENV{"):
            self._remark(command, "set() of this isn't understood")
            return
        # There is one scope only: functions aren't run, so PARENT_SCOPE means nothing. CACHE, with type and description
        # behind it, sets a default: a value that is there stays.
        values = [value for part in rest for value in part]
        if values[-1:] == ["PARENT_SCOPE"]:
            del values[-1]
        if "CACHE" in values:
            del values[values.index("CACHE") :]
            if first[0] in self._variables:
                return
        if rest:
            self._variables[first[0]] = ";".join(value.replace(";", "\\;") for value in values)
        else:
            self._variables.pop(first[0], None)

    def unset_variable(self, command: Command) -> None:
        for name in expand_all(command.arguments, self._variables)[:1]:
            self._variables.pop(name, None)

    def set_option(self, command: Command) -> None:
        words = [expand(argument, self._variables) for argument in command.arguments]
        if words and words[0]:
            value = words[2][0] if len(words) > 2 and words[2] else "OFF"
            self._variables.setdefault(words[0][0], value)

    def change_list(self, command: Command) -> None:
        words = expand_all(command.arguments, self._variables)
        if len(words) < 2:
            self._remark(command, "list() without a variable")
            return
        verb, name, *values = words
        items = split_list(self._variables.read(name))
        if verb == "APPEND":
            items += values
        elif verb == "PREPEND":
            items = values + items
        elif verb == "REMOVE_ITEM":
            removed = set(values)
            items = [item for item in items if item not in removed]
        elif verb == "REMOVE_DUPLICATES":
            items = list(dict.fromkeys(items))
        elif verb == "FILTER" and len(values) == 3 and values[1] == "REGEX":
            items = self._filter(command, items, values[2], excludes=values[0] == "EXCLUDE")
        elif verb == "SORT":
            items.sort()
        else:
            self._remark(command, f"list({verb} …) isn't understood")
            return
        self._variables[name] = ";".join(items)

    def _filter(self, command: Command, items: list[str], pattern: str, *, excludes: bool) -> list[str]:
        """Return the items of `list(FILTER variable INCLUDE|EXCLUDE REGEX pattern)`."""
        try:
            expression = self._variables.expression(pattern)
        except RegexError as error:
            raise self._error(command, str(error)) from None
        return [item for item in items if expression.is_found_in(item) != excludes]

    def find_files(self, command: Command) -> None:
        """Run `file(GLOB variable [RELATIVE folder] [CONFIGURE_DEPENDS] patterns…)`."""
        verb, *words = expand_all(command.arguments, self._variables) or [""]
        if verb not in {"GLOB", "GLOB_RECURSE"} or not words:
            self._remark(command, f"file({verb} …) isn't understood")
            return
        name, *rest = [word for word in words if word not in {"CONFIGURE_DEPENDS", "FOLLOW_SYMLINKS"}]
        base: Path | None = None
        if rest[:1] == ["RELATIVE"]:
            base, rest = self._folder / "".join(rest[1:2]), rest[2:]
        paths = {path for pattern in rest for path in self._glob(pattern, deep=verb == "GLOB_RECURSE")}
        names = [path.relative_to(base) if base and path.is_relative_to(base) else path for path in paths]
        self._variables[name] = ";".join(sorted(path.as_posix() for path in names))

    def _glob(self, pattern: str, *, deep: bool) -> list[Path]:
        """Return the files of a pattern in the package's folder. CMake's `**` is `*`."""
        path = Path(pattern)
        if path.is_absolute():
            if not path.is_relative_to(self._folder):
                return []
            path = path.relative_to(self._folder)
        if not path.parts:
            return []
        # Folder by folder, from the top: a part without `*`, `?` and `[` needs no listing, and each listing counts for
        # the limit, because a pattern as `*/*/*/*` may go through many.
        parents = [self._folder]
        for part in path.parts[:-1]:
            parents = [
                child for parent in parents for child in self._children(parent, part) if is_folder(child)
            ]
        if deep:
            parents = [inner for parent in parents for inner in self._folders_in(parent)]
        last = path.parts[-1]
        return [child for parent in parents for child in self._children(parent, last) if is_file(child)]

    def _children(self, folder: Path, pattern: str) -> list[Path]:
        """Return the files and folders in a folder whose names match."""
        if not set("*?[") & set(pattern):
            return [folder / pattern]
        names = self._names(folder)
        return [folder / name for name in names if fnmatchcase(name, pattern)]

    def _folders_in(self, folder: Path) -> Iterator[Path]:
        """Yield a folder and all that are in it, without those behind links."""
        for path, folders, names in os.walk(folder):
            self._count_listed(len(folders) + len(names))
            yield Path(path)

    def _names(self, folder: Path) -> list[str]:
        try:
            names = [child.name for child in folder.iterdir()]
        except OSError:
            return []
        self._count_listed(len(names))
        return names

    def _count_listed(self, count: int) -> None:
        self._listed += count
        if self._listed > MAX_LISTED:
            raise TooMuchError(f"its file(GLOB …) list more than {MAX_LISTED} files")

    def split_path(self, command: Command) -> None:
        """Run `get_filename_component(variable path part)` for parts of the name."""
        words = expand_all(command.arguments, self._variables)
        part = _PARTS.get(words[2]) if len(words) == 3 else None
        if part is None:
            self._remark(command, "this form of get_filename_component() isn't understood")
            return
        self._variables[words[0]] = part(PurePosixPath(words[1]))

    def configure_file(self, command: Command) -> None:
        """Run `configure_file(input output [COPYONLY] [@ONLY])`, whose output stays in memory until it is installed."""
        words = expand_all(command.arguments, self._variables)
        if len(words) < 2:
            raise self._error(command, "configure_file() needs an input and an output")
        source, output = self._folder / words[0], words[1]
        is_relative = not (output.startswith(BINARY_FOLDER) or Path(output).is_absolute())
        name = name_in_build(f"{BINARY_FOLDER}/{output}" if is_relative else output)
        if name == ".":  # the folder: the file keeps its name
            name = source.name
        if name is None or name.startswith(".."):
            self._remark(
                command, f"configure_file() writes {output}, outside of the build folder, and isn't run"
            )
            return
        try:
            self.plan.generated[name] = configured(source, self._variables, words[2:])
        except OSError as error:
            self._remark(command, f"configure_file(): {words[0]} can't be read: {error.strerror}")

    def add_environment_hooks(self, command: Command) -> None:
        """Run `ament_environment_hooks(file …)`; the variables of a file that ends in `.in` are replaced."""
        for word in expand_all(command.arguments, self._variables):
            name = Path(word).name.removesuffix(".in")
            if name.rpartition(".")[2] not in KINDS:
                self._remark(
                    command,
                    f"ament_environment_hooks(): {word} is left out: its name ends in none of {', '.join(KINDS)}",
                )
                continue
            content = self.plan.generated.get(name_in_build(word) or "")
            if content is None:
                options = () if word.endswith(".in") else ("COPYONLY",)
                try:
                    content = configured(self._folder / word, self._variables, options)
                except OSError as error:
                    self._remark(
                        command,
                        f"ament_environment_hooks(): {word} is left out, because it can't be read: {error.strerror}",
                    )
                    continue
            self.plan.hooks.append(EnvironmentHook(name, content, command.line))

    def show_message(self, command: Command) -> None:
        words = [" ".join(expand(argument, self._variables)) for argument in command.arguments]
        if words[:1] == ["FATAL_ERROR"]:
            if self._failed_search is not None:
                self.plan.compiled.append(self._failed_search)
                return
            raise self._error(command, "".join(words[1:]) or "message(FATAL_ERROR)")

    def include_file(self, command: Command) -> None:
        """Run `include`: of CMake's own modules nothing is needed; a file of the package isn't followed."""
        name = next(iter(expand_all(command.arguments, self._variables)), "")
        if "/" in name or name.endswith(".cmake"):
            self._remark(command, f"include({name}) isn't understood: its commands are left out")

    def stop(self, _command: Command) -> None:
        raise _Stop

    def _remark(self, command: Command, text: str) -> None:
        remark = Remark(command.line, text)
        if remark not in self.plan.unknown:
            self.plan.unknown.append(remark)

    def _error(self, command: Command, reason: str) -> CMakeSyntaxError:
        return CMakeSyntaxError(self._path, command.line, reason)


def _system_variables() -> dict[str, str]:
    """Return what `project()` sets about this system, which is also the one that the build runs on."""
    name, processor = platform.system(), platform.machine()
    kinds = {"Linux": ("UNIX", "LINUX"), "Darwin": ("UNIX", "APPLE"), "Windows": ("WIN32",)}.get(
        name, ("UNIX",)
    )
    variables = {"SYSTEM": f"{name}-{platform.release()}", "SYSTEM_NAME": name, "SYSTEM_PROCESSOR": processor}
    variables["SYSTEM_VERSION"] = platform.release()
    return {
        **dict.fromkeys(kinds, "1"),
        **{f"CMAKE_{name}": value for name, value in variables.items()},
        **{f"CMAKE_HOST_{name}": value for name, value in (variables | dict.fromkeys(kinds, "1")).items()},
        "CMAKE_SIZEOF_VOID_P": str(struct.calcsize("P")),
    }


_PARTS: dict[str, Callable[[PurePosixPath], str]] = {
    "NAME": lambda path: path.name,
    "NAME_WE": lambda path: path.name[:1] + path.name[1:].partition(".")[0],
    "NAME_WLE": lambda path: path.stem,
    "DIRECTORY": lambda path: "" if path.parent == PurePosixPath() else path.parent.as_posix(),
    "PATH": lambda path: "" if path.parent == PurePosixPath() else path.parent.as_posix(),
}

_OWN: dict[str, Callable[[_Reader, Command], None]] = {
    "configure_file": _Reader.configure_file,
    "ament_environment_hooks": _Reader.add_environment_hooks,
    "set": _Reader.set_variable,
    "unset": _Reader.unset_variable,
    "option": _Reader.set_option,
    "list": _Reader.change_list,
    "file": _Reader.find_files,
    "get_filename_component": _Reader.split_path,
    "message": _Reader.show_message,
    "include": _Reader.include_file,
    "return": _Reader.stop,
}

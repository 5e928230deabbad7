"""Which locks the C++ code holds while it calls out, read from its text: for a rule of `tests/architecture.py`.

This is no parser of C++. It relies on how native/ is written: a lock is a local object, released at the end of its
block or by `name.unlock()`. A call is taken for one of each function of that name in the files that the caller
includes, by what stands before the name: nothing (the caller's class, or no class), an object (another class), or a
class.
"""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from pathlib import Path

_NO_CODE = re.compile(
    r"""
    ^[ \t]*\#(?:[^\n]*\\\n)*[^\n]*$     # a line of the preprocessor, with those that continue it
    |//[^\n]* | /\*[\s\S]*?\*/          # comments
    |R"\([\s\S]*?\)" | "(?:\\.|[^"\\\n])*"
    |(?<![0-9a-fA-F])'(?:\\.|[^'\\\n])*'  # but not the ' within a number
    """,
    re.VERBOSE | re.MULTILINE,
)
_LOCK = re.compile(
    r"\b(?:lock_guard|unique_lock|scoped_lock|shared_lock|ReadLock)\b(?:<[^;(]*>)?\s+(\w+)\s*[({]"
)
_CALL = re.compile(r"(?:(\w+)?(::|\.|->)\s*)?(?<![\w~])(?:\(\*(\w+)\)|(\w+)(?:<[\w:, ]*>)?)\s*\(")
_ALIAS = re.compile(r"\busing\s+(\w+)\s*=\s*std::function<")
_PYTHON = re.compile(r"\b(?:Py[A-Z_]\w*|nb::\w+|nanobind::\w+|AcquiredGil|ReleasedGil)\b")
_SINK = re.compile(r"\bsink_?->(?:push|forget)(?=\()")
"""Calls of virtual functions of `Sink`, some of which call users' functions."""
_CONTROL = {"if", "for", "while", "switch", "catch", "return", "sizeof", "alignof", "decltype", "noexcept"}
_DEFERRED = "DeferredQueue::Scope"
"""A function that declares this object defers what it would call out."""


@dataclass(frozen=True, order=True)
class _Call:
    name: str
    of: str
    """What stands before the name: nothing, `.` for an object, or a class or namespace."""


@dataclass
class _Function:
    name: str
    of: str
    """Its class; empty for none."""
    line: int
    body: str
    calls: set[_Call] = field(default_factory=set)


@dataclass
class _File:
    text: str
    """Without comments and literals, which are blanks."""
    includes: set[str]
    functions: list[_Function]


def _code_of(text: str) -> str:
    """Return C++ text with blanks in the place of comments, literals and lines of the preprocessor."""

    def blank(match: re.Match[str]) -> str:
        return re.sub(r"[^\n]", " ", match.group())

    return _NO_CODE.sub(blank, text)


def _end_of_block(text: str, begin: int) -> int:
    """Return the position of the brace that ends the block in which `begin` lies; the text's end without one."""
    depth = 0
    for position in range(begin, len(text)):
        if text[position] == "{":
            depth += 1
        elif text[position] == "}":
            depth -= 1
            if depth < 0:
                return position
    return len(text)


def _function_name(header: str) -> tuple[str, str] | None:
    """Return class and name of the function whose body follows `header`; None if the brace is of something else."""
    header = header.strip()
    first = re.search(r"(?:(\w+)::)?([\w~]+)\s*\(", header)
    if first is None or "=" in header[: first.start()] or header.startswith(("namespace", "#", "[")):
        return None
    if first.group(2) in _CONTROL or re.search(r"\b(class|struct|enum|union)\b[^(]*$", header):
        return None
    return first.group(1) or "", first.group(2)


def _functions(text: str) -> list[_Function]:
    """Return the functions that a file defines, outside of other functions' bodies."""
    functions = []
    classes: list[str] = []
    begin = position = 0
    while position < len(text):
        letter = text[position]
        if letter == "}" and classes:
            classes.pop()
        elif letter == "{":
            header = text[begin:position]
            found = _function_name(header)
            if found is None:
                is_class = re.search(r"\b(?:class|struct)\s+(\w+)[^;()]*$", header)
                classes.append(is_class.group(1) if is_class else "")
            else:
                end = _end_of_block(text, position + 1)
                line = text.count("\n", 0, position) + 1
                of = found[0] or next((name for name in reversed(classes) if name), "")
                functions.append(_Function(found[1], of, line, text[position:end]))
                position = end
        if letter in "{};":
            begin = position + 1
        position += 1
    return functions


def _called(text: str) -> set[_Call]:
    """Return what a text calls, but for what it hands to `defer`."""
    text = re.sub(r"\bdefer\s*\(\s*\[.*", "", text, flags=re.DOTALL)
    calls = set()
    for match in _CALL.finditer(text):
        before, how, pointer, name = match.groups()
        if pointer or name not in _CONTROL:
            of = "" if before == "this" or not how else before or "" if how == "::" else "."
            calls.add(_Call(pointer or name, of))
    calls |= {_Call(match.group(), "") for match in _PYTHON.finditer(text)}
    return calls | {_Call(match.group(), "") for match in _SINK.finditer(text)}


def _may_be(call: _Call, caller: str, classes: set[str]) -> set[str]:
    """Return those of `classes` whose function a call may mean; they are all that have one of its name."""
    if call.of == "":
        meant = classes & {"", caller}
    elif call.of == ".":
        meant = classes - {"", caller}
    else:
        meant = classes & {"", call.of}
    return meant or classes


def _under_locks(function: _Function) -> list[tuple[int, str]]:
    """Return line and text of each part of a function that runs while it holds a lock that it has acquired."""
    parts = []
    for match in _LOCK.finditer(function.body):
        end = _end_of_block(function.body, match.end())
        name = match.group(1)
        begin: int | None = function.body.find(";", match.end())
        for event in re.finditer(rf"\b{name}\.(unlock|lock)\(\)|$", function.body[:end]):
            if event.start() <= match.end():
                continue
            if begin is not None and event.group(1) != "lock":
                parts.append(
                    (
                        function.line + function.body.count("\n", 0, begin),
                        function.body[begin : event.start()],
                    )
                )
                begin = None
            elif begin is None and event.group(1) == "lock":
                begin = event.end()
    return parts


def _read(native: Path) -> dict[str, _File]:
    files = {}
    for path in sorted(native.glob("*/*.[ch]pp")):
        source = path.read_text("utf-8")
        text = _code_of(source)
        includes = set(re.findall(r'#include "([^"]+)"', source))
        files[path.relative_to(native).as_posix()] = _File(text, includes, _functions(text))
    return files


def _visible(files: dict[str, _File], name: str) -> set[str]:
    """Return a file, those that it includes, directly or not, and the sources of these."""
    seen: set[str] = set()
    left = [name]
    while left:
        here = left.pop()
        if here in files and here not in seen:
            seen.add(here)
            left += files[here].includes
    return seen | {source for header in seen if (source := header.replace(".hpp", ".cpp")) in files}


def _users_functions(files: dict[str, _File]) -> dict[str, set[str]]:
    """Return for each file, without its ending, the names of variables and members that hold a std::function."""
    aliases = {name for file in files.values() for name in _ALIAS.findall(file.text)}
    types = "|".join([r"std::function<[^;{]*?\)>", *(rf"(?:\w+::)*{alias}\b" for alias in sorted(aliases))])
    declared = re.compile(rf"\b({types})[>&\s]*\s(\w+)\s*(?=[;,){{=])")
    names: dict[str, set[str]] = {}
    for name, file in files.items():
        # Parameters of templates, which are of any type, and types of the file's own.
        others = set(
            re.findall(r"\b(?:class|typename)\s+(\w+)|\busing\s+(\w+)\s*=(?!\s*std::function<)", file.text)
        )
        others_names = {other for pair in others for other in pair}
        found = {variable for kind, variable in declared.findall(file.text) if kind not in others_names}
        names.setdefault(_stem(name), set()).update(found)
    return names


def _stem(name: str) -> str:
    return name.rpartition(".")[0]


def calls_under_locks(native: Path) -> list[str]:
    """Return each place where a function of native/ uses Python or calls a std::function while it holds a lock."""
    files = _read(native)
    out = _users_functions(files)
    visible = {name: _visible(files, name) for name in files}
    defined: dict[tuple[str, str], set[str]] = {}
    ways: dict[tuple[str, str, str], str] = {}
    for name, file in files.items():
        for function in file.functions:
            defined.setdefault((name, function.name), set()).add(function.of)
            function.calls = set() if _DEFERRED in function.body else _called(function.body)

    def way(name: str, caller: _Function, call: _Call) -> str:
        """Return how a call in a file calls out; empty if it doesn't."""
        if call.name in out[_stem(name)] or _PYTHON.fullmatch(call.name) or _SINK.match(call.name + "("):
            return call.name
        here = defined.get((name, call.name), set()) - {"", caller.of} if call.of == "." else set()
        classes = here or {of for other in visible[name] for of in defined.get((other, call.name), ())}
        meant = sorted(_may_be(call, caller.of, classes))
        places = ((other, of, call.name) for other in sorted(visible[name]) for of in meant)
        return next((ways[place] for place in places if place in ways), "")

    size = -1
    while size < len(ways):  # until no further function is known to call out
        size = len(ways)
        for name, file in files.items():
            for function in file.functions:
                found = [found for call in sorted(function.calls) if (found := way(name, function, call))]
                if found:
                    ways.setdefault((name, function.of, function.name), f"{function.name}, {found[0]}")
    return [
        f"{name}:{line} calls {found} under a lock"
        for name, file in files.items()
        for function in file.functions
        if _DEFERRED not in function.body
        for line, part in _under_locks(function)
        for call in sorted(_called(part))
        if (found := way(name, function, call))
    ]

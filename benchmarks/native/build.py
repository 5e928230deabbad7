"""Build the extension as it ships, and without each optimisation; only files affected by an edit are compiled again."""

from __future__ import annotations

import json
import os
import shlex
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from functools import cached_property
from pathlib import Path

import nanobind

from benchmarks.native.plain import HERE, NATIVE, write_plain

ROOT = NATIVE.parent
FOLDER = ROOT / "build" / "benchmarks"
MODULE = "_native"
PROGRAM = "beside_writers"
CORES = os.cpu_count() or 1
UNITY = "Unity"
"""The folder of the sources that CMake writes, which include several files of a target."""


class Build:
    """The build of the extension as it ships. The other builds reuse its unchanged objects."""

    def __init__(self) -> None:
        self.folder = FOLDER / "shipped"
        options = {
            "SKBUILD": "2",  # set by scikit-build-core; CMakeLists.txt builds the extension only if it is set
            "nanobind_DIR": nanobind.cmake_dir(),
            "Python_EXECUTABLE": sys.executable,
            "CMAKE_BUILD_TYPE": "Release",
            "CMAKE_EXPORT_COMPILE_COMMANDS": "ON",
        }
        definitions = [f"-D{key}={value}" for key, value in options.items()]
        run(tool("cmake"), "-S", str(ROOT), "-B", str(self.folder), "-G", "Ninja", *definitions)
        run(tool("ninja"), "-C", str(self.folder))
        self.module = next(self.folder.glob(f"{MODULE}.*"))

    def ninja(self, *arguments: str) -> str:
        return run(tool("ninja"), "-C", str(self.folder), "-t", *arguments)

    @cached_property
    def commands(self) -> dict[str, tuple[Path, list[str]]]:
        """The source and the compiler's command of each object; of some, the source includes several files."""
        entries = json.loads((self.folder / "compile_commands.json").read_text("utf-8"))
        command_of = {}
        for entry in entries:
            source, words = Path(entry["file"]), shlex.split(entry["command"])
            if source.is_relative_to(NATIVE) or source.parent.name == UNITY:
                command_of[words[words.index("-o") + 1]] = (source, words)
        return command_of

    @cached_property
    def headers(self) -> dict[str, set[str]]:
        """The files in `native/` on which each object depends, as paths relative to it."""
        headers_of: dict[str, set[str]] = {}
        target = ""
        for line in self.ninja("deps").splitlines():
            if line.startswith(" "):
                path = Path(os.path.normpath(self.folder / line.strip()))
                if path.is_relative_to(NATIVE):
                    headers_of[target].add(path.relative_to(NATIVE).as_posix())
            elif ": #deps" in line:
                target = line.split(":")[0]
                headers_of[target] = set()
        return headers_of

    def without(self, name: str) -> Plain:
        """Return the extension without `name`; objects that are not up to date are compiled."""
        folder = FOLDER / name.replace(" ", "_")
        changed = write_plain(name, folder / "native")
        objects = {}
        jobs = []
        for made, (source, words) in self.commands.items():
            if not self.headers[made] & changed:
                continue
            target = folder / made.replace("/", "_")
            objects[made] = str(target)
            sources = [self.folder / made, *(folder / "native" / one for one in changed)]
            if target.exists() and target.stat().st_mtime >= max(one.stat().st_mtime for one in sources):
                continue
            command = [words[0], f"-I{folder / 'native'}", *words[1:]]
            command[command.index("-o") + 1] = str(target)
            command[command.index("-c") + 1] = str(edited_source(source, folder, changed))
            jobs.append(command)
        with ThreadPoolExecutor(CORES) as pool:
            for done in pool.map(lambda command: run(*command, folder=self.folder), jobs):
                print(done, end="")
        return Plain(self, folder, objects)


def edited_source(source: Path, folder: Path, changed: set[str]) -> Path:
    """Return the source of an object with the files that are edited in place of the shipped ones."""
    if source.parent.name != UNITY:
        edited = folder / "native" / source.relative_to(NATIVE)
        return edited if edited.exists() else source
    text = source.read_text("utf-8")
    for path in changed:
        text = text.replace(f'"{NATIVE / path}"', f'"{folder / "native" / path}"')
    edited = folder / f"{source.parents[1].stem}_{source.name}"
    edited.write_text(text, "utf-8")
    return edited


class Plain:
    """The objects without one optimisation."""

    def __init__(self, build: Build, folder: Path, objects: dict[str, str]) -> None:
        self._build, self.folder, self.objects = build, folder, objects

    @property
    def core(self) -> list[str]:
        """The objects of the core, which its library has too."""
        return [one for made, one in self.objects.items() if "/tfloom_core" in made]

    @property
    def module(self) -> Path:
        """The extension, linked like the shipped one, with this build's objects first."""
        build = self._build
        module = self.folder / build.module.name
        command = build.ninja("commands", build.module.name).strip().splitlines()[-1]
        words = [self.objects.get(word, word) for word in shlex.split(command) if word not in {":", "&&"}]
        words[words.index("-o") + 1] = str(module)
        archive = words.index("libtfloom_core.a")
        words[archive:archive] = self.core
        run(*words, folder=build.folder)
        return module


def program(build: Build, plain: Plain | None = None) -> Path:
    """Return the path of `beside_writers`, linked with the shipped core or with that of `plain`."""
    folder = plain.folder if plain else build.folder
    core = plain.core if plain else []
    words = next(words for made, (_, words) in build.commands.items() if made.endswith("/tf2/buffer.cpp.o"))
    flags = words[1 : words.index("-o")]
    target = folder / PROGRAM
    includes = [f"-I{folder / 'native'}"] if plain else []
    run(
        words[0], *includes, *flags, str(HERE / f"{PROGRAM}.cpp"), *core, "libtfloom_core.a", "-ldl", "-pthread",
        "-o", str(target), folder=build.folder,
    )  # fmt: skip
    return target


def tool(name: str) -> str:
    path = os.pathsep.join([str(Path(sys.executable).parent), os.environ["PATH"]])
    program = shutil.which(name, path=path)
    if program is None:
        raise SystemExit(f"{name} is not installed: install the dependency group 'build'")
    return program


def run(*command: str, folder: Path | None = None) -> str:
    done = subprocess.run(command, capture_output=True, text=True, check=False, cwd=folder)
    if done.returncode != 0:
        raise SystemExit(f"{shlex.join(command)}\n{done.stdout}{done.stderr}")
    return done.stdout if command[0].endswith("ninja") and "-t" in command else ""

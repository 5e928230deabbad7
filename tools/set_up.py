"""Create the virtual environment of a checkout, or update it: `python3 tools/set_up.py STAGE`.

Each stage includes the ones before it: `demo` has the packages for the demonstration, `test` adds those for the tests
and all extras, `check` the linters, type checkers and the documentation's generator, `bench` the libraries that are
measured beside tfloom. `docs` stands alone: it has what builds the documentation. Each stage also generates the files
that are not in git (tools/generated.py). A second run checks whether anything has changed, and ends at once if not.
`wheels` collects all downloads of the stage `check` in a folder, for a machine without a network.

Only the standard library is imported, because this script runs before anything is installed.
"""

from __future__ import annotations

import argparse
import hashlib
import json
import os
import platform
import re
import shutil
import subprocess
import sys
import sysconfig
import tempfile
import threading
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from functools import partial
from pathlib import Path
from typing import Any

ROOT = Path(__file__).resolve().parents[1]
STAGES: dict[str, tuple[list[str], list[str]]] = {
    "demo": (["build"], []),
    "test": (["test"], ["turtlesim", "transformations", "workspace", "launch", "bag", "robot", "view"]),
    "check": (["check", "docs"], []),
    "bench": (["bench"], []),
    "docs": (["docs"], []),
}
"""The additions of each stage to the one before it: dependency groups, and extras of tfloom."""
ALONE = {"docs"}
"""Stages that need none before them: the documentation is built from the sources, without compiling them."""
PACKAGE = ROOT / "src" / "tfloom"
PACKAGES = ("tfloom-ros2", "tfloom-rviz", "tfloom-interfaces", "tfloom-sensing")
"""Distributions in packages/, installed in the stage `test`, because tests use what they have."""
DDS = "cyclonedds"
OWN_DDS = ROOT / "packages" / "tfloom-ddsc"
"""Holds the same library, for a Python that has no wheel of cyclonedds."""
OLDEST = (3, 10)
"""The oldest Python that tfloom supports."""
RECORD = "tfloom-set-up.json"
"""File in the environment that records the installed stages, with digests of their sources."""
NO_NETWORK = (
    "NewConnectionError",
    "NameResolutionError",
    "ConnectTimeout",
    "Failed to establish",
    "ProxyError",
)
"""Texts that pip prints if it reaches no package index."""
TELL_S = 10.0
"""Time between two lines while it compiles [s]."""
OFFLINE = """\
pip reaches no package index. Without a network, collect what is needed on a machine of the same kind that has one:
    make wheels
copy the folder wheels/ here, and repeat the command with these two variables:
    PIP_NO_INDEX=1 PIP_FIND_LINKS=wheels"""
ELSEWHERE = "Make the folder writable, or name another place: make VENV=FOLDER"
INSTALL_COMMANDS = {
    "debian": "apt-get install",
    "ubuntu": "apt-get install",
    "fedora": "dnf install",
    "rhel": "dnf install",
    "suse": "zypper install",
    "arch": "pacman -S",
    "alpine": "apk add",
}
COMPILER_PACKAGES = {
    "debian": "g++",
    "ubuntu": "g++",
    "fedora": "gcc-c++",
    "rhel": "gcc-c++",
    "suse": "gcc-c++",
    "arch": "gcc",
    "alpine": "g++",
}
HEADER_PACKAGES = {
    "debian": "python3-dev",
    "ubuntu": "python3-dev",
    "fedora": "python3-devel",
    "rhel": "python3-devel",
    "suse": "python3-devel",
    "alpine": "python3-dev",
}
ON_MACOS = "xcode-select --install"
ON_WINDOWS = (
    "no C++ compiler was found; Microsoft's Build Tools bring one: winget install "
    'Microsoft.VisualStudio.2022.BuildTools --override "--passive --wait --add '
    'Microsoft.VisualStudio.Workload.VCTools --includeRecommended"'
)
WINDOWS_COMPILERS = ("cl", "clang-cl", "clang++", "g++")
CXX_20 = (
    "#include <concepts>\n#include <span>\nstatic_assert(std::integral<int>);\nint main() { return 0; }\n"
)


Step = tuple[str, str, Callable[[], object]]
"""A step of an installation: its name, a digest of its inputs, and its function."""


class SetUpError(Exception):
    """The environment cannot be created or updated. The text states what to do."""


def main() -> int:
    """Update the environment to the stage named on the command line; return the exit code."""
    parser = argparse.ArgumentParser(description="Make or update the virtual environment of this checkout.")
    parser.add_argument("stage", choices=[*STAGES, "wheels"])
    parser.add_argument("--venv", type=Path, default=ROOT / ".venv", help="the environment's folder")
    parser.add_argument(
        "--keep-python", action="store_true", help="use an environment of another Python that is there"
    )
    parser.add_argument(
        "--without-dds", action="store_true", help=f"leave {DDS} out, as where it has no wheel"
    )
    options = parser.parse_args()
    try:
        if options.stage == "wheels":
            collect_wheels(ROOT / "wheels")
        else:
            Environment(options.venv.absolute(), options.without_dds).bring_to(
                options.stage, options.keep_python
            )
    except SetUpError as error:
        print(f"set-up: {error}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("\nset-up: interrupted; the next run makes good what is missing", file=sys.stderr)
        return 130
    return 0


class Environment:
    """A virtual environment, and the record of the stages installed in it.

    Args:
        folder: Its path, which need not exist.
        without_dds: Do not install the DDS library.
    """

    def __init__(self, folder: Path, without_dds: bool = False) -> None:
        self.folder = folder
        self.python = folder / ("Scripts/python.exe" if os.name == "nt" else "bin/python")
        self._without_dds = without_dds

    def bring_to(self, stage: str, keep_python: bool) -> None:
        """Install the missing parts of `stage` and of the stages before it.

        Two runs at once on the same environment go one after the other.

        Args:
            stage: A key of STAGES.
            keep_python: Accept an existing environment with another Python.

        Raises:
            SetUpError: a tool is missing, a folder cannot be written, or pip failed.
        """
        with suppress(OSError):  # `make` says why it can't be made
            self.folder.mkdir(parents=True, exist_ok=True)
        with only_one(self.folder):
            self.make(keep_python)
            project = read_project(self.python)
            started = time.monotonic()
            first, *later = up_to(stage)
            is_changed = self._run_missing(self._steps([first], project))
            self._generate()  # with PyYAML of the first stage, before the packages that have generated files
            if self._run_missing(self._steps(later, project)) or is_changed:
                say_ready(started)

    def complete(self, steps: Sequence[Step]) -> None:
        """Run the steps that are not recorded as done, in order.

        Raises:
            SetUpError: a step failed; those before it are recorded.
        """
        started = time.monotonic()
        if self._run_missing(steps):
            say_ready(started)

    def _run_missing(self, steps: Sequence[Step]) -> bool:
        """Run the steps that are not recorded as done, in order; return whether there was one.

        Raises:
            SetUpError: a step failed; those before it are recorded.
        """
        done = self._read_record()
        missing = [(name, digest, step) for name, digest, step in steps if done.get(name) != digest]
        if any(name == "native" for name, _, _ in missing):
            check_compiler()
        for name, digest, step in missing:
            # Recorded first, because a process killed while pip writes leaves incomplete packages.
            self._write_record({**done, "unfinished": name})
            try:
                step()
            # pip has ended by itself, and left what was there before: the environment stays usable. Any other
            # exception, as Ctrl-C, leaves the mark, and the next run makes the environment anew.
            except SetUpError:
                self._write_record(done)
                raise
            done[name] = digest
            self._write_record(done)
        return bool(missing)

    def make(self, keep_python: bool) -> None:
        """Create the environment with this Python, unless a usable one exists.

        Raises:
            SetUpError: it cannot be created.
        """
        reason = self.why_make(keep_python)
        if reason is None:
            return
        say(f"Making {shown(self.folder)} with Python {platform.python_version()}{reason}")
        command = [base_python(), "-I", "-m", "venv", "--clear", str(self.folder)]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        if done.returncode == 0:
            return
        output = done.stdout + done.stderr
        if "ensurepip" in output:
            package = f"python{sys.version_info[0]}.{sys.version_info[1]}-venv"
            raise SetUpError(f"this Python lacks ensurepip; this brings it: apt-get install {package}")
        raise SetUpError(f"can't make {self.folder}: {output.strip()}\n{ELSEWHERE}")

    def why_make(self, keep_python: bool) -> str | None:
        """Return why the environment must be created, as the end of a sentence; None if a usable one exists."""
        try:
            if not os.path.lexists(self.folder) or not any(self.folder.iterdir()):
                return ""
            if not (self.folder / "pyvenv.cfg").is_file():
                raise SetUpError(
                    f"{self.folder} is there and is not a virtual environment: move it away, and repeat"
                )
        except OSError as error:
            raise SetUpError(f"can't use {self.folder}: {error.strerror}. {ELSEWHERE}") from None
        # A folder with pyvenv.cfg is an environment, and is made anew where it can't be completed: by what it lacks, by
        # a run that was killed, by its paths (scripts in it name the folder), or by its Python.
        version = self._version()
        record = self._read_record()
        if version is None:
            return ": in the one that is there, Python or pip doesn't run"
        if "unfinished" in record:
            return ": the one that is there was left unfinished"
        if record.get("folder", str(self.folder)) != str(self.folder):
            return ": the one that is there was made in another folder"
        if version < OLDEST or (version != sys.version_info[:2] and not keep_python):
            return f": the one that is there has Python {version[0]}.{version[1]}"
        return None

    def pip(self, *arguments: str, quietly: bool = False) -> bool:
        """Run pip in the environment, and return whether it succeeded. Print its messages unless `quietly`.

        What it installs is compiled when it is first imported: pip would compile all files, most of which no program
        here imports, and take as long for that as for the rest of the installation. It does so where Python is
        configured to write no compiled files, because each process would compile anew what it imports.

        Raises:
            SetUpError: pip reached no package index, or failed, and `quietly` is false.
        """
        lazily = ["--no-compile"] if arguments[0] == "install" and not sys.dont_write_bytecode else []
        options = [*lazily, "--quiet", "--disable-pip-version-check"]
        command = [str(self.python), "-I", "-m", "pip", *arguments, *options]
        offline = False
        with subprocess.Popen(
            command,
            cwd=ROOT,
            env=os.environ | {"PIP_USER": "0"} | absolute_find_links(),
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            errors="replace",
        ) as process:
            for line in process.stdout or ():
                offline |= any(sign in line for sign in NO_NETWORK)
                if not (quietly or line.startswith("Ignoring ")):  # requirements of other platforms
                    print(line, end="", file=sys.stderr, flush=True)
        if process.returncode == 0 or quietly:
            return process.returncode == 0
        raise SetUpError(OFFLINE if offline else "pip failed; its messages are above")

    def _version(self) -> tuple[int, int] | None:
        """Return the version of the environment's Python; None if it or its pip does not run."""
        code = "import sys, pip._internal.cli.main; print(*sys.version_info[:2])"
        try:
            done = subprocess.run(
                [self.python, "-I", "-c", code], capture_output=True, text=True, check=False
            )
        except OSError:
            return None
        if done.returncode:
            return None
        major, minor = map(int, done.stdout.split())
        return major, minor

    def _steps(self, stages: Sequence[str], project: Mapping[str, Any]) -> list[Step]:
        """Return the steps of stages."""
        steps: list[Step] = []
        for name in stages:
            requirements = requirements_of(project, name)
            steps.append((name, digest_of(requirements), partial(self._download, name, requirements)))
            # The core is compiled anew when its sources or the settings of its build change. Of the Python files, only
            # the one with the version is in the digest, because an editable package reads them from the checkout.
            if name == "demo":
                tool = project["tool"]
                settings = [
                    project["build-system"],
                    project["project"],
                    tool["scikit-build"],
                    tool["dynamic-metadata"],
                ]
                sources = [
                    PACKAGE / "__init__.py",
                    ROOT / "tools" / "wheel_requirements.py",
                    ROOT / "CMakeLists.txt",
                    *sorted((ROOT / "native").rglob("*.?pp")),
                ]
                steps.append(("native", digest_of(settings, sources), self._compile))
            if name == "test":
                for package in PACKAGES:
                    folder = ROOT / "packages" / package
                    sources = sorted(
                        path for path in folder.rglob("*") if path.is_file() and path.suffix != ".pyc"
                    )
                    steps.append((package, digest_of([], sources), partial(self._install, folder)))
        return steps

    def _generate(self) -> None:
        """Bring the generated files of the checkout up to date.

        Raises:
            SetUpError: it failed.
        """
        if subprocess.run([self.python, ROOT / "tools" / "generated.py"], check=False).returncode:
            raise SetUpError("tools/generated.py failed; its messages are above")

    def _download(self, stage: str, requirements: Sequence[str]) -> None:
        dds = [requirement for requirement in requirements if distribution(requirement) == DDS]
        needed = [requirement for requirement in requirements if requirement not in dds]
        say(f"Installing what '{stage}' needs: {', '.join(map(distribution, needed))}")
        self.pip("install", *needed)
        if not dds:
            return
        # The DDS library is optional: it is installed from a wheel or not at all, and a failure of pip is not an error.
        # The search for the module then distinguishes both cases, and also finds a library from an earlier run. Where
        # this Python has no wheel, the library comes from that of another one.
        if not self._without_dds:
            self.pip("install", "--only-binary", DDS, *dds, quietly=True)
            if not self._has(DDS):
                self.pip("install", "--no-build-isolation", str(OWN_DDS), quietly=True)
        if not self._has(DDS, "tfloom_ddsc"):
            say(
                f"{DDS} has no wheel here (Python {platform.python_version()}, {sysconfig.get_platform()}): "
                "processes meet if this system has a libddsc (on Debian and Ubuntu: apt-get install libddsc0t64, or "
                "libddsc0debian on Debian 12); without one, nodes of one process meet on the wire tfloom_local"
            )

    def _has(self, *modules: str) -> bool:
        """Return whether the environment has one of these modules, without importing it."""
        look = f"import importlib.util as u, sys; sys.exit(not any(map(u.find_spec, {modules!r})))"
        return subprocess.run([self.python, "-I", "-c", look], check=False).returncode == 0

    def _compile(self) -> None:
        """Compile native/ and install tfloom as an editable package."""
        say("Compiling what is new in the C++ core: all of it takes half a minute on two cores")
        options = [
            "--no-deps",
            "--no-build-isolation",
            "--config-settings",
            "cmake.define.TFLOOM_WARNINGS_AS_ERRORS=ON",
        ]
        # Without build isolation, so that a second run compiles only the changed files: environments of one Python
        # share the folder of the build.
        with only_one(ROOT), telling_the_time("Still compiling"):
            self.pip("install", *options, "--editable", str(ROOT))

    def _install(self, folder: Path) -> None:
        with only_one(ROOT):
            self.pip("install", "--no-deps", "--no-build-isolation", str(folder))

    def _read_record(self) -> dict[str, str]:
        with suppress(OSError, ValueError):
            record = json.loads((self.folder / RECORD).read_text("utf-8"))
            if isinstance(record, dict):
                return record
        return {}

    def _write_record(self, record: Mapping[str, str]) -> None:
        text = json.dumps({**record, "folder": str(self.folder)}, indent=1)
        (self.folder / RECORD).write_text(f"{text}\n", "utf-8")


def say(text: str) -> None:
    """Print what is done next, or was done, on a line that begins with `--`."""
    print(f"-- {text}", flush=True)


def say_ready(started: float) -> None:
    """Print how long a set-up took that began at `started`, of the monotonic clock."""
    say(f"The environment is ready, after {time.monotonic() - started:.0f} s")


@contextmanager
def telling_the_time(text: str) -> Iterator[None]:
    """Print `text` with the time since the start of the block, every TELL_S, until the block ends."""
    ended = threading.Event()
    started = time.monotonic()

    def tell() -> None:
        while not ended.wait(TELL_S):
            say(f"{text}, for {time.monotonic() - started:.0f} s")

    thread = threading.Thread(target=tell, daemon=True)
    thread.start()
    try:
        yield
    finally:
        ended.set()
        thread.join()


@contextmanager
def only_one(folder: Path) -> Iterator[None]:
    """Keep other set-ups from a folder as long as the block runs; wait, and say so, as long as another one has it.

    The lock is on the folder itself, so it needs no right to write there, and ends with the process. A file system
    without locks, or Windows, has none.
    """
    descriptor = -1
    with suppress(ImportError, OSError):
        import fcntl

        descriptor = os.open(folder, os.O_RDONLY)
        try:
            fcntl.flock(descriptor, fcntl.LOCK_EX | fcntl.LOCK_NB)
        except BlockingIOError:
            say(f"Waiting for another set-up, which is at work in {shown(folder)}")
            fcntl.flock(descriptor, fcntl.LOCK_EX)
    try:
        yield
    finally:
        if descriptor != -1:
            os.close(descriptor)


def collect_wheels(folder: Path) -> None:
    """Collect the wheels of the stages up to `check` in a folder, for a machine without a network."""
    with tempfile.TemporaryDirectory() as scratch:
        environment = Environment(Path(scratch) / "venv")
        environment.make(keep_python=False)
        project = read_project(environment.python)
        requirements = [
            requirement for name in up_to("check") for requirement in requirements_of(project, name)
        ]
        say(f"Collecting wheels in {shown(folder)}")
        environment.pip("wheel", "--wheel-dir", str(folder), *requirements)
        # Where this Python has no wheel of it, `tfloom-ddsc` is built on the other machine from another Python's.
        if not any(folder.glob(f"{DDS}-*.whl")):
            backend = [environment.python, OWN_DDS / "build_backend.py", folder.absolute()]
            subprocess.run(backend, capture_output=True, check=False)  # optional, as everywhere


def absolute_find_links() -> dict[str, str]:
    """Return the variable of pip's folders of wheels, with addresses that a build in another folder can follow.

    Pip splits the variable at spaces, which the address of a folder has none of.
    """
    words = os.environ.get("PIP_FIND_LINKS", "").split()
    links = [(ROOT / word).as_uri() if (ROOT / word).is_dir() else word for word in words]
    return {"PIP_FIND_LINKS": " ".join(links)} if links else {}


def up_to(stage: str) -> list[str]:
    """Return a stage and those before it that it needs, the first one first."""
    if stage in ALONE:
        return [stage]
    names = list(STAGES)
    return names[: names.index(stage) + 1]


def read_project(python: Path) -> dict[str, Any]:
    """Return pyproject.toml, parsed by an environment's Python; before 3.11, by the parser in its pip."""
    code = (
        "import json, sys\n"
        "if sys.version_info >= (3, 11): import tomllib\n"
        "else: from pip._vendor import tomli as tomllib\n"
        "json.dump(tomllib.load(open('pyproject.toml', 'rb')), sys.stdout)"
    )
    done = subprocess.run([python, "-I", "-c", code], capture_output=True, text=True, check=False, cwd=ROOT)
    if done.returncode:
        raise SetUpError(f"can't read {ROOT / 'pyproject.toml'}: {done.stderr.strip()}")
    project: dict[str, Any] = json.loads(done.stdout)
    return project


def requirements_of(project: Mapping[str, Any], stage: str) -> list[str]:
    """Return the additions of a stage to the one before it, as requirements for pip."""
    groups, extras = STAGES[stage]
    own = dependencies_of(project) if stage in {"demo", *ALONE} else []
    if stage in ALONE:
        own = [requirement for requirement in own if distribution(requirement) != DDS]
    grouped = [requirement for group in groups for requirement in project["dependency-groups"][group]]
    extra = [requirement for name in extras for requirement in requirements_of_extra(project, name)]
    return [*grouped, *own, *extra]


def requirements_of_extra(project: Mapping[str, Any], name: str) -> list[str]:
    """Return the requirements of an extra; where it names others of tfloom's, as `tfloom[bag]`, theirs.

    Without this, a command would ask the package index for tfloom.
    """
    requirements: list[str] = []
    for requirement in project["project"]["optional-dependencies"][name]:
        others = re.fullmatch(r"tfloom\[([\w,-]+)\]", requirement)
        if others is None:
            requirements.append(requirement)
        else:
            requirements += [
                one for other in others[1].split(",") for one in requirements_of_extra(project, other)
            ]
    return requirements


def dependencies_of(project: Mapping[str, Any]) -> list[str]:
    """Return what tfloom requires with glibc; see tools/wheel_requirements.py."""
    (table,) = (entry for entry in project["tool"]["dynamic-metadata"] if "dependencies" in entry)
    return [*table["dependencies"], *table["needs-glibc"]]


def distribution(requirement: str) -> str:
    """Return the name in a requirement: 'numpy' of 'numpy>=1.24'."""
    return re.split(r"[^\w.-]", requirement, maxsplit=1)[0]


def digest_of(values: object, files: Sequence[Path] = ()) -> str:
    """Return a digest of values, and of files with their paths."""
    digest = hashlib.sha256(json.dumps(values, sort_keys=True).encode())
    for path in files:
        digest.update(f"\0{path.relative_to(ROOT)}\0".encode() + hashlib.sha256(path.read_bytes()).digest())
    return digest.hexdigest()


def output_of(command: Sequence[object], *, last: int = 20, **options: Any) -> str:
    """Run a command in the checkout, and return what it prints, errors apart. Options are those of `subprocess.run`.

    Raises:
        SetUpError: it failed; the text ends with its last lines, as many as `last`.
    """
    words = [str(word) for word in command]
    done: subprocess.CompletedProcess[str] = subprocess.run(
        words, capture_output=True, text=True, errors="replace", check=False, **{"cwd": ROOT, **options}
    )
    if done.returncode:
        lines = (done.stdout + done.stderr).strip().splitlines()[-last:]
        raise SetUpError(f"{Path(words[0]).name} failed:\n" + "\n".join(lines))
    return done.stdout


def base_python() -> str:
    """Return the interpreter from which this one's environment was created, or this one."""
    return str(getattr(sys, "_base_executable", None) or sys.executable)


def shown(path: Path) -> str:
    """Return a path for messages: relative to the current folder if it is below it."""
    with suppress(ValueError):
        return str(path.relative_to(Path.cwd()))
    return str(path)


def check_compiler() -> None:
    """Raise SetUpError with the package to install if there is no C++20 compiler, or no header of Python."""
    if os.name == "nt":
        if not _has_windows_compiler():
            raise SetUpError(ON_WINDOWS)
        return
    compiler = os.environ.get("CXX") or next(filter(shutil.which, ("c++", "g++", "clang++")), None)
    header = Path(sysconfig.get_path("include")) / "Python.h"
    if compiler is None:
        others = [] if header.is_file() else [HEADER_PACKAGES]
        install = install_command("g++", COMPILER_PACKAGES, *others)
        raise SetUpError(f"no C++ compiler was found; this brings one: {install}")
    with tempfile.TemporaryDirectory() as folder:
        program = Path(folder) / "program.cpp"
        program.write_text(CXX_20)
        # Compiled to an object: zig's compiler fails where nothing is written.
        command = [*compiler.split(), "-std=c++20", "-c", str(program), "-o", str(program.with_suffix(".o"))]
        try:
            done = subprocess.run(command, capture_output=True, text=True, errors="replace", check=False)
        except OSError as error:
            raise SetUpError(
                f"{compiler} can't be started: {error.strerror}; CXX names another compiler"
            ) from None
    if done.returncode and "xcode-select" in done.stderr:  # what macOS has in place of a compiler
        raise SetUpError(f"no C++ compiler was found; this brings one: {ON_MACOS}")
    if done.returncode:
        said = next((f": {line}" for line in done.stderr.splitlines() if "error" in line), "")
        raise SetUpError(
            f"{compiler} compiles no C++20: g++ 12, clang 15 or newer does; CXX names another compiler{said}"
        )
    if not header.is_file():
        install = install_command("Python's C headers", HEADER_PACKAGES)
        raise SetUpError(f"{header} is missing; this brings it: {install}")


def _has_windows_compiler() -> bool:
    """Return whether CMake may find a compiler: one on PATH, or Visual Studio, which has an installer at one place."""
    programs = os.environ.get("PROGRAMFILES(X86)", r"C:\Program Files (x86)")
    installer = Path(programs, "Microsoft Visual Studio", "Installer", "vswhere.exe")
    return "CXX" in os.environ or installer.is_file() or any(map(shutil.which, WINDOWS_COMPILERS))


def install_command(otherwise: str, *packages: Mapping[str, str]) -> str:
    """Return the command that installs system packages on this system.

    Args:
        otherwise: What they are, for a system of which no command is known.
        packages: Of each, its name by system.
    """
    if sys.platform == "darwin":
        return ON_MACOS
    with suppress(OSError, AttributeError):
        release = platform.freedesktop_os_release()
        # ID_LIKE names the distributions that this one derives from, the nearest first.
        for name in (release.get("ID", ""), *release.get("ID_LIKE", "").split()):
            if name in INSTALL_COMMANDS and name in packages[0]:
                names = [names[name] for names in packages if name in names]
                return " ".join([INSTALL_COMMANDS[name], *names])
    return f"your system's package of {otherwise}"


if __name__ == "__main__":
    sys.exit(main())

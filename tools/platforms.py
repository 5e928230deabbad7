"""Run tfloom on other systems, in chroots, and print a table: `python -m tools.platforms [PART …]`, `make platforms`.

`testing`, `unstable` and `debian13` are Debian's on this processor, with its newest Python, the next one and 3.13:
README's `make demo`, then tests. `arm64` is Debian 13 on arm64, whose programs qemu-user runs: the extension is
cross-compiled here; there the demonstration, tests, and a talk with nodes of this machine, over the loopback interface
that both share. `musl` is Debian 13 with a Python on the C library of Alpine, compiled by tools/python_on_musl.sh. With
`--short`, only the checks that take less than five minutes on two quiet cores, and on musl the Python they need. It
needs these packages of Debian, and to be root, because of chroots, mounts and binfmt_misc:

    apt-get install mmdebstrap qemu-user-static g++-aarch64-linux-gnu
"""

from __future__ import annotations

import argparse
import os
import re
import shlex
import shutil
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager, nullcontext, suppress
from functools import partial
from pathlib import Path
from typing import Any, NamedTuple

from tools.set_up import PACKAGES as PACKAGES_OF_TESTS
from tools.set_up import (
    ROOT,
    SetUpError,
    distribution,
    only_one,
    output_of,
    read_project,
    requirements_of,
    say,
)

FOLDER = ROOT / "build" / "platforms"
HERE = "root/tfloom"
"""The checkout's folder in a chroot."""
CORE = "tests/tf2 tests/rosidl tests/kdl tests/test_walk.py"
TESTS = {
    "core tests": CORE,
    "tests of the wire": "tests/rmw",
    "tests of nodes": "tests/node",
    "tests of tf2_ros": "tests/tf2_ros",
    "tests of commands": "tests/cli",
}
"""The tests of each system, by what they are named in the table."""
TESTS_ON_DDS_0_10 = (
    *(
        f"tests/rmw/test_{name}.py"
        for name in (
            "cyclonedds",
            "cyclonedds_processes",
            "cyclone_graph",
            "cyclone_config",
            "events",
            "services",
            "loopback",
            "library_self_test",
        )
    ),
    "tests/node/wire/test_forks.py",
)
"""Those on a distribution's libddsc: discovery, data, events, services, sockets and forks."""
TESTS_ON_ARM64 = {
    "core tests": "tests/tf2 tests/kdl tests/rosidl/test_cdr.py tests/rosidl/test_runtime.py",
    "tests of the wire": " ".join(
        f"tests/rmw/test_{name}.py"
        for name in (
            "library_self_test",
            "core",
            "cyclonedds",
            "services",
            "events",
            "loopback",
            "zenoh_wire",
        )
    ),
    "tests of nodes": "tests/node/wire/test_services.py tests/node/wire/test_parameters.py tests/node/test_service.py",
    "tests of tf2_ros": "tests/tf2_ros/test_listener.py tests/tf2_ros/test_wire.py tests/tf2_ros/test_point_cloud.py",
}
"""Those on arm64: each layer of what an emulated processor can do differently. All of `TESTS` would take hours there;
tests of deadlines, which the emulator misses, would also fail."""
SHORT_TESTS = "tests/tf2/test_arrays.py tests/tf2/test_vectors.py tests/kdl"
"""Those that run first on arm64: with the paths of `native/` that are written for its processor."""
CERTIFICATES = Path("/etc/ssl/certs/ca-certificates.crt")
TOOLS = "g++ make git ca-certificates binutils iproute2 faketime"
SUITES = {"testing": "testing", "unstable": "sid", "debian13": "trixie", "arm64": "trixie", "musl": "trixie"}
PYTHONS = {"testing": "python3", "unstable": "python3.15", "debian13": "python3"}
"""The Python of each system of this processor, by the name of its command."""
PACKAGES = {name: f"{python} {python}-venv {python}-dev {TOOLS}" for name, python in PYTHONS.items()}
PACKAGES["debian13"] += " libddsc0t64"
PACKAGES |= {
    "arm64": "base-files bash coreutils dash findutils grep procps sed python3 python3-dev python3-numpy python3-yaml "
    "python3-argcomplete python3-pil python3-reportlab python3-psutil python3-rich python3-pytest python3-pytest-xdist "
    "python3-pytest-rerunfailures python3-hypothesis python3-pandas python3-transforms3d python3-scipy python3-xxhash "
    "libddsc0t64",
    "musl": "musl python3-venv make git ca-certificates binutils perl tcl autoconf automake libtool libltdl-dev "
    "pkgconf xz-utils",
}
ON_MUSL = "/opt/musl"
"""The folder in which tools/python_on_musl.sh puts a Python and its compilers."""
NOT_ON_MUSL = {"eclipse-zenoh", "opencv-python-headless", "pygame-ce"}
"""What tests of other folders need, and what has no wheel for musl: it would be compiled for long, or with Rust."""
WIDE_VECTORS = "tests/tf2/test_vectors.py::test_wide_vectors_are_used_where_the_processor_has_them"
TESTS_ON_MUSL = TESTS | {"core tests": f"{CORE} --deselect {WIDE_VECTORS}"}
"""zig's runtime, unlike g++'s on Alpine, doesn't report what the processor has."""
ARM64_MAGIC = (
    r":M::\x7fELF\x02\x01\x01\x00\x00\x00\x00\x00\x00\x00\x00\x00\x02\x00\xb7\x00"
    r":\xff\xff\xff\xff\xff\xff\xff\x00\xff\xff\xff\xff\xff\xff\xff\xff\xfe\xff\xff\xff:/usr/bin/qemu-aarch64-static:F"
)
"""What registers qemu for programs of arm64, after a colon and a name.

By the flag F the kernel opens qemu when it is registered, so that no chroot needs it.
"""
BINFMT = Path("/proc/sys/fs/binfmt_misc")
TALK_DOMAIN = "93"
TALK_S = 90.0
END_S = 20.0
"""How long an interrupted command has to end its own programs [s]."""
WHEEL_OF_ANOTHER_PYTHON = (
    "pip install --no-deps --target DIR --python-version 3.13 --only-binary=:all: cyclonedds==11.0.1"
)
"""What the documentation and an error say for a Python without a wheel of cyclonedds; DIR is then on PYTHONPATH."""
COUNTS = re.compile(r"\d+ (?:passed|failed|skipped|errors?|rerun)\b")


class Row(NamedTuple):
    """What was run, what came of it, and how long it took."""

    system: str
    what: str
    result: str
    seconds: float
    is_good: bool


class Check(NamedTuple):
    """One row of the table, not yet run.

    Args:
        run: Returns whether it succeeded, and what came of it.
        is_short: Whether it takes less than five minutes.
    """

    what: str
    run: Callable[[], tuple[bool, str]]
    is_short: bool = True


class Chroot:
    """A system in a separate folder.

    Args:
        name: A key of `SUITES`; the folder is named so.
        architecture: Debian's name of its processor.
    """

    def __init__(self, name: str, architecture: str) -> None:
        self.name = name
        self.folder = FOLDER / name
        self._architecture = architecture

    def create(self, variant: str) -> tuple[bool, str]:
        """Install Debian anew, by a variant of mmdebstrap; return that this has succeeded, for a row.

        Raises:
            SetUpError: mmdebstrap failed.
        """
        shutil.rmtree(self.folder, ignore_errors=True)
        self.folder.parent.mkdir(parents=True, exist_ok=True)
        # In a mount namespace, as in `command`: it mounts /proc and /dev while it installs.
        command = ["unshare", "--mount", "mmdebstrap"]
        command += [f"--variant={variant}", f"--architectures={self._architecture}"]
        # A mirror may be a snapshot, whose index has expired; its signature is checked in any case.
        command += [
            "--aptopt=Acquire::Check-Valid-Until false",
            f"--include={PACKAGES[self.name].replace(' ', ',')}",
        ]
        succeed([*command, SUITES[self.name], self.folder])
        # Scripts of packages, which the variant `extract` leaves out, merge these into /usr.
        for name in ("proc", "dev", HERE):
            (self.folder / name).mkdir(parents=True, exist_ok=True)
        for name in ("bin", "sbin", "lib"):
            if not (self.folder / name).exists():
                (self.folder / name).symlink_to(f"usr/{name}")
        for name in ("blas", "lapack"):
            for library in self.folder.glob(f"usr/lib/*/{name}/lib{name}.so.3"):
                if not (link := library.parents[1] / library.name).exists():
                    link.symlink_to(f"{name}/{library.name}")
        for file in (Path("/etc/resolv.conf"), Path("/etc/hosts"), CERTIFICATES):
            if file.exists():
                (self.folder / file.relative_to("/")).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(file, self.folder / file.relative_to("/"))
        return True, "ready"

    def command(self, text: str, **variables: str) -> list[str]:
        """Return the command that runs a line of shell in the checkout there, with a separate set of variables."""
        kept = {name: value for name, value in os.environ.items() if name.startswith("PIP_INDEX")}
        environment = {
            "PATH": "/usr/sbin:/usr/bin:/sbin:/bin",
            "HOME": "/root",
            "LANG": "C.UTF-8",
            "PIP_CERT": str(CERTIFICATES),
            **kept,
            **variables,
        }
        words = [f"{name}={value}" for name, value in environment.items()]
        # In a separate mount namespace, so that what is mounted is gone with the command, however it ends: a folder
        # in which /dev of this machine stays mounted must not be removed.
        mounts = 'mount -t proc proc "$0/proc" && mount --rbind /dev "$0/dev" && exec env -i "$@"'
        inside = [*words, "chroot", str(self.folder), "sh", "-c", f"cd /{HERE} && {text}"]
        return ["unshare", "--mount", "sh", "-c", mounts, str(self.folder), *inside]

    def end_programs(self) -> None:
        """End the programs that run in there: what an interrupted command had started."""
        for process in Path("/proc").glob("[0-9]*"):
            with suppress(OSError):  # it has ended, or is a thread of the kernel
                if (process / "root").readlink() == self.folder:
                    os.kill(int(process.name), signal.SIGKILL)


def completed(command: Sequence[str | Path], **options: Any) -> subprocess.CompletedProcess[str]:
    """Run a command to its end, as subprocess.run does.

    If this program is interrupted meanwhile, the command and its children are, too: those that run in a terminal of
    their own would not receive the signal.
    """
    numbers = {signal.SIGINT, signal.SIGTERM}
    mask = signal.pthread_sigmask(
        signal.SIG_BLOCK, numbers
    )  # or a signal while it starts would leave it behind
    try:
        with subprocess.Popen(
            command,
            start_new_session=True,
            text=True,
            preexec_fn=partial(signal.pthread_sigmask, signal.SIG_SETMASK, mask),  # noqa: PLW1509  # no other thread
            **options,
        ) as process:
            try:
                signal.pthread_sigmask(signal.SIG_SETMASK, mask)
                output, errors = process.communicate()
            except BaseException:
                for number in (signal.SIGINT, signal.SIGKILL):
                    with suppress(ProcessLookupError):
                        os.killpg(process.pid, number)
                    with suppress(subprocess.TimeoutExpired):
                        process.wait(END_S)
                raise
    finally:
        signal.pthread_sigmask(signal.SIG_SETMASK, mask)
    return subprocess.CompletedProcess(command, process.returncode, output, errors)


@contextmanager
def ended_by_sigterm() -> Iterator[None]:
    """Have SIGTERM raise SystemExit as long as the block runs, so that all is put back."""
    previous = signal.signal(signal.SIGTERM, lambda *_: sys.exit(128 + signal.SIGTERM))
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, previous)


def export_checkout(folder: Path) -> None:
    """Write the last commit's files to a folder."""
    shutil.rmtree(folder, ignore_errors=True)
    folder.mkdir(parents=True)
    archive = subprocess.run(["git", "archive", "HEAD"], cwd=ROOT, capture_output=True, check=True)
    subprocess.run(["tar", "x", "-C", folder], input=archive.stdout, check=True)


def measured(system: str, what: str, run: Callable[[], tuple[bool, str]]) -> Row:
    """Run one check, print its row, and return it."""
    started = time.monotonic()
    try:
        is_good, result = run()
    except (SetUpError, subprocess.SubprocessError, OSError) as error:
        is_good, result = False, str(error)
    row = Row(system, what, " ".join(result.split()), time.monotonic() - started, is_good)
    say(f"{row.system}: {row.what}: {row.result} ({row.seconds / 60:.1f} min)")
    return row


def run_in(chroot: Chroot, text: str, log: str, **variables: str) -> tuple[bool, str]:
    """Run a line of shell in a chroot; return whether it succeeded, and pytest's counts or the last line it printed."""
    path = log_path(chroot, log)
    with path.open("w", encoding="utf-8") as file:
        code = completed(chroot.command(text, **variables), stdout=file, stderr=subprocess.STDOUT).returncode
    lines = log_lines(chroot, log) or [f"exit code {code}, and nothing printed"]
    counts = total_counts(lines)
    return code == 0, counts or (lines[-1] if code else "ran") + (f"; see {path}" if code else "")


def log_path(chroot: Chroot, log: str) -> Path:
    """Return the file with the output of a command in a chroot."""
    return FOLDER / f"{chroot.name}_{log}.log"


def log_lines(chroot: Chroot, log: str) -> list[str]:
    """Return the lines that a command has printed in a chroot."""
    return log_path(chroot, log).read_text("utf-8", errors="replace").strip().splitlines()


def total_counts(lines: Sequence[str]) -> str:
    """Return the sums of pytest's summaries: `812 passed, 3 skipped`; empty if there are none."""
    totals: dict[str, int] = {}
    for line in lines:
        if " in " in line and (found := COUNTS.findall(line)):
            for number, word in map(str.split, found):
                totals[word] = totals.get(word, 0) + int(number)
    return ", ".join(f"{number} {word}" for word, number in totals.items())


def run_all(system: str, checks: Sequence[Check], *, is_short: bool) -> list[Row]:
    """Run the checks of a system, or only the short ones; return the rows."""
    return [measured(system, check.what, check.run) for check in checks if check.is_short or not is_short]


def run_native(name: str, *, is_short: bool) -> list[Row]:
    """Run README's two commands on a Debian of this processor."""
    chroot = Chroot(name, output_of(["dpkg", "--print-architecture"]).strip())
    rows = [measured(f"Debian {name}", "installed", lambda: chroot.create("minbase"))]
    if not rows[0].is_good:
        return rows
    export_checkout(chroot.folder / HERE)
    make = f"make PYTHON={PYTHONS[name]}"
    demo = f'{make} demo ARGS="--seconds 8" && .venv/bin/tfloom doctor'
    checks = [Check("make demo", partial(run_in, chroot, demo, "demo")), *talks(chroot, ".venv/bin/tfloom")]
    tests = {what: f'{make} test ARGS="--quiet {paths}"' for what, paths in TESTS.items()}
    if name == "debian13":
        files = " ".join(TESTS_ON_DDS_0_10)
        with_older = f'TFLOOM_LIBDDSC={installed_library(chroot)} {make} test ARGS="--quiet {files}"'
        tests["tests of the wire on libddsc 0.10"] = with_older
    else:
        checks.append(
            Check("pip install … cyclonedds", partial(run_in, chroot, other_wheel(), "other_wheel"))
        )
    checks += [
        Check(what, partial(run_in, chroot, command, log_name(what)), is_short=False)
        for what, command in tests.items()
    ]
    system = f"Debian {name}, {chroot_output(chroot, f'{PYTHONS[name]} --version')}"
    return rows + run_all(system, checks, is_short=is_short)


def installed_library(chroot: Chroot) -> str:
    """Return the path, in a chroot, of its system's libddsc."""
    library = next((chroot.folder / "usr/lib").glob("*/libddsc.so.0.10.*"))
    return f"/{library.relative_to(chroot.folder)}"


def other_wheel() -> str:
    """Return the commands that have tfloom take libddsc from another Python's wheel, instead of its own."""
    folder = "/tmp/cyclonedds"  # noqa: S108  # that of a chroot
    return (
        f".venv/bin/{WHEEL_OF_ANOTHER_PYTHON.replace('DIR', folder)} && "
        "own=$(echo .venv/lib/python3*/site-packages/tfloom_ddsc) && mv $own /tmp/own && "
        f"{{ PYTHONPATH={folder} .venv/bin/tfloom doctor | grep 'of the wheel of cyclonedds'; code=$?; }} && "
        "mv /tmp/own $own && exit $code"
    )


def log_name(what: str) -> str:
    """Return the name of a check in that of its log."""
    return what.replace(" ", "_")


def chroot_output(chroot: Chroot, text: str) -> str:
    """Return what a command prints in a chroot."""
    done = completed(chroot.command(text), stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    return done.stdout.strip()


@contextmanager
def mounted_binfmt() -> Iterator[None]:
    """Have binfmt_misc mounted as long as the block runs; unmount it if it wasn't, and nothing else is registered."""
    is_own = not (BINFMT / "register").exists()
    if is_own:
        succeed(["mount", "-t", "binfmt_misc", "binfmt_misc", BINFMT])
    try:
        yield
    finally:
        if is_own and not registrations():
            succeed(["umount", BINFMT])


def registrations() -> list[Path]:
    """Return what is registered in binfmt_misc."""
    return [entry for entry in BINFMT.iterdir() if entry.name not in {"register", "status"}]


def tell_kernel(file: Path, text: str) -> None:
    """Write to one of its files, where a single write is one command."""
    file.write_text(text)


def runs_arm64(entry: Path) -> bool:
    """Return whether a registration of binfmt_misc runs programs of arm64 in any chroot."""
    lines = entry.read_text().splitlines()
    magic = ARM64_MAGIC.split(":")[3].encode().decode("unicode_escape").encode("latin-1").hex()
    flags = next((line.removeprefix("flags:") for line in lines if line.startswith("flags:")), "")
    return "enabled" in lines and f"magic {magic}" in lines and "F" in flags


@contextmanager
def arm64_programs() -> Iterator[None]:
    """Have the kernel run programs of arm64 by qemu as long as the block runs, and leave it as it was.

    Raises:
        SetUpError: binfmt_misc can't be mounted or written.
    """
    with mounted_binfmt():
        if any(map(runs_arm64, registrations())):
            yield
            return
        # A name of this process, because another checkout may run at the same time.
        own = BINFMT / f"tfloom-arm64-{os.getpid()}"
        try:
            tell_kernel(BINFMT / "register", f":{own.name}{ARM64_MAGIC}")
        except OSError as error:
            raise SetUpError(f"qemu can't be registered in {BINFMT}: {error}") from None
        try:
            yield
        finally:
            tell_kernel(own, "-1")


def build_for_arm64(chroot: Chroot) -> tuple[bool, str]:
    """Cross-compile the extension for a chroot's Python, with its bindings, and put tfloom there as its wheel would."""
    build = FOLDER / "arm64_build"
    (python,) = (path for path in (chroot.folder / "usr/bin").glob("python3.*") if path.name[9:].isdigit())
    options = {
        "CMAKE_SYSTEM_NAME": "Linux",
        "CMAKE_SYSTEM_PROCESSOR": "aarch64",
        "CMAKE_CXX_COMPILER": "aarch64-linux-gnu-g++",
        "CMAKE_BUILD_TYPE": "Release",
        "CMAKE_INSTALL_PREFIX": str(chroot.folder / "usr/lib/python3/dist-packages"),
        "SKBUILD": "2",
        "TFLOOM_WARNINGS_AS_ERRORS": "ON",
        # CMake reads version and file names from the target's Python, which qemu runs, with that system's libraries.
        "Python_EXECUTABLE": str(python),
        "Python_INCLUDE_DIR": str(chroot.folder / "usr/include" / python.name),
        "nanobind_DIR": output_of([sys.executable, "-m", "nanobind", "--cmake_dir"]).strip(),
    }
    environment = os.environ | {"QEMU_LD_PREFIX": str(chroot.folder)}
    beside = Path(sys.executable).parent
    tools = os.pathsep.join([str(beside), environment["PATH"]])
    environment |= {"PATH": tools, "CXXFLAGS": f"-isystem {link_headers(chroot, python.name)}"}
    defined = [f"-D{name}={value}" for name, value in options.items()]
    succeed(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", *defined], environment)
    succeed(["cmake", "--build", build], environment)
    succeed(["cmake", "--install", build], environment)
    return True, "compiled and linked, bindings included"


def link_headers(chroot: Chroot, python: str) -> Path:
    """Return a folder with a link to that part of Python's headers which Debian has in a folder of the processor's.

    The others name it by `aarch64-linux-gnu/python3.13/pyconfig.h`. The folder above has the headers of that system's C
    library, which the cross-compiler must not see beside its own.
    """
    folder = FOLDER / "arm64_headers"
    shutil.rmtree(folder, ignore_errors=True)
    (folder / "aarch64-linux-gnu").mkdir(parents=True)
    link = folder / "aarch64-linux-gnu" / python
    link.symlink_to(chroot.folder / "usr/include" / link.relative_to(folder))
    return folder


def succeed(command: Sequence[str | Path], environment: Mapping[str, str] | None = None) -> None:
    """Run a command in the checkout.

    Raises:
        SetUpError: it failed; the text has its last lines.
    """
    done = completed(command, cwd=ROOT, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    if done.returncode:
        lines = done.stdout.splitlines()[-15:]
        name = next(Path(word).name for word in command if word not in {"unshare", "--mount"})
        raise SetUpError(f"{name} failed:\n" + "\n".join(lines))


PROGRAM = "#!/usr/bin/python3\nimport sys\n\nfrom tfloom.cli.main import main\n\nsys.exit(main())\n"
PATIENT_DEMO = (
    "import sys, tfloom.demos.show as show, tfloom.cli.main as m; show.PATIENCE_S = 400.0; sys.exit(m.main())"
)
"""The command `ros2`, whose demonstration waits ten times as long for its programs, because the emulator is slow."""
PURE_PACKAGES = (
    "rosbags<0.12",
    "pytest>=9",
    "pytest-xdist>=3.7",
    "pytest-rerunfailures>=16.3",
    "hypothesis>=6.140,<6.156",  # Debian's warns by mistake about its own object; later ones are compiled
    "./packages/tfloom-ros2",
    "./packages/tfloom-rviz",
    "./packages/tfloom-interfaces",
)
"""What the tests need and Debian hasn't, or not as new."""
COMPILED_PACKAGE = "eclipse-zenoh>=1.10,<2"
"""What tfloom's wire on Zenoh needs, compiled for each processor."""


def install_for_arm64(chroot: Chroot) -> tuple[bool, str]:
    """Put what tfloom's wheel installs into a chroot, beside the extension, with commands and compiled modules."""
    packages = chroot.folder / "usr/lib/python3/dist-packages"
    export_checkout(chroot.folder / HERE)
    wheels = FOLDER / "arm64_wheels"
    shutil.rmtree(wheels, ignore_errors=True)
    pip: list[str | Path] = [sys.executable, "-m", "pip", "--quiet", "--disable-pip-version-check"]
    build: list[str | Path] = [*pip, "wheel", "--no-deps", "--no-build-isolation", "--wheel-dir", wheels]
    succeed([*build, "-C", "wheel.cmake=false", "."])
    succeed([*build, *PURE_PACKAGES])
    succeed(
        [
            *pip,
            "install",
            "--no-deps",
            "--no-compile",
            "--upgrade",
            "--target",
            packages,
            *wheels.glob("*.whl"),
        ]
    )
    of_arm64 = ["--platform", "manylinux_2_28_aarch64", "--only-binary=:all:", "--no-deps", "--no-compile"]
    succeed([*pip, "install", *of_arm64, "--upgrade", "--target", packages, COMPILED_PACKAGE])
    for name in ("tfloom", "ros2"):
        program = chroot.folder / "usr/bin" / name
        program.write_text(PROGRAM)
        program.chmod(0o755)
    # Without compiled modules each program would compile all that it imports, in the emulator.
    return run_in(chroot, "python3 -m compileall -q -j 0 /usr/lib/python3/dist-packages/tfloom", "compile")


def talks(chroot: Chroot, command_there: str) -> list[Check]:
    """Return the checks of a talk with this machine, both ways, where `command_there` starts tfloom in the chroot."""
    return [
        Check("a talker there, a listener here", partial(talk, chroot, command_there, speaks_there=True)),
        Check("a talker here, a listener there", partial(talk, chroot, command_there, speaks_there=False)),
    ]


def talk(chroot: Chroot, command_there: str, *, speaks_there: bool) -> tuple[bool, str]:
    """Have a talker on one side, and a listener on the other, over the loopback interface."""
    domain = {"ROS_DOMAIN_ID": TALK_DOMAIN}
    ours = os.environ | domain | {"PYTHONUNBUFFERED": "1"}
    command = str(Path(sys.executable).with_name("tfloom"))
    sides = {
        program: (
            chroot.command(
                f"exec {command_there} run demo_nodes_py {program}", PYTHONUNBUFFERED="1", **domain
            )
            if is_there
            else [command, "run", "demo_nodes_py", program]
        )
        for program, is_there in (("talker", speaks_there), ("listener", not speaks_there))
    }
    log = log_path(chroot, f"talker_{'there' if speaks_there else 'here'}")
    with (
        log.open("w", encoding="utf-8") as output,
        subprocess.Popen(sides["talker"], env=ours, stdout=output, stderr=output) as talker,
        subprocess.Popen(sides["listener"], env=ours, stdout=output, stderr=output) as listener,
    ):
        try:
            end = time.monotonic() + TALK_S
            while "I heard: [Hello World" not in log.read_text("utf-8") and time.monotonic() < end:
                time.sleep(0.2)
        finally:
            for process in (talker, listener):
                process.send_signal(signal.SIGINT)
    has_heard = "I heard: [Hello World" in log.read_text("utf-8")
    return has_heard, "heard" if has_heard else f"nothing was heard; see {log}"


@contextmanager
def without_library(chroot: Chroot) -> Iterator[None]:
    """Take libddsc away from a chroot as long as the block runs."""
    libraries = list((chroot.folder / "usr/lib").rglob("libddsc.so.*"))
    for library in libraries:
        library.rename(library.with_name(f"away.{library.name}"))
    try:
        yield
    finally:
        for library in libraries:
            library.with_name(f"away.{library.name}").rename(library)


def demo_on_arm64(chroot: Chroot, *, has_library: bool) -> tuple[bool, str]:
    """Run the demonstration, over DDS or without its library; return the line in which it says so."""
    demo = f"mkdir -p /tmp/demo && cd /tmp/demo && python3 -c '{PATIENT_DEMO}' demo --seconds 8"
    log = "demo" if has_library else "demo_without_libddsc"
    with nullcontext() if has_library else without_library(chroot):
        is_good, result = run_in(chroot, f"{demo} && ros2 doctor" if has_library else demo, log)
    said = next(
        (
            line
            for line in log_lines(chroot, log)
            if line.startswith(("They meet over DDS", "No DDS library"))
        ),
        "",
    )
    is_told = said.startswith("They meet over DDS" if has_library else "No DDS library")
    return is_good and is_told, said if is_good else result


def run_arm64(*, is_short: bool) -> list[Row]:
    """Run the demonstration, tests and a talk on Debian 13 for arm64."""
    chroot = Chroot("arm64", "arm64")
    # The other variants of mmdebstrap run the packages' scripts, each under qemu.
    rows = [measured("Debian 13, arm64", "installed", lambda: chroot.create("extract"))]
    if not rows[0].is_good:
        return rows
    with arm64_programs():
        system = f"Debian 13, arm64, {chroot_output(chroot, 'python3 --version')}"
        # Two workers, because an emulated program computes where a native one would wait. The random cases of one test
        # take minutes there, so the limit for a test that hangs is longer, and Hypothesis's profile has none. The
        # emulator may stall for seconds, so a test has a second try, which the counts name, as in the CI.
        tests = "python3 tools/run_tests.py --quiet -n2 --hypothesis-profile=ci -o faulthandler_timeout=1800"
        checks = [
            Check("its wheel, unpacked", lambda: install_for_arm64(chroot)),
            Check("the extension", lambda: build_for_arm64(chroot)),
            Check("ros2 demo", lambda: demo_on_arm64(chroot, has_library=True)),
            Check("ros2 demo without libddsc", lambda: demo_on_arm64(chroot, has_library=False)),
            *talks(chroot, "tfloom"),
        ]
        special = partial(run_in, chroot, f"{tests} {SHORT_TESTS}", "short_tests", CI="1")
        checks.append(Check("paths for the processor", special, is_short=False))
        checks += [
            Check(
                f"{what}: {paths}",
                partial(run_in, chroot, f"{tests} {paths}", log_name(what), CI="1"),
                is_short=False,
            )
            for what, paths in TESTS_ON_ARM64.items()
        ]
        return rows + run_all(system, checks, is_short=is_short)


def run_on_musl(*, is_short: bool) -> list[Row]:
    """Run README's `make demo`, `pip install` and tests with a Python on musl."""
    chroot = Chroot("musl", output_of(["dpkg", "--print-architecture"]).strip())
    rows = [measured("musl", "installed", lambda: chroot.create("minbase"))]
    if rows[-1].is_good:
        export_checkout(chroot.folder / HERE)
        rows.append(
            measured("musl", "Python", partial(run_in, chroot, "sh tools/python_on_musl.sh", "python"))
        )
    if not rows[-1].is_good:
        return rows
    python = f"{ON_MUSL}/bin/python3"
    compilers = {"CC": f"{ON_MUSL}/cc", "CXX": f"{ON_MUSL}/c++"}
    packages = [
        requirement
        for requirement in requirements_of(read_project(Path(sys.executable)), "test")
        if distribution(requirement) not in NOT_ON_MUSL
    ]
    packages += [f"./packages/{name}" for name in PACKAGES_OF_TESTS]
    venv = "/tmp/venv"  # noqa: S108 - of the chroot
    install = (
        f"{python} -m venv {venv} && {venv}/bin/pip install --quiet . && {venv}/bin/tfloom demo --seconds 8"
    )
    commands = {
        "make demo": f'make PYTHON={python} demo ARGS="--seconds 8"',
        "pip install .; tfloom demo": install,
        "what the tests need": f".venv/bin/pip install --quiet {shlex.join(packages)}",
    }
    commands |= {
        what: f".venv/bin/python tools/run_tests.py --quiet --no-timing {paths}"
        for what, paths in TESTS_ON_MUSL.items()
    }
    checks = [
        Check(
            what,
            partial(run_in, chroot, command, log_name(what), **compilers),
            is_short=what not in TESTS_ON_MUSL,
        )
        for what, command in commands.items()
    ]
    return rows + run_all(f"musl, {chroot_output(chroot, f'{python} --version')}", checks, is_short=is_short)


PARTS: dict[str, Callable[..., list[Row]]] = {name: partial(run_native, name) for name in PYTHONS} | {
    "arm64": run_arm64,
    "musl": run_on_musl,
}


def run_part(part: str, *, is_short: bool) -> list[Row]:
    """Run the checks of a part, and leave none of its programs behind; return the rows."""
    try:
        return PARTS[part](is_short=is_short)
    except (SetUpError, OSError) as error:
        return [Row(part, "prepared", " ".join(str(error).split()), 0.0, is_good=False)]
    finally:
        Chroot(part, "").end_programs()


def missing_tools() -> str:
    """Return why this machine can't run the parts; empty if it can."""
    if sys.platform != "linux" or os.geteuid() != 0:
        return "it makes chroots, mounts and registers in binfmt_misc, for which it must be root on Linux"
    commands = {
        "mmdebstrap": "mmdebstrap",
        "qemu-aarch64-static": "qemu-user-static",
        "aarch64-linux-gnu-g++": "g++-aarch64-linux-gnu",
    }
    missing = [package for command, package in commands.items() if shutil.which(command) is None]
    return f"these bring what it needs: apt-get install {' '.join(missing)}" if missing else ""


def main() -> int:
    """Run the parts, print the table, and return the exit code: 1 if something failed, 3 if it can't run here."""
    parser = argparse.ArgumentParser(description="Run tfloom on other systems, in chroots.")
    parser.add_argument("parts", nargs="*", metavar="PART", help=f"{' or '.join(PARTS)}; without one, all")
    parser.add_argument("--short", action="store_true", help="only the checks of less than five minutes")
    options = parser.parse_args()
    parts = options.parts or list(PARTS)
    if unknown := set(parts) - set(PARTS):
        parser.error(f"there is no part {', '.join(sorted(unknown))}: name {' or '.join(PARTS)}")
    if reason := missing_tools():
        print(f"platforms: {reason}", file=sys.stderr)
        return 3
    FOLDER.mkdir(parents=True, exist_ok=True)
    with (
        ended_by_sigterm(),
        only_one(FOLDER),  # another run would remove the chroots of this one
    ):
        rows = [row for part in parts for row in run_part(part, is_short=options.short)]
    print("| system | what | result | minutes |\n|---|---|---|---|")
    for row in rows:
        print(f"| {row.system} | {row.what} | {row.result} | {row.seconds / 60:.1f} |")
    return 0 if all(row.is_good for row in rows) else 1


if __name__ == "__main__":
    sys.exit(main())

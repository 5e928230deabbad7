"""Common fixtures: a DDS domain for each test, and programs that end with the test."""

from __future__ import annotations

import gc
import os
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Callable, Generator, Iterator, Mapping, Sequence
from contextlib import contextmanager, suppress
from pathlib import Path

import psutil
import pytest

from tfloom.node.context.context import Context
from tfloom.node.node import Node
from tfloom.rmw.cyclone.library import find_library
from tfloom.rmw.cyclone.ports import bound_indices
from tfloom.rmw.errors import NoBackendError
from tfloom.testing import domains

TIMEOUT_S = 90.0 if os.environ.get("CI") else 30.0
"""The longest wait for a condition [s]. A shared machine may stall for tens of seconds."""
PYTEST = ("-m", "pytest", "-p", "no:hypothesispytest")
"""The Python's words for a pytest in a process; without the plugin, which takes as long to start as pytest itself."""
LONG_FILES = {
    *("test_address_sanitizer.py", "test_thread_sanitizer.py", "test_on_zenoh.py", "test_release.py"),
    *("test_installers.py", "test_pyinstaller.py", "test_workspace.py", "test_colcon.py"),
    *("test_user_programs.py", "test_compilers.py", "test_site.py", "test_rounds.py"),
    *("test_browser.py", "test_drive_in_browser.py"),
}
"""Files of both tiers that take longest; their tests run one after another."""
DOMAIN_FIXTURES = {"domain_id", "module_domain_id"}

COLCON_PYTHON = {"COLCON_PYTHON_EXECUTABLE": str(Path(sys.executable).resolve())}
"""For a shell that sources what colcon wrote: colcon's own choice breaks where its path has a space."""


FIGURE = "figure"
"""Name of a property that a test records, whose text is printed at the end of the run."""


def pytest_terminal_summary(terminalreporter: pytest.TerminalReporter) -> None:
    for report in terminalreporter.getreports("passed"):
        for name, text in report.user_properties:
            if name == FIGURE:
                terminalreporter.write_line(str(text))


def pytest_configure() -> None:
    """Make SIGTERM, which `timeout` sends, end the tests as Ctrl-C does, together with the processes they started.

    Background jobs of a shell script ignore Ctrl-C and SIGQUIT, what nohup runs ignores SIGHUP, and so would the
    programs that tests start.
    """
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    signal.signal(signal.SIGINT, signal.default_int_handler)
    for name in ("SIGQUIT", "SIGHUP"):
        if hasattr(signal, name):
            signal.signal(getattr(signal, name), signal.SIG_DFL)


@pytest.hookimpl(wrapper=True)
def pytest_collection() -> Generator[None, object, object]:
    """Collect without the garbage collector, which would take a third of the time: nearly all objects are kept.

    Later collections leave these objects out.
    """
    gc.disable()
    try:
        return (yield)
    finally:
        gc.enable()
        gc.freeze()


WIRE_VARIABLE = "TFLOOM_TEST_WIRE"
"""The wire of all tests that take a domain and select none, in the place of DDS: a value of RMW_IMPLEMENTATION."""


def refuse_marks_of_other_files(mark: str, items: list[pytest.Item]) -> None:
    """Refuse a mark that a test has by another file, because tools/run_tests.py would not find its file.

    Raises:
        pytest.UsageError: there is one.
    """
    for path in {item.path for item in items if item.get_closest_marker(mark)}:
        if f"mark.{mark}" not in path.read_text("utf-8"):
            raise pytest.UsageError(f"{path}: write pytest.mark.{mark} in this file, for tools/run_tests.py")


@pytest.hookimpl(tryfirst=True)  # before -m selects
def pytest_collection_modifyitems(items: list[pytest.Item]) -> None:
    """Mark the tests that take a domain as `wire`, and skip those marked so where there is no DDS library.

    The longest files and those of the wire are first, because a whole file is one worker's, and a long one that
    started last would run alone.

    In the CI each test has a second try, which the summary names, because a shared machine may stall for seconds.
    Elsewhere the first failure fails the test.
    """
    if os.environ.get(WIRE_VARIABLE) == "rmw_zenoh_cpp":
        from tests.zenoh_ports import NOT_ON_ZENOH

        items[:] = [item for item in items if item.name.partition("[")[0] not in NOT_ON_ZENOH]
    for mark in ("slow", "timing"):
        refuse_marks_of_other_files(mark, items)
    for item in items:
        if DOMAIN_FIXTURES & set(getattr(item, "fixturenames", ())):
            item.add_marker(pytest.mark.wire)
    wire = [item for item in items if item.get_closest_marker("wire")]
    wire_files = {item.path for item in wire}
    items.sort(key=lambda item: (item.path.name not in LONG_FILES, item.path not in wire_files))
    try:
        find_library()
    except NoBackendError as error:
        for item in wire:
            item.add_marker(pytest.mark.skip(reason=f"needs DDS: {error}"))
    if os.environ.get("CI"):
        for item in items:
            item.add_marker(pytest.mark.flaky(reruns=1))


@pytest.fixture
def local_context(ros_domain: int) -> Iterator[Context]:
    """Return a context, not the default one, on the wire inside the process."""
    context = Context()
    context.init(args=[], domain_id=ros_domain)
    yield context
    context.try_shutdown()


@pytest.fixture
def make_node(local_context: Context) -> Iterator[Callable[..., Node]]:
    """Return a function that creates a node from its name and options; the nodes are destroyed at the end."""
    nodes: list[Node] = []

    def make(name: str, **options: object) -> Node:
        nodes.append(Node(name, context=local_context, **options))
        return nodes[-1]

    yield make
    for node in nodes:
        node.destroy_node()


@pytest.fixture
def node(make_node: Callable[..., Node]) -> Node:
    """Return a node on the wire inside the process."""
    return make_node("under_test")


def wait_until(condition: Callable[[], object], timeout_s: float = TIMEOUT_S, what: str = "") -> None:
    """Wait for a condition, checked every 10 ms; fail the test if it stays false."""
    end = time.monotonic() + timeout_s
    while not condition():
        if time.monotonic() > end:
            pytest.fail(f"gave up after {timeout_s} s waiting for {what or condition}")
        time.sleep(0.01)


def has_ended(pid: int) -> bool:
    """Return whether a process has ended, though its parent may not yet have asked for its exit code.

    The run of all tests is the parent of what tests leave, and asks only at its end.
    """
    with suppress(psutil.NoSuchProcess):
        return bool(psutil.Process(pid).status() == psutil.STATUS_ZOMBIE)
    return True


@pytest.fixture(name="wait_until")
def _wait_until() -> Callable[..., None]:
    return wait_until


@pytest.fixture(scope="session")
def deviations() -> dict[str, dict[str, str]]:
    """Return the rows of docs/deviations.md by their id: where, reference, ours, why."""
    text = (Path(__file__).parents[1] / "docs" / "deviations.md").read_text("utf-8")
    lines = [line.strip().strip("|").split(" | ") for line in text.splitlines() if line.startswith("| ")]
    rows = [[cell.strip() for cell in line] for line in lines]
    header = rows[0]  # that of each area's table
    body = [row for row in rows if row != header]
    return {row[0].strip("`"): dict(zip(header[1:], row[1:], strict=True)) for row in body}


@pytest.fixture
def planted(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Path]:
    """Return the folder of a new package, `planted`, that can be imported in this test alone."""
    package = tmp_path / "planted"
    package.mkdir()
    (package / "__init__.py").touch()
    monkeypatch.syspath_prepend(tmp_path)
    yield package
    for name in [name for name in sys.modules if name.split(".")[0] == "planted"]:
        del sys.modules[name]


def is_made_by_the_finder(module: object) -> bool:
    """Return whether a package was imported from definitions alone, without any of its modules perhaps."""
    loader = getattr(getattr(module, "__spec__", None), "loader", None)
    return type(loader).__module__ == "tfloom.ros_imports.finder"


@pytest.fixture
def forget_interfaces() -> Iterator[None]:
    """Forget, after a test, the classes and modules of the interface packages that it has imported."""
    from tfloom.rosidl import class_table, definition_files

    classes, modules = dict(class_table._classes), set(sys.modules)
    added = list(definition_files._added)
    yield
    imported = {name: sys.modules[name] for name in set(sys.modules) - modules}
    packages = {
        name.partition(".")[0]
        for name, module in imported.items()
        if name.endswith(definition_files.KINDS) and "ros_names" not in str(getattr(module, "__file__", None))
    } - {"tfloom", "tfloom_interfaces"}
    packages |= {name for name, module in imported.items() if is_made_by_the_finder(module)}
    class_table._classes.clear()
    class_table._classes.update(classes)
    definition_files._added[:] = added
    for name in imported:
        if name.partition(".")[0] in packages:
            del sys.modules[name]


@contextmanager
def forgetting_types() -> Iterator[None]:
    """Forget, after the block, the types that it has defined: from texts, from other nodes, and from recordings."""
    from tfloom.rosidl import class_table, sources

    texts, classes = dict(sources._defined), dict(class_table._classes)
    try:
        yield
    finally:
        names = texts.keys() | sources._defined.keys()
        changed = {name for name in names if texts.get(name) is not sources._defined.get(name)}
        for name in changed:
            sources.replace(name, texts.get(name))
            class_table.forget(name)
        for name in classes.keys() - class_table._classes.keys():
            if sources.definition_name(name) in changed:
                class_table.register(name, classes[name])


@pytest.fixture(autouse=True)
def _defined_types() -> Iterator[None]:
    """Forget the test's types, because a later one in this process may expect that it doesn't know them."""
    with forgetting_types():
        yield


@pytest.fixture(scope="session", autouse=True)
def _log_directory(tmp_path_factory: pytest.TempPathFactory) -> Iterator[None]:
    """Write log files to a temporary folder, not to the home directory."""
    with pytest.MonkeyPatch.context() as patch:
        patch.setenv("ROS_LOG_DIR", str(tmp_path_factory.mktemp("log")))
        yield


@pytest.fixture(autouse=True)
def _domains_of_the_process() -> Iterator[None]:
    """Give the next test new domains of the wire inside the process.

    A failure's traceback may hold a node until the garbage collector runs, and a later test must not discover it.
    """
    yield
    if (wire := sys.modules.get("tfloom.rmw.local.wire")) is not None:
        with wire._domains_lock:
            wire._domains.clear()


@pytest.fixture(autouse=True)
def _signal_handlers() -> Iterator[None]:
    """Restore the handlers of SIGINT and SIGTERM after the test.

    Programs and commands that run in this process leave their handlers, which a later `init` would take for the
    previous ones.
    """
    before = {number: signal.getsignal(number) for number in (signal.SIGINT, signal.SIGTERM)}
    yield
    if (signals := sys.modules.get("tfloom.node.executing.signals")) is not None:
        signals.uninstall_signal_handlers()
    for number, handler in before.items():
        signal.signal(number, handler)


@pytest.fixture(autouse=True)
def _environment() -> Iterator[None]:
    """Restore the environment variables after the test.

    Those of a launch's context are the process's. A `monkeypatch` that was made before `domain_id` and sets one of a
    graph's is undone after it, and puts back the domain.
    """
    before = dict(os.environ)
    yield
    for name in os.environ.keys() - before.keys():
        del os.environ[name]
    for name, value in before.items():
        if name != "PYTEST_CURRENT_TEST" and os.environ.get(name) != value:
            os.environ[name] = value


@contextmanager
def hold_domain() -> Iterator[int]:
    """Hold a DDS domain that no other test on this machine uses, and set ROS_DOMAIN_ID to it.

    Each program that a test starts holds it, too, so that the domain stays in use while a program outlives its test.
    """
    with domains.hold_domain() as domain, pytest.MonkeyPatch.context() as patch:
        patch.setenv("ROS_DOMAIN_ID", str(domain))
        patch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "LOCALHOST")
        # A program that ends may close the lock some time before its other sockets.
        wait_until(lambda: not bound_indices(domain), what=f"the end of what was on domain {domain}")
        if wire := os.environ.get(WIRE_VARIABLE):
            from tests.zenoh_ports import use_port_of

            patch.setenv("RMW_IMPLEMENTATION", wire)
            with use_port_of(domain):
                yield domain
            return
        yield domain


@pytest.fixture
def domain_id(start_program: Callable[..., Program]) -> Iterator[int]:
    """Reserve a domain for the test: see `hold_domain`.

    The test's own participants are closed before its programs are ended: a writer whose reader was killed would wait
    for its acknowledgements for a second.
    """
    with hold_domain() as domain:
        yield domain


@pytest.fixture(scope="module")
def module_domain_id(start_module_program: Callable[..., Program]) -> Iterator[int]:
    """Reserve a domain for the tests of a module that query the same graph and don't change it."""
    with hold_domain() as domain:
        yield domain


def _locks_go_along() -> dict[str, object]:
    """Return the options by which a program holds the locks of this process's domains too."""
    return {} if os.name == "nt" else {"pass_fds": domains.held_locks()}


def run_to_end(
    command: Sequence[object], *, timeout_s: float = 120.0, **options: object
) -> subprocess.CompletedProcess[str]:
    """Run a program; return its exit code and what it printed. Options are those of `subprocess.run`.

    Raises:
        subprocess.TimeoutExpired: it took longer, and was killed.
    """
    return subprocess.run(  # type: ignore[call-overload, no-any-return]
        command, capture_output=True, text=True, timeout=timeout_s, check=False, **options
    )


class Program:
    """A process under test: its output by lines, and methods to end it."""

    def __init__(self, command: Sequence[str | Path], **options: object) -> None:
        self.command = [str(part) for part in command]
        self.lines: list[str] = []
        self._printed = threading.Condition()
        self.process = subprocess.Popen(  # type: ignore[call-overload]
            self.command,
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
            bufsize=1,
            start_new_session=True,
            **{"stdin": subprocess.DEVNULL, **_locks_go_along(), **options},
        )
        self._reader = threading.Thread(target=self._read, daemon=True)
        self._reader.start()

    def _read(self) -> None:
        for line in self.process.stdout:
            with self._printed:
                self.lines.append(line.rstrip("\n"))
                self._printed.notify_all()
        with self._printed:
            self._printed.notify_all()

    @property
    def output(self) -> str:
        return "\n".join(self.lines)

    def wait_for(self, text: str, timeout_s: float = TIMEOUT_S) -> str:
        """Wait until a line contains `text`, and return it; fail with the whole output if the program ends before."""
        end = time.monotonic() + timeout_s
        while True:
            count = len(self.lines)
            ended = self.process.poll() is not None
            if ended:
                self._reader.join(1.0)
            for line in list(self.lines):
                if text in line:
                    return line
            if ended or time.monotonic() > end:
                pytest.fail(f"{self.command} never printed {text!r}; it printed:\n{self.output}")
            with self._printed:
                if len(self.lines) == count:
                    self._printed.wait(0.05)  # no longer, because a child may hold the output open

    def wait(self, timeout_s: float = TIMEOUT_S) -> int:
        """Wait for the end and return the exit code."""
        code = self.process.wait(timeout_s)
        self._reader.join(timeout_s)
        return int(code)

    def signal(self, number: int) -> None:
        self.process.send_signal(number)

    def pause(self) -> None:
        """Stop the process with SIGSTOP, and wait until all its threads have stopped."""
        self.signal(signal.SIGSTOP)
        _, status = os.waitpid(self.process.pid, os.WUNTRACED)
        assert os.WIFSTOPPED(status), self.output

    def end(self) -> None:
        """End the process and its children."""
        if hasattr(os, "killpg"):
            with suppress(ProcessLookupError):
                os.killpg(self.process.pid, 9)
        elif self.process.poll() is None:
            self.process.kill()
        self.process.wait(TIMEOUT_S)
        self._reader.join(TIMEOUT_S)
        self.process.stdout.close()
        if self.process.stdin is not None:
            self.process.stdin.close()


def python_with(constants: Mapping[str, object], code: str, *words: str | Path) -> list[str | Path]:
    """Return the Python command line that runs `code` with the arguments `words`, after replacing module constants.

    For example {"tfloom.cli.shared.calls.HINT_S": 1.0}, because a wait of full length tests no more than a short one.
    """
    lines = ["import importlib, sys"]
    for constant, value in constants.items():
        module, _, name = constant.rpartition(".")
        lines += [
            f"module = importlib.import_module({module!r})",
            f"module.{name}",
            f"module.{name} = {value!r}",
        ]
    return ["-c", "\n".join([*lines, code]), *words]


@contextmanager
def programs() -> Iterator[Callable[..., Program]]:
    """Yield a function that starts processes, as `start("ros2", "topic", "list")`; they are ended with the block."""
    started: list[Program] = []

    def start(*command: str | Path, **options: object) -> Program:
        first, *rest = command
        # A system's Python may be python3 alone.
        beside_python = Path(sys.executable).parent / (
            Path(sys.executable).name if first == "python" else first
        )
        program = Program([beside_python if beside_python.exists() else first, *rest], **options)
        started.append(program)
        return program

    try:
        yield start
    finally:
        for program in started:
            program.end()


@pytest.fixture
def start_program() -> Iterator[Callable[..., Program]]:
    """Start processes that are ended with the test: `start_program("ros2", "topic", "list")`."""
    with programs() as start:
        yield start


@pytest.fixture(scope="module")
def start_module_program() -> Iterator[Callable[..., Program]]:
    """Start processes, as `start_program` does, that are ended with the module."""
    with programs() as start:
        yield start


@pytest.fixture
def short_lease(monkeypatch: pytest.MonkeyPatch) -> float:
    """Shorten the lease of participants from 10 s to 3 s; return it [s].

    It applies to participants of this test, and to programs that the test starts.
    """
    lease_s = 3.0
    monkeypatch.setenv("TFLOOM_LEASE_S", str(lease_s))
    return lease_s

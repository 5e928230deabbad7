"""The self-test of libddsc's interface: libraries of other versions, and with planted differences."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from tests.conftest import run_to_end

from tfloom import _native
from tfloom.rmw.base import NodeName, Participant, Reader, Topic
from tfloom.rmw.cyclone import library as cyclone_library
from tfloom.rmw.cyclone import wire as cyclonedds
from tfloom.rmw.cyclone.library import find_library, open_library
from tfloom.rmw.errors import NoBackendError
from tfloom.rmw.qos import QoS

SOURCE = Path(__file__).parent / "libraries" / "planted.c"
TRACING = (
    "<CycloneDDS><Domain><General><Transport>none</Transport></General>"
    "<Tracing><Verbosity>config</Verbosity><OutputFile>{}</OutputFile></Tracing></Domain></CycloneDDS>"
)
OPEN = (
    "import sys; from tfloom._native import open_dds_library as o; print(o(sys.argv[1], sys.argv[2:] != []))"
)
OPEN_ALL = """
import sys
from tfloom._native import open_dds_library
for library in sys.argv[1:]:
    try:
        open_dds_library(library, True)
    except Exception as error:
        print(error, flush=True)
"""

pytestmark = pytest.mark.wire
needs_compiler = pytest.mark.skipif(
    sys.platform != "linux" or shutil.which("cc") is None, reason="builds a Linux library with cc"
)


@pytest.fixture
def build(tmp_path: Path) -> Callable[..., Path]:
    """Return a function that builds a library over libddsc, from the name in its SONAME and what differs."""

    def build(soname: str, *differences: str) -> Path:
        real, library = find_library(), tmp_path / "-".join(("libddsc.so", *differences))
        macros = [f"-D{name}" for name in differences]
        link = [f"-Wl,--no-as-needed,-soname,{soname}", "-Xlinker", "-rpath", "-Xlinker", Path(real).parent]
        command = ["cc", "-shared", "-fPIC", "-w", f'-DREAL="{real}"', *macros, *link, SOURCE, real, "-ldl"]
        subprocess.run([*command, "-o", library], check=True)
        return library

    return build


def open_in_a_process(library: Path, *words: str) -> tuple[int, str]:
    done = run_to_end([sys.executable, "-c", OPEN, str(library), *words])
    return done.returncode, done.stdout + done.stderr


def test_the_version_is_the_one_that_the_library_traces(tmp_path: Path) -> None:
    trace = tmp_path / "trace.txt"
    path, version, *_ = open_library()
    _native.DdsParticipant(path, 0, TRACING.format(trace), b"").close()
    traced = re.search(r"Version: CycloneDDS (\S+)", trace.read_text())
    if version.startswith("0.10."):
        assert traced is None, "0.10 traces none, so it is compared with the name of the library's file"
        assert path.endswith(f".so.{version}")
        return
    assert traced is not None
    if sys.platform == "win32":
        assert version == ""
    else:
        assert version == traced.group(1)


def test_the_installed_library_passes() -> None:
    _native.test_dds_library(find_library())
    _native.test_dds_library(find_library())  # the first has closed its domain


DIFFERENCES = {
    "WIDER_SAMPLE_INFO": "sample info differs (dds_readcdr)",
    "SWAPPED_SAMPLE_INFO": "sample info differs (dds_readcdr)",
    "WIDER_TAKE": "sample info differs (dds_take)",
    "LONGER_GUID": "GUID differs (dds_get_guid)",
    "LONGER_STATUS": "sample lost status differs (dds_get_sample_lost_status)",
    "SHORTER_STATUS": "matched status differs (dds_get_publication_matched_status)",
    "STATUS_BY_VALUE": "incompatible QoS status differs (dds_lset_offered_incompatible_qos_arg)",
    "MORE_MATCHES": "instance handle differs (dds_get_matched_publications)",
    "LATER_TOPIC_NAME": "endpoint data differs (dds_get_matched_publication_data)",
    "SHORTER_VIEW": "view of a sample differs (ddsi_serdata_to_ser_ref)",
    "OTHER_RESULT_CODES": "result code differs (dds_create_domain)",
    "NARROWER_DEPTH": "policy differs (dds_qget_history)",
}


@needs_compiler
def test_a_difference_is_named_instead_of_a_crash(build: Callable[..., Path]) -> None:
    libraries = [build("libddsc.so.11.0.2", difference) for difference in DIFFERENCES]
    done = run_to_end([sys.executable, "-c", OPEN_ALL, *libraries])
    for library, text, line in zip(libraries, DIFFERENCES.values(), done.stdout.splitlines(), strict=True):
        assert f"libddsc 11.0.2 in {library} fails the test of its interface: its {text}" in line
    assert done.returncode == 0, done.stderr


@needs_compiler
def test_a_tried_version_is_tested_in_uncommon_builds_alone(build: Callable[..., Path]) -> None:
    library = build("libddsc.so.11.0.1", "LONGER_GUID")
    assert open_in_a_process(library, "common build") == (0, "11.0.1\n")
    code, printed = open_in_a_process(library)
    assert code == 1
    assert "its GUID differs" in printed


@needs_compiler
@pytest.mark.parametrize(("soname", "version"), [("libddsc.so", ""), ("libddsc-1a.so.11", "11")])
def test_a_library_without_its_whole_version_is_tested(
    soname: str, version: str, build: Callable[..., Path]
) -> None:
    assert open_in_a_process(build(soname)) == (0, f"{version}\n")
    code, printed = open_in_a_process(build(soname, "LONGER_GUID"))
    assert code == 1
    assert f"libddsc {version or 'of unknown version'} in " in printed
    assert "its GUID differs" in printed


@needs_compiler
@pytest.mark.parametrize("version", ["0.9.1", "0.100.1", "12.0.0", "110.0.1"])
def test_another_major_version_is_refused_before_it_is_used(
    version: str, build: Callable[..., Path], monkeypatch: pytest.MonkeyPatch
) -> None:
    library = build(f"libddsc.so.{version}")
    monkeypatch.setattr(cyclone_library, "candidates", lambda: iter([("a test", str(library))]))
    with pytest.raises(
        NoBackendError, match=f"{library} is Cyclone DDS {version}, and only 0.10 and 11 can be used"
    ):
        open_library()


@needs_compiler
def test_an_untried_version_that_passes_is_used(
    build: Callable[..., Path],
    domain_id: int,
    monkeypatch: pytest.MonkeyPatch,
    node: NodeName,
    topic: Topic,
    take_data: Callable[[Reader, int], list[bytes]],
    wait_until: Callable[..., None],
) -> None:
    library = build("libddsc.so.11.9.9")
    monkeypatch.setattr(cyclone_library, "candidates", lambda: iter([("a test", str(library))]))
    assert open_library() == (str(library), "11.9.9", "a test", ())
    participant: Participant = cyclonedds.open_participant(domain_id)
    try:
        participant.add_node(node)
        reader = participant.create_reader(node, topic, QoS())
        writer = participant.create_writer(node, topic, QoS())
        wait_until(writer.matched_count)
        writer.write(bytes((0, 1, 0, 0, 1, 0, 0, 0)))
        assert take_data(reader, 1) == [bytes((0, 1, 0, 0, 1, 0, 0, 0))]
    finally:
        participant.close()

"""Build the wheel of tfloom-ddsc (PEP 517): libddsc, taken from the wheel of cyclonedds for another Python.

As a program (`build_backend.py FOLDER`), download that wheel into a folder, from which a later build takes it.

Only the standard library is imported, and pip is run, because the build's environment has nothing else.
"""

from __future__ import annotations

import base64
import hashlib
import re
import shutil
import subprocess
import sys
import tempfile
import zipfile
from collections.abc import Mapping
from pathlib import Path, PurePosixPath

VERSION = "11.0.1"
"""The version of cyclonedds, of its library, and of this distribution."""
PYTHON = "3.13"
"""The Python whose wheel is taken: any that has one, because the library doesn't know Python."""
LIBRARY = re.compile(r"(cyclonedds\.libs|cyclonedds/\.dylibs)/(lib)?ddsc[-.][^/]*")
LICENSE = re.compile(r"[^/]*\.dist-info/licenses/(LICENSE|NOTICE)[^/]*")

_MODULE = b'"""libddsc, for tfloom, which finds it in this folder."""\n'
_METADATA = f"""\
Metadata-Version: 2.1
Name: tfloom-ddsc
Version: {VERSION}
Summary: libddsc of Cyclone DDS, for tfloom
License: EPL-2.0 OR BSD-3-Clause
Requires-Python: >=3.10
"""


class BuildError(Exception):
    """There is no wheel to take the library from. The text states what to do."""


def build_wheel(
    wheel_directory: str,
    config_settings: Mapping[str, object] | None = None,
    metadata_directory: str | None = None,
) -> str:
    """Build the wheel in a folder, and return its name."""
    del config_settings, metadata_directory
    with tempfile.TemporaryDirectory() as scratch:
        return repack(download(Path(scratch)), Path(wheel_directory)).name


def build_sdist(sdist_directory: str, config_settings: Mapping[str, object] | None = None) -> str:
    """Refuse, because this package is installed by its path in tfloom's sources."""
    del sdist_directory, config_settings
    raise BuildError("tfloom-ddsc has no source distribution: install it by its path in tfloom's sources")


def download(folder: Path) -> Path:
    """Download the wheel of cyclonedds for this platform, and return its path.

    Raises:
        BuildError: there is none, or pip reaches no index.
    """
    command = [sys.executable, "-m", "pip", "download", "--quiet", "--disable-pip-version-check", "--no-deps"]
    command += [
        "--only-binary=:all:",
        "--python-version",
        PYTHON,
        "--dest",
        str(folder),
        f"cyclonedds=={VERSION}",
    ]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    wheels = list(folder.glob("*.whl"))
    if done.returncode or not wheels:
        raise BuildError(
            f"no wheel of cyclonedds {VERSION} came for this platform, to take libddsc from: where there is none (on "
            "Linux with arm64 or musl), install the system's, by apt-get install libddsc0t64 (Debian 13, Ubuntu) or "
            f"libddsc0debian (Debian 12). pip says: {done.stderr.strip()}"
        )
    return wheels[0]


def repack(source: Path, folder: Path) -> Path:
    """Write a wheel with the library of another wheel and with its licences; return its path.

    Args:
        source: A wheel of cyclonedds.
        folder: The folder to write into.

    Raises:
        BuildError: the other wheel holds no libddsc, or more than one.
    """
    platforms = source.stem.rpartition("-")[2]
    dist_info = f"tfloom_ddsc-{VERSION}.dist-info"
    files = {"tfloom_ddsc/__init__.py": _MODULE}
    with zipfile.ZipFile(source) as archive:
        names = archive.namelist()
        libraries = list(filter(LIBRARY.fullmatch, names))
        if len(libraries) != 1:
            raise BuildError(f"{source.name} holds {len(libraries)} libraries named libddsc, and not one")
        name = PurePosixPath(libraries[0]).name
        files[f"tfloom_ddsc/{name}"] = stripped(archive.read(libraries[0]))
        for license_name in filter(LICENSE.fullmatch, names):
            files[f"{dist_info}/licenses/{PurePosixPath(license_name).name}"] = archive.read(license_name)
    tags = "".join(f"Tag: py3-none-{platform}\n" for platform in platforms.split("."))
    files[f"{dist_info}/METADATA"] = _METADATA.encode()
    files[f"{dist_info}/WHEEL"] = (
        f"Wheel-Version: 1.0\nGenerator: tfloom-ddsc\nRoot-Is-Purelib: false\n{tags}".encode()
    )
    record = f"{dist_info}/RECORD"
    lines = [f"{path},sha256={_digest(content)},{len(content)}" for path, content in files.items()]
    files[record] = "\n".join([*lines, f"{record},,", ""]).encode()
    wheel = folder / f"tfloom_ddsc-{VERSION}-py3-none-{platforms}.whl"
    with zipfile.ZipFile(wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for path, content in files.items():
            archive.writestr(path, content)
    return wheel


def stripped(library: bytes) -> bytes:
    """Return a library of Linux without its debugging symbols, where the system has `strip`; others as they are."""
    strip = shutil.which("strip")
    if strip is None or not library.startswith(b"\x7fELF"):
        return library
    with tempfile.TemporaryDirectory() as scratch:
        file = Path(scratch, "libddsc.so")
        file.write_bytes(library)
        done = subprocess.run([strip, "--strip-unneeded", file], capture_output=True, check=False)
        return library if done.returncode else file.read_bytes()


def _digest(content: bytes) -> str:
    return base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()


if __name__ == "__main__":
    download(Path(sys.argv[1]))

"""Write the files that are generated, and not in git: `python tools/generated.py`, or `make generated`.

They are the classes of messages and their façades (`tfloom.rosidl.generate`), the façades of the other packages
(`tools.facades`) and the manifests (`tools.manifests`). They stand among the sources, and sdists and wheels have them.
An sdist has no generator. The set-up, the runner of the tests and the builds generate them where, by
RECORD, they are missing, changed, or made from other inputs: after a pull or a change of branch.

It imports tfloom from these sources, wherever another one is installed, and nothing that is compiled. It needs PyYAML
beside the standard library, and only to generate.
"""

from __future__ import annotations

import hashlib
import importlib
import json
import os
import shutil
import sys
from collections.abc import Iterator, Mapping
from contextlib import contextmanager, suppress
from importlib.machinery import BuiltinImporter, FrozenImporter, PathFinder
from pathlib import Path

__all__ = ["files_there", "generate", "inputs_digest", "is_checkout", "is_current", "main", "write"]

ROOT = Path(__file__).resolve().parents[1]
HOUSES = (
    "src/tfloom",
    "packages/tfloom-interfaces/src/tfloom_interfaces",
    "packages/tfloom-sensing/src/tfloom_sensing",
)
"""The import packages that have generated files."""
GENERATED = (
    "ros_names/**/*",
    "interfaces/*/**/*",
    "ros_imports/homes.py",
    "share/*/package.xml",
    "rosidl/definitions/*/package.xml",
    "definitions/*/package.xml",
)
"""The generated files of an import package: .gitignore has them, and `sdist.include` in each pyproject.toml."""
INPUTS = (
    "tools/generated.py",
    "tools/manifests.py",
    "tools/facades/*.*",
    "tests/golden/api_jazzy.json.gz",
    "tests/golden/module_names.json",
    *(f"{house}/**/*.{suffix}" for house in HOUSES for suffix in ("py", "msg", "srv", "action")),
)
"""What the generators read. Each module is among it, because the façades follow the names that modules define."""
RECORD = "build/generated.json"
"""The digest of the inputs, and one of each file that was made from them."""
LOCK = "build/generated.lock"


def is_checkout(root: Path = ROOT) -> bool:
    """Return whether a folder has the whole sources, as neither an sdist nor the folder of a wheel's tests has."""
    return all((root / path).is_file() for path in ("src/tfloom/__init__.py", *INPUTS[:2]))


def is_current(root: Path = ROOT) -> bool:
    """Return whether the generated files are those of the sources, and no others are beside them."""
    try:
        record = json.loads((root / RECORD).read_text("utf-8"))
    except (OSError, ValueError):
        return False
    return bool(record == {"inputs": inputs_digest(root), "outputs": _outputs(root)})


def files_there(root: Path = ROOT) -> list[str]:
    """Return the paths of what stands where generated files do, within the repository, in order."""
    return sorted(
        path.relative_to(root).as_posix()
        for house in HOUSES
        for pattern in GENERATED
        for path in (root / house).glob(pattern)
        if path.is_file() and path.suffix not in {".pyc", ".pyo"}
    )


def inputs_digest(root: Path = ROOT) -> str:
    """Return a digest of the names and contents of what the generators read."""
    found = {path.relative_to(root).as_posix() for pattern in INPUTS for path in root.glob(pattern)}
    digest = hashlib.sha256()
    for name in sorted(found.difference(files_there(root))):
        digest.update(f"{name}\0{_digest(root / name)}\0".encode())
    return digest.hexdigest()


def generate() -> dict[str, str]:
    """Return the texts of all generated files, by path within the repository.

    Those of messages are written first, because the façades are made from what these modules export.
    """
    files: dict[str, str] = {}
    messages = importlib.import_module("tfloom.rosidl.generate")
    own, extra = HOUSES[:2]
    for house, texts in ((own, messages.generate_all()), (extra, messages.generate_extra(ROOT / extra))):
        files |= {f"{house}/{path}": text for path, text in texts.items()}
    _write_differing(ROOT, files)
    for generator in ("tools.facades.generate", "tools.manifests"):
        files |= importlib.import_module(generator).generate_all()
    return files


def write(files: Mapping[str, str], inputs: str, root: Path = ROOT) -> None:
    """Write each file that differs, and remove what else stands where generated files do; then write the record.

    Args:
        files: The texts, by path within the repository.
        inputs: What `inputs_digest` returned before they were generated, because sources may have changed since.
        root: The repository.
    """
    _write_differing(root, files)
    for name in files_there(root):
        if name not in files:
            (root / name).unlink()
            _remove_empty((root / name).parent)
    record = {"inputs": inputs, "outputs": _outputs(root)}
    _write_whole(root / RECORD, json.dumps(record, indent=0).encode())


def _write_differing(root: Path, files: Mapping[str, str]) -> None:
    for name, text in files.items():
        path, content = root / name, text.encode()
        if not path.is_file() or path.read_bytes() != content:
            _write_whole(path, content)


def _write_whole(path: Path, content: bytes) -> None:
    """Write a file beside its place, and rename it, so that another process never reads a part of it."""
    path.parent.mkdir(parents=True, exist_ok=True)
    partial = path.with_name(f".{path.name}.{os.getpid()}.partial")
    try:
        partial.write_bytes(content)
        partial.replace(path)
    finally:
        partial.unlink(missing_ok=True)


def _remove_empty(folder: Path) -> None:
    """Remove a folder that has nothing but compiled files, and then those above it: Python would import them."""
    while all(path.name == "__pycache__" for path in folder.iterdir()):
        shutil.rmtree(folder)
        folder = folder.parent


def _outputs(root: Path) -> dict[str, str]:
    return {name: _digest(root / name) for name in files_there(root)}


def _digest(path: Path) -> str:
    return hashlib.sha256(path.read_bytes()).hexdigest()


@contextmanager
def _only_one(root: Path) -> Iterator[None]:
    """Keep other processes from generating as long as the block runs, where the file system has locks."""
    path = root / LOCK
    path.parent.mkdir(exist_ok=True)
    with path.open("ab") as file:
        with suppress(OSError):
            if sys.platform == "win32":
                import msvcrt

                file.seek(0)
                msvcrt.locking(file.fileno(), msvcrt.LK_LOCK, 1)  # it waits for 10 s, and is then an OSError
            else:
                import fcntl

                fcntl.flock(file, fcntl.LOCK_EX)
        yield


def _import_from_sources() -> None:
    """Import tfloom and the tools from this checkout, wherever the environment has another tfloom."""
    sys.meta_path[:] = [
        finder for finder in sys.meta_path if finder in (BuiltinImporter, FrozenImporter, PathFinder)
    ]
    sys.path[0] = str(ROOT / "src")  # in the place of tools/, whose modules are those of the package `tools`
    sys.path.insert(1, str(ROOT))


def main() -> int:
    """Bring the generated files of this checkout up to date; return an exit code."""
    if not is_checkout():
        return 0
    _import_from_sources()
    with _only_one(ROOT):
        if is_current():
            return 0
        table_error = importlib.import_module("tools.facades.table").TableError
        inputs = inputs_digest()
        try:
            write(generate(), inputs)
        except table_error as error:
            print(error, file=sys.stderr)
            return 1
    print("Generated the classes of messages, the façades and the manifests", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())

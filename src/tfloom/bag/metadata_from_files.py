"""The metadata of any bag: from metadata.yaml, or made from its files."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from tfloom.bag.bag import Bag
from tfloom.bag.metadata import FileInformation, Metadata
from tfloom.bag.reading.bag_file import BagFile
from tfloom.bag.reading.compression import COMPRESSED_SUFFIX
from tfloom.bag.writing.metadata_text import METADATA_VERSION, NO_TIME_NS
from tfloom.bag.writing.storage import STORAGES
from tfloom.ros_imports.ros_distro import ROS_DISTRO

__all__ = ["metadata_from_files", "metadata_of", "size_of", "storage_id_of"]


def metadata_of(bag: Bag) -> Metadata:
    """Return what metadata.yaml says of a bag, or for a single file what it holds.

    Raises:
        BagError: a file can't be read.
    """
    return bag.metadata or metadata_from_files(bag, bag.files)


def metadata_from_files(bag: Bag, files: Sequence[BagFile]) -> Metadata:
    """Return the metadata that files of a bag have.

    Raises:
        BagError: a file can't be read.
    """
    filled = [file for file in files if file.message_count]
    start_ns = min((file.start_ns for file in filled), default=NO_TIME_NS)
    end_ns = max((file.end_ns for file in filled), default=start_ns)
    mode = ""
    if any(file.is_compressed for file in files):
        mode = "FILE"
    elif any(file.storage.is_message_compressed for file in files):
        mode = "MESSAGE"
    return Metadata(
        version=METADATA_VERSION,
        storage_identifier=storage_id_of(files[0].path) if files else "",
        duration_ns=end_ns - start_ns,
        start_ns=start_ns,
        message_count=sum(file.message_count for file in files),
        topics=sorted(bag.topics.values()),
        compression_format="zstd" if mode else "",
        compression_mode=mode,
        relative_file_paths=[file.path.name for file in files],
        files=[_information(file) for file in files],
        custom_data={},
        ros_distro=ROS_DISTRO,
    )


def storage_id_of(path: Path) -> str:
    """Return the storage of a file by its name; empty for one of ROS 1."""
    name = path.name.removesuffix(COMPRESSED_SUFFIX)
    return next((key for key, suffix in STORAGES.items() if name.endswith(suffix)), "")


def size_of(path: Path) -> int:
    """Return the size of a file, or of all files in a folder [bytes]."""
    if path.is_file():
        return path.stat().st_size
    return sum(child.stat().st_size for child in path.iterdir() if child.is_file())


def _information(file: BagFile) -> FileInformation:
    name = file.path.name.removesuffix(COMPRESSED_SUFFIX)
    return FileInformation(name, file.start_ns, file.end_ns - file.start_ns, file.message_count)

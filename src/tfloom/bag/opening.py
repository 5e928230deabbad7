"""Open a recording by its path."""

from __future__ import annotations

import os
from collections.abc import Sequence
from contextlib import ExitStack
from pathlib import Path

from tfloom.bag.bag import Bag
from tfloom.bag.errors import BagError
from tfloom.bag.metadata import METADATA_FILE, FileInformation, Metadata, read_metadata
from tfloom.bag.reading.bag_file import BagFile

__all__ = ["open_bag", "open_bags"]


def open_bag(path: str | os.PathLike[str]) -> Bag:
    """Open a recording.

    Args:
        path: A folder of rosbag2, with its metadata.yaml; or a file: .mcap, .db3, .mcap.zstd, .db3.zstd, or .bag
            and .bag.active of ROS 1.

    Returns:
        The recording. A file that is unfinished is read up to its last whole record, with a `BagWarning`.

    Raises:
        BagError: there is no such recording, or it is damaged; the text has the file, the place and what to do.
    """
    place = Path(path)
    try:
        if place.is_dir():
            if recordings := _recordings_in(place):
                raise BagError(path, f"this folder has recordings, and is none: open one, as {recordings[0]}")
            return _open_folder(place)
        if not place.exists():
            raise BagError(path, "there is no such file or folder")
        bag = Bag(place, [BagFile(place)], None)
        _ = bag.files[0].storage
    except OSError as error:
        raise BagError(path, f"it can't be read: {error.strerror}") from None
    return bag


def open_bags(paths: Sequence[str | os.PathLike[str]]) -> Bag:
    """Open several recordings as one, with the topics of all, and their messages in the order of log times.

    Raises:
        BagError: there is none, one of them can't be opened, or two have a topic of one name with different types.
    """
    if not paths:
        raise BagError("", "no recording was named")
    with ExitStack() as opened:
        bags = [opened.enter_context(open_bag(path)) for path in paths]
        if len(bags) > 1:
            _check_types(bags)
        opened.pop_all()
    if len(bags) == 1:
        return bags[0]
    whole = Bag(bags[0].path, [file for bag in bags for file in bag.files], None)
    whole.parts = [bag.files for bag in bags]
    return whole


def _check_types(bags: list[Bag]) -> None:
    """Raise BagError if a topic of one recording has another type in a second one: one publisher can't have both."""
    found: dict[str, tuple[str, Path]] = {}
    for bag in bags:
        for topic in bag.topics.values():
            type_name, path = found.setdefault(topic.name, (topic.type, bag.path))
            if type_name != topic.type:
                raise BagError(
                    bag.path, f"the type of '{topic.name}' is {topic.type}, and in {path} it is {type_name}"
                )


def _recordings_in(folder: Path) -> list[Path]:
    """Return the recordings in a folder that is not a recording, in the order of their names."""
    if (folder / METADATA_FILE).exists():
        return []
    return sorted(child for child in folder.iterdir() if (child / METADATA_FILE).is_file())


def _open_folder(folder: Path) -> Bag:
    metadata = read_metadata(folder)
    is_message_compressed = metadata.compression_mode.upper() == "MESSAGE"
    if is_message_compressed and metadata.compression_format != "zstd":
        raise BagError(
            folder, f"the messages' compression is '{metadata.compression_format}', which isn't zstd"
        )
    if not metadata.relative_file_paths:
        raise BagError(folder, f"metadata.yaml names no files: `ros2 bag reindex {folder}` writes it anew")
    files = [
        BagFile(_path(folder, name), is_message_compressed, _information(metadata, name))
        for name in metadata.relative_file_paths
    ]
    for file in files:
        if not file.is_compressed:
            _ = file.storage
        elif not file.path.exists():
            raise BagError(file.path, "there is no such file, which metadata.yaml names")
    return Bag(folder, files, metadata)


def _path(folder: Path, name: str) -> Path:
    """Return the path of a file; early versions wrote it with the folder's name before it."""
    path = folder / name
    inside = folder / Path(name).name
    return inside if not path.exists() and inside.exists() else path


def _information(metadata: Metadata, name: str) -> FileInformation | None:
    bare = name.removesuffix(".zstd")
    return next((file for file in metadata.files if file.path in {name, bare}), None)

"""metadata.yaml written anew, from the files of a bag."""

from __future__ import annotations

import re
from pathlib import Path

from tfloom.bag.bag import Bag
from tfloom.bag.errors import BagError
from tfloom.bag.metadata import METADATA_FILE
from tfloom.bag.metadata_from_files import metadata_from_files, storage_id_of
from tfloom.bag.reading.bag_file import BagFile
from tfloom.bag.reading.compression import COMPRESSED_SUFFIX
from tfloom.bag.writing.metadata_text import metadata_file_text
from tfloom.common.files import write_file
from tfloom.node.log.logging import get_logger

__all__ = ["reindex"]


def reindex(folder: Path, storage_id: str = "") -> None:
    """Write metadata.yaml from the files in a folder. An unfinished file counts up to its last whole record.

    Args:
        folder: The bag's folder.
        storage_id: The storage whose files are read; empty: that of the first file.

    Raises:
        BagError: the folder has no files of a bag, one of them can't be read, or metadata.yaml can't be written.
    """
    logger = get_logger("rosbag2_cpp")
    logger.info(f'Beginning reindexing bag in directory: "{folder}"')  # noqa: G004 - ROS's logger
    paths = _files(folder, storage_id)
    files = [BagFile(path) for path in paths]
    bag = Bag(folder, files, None)
    try:
        metadata = metadata_from_files(bag, files)
    except OSError as error:
        raise BagError(folder, f"it can't be read: {error.strerror}") from None
    finally:
        bag.close()
    try:
        # The list of files is left empty, as rosbag2 leaves it.
        write_file(folder / METADATA_FILE, metadata_file_text(metadata._replace(files=[])))
    except OSError as error:
        raise BagError(folder / METADATA_FILE, f"it can't be written: {error.strerror}") from None
    logger.info("Reindexing complete.")


def _files(folder: Path, storage_id: str) -> list[Path]:
    """Return the files of one storage in a folder, in the order of recording."""
    if not folder.is_dir():
        raise BagError(folder, "only the folder of a bag can be reindexed")
    files = [path for path in folder.iterdir() if path.is_file() and storage_id_of(path)]
    # Where compressing a file was cut short, the original is whole.
    files = [path for path in files if path.suffix != COMPRESSED_SUFFIX or path.with_suffix("") not in files]
    files.sort(key=_number)
    chosen_storage = storage_id or (storage_id_of(files[0]) if files else "")
    files = [path for path in files if storage_id_of(path) == chosen_storage]
    if not files:
        raise BagError(folder, "there are no files of a bag in it: none ends in .mcap or .db3")
    return files


def _number(path: Path) -> tuple[int, str]:
    # By the names of Lyrical, `0_bag_2026_05_23-10_00_00.mcap`, or by those before it, `bag_0.mcap`.
    match = re.match(r"(\d+)_(?:.*_)?\d{4}(?:_\d\d){2}-\d\d(?:_\d\d){2}\.", path.name) or re.search(
        r"_(\d+)\.(?:mcap|db3)", path.name
    )
    return (int(match[1]) if match else 0, path.name)

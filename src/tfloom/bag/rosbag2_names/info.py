"""What is known of a bag, and metadata written anew."""

from __future__ import annotations

from pathlib import Path

from tfloom.bag.info_text import info_text
from tfloom.bag.metadata_from_files import metadata_of, size_of
from tfloom.bag.opening import open_bag
from tfloom.bag.reindexing import reindex
from tfloom.bag.rosbag2_names.storage import BagMetadata, StorageOptions

__all__ = ["Info", "Reindexer"]


class Info:
    """Reads and prints the metadata of bags, as `rosbag2_py.Info`."""

    def read_metadata(self, arg0: str, arg1: str) -> BagMetadata:  # noqa: ARG002 - the storage is found by itself
        """Return what is known of a bag; the second argument is its storage.

        Raises:
            BagError: it can't be read.
        """
        with open_bag(Path(arg0)) as bag:
            return BagMetadata.from_metadata(metadata_of(bag), size_of(bag.path))

    def read_metadata_and_output_service_verbose(self, arg0: str, arg1: str) -> None:  # noqa: ARG002 - as above
        """Print what is known of a bag, with the numbers of requests and responses.

        Raises:
            BagError: it can't be read.
        """
        with open_bag(Path(arg0)) as bag:
            print(info_text(bag, verbose=True))


class Reindexer:
    """Writes metadata.yaml from the files of a bag, as `rosbag2_py.Reindexer`."""

    def reindex(self, arg0: StorageOptions) -> None:
        """Write metadata.yaml from the files of a folder.

        Raises:
            BagError: there are none, or one of them can't be read.
        """
        reindex(Path(arg0.uri), arg0.storage_id)

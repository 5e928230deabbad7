"""Files of packages, as meshes of a robot's description, for clients."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING
from urllib.parse import unquote, urlsplit

from tfloom.common.files import open_regular, read_at_most
from tfloom.workspace.ament import PackageNotFoundError, get_package_share_path

if TYPE_CHECKING:
    from tfloom.foxglove.settings import Settings

__all__ = ["AssetError", "read_asset"]

MAX_FILE_BYTES = 256 * 1024 * 1024


class AssetError(Exception):
    """A file is not for clients, or can't be read; the text says why."""


def read_asset(
    uri: str, settings: Settings, find_share: Callable[[str], Path] = get_package_share_path
) -> bytes:
    """Return the bytes of a file.

    Args:
        uri: `package://PACKAGE/PATH`, or `file://PATH` where the settings allow that.
        settings: Which files clients may read.
        find_share: Returns the folder of a package.

    Raises:
        AssetError: clients may not read it, or nobody can.
    """
    if uri not in settings.assets:
        raise AssetError(f"clients may not read {uri}: no expression of asset_uri_allowlist matches it")
    try:
        parts = urlsplit(uri)
        if parts.scheme == "file":
            path = Path(unquote(parts.path))
        elif parts.scheme == "package":
            share = find_share(parts.netloc)
            path = (share / unquote(parts.path).lstrip("/")).absolute()
            if ".." in path.parts:
                raise AssetError(f"{uri} leads out of its package")
        else:
            raise AssetError(f"{uri} begins neither with package:// nor with file://")
        with open_regular(path) as file:
            content = read_at_most(file, MAX_FILE_BYTES)
    except PackageNotFoundError:
        raise AssetError(f"there is no package '{parts.netloc}', which {uri} is in") from None
    except (OSError, ValueError) as error:
        raise AssetError(f"{uri} can't be read: {getattr(error, 'strerror', None) or error}") from None
    if content is None:
        raise AssetError(f"{uri} has more than {MAX_FILE_BYTES} bytes")
    return content

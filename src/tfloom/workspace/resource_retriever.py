"""The functions of `resource_retriever`: files named by URLs, also as `package://my_package/meshes/arm.stl`."""

from __future__ import annotations

from pathlib import Path
from urllib.error import URLError
from urllib.request import urlopen

from tfloom.workspace.ament import get_package_share_directory

__all__ = ["PACKAGE_PREFIX", "get", "get_filename"]

PACKAGE_PREFIX = "package://"
_FILE_PREFIX = "file://"


def get_filename(url: str, use_protocol: bool = True) -> str:
    """Return the URL of a file, with `package://` replaced by the share folder of the package.

    Args:
        url: A URL with `package://`, `file://`, or another protocol, which is returned unchanged.
        use_protocol: Whether the result begins with `file://`; otherwise it is a path.

    Raises:
        PackageNotFoundError: there is no such package.
        ValueError: no package is named, or its name isn't valid.
    """
    path = url
    if url.startswith(PACKAGE_PREFIX):
        package, _, rest = url.removeprefix(PACKAGE_PREFIX).partition("/")
        if not package:
            raise ValueError(f"'{url}' names no package: write package://PACKAGE/PATH")
        path = _FILE_PREFIX + str(Path(get_package_share_directory(package, print_warning=False), rest))
    return path if use_protocol else path.removeprefix(_FILE_PREFIX)


def get(url: str) -> bytes:
    """Return the content of a file named by a URL: `package://`, `file://`, or of a web server.

    Raises:
        PackageNotFoundError: there is no such package.
        OSError: it can't be read.
        ValueError: it is not a URL.
    """
    name = get_filename(url)
    if name.startswith(_FILE_PREFIX):
        # Not by urlopen, which takes a blank or a hash sign in a path for something else.
        return Path(name.removeprefix(_FILE_PREFIX)).read_bytes()
    if not name.startswith(("http://", "https://")):
        raise ValueError(f"'{url}' begins with none of package://, file://, http:// and https://")
    try:
        with urlopen(name) as response:  # noqa: S310  # only the two protocols above
            content: bytes = response.read()
            return content
    except URLError as error:
        raise OSError(f"{url}: {error.reason}") from None

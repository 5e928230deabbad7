"""rosdep's keys of Python libraries, as `python3-serial`, and the names that these libraries have on PyPI."""

from __future__ import annotations

import re

PYPI_NAMES = {
    "absl": "absl-py",
    "alsaaudio": "pyalsaaudio",
    "antlr4": "antlr4-python3-runtime",
    "bluez": "PyBluez",
    "box": "python-box",
    "bs4": "beautifulsoup4",
    "bson": "pymongo",
    "cairo": "pycairo",
    "can": "python-can",
    "catkin-pkg-modules": "catkin-pkg",
    "cherrypy3": "CherryPy",
    "collada": "pycollada",
    "crypto": "pycrypto",
    "dateutil": "python-dateutil",
    "dbus": "dbus-python",
    "dotenv": "python-dotenv",
    "faiss": "faiss-cpu",
    "fcl": "python-fcl",
    "gi": "PyGObject",
    "gi-cairo": "PyGObject",
    "git": "GitPython",
    "github": "PyGithub",
    "gitlab": "python-gitlab",
    "gnupg": "python-gnupg",
    "googleapi": "google-api-python-client",
    "grpc-tools": "grpcio-tools",
    "imaging": "Pillow",
    "jwt": "PyJWT",
    "libgpiod": "gpiod",
    "magic": "python-magic",
    "marisa": "marisa-trie",
    "multicast": "py-multicast",
    "mysqldb": "mysqlclient",
    "networkmanager": "python-networkmanager",
    "opencv": "opencv-python",
    "opencv-contrib": "opencv-contrib-python",
    "opengl": "PyOpenGL",
    "pil": "Pillow",
    "pil-imagetk": "Pillow",
    "pkg-resources": "setuptools",
    "pyosmium": "osmium",
    "pyqt5.qtwebengine": "PyQtWebEngine",
    "pyqt6.qtwebengine": "PyQt6-WebEngine",
    "pytorch": "torch",
    "qt-bindings": "PyQt5",
    "qt5-bindings": "PyQt5",
    "qt5-bindings-gl": "PyQt5",
    "qt5-bindings-webkit": "PyQtWebEngine",
    "qwt": "PythonQwt",
    "rosdep-modules": "rosdep",
    "rosdistro-modules": "rosdistro",
    "rospkg-modules": "rospkg",
    "serial": "pyserial",
    "skimage": "scikit-image",
    "sklearn": "scikit-learn",
    "socketio": "python-socketio",
    "systemd": "systemd-python",
    "tz": "pytz",
    "ubjson": "py-ubjson",
    "usb": "pyusb",
    "usd": "usd-core",
    "virtualserialports": "PyVirtualSerialPorts",
    "websocket": "websocket-client",
    "wxgtk4.0": "wxPython",
    "xlib": "python-xlib",
    "yaml": "PyYAML",
    "zmq": "pyzmq",
}
"""Of the keys whose name on PyPI is another: there may be a library of the key's name, too, and a wrong one."""
_OF_THE_SYSTEM = {"apt", "dev", "distutils", "interpreter", "venv"}
"""Keys of what comes with Python or the system, and not from PyPI."""


def library_key(name: str) -> str | None:
    """Return what a key of rosdep names, as `serial` of `python3-serial`; None if it names no Python library."""
    match = re.fullmatch(r"python3?-(.+?)(?:-pip)?|(.+)-pip", name)
    return None if match is None else match[1] or match[2]


def pypi_name(key: str) -> str | None:
    """Return the name of a library on PyPI, or None for one that comes with the system.

    Args:
        key: What `library_key` returned.
    """
    if key in _OF_THE_SYSTEM:
        return None
    # A part of Qt's bindings, as `pyqt5.qtquick`, is in the whole.
    bindings = re.fullmatch(r"(pyqt\d|pyside\d)\..+", key)
    return PYPI_NAMES.get(key, bindings[1] if bindings else key)

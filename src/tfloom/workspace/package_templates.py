"""The texts of a new package's files, filled in by `str.format`. They pass the tests that are generated with them.

Templates of others are filled in as `ament_package` does: `@NAME@` is replaced by the value of NAME.
"""

from __future__ import annotations

import os
import re
from collections.abc import Mapping
from pathlib import Path

PACKAGE_XML = """\
<?xml version="1.0"?>
<?xml-model href="http://download.ros.org/schema/package_format3.xsd" schematypens="http://www.w3.org/2001/XMLSchema"?>
<package format="3">
  <name>{name}</name>
  <version>0.0.0</version>
  <description>{description}</description>
  <maintainer email="{email}">{maintainer}</maintainer>
  <license>{license}</license>

{tags}
  <export>
    <build_type>{build_type}</build_type>
  </export>
</package>
"""

SETUP_PY = """\
from setuptools import find_packages, setup

package_name = {name!r}

setup(
    name=package_name,
    version='0.0.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer={maintainer!r},
    maintainer_email={email!r},
    description={description!r},
    license={license!r},
    extras_require={{
        'test': ['pytest'],
    }},
    entry_points={{
        'console_scripts': [
{scripts}        ],
    }},
)
"""

SETUP_CFG = """\
[develop]
script_dir=$base/lib/{name}
[install]
install_scripts=$base/lib/{name}
"""

NODE = '''\
import rclpy
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node


class {class_name}(Node):
    """Count the seconds."""

    def __init__(self):
        super().__init__('{node}')
        self.count = 0
        self.timer = self.create_timer(1.0, self.on_timer)
        self.get_logger().info('Hi from {name}.')

    def on_timer(self):
        self.count += 1
        self.get_logger().info(f'{{self.count}} s')


def main():
    rclpy.init()
    node = {class_name}()
    try:
        rclpy.spin(node)
    except (KeyboardInterrupt, ExternalShutdownException):
        pass
    finally:
        node.destroy_node()
        rclpy.try_shutdown()


if __name__ == '__main__':
    main()
'''

_TEST = """\
from {module}.main import {function}
import pytest


@pytest.mark.{mark}
@pytest.mark.linter
def test_{mark}():
    {call}
"""

TESTS = {
    "test/test_copyright.py": """\
from ament_copyright.main import main
import pytest


# Remove this line when the source files have a notice of copyright.
@pytest.mark.skip(reason='the generated files have no notice of copyright')
@pytest.mark.copyright
@pytest.mark.linter
def test_copyright():
    assert main(argv=['.', 'test']) == 0, 'files without copyright or licence'
""",
    "test/test_flake8.py": _TEST.format(
        module="ament_flake8",
        function="main_with_errors",
        mark="flake8",
        call="code, errors = main_with_errors(argv=[])\n    assert code == 0, '\\n'.join(errors)",
    ),
    "test/test_pep257.py": _TEST.format(
        module="ament_pep257",
        function="main",
        mark="pep257",
        call="assert main(argv=['.', 'test']) == 0, 'docstrings that break a rule'",
    ),
}

CMAKE_LISTS = """\
cmake_minimum_required(VERSION 3.8)
project({name})

find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)
{find_packages}
# List each definition here: messages, services (srv/Name.srv) and actions (action/Name.action).
rosidl_generate_interfaces(${{PROJECT_NAME}}
  "msg/Num.msg"
{dependencies})

ament_export_dependencies(rosidl_default_runtime)
ament_package()
"""

MESSAGE = """\
# A field for each line: a type, a name, and a default if there is one.
int64 num
"""
IS_WINDOWS = os.name == "nt"
_VARIABLE = re.compile(r"@([a-zA-Z0-9_]+)@")


def configure_file(template_file: str | os.PathLike[str], environment: Mapping[str, str]) -> str:
    """Return the text of a template file with its variables replaced, as `configure_string` does.

    Args:
        template_file: Path of the file, in UTF-8.
        environment: The values of the variables, by name.

    Raises:
        OSError: the file cannot be read.
    """
    return configure_string(Path(template_file).read_text("utf-8"), environment)


def configure_string(template: str, environment: Mapping[str, str]) -> str:
    """Return a template with each `@NAME@` replaced by the value of NAME, or by nothing if it has none.

    Args:
        template: The text.
        environment: The values of the variables, by name.
    """
    return _VARIABLE.sub(lambda match: environment.get(match[1], ""), template)

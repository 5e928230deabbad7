from setuptools import find_packages, setup

package_name = "command_gate"

setup(
    name=package_name,
    version="0.1.0",
    packages=find_packages(exclude=["test"]),
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/" + package_name]),
        ("share/" + package_name, ["package.xml"]),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    maintainer="The tfloom developers",
    maintainer_email="tfloom@example.com",
    description="Passes velocity commands on, unless an obstacle is ahead or the commands have ended.",
    license="Apache-2.0",
    extras_require={"test": ["pytest"]},
    entry_points={"console_scripts": ["gate = command_gate.gate:main"]},
)

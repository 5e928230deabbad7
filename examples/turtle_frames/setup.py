from setuptools import find_packages, setup

package_name = "turtle_frames"

setup(
    name=package_name,
    version="0.1.0",
    packages=find_packages(),
    data_files=[
        ("share/ament_index/resource_index/packages", [f"resource/{package_name}"]),
        (f"share/{package_name}", ["package.xml"]),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    maintainer="The tfloom developers",
    maintainer_email="tfloom@example.com",
    description="Broadcasts where a turtle of turtlesim is, as the frame of its name under world.",
    license="Apache-2.0",
    entry_points={
        "console_scripts": [
            "broadcaster = turtle_frames.broadcaster:main",
        ],
    },
)

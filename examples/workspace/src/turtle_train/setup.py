from setuptools import find_packages, setup

package_name = 'turtle_train'

setup(
    name=package_name,
    version='0.1.0',
    packages=find_packages(exclude=['test']),
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),
        ('share/' + package_name, ['package.xml']),
    ],
    install_requires=['setuptools'],
    zip_safe=True,
    maintainer='The tfloom developers',
    maintainer_email='tfloom@example.com',
    description='Turtles of turtlesim that follow one another by their frames.',
    license='Apache-2.0',
    extras_require={
        'test': ['pytest'],
    },
    entry_points={
        'console_scripts': [
            'driver = turtle_train.driver:main',
            'follower = turtle_train.follower:main',
            'frames = turtle_train.frames:main',
            'train = turtle_train.train:main',
        ],
    },
)

"""ROS workspaces: packages that colcon has built, and tfloom's own programs.

- ament, index, ament_index, unsourced, packages_around: packages of prefixes, tfloom's programs, packages that no
  program finds, those of a clone
- program_scripts: a path for each of tfloom's programs
- resource_retriever: files named by package:// and other URLs
- create, package_templates: new packages
- interfaces, interface_stubs, get_interfaces: definitions in prefixes, and their types for checkers
- interface_package, listed_files, package_definitions: interface packages, built without CMake
- cmake_lists: CMakeLists.txt, read and never run
- cmake_syntax, cmake_values, cmake_regex: its language
- cmake_plan, installing: what it would install, installed; environment_hooks: scripts that a workspace runs
- leftovers: of earlier builds
- package_faults, missing_dependencies: what is wrong with package.xml and setup.py
- lint, copyright, licenses, pytest_markers: the checks of `colcon test`
- colcon/: its extensions
"""

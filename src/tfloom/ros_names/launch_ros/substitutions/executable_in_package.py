"""A program of a package as a substitution: `$(exec-in-pkg PROGRAM PACKAGE)`."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.ros.substitutions.executable_in_package import ExecutableInPackage as ExecutableInPackage

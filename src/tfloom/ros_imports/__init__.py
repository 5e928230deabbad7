"""How programs find ROS's names: what the façades in `ros_names/` need, and the import hooks.

- guard: the refusal to mix with a real ROS 2, and classes' names in ROS;  homes: GENERATED table of these names
- modules: imports of a façade on first use;  c_libraries: extension modules, as ROS 2 packages import them
- finder: the hook for packages that hold definitions and no Python
- absent: the hook that explains modules that tfloom doesn't have
- interrupted: no traceback of a program of a launch that Ctrl-C ends while it imports
- distributions: those beside tfloom; whether installed packages add anything by entry points
"""

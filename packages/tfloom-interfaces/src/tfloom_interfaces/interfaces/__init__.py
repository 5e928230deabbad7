"""The classes, generated from the definitions by `python -m tfloom.rosidl.generate`."""

"""The classes, generated from the definitions by `tools/generated.py`."""

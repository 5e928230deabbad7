"""Saved layouts: what a page shows from the start.

- layout: the values of a layout
- layout_file: our own files of YAML, read and written; which kind a file is
- placed_yaml: values of YAML with the lines of mistakes
- rviz_file: layouts of RViz's files, as far as they are known
"""

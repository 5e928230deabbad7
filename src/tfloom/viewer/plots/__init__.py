"""Numeric fields of topics over time, beside the scene.

- field_path: from `pose.position.x` or `ranges[3]` to a number of a message
- series: the numbers of one field, in bounded memory, and fewer of them for a page
- plots: the plots that all pages share, read from the topics' logs
"""

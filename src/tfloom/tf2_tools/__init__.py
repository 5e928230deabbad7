"""The programs of tf2: they print, watch, draw, serve and publish transforms."""

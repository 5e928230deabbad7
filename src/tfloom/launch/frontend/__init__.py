"""Launch files in other languages than Python: their elements, the parser, and how a tag gets its action."""

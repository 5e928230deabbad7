"""Pictures as lists of shapes, laid out once and written as PDF, SVG or PNG."""

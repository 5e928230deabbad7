"""Images, cameras, diagnostics and interactive markers: what programs around sensors import."""

"""Images, cameras, diagnostics and interactive markers for tfloom: what programs around sensors import."""

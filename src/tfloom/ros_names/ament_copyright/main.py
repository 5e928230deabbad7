"""Check files for copyright and licence."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.workspace.copyright import main as main

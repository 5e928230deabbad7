"""Check files for copyright and licence."""

from tfloom.workspace.copyright import main as main

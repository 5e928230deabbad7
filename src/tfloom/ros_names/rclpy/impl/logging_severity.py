"""The severities of log records."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.log.logging_severity import LoggingSeverity as LoggingSeverity

"""Loggers."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.node.log.rcutils_logger import CallerId as CallerId
from tfloom.node.log.rcutils_logger import RcutilsLogger as RcutilsLogger

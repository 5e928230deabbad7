"""The base class of substitutions."""

from tfloom.launch.substitution import Substitution as Substitution

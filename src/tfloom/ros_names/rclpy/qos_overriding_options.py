"""Overrides of QoS policies by parameters."""

from tfloom.node.qos.qos_overriding_options import InvalidQosOverridesError, QoSOverridingOptions

__all__ = ["InvalidQosOverridesError", "QoSOverridingOptions"]

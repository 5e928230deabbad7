"""QoS that parameters override."""

from tfloom.node.qos.qos_overriding_options import InvalidQosOverridesError, QoSOverridingOptions

__all__ = ["InvalidQosOverridesError", "QoSOverridingOptions"]

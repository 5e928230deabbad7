"""QoS profiles that parameters may override: `qos_overrides.<topic>.<publisher or subscription>.<policy>`."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any, TypeAlias, Union

from tfloom.interfaces.rcl_interfaces.msg import ParameterDescriptor, SetParametersResult
from tfloom.node.qos.qos import (
    DurabilityPolicy,
    HistoryPolicy,
    LivelinessPolicy,
    QoSPolicyEnum,
    QoSPolicyKind,
    QoSProfile,
    ReliabilityPolicy,
)
from tfloom.node.values.duration import Duration
from tfloom.ros_imports.guard import ros_home

if TYPE_CHECKING:
    from tfloom.node.parameters.node_parameters import NodeParameters

__all__ = [
    "InvalidQosOverridesError",
    "QoSOverridingOptions",
    "QoSProfileAttributes",
    "QosCallbackResult",
    "QosCallbackType",
    "apply_overrides",
]

QosCallbackResult = SetParametersResult
QosCallbackType = Callable[[QoSProfile], QosCallbackResult]
QoSProfileAttributes: TypeAlias = Union[  # noqa: UP007 - evaluated on 3.10
    HistoryPolicy, int, ReliabilityPolicy, DurabilityPolicy, Duration, LivelinessPolicy, bool
]
"""What a field of a profile holds."""

_ENUMS: dict[QoSPolicyKind, type[QoSPolicyEnum]] = {
    QoSPolicyKind.HISTORY: HistoryPolicy,
    QoSPolicyKind.RELIABILITY: ReliabilityPolicy,
    QoSPolicyKind.DURABILITY: DurabilityPolicy,
    QoSPolicyKind.LIVELINESS: LivelinessPolicy,
}
_DURATIONS = (QoSPolicyKind.DEADLINE, QoSPolicyKind.LIFESPAN, QoSPolicyKind.LIVELINESS_LEASE_DURATION)


class InvalidQosOverridesError(Exception):
    """The overrides result in an invalid profile, or in one that the callback rejects."""

    __module__ = ros_home("rclpy.qos_overriding_options", __name__)


class QoSOverridingOptions:
    """The policies of a publisher or subscription that parameters may override.

    Args:
        policy_kinds: The policies.
        callback: Takes the profile with its overrides, and accepts or rejects it.
        entity_id: Distinguishes several endpoints of one topic in one node.
    """

    def __init__(
        self,
        policy_kinds: Iterable[QoSPolicyKind],
        *,
        callback: QosCallbackType | None = None,
        entity_id: str | None = None,
    ) -> None:
        self._policy_kinds = list(policy_kinds)
        self._callback = callback
        self._entity_id = entity_id

    @property
    def policy_kinds(self) -> list[QoSPolicyKind]:
        """The policies that may be overridden."""
        return self._policy_kinds

    @property
    def callback(self) -> QosCallbackType | None:
        """Accepts or rejects the profile with its overrides."""
        return self._callback

    @property
    def entity_id(self) -> str | None:
        """Distinguishes several endpoints of one topic in one node."""
        return self._entity_id

    @classmethod
    def with_default_policies(
        cls,
        *,
        callback: QosCallbackType | None = None,
        entity_id: str | None = None,
    ) -> QoSOverridingOptions:
        """Return options for history, depth and reliability."""
        kinds = (QoSPolicyKind.HISTORY, QoSPolicyKind.DEPTH, QoSPolicyKind.RELIABILITY)
        return cls(kinds, callback=callback, entity_id=entity_id)


def apply_overrides(
    parameters: NodeParameters, kind: str, topic_name: str, profile: QoSProfile, options: QoSOverridingOptions
) -> QoSProfile:
    """Declare the parameters of the policies, and return the profile with their values.

    Args:
        parameters: The parameters of the node, which override.
        kind: `publisher` or `subscription`.
        topic_name: The topic's full name.
        profile: The profile before the overrides.
        options: The policies that may be overridden.

    Raises:
        InvalidQosOverridesError: a value isn't one of the policy's, or the callback rejects the profile.
        InvalidParameterTypeException: a value is of the wrong type.
    """
    settings = {name: getattr(profile, name) for name in profile.field_names()}
    suffix = f"_{options.entity_id}" if options.entity_id else ""
    for policy in options.policy_kinds:
        name = f"qos_overrides.{topic_name}.{kind}{suffix}.{policy.name.lower()}"
        settings[policy.name.lower()] = _declared_setting(
            parameters, name, policy, settings[policy.name.lower()]
        )
    overridden = QoSProfile(**settings)
    if options.callback is not None:
        result = options.callback(overridden)
        if not result.successful:
            raise InvalidQosOverridesError(f"Provided QoS overrides were refused: {result.reason}")
    return overridden


def _declare_qos_parameters(
    entity_type: type[Any], node: Any, topic_name: str, qos: QoSProfile, options: QoSOverridingOptions
) -> None:
    """Change `qos` to `apply_overrides` of it; a function by rclpy's name, which programs' tests call.

    Args:
        entity_type: Publisher or Subscription.
        node: The node whose parameters override.
        topic_name: The topic's full name.
        qos: The profile.
        options: The policies that may be overridden.

    Raises:
        InvalidQosOverridesError: as from `apply_overrides`.
    """
    overridden = apply_overrides(node, entity_type.__name__.lower(), topic_name, qos, options)
    for name in qos.field_names():
        setattr(qos, name, getattr(overridden, name))


def _declared_setting(parameters: NodeParameters, name: str, policy: QoSPolicyKind, default: Any) -> Any:
    descriptor = ParameterDescriptor(read_only=True)
    if policy in _DURATIONS:
        return Duration(nanoseconds=_declared_value(parameters, name, default.nanoseconds, descriptor))
    kind = _ENUMS.get(policy)
    if kind is None:
        return _declared_value(parameters, name, default, descriptor)
    text = _declared_value(parameters, name, default.short_key, descriptor)
    try:
        return kind.get_from_short_key(text)
    except KeyError:
        short_keys = ", ".join(kind.short_keys())
        raise InvalidQosOverridesError(f"{name} is '{text}', which is none of: {short_keys}") from None


def _declared_value(
    parameters: NodeParameters, name: str, default: Any, descriptor: ParameterDescriptor
) -> Any:
    if not parameters.has_parameter(name):
        parameters.declare_parameters("", [(name, default, descriptor)])
    return parameters.get_parameter(name).value

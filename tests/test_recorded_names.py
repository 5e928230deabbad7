"""The recorded names of ROS 2 exist in tfloom, with their signatures; those that are listed as missing do not."""

from __future__ import annotations

import gzip
import importlib
import json
import sys
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import Any

import pytest
from docs import rclpy_api
from tests.conftest import run_to_end
from tests.recorded_signatures import differences, signature_differences
from tools.facades.recorded import (
    Name,
    all_names,
    is_of,
    is_only_imported,
    missing,
    names_of,
    reason_for,
)

KILTED = Path(__file__).with_name("golden") / "api_kilted.json.gz"
"""The names of rclpy 9.1.2, recorded by `tests/oracles/record_rclpy_names.py` from its wheel of Kilted."""
TYPES_OF_A_FILE = "for annotations within the file of the original alone"
DIFFERENT_FROM_KILTED = {
    "rclpy.InitContextManager()": "`init` creates it; the constructor has other parameters",
    "rclpy.try_shutdown": "it leaves signal handlers alone, as in Jazzy; there is no uninstall_handlers",
    "rclpy.action.client.SendGoalKWargs": TYPES_OF_A_FILE,
    "rclpy.action.client.T": TYPES_OF_A_FILE,
    "rclpy.executors.T": TYPES_OF_A_FILE,
    "rclpy.task.T": TYPES_OF_A_FILE,
    "rclpy.waitable.T": TYPES_OF_A_FILE,
    "rclpy.lifecycle.node.CreateLifecyclePublisherArgs": TYPES_OF_A_FILE,
    "rclpy.lifecycle.node.LifecycleNodeArgs": TYPES_OF_A_FILE,
    "rclpy.node.Node.ParameterInput": TYPES_OF_A_FILE,
    "rclpy.type_hash.TypeHashDictionary": TYPES_OF_A_FILE,
    "rclpy.type_support.CommonMsgSrvMetaClass": TYPES_OF_A_FILE,
    "rclpy.type_support.MsgMetaClass": TYPES_OF_A_FILE,
    "rclpy.type_support.PyCapsule": TYPES_OF_A_FILE,
    "rclpy.qos.LivelinessPolicy.RMW_QOS_POLICY_DURABILITY_UNKNOWN": "a slip in the original",
    "rclpy.qos.QoSLivelinessPolicy.RMW_QOS_POLICY_DURABILITY_UNKNOWN": "a slip in the original",
    "rclpy.action.server.ActionServer()": "result_timeout is that of the distribution in force",
}
"""Patterns as in `missing.txt`, which holds here, too, with their reasons."""

DEPENDING_ON_THE_DISTRIBUTION = {"rclpy.action.server.ActionServer()"}
"""The rows that are needed only under another distribution than Kilted."""

OF_LYRICAL = {
    "rclpy.action.client.ActionClient": (
        "(self, node, action_type, action_name, *, enable_feedback_msg_optimization=False)"
    ),
    "rclpy.action.client.ActionClient.configure_introspection": (
        "(self, clock, service_event_qos_profile, introspection_state)"
    ),
    "rclpy.client.BaseClient": "",
    "rclpy.clock.BaseClock": "",
    "rclpy.endpoint_info.EndpointTypeEnum": "",
    "rclpy.endpoint_info.ServiceEndpointInfo": "",
    "rclpy.endpoint_info.TopicEndpointInfo": "",
    "rclpy.exceptions.TimeSourceChangedError": "",
    "rclpy.executors.Executor.is_spinning": "property",
    "rclpy.experimental.AsyncClient.call": "(self, request)",
    "rclpy.experimental.AsyncClient.wait_for_service": "(self, check_interval=0.1)",
    "rclpy.experimental.AsyncClock.sleep": "(self, seconds)",
    "rclpy.experimental.AsyncNode.create_client": "(self, srv_type, srv_name, *, qos_profile)",
    "rclpy.experimental.AsyncNode.create_publisher": "(self, msg_type, topic, qos_profile)",
    "rclpy.experimental.AsyncNode.create_service": (
        "(self, srv_type, srv_name, callback, *, qos_profile, concurrent=False)"
    ),
    "rclpy.experimental.AsyncNode.create_subscription": (
        "(self, msg_type, topic, callback, qos_profile, *, raw=False, concurrent=False, content_filter_options=None)"
    ),
    "rclpy.experimental.AsyncNode.create_timer": "(self, timer_period_sec, callback, autostart=True)",
    "rclpy.experimental.AsyncNode.destroy_node": "(self)",
    "rclpy.experimental.AsyncNode.run": "(self)",
    "rclpy.experimental.AsyncNode.wait_for_node": "(self, fully_qualified_node_name, check_interval=0.1)",
    "rclpy.experimental.AsyncPublisher": "",
    "rclpy.experimental.AsyncService": "",
    "rclpy.experimental.AsyncSubscription": "",
    "rclpy.experimental.AsyncTimer": "",
    "rclpy.node.BaseNode": "",
    "rclpy.node.Node.create_subscription": (
        "(self, msg_type, topic, callback, qos_profile, *, content_filter_options=None, "
        "acceptable_buffer_backends=None)"
    ),
    "rclpy.node.Node.get_action_client_names_and_types_by_node": "(self, node_name, node_namespace)",
    "rclpy.node.Node.get_action_names_and_types": "(self)",
    "rclpy.node.Node.get_action_server_names_and_types_by_node": "(self, node_name, node_namespace)",
    "rclpy.node.Node.get_clients_info_by_service": "(self, service_name, no_mangle=False)",
    "rclpy.node.Node.get_servers_info_by_service": "(self, service_name, no_mangle=False)",
    "rclpy.parameter_event_handler.ParameterEventHandler.configure_nodes_filter": "(self, node_names=None)",
    "rclpy.publisher.BasePublisher": "",
    "rclpy.service.BaseService": "",
    "rclpy.subscription.BaseSubscription": "",
    "rclpy.subscription.MessageInfo": "",
    "rclpy.subscription.PublisherGID": "",
    "rclpy.subscription.Subscription.is_cft_supported": "property",
    "rclpy.time.Time.to_datetime": "(self)",
    "rclpy.timer.BaseTimer": "",
    "rclpy.type_support.ImplT": "",
    "rosidl_pycommon.interface_base_classes.BaseAction": "",
    "rosidl_pycommon.interface_base_classes.BaseImpl": "",
    "rosidl_pycommon.interface_base_classes.BaseMessage": "",
    "rosidl_pycommon.interface_base_classes.BaseService": "",
}
"""Names that Lyrical adds to those of Kilted, with their parameters. There is no wheel to record them from."""

NAMES = all_names()
REASONS = missing()
pytestmark = pytest.mark.filterwarnings("ignore:importing 'qos_event'")


def test_each_name_exists_with_the_recorded_signature() -> None:
    amiss = [
        f"{name.full}: {difference}"
        for name in NAMES
        if reason_for(name, REASONS) is None
        for difference in differences(name)
    ]
    assert not amiss, "\n".join(amiss)


def test_another_object_than_the_homes_is_detected() -> None:
    """Check the instrument itself."""
    duration = Name("rclpy.time", "Time", "import", "rclpy.duration")
    (found,) = differences(duration)
    assert found.endswith("not the object of rclpy.duration")


def test_an_imported_name_is_one_object_in_all_modules() -> None:
    """Compare names of one home, compiled modules included, and the QoS profiles."""
    objects: dict[tuple[str, str], dict[int, str]] = {}
    for name in NAMES:
        is_profile = name.path.startswith("qos_profile_")
        if name.kind == "import" and (name.signature or is_profile) and not reason_for(name, REASONS):
            thing = getattr(importlib.import_module(name.module), name.path)
            objects.setdefault((name.signature, name.path), {})[id(thing)] = name.module
    assert len(objects) > 100
    assert not [where for where in objects.values() if len(where) > 1]


def test_dir_lists_imported_names() -> None:
    missing = [
        name.full
        for name in NAMES
        if name.kind == "import"
        and not reason_for(name, REASONS)
        and name.path not in dir(importlib.import_module(name.module))
    ]
    assert not missing


def wrongly_missing(patterns: Iterable[str]) -> Iterator[str]:
    """Yield the patterns that match no recorded name, and the existing names that they match."""
    for pattern in patterns:
        matched = [name for name in NAMES if is_of(name, pattern)]
        if not matched:
            yield f"{pattern}: no recorded name is so called"
        yield from (f"{pattern}: {name.full} is there" for name in matched if not any(differences(name)))


def test_names_listed_as_missing_are_missing() -> None:
    amiss = list(wrongly_missing(REASONS))
    assert not amiss, "\n".join(
        [*amiss, "take it out of tools/facades/missing.txt, and run `make generated`"]
    )


def test_existing_or_unrecorded_names_are_not_missing() -> None:
    assert list(wrongly_missing(["rclpy.node.Node.fly", "rclpy.node.Node.create_timer"])) == [
        "rclpy.node.Node.fly: no recorded name is so called",
        "rclpy.node.Node.create_timer: rclpy.node.Node.create_timer is there",
    ]


def test_signature_differences_are_found() -> None:
    """The comparison reports each difference from these recorded signatures."""

    def ours(node: object, *, depth: int = 10, raw: bool = False) -> None:
        """Return a substitute for one of tfloom's functions."""

    def seen(signature: str) -> list[str]:
        return list(signature_differences(signature, ours))

    assert seen("(node: Node, *, depth: Union[int, None] = 10) -> None") == []
    assert seen("(self, node, **kwargs)") == []
    assert seen("(node, *, queue=1)") == ["it has no parameter queue"]
    assert seen("(node, depth=10)")[0] == "its parameter depth is keyword, not positional"
    assert seen("(node, *, depth=5)") == ["the default of depth is 10, not 5"]
    assert seen("(*, depth=10)") == ["it requires a parameter node that the recorded one lacks"]
    assert seen("(node='x')") == ["the default of node is None, not 'x'"]
    missing = Name("rclpy.node", "Node.fly", "method", "(self)")
    assert list(differences(missing)) == ["it does not exist"]
    elsewhere = Name("rclpy.nowhere", "Node", "class", "")
    assert list(differences(elsewhere)) == ["the module does not exist"]


def test_names_that_are_only_imported_are_not_there() -> None:
    """In launch and launch_ros a module has what it defines, and of its imports those that a program uses."""
    dropped = [name for name in NAMES if is_only_imported(name)]
    assert {name.module.split(".")[0] for name in dropped} == {"launch", "launch_ros"}
    assert len(dropped) > 600
    assert not [name.full for name in dropped if name.path in dir(importlib.import_module(name.module))]


@pytest.mark.parametrize(
    ("module", "name", "home"),
    [
        ("launch.action", "LaunchContext", "launch"),
        ("launch.actions.execute_local", "TimerAction", "launch.actions"),
        ("launch_ros.actions.node", "ExecuteProcess", "launch.actions"),
        ("launch_ros.parameters_type", "ParameterFile", "launch_ros.parameter_descriptions"),
        ("launch_ros.substitutions.find_package", "get_package_share_directory", "ament_index_python"),
    ],
)
def test_names_that_programs_import_from_elsewhere_are_there(module: str, name: str, home: str) -> None:
    found = getattr(importlib.import_module(module), name)
    assert found is getattr(importlib.import_module(home), name)


def test_page_of_the_site_is_made_without_tfloom() -> None:
    code = "import sys; sys.modules['tfloom'] = None\nfrom docs import rclpy_api; print(rclpy_api.page())"
    result = run_to_end([sys.executable, "-c", code], cwd=Path(__file__).parents[1])
    assert result.returncode == 0, result.stderr
    lines = result.stdout.splitlines()
    assert (
        "| `Node.create_timer(timer_period_sec, callback, callback_group=None, clock=None, autostart=True)` | ✓ |"
        in lines
    )
    assert "| `ParameterEventHandler.Callbacks()` | an internal of rclpy |" in lines
    assert result.stdout == rclpy_api.page() + "\n"


def names_of_kilted() -> list[Name]:
    with gzip.open(KILTED, "rt", encoding="utf-8") as file:
        modules: dict[str, Any] = json.load(file)
    return [name for module, entries in sorted(modules.items()) for name in names_of(module, entries)]


@pytest.mark.filterwarnings(
    "ignore::DeprecationWarning", "ignore::UserWarning"
)  # of names that are deprecated
def test_names_of_kilted_exist_but_for_the_rows() -> None:
    names = names_of_kilted()
    assert len(names) > 600
    # The rows for Jazzy are about the same objects.
    known = [name for name in names if any(is_of(name, pattern) for pattern in REASONS)]
    different = {name: list(differences(name)) for name in names if name not in known}
    found = {name: amiss for name, amiss in different.items() if amiss}
    without_row = [
        f"{name.full}: {amiss}"
        for name, amiss in found.items()
        if not any(is_of(name, pattern) for pattern in DIFFERENT_FROM_KILTED)
    ]
    assert not without_row, "\n".join(without_row)
    unneeded = [
        pattern
        for pattern in DIFFERENT_FROM_KILTED
        if pattern not in DEPENDING_ON_THE_DISTRIBUTION and not any(is_of(name, pattern) for name in found)
    ]
    assert not unneeded, f"take these rows out, because nothing differs there any more: {unneeded}"


@pytest.mark.filterwarnings(
    "ignore::DeprecationWarning", "ignore::UserWarning"
)  # of names that are deprecated
@pytest.mark.skipif(sys.version_info < (3, 11), reason="AsyncNode needs asyncio.TaskGroup")
def test_names_of_lyrical_exist() -> None:
    amiss: list[str] = []
    for full, signature in OF_LYRICAL.items():
        # Modules have small letters, and the first name in one a capital.
        parts = full.split(".")
        count = next(number for number, part in enumerate(parts) if part != part.lower())
        module, path = ".".join(parts[:count]), ".".join(parts[count:])
        kind = "method" if "." in path and signature.startswith("(") else ("class" if signature else "value")
        kind = "property" if signature == "property" else kind
        amiss += [f"{full}: {difference}" for difference in differences(Name(module, path, kind, signature))]
    assert not amiss, "\n".join(amiss)

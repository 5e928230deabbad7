"""Checks and conversions of arguments, which several classes share."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

__all__ = [
    "AsyncSafeSignalManager",
    "ensure_argument_type",
    "is_a",
    "is_a_subclass",
    "isclassinstance",
    "normalize_to_list_of_entities",
    "normalize_to_list_of_substitutions",
    "perform_substitutions",
    "visit_all_entities_and_collect_futures",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from launch.utilities import class_tools_impl as class_tools_impl
    from launch.utilities import ensure_argument_type_impl as ensure_argument_type_impl
    from launch.utilities import normalize_to_list_of_entities_impl as normalize_to_list_of_entities_impl
    from launch.utilities import normalize_to_list_of_substitutions_impl as normalize_to_list_of_substitutions_impl
    from launch.utilities import perform_substitutions_impl as perform_substitutions_impl
    from launch.utilities import signal_management as signal_management
    from launch.utilities import type_utils as type_utils
    from launch.utilities import typing_file_path as typing_file_path
    from launch.utilities import visit_all_entities_and_collect_futures_impl as visit_all_entities_and_collect_futures_impl
    from tfloom.launch.utilities.class_tools import is_a as is_a
    from tfloom.launch.utilities.class_tools import is_a_subclass as is_a_subclass
    from tfloom.launch.utilities.class_tools import isclassinstance as isclassinstance
    from tfloom.launch.utilities.ensure_argument_type import ensure_argument_type as ensure_argument_type
    from tfloom.launch.utilities.normalize_to_list_of_entities import normalize_to_list_of_entities as normalize_to_list_of_entities
    from tfloom.launch.utilities.normalize_to_list_of_substitutions import normalize_to_list_of_substitutions as normalize_to_list_of_substitutions
    from tfloom.launch.utilities.perform_substitutions import perform_substitutions as perform_substitutions
    from tfloom.launch.utilities.signal_management import AsyncSafeSignalManager as AsyncSafeSignalManager
    from tfloom.launch.utilities.visit_all_entities_and_collect_futures import visit_all_entities_and_collect_futures as visit_all_entities_and_collect_futures
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        AsyncSafeSignalManager="tfloom.launch.utilities.signal_management",
        class_tools_impl="launch.utilities",
        ensure_argument_type="tfloom.launch.utilities.ensure_argument_type",
        ensure_argument_type_impl="launch.utilities",
        is_a="tfloom.launch.utilities.class_tools",
        is_a_subclass="tfloom.launch.utilities.class_tools",
        isclassinstance="tfloom.launch.utilities.class_tools",
        normalize_to_list_of_entities="tfloom.launch.utilities.normalize_to_list_of_entities",
        normalize_to_list_of_entities_impl="launch.utilities",
        normalize_to_list_of_substitutions="tfloom.launch.utilities.normalize_to_list_of_substitutions",
        normalize_to_list_of_substitutions_impl="launch.utilities",
        perform_substitutions="tfloom.launch.utilities.perform_substitutions",
        perform_substitutions_impl="launch.utilities",
        signal_management="launch.utilities",
        type_utils="launch.utilities",
        typing_file_path="launch.utilities",
        visit_all_entities_and_collect_futures="tfloom.launch.utilities.visit_all_entities_and_collect_futures",
        visit_all_entities_and_collect_futures_impl="launch.utilities",
    )

"""Read, write, record and play bags."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.ros_guard import claim

claim("rosbag2_py")

__all__ = [
    "BagMetadata",
    "CompressionMode",
    "CompressionOptions",
    "ConverterOptions",
    "FileInformation",
    "Info",
    "LocalMessageDefinitionSource",
    "MessageDefinition",
    "MetadataIo",
    "PlayOptions",
    "Player",
    "ReadOrder",
    "ReadOrderSortBy",
    "RecordOptions",
    "Recorder",
    "Reindexer",
    "SequentialCompressionReader",
    "SequentialCompressionWriter",
    "SequentialReader",
    "SequentialWriter",
    "ServiceRequestsSource",
    "StorageFilter",
    "StorageOptions",
    "TopicInformation",
    "TopicMetadata",
    "add_dll_directories_from_env",
    "bag_rewrite",
    "compression_mode_from_string",
    "compression_mode_to_string",
    "convert_rclcpp_qos_to_rclpy_qos",
    "get_default_storage_id",
    "get_registered_compressors",
    "get_registered_readers",
    "get_registered_serializers",
    "get_registered_writers",
    "to_rclcpp_qos_vector",
]

TYPE_CHECKING = False
if TYPE_CHECKING:
    from tfloom.bag.rosbag2_names.info import Info as Info
    from tfloom.bag.rosbag2_names.info import Reindexer as Reindexer
    from tfloom.bag.rosbag2_names.qos import convert_rclcpp_qos_to_rclpy_qos as convert_rclcpp_qos_to_rclpy_qos
    from tfloom.bag.rosbag2_names.qos import to_rclcpp_qos_vector as to_rclcpp_qos_vector
    from tfloom.bag.rosbag2_names.readers import SequentialCompressionReader as SequentialCompressionReader
    from tfloom.bag.rosbag2_names.readers import SequentialReader as SequentialReader
    from tfloom.bag.rosbag2_names.readers import get_registered_readers as get_registered_readers
    from tfloom.bag.rosbag2_names.storage import BagMetadata as BagMetadata
    from tfloom.bag.rosbag2_names.storage import ConverterOptions as ConverterOptions
    from tfloom.bag.rosbag2_names.storage import FileInformation as FileInformation
    from tfloom.bag.rosbag2_names.storage import LocalMessageDefinitionSource as LocalMessageDefinitionSource
    from tfloom.bag.rosbag2_names.storage import MessageDefinition as MessageDefinition
    from tfloom.bag.rosbag2_names.storage import MetadataIo as MetadataIo
    from tfloom.bag.rosbag2_names.storage import ReadOrder as ReadOrder
    from tfloom.bag.rosbag2_names.storage import ReadOrderSortBy as ReadOrderSortBy
    from tfloom.bag.rosbag2_names.storage import StorageFilter as StorageFilter
    from tfloom.bag.rosbag2_names.storage import StorageOptions as StorageOptions
    from tfloom.bag.rosbag2_names.storage import TopicInformation as TopicInformation
    from tfloom.bag.rosbag2_names.storage import TopicMetadata as TopicMetadata
    from tfloom.bag.rosbag2_names.storage import get_default_storage_id as get_default_storage_id
    from tfloom.bag.rosbag2_names.transport import PlayOptions as PlayOptions
    from tfloom.bag.rosbag2_names.transport import Player as Player
    from tfloom.bag.rosbag2_names.transport import RecordOptions as RecordOptions
    from tfloom.bag.rosbag2_names.transport import Recorder as Recorder
    from tfloom.bag.rosbag2_names.transport import ServiceRequestsSource as ServiceRequestsSource
    from tfloom.bag.rosbag2_names.transport import bag_rewrite as bag_rewrite
    from tfloom.bag.rosbag2_names.writers import CompressionMode as CompressionMode
    from tfloom.bag.rosbag2_names.writers import CompressionOptions as CompressionOptions
    from tfloom.bag.rosbag2_names.writers import SequentialCompressionWriter as SequentialCompressionWriter
    from tfloom.bag.rosbag2_names.writers import SequentialWriter as SequentialWriter
    from tfloom.bag.rosbag2_names.writers import compression_mode_from_string as compression_mode_from_string
    from tfloom.bag.rosbag2_names.writers import compression_mode_to_string as compression_mode_to_string
    from tfloom.bag.rosbag2_names.writers import get_registered_compressors as get_registered_compressors
    from tfloom.bag.rosbag2_names.writers import get_registered_serializers as get_registered_serializers
    from tfloom.bag.rosbag2_names.writers import get_registered_writers as get_registered_writers
    from tfloom.c_libraries import add_dll_directories_from_env as add_dll_directories_from_env
else:
    from tfloom.ros_modules import deferred

    __getattr__, __dir__ = deferred(
        __name__,
        BagMetadata="tfloom.bag.rosbag2_names.storage",
        CompressionMode="tfloom.bag.rosbag2_names.writers",
        CompressionOptions="tfloom.bag.rosbag2_names.writers",
        ConverterOptions="tfloom.bag.rosbag2_names.storage",
        FileInformation="tfloom.bag.rosbag2_names.storage",
        Info="tfloom.bag.rosbag2_names.info",
        LocalMessageDefinitionSource="tfloom.bag.rosbag2_names.storage",
        MessageDefinition="tfloom.bag.rosbag2_names.storage",
        MetadataIo="tfloom.bag.rosbag2_names.storage",
        PlayOptions="tfloom.bag.rosbag2_names.transport",
        Player="tfloom.bag.rosbag2_names.transport",
        ReadOrder="tfloom.bag.rosbag2_names.storage",
        ReadOrderSortBy="tfloom.bag.rosbag2_names.storage",
        RecordOptions="tfloom.bag.rosbag2_names.transport",
        Recorder="tfloom.bag.rosbag2_names.transport",
        Reindexer="tfloom.bag.rosbag2_names.info",
        SequentialCompressionReader="tfloom.bag.rosbag2_names.readers",
        SequentialCompressionWriter="tfloom.bag.rosbag2_names.writers",
        SequentialReader="tfloom.bag.rosbag2_names.readers",
        SequentialWriter="tfloom.bag.rosbag2_names.writers",
        ServiceRequestsSource="tfloom.bag.rosbag2_names.transport",
        StorageFilter="tfloom.bag.rosbag2_names.storage",
        StorageOptions="tfloom.bag.rosbag2_names.storage",
        TopicInformation="tfloom.bag.rosbag2_names.storage",
        TopicMetadata="tfloom.bag.rosbag2_names.storage",
        add_dll_directories_from_env="tfloom.c_libraries",
        bag_rewrite="tfloom.bag.rosbag2_names.transport",
        compression_mode_from_string="tfloom.bag.rosbag2_names.writers",
        compression_mode_to_string="tfloom.bag.rosbag2_names.writers",
        convert_rclcpp_qos_to_rclpy_qos="tfloom.bag.rosbag2_names.qos",
        get_default_storage_id="tfloom.bag.rosbag2_names.storage",
        get_registered_compressors="tfloom.bag.rosbag2_names.writers",
        get_registered_readers="tfloom.bag.rosbag2_names.readers",
        get_registered_serializers="tfloom.bag.rosbag2_names.writers",
        get_registered_writers="tfloom.bag.rosbag2_names.writers",
        to_rclcpp_qos_vector="tfloom.bag.rosbag2_names.qos",
    )

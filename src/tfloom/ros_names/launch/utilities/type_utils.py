"""Values of launch files and parameters: int, float, bool, str, lists of one of them, and substitutions for them."""
# Written by `python -m tools.facades`, from tools/facades/names.yaml.

from tfloom.launch.utilities.type_utils import AllowedTypesTuple as AllowedTypesTuple
from tfloom.launch.utilities.type_utils import AllowedTypesType as AllowedTypesType
from tfloom.launch.utilities.type_utils import AllowedValueType as AllowedValueType
from tfloom.launch.utilities.type_utils import ListTypesTuple as ListTypesTuple
from tfloom.launch.utilities.type_utils import ListTypesType as ListTypesType
from tfloom.launch.utilities.type_utils import ListValueType as ListValueType
from tfloom.launch.utilities.type_utils import NormalizedScalarType as NormalizedScalarType
from tfloom.launch.utilities.type_utils import NormalizedSequenceType as NormalizedSequenceType
from tfloom.launch.utilities.type_utils import NormalizedValueType as NormalizedValueType
from tfloom.launch.utilities.type_utils import ScalarTypesTuple as ScalarTypesTuple
from tfloom.launch.utilities.type_utils import ScalarTypesType as ScalarTypesType
from tfloom.launch.utilities.type_utils import ScalarValueType as ScalarValueType
from tfloom.launch.utilities.type_utils import SequenceValueType as SequenceValueType
from tfloom.launch.utilities.type_utils import SomeScalarType as SomeScalarType
from tfloom.launch.utilities.type_utils import SomeSequenceType as SomeSequenceType
from tfloom.launch.utilities.type_utils import SomeValueType as SomeValueType
from tfloom.launch.utilities.type_utils import StrSomeScalarType as StrSomeScalarType
from tfloom.launch.utilities.type_utils import StrSomeSequenceType as StrSomeSequenceType
from tfloom.launch.utilities.type_utils import StrSomeValueType as StrSomeValueType
from tfloom.launch.utilities.type_utils import coerce_list as coerce_list
from tfloom.launch.utilities.type_utils import coerce_to_type as coerce_to_type
from tfloom.launch.utilities.type_utils import extract_type as extract_type
from tfloom.launch.utilities.type_utils import get_typed_value as get_typed_value
from tfloom.launch.utilities.type_utils import is_instance_of as is_instance_of
from tfloom.launch.utilities.type_utils import is_instance_of_valid_type as is_instance_of_valid_type
from tfloom.launch.utilities.type_utils import is_normalized_substitution as is_normalized_substitution
from tfloom.launch.utilities.type_utils import is_substitution as is_substitution
from tfloom.launch.utilities.type_utils import is_typing_list as is_typing_list
from tfloom.launch.utilities.type_utils import is_valid_scalar_type as is_valid_scalar_type
from tfloom.launch.utilities.type_utils import normalize_typed_substitution as normalize_typed_substitution
from tfloom.launch.utilities.type_utils import perform_typed_substitution as perform_typed_substitution

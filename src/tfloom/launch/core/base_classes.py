"""The base classes of conditions, substitutions and entities."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from typing import TYPE_CHECKING, Any, ClassVar, Union

from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.core.private_names import HasPrivateNames
from tfloom.ros_imports.guard import ros_home, ros_repr

if TYPE_CHECKING:
    from asyncio import Future

__all__ = [
    "Condition",
    "LaunchDescriptionEntity",
    "ParsedSubstitution",
    "SomeEntitiesType",
    "SomeEntitiesType_types_tuple",
    "SomeSubstitutionsType",
    "SomeSubstitutionsType_types_tuple",
    "Substitution",
    "SubstitutionFailure",
    "TextSubstitution",
    "described",
    "normalize_to_list_of_entities",
]


class Condition:
    """A predicate that decides, when an action is visited, whether it is executed.

    Args:
        predicate: Called with the context; None: a condition that never holds.
    """

    def __init__(self, *, predicate: Callable[[LaunchContext], bool] | None = None) -> None:
        self._predicate = predicate

    def __repr__(self) -> str:
        return ros_repr(self)

    def describe(self) -> str:
        """Return a description for people."""
        return repr(self)

    def evaluate(self, context: LaunchContext) -> bool:
        """Return whether the condition holds now."""
        return self._predicate is not None and self._predicate(context)


class Substitution(HasPrivateNames):
    """A text that is only known when the launch runs."""

    def __repr__(self) -> str:
        return ros_repr(self)

    def perform(self, context: LaunchContext) -> str:
        """Return the text; derived classes implement it.

        Raises:
            NotImplementedError: the class has no `perform` of its own.
        """
        raise NotImplementedError(
            f"{type(self).__name__} has no method 'perform', which returns the substitution's text"
        )

    def describe(self) -> str:
        """Return a description for people."""
        return repr(self)


SomeSubstitutionsType = Union[str, Substitution, Iterable[str | Substitution]]
"""What an argument accepts where it takes substitutions: a text, a substitution, or a list of both, concatenated."""

SomeSubstitutionsType_types_tuple = (str, Substitution, Iterable)
"""The same for `isinstance`."""


class SubstitutionFailure(RuntimeError):  # ROS's name
    """A substitution cannot be performed.

    Args:
        msg: What is wrong.
    """

    __module__ = ros_home("launch.substitutions.substitution_failure", __name__)

    def __init__(self, msg: object) -> None:
        super().__init__(msg)


def described(substitutions: Iterable[Substitution]) -> str:
    """Return the descriptions of substitutions that are concatenated."""
    return " + ".join(substitution.describe() for substitution in substitutions)


class TextSubstitution(Substitution):
    """A text.

    Args:
        text: The text itself.

    Raises:
        TypeError: `text` is not a text.
    """

    def __init__(self, *, text: str) -> None:
        if not isinstance(text, str):
            raise TypeError(f"TextSubstitution expected Text object got '{type(text)}' instead.")
        self._text = text

    @property
    def text(self) -> str:
        """Text that the substitution stands for, whatever the context."""
        return self._text

    def describe(self) -> str:
        """Return a description for people."""
        return f"'{self._text}'"

    def perform(self, context: LaunchContext) -> str:
        """Return the text."""
        return self._text


class ParsedSubstitution(Substitution):
    """A substitution whose arguments in launch files, `$(name argument …)`, are its constructor's, in order."""

    _arguments: ClassVar[tuple[str, ...]] = ()
    """Names that the constructor has for them."""
    _optional: ClassVar[int] = 0
    """How many of them, at the end, may be missing."""
    _fault: ClassVar[str]
    """Text of the error of another number of them."""
    _error: ClassVar[type[Exception]] = TypeError
    """Class of this error."""

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[Substitution], dict[str, Any]]:
        """Return the class, and the arguments that the text of a launch file gives its constructor.

        Raises:
            TypeError, ValueError, AttributeError: there are too few or too many; the class defines which it is.
        """
        if not len(cls._arguments) - cls._optional <= len(data) <= len(cls._arguments):
            raise cls._error(cls._fault.format(class_name=cls.__name__, count=len(data)))
        return cls, dict(zip(cls._arguments, data, strict=False))


class LaunchDescriptionEntity(HasPrivateNames):
    """A node of the tree that the launch service visits."""

    def __repr__(self) -> str:
        return ros_repr(self)

    def describe(self) -> str:
        """Return a description for people; derived classes implement it.

        Raises:
            NotImplementedError: the class has no `describe` of its own.
        """
        raise NotImplementedError(f"{type(self).__name__} has no method 'describe'")

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the entities under this one, as far as they are known before it is visited."""
        return []

    def describe_conditional_sub_entities(
        self,
    ) -> list[tuple[str, Iterable[LaunchDescriptionEntity]]]:
        """Return the entities that may be visited, in groups, each with the text of its condition."""
        return []

    def visit(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Do what the entity stands for, and return the entities to visit next, at once and in their order."""
        return None

    def end_visit(self, context: LaunchContext) -> None:
        """Do what follows the visit of the entities that `visit` has returned; derived classes override it."""

    def get_asyncio_future(self) -> Future[Any] | None:
        """Return a future that is done when the entity has ended; None if it ends with its visit."""
        return None


SomeEntitiesType = Union[LaunchDescriptionEntity, Iterable[LaunchDescriptionEntity]]
"""What an argument accepts where it takes entities: one, or several."""

SomeEntitiesType_types_tuple = (LaunchDescriptionEntity, Iterable)
"""The same for `isinstance`."""


def normalize_to_list_of_entities(
    entities: Iterable[SomeEntitiesType], *, name: str = "entities"
) -> list[LaunchDescriptionEntity]:
    """Return all entities of nested lists, in order.

    Args:
        entities: The entities, and lists of them.
        name: What the error calls it.

    Raises:
        TypeError: an item is not an entity.
    """
    flat: list[LaunchDescriptionEntity] = []
    for item in entities:
        if isinstance(item, LaunchDescriptionEntity):
            flat.append(item)
        elif isinstance(item, Iterable) and not isinstance(item, (str, bytes)):
            flat += normalize_to_list_of_entities(item, name=name)
        else:
            raise TypeError(
                f"expected all items in '{name}' iterable to be of type 'LaunchDescriptionEntity' "
                f"but got '{type(item)}'"
            )
    return flat

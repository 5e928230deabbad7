"""Repeat actions: for each of several sets of values, or a number of times."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from typing import Any

from tfloom.launch.actions.opaque import OpaqueFunction
from tfloom.launch.core.base_classes import LaunchDescriptionEntity, SomeSubstitutionsType, Substitution
from tfloom.launch.core.entity import Entity, ParsesActions
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.entities.action import Action
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.logs.logging import get_logger
from tfloom.launch.substitutions.variables import ForEachVar
from tfloom.launch.utilities.substitutions import normalize_to_list_of_substitutions, perform_substitutions

__all__ = ["ForEach", "ForLoop"]

Entities = Sequence[LaunchDescriptionEntity]


@expose_action("for_each")
class ForEach(Action):
    """Visits entities once for each of several sets of values, when it is executed.

    In a launch file, the tag `for_each` has the sets in `values`, and holds actions, in which `$(for-var name)` is a
    value.

    Args:
        input_values: The sets: YAML mappings with semicolons between, such as `{name: a, id: 1};{name: b, id: 2}`. It
            may have substitutions. There may be no sets; an empty mapping is one.
        function: Called with the values of each set by keyword; returns the entities to visit, or None.
        kwargs: As for Action.
    """

    SEPARATOR = ";"

    def __init__(
        self,
        input_values: SomeSubstitutionsType,
        *,
        function: Callable[..., Entities | None],
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self._input_values = normalize_to_list_of_substitutions(input_values)
        self._function = function

    @classmethod
    def parse(cls, entity: Entity, parser: ParsesActions) -> tuple[type[ForEach], dict[str, Any]]:
        """Return the class and its arguments, read from the tag `for_each`: `values`, and the actions that it holds."""
        _, kwargs = super().parse(entity, parser)
        kwargs["input_values"] = parser.parse_substitution(entity.get_attr("values"))
        actions = _Actions(entity, parser)

        def once(**values: Any) -> Entities:
            return actions.with_values(values)

        kwargs["function"] = once
        return cls, kwargs

    @property
    def input_values(self) -> list[Substitution]:
        """Sets of values, as given: a text in YAML, or substitutions for it."""
        return self._input_values

    @property
    def function(self) -> Callable[..., Entities | None]:
        """The function that returns the entities for a set of values."""
        return self._function

    def describe(self) -> str:
        """Return the class's name with its arguments."""
        return f"{type(self).__name__}(input_values='{self._input_values}', function={self._function})"

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity]:
        """Return the entities for all sets of values.

        Raises:
            ValueError: a set is not a YAML mapping.
        """
        sets = _read_sets(perform_substitutions(context, self._input_values))
        if not sets:
            get_logger("launch.actions.for_loop").warning("no input values: will not iterate")
        return [entity for values in sets for entity in self._function(**values) or ()]


@expose_action("for")
class ForLoop(Action):
    """Visits entities a number of times, when it is executed.

    In a launch file, the tag `for` has the number in `len` and a `name`, and holds actions, in which `$(index name)` is
    the index.

    Args:
        length: The number of times; it may have substitutions.
        function: Called with the index by the keyword `i`, from 0; returns the entities to visit, or None.
        name: Name of the index, for `ForLoopIndex`.
        kwargs: As for Action.
    """

    def __init__(
        self,
        length: SomeSubstitutionsType,
        *,
        function: Callable[..., Entities | None],
        name: str | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self._length = normalize_to_list_of_substitutions(length)
        self._function = function
        self._name = name

    @classmethod
    def parse(cls, entity: Entity, parser: ParsesActions) -> tuple[type[ForLoop], dict[str, Any]]:
        """Return the class and its arguments, read from the tag `for`: `len`, `name`, and the actions that it holds."""
        _, kwargs = super().parse(entity, parser)
        length = entity.get_attr("len", data_type=int, can_be_str=True)
        kwargs["length"] = parser.parse_substitution(str(length))
        kwargs["name"] = name = entity.get_attr("name")
        actions = _Actions(entity, parser)

        def once(i: int) -> Entities:
            return actions.with_values({name: i})

        kwargs["function"] = once
        return cls, kwargs

    @property
    def length(self) -> list[Substitution]:
        """Number of iterations, as substitutions."""
        return self._length

    @property
    def function(self) -> Callable[..., Entities | None]:
        """The function that returns the entities for an index."""
        return self._function

    @property
    def name(self) -> str | None:
        """The name of the index."""
        return self._name

    def describe(self) -> str:
        """Return the class's name with its arguments."""
        return (
            f"{type(self).__name__}(length='{self._length}', name='{self._name}', function={self._function})"
        )

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity]:
        """Return the entities for all indices.

        Raises:
            ValueError: the number of times is not a whole number.
        """
        text = perform_substitutions(context, self._length)
        try:
            length = int(text)
        except ValueError:
            raise ValueError(f"the length of a ForLoop must be a whole number, not '{text}'") from None
        return [entity for i in range(length) for entity in self._function(i=i) or ()]


def _read_sets(text: str) -> list[dict[str, Any]]:
    from tfloom.common.yaml import load

    sets = []
    for part in filter(None, map(str.strip, text.split(ForEach.SEPARATOR))):
        values = load(part)
        if values is None:
            continue
        if not isinstance(values, dict):
            raise ValueError(
                f"the values of a ForEach must be YAML mappings with semicolons between, as in {{name: a, id: 1}}, "
                f"not '{part}'"
            )
        sets.append({str(name): value for name, value in values.items()})
    return sets


class _Actions:
    """The actions in an element, made anew for each iteration, because one of a process can't be executed twice.

    Args:
        entity: The element; its actions are also made at once, to find their errors.
        parser: The parser of its file.
    """

    def __init__(self, entity: Entity, parser: ParsesActions) -> None:
        self._entity = entity
        self._parser = parser
        self._make_actions()

    def _make_actions(self) -> list[LaunchDescriptionEntity]:
        return [self._parser.parse_action(child) for child in self._entity.children]

    def with_values(self, values: Mapping[str, Any]) -> Entities:
        """Return the actions, to be visited while the values are variables of the context."""
        variables = {ForEachVar.get_local_arg_name(name): str(value) for name, value in values.items()}

        def push(context: LaunchContext) -> None:
            context._push_locals()
            context.extend_locals(variables)

        def pop(context: LaunchContext) -> None:
            context._pop_locals()

        return [OpaqueFunction(function=push), *self._make_actions(), OpaqueFunction(function=pop)]

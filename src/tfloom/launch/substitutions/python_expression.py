"""The value of a Python expression."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

from tfloom.launch.core.base_classes import SomeSubstitutionsType, Substitution, described
from tfloom.launch.core.error_places import add_to_error
from tfloom.launch.core.launch_context import LaunchContext
from tfloom.launch.frontend.expose import expose_substitution
from tfloom.launch.utilities.argument_types import ensure_argument_type
from tfloom.launch.utilities.substitutions import (
    normalize_to_list_of_substitutions,
    perform_some_substitutions,
    perform_substitutions,
)

__all__ = ["PythonExpression"]


@expose_substitution("eval")
class PythonExpression(Substitution):
    """The value of a Python expression as a text.

    Args:
        expression: The expression.
        python_modules: Modules that it uses by their names. The names of `math` can be used without the module's, too.
    """

    def __init__(
        self,
        expression: SomeSubstitutionsType,
        python_modules: SomeSubstitutionsType = ["math"],  # noqa: B006  # never changed
    ) -> None:
        super().__init__()
        ensure_argument_type(expression, (str, Substitution, Iterable), "expression", "PythonExpression")
        ensure_argument_type(
            python_modules, (str, Substitution, Iterable), "python_modules", "PythonExpression"
        )
        self._expression = normalize_to_list_of_substitutions(expression)
        self._python_modules = normalize_to_list_of_substitutions(python_modules)

    @classmethod
    def parse(cls, data: Sequence[SomeSubstitutionsType]) -> tuple[type[PythonExpression], dict[str, Any]]:
        """Return the class and the arguments of `$(eval 'expression' 'module, module')`.

        Raises:
            TypeError: there are not one or two arguments.
        """
        if len(data) not in {1, 2}:
            raise TypeError("eval substitution expects 1 or 2 arguments")
        kwargs: dict[str, Any] = {"expression": data[0]}
        if len(data) == 2:
            names = perform_some_substitutions(LaunchContext(), data[1])
            kwargs["python_modules"] = [name.strip() for name in names.split(",") if name.strip()]
        return cls, kwargs

    @property
    def expression(self) -> list[Substitution]:
        """Python expression, as substitutions."""
        return self._expression

    @property
    def python_modules(self) -> list[Substitution]:
        """Modules that the expression uses."""
        return self._python_modules

    def describe(self) -> str:
        """Return a description for people."""
        modules = ", ".join(name.describe() for name in self._python_modules)
        return f"PythonExpr({described(self._expression)}, [{modules}])"

    def perform(self, context: LaunchContext) -> str:
        """Return the expression's value as a text. Its errors are raised, with the expression in their text."""
        import importlib

        names: dict[str, Any] = {}
        for name in self._python_modules:
            module = importlib.import_module(context.perform_substitution(name))
            if module.__name__ == "math":
                names.update(vars(module))
            names[module.__name__] = module
        expression = perform_substitutions(context, self._expression)
        try:
            # The launch file's author wrote the expression, as all of the launch file.
            return str(eval(expression, {}, names))  # noqa: S307
        except Exception as error:
            add_to_error(error, after=f", in the Python expression {expression!r}")
            raise

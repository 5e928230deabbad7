"""The launches of a test file, and the tests of each."""

from __future__ import annotations

import functools
import inspect
import unittest
import warnings
from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import Any, TypeAlias

from tfloom.launch.entities.launch_description import LaunchDescription
from tfloom.launch.testing.actions import ReadyToTest
from tfloom.launch.testing.markers import is_kept_alive
from tfloom.launch.testing.readiness import timeout_of

__all__ = [
    "DescriptionError",
    "LoadTestsFromPythonModule",
    "PostShutdownTestLoader",
    "PreShutdownTestLoader",
    "TestRun",
    "slim_formatwarning",
]

ENTRY_POINT = "generate_test_description"
READY_FN = "ready_fn"

__unittest = True  # unittest leaves the frames of this file out of its reports

_Case: TypeAlias = type[unittest.TestCase]


class DescriptionError(Exception):
    """A `generate_test_description` that cannot be called, or returns something else than a description."""


def slim_formatwarning(
    message: object, category: object, filename: str, lineno: int, line: object = None
) -> str:
    """Return a warning's text, without the line of source."""
    del category, filename, lineno, line
    return f"Warning: {message}\n"


class TestRun:
    """One launch, and the tests that run during it and after it.

    Args:
        name: Of the file.
        test_description_function: Returns the description.
        param_args: Arguments of `parametrize`.
        pre_shutdown_tests: Cases that run during the launch.
        post_shutdown_tests: Cases that run after it.
    """

    __test__ = False  # for pytest

    def __init__(
        self,
        name: str,
        test_description_function: Callable[..., Any],
        param_args: Mapping[str, Any],
        pre_shutdown_tests: Iterable[_Case] = (),
        post_shutdown_tests: Iterable[_Case] = (),
    ) -> None:
        self.name = name
        self.test_description_function = test_description_function
        self.param_args = dict(param_args)
        self.pre_shutdown_tests = list(pre_shutdown_tests)
        self.post_shutdown_tests = list(post_shutdown_tests)
        self.module_name: str | None = None
        """Name of the module of the cases, as reports have it; None: the one that it has."""
        self.is_kept_alive = is_kept_alive(test_description_function)
        self.ready_timeout_s = timeout_of(test_description_function)

    @property
    def all_tests(self) -> list[unittest.TestCase]:
        """The tests before and after the shutdown, one by one."""
        return [
            case(name)
            for case in (*self.pre_shutdown_tests, *self.post_shutdown_tests)
            for name in unittest.defaultTestLoader.getTestCaseNames(case)
        ]

    @property
    def skip_reason(self) -> str | None:
        """The reason of `unittest.skip`; None if the launch is not skipped."""
        if not getattr(self.test_description_function, "__unittest_skip__", False):
            return None
        return str(getattr(self.test_description_function, "__unittest_skip_why__", ""))

    def validate(self) -> None:
        """Check the arguments of the function that returns the description.

        Raises:
            DescriptionError: it has an argument that nothing sets, or has none for a value of `parametrize`.
        """
        function = self.test_description_function
        parameters = inspect.signature(inspect.unwrap(function)).parameters
        takes_any = any(parameter.kind is parameter.VAR_KEYWORD for parameter in parameters.values())
        for name in self.param_args:
            if name not in parameters and not takes_any:
                raise DescriptionError(
                    f"Could not find an argument '{name}' in {ENTRY_POINT}, which parametrize sets"
                )
        for name, parameter in parameters.items():
            needed = parameter.default is parameter.empty and parameter.kind in {
                parameter.POSITIONAL_OR_KEYWORD,
                parameter.KEYWORD_ONLY,
            }
            if needed and name not in {READY_FN, *self.param_args}:
                raise DescriptionError(
                    f"unexpected extra argument '{name}' in {ENTRY_POINT}: it may have '{READY_FN}', and what "
                    "launch_testing.parametrize sets"
                )

    def normalized_test_description(
        self, ready_fn: Callable[[], object]
    ) -> tuple[LaunchDescription, dict[str, Any]]:
        """Return the description, and the objects that the tests can take as arguments.

        Args:
            ready_fn: What an older description calls in place of the ReadyToTest action.

        Raises:
            DescriptionError: the function has other arguments, returns something else, or has neither a ReadyToTest
                action in its description nor the argument `ready_fn`.
        """
        self.validate()
        takes_ready_fn = READY_FN in inspect.signature(self.test_description_function).parameters
        if takes_ready_fn:
            warnings.warn(
                f"Passing {READY_FN} as an argument to {ENTRY_POINT} will be removed in a future release.  Include a "
                "launch_testing.actions.ReadyToTest action in the LaunchDescription instead.",
                stacklevel=2,
            )
        made = self.test_description_function(**({READY_FN: ready_fn} if takes_ready_fn else {}))
        description, context = made if isinstance(made, tuple) and len(made) == 2 else (made, {})
        if not isinstance(description, LaunchDescription) or not isinstance(context, Mapping):
            raise DescriptionError(
                f"{ENTRY_POINT} must return a LaunchDescription, or one and a dictionary, and returned {made!r}"
            )
        if not takes_ready_fn and not any(iterate_ready_to_test_actions(description.entities, ReadyToTest)):
            raise DescriptionError(
                f"{ENTRY_POINT} functions without a {READY_FN} argument must return a LaunchDescription "
                "containing a ReadyToTest action"
            )
        return description, dict(context)

    def get_launch_description(self) -> LaunchDescription:
        """Return the description, for its arguments."""
        return self.normalized_test_description(lambda: None)[0]

    def bind(
        self, cases: Iterable[_Case], attributes: Mapping[str, Any], arguments: Mapping[str, Any]
    ) -> Any:
        """Return the suite of some cases, whose tests can take objects by name.

        Args:
            cases: Test cases.
            attributes: Objects that each test also has as attributes.
            arguments: Objects that tests, `setUp`, `setUpClass` and their opposites can take as arguments.
        """
        loader = unittest.TestLoader()
        everything = {**arguments, **self.param_args}
        suites = (
            loader.loadTestsFromTestCase(_bound_case(case, attributes, everything, self.module_name))
            for case in cases
        )
        return unittest.TestSuite(suites)

    def __str__(self) -> str:
        if not self.param_args:
            return self.name
        return f"{self.name}[{', '.join(f'{name}={value}' for name, value in self.param_args.items())}]"


def LoadTestsFromPythonModule(module: Any, *, name: str = "launch_tests") -> list[TestRun]:
    """Return the launches of a test file: one, or one for each set of arguments of `parametrize`.

    Args:
        module: The imported file.
        name: Of the launches.

    Raises:
        DescriptionError: it has no `generate_test_description`.
    """
    function = getattr(module, ENTRY_POINT, None)
    if function is None:
        older = getattr(module, "generate_launch_description", None)
        if older is None:
            raise DescriptionError(
                f"there is no function {ENTRY_POINT} in {getattr(module, '__file__', module)}"
            )
        warnings.warn(f"write {ENTRY_POINT} in place of generate_launch_description", stacklevel=2)
        function = older
    runs = function if getattr(function, "__parametrized__", False) else [(function, {})]
    before, after = PreShutdownTestLoader().cases_of(module), PostShutdownTestLoader().cases_of(module)
    return [TestRun(name, generate, arguments, before, after) for generate, arguments in runs]


class PreShutdownTestLoader(unittest.TestLoader):
    """Loads the tests of a module that run during the launch."""

    is_post_shutdown = False

    def cases_of(self, module: Any) -> list[_Case]:
        """Return the cases of a module."""
        return [
            member
            for member in vars(module).values()
            if isinstance(member, type)
            and issubclass(member, unittest.TestCase)
            and member not in {unittest.TestCase, unittest.FunctionTestCase}
            and bool(getattr(member, "__post_shutdown_test__", False)) is self.is_post_shutdown
        ]

    def loadTestsFromModule(self, module: Any, *args: Any, **kwargs: Any) -> unittest.TestSuite:
        """Return the suite of these tests."""
        del args, kwargs
        return unittest.TestSuite(self.loadTestsFromTestCase(case) for case in self.cases_of(module))


class PostShutdownTestLoader(PreShutdownTestLoader):
    """Loads the tests of a module that run after the launch."""

    is_post_shutdown = True


def iterate_ready_to_test_actions(entities: Iterable[Any], kind: type[Any]) -> Iterator[Any]:
    """Yield the actions of a kind among entities, and among what these hold, in event handlers too."""
    for entity in entities:
        if isinstance(entity, kind):
            yield entity
            continue
        yield from iterate_ready_to_test_actions(entity.describe_sub_entities(), kind)
        for _, conditional in entity.describe_conditional_sub_entities():
            yield from iterate_ready_to_test_actions(conditional, kind)


def _bound_case(
    case: _Case, attributes: Mapping[str, Any], arguments: Mapping[str, Any], module_name: str | None
) -> _Case:
    """Return a case with the same tests, whose methods get the arguments that they have by name."""
    methods: dict[str, Any] = {}
    for name in (*unittest.TestLoader().getTestCaseNames(case), "setUp", "tearDown"):
        method = getattr(case, name)
        methods[name] = _with_arguments(method, arguments)
    for name in ("setUpClass", "tearDownClass"):
        methods[name] = classmethod(_with_arguments(getattr(case, name).__func__, arguments))
    named = {
        "__module__": module_name or case.__module__,
        "__qualname__": case.__qualname__,
        "__doc__": case.__doc__,
    }
    return type(case.__name__, (case,), {**attributes, **methods, **named})


def _with_arguments(method: Callable[..., Any], arguments: Mapping[str, Any]) -> Callable[..., Any]:
    names = list(inspect.signature(method).parameters)[1:]
    values = {name: arguments[name] for name in names if name in arguments}
    if not values:
        return method

    @functools.wraps(method)
    def call(self: Any) -> Any:
        return method(self, **values)

    @functools.wraps(method)
    async def await_call(self: Any) -> Any:
        return await method(self, **values)

    return await_call if inspect.iscoroutinefunction(method) else call

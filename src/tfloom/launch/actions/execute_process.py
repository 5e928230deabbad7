"""The action that runs a command line."""

from __future__ import annotations

import shlex
from collections.abc import Iterable, Mapping
from typing import Any

from tfloom.launch.actions.executable import Executable
from tfloom.launch.actions.execute_local import ExecuteLocal
from tfloom.launch.core.base_classes import SomeSubstitutionsType, Substitution, TextSubstitution
from tfloom.launch.core.entity import Entity, ParsesActions, parse_pairs
from tfloom.launch.entities.action import Action
from tfloom.launch.frontend.expose import expose_action
from tfloom.launch.utilities.argument_errors import unknown_argument_error, words_error

__all__ = ["ExecuteProcess"]


ATTRIBUTES: dict[str, tuple[str, type]] = {
    "cwd": ("cwd", str),
    "name": ("name", str),
    "launch-prefix": ("prefix", str),
    "output": ("output", str),
    "sigterm_timeout": ("sigterm_timeout", float),
    "sigkill_timeout": ("sigkill_timeout", float),
    "shell": ("shell", bool),
    "emulate_tty": ("emulate_tty", bool),
    "respawn": ("respawn", bool),
    "respawn_delay": ("respawn_delay", float),
    "respawn_max_retries": ("respawn_max_retries", int),
}
"""Attributes of the tag, each with the constructor's argument and its type."""


@expose_action("executable")
class ExecuteProcess(ExecuteLocal):
    """Runs a command line, and ends its process with the launch.

    Args:
        cmd: The words of the command line, the program first.
        prefix: Words in front of it, as a shell would split them.
        name: The process's name, without its number; None: the program's file name.
        cwd: The folder to start in; None: the launch's.
        env: All of its environment variables; None: those of the launch.
        additional_env: Variables in addition to those.
        kwargs: As for ExecuteLocal.
    """

    def __init__(
        self,
        *,
        cmd: Iterable[SomeSubstitutionsType],
        prefix: SomeSubstitutionsType | None = None,
        name: SomeSubstitutionsType | None = None,
        cwd: SomeSubstitutionsType | None = None,
        env: Mapping[SomeSubstitutionsType, SomeSubstitutionsType] | None = None,
        additional_env: Mapping[SomeSubstitutionsType, SomeSubstitutionsType] | None = None,
        **kwargs: Any,
    ) -> None:
        error = words_error("cmd", cmd) or unknown_argument_error(ExecuteProcess, kwargs)
        if error is not None:
            raise error
        executable = Executable(
            cmd=cmd, prefix=prefix, name=name, cwd=cwd, env=env, additional_env=additional_env
        )
        super().__init__(process_description=executable, **kwargs)

    @property
    def name(self) -> str | list[Substitution] | None:
        """Name of the process, with its number once it has one."""
        if self.process_description.final_name is not None:
            return self.process_description.final_name
        return self.process_description.name

    @property
    def cmd(self) -> Any:
        """Words of the command line, performed once the process has been prepared."""
        if self.process_description.final_cmd is not None:
            return self.process_description.final_cmd
        return self.process_description.cmd

    @property
    def cwd(self) -> Any:
        """Folder to start in."""
        if self.process_description.final_cwd is not None:
            return self.process_description.final_cwd
        return self.process_description.cwd

    @property
    def env(self) -> Any:
        """All environment variables."""
        if self.process_description.final_env is not None:
            return self.process_description.final_env
        return self.process_description.env

    @property
    def additional_env(self) -> Any:
        """Environment variables in addition to those."""
        return self.process_description.additional_env

    # Launch files in XML and YAML

    @classmethod
    def parse(
        cls, entity: Entity, parser: ParsesActions, ignore: list[str] | None = None
    ) -> tuple[type[Action], dict[str, Any]]:
        """Return the class and the arguments of its constructor; attributes in `ignore` are a derived class's."""
        _, kwargs = super().parse(entity, parser)
        ignored = set(ignore or ())
        if "cmd" not in ignored:
            kwargs["cmd"] = cls._parse_cmdline(entity.get_attr("cmd"), parser)
        for attribute, (name, data_type) in ATTRIBUTES.items():
            value = (
                None
                if attribute in ignored
                else entity.get_attr(attribute, data_type=data_type, optional=True)
            )
            if value is not None:
                is_delay = name in {"respawn_delay", "respawn_max_retries"}
                kwargs[name] = value if is_delay else parser.parse_if_substitutions(_as_text(value))
        if "on_exit" not in ignored and entity.get_attr("on_exit", optional=True) == "shutdown":
            from tfloom.launch.actions.event_actions import Shutdown

            kwargs["on_exit"] = Shutdown()
        if "env" not in ignored and (
            variables := entity.get_attr("env", data_type=list[Entity], optional=True)
        ):
            kwargs["additional_env"] = dict(parse_pairs(variables, parser))
        return cls, kwargs

    @classmethod
    def _parse_cmdline(cls, cmd: str, parser: ParsesActions) -> list[list[Substitution]]:
        """Return the words of a command line: a shell splits its texts, and no substitution."""
        words: list[list[Substitution]] = []
        word: list[Substitution] | None = None
        for part in parser.parse_substitution(cmd):
            if not isinstance(part, TextSubstitution):
                word = [*(word or []), part]
                continue
            text = part.text
            if text[:1].isspace() and word is not None:
                words.append(word)
                word = None
            pieces = shlex.split(text)
            for number, piece in enumerate(pieces):
                if number > 0 and word is not None:
                    words.append(word)
                    word = None
                word = [*(word or []), TextSubstitution(text=piece)]
            if text[-1:].isspace() and word is not None:
                words.append(word)
                word = None
        return words if word is None else [*words, word]


def _as_text(value: Any) -> Any:
    return str(value) if isinstance(value, float) else value

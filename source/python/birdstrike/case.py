"""Cases: a parameter file and what is set beside it."""

import dataclasses
import math
import numbers
import os
import pathlib
import re
from typing import Any

from .program import call, find_folder, find_warnings
from .run import Run


@dataclasses.dataclass(frozen=True)
class Case:
    """A parameter file, with entries that overrule its own.

        case = Case("prm/frontal.prm").set("Bird/Particle spacing", "4 mm").set("Bird/Velocity", [0, 0, 200])
        run = case.run("runs/coarse")

    A case does not change: `set` makes another one. `program` is that of find_program.

    Raises Failed, with the program's own message, where the program refuses or loses the case.
    """

    file: str | os.PathLike[str]
    program: str | os.PathLike[str] | None = None
    entries: tuple[tuple[str, str], ...] = ()

    def set(self, entry: str, value: Any) -> "Case":
        """The same case with `entry`, "Section/Entry", set to `value`:

        a number         in the entry's own unit: SI, angles in degrees
        a text           as a parameter file has it: "2.5 mm", "65 knots", "shell"; "default" takes an entry back
        a bool           true, false
        a list or array  of these: a vector

        Raises ValueError for a name that is none, for a number that is not finite and for a text with a line break,
        TypeError for any other value. Which entries there are, the program knows: Failed is raised when it is called.
        """
        require_entry(entry)
        kept = tuple(each for each in self.entries if each[0] != entry)
        return dataclasses.replace(self, entries=(*kept, (entry, text_of(value))))

    def validate(self) -> list[str]:
        """Reads and checks the case, and computes nothing. Returns the warnings."""
        return find_warnings(call(self.program, self.arguments("validate")))

    def explain(self) -> str:
        """What would be computed, what it costs, and the warnings, as text."""
        return call(self.program, self.arguments("explain"))

    def run(self, folder: str | os.PathLike[str] | None = None, *, threads: int | None = None, force: bool = False,
            timeout: float | None = None) -> Run:
        """Runs the case to its end.

        folder   of the run, instead of the case's own (runs/NAME)
        threads  instead of the case's own number
        force    replaces a finished run in the folder; without it that is refused
        timeout  s, after which the run is stopped: Failed with code 130; `birdstrike resume` continues it
        """
        case = self if threads is None else self.set("Time/Threads", threads)
        arguments = case.arguments("run")
        if folder is not None:
            arguments.append(f"--output={os.fspath(folder)}")
        if force:
            arguments.append("--force")
        asked = None if folder is None else pathlib.Path(folder)
        output = call(self.program, arguments, timeout, asked)
        made = asked or find_folder(output)
        if made is None:
            raise RuntimeError("The program has not said in which folder the run is: it is of another version.")
        return Run(made)

    def arguments(self, command: str) -> list[str]:
        """The words behind the program's name for this case."""
        file = os.fspath(self.file)
        return [command, f"./{file}" if file.startswith("-") else file,
                *(f"--set={entry}={value}" for entry, value in self.entries)]


def require_entry(entry: str) -> None:
    """Raises ValueError unless `entry` can be the name of one."""
    if not re.fullmatch(r"\w[^=\r\n\0]*/[^=\r\n\0]+", entry):
        raise ValueError(f"{entry!r} is no name of an entry: 'Section/Entry', without '=' and line breaks.")


def text_of(value: Any) -> str:
    """`value` as a parameter file has it; raises as Case.set does."""
    value = value.tolist() if hasattr(value, "tolist") else value  # NumPy's numbers and arrays
    if isinstance(value, list | tuple):
        return ", ".join(_text_of_one(each) for each in value)
    return _text_of_one(value)


def _text_of_one(value: Any) -> str:
    value = value.tolist() if hasattr(value, "tolist") else value
    if isinstance(value, bool):
        return "true" if value else "false"
    if isinstance(value, numbers.Integral):
        return str(int(value))
    if isinstance(value, numbers.Real):
        if not math.isfinite(value):
            raise ValueError(f"{value} is no number that an entry can have.")
        return repr(float(value))
    if isinstance(value, str | os.PathLike):
        text = os.fspath(value)
        if re.search(r"[\r\n\0]", text):
            raise ValueError(f"{text!r} holds a line break or a zero byte.")
        return text
    raise TypeError(f"A value of an entry is a number, a text, a bool or a list of these, not {type(value).__name__}.")

"""The program birdstrike, started without a shell."""

from __future__ import annotations

import os
import pathlib
import re
import shutil
import signal
import subprocess
import tempfile
from collections.abc import Sequence
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from .studies import Study

_GRACE = 300.  # s, for what is stopped to write its checkpoint


class Failed(RuntimeError):
    """The program has ended with another exit code than 0. Its text is the program's own message.

    code     2 wrong input, 3 the computation was lost, 130 interrupted, 1 an error of the system (full disk) or of the
             program, 128 + n ended by signal n
    message  what the program says of it
    output   all that it has said
    study    of a study that has written its table: the table, which tells of each point what became of it
    """

    study: Study | None = None

    def __init__(self, message: str, code: int, output: str = "") -> None:
        super().__init__(message, code, output)
        self.message = message
        self.code = code
        self.output = output

    def __str__(self) -> str:
        return self.message


def find_program(program: str | os.PathLike[str] | None = None) -> pathlib.Path:
    """The program's file: `program` (a path, or a name in PATH), else that of the environment variable BIRDSTRIKE, else
    birdstrike in PATH, else build/bin/birdstrike of the source tree in which this package lies.

    Raises FileNotFoundError, which says what to do, where there is none; what is named but not there is not replaced.
    """
    for asked, what in ((program, "The argument 'program'"),
                        (os.environ.get("BIRDSTRIKE") or None, "The environment variable BIRDSTRIKE")):
        if asked is not None:
            if not (found := shutil.which(asked)):
                raise FileNotFoundError(f"{what} is '{os.fspath(asked)}', and there is no such program.")
            return pathlib.Path(found).absolute()
    if found := shutil.which("birdstrike"):
        return pathlib.Path(found).absolute()
    top = pathlib.Path(__file__).resolve().parents[3]
    built = top / "build" / "bin" / "birdstrike"
    if (top / "prm" / "run.sh").is_file() and shutil.which(built):
        return built
    raise FileNotFoundError("The program birdstrike is not found: not in PATH, nor in the build folder of a source tree "
                            "around this package.\n  Action: build it (bash prm/run.sh prm/quickstart.prm), or set the "
                            "environment variable BIRDSTRIKE to its path.")


def call(program: str | os.PathLike[str] | None, arguments: Sequence[str], timeout: float | None = None,
         folder: pathlib.Path | None = None) -> str:
    """Runs the program to its end; returns what it has said. `folder` is that of a run, whose log tells messages apart.

    After `timeout` (s), and at Ctrl-C, the program is asked to stop and has the time to write its checkpoint. A second
    Ctrl-C kills it.

    Raises Failed where the exit code is not 0, KeyboardInterrupt at Ctrl-C, FileNotFoundError as find_program does.
    """
    with tempfile.TemporaryFile() as said:
        child = subprocess.Popen([find_program(program), *arguments], stdin=subprocess.DEVNULL, stdout=said,
                                 stderr=subprocess.STDOUT)
        stopped = ""
        try:
            code = child.wait(timeout)
        except subprocess.TimeoutExpired:
            stopped = f"Stopped after the timeout of {timeout} s.\n"
            code = _stop(child, signal.SIGTERM)
        except BaseException as error:
            _stop(child, signal.SIGINT if isinstance(error, KeyboardInterrupt) else signal.SIGTERM)
            raise
        said.seek(0)
        output = said.read().decode(errors="replace")
    if code == 0:
        return output
    message = stopped + _find_message(output, folder)
    if code < 0:
        code = 128 - code
        message += f"\nThe program was ended by signal {code - 128}."
    raise Failed(message.strip(), code, output)


def find_folder(output: str) -> pathlib.Path | None:
    """The folder that a run names at its end, None where it does not."""
    found = re.search(r"^Results in (.+?)(?:\. Next: .*)?$", output, re.MULTILINE)
    return pathlib.Path(found[1]) if found else None


def find_warnings(output: str) -> list[str]:
    """What the program warns of, in its order."""
    return re.findall(r"^Warning: (.*)$", output, re.MULTILINE)


def _stop(child: subprocess.Popen[bytes], number: int) -> int:
    try:
        child.send_signal(number)
        return child.wait(_GRACE)
    except BaseException as error:
        child.kill()
        code = child.wait()
        if isinstance(error, subprocess.TimeoutExpired):
            return code
        raise


def _find_message(output: str, folder: pathlib.Path | None) -> str:
    """What was said last: of a run the last record of its log, of a study what stands behind its table; else the last lines
    but warnings, of which a message has at most six."""
    folder = folder or find_folder(output)
    if folder is not None and (folder / "log.txt").is_file():
        log = (folder / "log.txt").read_text(encoding="utf-8", errors="replace")
        record = re.split(r"^\d{4}-\d\d-\d\d [\d:.]+ \w+: ", log, flags=re.MULTILINE)[-1].strip()
        if record and record in output:  # else the log is that of an earlier run
            return record
    said = re.split(r"^Study in .*\n", output, flags=re.MULTILINE)[-1]
    lines = [line for line in said.strip().splitlines() if not line.startswith("Warning: ")]
    return "\n".join(lines[-6:])

"""Studies: a case at many points, side by side, and the table of what came out."""

import csv
import math
import os
import pathlib
import re
from collections.abc import Mapping, Sequence
from typing import Any, Protocol, overload

import numpy as np

from .case import Case, require_entry, text_of
from .mesh import Array
from .program import Failed, call
from .run import Run

_LONGEST = 120_000  # letters: what a word of a command line may have on Linux, with some room


class Sampler(Protocol):
    """What draws points of the unit cube, as the samplers of scipy.stats.qmc do."""

    def random(self, n: int) -> Any:
        """[n][d], in [0, 1)."""


class Study:
    """The table of the study in `folder`, a row a point, in the order of its points.

        made["Bird/Speed"]             # [n], in made.columns["Bird/Speed"]: what was varied
        made["Tip: peak (mid-chord)"]  # [n], m; NaN of a point that was refused or lost
        made.states[0], made.runs[0]   # "done", its Run

    Raises FileNotFoundError where the folder holds no table, and KeyError, with the names that there are, for a column
    that the table does not have.
    """

    folder: pathlib.Path

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        self.folder = pathlib.Path(folder)
        if not (self.folder / "study.csv").is_file():
            raise FileNotFoundError(f"'{folder}' holds no study.csv: it is no folder of a study.")
        with open(self.folder / "study.csv", encoding="utf-8", newline="") as file:
            headings, *rows = csv.reader(file)
        self._units: dict[str, str] = {}
        self._values: dict[str, Array] = {}
        for heading, cells in zip(headings, zip(*rows), strict=True):
            name, unit = re.fullmatch(r"(.*?)(?: \[([^\]]*)\])?", heading).groups()  # type: ignore[union-attr]
            self._units[name] = unit or ""
            self._values[name] = _read_column(cells, is_text=name in ("still rising", "warnings", "state", "folder"))

    def __len__(self) -> int:
        return len(self._values["point"])

    def __repr__(self) -> str:
        return f"Study('{self.folder}', {len(self)} points, {self.states.count('done')} done)"

    @property
    def columns(self) -> dict[str, str]:
        """{name: unit} of the columns: the varied entries, "Group: quantity", still rising, warnings, state, folder."""
        return dict(self._units)

    def __getitem__(self, name: str) -> Array:
        """A column, [n]: of floats, NaN where there is no value, or of texts."""
        if name not in self._values:
            raise KeyError(f"'{name}' is no column of {self.folder / 'study.csv'}. There are: {', '.join(self._values)}")
        return self._values[name]

    @property
    def states(self) -> list[str]:
        """What became of each point: "done", or "lost: ...", "refused: ..." with the reason, "stopped at ..."."""
        return [str(state) for state in self["state"]]

    @property
    def runs(self) -> Sequence[Run | None]:
        """The run of each point, None where it is not done. A run is read when it is asked for: thousands fill a memory."""
        return _Runs([self.folder / pathlib.PurePath(str(folder)).name if state == "done" else None
                      for state, folder in zip(self.states, self["folder"], strict=True)])


class _Runs(Sequence[Run | None]):
    def __init__(self, folders: list[pathlib.Path | None]) -> None:
        self._folders = folders

    def __len__(self) -> int:
        return len(self._folders)

    @overload
    def __getitem__(self, k: int) -> Run | None: ...
    @overload
    def __getitem__(self, k: slice) -> "_Runs": ...
    def __getitem__(self, k: int | slice) -> "Run | None | _Runs":
        if isinstance(k, slice):
            return _Runs(self._folders[k])
        folder = self._folders[k]
        return None if folder is None else Run(folder)


def study(case: Case, vary: Mapping[str, Sequence[Any] | str] | None = None, *, sampler: Sampler | None = None,
          n: int | None = None, pairs: bool = False, folder: str | os.PathLike[str] | None = None,
          jobs: int | None = None, force: bool = False, timeout: float | None = None) -> Study:
    """Runs the case at each point, side by side, with a thread a point; points that the folder has are taken.

    vary     {"Section/Entry": values}. Values are a list of what Case.set takes, or a text in the program's own words:
             "100:300:5", "4, 3, 2 mm". Each value runs with each. With a sampler: (lowest, highest), two numbers. None:
             what section Study of the file says
    sampler  has random(n), which draws n points of the unit cube, [n][number of entries], e.g.
             scipy.stats.qmc.LatinHypercube(2); points are drawn in the order of `vary`
    pairs    values go together one by one
    folder   of the study, instead of runs/study/NAME
    jobs     points side by side, instead of one a core
    force    replaces runs of other entries and tables of other points in the folder; without it that is refused
    timeout  s, as of Case.run; the same study again continues

    Raises Failed where a point was refused or lost: its `study` is the table with the others. Raises ValueError for
    values that make no study.
    """
    words = _grid(vary or {}) if sampler is None else _samples(vary or {}, sampler, n)
    for word in words:
        if len(word.encode()) > _LONGEST:
            raise ValueError(f"{word[:40]!r}... is longer than a command line can be: make several studies of it.")
    into = pathlib.Path(folder) if folder is not None else pathlib.Path("runs/study") / pathlib.Path(case.file).stem
    arguments = [*case.arguments("study"), *(f"--vary={word}" for word in words), f"--output={into}"]
    arguments += ["--pairs"] if pairs or sampler is not None else []
    arguments += ["--force"] if force else []
    arguments += [] if jobs is None else [f"--jobs={jobs}"]
    before = _stamp(into)
    try:
        call(case.program, arguments, timeout)
    except Failed as failed:
        if _stamp(into) != before:
            failed.study = Study(into)
        raise
    return Study(into)


def _stamp(folder: pathlib.Path) -> tuple[int, int] | None:
    """Of the table: another one after it has been written."""
    try:
        known = (folder / "study.csv").stat()
    except FileNotFoundError:
        return None
    return known.st_ino, known.st_mtime_ns


def _grid(vary: Mapping[str, Sequence[Any] | str]) -> list[str]:
    words = []
    for entry, values in vary.items():
        require_entry(entry)
        if isinstance(values, tuple):
            raise ValueError(f"{entry}: {values} is a range, from which a sampler draws. Without one, give a list.")
        words.append(f"{entry}={text_of(values) if isinstance(values, str) else _list(entry, list(values))}")
    return words


def _list(entry: str, values: list[Any]) -> str:
    """Values between '|', for they may hold commas."""
    texts = [text_of(value) for value in values]
    if not texts or any(not text or "|" in text for text in texts):
        raise ValueError(f"{entry}: a list of values is not empty, and no value is empty or holds '|'.")
    if len(texts) == 1 and isinstance(values[0], str) and re.search("[,:]", texts[0]):
        raise ValueError(f"{entry}: '{texts[0]}' alone would be read as several values. Set it with Case.set.")
    return " | ".join(texts)


def _samples(vary: Mapping[str, Sequence[Any] | str], sampler: Sampler, n: int | None) -> list[str]:
    if n is None or n < 1:
        raise ValueError("A sampler needs n, the number of points.")
    low, high = np.array([_bounds(entry, ends) for entry, ends in vary.items()]).reshape(-1, 2).T
    shares = np.asarray(sampler.random(n), dtype=float)
    if shares.shape != (n, len(vary)) or not np.all((shares >= 0.) & (shares <= 1.)):
        raise ValueError(f"The sampler must draw [{n}][{len(vary)}] numbers from 0 to 1; it has drawn {shares.shape}.")
    drawn = dict(zip(vary, (low + (high - low) * shares).T, strict=True))
    return [f"{entry}={' | '.join(f'{value:.9g}' for value in values)}" for entry, values in drawn.items()]


def _bounds(entry: str, ends: Sequence[Any] | str) -> tuple[float, float]:
    require_entry(entry)
    try:
        low, high = (float(end) for end in ends if not isinstance(end, str))
    except (TypeError, ValueError):
        low = high = math.nan
    if not (math.isfinite(low) and math.isfinite(high)):
        raise ValueError(f"{entry}: a sampler draws between two numbers, (lowest, highest), not from {ends!r}.")
    return low, high


def _read_column(cells: Sequence[str], is_text: bool) -> Array:
    if not is_text:
        try:
            return np.array([float(cell or "nan") for cell in cells])
        except ValueError:
            pass
    return np.array(cells, dtype=str)

"""Folders of runs: curves, profiles, histories of places, field files."""

import functools
import json
import os
import pathlib
import re
import types
import xml.etree.ElementTree
from collections.abc import Iterable
from typing import Any, NamedTuple

import h5py  # type: ignore[import]
import numpy as np

from .mesh import Array, Mesh


class Curve(NamedTuple):
    """A quantity in time.

    time    [n], s
    values  [n] or [n][components], in `unit`; NaN where there is none
    """

    time: Array
    values: Array
    unit: str


class Profile(NamedTuple):
    """A quantity along lines.

    axes    {name: coordinates} of each dimension of `values`
    values  of a stress [time][face][chord] in a history, [face][chord] or [span] at one instant, in `unit`
    """

    axes: dict[str, Array]
    values: Array
    unit: str


class Run:
    """The run in `folder`: summary and history as they are now, other files when they are asked for.

        run["contact_force_z"].unit           # any column of history.csv, "N"; run.columns lists them
        run.bird(0.4e-3).nodes["velocity"]    # particles are nodes
        run.nodes["tip"].u                    # Output/Histories: a Curve, [n][3]; elements, gauges, ... alike
        vars(run.sections["span0.5"])         # what a place has, by name

    An unfinished run can be read as well: its summary is None, and its curves end where history.csv does.

    Raises FileNotFoundError where the folder is none of a run, and KeyError, with the names that there are, for what the
    run does not have.

    folder    of the run
    summary   what summary.json holds, in SI; None of a run that has not come to its end
    """

    folder: pathlib.Path
    summary: dict[str, Any] | None

    def __init__(self, folder: str | os.PathLike[str]) -> None:
        self.folder = pathlib.Path(folder)
        if not (self.folder / "history.csv").is_file():
            raise FileNotFoundError(f"'{folder}' holds no history.csv: it is no folder of a run.")
        summary = self.folder / "summary.json"
        self.summary = json.loads(summary.read_text(encoding="utf-8")) if summary.is_file() else None
        self._units, self._history = _read_history(self.folder / "history.csv")

    def __repr__(self) -> str:
        return f"Run('{self.folder}')"

    @property
    def columns(self) -> dict[str, str]:
        """{name: unit} of the curves."""
        return dict(self._units)

    def __getitem__(self, name: str) -> Curve:
        """A curve of history.csv, [n]."""
        _require(name, self._history, f"column of {self.folder / 'history.csv'}")
        return Curve(self._history["time"], self._history[name], self._units[name])

    @property
    def tip(self) -> Curve:
        """Deflection of the tip at mid-chord, [n], m."""
        return self["tip_mid_chord"]

    @property
    def contact_force(self) -> Curve:
        """[n][3], N, of the bird on the blade."""
        return self._vector("contact_force")

    @property
    def contact_impulse(self) -> Curve:
        """[n][3], N s, of the bird on the blade."""
        return self._vector("contact_impulse")

    @property
    def energies(self) -> dict[str, Curve]:
        """{name: curve} of everything in J."""
        return {name: self[name] for name, unit in self._units.items() if unit == "J"}

    @functools.cached_property
    def nodes(self) -> dict[str, types.SimpleNamespace]:
        """The places of nodes.csv by name; each has its quantities as curves."""
        return self._places("nodes")

    @functools.cached_property
    def elements(self) -> dict[str, types.SimpleNamespace]:
        """The places of elements.csv, as `nodes`; tensors are [n][6]."""
        return self._places("elements")

    @functools.cached_property
    def gauges(self) -> dict[str, types.SimpleNamespace]:
        """The strain gauges of gauges.csv, as `nodes`."""
        return self._places("gauges")

    @functools.cached_property
    def sections(self) -> dict[str, types.SimpleNamespace]:
        """The stations of sections.csv, as `nodes`: forces and moments that the blade carries there."""
        return self._places("sections")

    @functools.cached_property
    def patches(self) -> dict[str, types.SimpleNamespace]:
        """The boxes of patches.csv, as `nodes`: force and impulse of the contact within each."""
        return self._places("patches")

    @functools.cached_property
    def blades(self) -> dict[str, types.SimpleNamespace]:
        """The blades of a row, of blades.csv, as `nodes`."""
        return self._places("blades")

    @property
    def profiles(self) -> list[str]:
        """Names of what results.h5 holds along lines: its groups with "values"; those of curves have none."""
        with h5py.File(self.folder / "results.h5") as file:
            return sorted(name for name in file if "values" in file[name])

    def profile(self, name: str) -> Profile:
        """E.g. root_normal_stress_at_peak."""
        _require(name, self.profiles, f"profile of {self.folder / 'results.h5'}")
        with h5py.File(self.folder / "results.h5") as file:
            group = file[name]
            values = group["values"]
            axes = {key: group[key][()] for key in group if key != "values"}
            if values.ndim > len(axes):
                axes["time"] = file["history/time"][()]
            unit = values.attrs["unit"]
            return Profile(axes, values[()], unit.decode() if isinstance(unit, bytes) else str(unit))

    def times(self, part: str) -> Array:
        """Times, [n], s, of the field files of "blade" or "bird"."""
        return np.array([time for time, _ in self._series(part)])

    def blade(self, time: float) -> Mesh:
        """The blade's field file nearest to `time` (s)."""
        return self._nearest("blade", time)

    def bird(self, time: float) -> Mesh:
        """The particles' field file nearest to `time` (s)."""
        return self._nearest("bird", time)

    def _vector(self, name: str) -> Curve:
        parts = [self[f"{name}_{axis}"] for axis in "xyz"]
        return Curve(parts[0].time, np.stack([part.values for part in parts], axis=1), parts[0].unit)

    def _places(self, table: str) -> dict[str, types.SimpleNamespace]:
        path = self.folder / f"{table}.csv"
        if not path.is_file():
            entry = "Blade/Row" if table == "blades" else "Output/Histories"
            raise KeyError(f"'{self.folder}' has no {path.name}: see {entry}.")
        return _read_places(path)

    def _nearest(self, part: str, time: float) -> Mesh:
        return Mesh(min(self._series(part), key=lambda entry: abs(entry[0] - time))[1])

    def _series(self, part: str) -> list[tuple[float, pathlib.Path]]:
        path = self.folder / f"{part}.pvd"
        if not path.is_file():
            raise KeyError(f"'{self.folder}' has no {part}.pvd: the scene has no {part}, or Output/{part.capitalize()} "
                           "fields is false.")
        sets = xml.etree.ElementTree.parse(path).getroot().iter("DataSet")
        return [(float(entry.attrib["timestep"]), self.folder / entry.attrib["file"]) for entry in sets]


def _require(name: str, names: Iterable[str], what: str) -> None:
    if name not in names:
        raise KeyError(f"'{name}' is no {what}. There are: {', '.join(sorted(names))}")


def _read_history(path: pathlib.Path) -> tuple[dict[str, str], dict[str, Array]]:
    """Units and columns by name. The file begins with '# 1: time [s]', a line a column, and a row of names."""
    lines = path.read_text(encoding="utf-8").splitlines()
    units = dict(re.findall(r"^# *\d+: (\S+) \[([^\]]*)\]", "\n".join(lines), re.MULTILINE))
    names, *rows = (line.split(",") for line in lines if not line.startswith("#"))
    rows = [row for row in rows if len(row) == len(names)]  # the last may be half written
    values = np.array(rows, dtype=float).reshape(-1, len(names))
    return {name: units.get(name, "") for name in names}, {name: values[:, k] for k, name in enumerate(names)}


def _read_places(path: pathlib.Path) -> dict[str, types.SimpleNamespace]:
    """Columns are "<place>.<quantity>", of vectors and tensors "<place>.<quantity>_<component>": a namespace of curves a
    place, components side by side as they stand in the file."""
    units, history = _read_history(path)
    time = history.pop("time")
    places: dict[str, dict[str, list[tuple[Array, str]]]] = {}
    for name, values in history.items():
        place, quantity = name.rsplit(".", 1)
        if re.match(r"(u|v|a|F|impulse|stress|strain)_(?!peak)", quantity):
            quantity = quantity.split("_")[0]
        places.setdefault(place, {}).setdefault(quantity, []).append((values, units[name]))
    return {place: types.SimpleNamespace(**{
        quantity: Curve(time, np.stack([values for values, _ in parts], axis=1) if len(parts) > 1 else parts[0][0],
                        parts[0][1])
        for quantity, parts in quantities.items()}) for place, quantities in places.items()}

"""Run folders in Python, with numpy and h5py alone.

    import sys; sys.path.append("prm")
    from birdstrike import Run

    run = Run("runs/frontal")
    run.summary["tip"]["peak"]            # m; what summary.json holds
    run.tip.time, run.tip.values          # s, m: deflection of the tip at mid-chord
    run["contact_force_z"].unit           # any column of history.csv, "N"; run.columns lists them
    run.blade(3e-3).cells["thickness"]    # the field file nearest to 3 ms: a Mesh
    run.bird(0.4e-3).nodes["velocity"]    # particles are nodes
    run.profile("root_normal_stress_at_peak").values
    run.nodes["tip"].u                    # Output/Histories: a Curve, [n][3]; elements, gauges, sections, patches alike
    run.gauges["root"].strain.values      # what a place has, by name: vars(run.sections["span0.5"])

An unfinished run can be read as well: its summary is None, and curves end where history.csv does. What a run does not
have raises KeyError with the names that it has. Units are those of the files: SI.
"""

import base64
import json
import pathlib
import re
import struct
import types
import xml.etree.ElementTree
import zlib
from typing import NamedTuple

import h5py
import numpy as np

__all__ = ["Run", "Curve", "Profile", "Mesh"]

_TYPES = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4", "Int64": "<i8", "UInt8": "u1", "UInt32": "<u4"}


class Curve(NamedTuple):
    """A quantity in time: `time` (s) and `values`, [n]."""

    time: np.ndarray
    values: np.ndarray
    unit: str


class Profile(NamedTuple):
    """A quantity along lines, `values`: of a stress [time][face][chord] in a history, [face][chord] or [span] at one
    instant. `axes` holds the coordinates of each dimension by name."""

    axes: dict
    values: np.ndarray
    unit: str


class Mesh:
    """What one field file holds.

    time       s
    points     [n][3], m: a blade's before the strike (add nodes["displacement"]) unless is_deformed, particles where
               they are
    is_deformed  whether the blade's points have been moved (Output/Blade geometry = deformed)
    cells_of   [m][1, 4 or 8] numbers of nodes, in VTK's order
    nodes      {name: [n] or [n][components]}, cells the same for cells
    units      {name: unit}
    path       of the file, for pyvista.read() or ParaView
    """

    def __init__(self, path):
        self.path = pathlib.Path(path)
        piece = xml.etree.ElementTree.parse(self.path).getroot()
        grid = piece.find("UnstructuredGrid")
        of_file = {array.get("Name"): array.text for array in grid.findall("FieldData/DataArray")}
        self.time = float(of_file["TimeValue"]) if "TimeValue" in of_file else None
        self.is_deformed = "deformed" in of_file
        piece = grid.find("Piece")
        self.units = {array.get("Name"): array.get("units", "") for array in piece.iter("DataArray") if array.get("Name")}
        self.points = _read(piece.find("Points/DataArray"))
        topology = {array.get("Name"): _read(array) for array in piece.find("Cells")}
        n = int(piece.get("NumberOfCells"))
        self.cells_of = topology["connectivity"].reshape(n, -1) if n > 0 else topology["connectivity"].reshape(0, 1)
        self.nodes = {array.get("Name"): _read(array) for array in piece.find("PointData")}
        self.cells = {array.get("Name"): _read(array) for array in piece.find("CellData")}

    def __repr__(self):
        return f"Mesh('{self.path}', {len(self.points)} nodes, {len(self.cells_of)} cells, {self.time} s)"


class Run:
    """The run in `folder`; raises FileNotFoundError where there is none."""

    def __init__(self, folder):
        self.folder = pathlib.Path(folder)
        if not (self.folder / "history.csv").is_file():
            raise FileNotFoundError(f"'{folder}' holds no history.csv: it is no folder of a run.")
        summary = self.folder / "summary.json"
        self.summary = json.loads(summary.read_text(encoding="utf-8")) if summary.is_file() else None
        self._units, self._history = _read_history(self.folder / "history.csv")
        self._places = {}

    @property
    def columns(self):
        """{name: unit} of the curves."""
        return dict(self._units)

    def __getitem__(self, name):
        _require(name, self._history, f"column of {self.folder / 'history.csv'}")
        return Curve(self._history["time"], self._history[name], self._units[name])

    @property
    def tip(self):
        """Deflection of the tip at mid-chord, m."""
        return self["tip_mid_chord"]

    @property
    def contact_force(self):
        """[n][3], N, of the bird on the blade."""
        parts = [self[f"contact_force_{axis}"] for axis in "xyz"]
        return Curve(parts[0].time, np.stack([part.values for part in parts], axis=1), parts[0].unit)

    @property
    def contact_impulse(self):
        """[n][3], N s, of the bird on the blade."""
        parts = [self[f"contact_impulse_{axis}"] for axis in "xyz"]
        return Curve(parts[0].time, np.stack([part.values for part in parts], axis=1), parts[0].unit)

    @property
    def energies(self):
        """{name: Curve} of everything in J."""
        return {name: self[name] for name, unit in self._units.items() if unit == "J"}

    def __getattr__(self, table):
        """The places of nodes.csv, elements.csv, gauges.csv, sections.csv or patches.csv, the blades of blades.csv, by name."""
        if table not in ("nodes", "elements", "gauges", "sections", "patches", "blades"):
            raise AttributeError(f"'Run' object has no attribute '{table}'")
        if table not in self._places:
            path = self.folder / f"{table}.csv"
            if not path.is_file():
                raise KeyError(f"'{self.folder}' has no {path.name}: see {'Blade/Row' if table == 'blades' else 'Output/Histories'}.")
            self._places[table] = _read_places(path)
        return self._places[table]

    @property
    def profiles(self):
        """Names of what results.h5 holds along lines: its groups with "values"; those of curves have none."""
        with h5py.File(self.folder / "results.h5") as file:
            return sorted(name for name in file if "values" in file[name])

    def profile(self, name):
        """E.g. root_normal_stress_at_peak, a Profile."""
        with h5py.File(self.folder / "results.h5") as file:
            _require(name, self.profiles, f"profile of {self.folder / 'results.h5'}")
            group = file[name]
            values = group["values"]
            axes = {key: group[key][()] for key in group if key != "values"}
            if values.ndim > len(axes):
                axes["time"] = file["history/time"][()]
            return Profile(axes, values[()], _text(values.attrs["unit"]))

    def times(self, part):
        """Times (s) of the field files of "blade" or "bird"."""
        return np.array([time for time, _ in self._series(part)])

    def blade(self, time):
        """The blade's field file nearest to `time` (s)."""
        return self._nearest("blade", time)

    def bird(self, time):
        """The particles' field file nearest to `time` (s)."""
        return self._nearest("bird", time)

    def _nearest(self, part, time):
        series = self._series(part)
        return Mesh(min(series, key=lambda entry: abs(entry[0] - time))[1])

    def _series(self, part):
        path = self.folder / f"{part}.pvd"
        if not path.is_file():
            raise KeyError(f"'{self.folder}' has no {part}.pvd: the scene has no {part}, or Output/{part.capitalize()} fields is false.")
        sets = xml.etree.ElementTree.parse(path).getroot().iter("DataSet")
        return [(float(entry.get("timestep")), self.folder / entry.get("file")) for entry in sets]


def _require(name, names, what):
    if name not in names:
        raise KeyError(f"'{name}' is no {what}. There are: {', '.join(sorted(names))}")


def _text(value):
    return value.decode() if isinstance(value, bytes) else str(value)


def _read_history(path):
    """Units and columns by name. The file begins with '# 1: time [s]', a line a column, and a row of names."""
    with open(path, encoding="utf-8") as file:
        lines = file.read().splitlines()
    units = dict(re.findall(r"^# *\d+: (\S+) \[([^\]]*)\]", "\n".join(lines), re.MULTILINE))
    names, *rows = (line.split(",") for line in lines if not line.startswith("#"))
    rows = [row for row in rows if len(row) == len(names)]  # the last may be half written
    values = np.array(rows, dtype=float).reshape(-1, len(names))
    return {name: units.get(name, "") for name in names}, {name: values[:, k] for k, name in enumerate(names)}


def _read_places(path):
    """Columns are "<place>.<quantity>", of vectors and tensors "<place>.<quantity>_<component>": a namespace of curves a
    place, components side by side as they stand in the file."""
    units, history = _read_history(path)
    time, places = history.pop("time"), {}
    for name, values in history.items():
        place, quantity = name.rsplit(".", 1)
        if re.match(r"(u|v|a|F|impulse|stress|strain)_(?!peak)", quantity):
            quantity = quantity.split("_")[0]
        places.setdefault(place, {}).setdefault(quantity, []).append((values, units[name]))
    return {place: types.SimpleNamespace(**{
        quantity: Curve(time, np.stack([values for values, _ in parts], axis=1) if len(parts) > 1 else parts[0][0], parts[0][1])
        for quantity, parts in quantities.items()}) for place, quantities in places.items()}


def _read(array):
    """The values of a DataArray, by rows where it has several components."""
    text = "".join(array.text.split())
    n_blocks = struct.unpack("<I", base64.b64decode(text[:8])[:4])[0]
    n_header = 4 * (3 + n_blocks)
    end = 4 * ((n_header + 2) // 3)
    lengths = struct.unpack(f"<{3 + n_blocks}I", base64.b64decode(text[:end])[:n_header])[3:]
    body, raw, begin = base64.b64decode(text[end:]), b"", 0
    for length in lengths:
        raw += zlib.decompress(body[begin:begin + length])
        begin += length
    values = np.frombuffer(raw, _TYPES[array.get("type")])
    n = int(array.get("NumberOfComponents", 1))
    return values.reshape(-1, n) if n > 1 else values

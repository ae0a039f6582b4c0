"""Field files of a run: VTK's unstructured grids, compressed."""

import base64
import os
import pathlib
import struct
import xml.etree.ElementTree
import zlib
from typing import Any, TypeAlias

import numpy as np
import numpy.typing as npt

Array: TypeAlias = npt.NDArray[Any]

_TYPES = {"Float32": "<f4", "Float64": "<f8", "Int32": "<i4", "Int64": "<i8", "UInt8": "u1", "UInt32": "<u4"}


class Mesh:
    """What one field file holds.

    path         of the file, for pyvista.read() or ParaView
    time         s, None where the file has none
    is_deformed  whether the blade's points have been moved (Output/Blade geometry = deformed)
    points       [n][3], m: a blade's before the strike (add nodes["displacement"]) unless is_deformed, particles where
                 they are
    cells_of     [m][1, 4 or 8] numbers of nodes, in VTK's order
    nodes        {name: [n] or [n][components]}
    cells        {name: [m] or [m][components]}
    units        {name: unit} of both
    """

    path: pathlib.Path
    time: float | None
    is_deformed: bool
    points: Array
    cells_of: Array
    nodes: dict[str, Array]
    cells: dict[str, Array]
    units: dict[str, str]

    def __init__(self, path: str | os.PathLike[str]) -> None:
        self.path = pathlib.Path(path)
        grid = _find(xml.etree.ElementTree.parse(self.path).getroot(), "UnstructuredGrid")
        of_file = {array.get("Name"): array.text or "" for array in grid.findall("FieldData/DataArray")}
        self.time = float(of_file["TimeValue"]) if "TimeValue" in of_file else None
        self.is_deformed = "deformed" in of_file
        piece = _find(grid, "Piece")
        self.units = {name: array.get("units", "") for array in piece.iter("DataArray") if (name := array.get("Name"))}
        self.points = _read(_find(piece, "Points/DataArray"))
        connectivity = _read_by_name(_find(piece, "Cells"))["connectivity"]
        n = int(piece.get("NumberOfCells", 0))
        self.cells_of = connectivity.reshape(n, -1) if n > 0 else connectivity.reshape(0, 1)
        self.nodes = _read_by_name(_find(piece, "PointData"))
        self.cells = _read_by_name(_find(piece, "CellData"))

    def __repr__(self) -> str:
        return f"Mesh('{self.path}', {len(self.points)} nodes, {len(self.cells_of)} cells, {self.time} s)"


def _find(element: xml.etree.ElementTree.Element, path: str) -> xml.etree.ElementTree.Element:
    found = element.find(path)
    if found is None:
        raise ValueError(f"The field file has no {path} in its {element.tag}.")
    return found


def _read_by_name(element: xml.etree.ElementTree.Element) -> dict[str, Array]:
    return {array.get("Name", ""): _read(array) for array in element}


def _read(array: xml.etree.ElementTree.Element) -> Array:
    """The values of a DataArray, by rows where it has several components.

    In base64: a header of 3 + n numbers (blocks, size of a block, size of the last, n lengths), then n compressed blocks.
    """
    text = "".join((array.text or "").split())
    n_blocks = struct.unpack("<I", base64.b64decode(text[:8])[:4])[0]
    n_header = 4 * (3 + n_blocks)
    end = 4 * ((n_header + 2) // 3)
    lengths = struct.unpack(f"<{3 + n_blocks}I", base64.b64decode(text[:end])[:n_header])[3:]
    body, raw, begin = base64.b64decode(text[end:]), bytearray(), 0
    for length in lengths:
        raw += zlib.decompress(body[begin:begin + length])
        begin += length
    values = np.frombuffer(bytes(raw), _TYPES[array.get("type", "")])
    n = int(array.get("NumberOfComponents", 1))
    return values.reshape(-1, n) if n > 1 else values

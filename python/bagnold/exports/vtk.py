# SPDX-License-Identifier: BSD-3-Clause
"""VTK: NAME.pvd, which ParaView opens, and NAME_vtk/000000.vtp, a file each frame; with contacts
NAME.contacts.pvd and NAME_vtk/contacts_000000.vtp, lines between centres."""

from __future__ import annotations

import base64
import pathlib
import struct

import numpy as np
from numpy.typing import NDArray
from typing import Any

from ..contacts import ContactFrames, Contacts
from ..files import beside
from ..frames import Array, Frame, Frames
from .text import contact_segment, in_cell, written_whole

TYPES = {"float64": "Float64", "int64": "Int64"}


def _array(name: str, values: NDArray[Any]) -> str:
    """A DataArray with its bytes, their number before them, in base64."""
    values = np.ascontiguousarray(values, dtype=np.int64 if values.dtype.kind == "i" else np.float64)
    raw = values.astype(values.dtype.newbyteorder("<")).tobytes()
    text = base64.b64encode(struct.pack("<Q", len(raw)) + raw).decode("ascii")
    components = f' NumberOfComponents="{values.shape[1]}"' if values.ndim == 2 else ""
    return (f'<DataArray type="{TYPES[values.dtype.name]}" Name="{name}"{components} format="binary">'
            f"{text}</DataArray>\n")


def _field(name: str, values: list[float]) -> str:
    """Field data of the whole frame."""
    return _array(name, np.array(values, dtype=np.float64)).replace(
        "<DataArray ", f'<DataArray NumberOfTuples="{len(values)}" ', 1)


def _poly_data(points: Array, kind: str, cells: NDArray[np.int64], point_data: str, cell_data: str, field: str) -> str:
    """A file of points, with `cells` [M, k] of the kind "Verts" or "Lines"."""
    others = "".join(f'<{name}><DataArray type="Int64" Name="connectivity" format="ascii"></DataArray>'
                     f'<DataArray type="Int64" Name="offsets" format="ascii"></DataArray></{name}>\n'
                     for name in ("Verts", "Lines", "Strips", "Polys") if name != kind)
    offsets = np.arange(1, len(cells) + 1) * cells.shape[1]
    counts = " ".join(f'NumberOf{name}="{len(cells) if name == kind else 0}"'
                      for name in ("Verts", "Lines", "Strips", "Polys"))
    return ('<?xml version="1.0"?>\n<VTKFile type="PolyData" version="1.0" byte_order="LittleEndian" '
            f'header_type="UInt64">\n<PolyData>\n<FieldData>\n{field}</FieldData>\n'
            f'<Piece NumberOfPoints="{len(points)}" {counts}>\n<PointData>\n{point_data}</PointData>\n'
            f"<CellData>\n{cell_data}</CellData>\n"
            f"<Points>\n{_array('Points', points)}</Points>\n"
            f"<{kind}>\n{_array('connectivity', cells.ravel())}{_array('offsets', offsets)}</{kind}>\n{others}"
            "</Piece>\n</PolyData>\n</VTKFile>\n")


def _three(values: Array) -> Array:
    return np.column_stack([values, np.zeros(len(values))])


def _about(frame: Frame) -> str:
    return (_field("TimeValue", [frame.time]) + _field("strain", [frame.strain])
            + _field("strain_rate", [frame.strain_rate]) + _field("box", frame.box.matrix.ravel().tolist()))


def _disks(frame: Frame) -> str:
    position, image = in_cell(frame)
    data = {"diameter": frame.diameter, "species": frame.species, "mass": frame.mass,
            "velocity": _three(frame.velocity), "nonaffine_velocity": _three(frame.nonaffine_velocity)}
    if frame.spin is not None:
        data["spin"] = frame.spin
    if image is not None:
        data["image"] = np.column_stack([image, np.zeros(len(frame), dtype=np.int64)])
    return _poly_data(_three(position), "Verts", np.arange(len(frame))[:, None],
                      "".join(_array(name, values) for name, values in data.items()), "", _about(frame))


def _contacts(frame: Frame, found: Contacts) -> str:
    position, _ = in_cell(frame)
    ends = contact_segment(frame.box, position, found.i, found.normal, found.separation)
    data = {"i": found.i, "j": found.j, "overlap": found.overlap, "normal_force": found.normal_force,
            "tangential_force": found.tangential_force}
    return _poly_data(_three(ends.reshape(-1, 2)), "Lines", np.arange(2 * len(found)).reshape(-1, 2), "",
                      "".join(_array(name, values) for name, values in data.items()), _about(frame))


def _collection(path: pathlib.Path, frames: list[tuple[float, str]]) -> None:
    with written_whole(path) as file:
        file.write('<?xml version="1.0"?>\n<VTKFile type="Collection" version="1.0">\n<Collection>\n')
        for time, name in frames:
            file.write(f'<DataSet timestep="{time!r}" part="0" file="{name}"/>\n')
        file.write("</Collection>\n</VTKFile>\n")


def write(frames: Frames, contacts: ContactFrames | None, target: pathlib.Path) -> list[pathlib.Path]:
    """Writes the files; returns the collections."""
    folder = beside(target, "_vtk")
    folder.mkdir(exist_ok=True)
    disks, pairs = [], []
    for k, frame in enumerate(frames):
        name = f"{folder.name}/{k:06}.vtp"
        with written_whole(target.parent / name) as file:
            file.write(_disks(frame))
        disks.append((frame.time, name))
        if contacts is not None:
            name = f"{folder.name}/contacts_{k:06}.vtp"
            with written_whole(target.parent / name) as file:
                file.write(_contacts(frame, contacts[k]))
            pairs.append((frame.time, name))
    _collection(target, disks)
    if contacts is None:
        return [target]
    of_pairs = beside(target, ".contacts.pvd")
    _collection(of_pairs, pairs)
    return [target, of_pairs]

# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Pieces of a mesh that become one."""

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkCommonCore import vtkAbstractArray, vtkIdList, vtkPoints
from vtkmodules.vtkCommonDataModel import vtkDataSetAttributes, vtkPointData, vtkPolyData
from vtkmodules.vtkFiltersCore import vtkAppendFilter, vtkAppendPolyData, vtkExtractCells

_IDS = "gatun global ids of points"
_GHOSTS = vtkDataSetAttributes.GhostArrayName()


# ------------------------------------------------------------------------------
# Pieces


def prepare_piece(piece):
    """Removes cells of other pieces, and arrays that readers make for pieces."""
    ghosts = piece.GetCellData().GetArray(_GHOSTS)
    if ghosts and np.any(vtk_to_numpy(ghosts) & vtkDataSetAttributes.DUPLICATECELL):
        if isinstance(piece, vtkPolyData):
            piece.RemoveGhostCells()
        else:
            piece = _extract_cells(piece, vtk_to_numpy(ghosts) & vtkDataSetAttributes.DUPLICATECELL == 0)
    for data in (piece.GetPointData(), piece.GetCellData()):
        _clear_duplicates(data)
    ids = piece.GetPointData().GetGlobalIds()
    if ids:
        copy = ids.NewInstance()
        copy.DeepCopy(ids)
        copy.SetName(_IDS)
        piece.GetPointData().AddArray(copy)
    for data in (piece.GetPointData(), piece.GetCellData()):
        ids = data.GetGlobalIds()
        if ids and ids.GetInformation().Has(vtkAbstractArray.GUI_HIDE()):
            data.RemoveArray(ids.GetName())
    return piece


def _make_id_list(ids):
    made = vtkIdList()
    made.SetNumberOfIds(len(ids))
    for i, number in enumerate(ids.tolist()):
        made.SetId(i, number)
    return made


def _extract_cells(grid, is_kept):
    """A grid with some of the cells. What RemoveGhostCells of VTK 9.6 leaves of polyhedra loses cells when it is sent."""
    extract = vtkExtractCells()
    extract.SetInputData(grid)
    extract.SetCellList(_make_id_list(np.flatnonzero(is_kept)))
    extract.PassThroughCellIdsOff()
    extract.Update()
    piece = extract.GetOutput()
    piece.GetPoints().GetData().SetName(grid.GetPoints().GetData().GetName())
    piece.GetFieldData().ShallowCopy(grid.GetFieldData())
    piece.GetInformation().Copy(grid.GetInformation())
    return piece


def _clear_duplicates(data):
    """Clears the marks of points and cells that belong to another piece. Other marks stay."""
    ghosts = data.GetArray(_GHOSTS)
    if ghosts:
        copy = ghosts.NewInstance()
        copy.DeepCopy(ghosts)
        marks = vtk_to_numpy(copy)
        marks &= 0xFF ^ vtkDataSetAttributes.DUPLICATECELL  # that of points has the same number
        data.RemoveArray(_GHOSTS)
        if marks.any():
            data.AddArray(copy)


def join_pieces(pieces):
    """Makes one mesh of pieces.

    Points of several pieces become one if they have the same global id, or without ids the same coordinates,
    and the same values of all arrays.
    """
    parts = [piece for piece in pieces if piece.GetNumberOfPoints() > 0] or pieces[:1]
    joined = parts[0]
    if len(parts) > 1:
        _check_arrays(parts)
        append = vtkAppendPolyData() if isinstance(joined, vtkPolyData) else vtkAppendFilter()
        for part in parts:
            append.AddInputData(part)
        append.Update()
        joined = append.GetOutput()
        joined.GetFieldData().ShallowCopy(parts[0].GetFieldData())
        joined.GetInformation().Copy(parts[0].GetInformation())
        owners = np.repeat(np.arange(len(parts)), [part.GetNumberOfPoints() for part in parts])
        _merge_points(joined, _find_equal_points(joined, owners))
    joined.GetPointData().RemoveArray(_IDS)
    return joined


def _list_names(part):
    return {
        (is_cell, data.GetArrayName(i))
        for is_cell, data in enumerate((part.GetPointData(), part.GetCellData()))
        for i in range(data.GetNumberOfArrays())
    }


def _check_arrays(parts):
    names = [_list_names(part) for part in parts]
    for is_cell, name in sorted(set.union(*names) - set.intersection(*names)):
        kind = "cell" if is_cell else "point"
        raise ValueError(f"the {kind} array {name!r} is not in the pieces of all processes")


# ------------------------------------------------------------------------------
# Points


def _find_candidates(keys):
    """The rows that occur more than once, ascending."""
    order = np.lexsort(keys.T)
    is_same = (keys[order[1:]] == keys[order[:-1]]).all(axis=1)
    is_several = np.zeros(len(keys), bool)
    is_several[1:] |= is_same
    is_several[:-1] |= is_same
    return np.sort(order[is_several])


def _number_rows(rows):
    """A number for each row, the same for equal ones."""
    return np.unique(rows, axis=0, return_inverse=True)[1].ravel()


def _find_equal_points(mesh, owners):
    """For each point the first one that equals it.

    Args:
        mesh: the mesh.
        owners: the number of the piece of each point, ascending. Points of one piece stay apart: the first of two
            equal ones becomes one with the first of two in another piece.
    """
    data = mesh.GetPointData()
    points = vtk_to_numpy(mesh.GetPoints().GetData())
    ids = data.GetArray(_IDS)
    candidates = _find_candidates(vtk_to_numpy(ids)[:, None] if ids else points)
    found = np.arange(len(points))
    if not candidates.size:
        return found
    arrays = [points] + [vtk_to_numpy(data.GetArray(i)) for i in range(data.GetNumberOfArrays())]
    rows = [np.ascontiguousarray(array[candidates]) for array in arrays]
    groups = _number_rows(np.hstack([row.view(np.uint8).reshape(len(candidates), -1) for row in rows]))
    order = np.lexsort((candidates, owners[candidates], groups))
    places = np.stack([groups[order], owners[candidates][order]], axis=1)
    begins = np.concatenate([[True], (places[1:] != places[:-1]).any(axis=1)])
    starts = np.flatnonzero(begins)
    turns = np.arange(len(order)) - starts[np.cumsum(begins) - 1]
    joined = _number_rows(np.stack([groups[order], turns], axis=1))
    first = np.full(joined.max() + 1, len(points))
    np.minimum.at(first, joined, candidates[order])
    found[candidates[order]] = first[joined]
    return found


def _merge_points(mesh, first):
    """Replaces points by others of the mesh."""
    is_kept = first == np.arange(len(first))
    if is_kept.all():
        return
    target = (np.cumsum(is_kept) - 1)[first]
    kept = _make_id_list(np.flatnonzero(is_kept))
    for cells in _list_cell_arrays(mesh):
        ids = vtk_to_numpy(cells.GetConnectivityArray())
        ids[...] = target[ids]
    if hasattr(mesh, "GetFaces") and not hasattr(mesh, "GetPolyhedronFaces"):  # before VTK 9.4
        _renumber_faces(mesh.GetFaces(), mesh.GetFaceLocations(), target)
    points = vtkPoints()
    points.SetDataType(mesh.GetPoints().GetDataType())
    points.SetNumberOfPoints(kept.GetNumberOfIds())
    mesh.GetPoints().GetPoints(kept, points)
    points.GetData().SetName(mesh.GetPoints().GetData().GetName())
    data = vtkPointData()
    data.CopyAllOn()
    data.CopyAllocate(mesh.GetPointData(), kept.GetNumberOfIds())
    data.CopyData(mesh.GetPointData(), kept)
    mesh.SetPoints(points)
    mesh.GetPointData().ShallowCopy(data)


def _list_cell_arrays(mesh):
    """The lists of points of a mesh."""
    if isinstance(mesh, vtkPolyData):
        found = [mesh.GetVerts(), mesh.GetLines(), mesh.GetPolys(), mesh.GetStrips()]
    else:
        found = [mesh.GetCells()]
        if hasattr(mesh, "GetPolyhedronFaces"):
            found.append(mesh.GetPolyhedronFaces())
    return [cells for cells in found if cells and cells.GetNumberOfCells() > 0]


def _renumber_faces(faces, locations, target):
    """Replaces points in the lists of faces of polyhedra: their number, and for each its size and points."""
    if not faces or not locations:
        return
    stream = vtk_to_numpy(faces)
    starts = vtk_to_numpy(locations)
    for at in starts[starts >= 0].tolist():
        count = stream[at]
        at += 1
        for _ in range(count):
            size = stream[at]
            stream[at + 1 : at + 1 + size] = target[stream[at + 1 : at + 1 + size]]
            at += 1 + size

# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Files of cells of all types, as vtkGatunWriter writes them, are decoded by a decoder written from
Documentation/format.md and cell-codec.md alone as vtkGatunReader reads them, bit for bit, and in
the original order as they were."""

import sys

import numpy as np

import gatunMeshes as gm
from gatun.vtk import vtkGatunWriter
from gatunTimeSource import TimeSource, connect

try:
    import gatunCellMeshes as meshes
    import gatunGolden as golden
    import gatunOrderMeshes as orders
    import gatunShellMeshes as shells
    from gatunDecoded import assert_decoded_as, decode
    from gtn_layers import check_layers
    from gtn_tree import check_ranges
except ImportError as error:
    print(error)
    sys.exit(gm.SKIPPED)

NONLINEAR_SOLIDS = (24, 25, 26, 27, 29, 31, 32, 33, 37)
NONLINEAR_SURFACES = (22, 23, 28, 30, 34)
TETRA, HEXAHEDRON, WEDGE, PYRAMID, POLYHEDRON = 10, 12, 13, 14, 42

# Functions by name; each gets a generator of random numbers.
MESHES = {
    **{name: getattr(meshes, name) for name in (
        "hexahedra", "hexahedra_at_random", "voxels", "wedges", "pyramids", "transition", "prisms",
        "hanging", "polygons_in_layers", "polyhedra_and_others", "other_corners", "middles",
        "with_boundary", "shells", "degenerate", "odd_places", "one_place", "around_an_edge",
        "cone", "holes", "torn", "comb")},
    **{"nonlinear %d" % kind: lambda rng, kind=kind: meshes.nonlinear(rng, kind)
       for kind in NONLINEAR_SOLIDS},
    **{"shell %d" % kind: lambda rng, kind=kind: meshes.quadratic_shell(rng, kind)
       for kind in NONLINEAR_SURFACES},
    **{"order %d of %d" % (order, kind):
       lambda rng, kind=kind, order=order: orders.solids(rng, kind, [order])
       for kind in (71, 72, 73, 78, 79, 80) for order in (1, 2, 3, 5)},
    "orders that differ": lambda rng: orders.solids(rng, 72, (2, 4, 1)),
    **{"order 4 of %d" % kind: lambda rng, kind=kind: orders.shell(rng, kind, 4)
       for kind in (69, 70, 76, 77)},
    "hanging hexahedra": lambda rng: meshes.hanging(rng, as_polyhedra=False),
    "turned polygons": lambda rng: meshes.polygons_in_layers(rng, shift=1),
    "large polygons": lambda rng: meshes.polygons_in_layers(rng, most=9, n=4),
    "few middles": lambda rng: meshes.middles(rng, part=0.15),
    "middles of pyramids": lambda rng: meshes.middles(rng, part=0.3, kind=PYRAMID),
    "many hexahedra": lambda rng: meshes.hexahedra(rng, (9, 9, 9), 0.02),
    "many holes": lambda rng: meshes.holes(rng, part=0.4),
    "linear soup": lambda rng: meshes.soup(rng, [*range(17), POLYHEDRON]),
    "nonlinear soup": lambda rng: meshes.soup(rng, [*range(21, 38)]),
    "soup of few": lambda rng: meshes.soup(rng, [HEXAHEDRON, POLYHEDRON, 4, 6], 20),
    "polyhedral soup": lambda rng: meshes.soup(rng, [POLYHEDRON], 20),
    "other soup": lambda rng: meshes.soup(rng, [41, 52, 61, *range(68, 82), 99, 200]),
}

SHELLS = {
    **{name: getattr(shells, name) for name in (
        "triangles", "triangles_irregular", "triangles_closed", "quads", "quads_closed",
        "quads_irregular", "polygons", "large_polygons", "pixels", "mixed", "nonlinear_mixed",
        "in_a_plane", "junctions", "moebius", "turned", "holes", "cube_walls", "fan", "book",
        "degenerate", "soup", "clustered", "colliding", "one_place", "odd_places", "beside_solids",
        "inside_solids")},
    **{"tiny %s" % kind: lambda rng, kind=kind: shells.tiny(rng, kind)
       for kind in ("one", "lens", "tetrahedron", "pillow")},
    "closed in turn": lambda rng: shells.triangles_closed(rng, in_turn=True),
    "closed polygons": lambda rng: shells.polygons(rng, is_closed=True),
    "closed mixed": lambda rng: shells.mixed(rng, is_closed=True),
    "four sheets": lambda rng: shells.junctions(rng, 4),
    "band": lambda rng: shells.moebius(rng, twists=2),
    "few holes": lambda rng: shells.holes(rng, part=0.85),
    "all walls": lambda rng: shells.cube_walls(rng, part=1.1),
    "nearly colliding": lambda rng: shells.colliding(rng, 1),
    "soup of triangles": lambda rng: shells.soup(rng, 60, 14, 3),
    "soup at few points": lambda rng: shells.soup(rng, 80, 12, 5),
    "soup of large polygons": lambda rng: shells.soup(rng, 60, 80, 30),
}

# Seeds for which the front touches itself in rare ways: more than once at an edge; a cell fills the
# gap between two faces that are not linked to each other, and both, or just one, lead on.
AMONG_MANY = (
    (1030, [WEDGE, TETRA], (3, 3, 2), 0.9), (2261, [TETRA] * 3 + [WEDGE], (4, 3, 3), 0.95),
    (2375, [TETRA] * 3 + [HEXAHEDRON], (4, 3, 3), 0.95), (2525, [WEDGE, TETRA], (4, 3, 3), 0.95),
    (2692, [TETRA] * 3 + [WEDGE], (4, 3, 3), 0.9), (3748, [WEDGE, TETRA], (3, 3, 3), 0.9),
    (5315, [WEDGE, TETRA], (3, 3, 3), 0.95))


def check(name, grid, **options):
    """Decodes, and gives the decoder."""
    path = gm.temporary("decoded.gtn")
    gm.write(grid, path, **options)
    decoder = decode(path)
    try:
        assert_decoded_as(gm.read(path, RestoreOrder=False), decoder, False)
        if options.get("KeepOrder") == 7:
            assert_decoded_as(gm.read(path, RestoreOrder=True), decoder, True)
            assert_decoded_as(grid, decoder, True)
        tets = gm.read(path, SplitCells=True, RestoreOrder=False)
        assert np.array_equal(
            gm.coordinates(tets)[gm.connectivity(tets)].view(np.uint8),
            decoder.points()[decoder.tets()].view(np.uint8)), "tetrahedra of cells"
    except AssertionError as error:
        raise AssertionError("%s %s: %s" % (name, options, error)) from error
    return decoder


modes = set()
shared = 0
for name, make in {**MESHES, **SHELLS}.items():
    grid = make(np.random.default_rng(6))
    for options in ({"ChunkSize": 0}, {"ChunkSize": 100, "KeepOrder": 7}):
        decoder = check(name, grid, Profile=0, **options)
        modes.update(chunk.geometry.mode for chunk in decoder.chunks if not chunk.is_walk)
        shared += sum(len(chunk.shared_points) for chunk in decoder.chunks)
        decoder = check(name, grid, Profile=1, **options)
        assert all(chunk.is_tree for chunk in decoder.chunks if chunk.walk.keys), name
assert modes == {0, 1, 2} and shared > 1000
for seed, *arguments in AMONG_MANY:
    grid = meshes.holes_among_many(np.random.default_rng(seed), *arguments)
    check("holes %d" % seed, grid, Profile=0)

# A file with chunks of both kinds: tetrahedra are in chunks of their own where nothing else is.
grid = meshes.two_blocks(np.random.default_rng(1))
decoder = check("two blocks", grid, ChunkSize=64, KeepOrder=7, Profile=0)
assert {chunk.is_walk for chunk in decoder.chunks} == {True, False}

# Steps with changes that are predicted from the step before.
grid = meshes.transition(np.random.default_rng(2))
values = np.random.default_rng(3).random(grid.GetNumberOfCells())
grids = []
for step in range(5):
    made = grid.NewInstance()
    made.ShallowCopy(grid)
    places = gm.coordinates(grid).astype(float)
    gm.add_array(made.GetPointData(), np.sin(places + 0.1 * step).astype(np.float32), "moving")
    gm.add_array(made.GetPointData(), np.floor(places[:, 0] + step).astype(np.int32), "stepping")
    gm.add_array(made.GetCellData(), (values + 0.01 * step).astype(np.float32), "rising")
    grids.append(made)
path = gm.temporary("decoded.gtn")
times = [float(step) for step in range(len(grids))]
for options in ({"ChunkSize": 64, "KeepOrder": 7}, {"KeyStepInterval": 2}):
    writer = vtkGatunWriter()
    connect(writer, TimeSource(grids.__getitem__, times))
    writer.WriteAllTimeStepsOn()
    writer.SetFileName(path)
    gm.set_options(writer, **options)
    assert writer.Write() == 1
    decoder = decode(path)
    for step, read in enumerate(golden.read_steps(path, False)[0]):
        assert_decoded_as(read, decoder, False, step)
        if options.get("KeepOrder") == 7:
            assert_decoded_as(grids[step], decoder, True, step)

# Merges are those of the tetrahedra of cells; layers are by values.
for name in ("hexahedra", "transition", "polygons_in_layers"):
    grid = MESHES[name](np.random.default_rng(4))
    decoder = check(name, grid, ChunkSize=300, Hierarchy=True)
    assert len(decoder.merges) > 10
    check_ranges(decoder)
    decoder = check(name, grid, ChunkSize=64, Layers=("wave", -1, 4))
    assert decoder.container.layers is not None and decoder.container.cells is not None
    check_layers(decoder)

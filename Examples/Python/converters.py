"""A mesh for meshio and for PyVista, and from meshio. Packages that are not installed are left out.

    python3 converters.py [FOLDER]
"""

from shapes import get_folder, make_pipe

import gatun

folder = get_folder()
points, cells, heat = make_pipe(16, 4, 20)
pipe = gatun.from_numpy(points, {"hexahedron": cells}, point_data={"temperature": heat})
gatun.write(pipe, f"{folder}/pipe.gtn", overwrite=True)
mesh = gatun.read(f"{folder}/pipe.gtn")

try:
    import meshio
except ImportError:
    print("meshio is not installed")
else:
    # Every format that meshio writes and reads, here that of Abaqus.
    gatun.to_meshio(mesh).write(f"{folder}/pipe.inp")
    again = meshio.read(f"{folder}/pipe.inp")
    size = gatun.write(again, f"{folder}/from_meshio.gtn", overwrite=True)
    print(f"meshio: {again.cells[0].type}, {len(again.points)} points, {size} bytes as .gtn")

try:
    import pyvista
except ImportError:
    print("PyVista is not installed")
else:
    wrapped = pyvista.wrap(mesh)
    print(f"PyVista: {wrapped.n_cells} cells, temperature up to {wrapped['temperature'].max():.1f}")
    gatun.write(wrapped.extract_cells(range(100)), f"{folder}/from_pyvista.gtn", overwrite=True)

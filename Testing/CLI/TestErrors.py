# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What gtn cannot do, it says in one line that names the file, with exit code 1; what makes no
sense, with exit code 2. A file that was there stays as it was."""

import os

from gatunCli import enter_folder, gtn, skip, standard_mesh, write

enter_folder("errors")
write(standard_mesh(3), "mesh.vtu")
gtn("pack", "-q", "mesh.vtu", "mesh.gtn")
os.mkdir("folder")
open("empty.vtu", "wb").close()
open("empty.gtn", "wb").close()
for name in ("bad.gtn", "bad.vtu", "bad.vtk", "bad.pvd", "bad.case", "bad.e", "bad.vtm", "bad.stl"):
    with open(name, "w") as file:
        file.write("this is no mesh\n" * 20)
with open("mesh.gtn", "rb") as file:
    good = file.read()
with open("cut.gtn", "wb") as file:
    file.write(good[: len(good) // 2])
with open("damaged.gtn", "wb") as file:
    middle = len(good) // 2
    file.write(good[:middle] + bytes([good[middle] ^ 64]) + good[middle + 1 :])

# Usage.
gtn(code=2)
gtn("nonsense", code=2)
gtn("pack", "mesh.vtu", code=2)
gtn("pack", "mesh.vtu", "mesh.vtk", code=2, says="mesh.vtk: the name must end in .gtn")
gtn("pack", "--keep-order", "some", "mesh.vtu", "new.gtn", code=2, says="some")
gtn("pack", "--chunk-size", "7", "mesh.vtu", "new.gtn", code=2)
gtn("pack", "-q", "-v", "mesh.vtu", "new.gtn", code=2)
gtn("unpack", "mesh.gtn", "new.xyz", code=2, says="new.xyz: the name must end in .vtu or .vtk")
gtn("unpack", "--time", "1", "--step", "1", "mesh.gtn", "new.vtu", code=2)
gtn("unpack", "--compressor", "zip", "mesh.gtn", "new.vtu", code=2)
gtn("info", code=2)

# Input.
for command, more in (("pack", ["new.gtn"]), ("unpack", ["new.vtu"]), ("info", []), ("verify", [])):
    extension = ".vtu" if command == "pack" else ".gtn"
    missing = "missing" + extension
    gtn(command, missing, *more, code=1, says=f"gtn: {missing}: no such file")
    gtn(command, "folder", *more, code=1, says="gtn: folder: is a folder")
    empty = "empty" + extension
    gtn(command, empty, *more, code=1, says=f"gtn: {empty}: is empty")
    gtn(command, "bad.gtn", *more, code=1, says="gtn: bad.gtn: ")
    gtn(command, "cut.gtn", *more, code=1, says="gtn: cut.gtn: ")
for name in ("bad.vtu", "bad.vtk", "bad.pvd", "bad.case", "bad.e", "bad.vtm", "bad.stl"):
    gtn("pack", name, "new.gtn", code=1, says=f"gtn: {name}: ")
gtn("verify", "damaged.gtn", code=1, says="gtn: damaged.gtn: ")
gtn("info", "mesh.vtu", code=1, says="gtn: mesh.vtu: ")
gtn("verify", "mesh.gtn", "missing.vtu", code=1, says="gtn: missing.vtu: no such file")
gtn(
    "pack", "--arrays", "heat", "mesh.vtu", "new.gtn",
    code=1, says="gtn: mesh.vtu: has no array 'heat'; there are pressure, velocity",
)
gtn("unpack", "--arrays", "heat", "mesh.gtn", "new.vtu", code=1, says="has no array 'heat'")
gtn("unpack", "--step", "3", "mesh.gtn", "new.vtu", code=1, says="has no time steps")
gtn("unpack", "--time", "3", "mesh.gtn", "new.vtu", code=1, says="has no time steps")

# Output.
gtn("pack", "mesh.vtu", "mesh.gtn", code=1, says="gtn: mesh.gtn: exists; use -f to overwrite it")
gtn("unpack", "mesh.gtn", "mesh.vtu", code=1, says="gtn: mesh.vtu: exists")
gtn("pack", "-f", "mesh.vtu", "folder", code=2)
os.mkdir("folder.gtn")
gtn("pack", "-f", "mesh.vtu", "folder.gtn", code=1, says="gtn: folder.gtn: is a folder")
gtn("pack", "mesh.vtu", "nowhere/new.gtn", code=1, says="there is no folder nowhere")
gtn("unpack", "mesh.gtn", "nowhere/new.vtu", code=1, says="there is no folder nowhere")
gtn("pack", "-f", "bad.vtu", "mesh.gtn", code=1)
with open("mesh.gtn", "rb") as file:
    assert file.read() == good, "a failed pack changed the file"
assert not [name for name in os.listdir(".") if name.startswith("new")], "half a file is left"

# Replacing works when asked for.
gtn("pack", "-f", "mesh.vtu", "mesh.gtn", says="tetrahedra")
assert gtn("pack", "-q", "-f", "mesh.vtu", "mesh.gtn") == ""

# A read-only file is not replaced, not even with -f.
write(standard_mesh(2), "other.vtu")
for out in ("mesh.gtn", "back.vtu"):
    command = ("pack", "other.vtu") if out == "mesh.gtn" else ("unpack", "mesh.gtn")
    if out == "back.vtu":
        gtn("unpack", "mesh.gtn", out)
    os.chmod(out, 0o444)
    with open(out, "rb") as file:
        old = file.read()
    gtn(*command, out, code=1, says=f"gtn: {out}: exists; use -f to overwrite it")
    with open(out, "rb") as file:
        assert file.read() == old
    gtn(command[0], "-f", *command[1:], out, code=1, says=f"gtn: {out}: is read-only")
    with open(out, "rb") as file:
        assert file.read() == old
    os.chmod(out, 0o644)
    gtn(command[0], "-f", *command[1:], out, says="tetrahedra")
gtn("verify", "mesh.gtn", "other.vtu", says="identical")

if os.geteuid() == 0:
    print("the rest is not for root")
else:
    os.chmod("folder", 0o555)
    gtn("pack", "mesh.vtu", "folder/new.gtn", code=1, says="gtn: folder/new.gtn: ")
    gtn("unpack", "mesh.gtn", "folder/new.vtu", code=1, says="gtn: folder/new.vtu: ")
    os.chmod("folder", 0o755)
    os.chmod("mesh.vtu", 0)
    gtn("pack", "mesh.vtu", "new.gtn", code=1, says="gtn: mesh.vtu: Permission denied")

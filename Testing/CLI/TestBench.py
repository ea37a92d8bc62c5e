# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""bench measures all formats at all numbers of threads, and leaves no files behind."""

import json
import os

from gatunCli import enter_folder, gtn, standard_mesh, write

enter_folder("bench")
write(standard_mesh(6), "mesh.vtu")
os.mkdir("work")
arguments = ("bench", "--repeat", "3", "--threads", "1,2", "--folder", "work", "mesh.vtu")
result = json.loads(gtn(*arguments, "--json"))
assert result["cells"] == 1296
assert [file["format"] for file in result["files"]] == ["gtn", "vtu-raw", "vtu-zlib", "vtu-lzma"]
assert len(result["loads"]) == 8
for load in result["loads"]:
    assert len(load["seconds"]) == 3 and load["threads"] in (1, 2)
    assert sorted(load["seconds"])[1] == load["median"]
    assert load["format"] != "gtn" or load["timesGtn"] == 1
assert "threads" in gtn(*arguments)
assert os.listdir("work") == []
gtn("bench", "--folder", "nowhere", "mesh.vtu", code=1, says="gtn: nowhere/gtn-bench-")

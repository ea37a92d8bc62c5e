# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The examples of Documentation/format.md are right: gtn_decoder decodes them as they say."""

import os
import re
import sys
from types import SimpleNamespace as Record

SKIPPED = 125

try:
    from gtn_decoder import Decoder
except ImportError as error:
    print(error)
    sys.exit(SKIPPED)

from gtn_bytes import step_limit, table_limit, unpack
from gtn_coding import FLOAT32, Domain
from gtn_tree import decode_merges
from gtn_walk import Geometry, Walk

data = os.environ["GATUN_TEST_DATA"]
with open(os.path.join(data, "..", "..", "Documentation", "format.md"), encoding="utf-8") as file:
    text = file.read()
of_file = text[text.index("\n### 12.1") : text.index("\n### 12.2")]
of_walk = text[text.index("\n### 12.2") : text.index("\n## 13 ")]
of_tree = text[text.index("\n### 13.7") : text.index("\n### 13.8")]
of_seam = text[text.index("\n### 13.8") : text.index("\n### 13.9")]
of_dependencies = text[text.index("\n### 13.9") : text.index("\n## 14 ")]
of_layers = text[text.index("\n### 14.3") : text.index("\n## 15 ")]
of_cells = text[text.index("\n### 15.4") : text.index("\n## 16 ")]

# The file is a hex dump with offsets.
dump = re.search("```\n(0000  .*?)```", of_file, re.DOTALL)[1]
decoder = Decoder(bytes.fromhex("".join(line[6:] for line in dump.splitlines())))
decoder.container.verify_layout()
assert decoder.points().tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
assert decoder.tets().tolist() == [[0, 1, 2, 3]]
assert [array.name for array in decoder.meta.arrays] == ["T"]
assert decoder.array(0, 0).tolist() == [[20], [21], [22], [24]]

# The walk is given by two streams, a table of vertices, tetrahedra and the edge log.
streams = re.search("```\n([0-9a-f \n]*)\n\n([0-9a-f \n]*)```", of_walk)
connectivity, geometry = [bytes.fromhex(streams[i]) for i in (1, 2)]
chunk = Record(tets=6, own_points=8, box=[(0.0, 5.0)] * 3)
domains = [Domain(FLOAT32)] * 3
walk = Walk(chunk, connectivity, Geometry(geometry, domains), domains, [], [])

rows = re.findall(r"^\| (\d) \| (\d \d \d) \| (.*) \|$", of_walk, re.MULTILINE)
assert len(rows) == len(walk.keys)
for (_, coordinates, rest), key, record in zip(rows, walk.keys, walk.records):
    assert [float(x) for x in coordinates.split()] == [domains[0].to_value(k) for k in key]
    if record.is_seed:
        assert rest.split()[0] == "seed"
    else:
        known = " ".join(map(str, record.known))
        assert rest == "%s | %d | %d" % (known, record.edge_grade, record.candidates)

sentence = re.search(r"The tetrahedra, with parents: (.*?)\.\n", of_walk, re.DOTALL)[1]
made = ["%d %d %d %d" % tet for tet in walk.tets]
parents = ["-" if parent is None else str(parent) for parent in walk.parents]
assert ", ".join("%s (%s)" % pair for pair in zip(made, parents)) == " ".join(sentence.split())

log = re.search(r"The edge log: (.*?)\.\n", of_walk, re.DOTALL)[1]
assert ", ".join("%d-%d" % pair for pair in walk.edge_log) == " ".join(log.split())

# Tables and stream of a tree, and what its merges make of a mesh.
with open(os.path.join(data, "Golden", "two_tets.gtn"), "rb") as file:
    decoder = Decoder(file.read())
container = decoder.container
places = {section.name: slice(section.offset, section.offset + section.length)
          for section in container._directory()}
rows = re.findall(r"^\| ([0-9a-f ]+) \|", of_tree, re.MULTILINE)
content = unpack(container.data[places[b"TREE"]], table_limit)
assert bytes.fromhex("".join(rows)) == content and "TREE, %d bytes" % len(content) in of_tree
dumps = [bytes.fromhex(dump) for dump in re.findall(r"`([0-9a-f \n]{20,})`", of_tree)]
assert dumps[0] == unpack(container.data[places[b"TRNG"]], step_limit)
assert dumps[1] == container.stream(container.tree.parts[0].stream)
sentence = re.search(r"The merges: (.*?)\.\n", of_tree)[1]
merges = decode_merges(dumps[1], 5, 2)
assert ", ".join("%d %d (%g)" % merge for merge in merges) == sentence
assert merges == decoder.merges
merges_of_tets = merges
assert decoder.points().tolist() == [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [1, 1, 1]]
assert decoder.tets().tolist() == [[0, 1, 2, 3], [1, 2, 3, 4]]
assert decoder.array(0, 0).ravel().tolist() == [20, 21, 24, 29, 36]
assert decoder.after(1).kept == [0, 1, 2, 3] and decoder.after(1).tets.tolist() == [[0, 1, 2, 3]]
assert decoder.after(2).kept == [1, 2, 3] and len(decoder.after(2).tets) == 0

# The merges of a surface, two of which belong together.
with open(os.path.join(data, "Golden", "seam.gtn"), "rb") as file:
    decoder = Decoder(file.read())
stream = bytes.fromhex(re.search(r"`([0-9a-f \n]{20,})`", of_seam)[1])
assert stream == decoder.container.stream(decoder.container.tree.parts[0].stream)
bonds = []
merges = decode_merges(stream, 8, 3, bonds)
assert merges == decoder.merges and bonds == [1, 0, 0]
sentence = " ".join(re.search(r"The merges: (.*?)\.\n", of_seam, re.DOTALL)[1].split())
assert sentence == ", ".join("%d %d (%g%s)" % (*merge, ", bound" if bond else "")
                             for merge, bond in zip(merges, bonds)), (merges, bonds)
assert len(decoder.cells()) == 4
assert len(decoder.after(2).tets) == 2 and len(decoder.after(3).tets) == 1

# The dependencies of the two merges of the first tree.
with open(os.path.join(data, "Golden", "two_tets.gtn"), "rb") as file:
    decoder = Decoder(file.read())
stream = bytes.fromhex(re.search(r"`([0-9a-f \n]{20,})`", of_dependencies)[1])
assert stream == decoder.container.stream(decoder.container.tree.parts[0].dependencies)
assert "DEPS, %d bytes" % len(stream) in of_dependencies
assert decoder.merges == merges_of_tets and decoder.dependencies == [[], [0]]

# Layers: the bytes of the table are those of the golden file.
with open(os.path.join(data, "Golden", "two_layers.gtn"), "rb") as file:
    golden = file.read()
at = golden.index(b"LAYR")
length = int.from_bytes(golden[at + 8 : at + 16], "little")
content = unpack(golden[at + 24 : at + 24 + length], table_limit)
rows = re.findall(r"^\| ([0-9a-f ]+) \| ", of_layers, re.MULTILINE)
assert bytes.fromhex("".join(rows)) == content and "LAYR, %d\nbytes" % len(content) in of_layers
assert "Bounds[0] %g |" % Decoder(golden).container.layers.bounds[0] in of_layers

# Cells: likewise.
with open(os.path.join(data, "Golden", "two_cells.gtn"), "rb") as file:
    golden = file.read()
at = golden.index(b"CELL")
length = int.from_bytes(golden[at + 8 : at + 16], "little")
content = unpack(golden[at + 24 : at + 24 + length], table_limit)
rows = re.findall(r"^\| ([0-9a-f ]+) \| ", of_cells, re.MULTILINE)
assert bytes.fromhex("".join(rows)) == content and "CELL, %d bytes" % len(content) in of_cells
cells = Decoder(golden).cells()
assert [kind for kind, _, _ in cells] == [12, 13]
assert len(set(cells[0][1]) & set(cells[1][1])) == 3

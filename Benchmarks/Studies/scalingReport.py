# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page of the model of scalingModel.py, with what runScaling.py has measured."""

from statistics import median

import benchmarkText
import scalingModel as model
import scalingText
from benchmarkText import image, number, paragraph, ratio, table
from scalingText import amount, duration, power, size

PAGE = "scaling"


def _head(results):
    return """# Scaling

What meshes of 10^9 and 10^12 cells take on 1 to 10,000 ranks: bytes, seconds, memory, messages, and where the
design stops scaling. No such machine was at hand. The numbers are those of a model, whose constants are
measured and which is [compared](#the-model-and-measurements) with what was measured. `Utilities/bench.sh
--scaling` (Benchmarks/Studies/runScaling.py) measures what other studies do not and writes this page. All
results are in [results.json](scaling/results.json), and in those of [meshes larger than
memory](parts-study.md) and of [several processes](parallel-study.md).

""" + benchmarkText.machine(results, "")


def _table_rows(tables):
    rows = []
    for one in tables:
        chunks = one["chunks"]
        rows.append([one["chunk"] or "usual", f"{chunks:,}",
                     number(one["groups"] / chunks) if "groups" in one else "",
                     number(one["members"] / chunks) if "members" in one else "",
                     number(model.table_bytes(one) / chunks), size(model.bytes_read(one)),
                     size(model.kept(one)), duration(model.opening(one))])
    return rows


def _tables(results, k):
    names = sorted({name for one in results["tables"] for name in one["sections"]} - set(model.STREAMS))
    text = "## Tables of many chunks\n\n" + paragraph(f"""A lattice of {results["tables"][0]["tets"]:,}
        tetrahedra with a field on its points, in chunks of at most so many tetrahedra. A *group* is the
        points that the same chunks share; a *member* is a chunk of a group. The tables are all sections
        but those of streams: {", ".join(names)}, with headers. Opening is `UpdateInformation` of a new
        `vtkGatunReader`; its memory is what the process keeps.""") + "\n" + table(
            ["tetrahedra", "chunks", "groups a chunk", "members a chunk", "tables, bytes a chunk",
             "opening reads", "its memory", "its time"], _table_rows(results["tables"]))
    text += "\n" + paragraph(f"""So a chunk of {k.tables.row["chunk"]} tetrahedra adds
        {number(k.tables.disk)} bytes to the tables, {size(k.tables.memory)} to the memory of opening and
        {duration(k.tables.seconds)} to its time. Its number of neighbors is that of a large chunk.""")
    if k.before:
        known = results["before"]["machine"]
        text += "\n" + paragraph(f"""Before tables came in pages (commit {known["commit"]}), they were read
            as a whole: {number(k.before.disk)} bytes, {size(k.before.memory)} and
            {duration(k.before.seconds)}.""") if scalingText.is_paged(k) else ""
    return text


def _time(seconds):
    return duration(seconds) if seconds > 0 else "less than the noise"


def _constants(k):
    parts, parallel = "[parts](parts-study.md)", "[processes](parallel-study.md)"
    here = "this page"
    rows = [
        ["b", "bytes of the file a cell", number(k.bytes), parts],
        ["s", "processor time a cell, both passes, without the source", duration(k.seconds), parallel],
        ["m", "memory of the mesh a cell, in VTK", f"{number(k.share)} bytes", parallel],
        ["e", "memory beside it", f"{size(k.fixed)} + {ratio(k.beside)} of the share", parallel],
        ["c", "bytes that a rank sends for its boundary, by (n/r)^(2/3)", number(k.boundary), parallel],
        ["p", "messages from a rank to another one, with one round each", number(k.pair), here],
        ["g", "bytes of groups a chunk, to each rank", number(k.groups), here],
        ["t", "bytes of tables a chunk, to rank 0", number(k.gathered), here],
        ["M, M0", "memory of tables a chunk, in each rank and in rank 0",
         f"{size(k.memory)}, {size(k.memory_first)}", here],
        ["a", "processor time of agreeing on groups a chunk, in each rank", _time(k.agreeing), here],
        ["f", "processor time of making the tables a chunk, in rank 0", _time(k.assembling), here],
        ["d, R", "tables on the disk a chunk, and what is read of them in opening",
         f"{number(k.tables.disk)} bytes, {number(k.tables.read)} bytes", here],
        ["o, O", "memory and time of opening a chunk",
         f"{size(k.tables.memory)}, {_time(k.tables.seconds)}", here]]
    return "## Constants\n\n" + paragraph("""Constants of chunks are differences of files with chunks of
        several sizes, and the smallest ones of the rounds. Messages were counted by the monitoring of
        Open MPI.""") + "\n" + table(
            ["", "constant", "value", "from"], rows)


def _formulas():
    rules = (
        f"""Chunks: C = r ceil(n / r / limit). The limit is {model.USUAL_CHUNK:,} cells,
        {model.MEDIUM_CHUNK:,} in parts of more than {model.MEDIUM_MESH:,}, and {model.LARGE_CHUNK:,} in parts
        of more than {model.LARGE_MESH:,}.""",
        """File: b n + d C bytes. Encoding: s n / r.""",
        """Memory of a rank: its share m n / r, e beside it, and M C for the tables of *all* chunks, because
        all ranks make the same blocks. Up to three times `SpillMemory` is included in e only as far as it
        was measured.""",
        f"""Boundaries: (1 - 1/r) c (n/r)^(2/3) bytes are sent by a rank, in rounds of {model.ROUND // 2**20}
        MiB, to ranks that a hash names: each rank to each.""",
        """Groups: each rank sends those of its chunks to all, and gets g C bytes. Agreeing on them takes a C
        of time.""",
        """Messages of a rank: (r - 1) (p + 4 (rounds - 1)): the length and the contents, for the points and
        for what became of them. Each broadcast and collective call takes log2(r) messages, one after the
        other.""",
        f"""Rank 0: t C bytes of tables, M0 C of memory, in place of M C, and f C of time. Values of
        {model.COMPONENTS} components that have at most {model.PALETTE:,} different ones in a rank come to
        it, too, {model.KEY} bytes each; all are taken for different. Their memory is needed before that of tables.""",
        """Writing: the file once to the temporary files of ranks. Copying: the same bytes are read and
        written again.""",
        """Opening: R C bytes read, o C of memory and O C of time in each process.""")
    return "## Formulas\n\n" + paragraph("""n cells on r ranks, each with one part, one thread and a processor;
        one time step with a field on the points. Parts are compact. The source of the parts is asked
        twice, which is not included.""") + "\n" + "".join(map(scalingText.bullet, rules)) + "\n" \
        + paragraph(f"""Assumed, not measured: a file system with {model.FILES / 1e9:.0f} GB/s for all ranks
        and {model.FILES_OF_RANK / 1e9:.0f} GB/s for one, a network with {model.NETWORK / 1e9:.0f} GB/s into
        a rank, and {model.LATENCY * 1e6:.0f} us for each message.""")


def _comparison(k):
    form = {"count": amount, "bytes": size, "seconds": duration}
    rows = [[case, what + (" *" if own else ""), form[kind](measured), form[kind](predicted),
             ratio(predicted / measured) if measured else ""]
            for case, what, measured, predicted, kind, own in model.compare(k)]
    return "## The model and measurements\n\n" + paragraph("""Rows with a star have supplied constants;
        the others are checks. Constants were averaged where several rows have supplied one. The load of
        the machine during other studies is on their pages. Sent bytes depend on the
        shape of the boundary: a cut through a lattice meets fewer points
        than one through an irregular mesh. More ranks than processors take turns.
        A rank has more of the tables of its own chunks than of others, which the model does not tell
        apart.""") + "\n" + table(
            ["case", "quantity", "measured", "model", "model / measured"], rows)


def _pieces(k):
    largest = [mesh for mesh in k.parts["large"] if "tets" in mesh][-1]
    return f"""One process has written {largest["tets"]:,} cells in {largest["pieces"]} parts with
        {size(largest["steps"][0]["peak"])}."""


def _writing(k):
    rows = []
    for one in predictions(k):
        rows.append([power(one.cells), f"{one.ranks:,}", amount(one.chunks), duration(one.stages["encoding"]),
                     duration(one.seconds), f"{100 * one.efficiency:.0f} %", size(one.share),
                     size(one.beside), size(one.tables)])
    return "## Writing\n\n" + paragraph(f"""*Time* is that of all stages, one after the other. *Efficiency* is
        the part of it in which cells are encoded. A share that does not fit into the memory is written in
        several parts by `gatun::PartWriter`, as on one process; then the memory is that of a part, and
        the tables remain. {_pieces(k)}""") + "\n" + table(
            ["cells", "ranks", "chunks", "encoding", "time", "efficiency", "share a rank", "beside it",
             "tables a rank"], rows)


def _messages(k):
    rows = []
    for one in predictions(k):
        if one.ranks > 1:
            rows.append([power(one.cells), f"{one.ranks:,}", one.rounds, amount(one.messages),
                         amount(one.messages * one.ranks), size(one.boundary), size(one.groups),
                         duration(one.stages["messages"])])
    return "## Messages\n\n" + paragraph("""Of a rank, except *all messages*. *Rounds* are those of the
        exchange of boundary points; in each one, every rank sends to every other one.""") + "\n" + table(
            ["cells", "ranks", "rounds", "messages", "all messages", "boundary, sent", "groups, received",
             "time"], rows)


def _first(k):
    rows = []
    for one in predictions(k):
        if one.ranks > 1:
            rows.append([power(one.cells), f"{one.ranks:,}", size(one.gathered), size(one.first),
                         size(one.palettes), duration(one.stages["tables on rank 0"]),
                         duration(one.stages["agreeing on groups"]), duration(one.stages["copying"])])
    return "## Rank 0, and copying\n\n" + paragraph("""The tables that rank 0 gathers, their memory, the
        values for palettes at most, and the time until the tables are made. Then the time in which each
        rank agrees on the groups of all, and that of copying.""") + "\n" + table(
            ["cells", "ranks", "tables", "memory", "palettes", "time of tables", "agreeing", "copying"], rows)


def _opening(results, k):
    head = ["cells", "ranks", "chunks", "file", "tables", "read", "read by all", "memory", "time"]
    paged = scalingText.is_paged(k)
    if paged:
        head += ["memory before", "time before"]
    rows = []
    for one in predictions(k):
        now = model.predict_opening(k.tables, one.chunks)
        rows.append([power(one.cells), f"{one.ranks:,}", amount(one.chunks), size(one.bytes), size(now.bytes),
                     size(now.read), size(now.read * one.ranks), size(now.memory), duration(now.seconds)])
        if paged:
            before = model.predict_opening(k.before, one.chunks)
            rows[-1] += [size(before.memory), duration(before.seconds)]
    return "## Opening\n\n" + paragraph("""By as many ranks as have written the file: each one reads for itself.
        Pieces of the mesh take further memory, which does not depend on the size of the file.""") \
        + "\n" + table(head, rows)


def _many(results):
    if "many" not in results:
        return ""
    many = results["many"]
    opened = median([one["seconds"] for one in many["opened"]])
    kept = median([one["kept"] for one in many["opened"]])
    rows = [["opening by `vtkGatunReader`", duration(opened), size(kept)]]
    for name, label in (("close", "`gtn render`, near its center"), ("whole", "`gtn render`, the whole mesh")):
        runs = many["images"][name]
        rows.append([label, duration(median([one["seconds"] for one in runs])),
                     size(median([one["peak"] for one in runs]))])
    return "## A file of many chunks\n\n" + paragraph(f"""A lattice of {many["tets"]:,} tetrahedra in
        {many["chunks"]:,} chunks, {size(many["bytes"])}. Its tables are those of {many["chunks"] * 262144:.2g} tetrahedra in chunks of
        the usual size. Memory is what opening keeps, and the peak of `gtn render` with opaque values, from
        its start to the image. About half of the latter are the program and its libraries. The image of the
        whole mesh needs every chunk on its near side, which are very small here.""") + "\n" + table(["", "time", "memory"], rows)


def predictions(k):
    return [model.predict(k, cells, ranks) for cells in model.CELLS for ranks in model.RANKS]


def page(results, plots):
    k = model.constants(results)
    parts = (_head(results), scalingText.stops(k, predictions(k)),
             image(plots, "stages", "Stages of writing by ranks", PAGE),
             image(plots, "memory", "Memory by cells", PAGE),
             scalingText.changes(results, k), _writing(k), _messages(k), _first(k),
             _opening(results, k), _many(results), scalingText.limits(), _tables(results, k), _constants(k), _formulas(),
             _comparison(k))
    return "\n".join(part.rstrip() + "\n" for part in parts if part)


def write(results, out):
    benchmarkText.write_page(results, out, PAGE, page, "scalingPlots")

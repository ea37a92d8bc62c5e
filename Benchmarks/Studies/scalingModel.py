# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A model of what writing and opening a file takes, by the number of cells and of ranks. Its constants are
those of the studies of parts and of several processes, and of runScaling.py."""

import math
import statistics
from types import SimpleNamespace as Record

import generatedParts
import parallelReport

CELLS = (10**9, 10**12)
RANKS = (1, 16, 256, 1000, 10000)

# What is assumed and not measured.
FILES = 10e9  # bytes a second of a file system, for all ranks together
FILES_OF_RANK = 1e9  # and for one
NETWORK = 10e9  # bytes a second that a rank receives
LATENCY = 5e-6  # seconds from a message to the next

# What the writer has fixed: gatunPartition, gatunPartAgreement, gatunPalette.
LARGE_MESH, LARGE_CHUNK, USUAL_CHUNK = 10**7, 262144, 65536
MEDIUM_MESH, MEDIUM_CHUNK = 10**6, 131072
ROUND = 64 * 2**20
PALETTE, KEY = 65536, 8
COMPONENTS = 4  # of the studies' meshes that may have a palette: three coordinates and a field
STREAMS = ("MESH", "VALS")


def chunk_limit(cells):
    """The most cells of a chunk of a part."""
    if cells > LARGE_MESH:
        return LARGE_CHUNK
    return MEDIUM_CHUNK if cells > MEDIUM_MESH else USUAL_CHUNK


def count_chunks(cells, parts, limit=None):
    """Those of equal parts, with the default limit or with another one."""
    part = cells / parts
    return parts * math.ceil(part / (limit or chunk_limit(part)))


# Constants of tables.


def table_bytes(one):
    return sum(size for name, size in one["sections"].items() if name not in STREAMS)


def kept(one):
    return min(opened["kept"] for opened in one["opened"])


def bytes_read(one):
    return min(opened["read"] for opened in one["opened"])


def opening(one):
    return statistics.median(opened["seconds"] for opened in one["opened"])


def per_chunk(tables, one, value):
    """What a chunk adds to a value, beside a file of the same mesh with the usual chunks."""
    usual = tables[-1]
    return max(0, value(one) - value(usual)) / (one["chunks"] - usual["chunks"])


def table_constants(tables):
    """Of chunks of 256 tetrahedra: small enough for many of them, and with as many neighbors as large ones."""
    one = next(table for table in tables if table["chunk"] == 256)
    return Record(disk=per_chunk(tables, one, table_bytes), memory=per_chunk(tables, one, kept),
                  read=per_chunk(tables, one, bytes_read), seconds=per_chunk(tables, one, opening), row=one)


# Constants of writing.


def find_runs(results, ranks, chunk):
    return [run for run in results["ranks"] if run["ranks"] == ranks and run["chunk"] == chunk]


def difference(results, ranks, value):
    """What a chunk of the file adds to a value of a run, by the two sizes of small chunks. The smallest of
    all rounds, as other load on the machine only adds."""
    coarse, fine = (find_runs(results, ranks, chunk) for chunk in
                    sorted({run["chunk"] for run in results["ranks"] if run["chunk"]}, reverse=True))
    more = min(map(value, fine)) - min(map(value, coarse))
    return max(0, more) / (fine[0]["chunks"] - coarse[0]["chunks"])


def to_first(run):
    """The bytes that go to rank 0 only."""
    total = 0
    for rank, seen in enumerate(run["messages"]):
        others = [size for to, size in enumerate(seen["bytes"]) if to not in (0, rank)]
        total += seen["bytes"][0] - statistics.mean(others) if rank > 0 else 0
    return total


def broadcast(run):
    """The bytes that each rank gets by broadcasts, with its own ones."""
    return sum(seen["broadcastBytes"] for seen in run["messages"]) / (run["ranks"] - 1)


def others_memory(run):
    return statistics.mean(one["extra"] for one in run["processes"][1:])


def pair_messages(run):
    """Messages from a rank to another one."""
    return sum(map(sum, (seen["to"] for seen in run["messages"]))) / run["ranks"] / (run["ranks"] - 1)


def own_processor(parallel):
    """The case with most processes, each of which has a processor of its own."""
    return [case for case in parallelReport.compact(parallel)
            if 1 < case["processes"] <= max(2, parallel["machine"]["processors"])][-1]


def median_seconds(case):
    return statistics.median(measured["gtn"]["seconds"] for measured in case["rounds"])


def memory_beside(case):
    """The share of a process and the memory beside it, of the process with most."""
    return max((one["share"], statistics.median(
        measured["gtn"]["processes"][i]["extra"] for measured in case["rounds"]))
        for i, one in enumerate(case["rounds"][0]["gtn"]["processes"]))


def boundary_bytes(case, tets):
    """The constant of bytes that a process sends for its boundary."""
    processes = case["processes"]
    return parallelReport.sent(case) / processes / boundary(tets, processes)


def boundary(cells, ranks):
    """Of compact parts, the boundary grows with the surface; one of the ranks that it goes to is the own."""
    return (1 - 1 / ranks) * (cells / ranks) ** (2 / 3)


def constants(results):
    parts, parallel = generatedParts.load("parts-study"), generatedParts.load("parallel-study")
    several = [case for case in parallelReport.compact(parallel) if case["processes"] > 1]
    timed = own_processor(parallel)
    smaller = next(mesh for mesh in parts["large"] if "tets" in mesh)
    grow, fixed = statistics.linear_regression(*zip(*map(memory_beside, several)))
    ranks = sorted({run["ranks"] for run in results["ranks"]})
    usual = {count: find_runs(results, count, 0)[0] for count in ranks}
    finest = min(run["chunk"] for run in results["ranks"] if run["chunk"])
    return Record(
        parts=parts, parallel=parallel, usual=usual, smaller=smaller, timed=timed,
        checked=[*usual.values(), *(find_runs(results, count, finest)[0] for count in ranks)],
        tables=table_constants(results["tables"]), usual_file=results["tables"][-1],
        opened=results["tables"][:-1],
        before=table_constants(results["before"]["tables"]) if results.get("before") else None,
        bytes=smaller["bytes"] / smaller["tets"],
        seconds=median_seconds(timed) * timed["processes"] * timed["rounds"][0]["gtn"]["threads"]
        / parallel["tets"],
        share=parallelReport.share(timed) * timed["processes"] / parallel["tets"],
        beside=max(0, grow), fixed=max(0, fixed),
        boundary=statistics.mean(boundary_bytes(case, parallel["tets"]) for case in several),
        points=sum(one["points"] for one in usual[ranks[0]]["processes"]) / usual[ranks[0]]["tets"],
        surveyed=min(one["survey"] for one in usual[ranks[0]]["processes"]) / usual[ranks[0]]["seconds"],
        groups=difference(results, ranks[-1], broadcast),
        gathered=difference(results, ranks[-1], to_first) * ranks[-1] / (ranks[-1] - 1),
        memory=difference(results, ranks[-1], others_memory),
        memory_first=difference(results, ranks[-1], lambda run: run["processes"][0]["extra"]),
        agreeing=difference(results, ranks[-1], lambda run: min(
            one["agreement"] for one in run["processes"])),
        assembling=difference(results, ranks[-1], lambda run: run["processes"][0]["finish"]),
        pair=pair_messages(usual[ranks[-1]]),
        collectives=statistics.mean(seen["collectives"] for seen in usual[ranks[-1]]["messages"]),
        broadcasts=statistics.mean(seen["broadcasts"] for seen in usual[ranks[-1]]["messages"]),
        ranks=ranks)


# Predictions.


def palettes(k, cells, ranks):
    """The bytes of different values that a rank sends, if all of its values are different."""
    points = k.points * cells / ranks
    return COMPONENTS * KEY * points if points <= PALETTE else 0


def rounds(k, cells, ranks):
    """Of the exchange of boundary points, as of that of what became of them."""
    return max(1, math.ceil(k.boundary * (cells / ranks) ** (2 / 3) / ROUND))


def sent(k, cells, ranks, chunks):
    """The bytes that a rank sends; a broadcast counts for each receiver."""
    if ranks == 1:
        return 0
    return (k.boundary * boundary(cells, ranks) + k.groups * chunks / ranks * (ranks - 1)
            + k.gathered * chunks / ranks + palettes(k, cells, ranks))


def beside(k, cells, ranks):
    """The memory that a rank takes beside its share, without tables."""
    return k.fixed + k.beside * k.share * cells / ranks


def gathered_palettes(k, cells, ranks):
    """The bytes of values that come to rank 0."""
    return palettes(k, cells, ranks) * (ranks - 1)


def first_memory(k, cells, ranks, chunks):
    """The memory of rank 0 beside that of all ranks: for palettes, and later for tables."""
    return max(k.memory_first * chunks, gathered_palettes(k, cells, ranks))


def seconds_of(k, cells, processors):
    return cells * k.seconds / processors


def predict(k, cells, ranks):
    """Ranks with one thread and a processor each, and one part each."""
    chunks = count_chunks(cells, ranks)
    several = ranks > 1
    size = k.bytes * cells + k.tables.disk * chunks
    bandwidth = min(FILES, ranks * FILES_OF_RANK)
    turns = rounds(k, cells, ranks)
    messages = (ranks - 1) * (k.pair + 4 * (turns - 1))
    steps = messages + (k.broadcasts * ranks + k.collectives) * math.ceil(math.log2(ranks))
    received = k.boundary * boundary(cells, ranks) + k.groups * chunks * several
    one = Record(cells=cells, ranks=ranks, chunks=chunks, bytes=size, share=k.share * cells / ranks,
                 beside=beside(k, cells, ranks), tables=k.memory * chunks, rounds=turns,
                 messages=messages, boundary=k.boundary * boundary(cells, ranks),
                 groups=k.groups * chunks * several, gathered=k.gathered * chunks * several,
                 first=k.memory_first * chunks,
                 palettes=gathered_palettes(k, cells, ranks))
    one.stages = {
        "encoding": seconds_of(k, cells, ranks),
        "agreeing on groups": k.agreeing * chunks,
        "messages": steps * LATENCY + received / NETWORK,
        "tables on rank 0": k.assembling * chunks + (one.gathered + one.palettes) / NETWORK,
        "writing": size / bandwidth,
        "copying": 2 * size / bandwidth * several,
    }
    one.seconds = sum(one.stages.values())
    one.efficiency = one.stages["encoding"] / one.seconds
    return one


def predict_opening(tables, chunks):
    return Record(bytes=tables.disk * chunks, read=tables.read * chunks, memory=tables.memory * chunks,
                  seconds=tables.seconds * chunks)


# Comparison with what was measured.


def compare(k):
    """Rows (case, quantity, measured, predicted, kind, whether a constant is taken from it)."""
    rows = []
    for mesh in k.parts["large"]:
        if "tets" in mesh:
            rows += _compare_parts(k, mesh)
    for one in k.parts["compared"][1:]:
        case = f"{one['tets']:,} cells in {one['pieces']} pieces"
        rows.append((case, "size of the file", one["bytes"], k.bytes * one["tets"], "bytes", False))
    for case in parallelReport.compact(k.parallel):
        rows += _compare_parallel(k, case)
    for run in k.checked:
        rows += _compare_ranks(k, run)
    for one in k.opened:
        rows += _compare_opening(k, one)
    return rows


def count_ranks(ranks):
    return f"{ranks:,} rank" + ("s" if ranks > 1 else "")


def _compare_parts(k, mesh):
    case = f"{mesh['tets']:,} cells in {mesh['pieces']} pieces"
    step = mesh["steps"][0]
    chunks = count_chunks(mesh["tets"], mesh["pieces"], USUAL_CHUNK)
    return [(case, "chunks", mesh["chunks"], chunks, "count", False),
            (case, "size of the file", mesh["bytes"], k.bytes * mesh["tets"], "bytes",
             mesh is k.smaller),
            (case, "seconds", step["seconds"] - step["making"],
             seconds_of(k, mesh["tets"], k.parts["machine"]["processors"]), "seconds", False)]


def _compare_parallel(k, case):
    processes, tets = case["processes"], k.parallel["tets"]
    name = f"{tets:,} cells, {count_ranks(processes)}, {k.parallel['kind']}"
    threads = processes * case["rounds"][0]["gtn"]["threads"]
    rows = [(name, "seconds", median_seconds(case),
             seconds_of(k, tets, min(threads, k.parallel["machine"]["processors"])), "seconds",
             case is k.timed)]
    if processes > 1:
        chunks = count_chunks(tets, processes)
        rows += [(name, "sent by a rank", parallelReport.sent(case) / processes,
                  sent(k, tets, processes, chunks), "bytes", True),
                 (name, "memory beside the share", memory_beside(case)[1], beside(k, tets, processes),
                  "bytes", True)]
    return rows


def _compare_ranks(k, run):
    tets, ranks, chunks = run["tets"], run["ranks"], run["chunks"]
    name = f"{tets:,} cells, {count_ranks(ranks)}, {chunks:,} chunks"
    is_last = ranks == k.ranks[-1]
    everything = sum(map(sum, (seen["to"] for seen in run["messages"])))
    first, last = run["processes"][0], run["processes"][-1]
    rows = [(name, "sent by a rank", last["sent"], sent(k, tets, ranks, chunks), "bytes", False),
            (name, "memory beside the share, rank 0", first["extra"],
             beside(k, tets, ranks) + first_memory(k, tets, ranks, chunks), "bytes", is_last and run["chunk"]),
            (name, "memory beside the share, last rank", last["extra"],
             beside(k, tets, ranks) + k.memory * chunks, "bytes", is_last and run["chunk"])]
    if run["chunk"] == 0:
        rows = [(name, "chunks", chunks, count_chunks(tets, ranks), "count", False),
                (name, "messages of a rank", everything / ranks, (ranks - 1) * k.pair, "count", is_last),
                *rows]
    return rows


def _compare_opening(k, one):
    more = one["chunks"] - k.usual_file["chunks"]
    name = f"{one['tets']:,} cells, opened, {one['chunks']:,} chunks"
    own = one is k.tables.row
    return [(name, "memory", kept(one), kept(k.usual_file) + k.tables.memory * more, "bytes", own),
            (name, "seconds", opening(one), opening(k.usual_file) + k.tables.seconds * more, "seconds", own)]

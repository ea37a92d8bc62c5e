# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""What the page of scaling says about the numbers of the model, and how it writes them."""

import math

import scalingModel as model
from benchmarkText import number, paragraph, table


def size(value):
    """Bytes with a unit; 1,000 GiB are still GiB."""
    for unit in ("bytes", "KiB", "MiB", "GiB"):
        if abs(value) < 1000:
            return f"{number(value) if value % 1 or value >= 1000 else round(value)} {unit}"
        value /= 1024
    return f"{number(value)} TiB"


def duration(seconds):
    """A time with a unit."""
    for limit, unit, name in ((0.9995e-6, 1e-9, "ns"), (0.9995e-3, 1e-6, "us"), (0.9995, 1e-3, "ms"),
                              (600, 1, "s"), (36000, 60, "min"), (172800, 3600, "h")):
        if seconds < limit:
            return f"{number(seconds / unit)} {name}" if seconds else "0 s"
    return f"{number(seconds / 86400)} days"


def amount(value):
    """A number of things; large ones as 1.23e9."""
    return f"{value:,.0f}" if value < 1e7 else f"{value:.2e}".replace("e+0", "e").replace("e+", "e")


def power(value):
    exponent = round(math.log10(value))
    return f"10^{exponent}" if value == 10**exponent else f"{value:,}"


def case(one):
    return f"{power(one.cells)} cells on {model.count_ranks(one.ranks)}"


def listed(texts):
    texts = list(texts)
    return texts[0] if len(texts) == 1 else ", ".join(texts[:-1]) + " and " + texts[-1]


def bullet(text):
    lines = paragraph(text).splitlines()
    return "- " + "\n  ".join(lines) + "\n"


def is_paged(k):
    """Whether tables are read in pages, by what opening takes."""
    return k.before is not None and k.tables.memory < k.before.memory / 2


def _efficiency(predictions):
    slow = [one for one in predictions if one.efficiency < 0.5]
    if not slow:
        return "Encoding takes more than half of the time in all cases of the model."
    return f"Encoding takes less than half of the time for {listed(map(case, slow))}."


def _stages(one):
    stages = sorted(one.stages.items(), key=lambda stage: -stage[1])
    return listed(f"{name} {duration(seconds)}" for name, seconds in stages if seconds > 0)


def stops(k, predictions):
    most = predictions[-1]
    small = [one for one in predictions if one.cells == predictions[0].cells][-1]
    worst = max(predictions, key=lambda one: one.palettes)
    later = model.predict_opening(k.tables, most.chunks)
    parts = ["## Where it stops scaling\n", paragraph(f"""{_efficiency(predictions)} The time of
        {case(most)}: {_stages(most)}. That of {case(small)}: {_stages(small)}. What grows with the whole mesh
        or with the ranks, and not with the share of a rank:""")]
    parts.append("".join(map(bullet, (
        f"""**Tables in each rank.** All ranks make the tables of all chunks when they have agreed on the groups
        of shared points: {size(most.tables)} for {case(most)}, where the share is {size(most.share)}, and
        {size(small.tables)} for {case(small)}, with a share of {size(small.share)}. This limits the number of
        cells, whatever the number of ranks.""",
        f"""**Groups go to all.** For that, each rank receives the groups of all chunks: {size(most.groups)} for
        {case(most)}, {size(most.groups * most.ranks)} in all ranks together.""",
        f"""**Rank 0 makes the directory.** It gathers {size(most.gathered)} of tables for {case(most)}, which
        take {size(most.first)} of memory and {duration(most.stages["tables on rank 0"])}. The others
        wait. Up to {size(worst.palettes)} of values for palettes come to it before ({case(worst)}), if each rank
        has no more than {model.PALETTE:,} points with different values.""",
        f"""**All to all.** Points on boundaries go to ranks that a hash names, so that every rank sends to
        every other one: {amount(small.messages * small.ranks)} messages in all for {case(small)},
        {amount(most.messages * most.ranks)} for {case(most)}, with {most.rounds} rounds. A rank has
        {amount(most.messages)} of them, one after the other. The bytes are few: {size(most.boundary)} a
        rank.""",
        f"""**Two passes over the source.** Each part is made twice, once for the survey. That took
        {100 * k.surveyed:.0f} % of the time of {min(k.ranks)} ranks here, without making the parts. A source
        that computes its parts again takes its time twice. A solver that has them in memory does not.""",
        f"""**Bytes are copied down twice.** Each rank writes into a temporary file, because it does not know
        its place in the file, and copies it there: {duration(most.stages["copying"])} beside
        {duration(most.stages["writing"])} of writing for {case(most)}.""",
        f"""**Opening** reads something of every chunk: {size(later.read)}, which take {size(later.memory)} of
        memory and {duration(later.seconds)} in each process, for {case(most)}. As many ranks read
        {size(later.read * most.ranks)} together, since each one reads for itself."""))))
    return "\n".join(parts)


def changes(results, k):
    most = model.predict(k, model.CELLS[-1], model.RANKS[-1])
    now = model.predict_opening(k.tables, most.chunks)
    done = [f"""Chunks have up to {model.LARGE_CHUNK:,} cells in parts of more than
        {power(model.LARGE_MESH)}, in place of {model.USUAL_CHUNK:,}: a fourth of the chunks and of their
        tables.""",
            """Shared points are stored in groups by the chunks that share them, and small groups with the same
        first chunk in one block: the tables of a chunk depend on its neighbors and not on its points.""",
            """Boundary points are not gathered. They are exchanged in rounds of bounded size, and sorted on the
        disk if they exceed `SpillMemory`.""",
            """Offsets, numbers of points and of cells have 64 bits in the file, and original numbers where 32
        are not enough."""]
    if is_paged(k):
        before = model.predict_opening(k.before, most.chunks)
        done.insert(0, f"""Tables come in pages of 256 chunks. Opening a file reads a summary of each chunk; the
            rest is read when it is needed, and kept in a cache of pages. To open the file of {case(most)}
            takes {size(now.memory)} and {duration(now.seconds)}; it took {size(before.memory)} and
            {duration(before.seconds)} when tables were read as a whole ({size(k.before.memory)} and
            {duration(k.before.seconds)} a chunk).""")
    following = [
        f"""Ranks that keep only the tables of chunks that they or their neighbors have: saves nearly all of
        {size(most.tables)} a rank for {case(most)}, the groups that go to all, and
        {duration(most.stages["agreeing on groups"])}.""",
        f"""Streams that stay in memory until their place is known: {size(k.bytes * most.cells / most.ranks)} a
        rank, {100 * k.bytes / k.share:.1f} % of its share. Saves {duration(most.stages["copying"])} of
        copying.""",
        f"""Tables that each rank writes itself, so that rank 0 has the directory only: saves
        {duration(most.stages["tables on rank 0"])} in which the others wait, and {size(most.first)} in
        rank 0.""",
        """Values for palettes that are joined along a tree of ranks, and given up as soon as there are too
        many.""",
        f"""One rank of each node that reads the summary of a file for the others: saves nearly all of
        {size(now.read * most.ranks)}.""",
        f"""Records of boundaries that go to ranks whose boxes touch, in place of {amount(most.ranks - 1)}
        others: messages by neighbors."""]
    if not is_paged(k):
        following.insert(0, f"""Tables that are read in pages, on demand: opening the file of {case(most)} takes
            {size(now.memory)} and {duration(now.seconds)}, since they are read as a whole.""")
    return "## What was changed because of it\n\n" + "".join(map(bullet, done)) \
        + "\n## What would be next\n\n" \
        + "".join(map(bullet, following))


def limits():
    most = (2**32 - 2) * model.LARGE_CHUNK
    rows = [["points, cells, offsets and lengths of a file", "2^64 - 1", "varints and u64 in the tables"],
            ["points or cells of a part", "2^32 - 16", "a rank has one part; the core takes several"],
            ["chunks of a file", "2^32 - 2", f"{most:.1e} cells".replace("e+", "e")
             + f" in chunks of {model.LARGE_CHUNK:,}"],
            ["groups of points between parts", "2^32 - 1", "records have 32 bits"],
            ["points of a block of shared points", "2^32 - 1", "chunks share surfaces, so blocks are small"],
            ["chunks that share points with a chunk, on average", "1,024", "more in files of few chunks"],
            ["points that no cell uses, in all parts", "2^32 - 1", "they are one block"],
            ["points of a mesh with a hierarchy", "2^32 - 1",
             "the order of merges needs the whole mesh in one process"],
            ["bytes of a message", "2^64 - 1", "MPI counts with 32 bits: sent in pieces of 64 MiB"]]
    return "## Limits of numbers\n\n" + paragraph("""What exceeds a limit of 32 bits is refused with a
        message, and nothing is written.""") + "\n" + table(["what", "limit", "note"], rows)

# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page of the results of runDetail.py."""

import math
import statistics

import benchmarkText
from benchmarkText import image, paragraph, table

PAGE = "detail-study"
NAMES = {"delaunay": "Delaunay mesh of a ball", "flow1": "structured grid around a nose",
         "lattice": "jittered lattice"}


def name_of(mesh):
    return NAMES.get(mesh["name"], mesh["name"])


def tets_at(ladder, rms):
    """Tetrahedra at which a ladder of levels has an error, interpolated in logarithms; None beyond
    its ends. The ladder begins with the whole mesh, which has no error."""
    points = sorted((max(one["rms"], 1e-9), one["tets"]) for one in ladder)
    for (low, more), (high, fewer) in zip(points, points[1:]):
        if low <= rms <= high and high > low:
            part = (math.log(rms) - math.log(low)) / (math.log(high) - math.log(low))
            return math.exp(math.log(more) + part * (math.log(fewer) - math.log(more)))
    return None


def rms_at(ladder, tets):
    """The error that a ladder has with so many tetrahedra; None beyond its ends."""
    points = sorted((one["tets"], max(one["rms"], 1e-9)) for one in ladder)
    for (few, worse), (many, better) in zip(points, points[1:]):
        if few <= tets <= many and many > few:
            part = (math.log(tets) - math.log(few)) / (math.log(many) - math.log(few))
            return math.exp(math.log(worse) + part * (math.log(better) - math.log(worse)))
    return None


def _picture_rows(results):
    for mesh in results["meshes"]:
        for place in mesh["pictures"]["places"]:
            for one in place["view"]:
                same = tets_at(place["uniform"], one["rms"])
                rms = rms_at(place["uniform"], one["tets"])
                yield [name_of(mesh), f"{place['part']:.2f}", f"{one['points']:,}",
                       f"{one['tets']:,}", f"{one['rms']:.2f}",
                       f"{rms:.2f}" if rms else "-",
                       f"{same:,.0f}" if same else "-",
                       f"{one['tets'] / same:.2f}" if same else "-"]


def _update_rows(results):
    for mesh in results["meshes"]:
        for place in mesh["pictures"]["places"]:
            updates = place["updates"]
            yield [name_of(mesh), f"{place['part']:.2f}", f"{updates['points']:,}",
                   f"{1000 * statistics.median(updates['cut']):.1f}",
                   f"{1000 * statistics.median(updates['blocks']):.1f}",
                   f"{100 * statistics.median(updates['again']):.0f} %"]


def in_time(flight):
    return sum(s <= 1.25 * flight["budget"] for s in flight["seconds"]) / len(flight["seconds"])


def way_of(flight):
    if flight["uniform"]:
        return "uniform, fewer rays"
    return "for the view, all rays" if flight["onlyPoints"] else "for the view, fewer rays"


def _flight_rows(results):
    for mesh in results["meshes"]:
        for flight in mesh["flights"]:
            read = flight["bytesRead"]
            ten = read[min(9, len(read) - 1)] / flight["fileBytes"]
            yield [name_of(mesh), f"{1000 * flight['budget']:.0f}", way_of(flight),
                   f"{100 * in_time(flight):.0f} %",
                   f"{1000 * statistics.median(flight['seconds']):.0f}",
                   f"{1000 * max(flight['seconds']):.0f}",
                   f"{statistics.median(flight['points']):,.0f}",
                   f"{statistics.median(flight['distances']):.1f}",
                   f"{100 * ten:.1f} %", f"{100 * read[-1] / flight['fileBytes']:.1f} %",
                   f"{(flight['peak'] - flight['before']) / 2**20:.0f}"]


def _film(results):
    if not results.get("film"):
        return ""
    return paragraph(f"""The first three fifths of the flight into the last mesh with {results['film']['points']:,} points, as it
        looks and with the sizes of the tetrahedra as colors (from blue, a two-hundredth of the diagonal,
        to red, a twentieth):""") + "\n![A flight, uniform and for the view](detail-study/flight.gif)\n"


def page(results, plots):
    size = results["meshes"][0]["pictures"]["size"]
    memory = results["meshes"][0]["flights"][0]["memory"]
    parts = [
        """# The detail study

How much view-dependent simplification ([guide](../just-in-time.md#where-the-view-needs-it)) gains on a flight into
meshes in files. `Utilities/bench.sh --detail` (Benchmarks/Studies/runDetail.py) writes this page. All results are in
[results.json](detail-study/results.json).

""" + benchmarkText.machine(results, ""),
        "## Tetrahedra and errors\n\n" + paragraph(f"""The camera flies from where all of the mesh is
            seen (0) to a tenth of its diagonal from the center (1). At each place the table compares
            meshes for the view with a ladder of meshes that are simplified everywhere alike, each with
            half of the points of the one before. *Tetrahedra* are those of the chunks that are drawn.
            *RMS* is the difference of the image, {size} x {size} pixels, from that of the whole mesh,
            in steps of 255 over all channels. *Uniform RMS* is that of as many uniform tetrahedra,
            *uniform tetrahedra* are those with the same RMS, and *ratio* is the tetrahedra for the view
            over these.""") + "\n" + table(
                ["mesh", "place", "points", "tetrahedra", "RMS", "uniform RMS",
                 "uniform tetrahedra", "ratio"], _picture_rows(results)) + "\n" + image(
                     plots, "errors", "Errors by tetrahedra", PAGE),
        _film(results),
        "## Following the camera\n\n" + paragraph("""Medians over ten steps of a hundredth of the way.
            *Cut*: choosing the merges and finding the chunks. *Blocks*: making those that changed, in
            and out of the view. *Made again*: the part of the blocks. In the mapper both are done
            in the background.""") + "\n" + table(
                ["mesh", "place", "points", "cut, ms", "blocks, ms", "made again"],
                _update_rows(results)),
        "## Frames, bytes and memory\n\n" + paragraph(f"""A flight of the mapper, from the file with a
            budget of {memory} MiB for decoded data, at default settings but for the column *way*. *In
            time*: at most 1.25 times the budget. *Ray distance* in pixels is the median.
            *Read*: bytes over those of the file, after ten frames and at the end. *Memory* is the peak
            above that before the flight, with an empty window.""") + "\n" + table(
                ["mesh", "budget, ms", "way", "in time", "median, ms", "worst, ms", "points",
                 "ray distance", "read, 10 frames", "read, all", "memory, MiB"],
                _flight_rows(results))]
    return "\n".join(part.rstrip() + "\n" for part in parts)


def write(results, out):
    benchmarkText.write_page(results, out, PAGE, page, "detailPlots")

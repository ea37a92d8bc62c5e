# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The part of the page of surfaces about images in motion."""

import math
import statistics

from benchmarkText import image, number, paragraph, ratio, span, table

WAYS = {"gtn": "`.gtn`, just in time", "vtp": "`.vtp`, ParaView's level of detail"}


def _mebibytes(cost):
    return (cost["peak"] - cost["before"]) / 2**20


def _first(motion):
    gtn, vtp = motion["first"]["gtn"], motion["first"]["vtp"]
    rows = [["`.gtn`, coarse", gtn["first"]], ["`.gtn`, whole", gtn["whole"]],
            ["`.vtp`, whole", vtp["first"]]]
    return table(["image", "s", "MiB above idle"],
                 [[name, number(cost["seconds"]), number(_mebibytes(cost))] for name, cost in rows])


def in_time(path, way):
    """The % of the frames that take at most 1.25 times the budget."""
    return 100 * path[way]["withinShare"]


def _frames(motion):
    head = ["budget, ms", "way", "in time", "median, ms", "worst, ms", "points", "level made, s",
            "rest, s"]
    rows = []
    for path in motion["paths"]:
        for way, name in WAYS.items():
            one = path[way]
            rows.append([
                f"{1000 * path['budget']:.0f}", name, f"{in_time(path, way):.0f} %",
                number(1000 * statistics.median(one["frames"])), number(1000 * max(one["frames"])),
                f"{one['medianPoints']:,.0f}", number(one["levelSeconds"]) if one["levelSeconds"] else "-",
                number(one["refinedSeconds"])])
    return table(head, rows)


def points_for(uniform, difference):
    """The points with which the uniform surface has a difference, on a line between two numbers in a
    double logarithmic plot. Nothing beyond those that were measured."""
    known = sorted((one["points"], one["difference"]) for one in uniform)
    for (fewer, worse), (more, better) in zip(known, known[1:]):
        if better <= difference <= worse and worse > better > 0:
            part = math.log(worse / difference) / math.log(worse / better)
            return fewer * (more / fewer) ** part
    return None


def difference_of(uniform, points):
    """The difference of the uniform surface with so many points, likewise."""
    known = sorted((one["points"], one["difference"]) for one in uniform)
    for (fewer, worse), (more, better) in zip(known, known[1:]):
        if fewer <= points <= more and min(worse, better) > 0:
            part = math.log(points / fewer) / math.log(more / fewer)
            return worse * (better / worse) ** part
    return None


def _cuts(motion):
    head = ["place", "pixels", "points", "RMS", "RMS, uniform", "points, uniform, for this RMS",
            "share of them", "update, ms", "image, ms", "blocks, new of drawn"]
    rows = []
    for i, place in enumerate(motion["cuts"], 1):
        for cut in place["cuts"]:
            points = cut["points"]
            if points == 0:
                rows.append([str(i), f"{cut['error']:g}", "all", *["-"] * 7])
                continue
            same = difference_of(place["uniform"], points)
            needed = points_for(place["uniform"], cut["difference"])
            least = min(one["difference"] for one in place["uniform"])
            most = max(one["points"] for one in place["uniform"])
            beyond = f"more than {most:,}" if cut["difference"] < least else "-"
            rows.append([
                str(i), f"{cut['error']:g}", f"{points:,}", ratio(cut["difference"]),
                ratio(same) if same else "-", f"{needed:,.0f}" if needed else beyond,
                ratio(points / needed) if needed else
                f"less than {ratio(points / most)}" if beyond != "-" else "-",
                f"{1000 * cut['updateSeconds']:.0f}", f"{1000 * cut['drawSeconds']:.0f}",
                f"{cut['newChunks']} of {cut['chunks']}"])
    return table(head, rows)


def _for_the_view(motion):
    if not motion.get("cuts"):
        return ""
    wholes = "" if all(cut["points"] for place in motion["cuts"] for cut in place["cuts"]) else """*All*: the
        base mesh for so small an error does not fit into half of the memory budget, 1 GiB."""
    return "\n## Simplified for the view\n\n" + paragraph(f"""The same file, from far (place 1) to near (place
        {len(motion['cuts'])}), where the surface reaches to the horizon, with `PixelError` at its
        *pixels* beside the surface that is simplified everywhere alike (`SimplificationRatio`). The
        *RMS* is that of the gray values, of 255, from the image of all of the surface, with
        {motion['view']} x {motion['view']} pixels that are means of 3 x 3. *Uniform* values are interpolated
        between halvings of the number of points. *Update* is the time in addition to that of the
        image after the camera has turned by half a degree around the surface, with two threads; in
        motion, it is spent in the background. {wholes}""") + "\n" + _cuts(motion)


def section(results, plots):
    """The text, or nothing if it was not measured."""
    motion = results.get("motion")
    if not motion:
        return ""
    known = motion["machine"]
    load = f"""Measured {known["date"]}, commit {known["commit"]}; the load average was
        {known["loadBefore"][0]:.2f} at the start and {known["loadAfter"][0]:.2f} at the end."""
    text = "## Images in motion\n\n" + paragraph(f"""A scan with noise of {motion['triangles']:,} triangles and
        {motion['points']:,} points, in a `.gtn` file with base meshes of
        {motion['bytes']['gtn'] / 2**20:.0f} MiB and a `.vtp` file of
        {motion['bytes']['vtp'] / 2**20:.0f} MiB. Images have {motion['size']} x {motion['size']} pixels
        and are drawn by Mesa with two threads, by `vtkGatunSurfaceMapper` with 512 MiB for
        buffers and by `vtkPolyDataMapper`. {load}""") + "\n"
    text += paragraph("""From the file, in the page cache, to the first image. *Coarse* is the first image
        in motion; *whole* follows it at rest.""") + "\n" + _first(motion) + "\n"
    text += paragraph(f"""Then the camera turns once around the surface and comes near it, in
        {len(motion['paths'][0]['gtn']['frames'])} frames; the `.gtn` file begins with the first of them.
        *In time*: at most 1.25 times the budget. *Points* are the median of those drawn, and *rest*
        is the time to the whole image after the last frame. ParaView's level of detail is
        vtkQuadricClustering as ParaView sets it, which is made of the whole surface before.""") + "\n"
    return text + _frames(motion) + "\n" + image(
        plots, "motion", "Times of the frames and points drawn", "surface-study") + _for_the_view(motion)


def conclude(results):
    """A sentence about it, or nothing."""
    motion = results.get("motion")
    if not motion:
        return ""
    texts = [f"{in_time(path, 'gtn'):.0f} % at {1000 * path['budget']:.0f} ms"
             for path in motion["paths"]]
    others = [f"{in_time(path, 'vtp'):.0f}" for path in motion["paths"]]
    shares = [cut["points"] / needed for place in motion.get("cuts", ()) for cut in place["cuts"]
              for needed in [points_for(place["uniform"], cut["difference"])]
              if needed and cut["points"] > 0]
    text = "" if not shares else f""" Simplified for the view, it takes {span(shares, ratio)} times the points for the
        same difference of the image."""
    return text_of_frames(motion, texts, others) + text


def text_of_frames(motion, texts, others):
    return f""" Of the frames of a camera path over {motion['triangles']:,} triangles {" and ".join(texts)}
        are in time; with ParaView's level of detail {" and ".join(others)} %."""



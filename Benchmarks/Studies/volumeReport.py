# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page of the results of runVolumes.py."""

import statistics

import benchmarkText
from benchmarkText import image, number, paragraph, spread, table

FOLDER = "volume-study"
MIB = 2**20
VIEWS = ("0 0 0", "0.5 0 1", "0.25 0.25 0.25", "0.48 0.1 0.95")

# The dissertation's values by size of blocks: Table 1 for the four views; Table 2 for the exponential
# and the linear opacity model, each for the second and the fourth view.
PAPER1 = {4: (0, 0.153, 25.543, 35.980), 8: (0.529, 1.536, 15.990, 23.536),
          16: (0.433, 1.026, 9.980, 18.336), 32: (0.301, 1.006, 4.670, 10.312),
          64: (0.149, 0.217, 3.252, 3.513)}
PAPER2 = {2: (3.115, 5.339, 4.935, 8.377), 4: (7.0699, 8.001, 9.129, 10.560),
          8: (10.870, 12.698, 12.699, 14.958), 16: (16.775, 17.314, 18.397, 19.402),
          32: (25.781, 26.089, 27.778, 28.321), 64: (32.750, 37.336, 34.579, 39.601)}


def error(value):
    """A mean square error, small or large."""
    if value is None:
        return "?"
    if value == 0:
        return "0"
    if value < 1e-4:
        return "<0.0001"
    return f"{value:.4f}" if value < 0.1 else number(value)


def size(block):
    return str(block) if block else "whole"


def find(runs, **wanted):
    """The first run with these values; None if there is none."""
    return next((run for run in runs
                 if all(run.get(key) == value for key, value in wanted.items())), None)


def median(run):
    return statistics.median(run["later"])


def model(name):
    """The opacity model of a run."""
    return {"xray": "X-ray", "exponential": "exponential"}.get(name, name)


def _head(results):
    text = """# The volume study

Quality and speed of images drawn from Hartley coefficients
([method](../hartley.md)). The page compares them with the dissertation's own results (C. Yang:
On-the-fly processing of compressed volume data, 2001, Tables 1 and 2), with a ray caster for voxels,
with zfp and with VTK. `Utilities/bench.sh --volumes` (Benchmarks/Studies/runVolumes.py) writes it.
All results are in [results.json](volume-study/results.json).

""" + benchmarkText.machine(results)
    rows = [[one["name"], f"{one['rates']['voxels']:,}", one["rates"]["type"],
             f"{one['rates']['lowest']:g} to {one['rates']['highest']:g}", one["about"]]
            for one in results["volumes"]]
    return text + "\n" + table(["volume", "voxels", "type", "values", "description"], rows)


def _blocks(results):
    text = "## Table 1: images of blocks\n\n" + paragraph("""Mean square error of the images of single
        blocks, scaled so that the largest sum along a ray is 255. The mean is over the rays that meet a
        block and over blocks that are not empty (a fixed, evenly spread selection). Turns are about x, y
        and z in units of pi, and voxels are cubes. *Sums*: relative to sums of trilinear samples at
        distances of a voxel, one of them on the plane through the center of the block. The
        dissertation compares with such sums. *Lines*: relative to exact integrals of the same
        trilinear basis functions along the same rays. *Between*: the difference of the sums from the
        integrals, that is, the error of the reference itself. An image made of integrals cannot be closer
        to the sums than that. *Slice*: by slices of spectra for all sizes of blocks, with the
        Kaiser-Bessel kernel. *Paper's kernel*: trilinear slices of spectra, without padding and
        padded to twice the size, relative to the sums, computed by this program. *1 bit*: ours at one
        bit per voxel, relative to sums of the original voxels.""")
    for one in results["volumes"]:
        rows = []
        for run in one["blocks"]:
            if run["rate"] != 0:
                continue
            coded = find(one["blocks"], block=run["block"], rate=1)["ways"][0]["views"]
            ways = {way["way"]: way["views"] for way in run["ways"]}
            for i, view in enumerate(VIEWS):
                paper = PAPER1[run["block"]][i] if run["block"] in PAPER1 else ""
                own = ways["gatun"][i]
                rows.append([size(run["block"]), view, paper, f"**{error(own['samples'])}**",
                             f"**{error(own['lines'])}**", error(own["between"]),
                             error(ways.get("slice", ways["gatun"])[i]["lines"]),
                             error(ways["trilinear-1"][i]["samples"]),
                             error(ways["trilinear-2"][i]["samples"]), error(coded[i]["samples"])])
        text += f"\n### {one['name']}\n\n" + table(
            ["block", "turns", "paper", "ours, sums", "ours, lines", "between", "slice, lines",
             "paper's kernel", "padded", "1 bit"], rows) + "\n" + _worst(one)
    return text


def _worst(one):
    """The worst of all sizes of blocks and views, without quantization."""
    own = [view for run in one["blocks"] if run["rate"] == 0 for view in run["ways"][0]["views"]]
    sums = max(own, key=lambda view: view["samples"])
    return paragraph(f"""Our largest errors are {error(sums['samples'])} relative to the sums, where the error
        of the reference itself is {error(sums['between'])}, and
        {error(max(view['lines'] for view in own))} relative to the integrals.""")


def _images(results, plots):
    text = "## Table 2: whole images\n\n" + paragraph("""Mean square error of images with values from 0 to
        255, over all rays that meet the volume. The reference is a ray caster that samples the
        trilinear volume at distances of a voxel, front to back, by equations 1, 2 and 5. Gray goes from
        the lowest to the highest density. *Opacity* is that of a sample of the highest density, which
        determines K; the dissertation does not state its own. *Equation 6*: opacity under the
        exponential model relative to 1 - exp(-K times the line integral), without blocks, and its
        largest difference. It is exact on the lattice of a slab, from which
        pixels are interpolated. *X-ray*: relative to line integrals, the largest of which is 255.""")
    for one in results["volumes"]:
        for run in one["pictures"]:
            rows = []
            for block in run["blocks"]:
                if block["rate"] != 0:
                    continue
                coded = find(run["blocks"], block=block["block"], rate=1)
                for i in (0, 1, 2, 3):
                    view = block["views"][i]
                    paper = PAPER2.get(block["block"]) if i in (1, 3) else None
                    rows.append([
                        size(block["block"]), VIEWS[i], error(view["xrayLines"]["mse"]),
                        error(view["equation6"]["mse"]), f"{view['equation6']['worst']:.2f}",
                        paper[i // 2] if paper else "",
                        f"**{error(view['exponential']['mse'])}**",
                        paper[2 + i // 2] if paper else "",
                        f"**{error(view['linear']['mse'])}**",
                        error(coded["views"][i]["exponential"]["mse"]) if coded else ""])
            text += f"\n### {one['name']}, opacity {run['opacity']:g}\n\n" + table(
                ["block", "turns", "X-ray", "equation 6", "largest", "paper, exponential", "ours",
                 "paper, linear", "ours", "exponential, 1 bit"], rows)
        text += "\n" + _paper_wins(one)
    return text + "\n" + image(plots, "tables", "Errors by size of blocks", FOLDER)


def count_against_paper(one):
    """How many of the dissertation's values are larger than ours, and how many smaller."""
    better, worse = 0, 0
    for run in one["pictures"]:
        for block in run["blocks"]:
            if block["rate"] != 0 or block["block"] not in PAPER2:
                continue
            paper = PAPER2[block["block"]]
            for i, view in ((0, 1), (1, 3)):
                for offset, law in ((0, "exponential"), (2, "linear")):
                    ours = block["views"][view][law]["mse"]
                    better += ours < paper[i + offset]
                    worse += ours > paper[i + offset]
    return better, worse


def _paper_wins(one):
    better, worse = count_against_paper(one)
    return paragraph(f"""Compared with the dissertation's values for its own volume, the error is smaller in
        {better} and larger in {worse} of {better + worse} cases.""")


def _rates(results, plots):
    text = "## Bits by error\n\n" + paragraph("""Bits per voxel of the whole file (and its PSNR) for a
        requested error of the voxels that the reader returns, rounded to the type of the volume. PSNR
        is 20 log10(range / root mean square error). zfp 1.0 compresses a single-precision copy to a
        given accuracy (mostly the best of its modes) and integers promoted to 32 bits to a number of
        bit planes; its results are rounded likewise. Lossless: `.ghv` with error 0, zfp's
        reversible mode for integers, and VTK's own .vti with zlib.""")
    rows = []
    for one in results["volumes"]:
        for series in one["rates"]["gatun"]:
            points = series["points"]
            rows.append([one["name"], size(series["block"]),
                         *(f"{point['bits']:.3f} ({psnr(point)})" for point in points
                           if point["wanted"] > 0),
                         f"**{find(points, wanted=0)['bits']:.3f}**"])
    wanted = [f"{point['wanted']} dB" for point in results["volumes"][0]["rates"]["gatun"][0]["points"]
              if point["wanted"] > 0]
    text += "\n" + table(["volume", "block", *wanted, "lossless"], rows)
    rows = []
    for one in results["volumes"]:
        rates = one["rates"]
        zfp = rates.get("zfp", {})
        reversible = zfp.get("reversible")
        rows.append([one["name"], f"{rates['vti']:.3f}",
                     f"{reversible[0]['bits']:.3f}" if reversible else "",
                     "; ".join(f"{point['bits']:.3f}: {psnr(point)}"
                               for point in zfp.get("accuracy", []))])
    text += "\n" + paragraph("Bits per voxel and dB of the peers:") + "\n" + table(
        ["volume", ".vti, zlib", "zfp, reversible", "zfp, accuracy"], rows)
    return text + "\n" + image(plots, "rates", "PSNR by bits per voxel", FOLDER)


def psnr(point):
    """JSON has null for infinity."""
    return f"{point['psnr']:.1f}" if point["psnr"] is not None else "exact"


def _way(run):
    return {"gatun": f"Gatun, {size(run.get('block', 0))}", "plain": "plain sums, voxels",
            "fixed-point": "vtkFixedPointVolumeRayCastMapper"}[run["way"]]


def _times(results, plots):
    part = results.get("times")
    if not part:
        return ""
    runs = part["runs"]
    text = f"## Time for a view: {part['name']}\n\n" + paragraph("""Each view has another direction. The
        methods take turns. *First* includes data that later views reuse (spectra). *Later* is the median
        of the later views, with their range. Memory is the peak above that before the first view.
        vtkFixedPointVolumeRayCastMapper takes the same samples, at distances of a voxel, for the same
        pixels (X-ray: additive blending), in an offscreen window. *Plain sums* are trilinear samples
        summed along each ray, on all threads.""")

    def rows_of(run, *extra):
        return [[*extra, _way(one), model(one["law"]),
                 f"{one['rate']:g}" if one["rate"] else "lossless" if one["way"] == "gatun" else "",
                 one.get("method", ""),
                 f"{find(run['sources'], block=one['block'], rate=one['rate'])['terms']:,}"
                 if one["way"] == "gatun" else "",
                 number(1000 * one["seconds"]), spread(1000 * s for s in one["later"]),
                 number((one["peak"] - one["before"]) / MIB)]
                for one in ({"rate": 0, "block": 0, **way} for way in run["ways"])]
    head = ["renderer", "model", "bits per voxel", "method", "nonzero coefficients", "first, ms",
            "later, ms", "MiB"]
    text += f"\n### By size of blocks, {runs['blocks']['pixels']} x {runs['blocks']['pixels']}\n\n"
    text += table(head, rows_of(runs["blocks"]))
    text += "\n### By quality\n\n" + table(head, rows_of(runs["rates"]))
    text += "\n### By size of the image\n\n" + table(
        ["pixels", *head], [row for run in runs["pixels"] for row in rows_of(run, run["pixels"])])
    text += "\n### By number of threads\n\n" + table(
        ["threads", *head], [row for run in runs["threads"] for row in rows_of(run, run["threads"])])
    return text + "\n" + image(plots, "times", "Time for a view", FOLDER)


def _plate(results, plots):
    if "plate" not in results:
        return ""
    runs = [run for run in results["plate"]["runs"]
            if run["law"] == "xray" and run["plate"] != "voxels"]
    rows = [[size(run["block"]), f"{run['rate']} bits" if run["rate"] else "lossless",
             f"{run['bits']:.3f}", psnr(run)] for run in runs]
    return f"## Images: {results['plate']['name']}\n\n" + paragraph("""From top to bottom: X-ray, gray
        under the exponential model, and colors by a transfer function. The left column is drawn
        from voxels, the others from blocks of 4 voxels at fewer and fewer bits per voxel.""") + (
            "\n" + image(plots, "qualities", "The same view at several qualities", FOLDER)) + (
            "\n" + paragraph("""The same without loss, in larger and larger blocks. A block is colored by
        its mean density along the ray. The error shows in colors and, under a transfer
        function, in opacities. X-rays do not depend on the size of the blocks.""")) + (
            "\n" + image(plots, "sizes", "The same view with several sizes of blocks", FOLDER)) + (
            "\n" + table(["block", "requested", "bits per voxel", "PSNR"], rows))


def page(results, plots):
    parts = [_head(results), _plate(results, plots), _blocks(results), _images(results, plots),
             _rates(results, plots), _times(results, plots)]
    return "\n".join(part.rstrip() + "\n" for part in parts if part)


def write(results, out):
    benchmarkText.write_page(results, out, "volume-study", page, "volumePlots")

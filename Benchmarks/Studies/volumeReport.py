# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""The page made of what runVolumes.py has measured."""

import statistics

from benchmarkText import machine, number, paragraph, picture, table

FOLDER = "volume-study"
MIB = 2**20
VIEWS = ("0 0 0", "0.5 0 1", "0.25 0.25 0.25", "0.48 0.1 0.95")

# Of the dissertation, by size of blocks: the four views; and the exponential and the linear law,
# each from the second and the fourth.
PAPER1 = {4: (0, 0.153, 25.543, 35.980), 8: (0.529, 1.536, 15.990, 23.536),
          16: (0.433, 1.026, 9.980, 18.336), 32: (0.301, 1.006, 4.670, 10.312),
          64: (0.149, 0.217, 3.252, 3.513)}
PAPER2 = {2: (3.115, 5.339, 4.935, 8.377), 4: (7.0699, 8.001, 9.129, 10.560),
          8: (10.870, 12.698, 12.699, 14.958), 16: (16.775, 17.314, 18.397, 19.402),
          32: (25.781, 26.089, 27.778, 28.321), 64: (32.750, 37.336, 34.579, 39.601)}


def error(value):
    """A mean square error, from hardly anything to a lot."""
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
    """The first that has all that is wanted; None if there is none."""
    return next((run for run in runs
                 if all(run.get(key) == value for key, value in wanted.items())), None)


def median(run):
    return statistics.median(run["later"])


def _head(results):
    text = """# The study of regular volumes

How good and how fast pictures are that come from Hartley coefficients without going back to voxels, next to
the dissertation's own figures (C. Yang: On-the-fly processing of compressed volume data, 2001, Tables 1 and
2), to a voxel-by-voxel ray caster, to zfp and to VTK. `Utilities/bench.sh --volumes`
(Benchmarks/Studies/runVolumes.py) made this page; every figure behind it is in
[results.json](volume-study/results.json).

""" + machine(results["machine"])
    if results["mode"] != "full":
        text += f"\n**A {results['mode']} run on small volumes: not to be quoted.**\n"
    rows = [[one["name"], f"{one['rates']['voxels']:,}", one["rates"]["type"],
             f"{one['rates']['lowest']:g} to {one['rates']['highest']:g}", one["about"]]
            for one in results["volumes"]]
    return text + "\n" + table(["volume", "voxels", "type", "values", "what"], rows)


def _blocks(results):
    text = "## Table 1: pictures of blocks\n\n" + paragraph("""Mean square error of the pictures of single
        blocks, scaled so that the largest sum along a ray is 255, over rays that meet the block and over
        blocks that are not empty (a fixed, evenly spread selection of them). Turns about x, y, z in units
        of pi, voxels are cubes. *Sums*: against sums of trilinear samples a voxel apart, one on the
        plane through the block's centre, which is what the paper compares with. *Lines*: against exact
        integrals of the same trilinear hats along the same rays. *Between*: of the sums against the
        integrals, which is the error of the yardstick itself: no picture made of integrals can be
        closer to the sums. *Slice*: by slices of spectra for all sizes of blocks, with the
        Kaiser-Bessel kernel. *Paper's kernel*: trilinear slices of spectra, without padding and with
        as much again, against the sums, by the same program. *1 bit*: ours at one bit a voxel, against
        sums of the original voxels.""")
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
    """What is worst of all sizes of blocks and views, without loss."""
    own = [view for run in one["blocks"] if run["rate"] == 0 for view in run["ways"][0]["views"]]
    sums = max(own, key=lambda view: view["samples"])
    return paragraph(f"""Ours at worst: {error(sums['samples'])} against the sums, where the yardstick's own
        error is {error(sums['between'])}; {error(max(view['lines'] for view in own))} against the
        integrals.""")


def _pictures(results, pictures):
    text = "## Table 2: whole pictures\n\n" + paragraph("""Mean square error of pictures from 0 to 255, over
        all rays that meet the volume, against a ray caster that takes the trilinear volume sample by
        sample, a voxel apart, front to back, by equations 1, 2 and 5. Grey goes from the lowest to the
        highest density. *Opacity*: that of a sample of the highest density, by which K is set; the
        paper does not tell its own. *Equation 6*: opacity under the exponential law against
        1 - exp(-K times the line integral), without any blocks; its largest difference is next to it.
        *X-ray*: against line integrals, the largest of which is 255.""")
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
    return text + "\n" + picture(pictures, "tables", "Errors against sizes of blocks", FOLDER)


def _rates(results, pictures):
    text = "## Bits against errors\n\n" + paragraph("""Bits a voxel of the whole file (and its PSNR) for
        an error that is wanted of the voxels, as a reader gives them back (rounded to the volume's type). PSNR: 20 log10(range / root mean
        square error). zfp 1.0 compresses a copy in single precision to a given accuracy (the best of
        its settings in most of these), and integers promoted to 32 bits to a number of bit planes; what
        comes back is rounded likewise. Lossless: `.ghv` at error 0, zfp's reversible mode on
        integers, and VTK's own .vti with zlib.""")
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
    text += "\n" + paragraph("Bits and dB of peers:") + "\n" + table(
        ["volume", ".vti, zlib", "zfp, reversible", "zfp, accuracy"], rows)
    return text + "\n" + picture(pictures, "rates", "PSNR against bits a voxel", FOLDER)


def psnr(point):
    """Null is what JSON makes of infinity."""
    return f"{point['psnr']:.1f}" if point["psnr"] is not None else "exact"


def _way(run):
    return {"gatun": f"Gatun, {size(run.get('block', 0))}", "plain": "plain sums, voxels",
            "fixed-point": "vtkFixedPointVolumeRayCastMapper"}[run["way"]]


def _times(results, pictures):
    part = results.get("times")
    if not part:
        return ""
    runs = part["runs"]
    text = f"## Time for a view: {part['name']}\n\n" + paragraph("""Each view is from another side; seconds are
        medians of views after the first, all ways in turn. *First* includes what is kept for later views
        and for the same size of blocks (spectra); memory is the peak above what there was before the first
        view. vtkFixedPointVolumeRayCastMapper takes the same samples, a voxel apart, of the same pixels
        (X-ray: additive blending), in a window that nobody sees; *plain sums* are trilinear samples
        summed along each ray, on all threads.""")

    def rows_of(run, *extra):
        return [[*extra, _way(one), one["law"],
                 f"{one['rate']:g}" if one["rate"] else "no loss" if one["way"] == "gatun" else "",
                 one.get("method", ""),
                 f"{find(run['sources'], block=one['block'], rate=one['rate'])['terms']:,}"
                 if one["way"] == "gatun" else "",
                 number(1000 * one["seconds"]), f"**{number(1000 * median(one))}**",
                 number((one["peak"] - one["before"]) / MIB)]
                for one in ({"rate": 0, "block": 0, **way} for way in run["ways"])]
    head = ["way", "law", "bits a voxel", "method", "coefficients not 0", "first, ms", "later, ms",
            "MiB"]
    text += f"\n### By size of blocks, {runs['blocks']['pixels']} x {runs['blocks']['pixels']}\n\n"
    text += table(head, rows_of(runs["blocks"]))
    text += "\n### By quality\n\n" + table(head, rows_of(runs["rates"]))
    text += "\n### By size of the picture\n\n" + table(
        ["pixels", *head], [row for run in runs["pixels"] for row in rows_of(run, run["pixels"])])
    text += "\n### By threads\n\n" + table(
        ["threads", *head], [row for run in runs["threads"] for row in rows_of(run, run["threads"])])
    return text + "\n" + picture(pictures, "times", "Time for a view", FOLDER)


def _plate(results, pictures):
    if "plate" not in results:
        return ""
    runs = [run for run in results["plate"]["runs"]
            if run["law"] == "xray" and run["plate"] != "voxels"]
    rows = [[size(run["block"]), f"{run['rate']} bits" if run["rate"] else "no loss",
             f"{run['bits']:.3f}", psnr(run)] for run in runs]
    return f"## Pictures: {results['plate']['name']}\n\n" + paragraph("""From top to bottom: X-ray, grey
        under the exponential law, and colours by a transfer function. Voxel by voxel on the left; then
        blocks of 4 voxels from the file, at ever fewer bits a voxel.""") + "\n" + picture(
            pictures, "qualities", "The same view at several qualities", FOLDER) + "\n" + paragraph(
                """The same without loss, in ever larger blocks. That a block counts as if its mean
                density were everywhere in it shows in colours and, under a transfer function, in
                opacities; X-rays are the same for all.""") + "\n" + picture(
                    pictures, "sizes", "The same view with several sizes of blocks", FOLDER) + (
                        "\n" + table(["block", "wanted", "bits a voxel", "PSNR"], rows))


def write(results, out):
    """Writes volume-study.md, and plots where matplotlib is there."""
    try:
        import volumePlots
        pictures = volumePlots.draw(results, out / FOLDER)
    except ImportError:
        print("Without matplotlib (python3-matplotlib) there are no plots.")
        pictures = set()
    page = [_head(results), _plate(results, pictures), _blocks(results), _pictures(results, pictures),
            _rates(results, pictures), _times(results, pictures)]
    (out / "volume-study.md").write_text(
        "\n".join(part.rstrip() + "\n" for part in page if part), encoding="utf-8")

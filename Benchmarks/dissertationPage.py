# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Documentation/dissertation.md: the tables and figures of the dissertation proposal beside ours."""

import io
import statistics

import performancePage
from performancePage import medians, memory, number, paragraph, table

VIEWS = ("0 0 0", "0.5 0 1", "0.25 0.25 0.25", "0.48 0.1 0.95")
TABLE1 = {4: (0, 0.153, 25.543, 35.980), 8: (0.529, 1.536, 15.990, 23.536), 16: (0.433, 1.026, 9.980, 18.336),
          32: (0.301, 1.006, 4.670, 10.312), 64: (0.149, 0.217, 3.252, 3.513)}
# Exponential for two views, then linear.
TABLE2 = {2: (3.115, 5.339, 4.935, 8.377), 4: (7.0699, 8.001, 9.129, 10.560),
          8: (10.870, 12.698, 12.699, 14.958), 16: (16.775, 17.314, 18.397, 19.402),
          32: (25.781, 26.089, 27.778, 28.321), 64: (32.750, 37.336, 34.579, 39.601)}
TABLE3 = (("Spx", 2896, 12936, 27252, 2760), ("Fighter", 13832, 70125, 143881, 7262),
          ("Blunt", 40960, 187395, 381548, 13516), ("Combustion", 47025, 215040, 437888, 15616),
          ("Post", 109744, 513375, 1040588, 27676), ("Delta", 211680, 1005765, 2032084, 41468))
TABLE4 = (("Blunt-fin", 1024, "125.88", "97.36", "245.54*", "97.96"),
          ("Combustion Chamber", 1024, "141.28", "123.12", "601.17*", "176.15*"),
          ("Liquid Oxygen Post", 128, "18.51", "19.17", "705.67*", "19.26"),
          ("Liquid Oxygen Post", 256, "24.80", "23.40", "791.35*", "23.45"),
          ("Liquid Oxygen Post", 512, "54.06", "40.69", "964.70*", "40.73"),
          ("Liquid Oxygen Post", 1024, "284.95*", "122.16", "N/A", "3129.55*"),
          ("Delta Wing", 128, "2414.41*", "47.77", "N/A", "50.26"))
WAYS = {"gatun": ("while decompressing", "#0072b2"), "generic": ("decompress first", "#d55e00"),
        "vtu": ("`.vtu`, load first", "#e69f00")}


def small(value):
    return "<0.0001" if value < 1e-4 else f"{value:.4f}" if value < 0.1 else number(value)


def seconds(runs):
    """The median; None if the limit was too little."""
    return statistics.median(medians(runs, "seconds")) if None not in runs else None


def case(mesh, limit, size):
    return next((one for one in mesh["cases"] if (one["limit"], one["size"]) == (limit, size)), None)


def sizes(mesh):
    return sorted({one["size"] for one in mesh["cases"]})


def figure13(mesh):
    """Memory of each method at the size that is nearest to 512, in MiB."""
    size = min(sizes(mesh), key=lambda one: abs(one - 512))
    return {way: statistics.median(memory(runs)) for way, runs in case(mesh, 0, size)["ways"].items()}


def time_ratios(results, way):
    """Of the time of another method over Gatun's, without a limit."""
    return [seconds(one["ways"][way]) / seconds(one["ways"]["gatun"])
            for mesh in results["dissertation"]["meshes"] for one in mesh["cases"] if one["limit"] == 0]


def _save(pyplot, figure, file):
    """As a .png file of few colors, which is small."""
    from PIL import Image  # pylint: disable=import-outside-toplevel
    data = io.BytesIO()
    figure.tight_layout()
    figure.savefig(data, format="png", dpi=100)
    pyplot.close(figure)
    Image.open(data).convert("RGB").quantize(48).save(file, optimize=True)


def _draw_memory(pyplot, meshes):
    figure, axes = pyplot.subplots(figsize=(7, 3.2))
    for i, (way, (text, color)) in enumerate(WAYS.items()):
        values = [figure13(mesh)[way] for mesh in meshes]
        bars = axes.bar([m + 0.27 * i for m in range(len(meshes))], values, 0.27, color=color,
                        label=text.replace("`", ""))
        axes.bar_label(bars, [f"{value:,.0f}" for value in values], fontsize=8)
    axes.set_xticks([m + 0.27 for m in range(len(meshes))],
                    [f"{mesh['name']}\n{mesh['tets']:,}" for mesh in meshes])
    axes.set_yscale("log")
    axes.set_ylim(10, 2 * max(value for mesh in meshes for value in figure13(mesh).values()))
    axes.set_ylabel("peak memory, MiB")
    axes.legend(fontsize=8)
    return figure


def _draw_time(pyplot, meshes):
    figure, grid = pyplot.subplots(1, len(meshes), squeeze=False, figsize=(2.6 * len(meshes), 2.8))
    for axes, mesh in zip(grid[0], meshes):
        for way, (text, color) in WAYS.items():
            axes.plot(sizes(mesh), [seconds(case(mesh, 0, size)["ways"][way]) for size in sizes(mesh)], "o-",
                      color=color, markersize=3, label=text.replace("`", ""))
        axes.set_xscale("log", base=2)
        axes.set_xticks(sizes(mesh), sizes(mesh), fontsize=8)
        axes.set_ylim(bottom=0)
        axes.set_title(mesh["name"], fontsize=9)
        axes.set_xlabel("pixels along an edge", fontsize=8)
        axes.grid(alpha=0.3)
    grid[0][0].set_ylabel("s, file to image")
    grid[0][0].legend(fontsize=7)
    return figure


def _draw_simplification(pyplot, meshes):
    figure, (first, second, third) = pyplot.subplots(1, 3, figsize=(11, 3.4))
    colors = ("#0072b2", "#d55e00", "#009e73", "#cc79a7")
    for mesh, color in zip(meshes, colors):
        options = {"color": color, "markersize": 3}
        ratios = medians(mesh["ratios"], "ratio")
        for way, style in (("gatun", "o-"), ("generic", "o--")):
            first.plot(ratios, [seconds(one[way]) for one in mesh["ratios"]], style, **options,
                       label=mesh["name"] if way == "gatun" else None)
        known = mesh["simplified"]["ratios"]
        for way, style in (("integral", "o-"), ("samples", "o--")):
            second.plot(ratios, [statistics.median(one[way]) for one in known], style, **options)
        third.plot(ratios[1:], [one["rms"] for one in known[1:]], "o-", **options)
    for axes, title in ((first, "Figure 17: s, file to image\n(dashed: one stage after the other)"),
                        (second, "Figure 18: s, drawing, all threads\n(dashed: samples at even distances)"),
                        (third, "Figure 19: RMS error of the image, 0 to 1\n")):
        axes.set_title(title, fontsize=9)
        axes.set_xlabel("ratio of simplification", fontsize=8)
        axes.set_yscale("log")
        axes.grid(alpha=0.3)
    first.legend(fontsize=7)
    return figure


def draw(results, folder):
    """Writes the plots, where matplotlib is installed."""
    try:
        import matplotlib  # pylint: disable=import-outside-toplevel
        matplotlib.use("Agg")
        from matplotlib import pyplot  # pylint: disable=import-outside-toplevel
    except ImportError:
        print("Without matplotlib (python3-matplotlib) there are no plots.")
        return
    makers = {"memory": _draw_memory, "time": _draw_time, "simplification": _draw_simplification}
    for name, make in makers.items():
        _save(pyplot, make(pyplot, results["dissertation"]["meshes"]), folder / f"{name}.png")


def _image(plots, name, text):
    return f"\n![{text}](performance/{name}.png)\n" if name in plots else ""


def _head(results, _):
    return f"""# The dissertation, repeated

C. Yang, *On-the-fly Processing of Compressed Volume Data*, dissertation proposal, Stony Brook, 2001, has the
methods that Gatun began with. This page has its Tables 1 to 4 and Figures 13, 14 and 17 to 19 beside ours.
`Utilities/setup.sh bench` writes it. Its numbers are in [results.json](performance/results.json); other
comparisons are on the [page of performance](performance.md).

{performancePage.machine(results)}"""


def _table1(results, _):
    tables = results["dissertation"]["tables"]
    rows, lines = [], []
    for name, known in tables.items():
        for one in known["table1"]["blocks"]:
            paper = TABLE1.get(one["block"], ("-",) * 4)
            lines += medians(one["views"], "lines")
            rows.append([f"{name}, {one['block']}", *(cell for pair in zip(paper, (
                f"**{small(view['samples'])}**" for view in one["views"])) for cell in pair)])
    largest = max(view["between"] for known in tables.values() for one in known["table1"]["blocks"]
                  for view in one["views"])
    return "## Table 1: images of blocks\n\n" + paragraph(f"""Mean square error of the image of a block, drawn from its
        Hartley coefficients (not quantized), against sums of samples along rays, the largest of which is 255, by
        rotation about x, y and z in units of pi: the dissertation, then **ours**. The volumes differ. Against
        exact line integrals our largest error is {small(max(lines))}; the sums themselves differ from the
        integrals by up to {small(largest)}.""") + "\n" + table(
            ["block", *(cell for view in VIEWS for cell in (view, "ours"))], rows)


def _table2(results, _):
    rows, better, count = [], 0, 0
    for name, known in results["dissertation"]["tables"].items():
        for opacity, one in ((run["opacity"], one) for run in known["table2"] for one in run["blocks"]):
            ours = (*one["exponential"], *one["linear"])
            paper = TABLE2.get(one["block"], ("-",) * 4)
            if one["block"] in TABLE2:
                better += sum(a < b for a, b in zip(ours, paper))
                count += len(ours)
            rows.append([f"{name}, {opacity:g}, {one['block']}", *(cell for a, b in zip(paper, ours)
                                                                   for cell in (a, f"**{small(b)}**"))])
    return "## Table 2: whole images\n\n" + paragraph(f"""Mean square error of images from 0 to 255 against a ray caster that
        samples voxels, for the exponential and the linear model of opacity. A block has one color along a ray,
        that of its mean density, which is the error of large blocks. Ours is smaller in {better} of {count}
        cases, but the comparison is weak: the dissertation does not state its opacity, on which the error of
        large blocks depends. Rows have the volume, our opacity of a sample of the highest density, and the size
        of blocks.""") + "\n" + table(
            ["volume", *(cell for model in ("exponential", "linear") for view in VIEWS[1::2]
                        for cell in (f"{model}, {view}", "ours"))], rows)


def _table3(results, _):
    ours = [(f"**{mesh['name']}**", mesh["points"], mesh["tets"], (4 * mesh["tets"] + mesh["boundary"]) // 2,
             mesh["boundary"]) for mesh in results["dissertation"]["meshes"]]
    return "## Table 3: meshes\n\n" + paragraph("""Blunt and Combustion still exist (bluntfin and comb). A Delaunay mesh and a
        structured grid take the place of the others.""") + "\n" + table(
            ["mesh", "points", "tetrahedra", "faces", "boundary faces"],
            [[name, *(f"{cell:,}" for cell in cells)] for name, *cells in (*TABLE3, *ours)])


def _figures13_14(results, plots):
    meshes = results["dissertation"]["meshes"]
    ratios = [found["generic"] / found["gatun"] for found in map(figure13, meshes)]
    times, vtu = time_ratios(results, "generic"), time_ratios(results, "vtu")
    text = "## Figures 13 and 14, Table 4: memory and time\n\n" + paragraph(f"""From the file to an image by one ray caster:
        *while decompressing*, chunk by chunk, or *decompress first*, the dissertation's generic method; and from
        a zlib `.vtu` file. Each image is drawn by a separate process; memory is above that of the new process, at
        512 x 512 pixels. Files have default settings, points and cells a good order, as for
        [images](performance.md#images). The dissertation says that Gatun needs "usually less than half" of the memory. Here,
        decompressing first takes {min(ratios):.1f} to {max(ratios):.1f} times the memory, more for larger
        meshes, and {min(times):.2f} to {max(times):.2f} times the time. Beginning with a `.vtu` file, which
        needs no decoding of the mesh, takes {min(vtu):.2f} to {max(vtu):.2f} times the time.""")
    text += _image(plots, "memory", "Figure 13: peak memory by mesh")
    text += _image(plots, "time", "Figure 14: time by size of the image")
    rows = []
    for mesh in meshes:
        for limit in sorted({one["limit"] for one in mesh["cases"]}):
            for size in (sizes(mesh)[0], sizes(mesh)[-1]):
                found = {way: seconds(runs) for way, runs in case(mesh, limit, size)["ways"].items()}
                rows.append([mesh["name"], size, f"{limit} MiB" if limit else "none", *(
                    "fails" if found[way] is None else f"{found[way]:.2f}"
                    for way in ("generic", "gatun", "vtu"))])
    return text + "\n" + paragraph("""Table 4 limits the memory. Ours, seconds; *fails*: the limit was too small. There is no
        swap, so that what paged in 2001 fails.""") + "\n" + table(
            ["mesh", "pixels", "limit", "generic", "Gatun", "`.vtu`"], rows) + "\n" + paragraph("""The dissertation's,
        seconds on a Pentium II with 300 MHz; an asterisk means paging:""") + "\n" + table(
            ["mesh", "pixels", "generic, 160 MB", "Gatun, 160 MB", "generic, 80 MB", "Gatun, 80 MB"], TABLE4)


def _figures17_19(results, plots):
    meshes = results["dissertation"]["meshes"]
    staged = [seconds(one["generic"]) / seconds(one["gatun"]) for mesh in meshes for one in mesh["ratios"][1:]]
    gains = {way: [statistics.median(known[0][way]) / statistics.median(known[-1][way])
                   for known in (mesh["simplified"]["ratios"] for mesh in meshes)]
             for way in ("integral", "samples")}
    errors = [mesh["simplified"]["ratios"][-2]["rms"] for mesh in meshes]
    last = meshes[0]["simplified"]["ratios"][-1]["ratio"]
    return "## Figures 17 to 19: simplification\n\n" + paragraph(f"""Images of 256 x 256 pixels by the ratio of
        simplification, the part of the points that is merged away. *Figure 17*: from a file with a hierarchy to
        the image. Decompressing, simplifying and drawing one after the other takes {min(staged):.2f} to
        {max(staged):.2f} times the time of doing all three chunk by chunk; the dissertation's integrated system
        "wins in all the cases". *Figure 18*: drawing alone. The dissertation draws with samples at even distances
        ("volume-based") or on faces only ("area-based"), and is surprised that both gain from simplification. At
        a ratio of {last:g}, images with samples at even distances are drawn {min(gains["samples"]):.1f} to
        {max(gains["samples"]):.1f} times as fast as the whole mesh, and those with the exact integral of each
        tetrahedron, which Gatun has in place of samples on faces, {min(gains["integral"]):.1f} to
        {max(gains["integral"]):.1f} times. *Figure 19*: the error of the image is "minimal" up to aggressive
        ratios, as in the dissertation: at 0.9 at most {max(errors):.1g} of the range of colors.""") + _image(
            plots, "simplification", "Figures 17, 18 and 19")


LESSONS = """## What does not pay

Measured earlier, and listed so that nobody tries it again without a new idea:

- *Release from both ends of the rays* (section 4.4 of the proposal): fewer tetrahedra wait, but rays break into
  more fragments, and images take longer. Gatun releases from the front.
- *The pre-filter* (section 4.4) drops many tetrahedra of small images, but saves no time.
- *Trilinear slices of spectra* (section 3), even with padding to twice the size, have errors above 1 in Table 1
  for rotated views.
- *Layers of growing precision* for arrays with bounded errors take over half as many bytes again as the finest
  layer alone.
- *Quadric placement* as in VTK moves points and computes new values. It wins on smooth fields at few tetrahedra,
  but such merges cannot be undone, nor stored as an order of points.
- *Many processes*: each one needs the tables of all chunks, which bound the memory of a writer. Larger chunks
  help.
"""


def page(results, plots):
    parts = [make(results, plots) for make in (_head, _table1, _table2, _table3, _figures13_14, _figures17_19)]
    return "\n".join([*parts, LESSONS])

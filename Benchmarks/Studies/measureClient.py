# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""For runClient.py, in ParaView's window (paraview --script): opens a file as File > Open and Apply do, shows
it as a volume, turns it, and writes times and the peak of memory.

GATUN_MEASURE in the environment is JSON: the file (empty: only the empty view), the representation for the volume,
the file for the results, and the file for a picture.
"""

import json
import os
import time

from paraview import simple


def peak_memory():
    """Bytes."""
    with open("/proc/self/status", encoding="ascii") as status:
        line = next(line for line in status if line.startswith("VmHWM"))
    return 1024 * int(line.split()[1])


def render():
    simple.Render()


def measure(wanted):
    view = simple.GetActiveViewOrCreate("RenderView")
    render()
    results = {"viewSize": list(view.ViewSize), "idleBytes": peak_memory()}
    if not wanted["file"]:
        return results
    begin = time.monotonic()
    source = simple.OpenDataFile(wanted["file"])
    shown = simple.Show(source, view)
    simple.ResetCamera(view)
    render()
    results.update(firstSeconds=time.monotonic() - begin, firstBytes=peak_memory(),
                   firstRepresentation=str(shown.Representation).strip("'"))
    source.UpdatePipelineInformation()
    colored = source.PointData[0].GetName()
    again = time.monotonic()
    shown.SetRepresentationType(wanted["representation"])
    simple.ColorBy(shown, ("POINTS", colored))
    render()
    results.update(volumeSeconds=results["firstSeconds"] + time.monotonic() - again, volumeBytes=peak_memory())
    later = []
    for _ in range(3):
        view.GetActiveCamera().Azimuth(20)
        view.CameraPosition = view.GetActiveCamera().GetPosition()
        again = time.monotonic()
        render()
        later.append(time.monotonic() - again)
    results["laterSeconds"] = sorted(later)[1]
    if wanted["picture"]:
        simple.SaveScreenshot(wanted["picture"], view)
    return results


def main():
    wanted = json.loads(os.environ["GATUN_MEASURE"])
    results = measure(wanted)
    with open(wanted["results"], "w", encoding="ascii") as file:
        json.dump(results, file)
    # Closing the window would ask questions.
    os._exit(0)


main()

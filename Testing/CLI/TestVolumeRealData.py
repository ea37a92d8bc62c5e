# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""A CT and an MR scan: packed as well as is asked for, unpacked and drawn."""

import json
import os

import numpy as np

import gatunVolumes as gv
from gatunCli import enter_folder, gtn, skip

folder = os.environ.get("GATUN_DATA_DIR")
files = [os.path.join(folder or "", name) for name in ("CT_AVM.nii.gz", "brain1_mr_int16.vti")]
if not folder or not all(os.path.exists(name) for name in files):
    skip("GATUN_DATA_DIR has no scans")
enter_folder("volume-real")
for name in files:
    values = gv.values_of(gv.read_image(name)).astype(float)
    for options, most in ((["--rms-error", 0], 0), (["--psnr", 45], None)):
        packed = json.loads(gtn("volume", "pack", "-f", "--json", *options, name, "scan.ghv"))
        gtn("volume", "unpack", "-f", "scan.ghv", "scan.vti")
        errors = gv.values_of(gv.read_image("scan.vti")) - values
        rms = np.sqrt((errors ** 2).mean())
        assert abs(rms - packed["rootMeanSquareError"]) <= 1e-6 * rms
        assert abs(errors).max() == packed["largestError"]
        assert most is None or abs(errors).max() == most
        assert most is not None or 20 * np.log10((values.max() - values.min()) / rms) >= 45
        print(name, packed["bitsPerVoxel"], rms)
    # With colors and opacities that do not follow from a histogram of voxels.
    look = ("volume", "render", "-f", "--size", "200x200", "--opacity-model", "exponential", "--range", "0,1000")
    gtn(*look, "scan.ghv", "of-file.png")
    gtn(*look, "--psnr", 45, name, "of-scan.png")
    one, other = (gv.vtk_to_numpy(gv.read_image(file).GetPointData().GetScalars()).astype(int)
                  for file in ("of-file.png", "of-scan.png"))
    assert (one[:, 3] > 20).mean() > 0.02
    # Where hardly anything is seen, colors that opacity is divided out of are noise.
    assert (abs(one - other).max(axis=1)[one[:, 3] > 8] > 3).mean() < 0.01

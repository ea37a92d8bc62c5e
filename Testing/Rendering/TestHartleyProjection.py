# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""Images from Hartley coefficients are those of the trilinear volume, for any position of the volume
and any view: compared with integrals along rays that numpy computes."""

import numpy as np

import gatunHartley as gh
import gatunRays as gr

SIZE = (40, 33)


def rotation(seed):
    q, r = np.linalg.qr(np.random.default_rng(seed).normal(size=(3, 3)))
    return q * np.sign(np.diag(r))


field = gh.blobs((14, 11, 17), seed=3, scale=100).astype(np.float32) + np.float32(7)
places = {
    "plain": dict(first=(0, 0, 0), origin=(0, 0, 0), spacing=(1, 1, 1), direction=None),
    "spacing": dict(first=(-4, 5, 6), origin=(3, -2, 1), spacing=(0.5, 1.5, -2), direction=None),
    "oblique": dict(first=(1, 2, 3), origin=(1, 2, 3), spacing=(0.7, 1.1, 1.9),
                    direction=rotation(5)),
    "sheared": dict(first=(0, 0, 0), origin=(0, 0, 0), spacing=(1, 1, 1),
                    direction=[[1, 0.4, 0], [0, 1, 0.3], [0, 0, 1]]),
}
worst = {}


def note(key, errors):
    mean, largest = worst.get(key, (0, 0))
    worst[key] = max(mean, errors.mean()), max(largest, errors.max())


for number, (name, place) in enumerate(places.items()):
    image = gh.make_volume(field, **place)
    bounds = np.array(image.GetBounds())
    focus = (bounds[::2] + bounds[1::2]) / 2 + (0.3, -0.2, 0.1)
    scale = np.linalg.norm(bounds[1::2] - bounds[::2]) / 2
    for turn in range(3):
        axes = rotation(100 * number + turn)
        camera = gr.make_camera(axes[0], axes[1], focus, scale)
        exact = gr.integrals(image, field, camera, SIZE)
        for options in (dict(BlockSize=2), dict(BlockSize=8), dict(BlockSize=0),
                        dict(BlockSize=16, Method=2)):
            step = 0.25 * (turn + 1)
            sums = gr.draw(image, camera, "Sum", OpacityModel=0, Size=SIZE, SampleDistance=step,
                           **gr.LOSSLESS, **options)
            note("sums " + str(options), abs(sums * step - exact) / exact.max())
            # In the exponential model, opacity does not depend on the blocks.
            rgba = gr.draw(image, camera, "RGBA", OpacityModel=1, Size=SIZE, Extinction=0.003, Zero=0,
                           **gr.LOSSLESS, **options)
            note("opacity " + str(options), abs(rgba[..., 3] - (1 - np.exp(-0.003 * exact))))
for key, (mean, largest) in worst.items():
    print("%-40s mean %.1e, largest %.1e" % (key, mean, largest))
# Images of blocks are interpolated at the pixels, and silhouettes are sharp.
assert max(mean for mean, _ in worst.values()) < 2e-3
assert max(largest for _, largest in worst.values()) < 2e-2

# Samples are the sum of a volume of ones.
image = gh.make_volume(field, **places["oblique"])
camera = gr.make_camera((0.3, -0.5, 0.8), focus=image.GetCenter(), scale=14)
samples = gr.draw(image, camera, "Samples", OpacityModel=0, Size=SIZE, SampleDistance=0.5)
exact = gr.integrals(image, np.ones_like(field), camera, SIZE) / 0.5
errors = abs(samples - exact) / exact.max()
assert errors.mean() < 2e-3 and errors.max() < 2e-2, (errors.mean(), errors.max())

# Along the axes sums are just sums, with the sample distance that is the default.
camera = gr.make_camera((0, 0, -1), focus=(8, 5, 0), scale=5.5)
plain = gh.make_volume(field)
sums = gr.draw(plain, camera, "Sum", OpacityModel=0, Size=(17, 11), Method=1, **gr.LOSSLESS)
assert abs(sums - field.sum(0)).max() < 1e-3 * sums.max()
# The X-ray by the spectrum of the whole volume, which is the default, is within the documented bound.
sums = gr.draw(plain, camera, "Sum", OpacityModel=0, Size=(17, 11), **gr.LOSSLESS)
assert np.square(sums - field.sum(0)).mean() < 0.02 * (sums.max() / 255) ** 2
camera = gr.make_camera((1, 0, 0), (0, 0, 1), (8, 5, 6.5), 7)
sums = gr.draw(plain, camera, "Sum", OpacityModel=0, Size=(11, 14), Method=1, **gr.LOSSLESS)
assert abs(sums - field.sum(2)[:, ::-1]).max() < 1e-3 * sums.max()  # right is towards -y

# The same data with axes in another order, and a direction that puts them back: the same picture.
camera = gr.make_camera((0.4, 0.5, -0.7), focus=plain.GetCenter(), scale=12)
colors = gr.make_property([(7, 0, 0, 1), (107, 1, 0.5, 0)], [(7, 0), (107, 0.3)])
for model in (0, 1, 2):
    settings = dict(OpacityModel=model, Property=colors, Size=SIZE, **gr.LOSSLESS)
    expected = gr.draw(plain, camera, "RGBA", **settings)
    assert len(np.unique(np.rint(255 * expected))) > 50
    for order in ((1, 2, 0), (2, 1, 0), (0, 2, 1)):
        # Axis i of the new volume is axis order[i] of the old one, along x, y, z.
        moved = np.ascontiguousarray(field.transpose([2 - order[2 - i] for i in range(3)]))
        direction = np.zeros((3, 3))
        direction[order, range(3)] = 1
        same = gh.make_volume(moved, direction=direction)
        assert np.allclose(same.GetBounds(), plain.GetBounds())
        got = gr.draw(same, camera, "RGBA", **settings)
        assert abs(got - expected).max() <= 0.004, (model, order, abs(got - expected).max())
    # So with voxels that are counted backwards, where the blocks are others.
    flipped = gh.make_volume(np.ascontiguousarray(field[:, :, ::-1]), spacing=(-1, 1, 1),
                             origin=(16, 0, 0))
    got = gr.draw(flipped, camera, "RGBA", **settings)
    errors = abs(got - expected)
    print("backwards, model %d: mean %.1e, largest %.1e" % (model, errors.mean(), errors.max()))
    assert errors.mean() < 0.01 and errors.max() < 0.1, model

# A constant volume: opacity is that of so much length, and the color that of the value.
box = gh.make_volume(np.full((20, 24, 28), 5, np.uint8), spacing=(0.5, 0.5, 0.5))
camera = gr.make_camera((0, 0, 1), focus=box.GetCenter(), scale=3)
half = gr.make_property([(0, 0, 0, 0), (10, 1, 0.4, 0.2)], [(0, 0.4), (10, 0.4)], 4)
for distance in (0, 0.1, 3):
    rgba = gr.draw(box, camera, "RGBA", Property=half, SampleDistance=distance, Size=(10, 10))
    expected = 1 - 0.6 ** (20 * 0.5 / 4)
    assert abs(rgba[..., 3] - expected).max() < 0.005, (distance, rgba[..., 3].min(), expected)
    assert abs(rgba[..., :3] / rgba[..., 3:] - (0.5, 0.2, 0.1)).max() < 0.002
# Gray functions too, and bytes are the colors that are not multiplied.
bytes_ = gr.draw(box, camera, Property=half, Size=(10, 10))
assert abs(bytes_.astype(int) - (128, 51, 26, round(255 * expected))).max() <= 1, bytes_[0, 0]
gray = gr.make_property([], [(0, 0.4)], 4)
gray.SetColor(half.GetScalarOpacity())
bytes_ = gr.draw(box, camera, Property=gray, Size=(10, 10))
assert abs(bytes_[..., :3].astype(int) - 102).max() <= 1
over = gr.draw(box, camera, "RGBA", Property=half, Size=(10, 10), Background=(0, 1, 0))
assert abs(over[..., 3] - 1).max() < 1e-6
assert abs(over[..., 1] - (0.2 * expected + 1 - expected)).max() < 0.005

# The window of an X-ray, and by itself.
sums = gr.draw(plain, camera, "Sum", OpacityModel=0, Size=SIZE)
shown = gr.draw(plain, camera, "RGBA", OpacityModel=0, Size=SIZE, Window=(500, 900))
inside = gr.draw(plain, camera, "Samples", OpacityModel=0, Size=SIZE) > 1
expected = np.clip((sums - 500) / 400, 0, 1)
assert inside.any() and abs(shown[..., 0] - expected)[inside].max() < 1e-3
shown = gr.draw(plain, camera, "RGBA", OpacityModel=0, Size=SIZE)
assert shown[..., 0].max() > 0.999

# Without a camera all of the volume is seen, and pixels are square.
for size in (50, 50), (160, 40), (40, 160):
    projection = gr.make_projection(plain, None, OpacityModel=0, Size=size)
    projection.Update()
    samples = gr.array_of(projection, "Samples")
    assert samples.max() > 0 and not samples[[0, -1]].any() and not samples[:, [0, -1]].any()
    spacing = projection.GetOutput().GetSpacing()
    assert abs(spacing[0] - spacing[1]) < 1e-12 * spacing[0]
    total = samples.sum() * spacing[0] * spacing[1]
    assert abs(total - field.size) < 0.03 * field.size, (total, field.size)
    # That is the view of a camera along the z axis, which can be magnified.
    camera = gr.make_camera((0, 0, -1))
    assert projection.ResetCamera(camera)
    same = gr.draw(plain, camera, "Samples", OpacityModel=0, Size=size)
    assert abs(same - samples).max() < 1e-3 * samples.max()
    camera.Zoom(2)
    zoomed = gr.draw(plain, camera, "Samples", OpacityModel=0, Size=size)
    assert (zoomed > 0).sum() > 1.9 * (samples > 0).sum()

# ResetCamera keeps the direction and shows all.
camera = gr.make_camera((1, 1, 1), (0, 0, 1), (50, 60, 70), 0.1)
camera.ParallelProjectionOff()
projection = gr.make_projection(plain, None, OpacityModel=0, Size=(30, 60))
assert projection.ResetCamera(camera)
projection.SetCamera(camera)
projection.Update()
assert np.allclose(camera.GetDirectionOfProjection(), np.ones(3) / 3 ** 0.5)
assert camera.GetParallelProjection() and np.allclose(camera.GetFocalPoint(), plain.GetCenter())
samples = gr.array_of(projection, "Samples")
assert samples.max() > 0 and not samples[[0, -1]].any() and not samples[:, [0, -1]].any()

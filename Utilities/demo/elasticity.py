# SPDX-FileCopyrightText: Copyright (c) 2026, the Gatun authors
# SPDX-License-Identifier: BSD-3-Clause

"""How a part bends under load: linear elasticity on linear tetrahedra, by conjugate gradients.

Lengths are in millimetres, forces in newtons, stresses in megapascals.
"""

import numpy as np

YOUNG = 70000.0  # aluminium
POISSON = 0.33


def _lame():
    """The two constants of an isotropic material."""
    return (
        YOUNG * POISSON / ((1 + POISSON) * (1 - 2 * POISSON)),
        YOUNG / (2 * (1 + POISSON)),
    )


class Solid:
    """A tetrahedral mesh with what is needed to compute the forces of a displacement."""

    def __init__(self, points, tets):
        corners = points[tets]
        edges = corners[:, 1:] - corners[:, :1]
        inverse = np.linalg.inv(edges)
        self.volumes = np.abs(np.linalg.det(edges)) / 6
        # gradients[t, a] is that of corner a's hat function in tetrahedron t.
        self.gradients = np.empty((len(tets), 4, 3))
        self.gradients[:, 1:] = np.swapaxes(inverse, 1, 2)
        self.gradients[:, 0] = -self.gradients[:, 1:].sum(axis=1)
        self.tets = tets
        self.count = len(points)
        self._assemble()

    def _assemble(self):
        """The stiffness between each two points of a tetrahedron, a 3 x 3 matrix, row by row."""
        a, b = (pair.ravel() for pair in np.meshgrid(range(4), range(4), indexing="ij"))
        key = (self.tets[:, a].astype(np.int64) * self.count + self.tets[:, b]).ravel()
        order = np.argsort(key, kind="stable")
        key = key[order]
        first = np.flatnonzero(np.concatenate([[True], key[1:] != key[:-1]]))
        rows, self.column = np.divmod(key[first], self.count)
        self.used, self.row_start = np.unique(rows, return_index=True)

        lame, shear = _lame()
        across = np.einsum("tai,tbi->tab", self.gradients, self.gradients).reshape(-1, 16)
        weights = self.volumes[:, None]
        self.blocks = {}
        for i in range(3):
            for j in range(3):
                one, other = self.gradients[:, :, i], self.gradients[:, :, j]
                block = lame * one[:, a] * other[:, b] + shear * other[:, a] * one[:, b]
                if i == j:
                    block += shear * across
                values = (weights * block).ravel()[order]
                self.blocks[i, j] = np.add.reduceat(values, first)
        diagonal = rows == self.column
        self.diagonal = np.ones((self.count, 3))
        for i in range(3):
            self.diagonal[rows[diagonal], i] = self.blocks[i, i][diagonal]

    def forces(self, displacement):
        """The forces at the points that this displacement needs."""
        at_column = [np.ascontiguousarray(displacement[:, j])[self.column] for j in range(3)]
        forces = np.zeros_like(displacement)
        for i in range(3):
            products = sum(self.blocks[i, j] * at_column[j] for j in range(3))
            forces[self.used, i] = np.add.reduceat(products, self.row_start)
        return forces

    def stress(self, displacement):
        """The stress tensor of each tetrahedron."""
        gradient = np.einsum("tai,taj->tij", displacement[self.tets], self.gradients)
        strain = 0.5 * (gradient + np.swapaxes(gradient, 1, 2))
        lame, shear = _lame()
        trace = np.trace(strain, axis1=1, axis2=2)
        return 2 * shear * strain + lame * trace[:, None, None] * np.eye(3)

    def point_mean(self, values):
        """Cell values as point values, weighted by volume."""
        corner = self.tets.ravel()
        weights = np.repeat(self.volumes, 4)
        total = np.bincount(corner, weights, minlength=self.count)
        mean = np.bincount(corner, weights * np.repeat(values, 4), minlength=self.count)
        return mean / np.maximum(total, 1e-300)


def solve(solid, fixed, load, start=None, tolerance=1e-4, most=3000, report=None):
    """The displacement under a load (points, 3), where the points of the mask stay in place.

    A start near the solution saves iterations.
    """
    free = ~fixed[:, None]
    weight = 1 / solid.diagonal
    displacement = np.zeros_like(load) if start is None else np.where(free, start, 0.0)
    goal = tolerance * np.linalg.norm(np.where(free, load, 0.0))
    residual = np.where(free, load - solid.forces(displacement), 0.0)
    step = weight * residual
    scalar = np.sum(residual * step)
    for iteration in range(most):
        left = np.linalg.norm(residual)
        if report and iteration % 100 == 0:
            report(iteration, left / (goal / tolerance))
        if left <= goal:
            break
        response = np.where(free, solid.forces(step), 0.0)
        length = scalar / np.sum(step * response)
        displacement += length * step
        residual -= length * response
        preconditioned = weight * residual
        previous, scalar = scalar, np.sum(residual * preconditioned)
        step = preconditioned + scalar / previous * step
    return displacement


def von_mises(stress):
    """The equivalent stress, which says how near to yielding the material is."""
    deviator = stress - np.eye(3) * np.trace(stress, axis1=1, axis2=2)[:, None, None] / 3
    return np.sqrt(1.5 * np.sum(deviator**2, axis=(1, 2)))

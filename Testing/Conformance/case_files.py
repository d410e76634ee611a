"""Grids, phantoms and the registry of cases. License: CC0 1.0."""
import dataclasses
import shutil
import typing

import numpy as np

COLUMNS = (
    ["name", "format", "title", "clause", "expectation"]
    + ["size_x", "size_y", "size_z", "spacing_x", "spacing_y", "spacing_z", "origin_x", "origin_y", "origin_z"]
    + [f"direction_{row}{column}" for row in "xyz" for column in "xyz"]
)
CASES = []

VOXELS = "voxels"  # intensity and place of every voxel; NaN in the array: any intensity
PLACES = "places"  # slices on no rectangular grid: center and extent of the voxels above BRIGHT
REFUSAL = "refusal"  # any volume is wrong
BRIGHT = 500.0


@dataclasses.dataclass
class Grid:
    """LPS, mm; columns of the direction are the axes x, y, z of the array."""

    size: tuple = (14, 10, 6)
    spacing: tuple = (0.75, 1.25, 2.5)
    origin: tuple = (-31.0, 17.0, -105.5)
    direction: np.ndarray = dataclasses.field(default_factory=lambda: np.eye(3))

    def place(self, x, y, z):
        return np.array(self.origin) + self.direction @ (np.array(self.spacing) * (x, y, z))


def oblique():
    """A rotation about no coordinate axis."""
    axis = np.array([0.36, -0.48, 0.8])
    angle = 0.6
    cross = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def phantom(grid=Grid()):
    """Integers, indexed z, y, x: a ramp along each axis, and a box that is 400 higher."""
    z, y, x = np.indices(grid.size[::-1])
    box = (x >= 4) & (x < 9) & (y >= 3) & (y < 7) & (z >= 2) & (z < 5)
    return 7 * x + 3 * y + 11 * z + 400 * box


@dataclasses.dataclass
class Case:
    name: str
    format: str
    title: str
    clause: str
    expectation: str
    make: typing.Callable

    def write(self, folder):
        target = folder / "cases" / self.name
        shutil.rmtree(target, ignore_errors=True)
        target.mkdir(parents=True)
        grid, voxels = self.make(target)
        row = dict(zip(COLUMNS, (self.name, self.format, self.title, self.clause, self.expectation)))
        if grid is not None:
            numbers = [*grid.size, *grid.spacing, *grid.origin, *np.asarray(grid.direction).ravel()]
            row.update(zip(COLUMNS[5:], (repr(float(n)) if i > 2 else int(n) for i, n in enumerate(numbers))))
            np.asarray(voxels, "<f4").tofile(folder / "expected" / (self.name + ".f32"))
        return row


def case(name, form, title, clause, expectation=VOXELS):
    """Registers a function that writes the files into a folder and returns the grid and the voxels (z, y, x)."""

    def register(make):
        CASES.append(Case(name, form, title, clause, expectation, make))
        return make

    return register

"""Blades of any shape as meshes: a plate sheared, cambered, twisted and warped, its nodes out of line, of shells or of bricks."""

import math

import meshes
import numpy as np


class Shape:
    """Maps (s along the span 0..1, c along the chord -0.5..0.5) to a point (m).

    `skew`: angle (rad) by which the root's edge leans; `camber`: angle (rad) of the arc that the chord is bent to; `twist`: angle (rad)
    by which the tip is turned about x; `taper`: by how much the tip's chord is shorter, as a share."""

    def __init__(self, length, chord, skew=0., camber=0., twist=0., taper=0.):
        self.length, self.chord = length, chord
        self.skew, self.camber, self.twist, self.taper = skew, camber, twist, taper

    def point(self, s, c):
        width = self.chord * (1. - self.taper * s)
        x = self.length * s + math.tan(self.skew) * self.chord * c
        if self.camber > 0.:
            radius, angle = width / self.camber, self.camber * c
            y, z = radius * math.sin(angle), radius * (1. - math.cos(angle))
        else:
            y, z = width * c, 0.
        turn = self.twist * s
        return np.array((x, y * math.cos(turn) - z * math.sin(turn), y * math.sin(turn) + z * math.cos(turn)))

    def tangents(self, s, c, step=1e-5):
        """Unit vectors along span and in the surface across it, and their normal."""
        along = self.point(s + step, c) - self.point(s - step, c)
        across = self.point(s, c + step) - self.point(s, c - step)
        normal = np.cross(along, across)
        along, normal = along / np.linalg.norm(along), normal / np.linalg.norm(normal)
        return along, np.cross(normal, along), normal


class Blade:
    """`warp`, `jitter`: how far nodes lie off the surface and, in it, off their row, as shares of an element's shorter side."""

    def __init__(self, shape, n_span, n_chord, thickness, layers=0, warp=0., jitter=0., second_metal=None, draw=None):
        self.shape, self.n, self.thickness, self.layers = shape, (n_span, n_chord), thickness, layers
        side = min(shape.length / n_span, shape.chord * (1. - shape.taper) / n_chord)
        points, normals = [], []
        for i in range(n_span + 1):
            for j in range(n_chord + 1):
                s, c = i / n_span, j / n_chord - 0.5
                along, across, normal = shape.tangents(s, c)
                inner_s, inner_c = 0 < i < n_span, 0 < j < n_chord
                offset = warp * side * (0.5 if (i + j) % 2 else -0.5) * normal
                if jitter > 0.:
                    offset = offset + jitter * side * ((draw.uniform(-1., 1.) * inner_s) * along + (draw.uniform(-1., 1.) * inner_c) * across)
                points.append(tuple(shape.point(s, c) + offset))
                normals.append(tuple(normal))
        cells = meshes.grid_cells(n_span, n_chord)
        metals = [2 if second_metal and second_metal(k // n_chord / n_span, k % n_chord / n_chord) else 1 for k in range(len(cells))]
        self.surface = meshes.Mesh(points, cells, meshes.edges(n_span, n_chord), metals)
        self.mesh = meshes.body(self.surface, normals, thickness, layers) if layers else self.surface

    def middle(self, displaced):
        """Points of the mid-surface, then the means of its cells' corners, where the mesh's points are `displaced` [n][3] (m)."""
        n = len(self.surface.points)
        points = 0.5 * (displaced[:n] + displaced[-n:]) if self.layers else displaced
        return np.concatenate((points, points[np.array(self.surface.cells)].mean(axis=1)))

    def triangles(self):
        """[m][3] numbers of points of middle(): four about the mean of a cell, as contact has it of a warped one."""
        n = len(self.surface.points)
        return np.array([(cell[k - 1], cell[k], n + number) for number, cell in enumerate(self.surface.cells) for k in range(4)])

    def shortest_side(self):
        points = np.array(self.surface.points)
        corners = points[np.array(self.surface.cells)]
        sides = np.linalg.norm(corners - np.roll(corners, 1, axis=1), axis=2).min()
        return min(sides, self.thickness / self.layers) if self.layers else sides

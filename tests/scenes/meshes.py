"""Meshes of the scenes, in Gmsh's format 2.2: boundaries 10 root, 11 tip, 12 and 13 the long edges; of bodies 15 and 16 the faces."""

import math
import random


class Mesh:
    """`cells`: four corners of a surface, eight of a body (Gmsh's order); `sides`: (boundary id, two or four points); `materials`: an id a
    cell. `turned`: every cell goes round the other way. `seed`: points, cells and the point that a surface's cell begins with are
    drawn anew."""

    def __init__(self, points, cells, sides, materials=None, turned=False, seed=None):
        self.points, self.cells, self.sides = points, cells, sides
        self.materials, self.turned, self.seed = materials or [1] * len(cells), turned, seed

    def moved(self, place):
        """With every point where `place` puts it."""
        return Mesh([place(p) for p in self.points], self.cells, self.sides, self.materials, self.turned, self.seed)

    def listed(self, turned, seed):
        return Mesh(self.points, self.cells, self.sides, self.materials, turned, seed)

    def write(self, name):
        order, cells = list(range(len(self.points))), list(zip(self.cells, self.materials))
        if self.turned:
            cells = [(c[::-1] if len(c) == 4 else c[4:] + c[:4], m) for c, m in cells]
        if self.seed is not None:
            draw = random.Random(self.seed)
            draw.shuffle(order)
            cells = [(c[k:] + c[:k] if len(c) == 4 else c, m) for c, m in cells for k in (draw.randrange(4),)]
            draw.shuffle(cells)
        number = {point: k + 1 for k, point in enumerate(order)}
        kind = {2: 1, 4: 3, 8: 5}
        with open(name, "w") as file:
            file.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(order)}\n")
            for point in order:
                file.write("%d %.17g %.17g %.17g\n" % (number[point], *self.points[point]))
            file.write(f"$EndNodes\n$Elements\n{len(self.sides) + len(cells)}\n")
            for k, (corners, tag) in enumerate([(side[1:], side[0]) for side in self.sides] + cells):
                file.write(f"{k + 1} {kind[len(corners)]} 2 {tag} {tag} {' '.join(str(number[p]) for p in corners)}\n")
            file.write("$EndElements\n")


def plate(length, chord, n_span, n_chord):
    """A plate in z = 0; cells turn from x to y, so that normals are +z."""
    points = [(length * i / n_span, chord * (j / n_chord - 0.5), 0.) for i in range(n_span + 1) for j in range(n_chord + 1)]
    return Mesh(points, grid_cells(n_span, n_chord), edges(n_span, n_chord))


def slivers(length, chord, n_span, n_chord):
    """The plate in elements ten times as long as wide with corners of 20 degrees (lines across lean to and fro between the edges, least at
    root and tip), neighbours of which are folded by some 20 degrees against one another."""
    width, height = length / n_span, chord / n_chord
    lean, fold = 0.5 * height / math.tan(math.radians(20.)), 0.5 * width * math.tan(math.radians(5.))
    points = []
    for i in range(n_span + 1):
        for j in range(n_chord + 1):
            inner = math.sin(math.pi * i / n_span)
            x = length * i / n_span + (lean * inner * (-1) ** j if 0 < j < n_chord else 0.)
            points.append((x, chord * (j / n_chord - 0.5), fold * inner * (-1) ** (i + j)))
    return Mesh(points, grid_cells(n_span, n_chord), edges(n_span, n_chord))


def folded_sheet(length, width, gap, n_length, n_width, n_gap):
    """A sheet that comes in at z = 0, turns upwards at x = 0 and goes back at z = gap."""
    line = [(length * (1. - i / n_length), 0.) for i in range(n_length)] + [(0., gap * i / n_gap) for i in range(n_gap)]
    line += [(length * i / n_length, gap) for i in range(n_length + 1)]
    points = [(x, width * (j / n_width - 0.5), z) for x, z in line for j in range(n_width + 1)]
    return Mesh(points, grid_cells(len(line) - 1, n_width), edges(len(line) - 1, n_width))


def body(surface, normals, thickness, n_layers):
    """Bricks in layers on a surface with a normal a point."""
    n = len(surface.points)
    points = [tuple(x + thickness * (k / n_layers - 0.5) * d for x, d in zip(p, normal))
              for k in range(n_layers + 1) for p, normal in zip(surface.points, normals)]
    lift = [(k * n, (k + 1) * n) for k in range(n_layers)]
    cells = [tuple(p + low for p in c) + tuple(p + high for p in c) for low, high in lift for c in surface.cells]
    sides = [(tag, a + low, b + low, b + high, a + high) for low, high in lift for tag, a, b in surface.sides]
    sides += [(tag, *(p + at for p in c)) for tag, at in ((15, 0), (16, n_layers * n)) for c in surface.cells]
    return Mesh(points, cells, sides, surface.materials * n_layers)


def grid_cells(n, m):
    row = m + 1
    return [(i * row + j, (i + 1) * row + j, (i + 1) * row + j + 1, i * row + j + 1) for i in range(n) for j in range(m)]


def edges(n, m):
    """(boundary id, point, point) of a grid of n by m cells."""
    row = m + 1
    result = [(10, j, j + 1) for j in range(m)] + [(11, n * row + j, n * row + j + 1) for j in range(m)]
    result += [(12, i * row, (i + 1) * row) for i in range(n)] + [(13, i * row + m, (i + 1) * row + m) for i in range(n)]
    return result

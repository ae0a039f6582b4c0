"""Surface meshes of the scenes, in Gmsh's format 2.2: physical lines 10 root, 11 tip, 12 and 13 the long edges."""

import random


def plate(length, chord, n_span, n_chord):
    """Points and cells of a plate in z = 0; cells turn from x to y, so that normals are +z."""
    points = [(length * i / n_span, chord * (j / n_chord - 0.5), 0.) for i in range(n_span + 1) for j in range(n_chord + 1)]
    return points, grid_cells(n_span, n_chord)


def folded_sheet(length, width, gap, n_length, n_width, n_gap):
    """A sheet that comes in at z = 0, turns upwards at x = 0 and goes back at z = gap."""
    line = [(length * (1. - i / n_length), 0.) for i in range(n_length)] + [(0., gap * i / n_gap) for i in range(n_gap)]
    line += [(length * i / n_length, gap) for i in range(n_length + 1)]
    points = [(x, width * (j / n_width - 0.5), z) for x, z in line for j in range(n_width + 1)]
    return points, grid_cells(len(line) - 1, n_width)


def grid_cells(n, m):
    row = m + 1
    return [(i * row + j, (i + 1) * row + j, (i + 1) * row + j + 1, i * row + j + 1) for i in range(n) for j in range(m)]


def edges(n, m):
    """(boundary id, point, point) of a grid of n by m cells."""
    row = m + 1
    result = [(10, j, j + 1) for j in range(m)] + [(11, n * row + j, n * row + j + 1) for j in range(m)]
    result += [(12, i * row, (i + 1) * row) for i in range(n)] + [(13, i * row + m, (i + 1) * row + m) for i in range(n)]
    return result


def write(name, points, cells, lines, turned=False, seed=None):
    """Writes the file. `turned`: every cell goes round the other way. `seed`: points, cells and the point that a cell begins with
    are drawn anew."""
    order = list(range(len(points)))
    cells = [c[::-1] if turned else c for c in cells]
    if seed is not None:
        draw = random.Random(seed)
        draw.shuffle(order)
        cells = [c[k:] + c[:k] for c in cells for k in (draw.randrange(4),)]
        draw.shuffle(cells)
    number = {point: k + 1 for k, point in enumerate(order)}
    with open(name, "w") as file:
        file.write(f"$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{len(points)}\n")
        for point in order:
            file.write("%d %.17g %.17g %.17g\n" % (number[point], *points[point]))
        file.write(f"$EndNodes\n$Elements\n{len(lines) + len(cells)}\n")
        for k, (boundary, a, b) in enumerate(lines):
            file.write(f"{k + 1} 1 2 {boundary} {boundary} {number[a]} {number[b]}\n")
        for k, cell in enumerate(cells):
            file.write(f"{len(lines) + k + 1} 3 2 1 1 {' '.join(str(number[p]) for p in cell)}\n")
        file.write("$EndElements\n")

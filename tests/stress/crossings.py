"""Whether particles have gone through an intact blade, by what the field files say alone."""

import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "source", "python"))
import birdstrike  # noqa: E402

NEAREST = 12  # triangles about a particle that are looked at
RIM = 2.     # spacings from the edge, within which a particle may go round it between two files


def displaced(mesh, places):
    """The blade's points in the order of `places` (as drawn), where they are now."""
    points = mesh.points.astype(float)
    order = [int(np.argmin(np.abs(points - place).sum(axis=1))) for place in places]
    return order, lambda now: places + now.nodes["displacement"].astype(float)[order]


def sides(corners, points):
    """Signed distances of points [p][3] from the planes of triangles [p][k][3][3], whether they lie over them, a twentieth within, and
    the triangles' normals."""
    a, b, c = corners[..., 0, :], corners[..., 1, :], corners[..., 2, :]
    normal = np.cross(b - a, c - a)
    area = np.linalg.norm(normal, axis=-1, keepdims=True)
    normal = normal / np.maximum(area, 1e-300)
    to = points[:, None, :] - a
    distance = np.einsum("pkd,pkd->pk", to, normal)

    def share(p, q):
        return np.einsum("pkd,pkd->pk", np.cross(p, q), normal) / np.maximum(area[..., 0], 1e-300)
    v, w = share(to, c - a), share(b - a, to)
    return distance, (v > 0.05) & (w > 0.05) & (v + w < 0.95), normal


def distance_to_edge(point, surface, edge):
    """Of a point from the nearest of the segments `edge` [m][2]."""
    begin, along = surface[edge[:, 0]], surface[edge[:, 1]] - surface[edge[:, 0]]
    share = np.clip(np.einsum("md,md->m", point - begin, along) / np.maximum(np.einsum("md,md->m", along, along), 1e-300), 0., 1.)
    return np.linalg.norm(begin + share[:, None] * along - point, axis=1).min()


def has_row_in_plane(run_folder, spacing):
    """Whether particles of the first file lie at y = 0."""
    return bool(np.any(np.abs(birdstrike.Run(run_folder).bird(0.).points[:, 1]) < 0.1 * spacing))


def count(run_folder, blade, spacing):
    """Particles that were on one side of the mid-surface in one file and on the other in the next, over the same triangle both times."""
    run = birdstrike.Run(run_folder)
    times = run.times("bird")
    triangles, crossed = blade.triangles(), set()
    edge = np.array([(a, b) for _, a, b in blade.surface.sides])
    order, place = displaced(run.blade(times[0]), np.array(blade.mesh.points))
    last = None
    for time in times:
        particles, surface = run.bird(time), blade.middle(place(run.blade(time)))
        if len(particles.points) == 0:
            break
        corners = surface[triangles]
        order_of_ids = np.argsort(particles.nodes["id"])  # files have them as they lie in memory
        points = particles.points.astype(float)[order_of_ids]
        now = (particles.nodes["id"][order_of_ids], points, corners, surface)
        if last is not None and len(last[1]) == len(points):
            centres = corners.mean(axis=1)
            far = np.linalg.norm(points[:, None, :] - centres[None], axis=2)
            chosen = np.argsort(far, axis=1)[:, :NEAREST]
            before, was_over, old_normal = sides(last[2][chosen], last[1])
            after, is_over, normal = sides(corners[chosen], points)
            is_same = np.einsum("pkd,pkd->pk", old_normal, normal) > 0.5  # else one of a crumpled cell has turned over
            through = (before * after < 0.) & was_over & is_over & is_same & (np.maximum(abs(before), abs(after)) < spacing)
            crossed.update(int(now[0][i]) for i in np.flatnonzero(np.any(through, axis=1))
                           if min(distance_to_edge(points[i], surface, edge), distance_to_edge(last[1][i], last[3], edge)) > RIM * spacing)
        last = now
    return len(crossed)

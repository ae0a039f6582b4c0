"""Scenes of the newer kinds told otherwise, of which only round-off may tell: birds in another order, plies cut in two or counted from another
corner, a row seen from the next blade or counted backwards, a speed written as a formula."""

import math

import entries
import numpy as np
from placing import X, about_third, frame_of, vector_of, yaw_pitch_roll


def rotation(axis, angle):
    """About the axis by the angle (rad), right-handed (Rodrigues)."""
    x, y, z = axis / np.linalg.norm(axis)
    cross = np.array(((0., -z, y), (z, 0., -x), (-y, x, 0.)))
    return np.eye(3) + math.sin(angle) * cross + (1. - math.cos(angle)) * cross @ cross


def birds_reversed(scene):
    """The last bird is told of first."""
    twin, sections = scene.copy(), scene.info["birds"]
    other = dict(zip(sections, sections[::-1]))
    for path in [p for p in scene.settings if p.split("/")[0] in other]:
        del twin.settings[path]
    for path, value in scene.settings.items():
        section, *rest = path.split("/")
        if section in other and rest != ["Enabled"]:
            twin.settings["/".join((other[section], *rest))] = value
    for section in sections[1:]:
        twin.set(section + "/Enabled", "true")
    return twin, np.eye(3)


def plies_in_halves(scene):
    """Of plies that never fail: where they do, it is decided in the middle of each."""
    twin = scene.copy()
    twin.info["plies"] = [(angle, 0.5 * thickness, name) for angle, thickness, name in scene.info["plies"] for _ in range(2)]
    entries.set_plies(twin)
    return twin, np.eye(3)


def cells_listed_anew(scene):
    """Points and cells in another order, cells the other way round: shells look upwards all the same."""
    twin = scene.copy()
    twin.mesh = scene.mesh.listed(True, scene.seed)
    return twin, np.eye(3)


def speed_as_formula(scene):
    """Of a number, a formula without t in effect; of a formula, the other way of turning about the opposite axis."""
    twin = scene.copy()
    speed = scene.settings["Blade/Spin/Speed"]
    if "t" in speed.replace("sqrt", ""):
        twin.set("Blade/Spin/Speed", f"-({speed})")
        twin.set("Blade/Spin/Axis", [-float(c) for c in vector_of(scene, "Blade/Spin/Axis")])
    else:
        twin.set("Blade/Spin/Speed", f"{speed} + 0*t")
    return twin, np.eye(3)


def rigid_of(scene):
    return [int(k) for k in scene.settings["Blade/Mesh/Row/Rigid"].split()]


def row_backwards(scene):
    """About the opposite axis: blades count the other way, and the hub turns at the opposite speed."""
    twin, n = scene.copy(), int(scene.settings["Blade/Mesh/Row/Blades"])
    twin.set("Blade/Spin/Axis", [-float(c) for c in vector_of(scene, "Blade/Spin/Axis")])
    twin.set("Blade/Spin/Speed", f"-({scene.settings['Blade/Spin/Speed']})")
    twin.set("Blade/Mesh/Row/Place", n + 1 - int(scene.settings["Blade/Mesh/Row/Place"]))
    twin.set("Blade/Mesh/Row/Rigid", " ".join(str(n + 1 - k) for k in rigid_of(scene)))
    return twin, np.eye(3)


def row_from_next(scene):
    """The next elastic blade lies as described; the row and the bird are turned back by the pitches between them."""
    n, place, rigid = int(scene.settings["Blade/Mesh/Row/Blades"]), int(scene.settings["Blade/Mesh/Row/Place"]), rigid_of(scene)
    others = [k for k in (*range(place + 1, n + 1), *range(1, place)) if k not in rigid]
    if not others:
        return row_backwards(scene)
    twin = scene.copy()
    turn = rotation(vector_of(scene, "Blade/Spin/Axis"), math.radians((place - others[0]) * float(scene.settings["Blade/Mesh/Row/Pitch"])))
    centre = vector_of(scene, "Blade/Spin/Centre")
    twin.set("Blade/Mesh/Row/Place", others[0])
    twin.set("Bird/Aim point", [float(x) for x in turn @ (vector_of(scene, "Bird/Aim point") - centre) + centre])
    twin.set("Bird/Velocity", [float(v) for v in turn @ vector_of(scene, "Bird/Velocity")])
    turn_attitude(scene, twin, turn)
    return twin, turn


def turn_attitude(scene, twin, turn):
    velocity = vector_of(scene, "Bird/Velocity")
    attitude = turn @ frame_of(velocity, X) @ about_third(math.radians(float(scene.settings.get("Bird/Roll", "0"))))
    for name, angle in zip(("Yaw", "Pitch", "Roll"), yaw_pitch_roll(attitude, turn @ velocity, X)):
        twin.set("Bird/" + name, angle)


def told_otherwise(scene):
    """[(name, twin, how the impulse is turned)] of a scene; empty for kinds that know no other words."""
    ways = []
    if len(scene.info.get("birds", [])) > 1:
        ways.append(("order of birds", birds_reversed))
    if "plies" in scene.info:
        ways.append(("another list", cells_listed_anew))
        if not scene.info["can_fail"]:
            ways.append(("halves", plies_in_halves))
    if "Blade/Mesh/Row/Blades" in scene.settings:
        ways += [("backwards", row_backwards), ("from next", row_from_next)]
    elif "Blade/Spin/Speed" in scene.settings:
        ways.append(("formula", speed_as_formula))
    return [(name, *way(scene)) for name, way in ways]

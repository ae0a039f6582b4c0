"""The same strike elsewhere: turned or mirrored, 1000 m away, seen by somebody who moves."""

import math

import entries
import numpy as np

DISTANCE = 1000.  # m


X, Y, Z = np.eye(3)


def span_of(scene):
    """From the middle of the root's sides to that of the tip's, of a deformable blade from a file that names both; else x (span_of in
    source/simulation/scene.cc)."""
    ids = lambda entry: {int(word) for word in scene.settings.get("Blade/Supports/" + entry, "").replace(",", " ").split()}
    root, tip = ids("Hub") or ids("Clamped"), ids("Tip")
    if scene.mesh is None or scene.settings["Blade/Kind"] == "rigid" or not root or not tip:
        return X
    points = np.array(scene.mesh.points)

    def middle(of):
        sizes, middles = [], []
        for boundary, *corners in scene.mesh.sides:
            if boundary in of:
                x = points[list(corners)]
                sizes.append(np.linalg.norm(x[1] - x[0] if len(x) == 2 else 0.5 * np.cross(x[2] - x[0], x[3] - x[1])))
                middles.append(x.mean(axis=0))
        return np.average(middles, axis=0, weights=sizes)
    along = middle(tip) - middle(root)
    return along / np.linalg.norm(along)


def frame_of(velocity, span):
    """Columns: what the program takes for x, y, z of a bird with this velocity (compute_attitude in source/bird/attitude.cc)."""
    direction = velocity / np.linalg.norm(velocity)
    for of in (span, Y, Z):
        x = of - (of @ direction) * direction
        if np.linalg.norm(x) >= 1e-3:
            break
    x /= np.linalg.norm(x)
    return np.stack((x, np.cross(direction, x), direction), axis=1)


def yaw_pitch_roll(attitude, velocity, span):
    """Angles (degrees) that give a bird with this velocity the attitude."""
    m = frame_of(velocity, span).T @ attitude
    return [math.degrees(a) for a in (math.atan2(-m[1, 2], m[2, 2]), math.asin(max(-1., min(1., m[0, 2]))), math.atan2(-m[0, 1], m[0, 0]))]


def vector_of(scene, path):
    """The entry's three numbers."""
    return np.array([float(x) for x in scene.settings[path].replace(",", " ").split()])


def sections_of_birds(scene):
    return scene.info.get("birds", ["Bird"])


def slice_frame(normal, attitude):
    """Columns: x, y, z of a slice whose Roll is 0, of a bird with this attitude without roll (compute_slice_frame in source/bird/attitude.cc)."""
    n = normal / np.linalg.norm(normal)
    x = attitude[:, 0] - (attitude[:, 0] @ n) * n
    if np.linalg.norm(x) < 0.1:
        x = attitude[:, 2] - (attitude[:, 2] @ n) * n
    x /= np.linalg.norm(x)
    return np.stack((x, np.cross(n, x), n), axis=1)


def upward_normal(mesh):
    """Sum of the cells' areas (m^2) as the program has shells of a file look: with the first of z, y and x that is not next to nothing
    (face_upwards in source/mesh/blade_mesh.cc)."""
    points = np.array(mesh.points)
    corners = points[np.array([cell[:4] for cell in mesh.cells])]
    area = 0.5 * np.cross(corners[:, 2] - corners[:, 0], corners[:, 3] - corners[:, 1]).sum(axis=0)
    return area * next((math.copysign(1., area[k]) for k in (2, 1, 0) if abs(area[k]) > 0.01 * np.linalg.norm(area)), 1.)


def about_third(angle):
    return np.array(((math.cos(angle), -math.sin(angle), 0.), (math.sin(angle), math.cos(angle), 0.), (0., 0., 1.)))


def draw_turn(draw, is_mirrored):
    turn, triangle = np.linalg.qr(np.array([[draw.gauss(0., 1.) for _ in range(3)] for _ in range(3)]))
    turn = turn * np.sign(np.diag(triangle))
    if (np.linalg.det(turn) < 0.) != is_mirrored:
        turn[:, 0] *= -1.
    return turn


def draw_square_turn(draw, is_mirrored):
    """Of axes into axes, which boxes along them go through unchanged."""
    turn = np.diag([draw.choice((1., -1.)) for _ in range(3)])[draw.sample(range(3), 3)]
    if (np.linalg.det(turn) < 0.) != is_mirrored:
        turn[0] *= -1.
    return turn


class Place:
    """x -> turn x + shift, and velocities turn v + drift. `is_square`: turned by right angles only."""

    def __init__(self, draw, is_turned, is_mirrored, is_shifted, largest_drift, is_square=False):
        by = draw_square_turn if is_square else draw_turn
        self.turn = by(draw, is_mirrored) if is_turned else np.diag((1., 1., -1. if is_mirrored else 1.))
        unit = np.array([draw.gauss(0., 1.) for _ in range(3)])
        self.shift = DISTANCE * unit / np.linalg.norm(unit) if is_shifted else np.zeros(3)
        drift = np.array([draw.gauss(0., 1.) for _ in range(3)])
        self.drift = draw.uniform(0.1, 1.) * largest_drift * drift / np.linalg.norm(drift)
        self.is_mirrored = is_mirrored
        self.name = "+".join(n for n, on in (("turned", is_turned), ("mirrored", is_mirrored), ("shifted", is_shifted),
                                             ("moving", largest_drift > 0.)) if on)

    def point(self, x):
        return self.turn @ np.asarray(x) + self.shift

    def axial(self, w):
        """Of a rotation or a moment."""
        return (-1. if self.is_mirrored else 1.) * self.turn @ np.asarray(w)

    def apply(self, scene):
        """The scene's twin there."""
        twin = scene.copy()
        for section in sections_of_birds(scene):
            self.place_bird(scene, twin, section)
        if np.any(self.drift):
            twin.set("Blade/Loads/Initial velocity", "; ".join(repr(float(v)) for v in self.drift))
        self.place_blade(scene, twin)
        return twin

    def place_bird(self, scene, twin, section):
        """A lattice of the bird has mirror planes between its x and y, so that the mirrored one changes them."""
        velocity, aim = vector_of(scene, section + "/Velocity"), vector_of(scene, section + "/Aim point")
        distance = float(scene.settings[section + "/Stand-off"])
        start = self.point(aim - distance * velocity / np.linalg.norm(velocity))
        roll = math.radians(float(scene.settings.get(section + "/Roll", "0")))
        span = span_of(scene)
        span_there = self.turn @ span if span is not X else X
        attitude = self.turn @ frame_of(velocity, span) @ about_third(roll)
        if self.is_mirrored:
            attitude = attitude[:, (1, 0, 2)]
        seen = self.turn @ velocity + self.drift
        twin.set(section + "/Velocity", [float(v) for v in seen])
        twin.set(section + "/Aim point", [float(x) for x in start + distance * seen / np.linalg.norm(seen)])
        angles = yaw_pitch_roll(attitude, seen, span_there)
        if scene.settings.get(section + "/Slice/Normal"):
            angles[2] = self.place_slice(scene, twin, section, angles[:2], (velocity, span), (seen, span_there), roll)
        for name, angle in zip(("Yaw", "Pitch", "Roll"), angles):
            twin.set(f"{section}/{name}", angle)

    def place_slice(self, scene, twin, section, yaw_pitch, here, there, roll):
        """Its normal; the roll (degrees) about it that gives it the lattice."""
        normal = vector_of(scene, section + "/Slice/Normal")
        lattice = self.turn @ slice_frame(normal, frame_of(*here)) @ about_third(roll)
        if self.is_mirrored:
            lattice = lattice[:, (1, 0, 2)]
        twin.set(section + "/Slice/Normal", [float(c) for c in self.turn @ normal])
        yaw, pitch = (math.radians(angle) for angle in yaw_pitch)
        about_x = np.array(((1., 0., 0.), (0., math.cos(yaw), -math.sin(yaw)), (0., math.sin(yaw), math.cos(yaw))))
        about_y = np.array(((math.cos(pitch), 0., math.sin(pitch)), (0., 1., 0.), (-math.sin(pitch), 0., math.cos(pitch))))
        unrolled = slice_frame(self.turn @ normal, frame_of(*there) @ about_x @ about_y)
        return math.degrees(math.atan2(lattice[:, 0] @ unrolled[:, 1], lattice[:, 0] @ unrolled[:, 0]))

    def place_blade(self, scene, twin):
        """Shells look upwards wherever they are, so that a place may turn plies over and pressure about."""
        twin.mesh = scene.mesh.moved(lambda p: tuple(float(x) for x in self.point(p))).listed(self.is_mirrored, None)
        is_shell = scene.settings["Blade/Kind"] == "shell"
        looks_back = is_shell and self.turn @ upward_normal(scene.mesh) @ upward_normal(twin.mesh) < 0.
        if "Blade/Spin/Axis" in scene.settings:
            twin.set("Blade/Spin/Axis", [float(c) for c in self.axial(vector_of(scene, "Blade/Spin/Axis"))])
            twin.set("Blade/Spin/Centre", [float(x) for x in self.point(vector_of(scene, "Blade/Spin/Centre"))])
        info = twin.info
        if "plies" in info:
            direction = self.turn @ vector_of(scene, "Blade/Laminate/Reference direction")
            twin.set("Blade/Laminate/Reference direction", " ".join(repr(float(c)) for c in direction))
            info["plies"] = [(-angle if self.is_mirrored != looks_back else angle, *of) for angle, *of in info["plies"]][::-1 if looks_back else 1]
            entries.set_plies(twin)
        if "initial_spin" in info:
            spin = self.axial(info["initial_spin"])
            info.update(initial_spin=spin, initial_velocity=self.turn @ np.array(info["initial_velocity"]) - np.cross(spin, self.shift))
            entries.set_initial(twin)
        if "Blade/Loads/Pressure" in scene.settings and looks_back:
            twin.set("Blade/Loads/Pressure", f"-({scene.settings['Blade/Loads/Pressure']})")
        if "point_loads" in info:
            info["point_loads"] = [([float(x) for x in self.point(place)], [float(f) for f in self.turn @ np.array(force)],
                                    [float(m) for m in self.axial(moment)], law) for place, force, moment, law in info["point_loads"]]
            info["driven"] = [(side, [float(x) for x in self.turn @ np.array(way)], law) for side, way, law in info["driven"]]
            entries.set_loads(twin)


def waits(scene):
    """Whether a bird is woken where boxes along the axes come near, which says from when on it counts for the step of all."""
    return any(float(scene.settings.get(section + "/Arrival time", 0.)) > 0. for section in sections_of_birds(scene))


def draw_place(scene, draw):
    """All at once: one difference says that something is wrong, then each alone says what."""
    drift = draw.choice((0., 1.)) * scene.info["speed"] if scene.info.get("free") else 0.
    return Place(draw, True, draw.random() < 0.5, True, drift, waits(scene))


def apart(scene, draw, place):
    """Each part of a place by itself."""
    names = place.name.split("+")
    drift = scene.info["speed"] if "moving" in names else 0.
    places = [Place(draw, name == "turned", name == "mirrored", name == "shifted", drift if name == "moving" else 0., waits(scene))
              for name in names]
    for alone in places:
        if alone.name == "turned" and not place.is_mirrored:
            alone.turn = place.turn
    return places

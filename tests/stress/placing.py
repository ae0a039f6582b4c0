"""The same strike elsewhere: turned or mirrored, 1000 m away, seen by somebody who moves."""

import math

import numpy as np

DISTANCE = 1000.  # m


def frame_of(velocity):
    """Columns: what the program takes for x, y, z of a bird with this velocity (source/bird/packing.cc)."""
    direction = velocity / np.linalg.norm(velocity)
    span = np.array((1., 0., 0.)) - direction[0] * direction
    if np.linalg.norm(span) < 1e-3:
        span = np.array((0., 1., 0.)) - direction[1] * direction
    span /= np.linalg.norm(span)
    return np.stack((span, np.cross(direction, span), direction), axis=1)


def yaw_pitch_roll(attitude, velocity):
    """Angles (degrees) that give a bird with this velocity the attitude."""
    m = frame_of(velocity).T @ attitude
    return [math.degrees(a) for a in (math.atan2(-m[1, 2], m[2, 2]), math.asin(max(-1., min(1., m[0, 2]))), math.atan2(-m[0, 1], m[0, 0]))]


def draw_turn(draw, is_mirrored):
    turn, triangle = np.linalg.qr(np.array([[draw.gauss(0., 1.) for _ in range(3)] for _ in range(3)]))
    turn = turn * np.sign(np.diag(triangle))
    if (np.linalg.det(turn) < 0.) != is_mirrored:
        turn[:, 0] *= -1.
    return turn


class Place:
    """x -> turn x + shift, and velocities turn v + drift."""

    def __init__(self, draw, is_turned, is_mirrored, is_shifted, largest_drift):
        self.turn = draw_turn(draw, is_mirrored) if is_turned else np.diag((1., 1., -1. if is_mirrored else 1.))
        unit = np.array([draw.gauss(0., 1.) for _ in range(3)])
        self.shift = DISTANCE * unit / np.linalg.norm(unit) if is_shifted else np.zeros(3)
        drift = np.array([draw.gauss(0., 1.) for _ in range(3)])
        self.drift = draw.uniform(0.1, 1.) * largest_drift * drift / np.linalg.norm(drift)
        self.is_mirrored = is_mirrored
        self.name = "+".join(n for n, on in (("turned", is_turned), ("mirrored", is_mirrored), ("shifted", is_shifted),
                                             ("moving", largest_drift > 0.)) if on)

    def point(self, x):
        return self.turn @ np.asarray(x) + self.shift

    def apply(self, scene):
        """The scene's twin there. A lattice of the bird has mirror planes between its x and y, so that the mirrored one changes them."""
        twin, listed = scene.copy(), [float(v) for v in scene.settings["Bird/Velocity"].split(",")]
        velocity, aim = np.array(listed), np.array([float(x) for x in scene.settings["Bird/Aim point"].split(",")])
        distance = float(scene.settings["Bird/Stand-off"])
        start = self.point(aim - distance * velocity / np.linalg.norm(velocity))
        roll = math.radians(float(scene.settings.get("Bird/Roll", "0")))
        about = np.array(((math.cos(roll), -math.sin(roll), 0.), (math.sin(roll), math.cos(roll), 0.), (0., 0., 1.)))
        attitude = self.turn @ frame_of(velocity) @ about
        if self.is_mirrored:
            attitude = attitude[:, (1, 0, 2)]
        seen = self.turn @ velocity + self.drift
        twin.set("Bird/Velocity", [float(v) for v in seen])
        twin.set("Bird/Aim point", [float(x) for x in start + distance * seen / np.linalg.norm(seen)])
        for name, angle in zip(("Yaw", "Pitch", "Roll"), yaw_pitch_roll(attitude, seen)):
            twin.set("Bird/" + name, angle)
        if np.any(self.drift):
            twin.set("Blade/Loads/Initial velocity", "; ".join(repr(float(v)) for v in self.drift))
        twin.mesh = scene.mesh.moved(lambda p: tuple(float(x) for x in self.point(p))).listed(self.is_mirrored, None)
        return twin


def draw_place(scene, draw):
    """All at once: one difference says that something is wrong, then each alone says what."""
    drift = draw.choice((0., 1.)) * scene.info["speed"] if scene.info.get("free") else 0.
    return Place(draw, True, draw.random() < 0.5, True, drift)


def apart(scene, draw, place):
    """Each part of a place by itself."""
    names = place.name.split("+")
    drift = scene.info["speed"] if "moving" in names else 0.
    places = [Place(draw, name == "turned", name == "mirrored", name == "shifted", drift if name == "moving" else 0.) for name in names]
    for alone in places:
        if alone.name == "turned" and not place.is_mirrored:
            alone.turn = place.turn
    return places

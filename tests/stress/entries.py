"""Entries whose text is made of what `info` holds, so that twins can be told otherwise."""


def set_plies(scene):
    """Writes info['plies']: (angle in degrees, thickness in m, material's name or '')."""
    scene.set("Blade/Laminate/Plies", "; ".join(f"{angle!r}: {thickness!r}" + (f": {name}" if name else "")
                                                for angle, thickness, name in scene.info["plies"]))


def set_loads(scene):
    """Writes info['point_loads']: (place, force N, moment N m, law of t), and info['driven']: (boundary, way m, law of t)."""
    info = scene.info
    if info["point_loads"]:
        texts = []
        for place, force, moment, law in info["point_loads"]:
            parts = [f"{c!r}*({law})" for c in (force + moment if any(moment) else force)]
            texts.append(" ".join(repr(x) for x in place) + ": " + "; ".join(parts))
        scene.set("Blade/Loads/Point loads", " | ".join(texts))
    if info["driven"]:
        scene.set("Blade/Supports/Driven", "; ".join(f"{side}: u{axis} = {c!r}*({law})" for side, way, law in info["driven"]
                                                     for axis, c in zip("xyz", way)))


def set_initial(scene):
    for entry, name in (("Initial spin", "initial_spin"), ("Initial velocity", "initial_velocity")):
        scene.set("Blade/Loads/" + entry, "; ".join(repr(float(v)) for v in scene.info[name]))

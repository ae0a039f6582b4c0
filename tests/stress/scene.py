"""A scene: a strike as a small table of entries and figures, its mesh, and its parameter file."""

import json
import math
import os

import meshes


def log_uniform(draw, low, high):
    return math.exp(draw.uniform(math.log(low), math.log(high)))


def round_figures(value):
    return float(f"{value:.4g}")


class Scene:
    """`settings`: entries of the parameter file by path. `info`: what the judge and the table need."""

    def __init__(self, kind, seed):
        self.kind, self.seed = kind, seed
        self.settings, self.info, self.mesh, self.blade = {}, {}, None, None

    def set(self, path, value):
        if isinstance(value, (list, tuple)):
            value = ", ".join(repr(v) for v in value)
        self.settings[path] = str(value)

    def copy(self):
        twin = Scene(self.kind, self.seed)
        twin.settings, twin.info, twin.mesh, twin.blade = dict(self.settings), dict(self.info), self.mesh, self.blade
        return twin

    @property
    def can_be_placed(self):
        """Whether it is given by a mesh of its own, with a stand-off: what placing.py needs."""
        return self.mesh is not None and "Bird/Stand-off" in self.settings

    def freeze(self, path):
        """Writes all that it is to a file, from which thaw() makes it again whatever becomes of the drawing."""
        mesh = self.mesh and {"points": self.mesh.points, "cells": self.mesh.cells, "sides": self.mesh.sides, "materials": self.mesh.materials}
        with open(path, "w") as file:
            json.dump({"kind": self.kind, "seed": self.seed, "settings": self.settings, "info": self.info, "mesh": mesh}, file)

    @staticmethod
    def thaw(path):
        with open(path) as file:
            frozen = json.load(file)
        scene = Scene(frozen["kind"], frozen["seed"])
        scene.settings, scene.info = frozen["settings"], frozen["info"]
        if frozen["mesh"]:
            scene.mesh = meshes.Mesh(*([tuple(entry) for entry in frozen["mesh"][key]] for key in ("points", "cells", "sides")),
                                     frozen["mesh"]["materials"])
        return scene

    def write(self, folder, name):
        """Writes the parameter file (and mesh) into the folder and returns its path."""
        if self.mesh:
            self.mesh.write(os.path.join(folder, name + ".msh"))
            self.settings["Blade/Mesh/File"] = name + ".msh"
        path = os.path.join(folder, name + ".prm")
        tree = {}
        for entry, value in self.settings.items():
            *sections, key = entry.split("/")
            node = tree
            for section in sections:
                node = node.setdefault(section, {})
            node[key] = value
        with open(path, "w") as file:
            file.write(f"# Drawn at random: stress.py --seed {self.seed} --only {self.kind}\n")
            write_section(file, tree, "")
        return path


def write_section(file, node, indent):
    for key, value in node.items():
        if isinstance(value, dict):
            file.write(f"{indent}subsection {key}\n")
            write_section(file, value, indent + "  ")
            file.write(f"{indent}end\n")
        else:
            file.write(f"{indent}set {key} = {value}\n")

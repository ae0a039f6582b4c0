"""What the scenes share: to run the program on a file, and to read what it leaves."""

import csv
import json
import math
import os
import subprocess

QUIET = ("Time/Threads=1", "Output/Blade fields=false", "Output/Bird fields=false", "Output/HDF5=false")

# Stored and dissipated energies: each alone cannot be negative. `bird_internal` is bird_elastic + bird_dissipated.
NOT_NEGATIVE = ("bird_kinetic", "bird_elastic", "bird_dissipated", "bird_retired", "blade_kinetic", "blade_elastic", "blade_plastic",
                "blade_hourglass", "blade_viscous", "blade_damped", "blade_eroded", "contact_stored", "contact_dissipated",
                "self_contact_stored", "self_contact_dissipated")


class Run:
    """Exit code (-9: no end in time), text, rows of history.csv as columns of numbers, and summary.json (None without one)."""

    def __init__(self, code, text, folder):
        self.folder = folder
        self.code, self.text = code, text
        self.columns, self.summary = {}, None
        self.history_bytes = b""
        history = os.path.join(folder, "history.csv")
        if os.path.exists(history):
            with open(history, "rb") as file:
                self.history_bytes = file.read()
            self.columns = self.table("history")
        summary = os.path.join(folder, "summary.json")
        if os.path.exists(summary):
            with open(summary) as file:
                self.summary = json.load(file)

    def __getitem__(self, path):
        """A figure of the summary: 'contact/impulse/2'."""
        value = self.summary
        for key in path.split("/"):
            value = value[int(key)] if isinstance(value, list) else value[key]
        return value

    def table(self, name):
        """Columns of numbers of a .csv file of the run."""
        with open(os.path.join(self.folder, name + ".csv"), errors="replace") as file:
            lines = [line for line in file.read().splitlines() if not line.startswith("#")]
        rows = [row for row in csv.DictReader(lines) if None not in row.values()]
        return {key: [float(row[key]) for row in rows] for key in rows[0]} if rows else {}

    def initial_energy(self):
        return self.columns["energy"][0]

    def least(self, name):
        return min(self.columns.get(name, [0.]))

    def most(self, name):
        return max(self.columns.get(name, [0.]))

    def largest_fall(self, name):
        """By how much a column was ever below an earlier value of its own."""
        fall, highest = 0., -math.inf
        for value in self.columns.get(name, []):
            highest = max(highest, value)
            fall = max(fall, highest - value)
        return fall

    def message(self):
        """The words of a refusal or a stop: what follows the last empty line."""
        return " ".join(self.text.strip().split("\n\n")[-1].split())

    def stop(self):
        """The message alone, without a program's progress, tables and warnings: the last lines in which it speaks."""
        lines = self.text.strip().split("\n\n")[-1].splitlines()
        return " ".join(" ".join(l for l in lines if not l.lstrip().startswith(("Warning:", "t = "))).split())[:300]


def start(command, folder, limit):
    """Exit code (-9: no end in time) and words of a command that runs in `folder`."""
    try:
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=limit, errors="replace", text=True, cwd=folder)
    except subprocess.TimeoutExpired:
        return -9, f"no end within {limit:g} s"
    return done.returncode, done.stdout


def run(program, prm, folder, settings=(), limit=120., start=start):
    """Runs `prm` with --set for each of `settings` ('Section/Entry=value')."""
    command = [program, "run", prm, "--output", folder]
    for setting in (*QUIET, *settings):
        command += ["--set", setting]
    return Run(*start(command, os.path.dirname(os.path.abspath(prm)), limit), folder)


def resume(program, folder, limit=120., start=start):
    """Goes on with the run in `folder` from its newest checkpoint."""
    return Run(*start([program, "resume", folder], os.path.dirname(os.path.abspath(folder)), limit), folder)


def has_words(result):
    """Whether a refusal (2) or a stop (3) speaks to the user."""
    dump = any(word in result.text for word in ("terminate called", "Stacktrace", "An error occurred in line", "Segmentation"))
    return result.code in (2, 3) and len(result.message()) > 40 and not dump

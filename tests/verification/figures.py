"""What an expression of the tables may say of a run: figures of its summary, its histories and other runs."""

import csv
import json
import math
import os


class Run:
    """A run folder, read when it is asked for. Names of columns are those of `birdstrike columns`."""

    def __init__(self, folder, runs):
        self.folder, self.runs, self.tables = folder, runs, {}
        with open(os.path.join(folder, "summary.json")) as file:
            self.summary = json.load(file)

    def s(self, path):
        """A figure of summary.json: 'contact/impulse/2'."""
        value = self.summary
        for key in path.split("/"):
            value = value[int(key)] if isinstance(value, list) else value[key]
        return value

    def c(self, name, table="history"):
        """A column of history.csv, or of another table."""
        if table not in self.tables:
            with open(os.path.join(self.folder, table + ".csv")) as file:
                rows = list(csv.reader(line for line in file if not line.startswith("#")))
            self.tables[table] = {n: [float(row[k]) for row in rows[1:]] for k, n in enumerate(rows[0])}
        return self.tables[table][name]

    def at(self, name, time):
        """The column at a time, linear between rows."""
        t, y = self.c("time"), self.c(name)
        for k in range(1, len(t)):
            if t[k] >= time:
                return y[k - 1] + (y[k] - y[k - 1]) * (time - t[k - 1]) / (t[k] - t[k - 1])
        return y[-1]

    def between(self, name, begin, end, table="history"):
        """What a column is within a span of time."""
        return [y for t, y in zip(self.c("time", table), self.c(name, table)) if begin <= t <= end]

    def mean(self, name, begin, end):
        """Mean over a span of time, trapezoidal."""
        t, y = self.c("time"), self.c(name)
        area = length = 0.
        for k in range(1, len(t)):
            if t[k - 1] >= begin and t[k] <= end:
                area += 0.5 * (y[k] + y[k - 1]) * (t[k] - t[k - 1])
                length += t[k] - t[k - 1]
        return area / length

    def crossing(self, name, level):
        """When the column first reaches the level, s."""
        t, y = self.c("time"), self.c(name)
        for k in range(1, len(t)):
            if y[k] >= level > y[k - 1]:
                return t[k - 1] + (t[k] - t[k - 1]) * (level - y[k - 1]) / (y[k] - y[k - 1])
        return math.inf

    def frequency(self, name):
        """Of a column that swings about zero, Hz: from its first crossing to its last."""
        t, y = self.c("time"), self.c(name)
        crossings = [t[k - 1] + (t[k] - t[k - 1]) * y[k - 1] / (y[k - 1] - y[k]) for k in range(2, len(t))
                     if y[k - 1] * y[k] < 0.]
        return 0.5 * (len(crossings) - 1) / (crossings[-1] - crossings[0])

    def value(self, expression):
        names = {name: getattr(self, name) for name in ("s", "c", "at", "between", "mean", "crossing", "frequency")}
        names.update(run=lambda name: self.runs[name], abs=abs, min=min, max=max, sum=sum, len=len, zip=zip, hypot=math.hypot,
                     sqrt=math.sqrt, exp=math.exp, pi=math.pi, sin=lambda degrees: math.sin(math.radians(degrees)), folder=self.folder)
        return float(eval(expression, {"__builtins__": {}, **names}))

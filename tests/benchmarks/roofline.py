#!/usr/bin/env python3
"""Roofline of one core (Williams, Waterman & Patterson 2009): python3 tests/benchmarks/roofline.py build/speed

Reads benchmarks.json, writes roofline.png beside it and prints the points as text. Flops and bytes of a unit are those that
tests/benchmarks/flops.cc counts; ceilings are the probes machine/fma, of the loop's own precision, and machine/triad.
"""

import os
import sys

from compare import BadInput, read_benchmarks

LOOPS = (("particle pairs", "bird/rates/riemann/n:10000", "float"),
         ("kick", "bird/kick/n:10000", "double"),
         ("shell, elastic", "shell/forces/physical/elastic/n:1000", "double"),
         ("shell, 5 points plastic", "shell/forces/physical/plastic_5/n:1000", "double"),
         ("contact", "contact/step/n:1000", "double"))


def read_points(benchmarks):
    """[(label, precision, flop per byte, GFLOP/s)] of the loops that were measured."""
    points = []
    for label, name, precision in LOOPS:
        entry = benchmarks.get(name + "/threads:1")
        if entry and entry.get("bytes_per_unit"):
            per_second = entry["flops_per_unit"] * entry["units"] / entry["time"]  # flop/ns
            points.append((label, precision, entry["flops_per_unit"] / entry["bytes_per_unit"], per_second))
    return points


def read_ceilings(benchmarks):
    """{precision: peak GFLOP/s} and {label: GB/s}."""
    peaks, bandwidths = {}, {}
    for name, entry in benchmarks.items():
        if not name.endswith("/threads:1"):
            continue
        if name.startswith("machine/fma"):
            peaks[name.split("/")[2]] = entry["flops_per_unit"] * entry["units"] / entry["time"]
        if name.startswith("machine/triad/"):
            bandwidths[name.split("/")[2]] = entry["bytes_per_unit"] * entry["units"] / entry["time"]
    if set(peaks) != {"double", "float"} or not bandwidths:
        raise BadInput("the probes machine/fma and machine/triad are missing.")
    return peaks, bandwidths


def draw(points, peaks, bandwidths, title, path):
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(7, 4.5))
    low, high = 0.05, 50.0
    peak = max(peaks.values())
    for where, bandwidth in bandwidths.items():
        x = [low, min(peak / bandwidth, high), high]
        axes.plot(x, [min(peak, bandwidth * i) for i in x], linewidth=1.2, label=f"{where}: {bandwidth:.0f} GB/s")
    for (precision, value), style in zip(sorted(peaks.items()), ("-", "--")):
        axes.axhline(value, color="black", linestyle=style, linewidth=0.8, label=f"fused multiply-add, {precision}: {value:.0f} GFLOP/s")
    for (label, precision, intensity, speed), marker in zip(points, "osD^v"):
        axes.plot([intensity], [speed], marker, markersize=7, linestyle="", label=f"{label}, {precision}: {speed:.1f} GFLOP/s")
    axes.set(xscale="log", yscale="log", xlim=(low, high), ylim=(0.5, 2.0 * peak), title=title,
             xlabel="flop per byte that must move", ylabel="GFLOP/s, one core")
    axes.title.set_fontsize(9)
    axes.legend(fontsize=8, loc="lower right")
    axes.grid(True, which="both", linewidth=0.3)
    figure.tight_layout()
    figure.savefig(path, dpi=150)


def main():
    if len(sys.argv) != 2:
        print(__doc__, file=sys.stderr)
        return 2
    try:
        context, benchmarks = read_benchmarks(os.path.join(sys.argv[1], "benchmarks.json"))
        points, (peaks, bandwidths) = read_points(benchmarks), read_ceilings(benchmarks)
    except BadInput as error:
        print(f"No roofline: {error}", file=sys.stderr)
        return 2
    for label, precision, intensity, speed in points:
        peak = peaks[precision]
        roof = {where: min(peak, bandwidth * intensity) for where, bandwidth in bandwidths.items()}
        print(f"{label:<24} {intensity:6.2f} flop/byte {speed:6.1f} GFLOP/s = {speed / peak:4.0%} of the peak in {precision}; roof "
              + ", ".join(f"{value:.0f} from {where}" for where, value in roof.items()))
    path = os.path.join(sys.argv[1], "roofline.png")
    try:
        draw(points, peaks, bandwidths, f"{context.get('machine', '')}, commit {context.get('commit', '?')}", path)
        print(f"Roofline in {path}")
    except ImportError:
        print("No picture: apt-get install python3-matplotlib.")
    return 0


if __name__ == "__main__":
    sys.exit(main())

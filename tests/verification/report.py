"""The ladder's judged rows as text, Markdown, CSV and, with gnuplot, SVG."""

import csv
import math
import os
import re
import shutil
import subprocess

BEGIN, END = "<!-- ladder.py --update writes from here -->", "<!-- to here -->"


def number(x):
    return "–" if x is None or math.isnan(x) else f"{x:.5g}"


def bounds(row):
    if row["low"] == -math.inf:
        return "≤ " + number(row["high"])
    if "low_given" in row or "tolerance" not in row:
        return f"{number(row['low'])} to {number(row['high'])}"
    return f"± {100. * row['tolerance']:.3g} %"


def ratio(row):
    """Found over reference, of rows that have one to be compared with."""
    return row["found"] / row["reference"] if "found" in row and row["low"] != -math.inf and row["reference"] else None


def line(row):
    found = f"{number(row['found'])} of {number(row['reference'])} ({bounds(row)})" if "found" in row else ""
    return f"{row['verdict']:<11} {row['case']:<4} {row['what']}  {found}"


def where(row):
    if "scene" in row:
        return f"scene `{row['scene']}`"
    return f"`{row['ctest']}`" if "ctest" in row else f"`{row['test'].split()[1]}`"


def markdown(rows):
    counts = {v: sum(r["verdict"] == v for r in rows) for v in ("met", "passes", "missed", "fails", "not covered")}
    text = [f"{len(rows)} rows: {counts['met']} figures within their tolerance, {counts['missed']} **missed**, {counts['passes']} tests"
            f" without a figure pass, {counts['fails']} fail, {counts['not covered']} cases are not covered.", "",
            "| case | what | reference | tolerance | found | found / reference | verdict | by |", "|---|---|---|---|---|---|---|---|"]
    for row in rows:
        verdict = {"missed": "**missed**", "fails": "**fails**"}.get(row["verdict"], row["verdict"])
        if row["verdict"] == "not covered":
            text.append(f"| {row['case']} | {row['what']} | | | | | {verdict} | |")
        elif "found" in row:
            reference = f"{number(row['reference'])} ({row['standing']})"
            text.append(f"| {row['case']} | {row['what']} | {reference} | {bounds(row)} | {number(row['found'])} | "
                        f"{number(ratio(row)) if ratio(row) is not None else ''} | {verdict} | {where(row)} |")
        else:
            text.append(f"| {row['case']} | {row['what']} | | | | | {verdict} | {where(row)} |")
    for title, chosen, reason in (("Missed, and why", [r for r in rows if r["verdict"] in ("missed", "fails")], "miss"),
                                  ("Not covered, and why", [r for r in rows if r["verdict"] == "not covered"], "not_covered")):
        if chosen:
            text += ["", f"### {title}", ""]
            text += [f"- **{r['case']} {r['what']}**: {r.get(reason, 'not expected')}" for r in chosen]
    return "\n".join(text) + "\n"


def write(rows, output):
    with open(os.path.join(output, "ladder.md"), "w") as file:
        file.write(markdown(rows))
    with open(os.path.join(output, "ladder.csv"), "w", newline="") as file:
        table = csv.writer(file)
        table.writerow(("case", "what", "level", "standing", "reference", "low", "high", "found", "verdict", "why", "by"))
        for r in rows:
            table.writerow((r["case"], r["what"], r.get("level", ""), r.get("standing", ""), *(r.get(k, "") for k in (
                "reference", "low", "high", "found", "verdict")), r.get("why", r.get("not_covered", "")),
                where(r).replace("`", "") if r["verdict"] != "not covered" else ""))
    draw(rows, output)


def draw(rows, output):
    """Found over reference with the band that is allowed, a line a row; what is only bounded above: found over its bound."""
    if not shutil.which("gnuplot"):
        print("gnuplot is not installed: no ladder.svg")
        return
    near = [r for r in rows if "found" in r and ratio(r) is not None and not math.isnan(r["found"])]
    below = [r for r in rows if "found" in r and ratio(r) is None and r["low"] == -math.inf and not math.isnan(r["found"])]
    span = 0.3
    clip = lambda x: max(1. - span, min(1. + span, x))
    height = 90 + 13 * max(len(near), len(below))
    script = [f"set terminal svg size 1250,{height} font 'sans,10' background '#ffffff'", f"set output '{output}/ladder.svg'",
              "unset key", "set multiplot layout 1,2 title 'Grey: tolerance. Blue: found within it. Red: missed.'", "set grid x lc '#dddddd'",
              "set ytics font ',8'"]
    for panel, chosen in enumerate((near, below)):
        names = ", ".join("'%s' %d" % (re.sub(r"[_^{}@&']", " ", f"{r['case']} {r['what']}")[:62].replace("%", "%%"), -k) for k, r in enumerate(chosen))
        script += [f"set ytics ({names})", f"set yrange [{-len(chosen)}:1]", "$band << EOD"]
        for k, r in enumerate(chosen):
            low, high = (clip(r["low"] / r["reference"]), clip(r["high"] / r["reference"])) if panel == 0 else (1e-16, 1.)
            script.append(f"{0.5 * (low + high)} {-k} {min(low, high)} {max(low, high)} {-k - 0.4} {-k + 0.4}")
        script.append("EOD")
        colours = [colour for colour in ("met", "missed") if any(r["verdict"] == colour for r in chosen)]
        for colour in colours:
            script.append(f"${colour} << EOD")
            for k, r in enumerate(chosen):
                if r["verdict"] == colour:
                    x = clip(ratio(r)) if panel == 0 else max(1e-16, abs(r["found"] / r["reference"]))
                    script.append(f"{x} {-k}")
            script.append("EOD")
        script += (["set xlabel 'found over reference (cut at 0.7 and 1.3)'", f"set xrange [{1. - span}:{1. + span}]"] if panel == 0 else
                   ["set xlabel 'found over the largest that is allowed'", "set logscale x", "set format x '10^{%T}'", "set xtics 100",
                    "set xrange [1e-7:1e2]"])
        points = {"met": "with points pt 7 ps 0.5 lc '#1f5fbf'", "missed": "with points pt 7 ps 0.6 lc '#c62828'"}
        script.append("plot " + ", ".join(["$band using 1:2:3:4:5:6 with boxxyerror fs solid 1 noborder lc '#d8d8d8'"] * bool(chosen) +
                                          [f"${colour} {points[colour]}" for colour in colours]) if chosen else "set multiplot next")
    subprocess.run(["gnuplot"], input="\n".join(script) + "\n", text=True, check=True)


def update(rows, output, folder):
    """Puts table and figure where the reader finds them."""
    readme = os.path.join(folder, "README.md")
    with open(readme) as file:
        text = file.read()
    begin, end = text.index(BEGIN) + len(BEGIN), text.index(END)
    with open(readme, "w") as file:
        file.write(text[:begin] + "\n\n" + markdown(rows) + "\n" + text[end:])
    if os.path.exists(os.path.join(output, "ladder.svg")):
        shutil.copy(os.path.join(output, "ladder.svg"), folder)

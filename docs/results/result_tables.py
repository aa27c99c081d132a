# SPDX-FileCopyrightText: 2026 The Surefoot authors
# SPDX-License-Identifier: MIT
"""The tables that docs/make_tables writes: each a function of the kept files beside this one."""
import csv
import pathlib
import statistics

import reliability_diagram

HERE = pathlib.Path(__file__).resolve().parent
APE, FIRST = "RMSE (m)", "Maximum (m)"  # a run that is not whole has its verdict in the first row
RELATIVE = "Relative over 10 m, RMSE (%)"
LATEST_SET = 20  # of those with layouts of their own


class Kept:
    """A kept file: what it says about itself, and its rows."""

    def __init__(self, name):
        text = (HERE / f"{name}.csv").read_text().splitlines()
        head = [line[2:] for line in text if line.startswith("# ")]
        self.about = dict(line.split(": ", 1) for line in head)
        self.name = name
        self.rows = list(csv.reader(line for line in text if not line.startswith("# ")))


class Results(Kept):
    """What `surefoot compare` found: figures by recording, name and method."""

    def __init__(self, name):
        super().__init__(name)
        self.cells = {tuple(row[:3]): (float(row[3]) if row[3] else None, row[4])
                      for row in self.rows[1:]}
        self.recordings = list(dict.fromkeys(key[0] for key in self.cells))
        self.methods = list(dict.fromkeys(key[2] for key in self.cells))

    def value(self, recording, method, figure=APE):
        return self.cells.get((recording, figure, method), (None, ""))[0]

    def text(self, recording, method, figure=APE):
        """The figure as shown; of a run that is not whole, why."""
        value, text = self.cells.get((recording, figure, method), (None, "–"))
        if value is None and figure == APE:
            return self.cells.get((recording, FIRST, method), (None, "–"))[1]
        return text

    def values(self, method, figure=APE):
        found = (self.value(recording, method, figure) for recording in self.recordings)
        return [value for value in found if value is not None]


def markdown(head, rows):
    lines = [head, ["---"] * len(head), *rows]
    return "\n".join("| " + " | ".join(line) + " |" for line in lines)


def link(kept, root="results"):
    return f"[{kept.name}.csv]({root}/{kept.name}.csv)"


def kept_by(kept):
    note = f" Note: {kept.about['note']}." if "note" in kept.about else ""
    return f"Kept in {link(kept)}: commit {kept.about['commit']}, `{kept.about['command']}`.{note}"


def reliability():
    """A fault a row, over all walks."""
    kept = Kept("reliability")
    columns = {name: i for i, name in enumerate(kept.rows[0])}
    faults = {}
    for row in kept.rows[1:]:
        faults.setdefault(row[columns["fault"]], []).append(row)

    def total(rows, name):
        return sum(int(row[columns[name]]) for row in rows)

    def again(rows):
        seconds = [row[columns["right_again_s"]] for row in rows]
        known = [float(one) for one in seconds if one != "–"]
        return f"{statistics.median(known):.1f} s, {len(known)} of {len(rows)}" if known else "never"

    lines = [[fault, *(str(total(rows, name)) for name in
                       ("scans", "ok", "false_ok", "degenerate", "untrusted")), again(rows)]
             for fault, rows in faults.items()]
    everything = [row for rows in faults.values() for row in rows]
    lines.append(["all", *(str(total(everything, name)) for name in
                           ("scans", "ok", "false_ok", "degenerate", "untrusted")), ""])
    head = ["fault", "scans", "ok", "false ok", "degenerate", "untrusted", "right again"]
    return f"{markdown(head, lines)}\n\n{kept_by(kept)}"


def reliability_alike():
    """Where places look alike: the faults after which a wrong pose is called ok, and all."""
    kept = Kept("reliability_alike")
    columns = {name: i for i, name in enumerate(kept.rows[0])}
    names = ["scans", "ok", "false_ok", "degenerate", "untrusted"]
    lines = [[row[columns[name]] for name in ("walk", "fault", *names)]
             for row in kept.rows[1:] if row[columns["false_ok"]] != "0"]
    lines.append(["all", f"{len(kept.rows) - 1} runs",
                  *(str(sum(int(row[columns[name]]) for row in kept.rows[1:])) for name in names)])
    head = ["walk", "fault", "scans", "ok", "false ok", "degenerate", "untrusted"]
    return f"{markdown(head, lines)}\n\n{kept_by(kept)}"


def home_again():
    """What happened a row: of how many places, how soon, and the walks where some are missed."""
    kept = Kept("home_again")
    lines = []
    for what in dict.fromkeys(row[0] for row in kept.rows[1:]):
        walks = [row for row in kept.rows[1:] if row[0] == what and row[1] != "all"]
        sums = [str(sum(int(row[i]) for row in walks)) for i in (2, 3, 5, 6)]
        missed = ", ".join(f"{row[1]} {int(row[2]) - int(row[3])}" for row in walks
                           if row[2] != row[3])
        lines.append([what, sums[0], f"{sums[1]} in {walks[0][4]} s", *sums[2:], missed])
    head = ["what happened", "places", "right", "right in 7 s", "wrong place called ok",
            "late or never, of 4 on each walk"]
    return f"{markdown(head, lines)}\n\n{kept_by(kept)}"


def finer_grid():
    """A set a row: how many recordings, scans lost and the APE's ratio, with four grids and five."""
    kept = Kept("finer_grid")
    sets = list(dict.fromkeys(row[0] for row in kept.rows[1:]))
    lines = []
    for one in sets:
        rows = [row for row in kept.rows[1:] if row[0] == one]
        ratios = [float(row[6]) / float(row[4]) for row in rows]
        lost = [str(sum(int(row[column]) for row in rows)) for column in (3, 5)]
        lines.append([one, str(len(rows)), str(sum(int(row[2]) for row in rows)), *lost,
                      f"{statistics.geometric_mean(ratios):.2f}", f"{min(ratios):.2f}",
                      f"{max(ratios):.2f}"])
    head = ["set", "recordings", "scans", "four grids: lost", "five: lost",
            "APE, five to four, geometric mean", "least", "largest"]
    return f"{markdown(head, lines)}\n\n{kept_by(kept)}"


def hard_walks(name="hard_walks"):
    """Walks of a kind a row: what of them is lost and false by one default and by another."""
    kept = Kept(name)
    lines = []
    for kind in dict.fromkeys(row[0] for row in kept.rows[1:]):
        rows = [row for row in kept.rows[1:] if row[0] == kind]
        def sums(column, rows=rows):
            return str(sum(int(row[column]) for row in rows))
        ratios = [float(row[10]) / float(row[6]) for row in rows]
        lines.append([f"`{kind}`", str(len(rows)), sums(2), sums(3), sums(5), sums(7), sums(9),
                      f"{statistics.geometric_mean(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f})"])
    head = ["walk", "walks", "scans", "before: not trusted", "before: false ok", "not trusted", "false ok",
            "APE, ratio"]
    return f"{markdown(head, lines)}\n\n{kept_by(kept)}"


def reference():
    """A recording a row: errors of the odometry and of the reference; then the ratios."""
    kept = Kept("reference")
    rows = [[row[0], row[1], *(f"{float(cell) * 1000:.1f}" if "[m]" in name else
                               f"{float(cell):.3f}" for name, cell in zip(kept.rows[0][2:], row[2:]))]
            for row in kept.rows[1:]]
    ratios = []
    for column in range(2, 6):
        of = [float(row[column + 4]) / float(row[column]) for row in kept.rows[1:]]
        ratios.append(f"{statistics.geometric_mean(of):.2f} ({min(of):.2f} to {max(of):.2f})")
    rows.append(["reference to online, geometric mean (range)", "", "", "", "", "", *ratios, ""])
    return f"{markdown([name.replace('[m]', '[mm]') for name in kept.rows[0]], rows)}\n\n{kept_by(kept)}"


def told_and_wrong():
    """What was told up to, scans, told on average, wrong ones; and what a wrong one is weighed by, to
    be one in a hundred."""
    rows = [[row[0], int(row[1]), float(row[2]), int(row[3])] for row in Kept("reliability_bins").rows[1:]]
    wrong = sum(row[3] for row in rows)
    right = sum(row[1] - row[3] for row in rows)
    return rows, 0.01 / 0.99 * right / wrong


def reliability_picture():
    rows, weight = told_and_wrong()
    return reliability_diagram.svg([(told, scans, bad) for _, scans, told, bad in rows], weight)


def reliability_bins():
    """How often poses of which a probability is told are wrong, wrong ones as one in a hundred."""
    kept = Kept("reliability_bins")
    rows, weight = told_and_wrong()
    lines = []
    for end, scans, told, bad in rows:
        weighed = weight * bad
        share = weighed / (scans - bad + weighed) if scans else 0.0
        lines.append([end, str(scans), f"{told:.4f}", str(bad), f"{share:.4f}"])
    head = ["told, up to", "scans", "told on average", "wrong", "share of wrong ones"]
    return f"{markdown(head, lines)}\n\n{kept_by(kept)}"


def loops():
    """A scene a row: its walks' sums, the APE's medians; then all, and those on fresh layouts."""
    kept = Kept("loops")
    names = kept.rows[0]
    rows = [dict(zip(names, row)) for row in kept.rows[1:]]
    fresh = [row for row in rows if int(row["layout"]) > 8000]
    sums = names[2:8]

    def line(name, of):
        cells = [str(sum(int(row[column]) for row in of)) for column in sums]
        medians = [f"{statistics.median(float(row[column]) for row in of):.3f}"
                   for column in names[8:]]
        return [name, str(len(of)), *cells, *medians]

    lines = [line(scene, [row for row in rows if row["scene"] == scene])
             for scene in dict.fromkeys(row["scene"] for row in rows)]
    lines += [line("all", rows), line("of these, layouts from 8101 on", fresh)]
    head = ["scene", "walks", *sums, *(f"{name}, median" for name in names[8:])]
    return f"{markdown(head, lines)}\n\n{kept_by(kept)}"


def as_kept(name):
    """A file as it is, and what made it."""
    kept = Kept(name)
    about = [f"commit {kept.about['commit']}"] if "commit" in kept.about else []
    about += [kept.about[key] for key in ("machine", "note") if key in kept.about]
    return f"{markdown(kept.rows[0], kept.rows[1:])}\n\nKept in {link(kept)}: {'; '.join(about)}."


def detectors():
    """As kept."""
    kept = Kept("detectors")
    return f"{markdown(kept.rows[0], kept.rows[1:])}\n\n{kept_by(kept)}"


def of_suite(kept):
    return [name for name in kept.recordings if not name.startswith("gait_")]


def made_by(table, kept):
    about = kept.about
    note = f" Note: {about['note']}." if "note" in about else ""
    return (f"{table}\n\nKept in {link(kept)}: commit {about['commit']}, made {about['made']}, "
            f"`{about['command']}`.{note}")


def others():
    kept = Results("reporting-8-others")
    rows = [[one, *(kept.text(one, method) for method in kept.methods)] for one in kept.recordings]
    return made_by(markdown(["recording", *kept.methods], rows), kept)


def paper_tables():
    """A sequence of the paper's a row, as printed, and below it the latest set's recording that is
    nearest to it: mean and RMSE of the APE."""
    kept, ours = Kept("paper_tables"), Results(f"reporting-{LATEST_SET}")
    nearest = {"Seq. 1": "campus-wheel", "Seq. 2": "campus-trot", "Seq. 3": "parking-trot",
               "Seq. 4": "playground-trot"}
    figures = "Mean (m)", APE
    printed = {(row[1], row[3]): row[4:] for row in kept.rows[1:]}
    what = {row[1]: f"{row[1]}, {row[2]} (Table {row[0]})" for row in kept.rows[1:]}
    rows = []
    for one, recording in nearest.items():
        cells = zip(*(printed[one, figure] for figure in figures))
        rows.append([what[one], *(" / ".join(cell) if all(cell) else "–" for cell in cells), "–"])
        paper, kiss, surefoot = (
            " / ".join(ours.text(recording, method, figure) for figure in figures)
            for method in ("paper", "kiss-icp", "surefoot"))
        rows.append([f"ours: {recording}, simulated", "–", paper, kiss, "–", "–", surefoot])
    head = ["recording", *kept.rows[0][4:], "Surefoot"]
    return (f"{markdown(head, rows)}\n\nKept in {link(kept)}: {kept.about['note']}. Ours: commit "
            f"{ours.about['commit']}, {link(ours)}.")


def named(method):
    """A method by its name where the parameters beside it are its defaults since."""
    return method.split("+")[0]


def reporting(name):
    """A recording a row: the APE of each method, and of the default the relative error."""
    kept = Results(name)
    others = [method for method in kept.methods if method != "surefoot"]
    rows = [[one, kept.text(one, "surefoot"), kept.text(one, "surefoot", RELATIVE),
             *(kept.text(one, method) for method in others)] for one in kept.recordings]
    head = ["recording", "surefoot", "its relative error [%]", *map(named, others)]
    return made_by(markdown(head, rows), kept)


def whole_runs(kept, method):
    """Median and largest APE [m] of the runs that are whole, and how many these are."""
    errors = kept.values(method)
    if not errors:
        return ["–"] * 2
    whole = "" if len(errors) == len(kept.recordings) else f" ({len(errors)} whole)"
    beside = kept.values("kiss-icp")
    return [f"{statistics.median(errors):.3f} / {max(errors):.3f}{whole}",
            f"{statistics.median(beside):.3f}" if beside else "–"]


def earlier_sets():
    """A set a row: begun standing, and in motion as far as that was run."""
    rows = []
    for name in (f"reporting-{n}" for n in range(LATEST_SET - 1, 3, -1)):
        kept = Results(name)
        in_motion = HERE / f"{name}-in-motion.csv"
        moving = whole_runs(Results(in_motion.stem), "surefoot") if in_motion.exists() else ["–"] * 2
        rows.append([f"[{name}](results/{name}.csv)", kept.about["commit"],
                     *whole_runs(kept, "surefoot"), *moving])
    return markdown(["set", "commit", "begun standing", "kiss-icp", "in motion", "kiss-icp"], rows)


def latest_judged(ending, column):
    """Over the latest set's recordings: scans "ok", "false ok", "lost", "degenerate"."""
    rows = Kept(f"reporting-{LATEST_SET}{ending}-false").rows
    at = rows[0].index(column)
    return f"{sum(int(row[at]) for row in rows[1:]):,}"


def drawn():
    """A LiDAR a row, over set-ups drawn at random; then all."""
    kept = Kept("drawn")
    rows = kept.rows[1:]
    lidar = {row[0]: row[1].split("--lidar ")[1].split()[0] for row in rows}
    lines = []
    for name in (*sorted(set(lidar.values())), "all"):
        of = [row for row in rows if name in ("all", lidar[row[0]])]
        errors = [float(row[7]) for row in of]
        sums = [sum(int(row[column]) for row in of) for column in (2, 3, 5, 6)]
        lines.append([name, str(len(of)), f"{statistics.median(errors):.4f}", f"{max(errors):.3f}",
                      str(sum(int(row[4]) > 1 for row in of)), *map(str, sums)])
    return markdown(["LiDAR", "runs", "APE, median [m]", "largest [m]", "begun anew", "scans", "lost",
                     "ok", "false ok"], lines) + f"\n\n{kept_by(kept)}"


def drawn_clean():
    """Of the set-ups drawn, those without a false scan."""
    return str(sum(row[6] == "0" for row in Kept("drawn").rows[1:]))


def drawn_median():
    return f"{statistics.median(float(row[7]) for row in Kept('drawn').rows[1:]):.3f}"


def bend():
    """What straightening a map is worth: means of the figures, geometric ones of the ratios."""
    kept = Kept("bend")
    lines = []
    for hilltops in (False, True):
        for moving in (False, True):
            rows = [row for row in kept.rows[1:]
                    if (row[0] == "hilltop") == hilltops and (row[3] != "0") == moving]
            line = ["hilltops" if hilltops else "elsewhere", "in motion" if moving else "standing",
                    str(len(rows))]
            for first, form in ((4, "{:.4f}"), (6, "{:.1f}")):
                before, now = ([float(row[at]) for row in rows] for at in (first, first + 1))
                ratios = [b / a for a, b in zip(before, now)]
                line += [form.format(statistics.mean(before)), form.format(statistics.mean(now)),
                         f"{statistics.geometric_mean(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f})"]
            lines.append(line)
    head = ["where", "begun", "runs", "APE before [m]", "now", "ratio",
            "within the scan before [mrad]", "now", "ratio"]
    return f"{markdown(head, lines)}\n\n{kept_by(kept)}"


def readme(root="docs/results"):
    """A method a row, over the set that nothing was tuned on."""
    kept = Results(f"reporting-{LATEST_SET}")
    names = {"surefoot": "**Surefoot**", "paper": "the paper's", "paper-surface": "a variant of it",
             "kiss-icp": "KISS-ICP", "genz-icp": "GenZ-ICP", "floam": "F-LOAM", "icp": "ICP"}
    rows = []
    for method in sorted(kept.methods, key=list(names).index):
        errors = kept.values(method)
        rows.append([names[method], f"{statistics.median(errors):.3f}", f"{max(errors):.3f}",
                     f"{len(errors)} of {len(kept.recordings)}"])
    table = markdown(["method", "median", "largest", "whole runs"], rows)
    note = kept.about.get("note")
    return f"{table}\n\nAt commit {kept.about['commit']}: {link(kept, root)}" + (f"; {note}." if note else ".")


def measured_by_turns(name):
    """The kept file, and its columns by name: a number a turn."""
    kept = Kept(name)
    columns = zip(kept.rows[0], zip(*kept.rows[1:]))
    return kept, {column: [float(cell) for cell in cells] for column, cells in columns}


def with_range(values, digits=2):
    median, low, high = statistics.median(values), min(values), max(values)
    return f"{median:.{digits}f} ({low:.{digits}f} to {high:.{digits}f})"


def kept_by_turns(kept):
    return f"Medians of the turns (least to most). {kept_by(kept)} {kept.about['machine']}."


def ratios(above, below):
    return [a / b for a, b in zip(above, below)]


def latency():
    kept, turns = measured_by_turns("latency")
    rows = [[when, with_range(turns[when]), with_range(turns[f"{when} p99"])]
            for when in ("before", "now")]
    head = ["", "ms_total, median [ms]", "99th percentile [ms]"]
    return f"{markdown(head, rows)}\n\n{kept_by_turns(kept)}"


def latency_now():
    _, turns = measured_by_turns("latency")
    now, before = (f"{statistics.median(turns[when]):.2f}" for when in ("now", "before"))
    return f"{now} ms in the median instead of {before}"


def threads():
    kept, turns = measured_by_turns("threads")
    rows = [[f"{count}, wall time [ms]", *(with_range(turns[f"{when} {key}"]) for when in ("before", "now")),
             with_range(ratios(turns[f"now {key}"], turns[f"before {key}"]))]
            for count, key in (("one thread", "one"), ("two threads", "two"))]
    for name, above, below in (("one thread's wall time to that of two", "one", "two"),
                               ("processor time of two to that of one", "two processor", "one processor")):
        rows.append([name, *(with_range(ratios(turns[f"{when} {above}"], turns[f"{when} {below}"]))
                             for when in ("before", "now")), ""])
    return f"{markdown(['', 'before', 'now', 'now to before'], rows)}\n\n{kept_by_turns(kept)}"


def default_turns():
    """By recording and threads, the turns: before median, p99, now median, p99 [ms]."""
    turns = {}
    for recording, threads, *cells in Kept("default_times").rows[1:]:
        turns.setdefault((recording, int(threads)), []).append([float(cell) for cell in cells])
    return {key: [list(column) for column in zip(*rows)] for key, rows in turns.items()}


def default_times():
    rows = []
    for (recording, threads), columns in default_turns().items():
        before, now = ([statistics.median(column) for column in part] for part in (columns[:2], columns[2:]))
        rows.append([recording, str(threads), *(f"{median:.1f} / {p99:.1f}" for median, p99 in (before, now)),
                     *(with_range(ratios(columns[2 + k], columns[k])) for k in (0, 1))])
    head = ["recording", "threads", "before: median / p99 [ms]", "now [ms]", "median, now to before", "p99, now to before"]
    return f"{markdown(head, rows)}\n\n{kept_by_turns(Kept('default_times'))}"


def default_times_ratio(at):
    """Of the campus on one thread: 0 of the median, 1 of the 99th percentile."""
    columns = default_turns()["campus", 1]
    return f"{statistics.median(ratios(columns[2 + at], columns[at])):.2f}"


def default_threads_ratio():
    columns = default_turns()
    return f"{statistics.median(ratios(columns['campus', 1][2], columns['campus', 2][2])):.2f}"


def slow_scans():
    kept = Kept("slow_scans")
    walks = {}
    for walk, *cells in kept.rows[1:]:
        walks.setdefault(walk, []).append([float(cell) for cell in cells])
    rows = []
    for walk, turns in walks.items():
        before, now = ([list(column) for column in zip(*turns)][part] for part in (slice(0, 3), slice(3, 6)))
        rows.append([walk, *(" / ".join(f"{statistics.median(column):.1f}" for column in part)
                             for part in (before, now)),
                     *(with_range(ratios(now[k], before[k])) for k in (1, 2))])
    head = ["walk", "before: median / p99 / slowest [ms]", "now [ms]", "p99, now to before", "slowest, now to before"]
    return f"{markdown(head, rows)}\n\n{kept_by_turns(kept)}"


def slowest_scans():
    """The slowest scan of a run [ms]: medians of the turns, least to most of the walks."""
    walks = {}
    for walk, *cells in Kept("slow_scans").rows[1:]:
        walks.setdefault(walk, []).append(float(cells[-1]))
    slowest = [statistics.median(turns) for turns in walks.values()]
    return f"{min(slowest):.0f} to {max(slowest):.0f}"


def fewer_points():
    kept = Kept("fewer_points")
    columns = list(zip(*kept.rows[1:]))
    as_it_is = [float(cell) for cell in columns[1]]
    rows = []
    for k in range(1, len(columns), 2):
        times = ratios([float(cell) for cell in columns[k]], as_it_is)
        rows.append([kept.rows[0][k], f"{statistics.geometric_mean(times):.2f}",
                     str(sum(ratio > 1.1 for ratio in times)), str(sum(int(cell) for cell in columns[k + 1]))])
    head = ["", "APE, times (geometric mean)", f"of {len(as_it_is)} walks worse by a tenth", "scans lost"]
    return f"{markdown(head, rows)}\n\n{kept_by(kept)}"


def simulation_turns():
    kept, turns = measured_by_turns("simulation_turns")
    rows = []
    for name in (column.removesuffix(", now") for column in turns if column.endswith(", now")):
        before, now = turns[f"{name}, before"], turns[f"{name}, now"]
        rows.append([name, with_range(before, 1), with_range(now, 1),
                     f"{statistics.median(now) / statistics.median(before):.2f}",
                     f"{max(now) / max(before):.2f}"])
    head = ["scans/s", "before", "now", "ratio of medians", "of the best"]
    return f"{markdown(head, rows)}\n\n{kept_by_turns(kept)}"


def wall_time(threads, which):
    """[ms] of the default method over whole scans: 0 least, 1 median, 2 99th percentile."""
    for row in Kept("whole_run").rows[1:]:
        if row[:2] == ["surefoot", str(threads)]:
            return float(row[2].split(" / ")[which])
    raise KeyError(threads)


def within_scans(column):
    """Mean [%] over the recordings of a column, counted from the end."""
    return f"{statistics.mean(float(row[-column]) for row in Kept('within_scans').rows[1:]):.0f}"


GAITS = ("wheel", "handheld", "walk", "stairs", "trot", "run")


def let_go():
    """A gait a row: geometric means of the ratios, now to before, and whether the covariances hold."""
    kept = Kept("let_go")
    figures = (len(kept.rows[0]) - 3) // 2
    lines = []
    for gait in (*GAITS, "all"):
        rows = [row for row in kept.rows[1:] if gait in ("all", row[1])]
        line = [gait, str(len(rows))]
        for at in range(3, 7):
            ratios = [float(row[at + figures]) / float(row[at]) for row in rows]
            line.append(f"{statistics.geometric_mean(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f})")
        for first in (3, 3 + figures):
            line += [f"{statistics.mean(float(row[first + at]) for row in rows):.0f}" for at in (5, 6)]
        lines.append(line)
    head = ["gait", "recordings", "translation over 1 m", "rotation over 1 m", "APE", "attitude within the scan",
            "before: below 97.5 % [%]", "before: between 2.5 and 97.5 % [%]",
            "now: below 97.5 % [%]", "now: between 2.5 and 97.5 % [%]"]
    return f"{markdown(head, lines)}\n\n{kept_by(kept)}"


def tuning():
    """A change of the paper's constants a row; the last column is the geometric mean ratio."""
    kept = Results("tuning-paper")
    rows = []
    for method in kept.methods:
        ratios = [kept.value(one, method) / kept.value(one, "paper") for one in kept.recordings]
        change = method.removeprefix("paper").removeprefix("+").replace("+", ", ") or "as it was"
        rows.append([change, *(kept.text(one, method) for one in kept.recordings),
                     f"{statistics.geometric_mean(ratios):.2f}"])
    return made_by(markdown(["change", *kept.recordings, "ratio"], rows), kept)


def tuning_campus():
    kept = Results("tuning-paper-campus")
    rows = [[method.removeprefix("paper").removeprefix("+") or "as it was",
             *(kept.text(one, method) for one in kept.recordings)] for method in kept.methods]
    return made_by(markdown(["change", *kept.recordings], rows), kept)


def independence():
    """What three of ten residuals are worth over one of ten."""
    kept = Results("independence")
    before, now = kept.methods
    rows = [[one, *(kept.text(one, method, figure) for figure in (APE, RELATIVE)
                    for method in (before, now))] for one in kept.recordings]
    head = ["recording", "0.1: APE [m]", "0.3", "0.1: over 10 m [%]", "0.3"]
    return made_by(markdown(head, rows), kept)


def independence_ratio(part):
    """Geometric mean of what an APE became by it, over the recordings with such a name."""
    kept = Results("independence")
    before, now = kept.methods
    ratios = [kept.value(one, now) / kept.value(one, before)
              for one in kept.recordings if part in one]
    return f"{statistics.geometric_mean(ratios):.2f}"


def independence_compared(name):
    """A recording a row: what the APE is with one and with three of ten."""
    kept = Results(name)
    before, now = kept.methods
    rows = [[one, kept.text(one, before), kept.text(one, now)] for one in kept.recordings]
    return made_by(markdown(["recording", "0.1: APE [m]", "0.3"], rows), kept)


def independence_among(name):
    """Geometric mean of what an APE became, where both runs are whole, and its largest."""
    kept = Results(name)
    before, now = kept.methods
    pairs = [(kept.value(one, before), kept.value(one, now)) for one in kept.recordings]
    ratios = [after / least for least, after in pairs if least and after]
    return f"{statistics.geometric_mean(ratios):.2f} ({max(ratios):.2f} at most)"


def fast_stairs(walks, column):
    """Of the fresh walks, by the newest commit."""
    kept = Kept("fast_stairs")
    head, rows = kept.rows[0], kept.rows[1:]
    return next(row for row in reversed(rows) if row[1] == f"{walks}, fresh")[head.index(column)]


def trot_up_stairs_false():
    shares = [float(fast_stairs("stairwell, a trot", column)) for column in ("false ok", "ok")]
    return f"{100.0 * shares[0] / shares[1]:.1f}"


def kept_sum(name, column, of=lambda row: True):
    """Of a kept file's column, over the rows that are meant."""
    kept = Kept(name)
    i = kept.rows[0].index(column)
    return sum(int(row[i]) for row in kept.rows[1:] if of(row))


def city_walks(column):
    """Over the six walks as the file's commit has them, without those that were walked again."""
    return f"{kept_sum('city', column, lambda row: row[0][:-1] == 'walk '):,}"


def kept_cell(name, column, *first):
    """Of the row that begins so."""
    kept = Kept(name)
    row = next(row for row in kept.rows[1:] if tuple(row[:len(first)]) == first)
    return row[kept.rows[0].index(column)]


def places_compared():
    """On the walks of loops.csv and on the longest of kilometres.csv."""
    longest = kept_sum("kilometres", "places compared", lambda row: row[0] == "town-10km")
    return f"{kept_sum('loops', 'places compared') + longest:,}"


def revisits_missed():
    return str(kept_sum("loops", "revisits") - kept_sum("loops", "found"))


def starts(own):
    """Of the rows that no commit is named for, in maps of the walk's own place or of another."""
    def meant(row):
        return " " not in row[0] and (row[1] == row[2]) == own

    return str(kept_sum("localization", "starts", meant))


TABLES = {
    "trot-up-stairs-off": lambda: f"{float(fast_stairs('stairwell, a trot', 'off, median [m]')):.1f}",
    "trot-up-stairs-false": trot_up_stairs_false,
    "stairs-gait-off": lambda: fast_stairs("stairwell, a stair's gait", "off, median [m]"),
    "independence": independence,
    "independence-ape": lambda: independence_ratio(""),
    "independence-stairs": lambda: independence_ratio("stairwell-trot"),
    "independence-hilltop": lambda: independence_ratio("hilltop"),
    "independence-whole": lambda: independence_compared("independence_whole"),
    "independence-whole-ratio": lambda: independence_among("independence_whole"),
    "independence-in-motion": lambda: independence_compared("independence_begun_in_motion"),
    "independence-in-motion-ratio": lambda: independence_among("independence_begun_in_motion"),
    "tuning": tuning,
    "tuning-campus": tuning_campus,
    "time-median": lambda: f"{wall_time(1, 1):.1f}",
    "time-p99": lambda: f"{wall_time(1, 2):.1f}",
    "time-two": lambda: f"{wall_time(2, 1):.1f}",
    "time-commit": lambda: Kept("whole_run").about["commit"],
    "time-machine": lambda: Kept("whole_run").about["machine"].split(",")[0],
    "thread-ratio": lambda: f"{wall_time(1, 1) / wall_time(2, 1):.2f}",
    "within-below": lambda: within_scans(2),
    "within-between": lambda: within_scans(1),
    "latest-set": lambda: reporting(f"reporting-{LATEST_SET}"),
    "latest-ok": lambda: latest_judged("", "ok"),
    "latest-false": lambda: latest_judged("", "false ok"),
    "latest-lost": lambda: latest_judged("", "lost"),
    "latest-degenerate": lambda: latest_judged("", "degenerate"),
    "latest-in-motion-ok": lambda: latest_judged("-in-motion", "ok"),
    "latest-in-motion-false": lambda: latest_judged("-in-motion", "false ok"),
    "latest-in-motion-lost": lambda: latest_judged("-in-motion", "lost"),
    "latest-in-motion-degenerate": lambda: latest_judged("-in-motion", "degenerate"),
    "drawn": drawn,
    "drawn-runs": lambda: str(len(Kept("drawn").rows) - 1),
    "drawn-clean": drawn_clean,
    "drawn-median": drawn_median,
    "latest-set-in-motion": lambda: reporting(f"reporting-{LATEST_SET}-in-motion"),
    "earlier-sets": earlier_sets,
    "reporting-8-others": others,
    "paper-tables": paper_tables,
    "bend": bend,
    "hard-walks": hard_walks,
    "runners": lambda: hard_walks("runners"),
    "beginnings-hilltop": lambda: hard_walks("beginnings_hilltop"),
    "readme": readme,
    "summary": lambda: readme("results"),
    "finer-grid": finer_grid,
    "let-go": let_go,
    "loops": loops,
    "detectors": detectors,
    "reference": reference,
    "home-again": home_again,
    "reliability-alike": reliability_alike,
    "reliability-ok": lambda: f"{kept_sum('reliability', 'ok'):,}",
    "reliability-false": lambda: str(kept_sum("reliability", "false_ok")),
    "others-ok": lambda: f"{kept_sum('reliability_others', 'ok'):,}",
    "others-false": lambda: str(kept_sum("reliability_others", "false_ok")),
    "alike-ok": lambda: f"{kept_sum('reliability_alike', 'ok'):,}",
    "alike-false": lambda: str(kept_sum("reliability_alike", "false_ok")),
    "alike-carried-off":
        lambda: f"{float(kept_cell('reliability_alike', 'error_m', 'corridor-73', 'carried 20 m')):.0f}",
    "alike-carried-again":
        lambda: kept_cell("reliability_alike", "right_again_s", "corridor-73", "carried 1 m"),
    "city-loops": lambda: city_walks("loops"),
    "city-found": lambda: city_walks("found"),
    "city-revisits": lambda: city_walks("revisits"),
    "city-ok": lambda: city_walks("poses ok"),
    "city-false": lambda: city_walks("false ok"),
    "city-slid": lambda: kept_cell("city", "false ok", "walk 5"),
    "city-slid-memory": lambda: kept_cell("city", "memory [MB]", "walk 5"),
    "city-joined-off": lambda: kept_cell("city", "off, at most [m]", "all six joined"),
    "places-compared": places_compared,
    "forest-before": lambda: kept_cell("loops", "APE before [m]", "forest", "8201"),
    "forest-after": lambda: kept_cell("loops", "APE after [m]", "forest", "8201"),
    "loops-revisits": lambda: str(kept_sum("loops", "revisits")),
    "loops-missed": revisits_missed,
    "starts-here": lambda: starts(True),
    "starts-elsewhere": lambda: starts(False),
    "reliability": reliability,
    "reliability-bins": reliability_bins,
    "latency": latency,
    "latency-now": latency_now,
    "default-times": default_times,
    "default-threads": default_threads_ratio,
    "default-times-median": lambda: default_times_ratio(0),
    "default-times-p99": lambda: default_times_ratio(1),
    "threads": threads,
    "simulation-turns": simulation_turns,
    "slow-scans": slow_scans,
    "slowest-scans": slowest_scans,
    "fewer-points": fewer_points,
}


# Drawn from the data, to docs/images.
PICTURES = {"reliability.svg": reliability_picture}


def content(name):
    """Markdown between a marker and its end."""
    return TABLES[name]() if name in TABLES else as_kept(name)

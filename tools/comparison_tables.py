# SPDX-License-Identifier: MIT
"""What compare-synthesizers, compare-qualities and compare-reference measured, as Markdown for the templates."""
import json
import math

NOT_MEASURED = "Not measured yet: run `{}`."


def table(heads, rows):
    lines = ["| " + " | ".join(heads) + " |", "|" + "---|" * len(heads)]
    return "\n".join(lines + ["| " + " | ".join(str(cell) for cell in row) + " |" for row in rows])


def read(folder, name):
    path = folder / name
    return json.loads(path.read_text(encoding="utf-8")) if path.exists() else None


# ---- other synthesizers --------------------------------------------------------------------------


def synthesizers(facts):
    if not facts:
        return NOT_MEASURED.format("tools/docs/compare-synthesizers")
    heads = ["drum", "version", "modes or mesh", "heads", "air", "wires that collide", "contact of the stick",
             "account of energy", "of real time", "start [s]"]
    rows = [[row["name"], row["version"], *row["physics"], f"{row['real_time_factor']:.4f}",
             f"{row['start_s']:.2f}"] for row in facts["rows"]]
    missing = facts["missing"]
    said = f"Not installed here, so not measured: {', '.join(missing)}." if missing else "All were installed."
    return (f"{table(heads, rows)}\n\n{said} Smallest of {facts['repeats']} turns; load {facts['load']:g} when "
            "they ended, so compare within this table.")


# ---- quality levels ------------------------------------------------------------------------------


def difference(row):
    first, rest = row["bands_first"], row["bands_rest"]
    return [f"{row['first_db']:+.1f} / {row['rest_db']:+.1f}", f"{row['centroid_percent']:+.0f} %",
            *(f"{part['mean_db']:.1f}, {part['worst_db']:.1f} at {part['worst_hz']} Hz" for part in (first, rest)),
            f"{row['decay_percent']:+.0f} %", f"{row['contact_ms']:+.2f}", f"{row['glide_cents']:+.1f}"]


def own_values(of):
    return [f"{of['first_db']:.1f} / {of['rest_db']:.1f} dBFS", f"{of['centroid_hz']:.0f} Hz", "", "",
            f"{of['decay_s']:.2f} s", f"{1e3 * of['contact_s']:.2f}", f"{of['glide_cents']:.1f}"]


def quality_rows(drum):
    name = f"`{drum['preset']}`"
    for level, row in drum["levels"].items():
        yield [name, level, f"{drum['costs'][level]:.2f}", *difference(row)]
    yield [name, "*reference, values*", f"{drum['costs']['reference']:.2f}", *own_values(drum["reference"])]
    yield [name, "*0.1 % faster*", "", *difference(drum["faster"])]


def qualities(facts):
    if not facts:
        return NOT_MEASURED.format("tools/docs/compare-qualities")
    heads = ["drum", "level", "of real time", "level [dB]", "centroid", "bands, first 50 ms [dB]",
             "bands, after [dB]", "decay", "contact [ms]", "glide [cents]"]
    return table(heads, [row for drum in facts["presets"] for row in quality_rows(drum)])


# ---- live and studio beside reference ------------------------------------------------------------

WITHIN = {"studio": (2.0, 2.0), "live": (3.0, 5.0)}  # [dB] in 90 % of the bands, and in all of them


NOMINAL = (100, 125, 160, 200, 250, 315, 400, 500, 630, 800)  # centres of third octaves as they are called


def hertz(frequency):
    decade = 10.0 ** math.floor(math.log10(frequency / 95.0))
    name = decade * min(NOMINAL, key=lambda centre: abs(math.log(centre * decade / frequency)))
    return f"{name:g} Hz" if name < 1000.0 else f"{name / 1000.0:g} kHz"


def extremes(levels):
    return f"{min(levels):+.1f} .. {max(levels):+.1f}" if len(levels) > 1 else f"{levels[0]:+.1f}"


def difference_rows(name, windows, by_window, groups):
    for (start, end), bands in zip(windows, by_window):
        yield [*name, f"{1e3 * start:.0f}-{1e3 * end:.0f} ms", *(extremes(bands[a:b]) for a, b in groups)]


def differences(facts):
    """The lowest and the highest band of some groups; from 6.3 kHz on every band."""
    bands, windows = facts["bands_hz"], facts["windows_s"]
    groups = [(0, 6), (6, 11), (11, 15), (15, 18), *((i, i + 1) for i in range(18, len(bands)))]
    heads = ["drum", "", "window"] + [
        f"{hertz(bands[a])} to {hertz(bands[b - 1])}" if b - a > 1 else hertz(bands[a]) for a, b in groups]
    rows = [row for preset, result in facts["presets"].items() for level, own in result["differences"].items()
            for row in difference_rows([f"`{preset}`", "*0.1 % faster*" if level == "faster" else level], windows,
                                       own, groups)]
    rows += [row for finer, own in facts.get("convergence", {}).items()
             for row in difference_rows(["`snare-14x5.5`", f"*reference, {finer}*"], windows, own, groups)]
    return table(heads, rows)


def inside(level, result):
    """How many of all bands lie within each bound; a bound is at least what a faster stroke changes."""
    own = [abs(band) for window in result["differences"][level] for band in window]
    faster = [abs(band) for window in result["differences"].get("faster", []) for band in window] or [0.0] * len(own)
    most, every = (sum(size <= max(bound, limit) for size, limit in zip(own, faster)) for bound in WITHIN[level])
    return [f"{most} of {len(own)} within {WITHIN[level][0]:g} dB", f"{every} within {WITHIN[level][1]:g} dB",
            f"{max(own):.1f} dB"]


def verdicts(facts):
    rows = [[f"`{preset}`", level, *inside(level, result), f"{result['cost'][level]:.2f}",
             f"{result['cost']['reference']:.0f}"]
            for preset, result in facts["presets"].items() for level in result["differences"] if level != "faster"]
    return table(["drum", "level", "bands", "", "largest", "of real time", "reference's, at 96 kHz"], rows)


def reference(facts):
    """What the template calls for, by name."""
    if not facts:
        return {"reference_differences": NOT_MEASURED.format("tools/docs/compare-reference"), "reference_verdicts": ""}
    return {"reference_differences": differences(facts), "reference_verdicts": verdicts(facts)}


def values(folder):
    """What the template calls for, by name."""
    changes = read(folder, "qualities.json")
    return {"synthesizers": synthesizers(read(folder, "synthesizers.json")),
            "quality_changes": qualities(changes), "quality_load": f"{changes['load']:g}" if changes else "?"}

# SPDX-License-Identifier: MIT
"""What compare-synthesizers and compare-qualities measured, as Markdown for tools/performance.template.md."""
import json

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
        return NOT_MEASURED.format("tools/compare-synthesizers")
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
        return NOT_MEASURED.format("tools/compare-qualities")
    heads = ["drum", "level", "of real time", "level [dB]", "centroid", "bands, first 50 ms [dB]",
             "bands, after [dB]", "decay", "contact [ms]", "glide [cents]"]
    return table(heads, [row for drum in facts["presets"] for row in quality_rows(drum)])


def values(folder):
    """What the template calls for, by name."""
    changes = read(folder, "qualities.json")
    return {"synthesizers": synthesizers(read(folder, "synthesizers.json")),
            "quality_changes": qualities(changes), "quality_load": f"{changes['load']:g}" if changes else "?"}

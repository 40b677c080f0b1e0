# SPDX-License-Identifier: MIT
"""Reads traces and sound files of `tabor render` and draws them. Used by plot-trace and make-validation."""
import warnings

from python_packages import Module

np = Module("numpy")
matplotlib = Module("matplotlib")
plt = Module("matplotlib.pyplot")
Image = Module("PIL.Image")  # which comes with matplotlib
signal = Module("scipy.signal")  # both for sounds only
wavfile = Module("scipy.io.wavfile")

COLUMNS = ("time_s", "head_m", "wire_m", "striker_m", "striker_force_n", "wire_force_n", "energy_j")
OPEN_GAP, CLOSED_GAP = 1e-4, 2e-5  # [m]: a bounce opens the gap beyond one, then closes it to the other
HEAD_COLOUR, WIRE_COLOUR, TOUCH_COLOUR = "#1f5a99", "#c2491d", "#777777"
STYLE = {"font.size": 9, "axes.grid": True, "grid.alpha": 0.3, "lines.linewidth": 1.0, "svg.hashsalt": "tabor",
         "axes.titlesize": 9, "legend.fontsize": 8}


class Unreadable(Exception):
    """A file that is not what it should be; the message is one line for a person."""


def read_trace(path):
    """The columns of a trace by name; what a drum does not have is NaN."""
    try:
        with open(path, encoding="ascii") as file:
            names = tuple(file.readline().strip().split(","))
            if names != COLUMNS:
                raise Unreadable(f"{path}: not a trace of `tabor render --trace`")
            with warnings.catch_warnings():
                warnings.simplefilter("ignore")
                rows = np.genfromtxt(file, delimiter=",", ndmin=2)
    except OSError as error:
        raise Unreadable(f"{path}: {error.strerror}")
    except (UnicodeDecodeError, ValueError):
        raise Unreadable(f"{path}: damaged or not a trace")
    if rows.size == 0 or rows.shape[1] != len(COLUMNS):
        raise Unreadable(f"{path}: a trace without rows")
    return dict(zip(COLUMNS, rows.T))


def read_sound(path):
    """Sample rate and first channel of a WAV file, full scale = 1."""
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            rate, samples = wavfile.read(path)
    except OSError as error:
        raise Unreadable(f"{path}: {error.strerror or error}")
    except (ValueError, EOFError) as error:
        raise Unreadable(f"{path}: not a WAV file that can be read ({error})")
    first = samples if samples.ndim == 1 else samples[:, 0]
    if first.size == 0:
        raise Unreadable(f"{path}: no samples")
    scale = np.iinfo(first.dtype).max if np.issubdtype(first.dtype, np.integer) else 1.0
    return rate, first.astype(float) / scale


def gap(trace):
    """Of wire and head at the midpoint [m], on whichever side of the head the wire lies; penetration, which is much
    smaller than a bounce, counts as 0."""
    above = trace["wire_m"] - trace["head_m"]
    return np.maximum(0.0, above if np.nansum(above) >= 0.0 else -above)


def draw_motion(axes, trace, title=""):
    """Figure 4 of [Torin2014]: head and wire over time, with a bar where they touch."""
    time = 1e3 * trace["time_s"]
    axes.plot(time, 1e3 * trace["head_m"], color=HEAD_COLOUR, label="head, centre")
    if np.isfinite(trace["wire_m"]).any():
        axes.plot(time, 1e3 * trace["wire_m"], color=WIRE_COLOUR, label="wire, midpoint")
        axes.fill_between(time, 0.0, 0.04, where=gap(trace) < CLOSED_GAP, color=TOUCH_COLOUR,
                          transform=axes.get_xaxis_transform(), linewidth=0, label="touching there")
    axes.set(xlabel="time [ms]", ylabel="height [mm]", xlim=(0, time[-1]))
    axes.set_title(title, loc="left")
    axes.legend(loc="lower right", bbox_to_anchor=(1.0, 1.0), ncols=3, frameon=False, borderpad=0)


def draw_energy(axes, trace, title=""):
    energy = np.maximum(trace["energy_j"], 1e-12)
    axes.semilogy(1e3 * trace["time_s"], 1e3 * energy, color="#333333")
    axes.set(xlabel="time [ms]", ylabel="stored [mJ]", title=title,
             xlim=(0, 1e3 * trace["time_s"][-1]))


def draw_waveform(axes, rate, sound, title=""):
    """Extremes of the samples under each of 600 columns."""
    columns = np.array_split(sound, min(600, sound.size))
    time = np.cumsum([c.size for c in columns]) / rate
    axes.fill_between(time, [c.min() for c in columns], [c.max() for c in columns],
                      color=HEAD_COLOUR, linewidth=0.4, edgecolor=HEAD_COLOUR)
    axes.set(xlabel="time [s]", title=title, xlim=(0, sound.size / rate))


def draw_spectrogram(axes, rate, sound, title="", top=16000.0, depth=90.0):
    length = min(1024, sound.size)
    frequency, time, power = signal.spectrogram(sound, rate, "hann", length, length * 3 // 4)
    if time.size < 2:
        raise Unreadable(f"{title or 'the sound'}: too short for a spectrogram")
    level = 10.0 * np.log10(np.maximum(power, 1e-30))
    axes.imshow(level, origin="lower", aspect="auto", cmap="magma", interpolation="bilinear",
                extent=(time[0], time[-1], 0.0, 1e-3 * frequency[-1]), vmin=level.max() - depth,
                vmax=level.max())
    axes.set(xlabel="time [s]", ylabel="frequency [kHz]", title=title,
             ylim=(0, 1e-3 * min(top, frequency[-1])))
    axes.grid(False)


def panels(count, height, columns=1, width=7.0):
    """A figure of count rows, and its axes as rows of columns."""
    matplotlib.use("Agg")  # no display needed
    plt.rcParams.update(STYLE)
    return plt.subplots(count, columns, figsize=(width, height * count), squeeze=False,
                        layout="constrained")


def shrink(path):
    """Rewrites a picture with 128 colours: a third of the bytes."""
    with Image.open(path) as image:
        small = image.convert("RGB").quantize(128, dither=Image.Dither.NONE)
    small.save(path, optimize=True)


def save(figure, path):
    metadata = {"Date": None} if str(path).endswith(".svg") else None
    try:
        figure.savefig(path, dpi=100, metadata=metadata)
        if str(path).endswith(".png"):
            shrink(path)
    except (OSError, ValueError) as error:
        text = getattr(error, "strerror", None) or str(error).splitlines()[0]
        raise Unreadable(f"{path}: {text}")
    finally:
        plt.close(figure)

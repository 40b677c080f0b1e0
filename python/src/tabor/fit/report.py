# SPDX-License-Identifier: MIT
"""The report: one page of HTML with tables, pictures and players, which needs no other file."""

from __future__ import annotations

import base64
import html
import io
import os
from typing import Any, List, Sequence, Tuple

import numpy as np
from numpy.typing import NDArray

from ..model import Model
from .comparison import PartialDifference, StrokeDifference, played_beside
from .features import BANDS, WINDOWS, energies, features
from .fitting import Fit
from .parameters import unit_of
from .recordings import DURATION, Stroke

Array = NDArray[np.float64]

_FRAME, _HOP = 0.04, 0.01  # of the pictures over time [s]
_BELOW = -70.0  # the loudest: less is not drawn [dB]
_SPAN = 20.0  # of the colours of differences [dB]
_PLAYED = 0.5  # peak of the players' sounds

_STYLE = """
body { font: 16px/1.5 sans-serif; max-width: 60rem; margin: 2rem auto; padding: 0 1rem; color: #222; background: #fff }
h1, h2, h3 { line-height: 1.2 } table { border-collapse: collapse; margin: 1rem 0 } img { max-width: 100% }
th, td { padding: .2rem .8rem .2rem 0; text-align: right; border-bottom: 1px solid #ddd }
th:first-child, td:first-child { text-align: left } td { white-space: nowrap } audio { height: 2rem; vertical-align: middle }
"""


def levels_over_time(sound: Array, rate: float) -> Array:
    """Third octaves of overlapping pieces.

    Parameters
    ----------
    sound : ndarray of float64, shape (frames,)
        From the stroke on.
    rate : float
        [Hz].

    Returns
    -------
    ndarray of float64, shape (len(BANDS), pieces)
        Level of each of BANDS in pieces of 40 ms, each 10 ms after the one before [dB], the first one around the stroke.
    """
    size, hop = round(_FRAME * rate), round(_HOP * rate)
    padded = np.zeros(round(DURATION * rate) + size)
    part = sound[:round(DURATION * rate)]
    padded[size // 2:size // 2 + len(part)] = part
    pieces = np.lib.stride_tricks.sliding_window_view(padded, size)[::hop] * np.hanning(size)
    finer = np.pad(pieces, ((0, 0), (0, size)))  # lines lie twice as close
    return np.asarray(10 * np.log10(np.array([energies(piece, rate, BANDS, 1 / 3) for piece in finer]).T + 1e-20))


def _axes(rows: int, columns: int, height: float) -> Tuple[Any, Any]:
    from matplotlib.figure import Figure  # type: ignore[import-not-found,import-untyped,unused-ignore]

    figure = Figure(figsize=(11, height), layout="constrained")
    return figure, figure.subplots(rows, columns, squeeze=False)


def _picture(figure: Any, what: str) -> str:
    file = io.BytesIO()
    figure.savefig(file, format="png", dpi=90)
    return f'<img alt="{html.escape(what)}" src="data:image/png;base64,{base64.b64encode(file.getvalue()).decode()}">'


def _player(sound: Array, rate: float, what: str) -> str:
    import soundfile  # type: ignore[import-untyped,import-not-found,unused-ignore]

    file = io.BytesIO()
    soundfile.write(file, _PLAYED * sound / max(float(np.abs(sound).max()), 1e-12), int(rate), format="FLAC", subtype="PCM_16")
    return (f'{html.escape(what)} <audio controls preload="none" '
            f'src="data:audio/flac;base64,{base64.b64encode(file.getvalue()).decode()}"></audio>')


def _over_time(recorded: Array, modelled: Array, rate: float, name: str) -> str:
    """Recording, model, and their difference, over time and frequency."""
    one, two = (levels_over_time(sound / np.sqrt(np.sum(sound**2)), rate) for sound in (recorded, modelled))
    one, two = one - one.max(), two - one.max()
    figure, axes = _axes(1, 3, 3.2)
    end = 1000 * DURATION
    heard = np.maximum(one, two) > _BELOW
    for axis, shown, title in zip(axes[0], (one, two, np.where(heard, two - one, np.nan)), ("recording", "model", "model - recording")):
        limits = {"vmin": -_SPAN, "vmax": _SPAN, "cmap": "RdBu_r"} if title.startswith("model -") else {"vmin": _BELOW, "vmax": 0}
        image = axis.imshow(shown, origin="lower", aspect="auto", extent=(0, end, 0, len(BANDS)), **limits)
        ticks = [BANDS.index(band) for band in BANDS if round(band) in (125, 500, 2000, 8000)]
        axis.set_yticks([tick + 0.5 for tick in ticks], [f"{BANDS[tick]:.0f}" for tick in ticks])
        axis.set_title(title)
        axis.set_xlabel("time [ms]")
        figure.colorbar(image, ax=axis, label="dB")
    axes[0][0].set_ylabel("third octave [Hz]")
    return _picture(figure, f"third octaves over time of {name}: recording, model, difference")


def _spectra(recorded: Stroke, modelled: Stroke) -> str:
    """Third octaves in the time windows."""
    figure, axes = _axes(len(recorded.recordings), len(WINDOWS), 2.8 * len(recorded.recordings))
    for row, one, two in zip(axes, recorded.recordings, modelled.recordings):
        levels, modelled_levels = features(one.channels, one.rate), features(two.channels, two.rate)
        for index, (axis, (first, last)) in enumerate(zip(row, WINDOWS)):
            bands = slice(index * len(BANDS), (index + 1) * len(BANDS))
            axis.semilogx(BANDS, levels[bands], "k.-", label="recording")
            axis.semilogx(BANDS, modelled_levels[bands], "C1.-", label="model")
            axis.set_title(f"{1000 * first:.0f} to {1000 * last:.0f} ms")
            axis.set_xlabel("third octave [Hz]")
            axis.grid(alpha=0.3)
        row[0].set_ylabel("level [dB]")
        row[0].legend()
    return _picture(figure, "third octaves in time windows, recording and model")


def _table(head: Sequence[str], rows: Sequence[Sequence[str]]) -> str:
    cells = "".join(f"<th>{html.escape(one)}</th>" for one in head)
    lines = ["<tr>" + "".join(f"<td>{html.escape(one)}</td>" for one in row) + "</tr>" for row in rows]
    return f"<table><tr>{cells}</tr>{''.join(lines)}</table>"


def _stroke(found: Fit, model: Model, stroke: Stroke, difference: Sequence[StrokeDifference], kind: str) -> List[str]:
    speed = difference[0].speed
    modelled = played_beside(model, found.request.mics, speed, stroke)
    parts = [f"<h3>{html.escape(os.path.basename(stroke.recordings[0].name))}</h3><p>{kind}, at {speed:.2f} m/s</p>"]
    for mic, one, two, apart in zip(found.request.mics, stroke.recordings, modelled.recordings, difference):
        parts.append(f"<p>{html.escape(mic)}: third octaves differ by {apart.early:.1f} dB from 0 to 50 ms, by {apart.late:.1f} dB from "
                     f"50 to 200 ms. {_player(one.sound, one.rate, 'recording')} {_player(two.sound, two.rate, 'model')}</p>")
        parts.append(_over_time(one.sound, two.sound, one.rate, mic))
    parts.append(_spectra(stroke, modelled))
    return parts


def make_report(found: Fit, model: Model, fitted: Sequence[StrokeDifference], predicted: Sequence[StrokeDifference],
                partials: Sequence[PartialDifference]) -> str:
    """Makes the page.

    Parameters
    ----------
    found : Fit
        What was found.
    model : Model
        The drum of it.
    fitted, predicted : sequence of StrokeDifference
        Of the request's strokes and of those that were kept, stroke by stroke, microphone by microphone.
    partials : sequence of PartialDifference
        Of the recording's partials.

    Returns
    -------
    str
        HTML.
    """
    request, count = found.request, len(found.request.mics)
    name = html.escape(request.name)
    parts = [f'<!doctype html><html lang="en"><meta charset="utf-8"><title>{name}</title><style>{_STYLE}</style><h1>{name}</h1>']
    for key in ("comment", "license"):
        if found.definition[f"drum.{key}"]:
            parts.append(f"<p>{html.escape(str(found.definition[f'drum.{key}']))}</p>")
    parts.append(f"<p>Objective: {found.objective:.2f}; 1: the model is as far from the recordings as strokes of the same dynamics are "
                 "from each other.</p><h2>Parameters</h2><p>A parameter is determined if its 90 % interval is at most half as wide as the "
                 "range in which it was looked for.</p>")
    parts.append(_table(("parameter", "value", "90 % interval", "looked for", "unit", ""), [
        (one.key, f"{one.value:.4g}", f"{one.low:.4g} to {one.high:.4g}", f"{one.least:.4g} to {one.most:.4g}",
         unit_of(one.key), "" if one.determined else "not determined") for one in found.estimates]))
    parts.append("<h2>Partials</h2><p>Of the recording, with the model's beside them.</p>")
    parts.append(_table(("frequency [Hz]", "decay [1/s]", "level [dB]", "model [cents]", "model's decay over it"), [
        (f"{one.frequency:.1f}", f"{one.decay_rate:.1f}", f"{one.level:.0f}", f"{one.cents:+.0f}", f"{one.decay_ratio:.2f}") for one in partials]))
    parts.append("<h2>Strokes</h2>")
    for strokes, differences, kind in ((request.strokes, fitted, "Fitted"), (request.kept, predicted, "Predicted, the speed alone free")):
        for index, stroke in enumerate(strokes):
            parts += _stroke(found, model, stroke, differences[index * count:(index + 1) * count], kind)
    return "\n".join(parts) + "</html>\n"

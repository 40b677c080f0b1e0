# SPDX-License-Identifier: MIT
import sys
import threading

import numpy as np
import pytest

import tabor
import tabor.takes
import tabor.model

DRUMS = [tabor.Definition("frame-drum", {"batter.tension": tension}) for tension in (2000, 2500, 3000)]
TAKES = [[tabor.strike(0, 1.0)], [tabor.strike(0, 4.0), tabor.strike(0.02, 2.0)]]
DRAFT = {"duration": 0.05, "quality": "draft"}


@pytest.mark.parametrize("workers", [1, 2, 5])
def test_a_kit_is_what_each_drum_renders(workers):
    kit = tabor.render_takes(DRUMS, TAKES, mics=["far", "top"], workers=workers, **DRAFT)
    assert kit.shape == (3, 2, 2, 2400) and kit.dtype == np.float32
    for drum, sounds in zip(DRUMS, kit):
        for take, sound in zip(TAKES, sounds):
            np.testing.assert_array_equal(sound, tabor.render(drum, take, mics=["far", "top"], **DRAFT))


def test_one_stroke_and_the_usual_microphone_unless_told():
    kit = tabor.render_takes(["frame-drum", tabor.Model("tabor", quality="draft")], **DRAFT)
    assert kit.shape == (2, 1, 1, 2400)
    np.testing.assert_array_equal(kit[1, 0], tabor.render("tabor", **DRAFT))


def test_rooms_are_heard():
    hall = tabor.Definition("frame-drum", {"room.kind": "hall"})
    np.testing.assert_array_equal(tabor.render_takes([hall], **DRAFT)[0, 0], tabor.render(hall, **DRAFT))


def test_a_drum_is_computed_once(monkeypatch):
    built = []
    def count(*arguments):
        built.append(arguments[0])
        return original(*arguments)
    original = tabor.takes.model_of
    monkeypatch.setattr(tabor.takes, "model_of", count)
    kit = tabor.render_takes([DRUMS[0], DRUMS[1], DRUMS[0].copy()], TAKES * 2, **DRAFT)
    assert len(built) == 2
    np.testing.assert_array_equal(kit[0], kit[2])
    assert (kit[0] != kit[1]).any()


def test_progress_counts_in_the_calling_thread():
    seen = []
    def note(*counts):
        seen.append((counts, threading.get_ident()))
    tabor.render_takes(DRUMS + DRUMS[:1], TAKES, progress=note, **DRAFT)
    counts = [pair for pair, _ in seen]
    assert counts == sorted(set(counts)) and counts[-1] == (8, 8)
    assert {thread for _, thread in seen} == {threading.get_ident()}


def test_two_drums_are_computed_at_the_same_time(monkeypatch):
    """Each of two jobs waits for the other one to have begun."""
    both = threading.Barrier(2, timeout=60)
    original = tabor.takes.model_of
    def meet(*arguments):
        both.wait()
        return original(*arguments)
    monkeypatch.setattr(tabor.takes, "model_of", meet)
    tabor.render_takes(DRUMS[:2], workers=2, **DRAFT)


def test_other_threads_run_while_a_model_is_computed(monkeypatch):
    """The library lets go of Python's lock. Here no thread loses the lock unless it lets go, so this one gets it before
    the model is there only if the library does. A slow start of this thread is no failure: there are ten attempts."""
    began, ended = threading.Event(), threading.Event()
    original = tabor.model.check
    def announced(*arguments):
        began.set()
        original(*arguments)
    def build():
        tabor.Model(definition)
        ended.set()
    def computing_while_this_runs():
        began.clear()
        ended.clear()
        thread = threading.Thread(target=build)
        thread.start()
        began.wait()
        computing = not ended.is_set()
        thread.join()
        return computing
    definition = tabor.Definition("snare-14x5.5")
    monkeypatch.setattr(tabor.model, "check", announced)
    interval = sys.getswitchinterval()
    sys.setswitchinterval(1000)
    try:
        assert any(computing_while_this_runs() for _ in range(10))
    finally:
        sys.setswitchinterval(interval)


def test_an_error_says_which_drum():
    wrong = tabor.Definition("frame-drum", {"strike.radius": 0.6})
    before = threading.active_count()
    with pytest.raises(tabor.Error) as refused:
        tabor.render_takes([DRUMS[0], wrong, DRUMS[1]], **DRAFT)
    assert (refused.value.index, refused.value.key) == (1, "strike.radius")
    with pytest.raises(tabor.UnknownNameError) as refused:
        tabor.render_takes(["frame-drum", "tom-12"], mics=["nowhere"], workers=1, **DRAFT)
    assert refused.value.index == 0
    assert threading.active_count() == before


def test_an_exception_of_progress_ends_it():
    def interrupt(done, total):
        raise KeyboardInterrupt
    before = threading.active_count()
    with pytest.raises(KeyboardInterrupt):
        tabor.render_takes(DRUMS, TAKES, progress=interrupt, **DRAFT)
    assert threading.active_count() == before


def test_what_makes_no_kit():
    with pytest.raises(TypeError):
        tabor.render_takes("frame-drum")
    with pytest.raises(ValueError, match="workers 0"):
        tabor.render_takes(DRUMS, workers=0)
    with pytest.raises(ValueError, match="48000 Hz, not for 44100 Hz"):
        tabor.render_takes([tabor.Model("tabor", quality="draft")], sample_rate=44100)
    assert tabor.render_takes([], duration=0.01).shape == (0, 1, 1, 480)
    assert tabor.render_takes(DRUMS, [], **DRAFT).shape == (3, 0, 1, 2400)


def test_takes_ring_out_unless_told():
    takes = [[tabor.strike(0, 1)], [tabor.strike(0, 1), tabor.strike(0.7, 3)]]
    models = [tabor.Model("tabor", quality="draft"), tabor.Model("frame-drum", quality="draft")]
    kit = tabor.render_takes(models + models[:1], takes)
    sounds = [[tabor.render(model, take) for take in takes] for model in models + models[:1]]
    lengths = {sound.shape[1] for row in sounds for sound in row}
    assert kit.shape == (3, 2, 1, max(lengths)) and len(lengths) > 1
    for row, expected in zip(kit, sounds):
        for sound, alone in zip(row, expected):
            np.testing.assert_array_equal(sound[:, :alone.shape[1]], alone)
            assert (sound[:, alone.shape[1]:] == 0).all()
    assert tabor.render_takes([]).shape == (0, 1, 1, 0)


def test_the_former_name_warns():
    with pytest.warns(DeprecationWarning, match="render_takes"):
        sound = tabor.render_kit(DRUMS[:1], [], **DRAFT)
    assert sound.shape == tabor.render_takes(DRUMS[:1], [], **DRAFT).shape

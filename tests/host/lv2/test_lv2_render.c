/* SPDX-License-Identifier: MIT */
/*
 * The plugins play a MIDI file as `tabor render --midi-file` does, to the bit, whatever the sizes of the runs
 * are.
 *
 * test_lv2_render PROGRAM PLUGINS [brief | songs NUMBER]
 */
#include "plugin_host.h"

#include "midi/midi_file.h" /* before cmocka, which takes the name of fail() */
#include <math.h>
#include <setjmp.h>
#include <sndfile.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <cmocka.h>

#include "lv2/uris.h"
#include "midi_writer.h"

#define DIVISION 480 /* ticks of a quarter, which is half a second */
#define MOST_FRAMES 48000
#define MOST_MESSAGES 512

static const char *program, *plugins;
static bool brief;
static unsigned random_songs = 3;
static char folder[] = "/tmp/tabor-lv2-XXXXXX";

/* ---- songs ---------------------------------------------------------------------------------- */

typedef struct Song {
  MidiWriter writer;
  HostMessage messages[MOST_MESSAGES];
  size_t count;
} Song;

static Song song;

static void begin_song(void) {
  midi_write_header(&song.writer, 0, 1, DIVISION);
  midi_write_track(&song.writer);
}

static void add(uint32_t delta, uint8_t status, uint8_t first, uint8_t second) {
  const uint8_t bytes[] = {status, first, second};
  midi_write_event(&song.writer, delta, 1u + midi_data_count(status), bytes);
}

static void path_to(char *path, size_t size, const char *name) {
  (void)snprintf(path, size, "%s/%s", folder, name);
}

/* Writes the file, and reads from it what the plugin is to get at which frames. */
static void end_song(void) {
  char path[256];
  MidiFile file;
  midi_write_end(&song.writer, 0);
  path_to(path, sizeof path, "song.mid");
  FILE *const stream = fopen(path, "wb");
  assert_non_null(stream);
  assert_int_equal(fwrite(song.writer.bytes, 1, song.writer.length, stream), song.writer.length);
  assert_int_equal(fclose(stream), 0);
  assert_int_equal(midi_file_read(path, &file), OUTCOME_OK);
  assert_true(file.count <= MOST_MESSAGES);
  song.count = file.count;
  for (size_t i = 0; i < file.count; i++) {
    song.messages[i] =
      (HostMessage){(uint64_t)llround(48000 * file.events[i].time), file.events[i].message};
  }
  midi_file_free(&file);
}

/* Everything that MIDI can do: places, grip, strainer, gain, hands, silence and strokes while it fades,
   velocities of high resolution, notes of all kinds. */
static void write_all(void) {
  begin_song();
  add(0, 0x99, 38, 100);
  add(60, 0xB9, 16, 90);
  add(0, 0xB9, 17, 20);
  add(10, 0xB9, 88, 55);
  add(0, 0x99, 41, 70);
  add(40, 0x99, 36, 127);
  add(0, 0x99, 37, 90);
  add(7, 0xB9, 20, 10);
  add(25, 0xD9, 90, 0);
  add(31, 0xD9, 0, 0);
  add(1, 0xA9, 38, 30);
  add(20, 0xB9, 7, 100);
  add(3, 0x99, 40, 80);
  add(5, 0xB9, 11, 40);
  add(20, 0xB9, 20, 127);
  add(0, 0x99, 39, 80);
  add(50, 0xB9, 120, 0);
  add(4, 0x99, 38, 110);
  add(1, 0xB9, 11, 127);
  add(0, 0x89, 38, 64);
  add(30, 0x99, 60, 100);
  add(30, 0x99, 48, 20);
  end_song();
}

static void write_presets(void) {
  uint8_t presets[3] = {0, 1, 0}; /* tabor and frame-drum, which continue nothing of each other */
  begin_song();
  add(0, 0xC9, presets[0], 0);
  add(0, 0x99, 38, 100);
  add(200, 0xC9, presets[1], 0);
  add(0, 0x99, 38, 90);
  add(100, 0xC9, presets[2], 0);
  add(20, 0x99, 38, 90);
  end_song();
}

/* Programs, as `tabor presets` lists them. */
enum { SNARE = 5, SNARE_OFF, LOOSE, PICCOLO, MARCHING, TOM };

static void begin_ringing(void) {
  begin_song();
  add(0, 0x99, 38, 110);
}

static void end_struck(void) {
  add(100, 0x99, 38, 100);
  end_song();
}

/* To a drum without a stereo pair. */
static void write_other_mics(void) {
  begin_ringing();
  add(200, 0xC9, TOM, 0);
  end_struck();
}

static void write_two_at_once(void) {
  begin_ringing();
  add(100, 0xC9, LOOSE, 0);
  add(0, 0xC9, PICCOLO, 0);
  add(0, 0x99, 38, 90);
  add(100, 0xC9, MARCHING, 0);
  add(0, 0xC9, LOOSE, 0);
  end_struck();
}

/* What is moved stays, since nothing changes; then there is a real change. */
static void write_there_and_back(void) {
  begin_song();
  add(0, 0xC9, LOOSE, 0);
  add(0, 0x99, 38, 110);
  add(20, 0xB9, 20, 0);
  add(30, 0xC9, TOM, 0);
  add(0, 0xC9, PICCOLO, 0);
  add(0, 0xC9, LOOSE, 0);
  add(20, 0x99, 38, 80);
  add(50, 0xC9, TOM, 0);
  add(0, 0xC9, LOOSE, 0);
  add(0, 0xC9, SNARE, 0);
  end_struck();
}

/* More drums leave within 30 ms, which are 28.8 ticks, than may at once; and one while it rings. */
static void write_one_after_the_other(void) {
  static const uint8_t presets[] = {TOM, SNARE, LOOSE, MARCHING, 0, 1, PICCOLO};
  begin_ringing();
  add(100, 0x99, 38, 100);
  for (uint32_t i = 0; i < sizeof presets; i++) {
    add(i == 0 ? 20 : 4, 0xC9, presets[i], 0);
    add(0, 0x99, 38, 90);
  }
  add(60, 0xC9, LOOSE, 0);
  end_struck();
}

/* Strainer and grip begin anew, on a drum that could continue this one. */
static void write_moved_before(void) {
  begin_ringing();
  add(10, 0xB9, 20, 0);
  add(0, 0xB9, 1, 127);
  add(40, 0x99, 38, 90);
  add(50, 0xC9, LOOSE, 0);
  add(0, 0x99, 38, 90);
  add(30, 0xB9, 120, 0); /* what was moved before the change does not come back */
  add(0, 0x99, 38, 90);
  add(30, 0xC9, SNARE, 0);
  add(0, 0xB9, 20, 20);
  add(0, 0x99, 38, 90);
  add(40, 0xB9, 20, 90);
  add(0, 0xC9, LOOSE, 0);
  end_struck();
}

/* Silences before, with and after changes, and changes while they fade. */
static void write_silences(void) {
  begin_ringing();
  add(50, 0xB9, 120, 0);
  add(0, 0xC9, LOOSE, 0);
  add(0, 0x99, 38, 90);
  add(50, 0xC9, TOM, 0);
  add(3, 0xB9, 123, 0);
  add(2, 0xC9, PICCOLO, 0);
  add(5, 0xC9, TOM, 0);
  add(0, 0x99, 38, 90);
  add(40, 0xC9, SNARE, 0);
  add(0, 0xB9, 120, 0);
  add(0, 0xC9, TOM, 0);
  end_struck();
}

/* Changes between silences, and controllers and strokes between them. */
static void write_stacked_silences(void) {
  begin_ringing();
  add(100, 0xB9, 120, 0);
  add(1, 0xC9, LOOSE, 0);
  add(1, 0xB9, 120, 0);
  add(1, 0xC9, SNARE_OFF, 0);
  add(1, 0xB9, 20, 127);
  add(6, 0x99, 38, 100);
  add(100, 0xB0, 123, 0);
  add(0, 0xB1, 123, 0);
  add(1, 0xC9, LOOSE, 0);
  add(2, 0x99, 38, 120); /* silent before it sounds */
  add(0, 0xB9, 20, 30);
  add(0, 0xB9, 123, 0);
  add(1, 0x99, 38, 100);
  add(1, 0xC9, SNARE_OFF, 0); /* beside which the stroke rings out */
  add(0, 0xB9, 20, 127);
  add(6, 0x99, 38, 100);
  end_struck();
}

/* What hosts send when they stop, on all channels. */
static void write_panic(void) {
  static const uint8_t controllers[] = {120, 123, 121, 7, 11};
  begin_ringing();
  add(70, 0xB9, 20, 90);
  for (uint32_t i = 0; i < 16 * sizeof controllers; i++) {
    const uint8_t controller = controllers[i % sizeof controllers];
    const uint8_t value = controller == 7 ? 100 : controller == 11 ? 127 : 0;
    add(i == 0 ? 30 : 0, (uint8_t)(0xB0 + i / sizeof controllers), controller, value);
  }
  add(40, 0xC9, PICCOLO, 0);
  add(0, 0x99, 38, 90);
  end_struck();
}

/* More than may wait: of gains the last counts. */
static void write_many_gains(void) {
  begin_ringing();
  for (uint32_t i = 0; i < 100; i++) add(i == 0 ? 100 : 0, 0xB9, 7, (uint8_t)(i * 37 % 128));
  add(50, 0xB9, 120, 0);
  for (uint32_t i = 0; i < 300; i++)
    add(i % 30 == 1, 0xB9, i % 2 ? 7 : 11, (uint8_t)(127 - i % 64));
  add(2, 0x99, 38, 110);
  end_struck();
}

/* At a tempo of four ticks a frame, of which those of one frame act together, controllers and changes before notes. */
static void write_within_a_frame(void) {
  begin_song();
  midi_write_tempo(&song.writer, 0, DIVISION * 1000000 / 192000);
  add(0, 0x99, 38, 100);
  add(20000, 0x99, 38, 90);
  add(1, 0xB9, 16, 127);
  add(19999, 0x99, 38, 90);
  add(1, 0xC9, TOM, 0);
  add(19999, 0xB9, 20, 30);
  add(0, 0x99, 41, 90);
  add(1, 0xC9, SNARE_OFF, 0);
  add(19999, 0x99, 38, 100);
  end_song();
}

/* Heads of other sizes than the first one's, struck near the rim and elsewhere. */
static void write_sizes(void) {
  static const uint8_t presets[] = {0, 13, TOM, 1};
  begin_ringing();
  add(0, 0xB9, 16, 127);
  for (uint32_t i = 0; i < sizeof presets; i++) {
    add(60, 0xC9, presets[i], 0);
    add(0, 0x99, 38, 90);
    add(30, 0x99, 40, 80);
    if (i == 1) add(0, 0xB9, 16, 30);
  }
  end_struck();
}

static uint8_t below(uint64_t *random, uint32_t end) {
  return (uint8_t)(midi_random(random) % end);
}

static void add_any(uint64_t *random) {
  static const uint8_t controllers[] = {120, 123, 20, 20, 7, 11, 16, 17, 1, 88};
  const uint32_t delta = below(random, 3) == 0 ? below(random, 30) : below(random, 3);
  const uint8_t channel = below(random, 16), kind = below(random, 10);
  if (kind < 4) {
    add(delta, 0x90 | channel, (uint8_t)(36 + below(random, 15)), below(random, 128));
  } else if (kind < 7) {
    add(delta, 0xB0 | channel, controllers[below(random, sizeof controllers)], below(random, 128));
  } else if (kind < 9) {
    add(delta, 0xC0 | channel, (uint8_t)(SNARE + below(random, 3)), 0);
  } else {
    add(delta, 0xD0 | channel, (uint8_t)(100 * below(random, 2)), 0);
  }
}

static void write_random(uint64_t seed) {
  begin_ringing();
  for (uint32_t i = 0; i < (brief ? 50 : 120); i++) add_any(&seed);
  add(1, 0x99, 38, 100);
  end_song();
}

/* ---- both ways ------------------------------------------------------------------------------ */

typedef struct Take {
  uint32_t frames, channels;
  float *sound[HOST_OUTPUTS];
} Take;

static void open_take(Take *take, uint32_t channels) {
  *take = (Take){.frames = brief ? MOST_FRAMES / 2 : MOST_FRAMES, .channels = channels};
  for (uint32_t i = 0; i < channels; i++) {
    take->sound[i] = calloc(MOST_FRAMES, sizeof(float));
    assert_non_null(take->sound[i]);
  }
}

static void close_take(Take *take) {
  for (uint32_t i = 0; i < take->channels; i++) free(take->sound[i]);
}

static const char rendered[] = "render -o",
                  performed[] = "play --backend file --humanize 0 --record";

/* As the program has it, by one of these commands. */
static void take_from(const char *command_name, const char *options, const char *const *mics,
                      Take *take) {
  char command[1024], path[256];
  size_t length =
    (size_t)snprintf(command, sizeof command,
                     "'%s' %s '%s/song.wav' -q --midi-file '%s/song.mid' "
                     "--format float --duration %s %s",
                     program, command_name, folder, folder, brief ? "0.5" : "1", options);
  for (uint32_t i = 0; i < take->channels; i++) {
    length += (size_t)snprintf(command + length, sizeof command - length, " --mic %s", mics[i]);
  }
  assert_int_equal(system(command), 0);
  path_to(path, sizeof path, "song.wav");
  SF_INFO info = {0};
  SNDFILE *const file = sf_open(path, SFM_READ, &info);
  assert_non_null(file);
  assert_int_equal(info.channels, take->channels);
  assert_int_equal(info.frames, take->frames);
  float frame[HOST_OUTPUTS];
  for (uint32_t at = 0; at < take->frames; at++) {
    assert_int_equal(sf_readf_float(file, frame, 1), 1);
    for (uint32_t i = 0; i < take->channels; i++) take->sound[i][at] = frame[i];
  }
  sf_close(file);
}

static void play(PluginHost *host, uint32_t block, Take *take) {
  host->freewheel = 1;
  host_play(host, song.messages, song.count, take->frames, block, take->sound);
}

static void compare(const Take *expected, const Take *take, uint32_t block) {
  for (uint32_t i = 0; i < take->channels; i++) {
    for (uint32_t at = 0; at < take->frames; at++) {
      if (expected->sound[i][at] == take->sound[i][at]) continue;
      fail_msg("runs of %u, channel %u, frame %u: %.9g, not %.9g", (unsigned)block, (unsigned)i,
               (unsigned)at, (double)take->sound[i][at], (double)expected->sound[i][at]);
    }
  }
  assert_true(host_peak(take->sound[0], take->frames) > 0.01);
}

static const char *const pair[] = {"left", "right"};
static const char *const all[] = {"top", "bottom", "near", "far", "left", "right", "inside"};

/* ---- tests ---------------------------------------------------------------------------------- */

/* The plugin, set by @p prepare before the first run, in runs of these sizes. */
static void same_in_plugin(const char *uri, const Take *expected, void (*prepare)(PluginHost *),
                           const uint32_t *blocks, size_t count) {
  Take take;
  open_take(&take, expected->channels);
  for (size_t i = 0; i < (brief ? 1 : count); i++) {
    PluginHost *const host = host_open(host_descriptor(plugins, uri), HOST_WITHOUT_WORKER);
    if (prepare) prepare(host);
    play(host, blocks[i], &take);
    compare(expected, &take, blocks[i]);
    host_close(host);
  }
  close_take(&take);
}

static void same_as_render(const char *uri, const char *options, void (*prepare)(PluginHost *),
                           const uint32_t *blocks, size_t count) {
  const bool stereo = strcmp(uri, URI_DRUM) == 0;
  Take expected;
  open_take(&expected, port_outputs(stereo));
  take_from(rendered, options, stereo ? pair : all, &expected);
  same_in_plugin(uri, &expected, prepare, blocks, count);
  close_take(&expected);
}

static void at_draft(PluginHost *host) { host->knobs[KNOB_QUALITY] = 0; }

static void test_runs_of_every_size(void **state) {
  (void)state;
  static const uint32_t blocks[] = {37, 1, 64, 1000, HOST_BLOCK, 0, 0};
  write_all();
  same_as_render(URI_DRUM, "--quality draft", at_draft, blocks, 7);
}

static void test_the_usual_quality_is_live(void **state) {
  (void)state;
  static const uint32_t blocks[] = {256};
  write_all();
  same_as_render(URI_DRUM, "--quality live", NULL, blocks, 1);
}

static void test_an_output_per_microphone(void **state) {
  (void)state;
  static const uint32_t blocks[] = {512, 0};
  write_all();
  same_as_render(URI_DRUM_MULTI, "--quality draft", at_draft, blocks, 2);
}

static void test_program_changes(void **state) {
  (void)state;
  static const uint32_t blocks[] = {100, 4096, 0};
  write_presets();
  same_as_render(URI_DRUM, "--quality draft", at_draft, blocks, 3);
}

static void in_a_room(PluginHost *host) {
  at_draft(host);
  host->knobs[KNOB_ROOM] = TABOR_ROOM_STUDIO;
}

/* In a room, which hears the same. */
static void same_everywhere(void) {
  static const char options[] = "--quality draft --set room.kind=studio";
  static const uint32_t blocks[] = {0, 100};
  Take expected, take;
  open_take(&expected, 2);
  open_take(&take, 2);
  take_from(rendered, options, pair, &expected);
  same_in_plugin(URI_DRUM, &expected, in_a_room, blocks, 2);
  if (!brief) {
    take_from(performed, options, pair, &take);
    compare(&expected, &take, 0);
  }
  close_take(&expected);
  close_take(&take);
}

static void test_changes_of_all_kinds(void **state) {
  (void)state;
  static void (*const songs[])(void) = {
    write_other_mics,   write_two_at_once,   write_there_and_back,   write_one_after_the_other,
    write_moved_before, write_silences,      write_stacked_silences, write_panic,
    write_many_gains,   write_within_a_frame};
  for (size_t i = 0; i < sizeof songs / sizeof songs[0]; i++) {
    print_message("song %u\n", (unsigned)i + 1);
    songs[i]();
    same_everywhere();
  }
}

static void test_random_songs(void **state) {
  (void)state;
  for (uint64_t seed = 1; seed <= (brief ? 1 : random_songs); seed++) {
    print_message("seed %u\n", (unsigned)seed);
    write_random(seed);
    same_everywhere();
  }
}

static void scattered(PluginHost *host) {
  at_draft(host);
  host->knobs[KNOB_HUMANIZE] = 0.3f;
}

/* By the size of the drum that they fall on. */
static void test_strokes_are_scattered_on_their_drum(void **state) {
  (void)state;
  static const uint32_t blocks[] = {100};
  Take expected, take;
  open_take(&expected, 2);
  open_take(&take, 2);
  write_sizes();
  same_as_render(URI_DRUM, "--quality draft --humanize 0.3", scattered, blocks, 1);
  take_from(rendered, "--quality draft --humanize 0.3", pair, &expected);
  take_from("play --backend file --record", "--quality draft --humanize 0.3", pair, &take);
  compare(&expected, &take, 0);
  close_take(&expected);
  close_take(&take);
}

static void test_a_change_at_live(void **state) {
  (void)state;
  static const uint32_t blocks[] = {512};
  if (brief) {
    print_message("SKIPPED: it takes too long under sanitizers\n");
    skip();
  }
  write_two_at_once();
  same_as_render(URI_DRUM, "--quality live", NULL, blocks, 1);
}

/* ---- what a program change is ---- */

enum { CHANGED = 60, FADE = 1440 }; /* ticks; frames of 30 ms */

static const uint32_t change_frame = CHANGED * 48000 / 2 / DIVISION;

static const double ROUNDING = 1e-7; /* of single precision, after the fade and not before it */

/* The old drum at its own microphones, under the fade and nothing else; the new one is not struck. */
static void test_the_old_drum_rings_out(void **state) {
  (void)state;
  Take ringing, changed;
  open_take(&ringing, 2);
  open_take(&changed, 2);
  begin_ringing();
  end_song();
  take_from(rendered, "--quality draft", pair, &ringing);
  begin_ringing();
  add(CHANGED, 0xC9, TOM, 0);
  end_song();
  take_from(rendered, "--quality draft", pair, &changed);
  for (uint32_t channel = 0; channel < 2; channel++) {
    for (uint32_t at = 0; at < changed.frames; at++) {
      const uint32_t gone = at < change_frame ? 0 : at - change_frame;
      const double part = at < change_frame ? 1 : gone < FADE ? (FADE - gone) / (FADE + 1.0) : 0;
      const double expected = part * (double)ringing.sound[channel][at];
      const double off = (double)changed.sound[channel][at] - expected;
      if (fabs(off) > ROUNDING * fabs(expected)) fail_msg("frame %u", (unsigned)at);
    }
    assert_true(host_peak(changed.sound[channel] + change_frame, FADE) > 1e-3);
  }
  close_take(&ringing);
  close_take(&changed);
}

static void write_change(bool moves) {
  begin_ringing();
  if (moves) {
    add(10, 0xB9, 20, 0);
    add(0, 0xB9, 1, 127);
  }
  add(CHANGED - (moves ? 10 : 0), 0xC9, LOOSE, 0);
  end_struck();
}

/* These two drums are alike enough to be continued, which would keep what was moved. */
static void test_live_values_begin_anew(void **state) {
  (void)state;
  Take plain, moved;
  open_take(&plain, 2);
  open_take(&moved, 2);
  write_change(false);
  take_from(rendered, "--quality draft", pair, &plain);
  write_change(true);
  take_from(rendered, "--quality draft", pair, &moved);
  const uint32_t first = change_frame + FADE;
  const size_t size = (plain.frames - first) * sizeof(float);
  for (uint32_t channel = 0; channel < 2; channel++) {
    const float *const a = plain.sound[channel], *const b = moved.sound[channel];
    assert_memory_not_equal(a, b, change_frame * sizeof(float));
    assert_memory_equal(a + first, b + first, size);
    assert_true(host_peak(a + first, plain.frames - first) > 1e-3);
  }
  close_take(&plain);
  close_take(&moved);
}

static void turned(PluginHost *host) {
  at_draft(host);
  host->knobs[KNOB_BATTER_TENSION] = 4321;
  host->knobs[KNOB_STICK_HARDNESS] = 5e6f;
  host->knobs[KNOB_STRIKE_RADIUS] = 0.08f;
  host->knobs[KNOB_STRIKE_ANGLE] = -45;
  host->knobs[KNOB_VELOCITY_CURVE] = 2;
  host->knobs[KNOB_VELOCITY_RANGE] = 1;
  host->knobs[KNOB_HUMANIZE] = 0.7f;
  host->knobs[KNOB_GAIN] = -3.3f;
}

static void test_knobs_are_options(void **state) {
  (void)state;
  static const uint32_t blocks[] = {256, 0};
  write_all();
  same_as_render(
    URI_DRUM,
    "--quality draft --set batter.tension=4321 --set striker.stick.contact_stiffness=5e6 "
    "--set strike.radius=0.08 --set strike.angle=-45 --velocity-curve hard "
    "--velocity-range full --humanize 0.7 --gain -3.3",
    turned, blocks, 2);
}

static void test_silence_is_exactly_zero(void **state) {
  (void)state;
  PluginHost *const host = host_open(host_descriptor(plugins, URI_DRUM), HOST_WITHOUT_WORKER);
  at_draft(host);
  host->freewheel = 1;
  for (int run = 0; run < 20; run++) {
    host_run(host, 512);
    for (uint32_t i = 0; i < 2; i++) assert_true(host_peak(host->sound[i], 512) == 0);
  }
  host_note(host, 5, 38, 100);
  host_run(host, 5);
  assert_true(host_peak(host->sound[0], 5) == 0);
  host_close(host);
}

int main(int argc, char **argv) {
  if (argc < 3) return 1;
  program = argv[1];
  plugins = argv[2];
  brief = argc == 4;
  if (argc == 5) random_songs = (unsigned)atoi(argv[4]);
  if (!mkdtemp(folder)) return 1;
  const struct CMUnitTest tests[] = {
    cmocka_unit_test(test_runs_of_every_size),
    cmocka_unit_test(test_the_usual_quality_is_live),
    cmocka_unit_test(test_an_output_per_microphone),
    cmocka_unit_test(test_program_changes),
    cmocka_unit_test(test_changes_of_all_kinds),
    cmocka_unit_test(test_random_songs),
    cmocka_unit_test(test_strokes_are_scattered_on_their_drum),
    cmocka_unit_test(test_a_change_at_live),
    cmocka_unit_test(test_the_old_drum_rings_out),
    cmocka_unit_test(test_live_values_begin_anew),
    cmocka_unit_test(test_knobs_are_options),
    cmocka_unit_test(test_silence_is_exactly_zero),
  };
  const struct CMUnitTest songs[] = {cmocka_unit_test(test_random_songs)};
  const int failed = argc == 5 ? cmocka_run_group_tests(songs, NULL, NULL)
                               : cmocka_run_group_tests(tests, NULL, NULL);
  char command[64];
  (void)snprintf(command, sizeof command, "rm -r '%s'", folder);
  return system(command) == 0 ? failed : 1;
}

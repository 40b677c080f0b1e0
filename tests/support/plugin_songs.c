/* SPDX-License-Identifier: MIT */
#include "plugin_songs.h"

#include "drums/stereo_pair.h"
#include "midi/midi_file_input.h" /* both before cmocka, which takes the name of fail() */
#include <math.h>
#include <setjmp.h>
#include <sndfile.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "midi_writer.h"
#include "strokes/humanize.h"
#include "windows_names.h"

static const char *program;
static bool brief;
static char folder[] = "/tmp/tabor-songs-XXXXXX";

bool songs_begin(const char *tabor, bool shorter) {
  program = tabor;
  brief = shorter;
  return mkdtemp(folder) != NULL;
}

bool songs_end(void) { return remove_folder(folder) == 0; }

/* ---- songs ---------------------------------------------------------------------------------- */

Song song;

void song_begin(void) {
  midi_write_header(&song.writer, 0, 1, DIVISION);
  midi_write_track(&song.writer);
}

void song_add(uint32_t delta, uint8_t status, uint8_t first, uint8_t second) {
  const uint8_t bytes[] = {status, first, second};
  midi_write_event(&song.writer, delta, 1u + midi_data_count(status), bytes);
}

void song_path(char *path, size_t size, const char *name) {
  (void)snprintf(path, size, "%s/%s", folder, name);
}

/* Writes the file, and reads from it what the plugin is to get at which frames. */
void song_end(void) {
  char path[256];
  MidiFile file;
  midi_write_end(&song.writer, 0);
  song_path(path, sizeof path, "song.mid");
  FILE *const stream = fopen(path, "wb");
  assert_non_null(stream);
  assert_int_equal(fwrite(song.writer.bytes, 1, song.writer.length, stream), song.writer.length);
  assert_int_equal(fclose(stream), 0);
  assert_int_equal(midi_file_read(path, false, &file), OUTCOME_OK);
  assert_true(file.count <= MOST_MESSAGES);
  song.count = file.count;
  for (size_t i = 0; i < file.count; i++) {
    song.messages[i] =
      (HostMessage){(uint64_t)llround(48000 * file.events[i].time), file.events[i].message};
  }
  midi_file_free(&file);
}

/* Everything that MIDI can do: places, grip, strainer, gain, hands, silence and strokes while it
   fades, velocities of high resolution, notes of all kinds. */
void song_write_all(void) {
  song_begin();
  song_add(0, 0x99, 38, 100);
  song_add(60, 0xB9, 16, 90);
  song_add(0, 0xB9, 17, 20);
  song_add(10, 0xB9, 88, 55);
  song_add(0, 0x99, 41, 70);
  song_add(40, 0x99, 36, 127);
  song_add(0, 0x99, 37, 90);
  song_add(7, 0xB9, 20, 10);
  song_add(25, 0xD9, 90, 0);
  song_add(31, 0xD9, 0, 0);
  song_add(1, 0xA9, 38, 30);
  song_add(20, 0xB9, 7, 100);
  song_add(3, 0x99, 40, 80);
  song_add(5, 0xB9, 11, 40);
  song_add(20, 0xB9, 20, 127);
  song_add(0, 0x99, 39, 80);
  song_add(50, 0xB9, 120, 0);
  song_add(4, 0x99, 38, 110);
  song_add(1, 0xB9, 11, 127);
  song_add(0, 0x89, 38, 64);
  song_add(30, 0x99, 60, 100);
  song_add(30, 0x99, 48, 20);
  song_end();
}

void song_write_presets(void) {
  uint8_t presets[3] = {0, 1, 0}; /* tabor and frame-drum, which continue nothing of each other */
  song_begin();
  song_add(0, 0xC9, presets[0], 0);
  song_add(0, 0x99, 38, 100);
  song_add(200, 0xC9, presets[1], 0);
  song_add(0, 0x99, 38, 90);
  song_add(100, 0xC9, presets[2], 0);
  song_add(20, 0x99, 38, 90);
  song_end();
}

void song_begin_ringing(void) {
  song_begin();
  song_add(0, 0x99, 38, 110);
}

void song_end_struck(void) {
  song_add(100, 0x99, 38, 100);
  song_end();
}

/* To a drum without a stereo pair. */
void song_write_other_mics(void) {
  song_begin_ringing();
  song_add(200, 0xC9, TOM, 0);
  song_end_struck();
}

void song_write_two_at_once(void) {
  song_begin_ringing();
  song_add(100, 0xC9, LOOSE, 0);
  song_add(0, 0xC9, PICCOLO, 0);
  song_add(0, 0x99, 38, 90);
  song_add(100, 0xC9, MARCHING, 0);
  song_add(0, 0xC9, LOOSE, 0);
  song_end_struck();
}

/* What is moved stays, since nothing changes; then there is a real change. */
void song_write_there_and_back(void) {
  song_begin();
  song_add(0, 0xC9, LOOSE, 0);
  song_add(0, 0x99, 38, 110);
  song_add(20, 0xB9, 20, 0);
  song_add(30, 0xC9, TOM, 0);
  song_add(0, 0xC9, PICCOLO, 0);
  song_add(0, 0xC9, LOOSE, 0);
  song_add(20, 0x99, 38, 80);
  song_add(50, 0xC9, TOM, 0);
  song_add(0, 0xC9, LOOSE, 0);
  song_add(0, 0xC9, SNARE, 0);
  song_end_struck();
}

/* More drums leave within 30 ms, which are 28.8 ticks, than may at once; and one while it rings. */
void song_write_one_after_the_other(void) {
  static const uint8_t presets[] = {TOM, SNARE, LOOSE, MARCHING, 0, 1, PICCOLO};
  song_begin_ringing();
  song_add(100, 0x99, 38, 100);
  for (uint32_t i = 0; i < sizeof presets; i++) {
    song_add(i == 0 ? 20 : 4, 0xC9, presets[i], 0);
    song_add(0, 0x99, 38, 90);
  }
  song_add(60, 0xC9, LOOSE, 0);
  song_end_struck();
}

/* Strainer and grip begin anew, on a drum that could continue this one. */
void song_write_moved_before(void) {
  song_begin_ringing();
  song_add(10, 0xB9, 20, 0);
  song_add(0, 0xB9, 1, 127);
  song_add(40, 0x99, 38, 90);
  song_add(50, 0xC9, LOOSE, 0);
  song_add(0, 0x99, 38, 90);
  song_add(30, 0xB9, 120, 0); /* what was moved before the change does not come back */
  song_add(0, 0x99, 38, 90);
  song_add(30, 0xC9, SNARE, 0);
  song_add(0, 0xB9, 20, 20);
  song_add(0, 0x99, 38, 90);
  song_add(40, 0xB9, 20, 90);
  song_add(0, 0xC9, LOOSE, 0);
  song_end_struck();
}

/* Silences before, with and after changes, and changes while they fade. */
void song_write_silences(void) {
  song_begin_ringing();
  song_add(50, 0xB9, 120, 0);
  song_add(0, 0xC9, LOOSE, 0);
  song_add(0, 0x99, 38, 90);
  song_add(50, 0xC9, TOM, 0);
  song_add(3, 0xB9, 123, 0);
  song_add(2, 0xC9, PICCOLO, 0);
  song_add(5, 0xC9, TOM, 0);
  song_add(0, 0x99, 38, 90);
  song_add(40, 0xC9, SNARE, 0);
  song_add(0, 0xB9, 120, 0);
  song_add(0, 0xC9, TOM, 0);
  song_end_struck();
}

/* Changes between silences, and controllers and strokes between them. */
void song_write_stacked_silences(void) {
  song_begin_ringing();
  song_add(100, 0xB9, 120, 0);
  song_add(1, 0xC9, LOOSE, 0);
  song_add(1, 0xB9, 120, 0);
  song_add(1, 0xC9, SNARE_OFF, 0);
  song_add(1, 0xB9, 20, 127);
  song_add(6, 0x99, 38, 100);
  song_add(100, 0xB0, 123, 0);
  song_add(0, 0xB1, 123, 0);
  song_add(1, 0xC9, LOOSE, 0);
  song_add(2, 0x99, 38, 120); /* silent before it sounds */
  song_add(0, 0xB9, 20, 30);
  song_add(0, 0xB9, 123, 0);
  song_add(1, 0x99, 38, 100);
  song_add(1, 0xC9, SNARE_OFF, 0); /* beside which the stroke rings out */
  song_add(0, 0xB9, 20, 127);
  song_add(6, 0x99, 38, 100);
  song_end_struck();
}

/* What hosts send when they stop, on all channels. */
void song_write_panic(void) {
  static const uint8_t controllers[] = {120, 123, 121, 7, 11};
  song_begin_ringing();
  song_add(70, 0xB9, 20, 90);
  for (uint32_t i = 0; i < 16 * sizeof controllers; i++) {
    const uint8_t controller = controllers[i % sizeof controllers];
    const uint8_t value = controller == 7 ? 100 : controller == 11 ? 127 : 0;
    song_add(i == 0 ? 30 : 0, (uint8_t)(0xB0 + i / sizeof controllers), controller, value);
  }
  song_add(40, 0xC9, PICCOLO, 0);
  song_add(0, 0x99, 38, 90);
  song_end_struck();
}

/* More than may wait: of gains the last counts. */
void song_write_many_gains(void) {
  song_begin_ringing();
  for (uint32_t i = 0; i < 100; i++) song_add(i == 0 ? 100 : 0, 0xB9, 7, (uint8_t)(i * 37 % 128));
  song_add(50, 0xB9, 120, 0);
  for (uint32_t i = 0; i < 300; i++)
    song_add(i % 30 == 1, 0xB9, i % 2 ? 7 : 11, (uint8_t)(127 - i % 64));
  song_add(2, 0x99, 38, 110);
  song_end_struck();
}

/* At a tempo of four ticks a frame, of which those of one frame act together, controllers and
 * changes before notes. */
void song_write_within_a_frame(void) {
  song_begin();
  midi_write_tempo(&song.writer, 0, DIVISION * 1000000 / 192000);
  song_add(0, 0x99, 38, 100);
  song_add(20000, 0x99, 38, 90);
  song_add(1, 0xB9, 16, 127);
  song_add(19999, 0x99, 38, 90);
  song_add(1, 0xC9, TOM, 0);
  song_add(19999, 0xB9, 20, 30);
  song_add(0, 0x99, 41, 90);
  song_add(1, 0xC9, SNARE_OFF, 0);
  song_add(19999, 0x99, 38, 100);
  song_end();
}

/* Heads of other sizes than the first one's, struck near the rim and elsewhere. */
void song_write_sizes(void) {
  static const uint8_t presets[] = {0, 13, TOM, 1};
  song_begin_ringing();
  song_add(0, 0xB9, 16, 127);
  for (uint32_t i = 0; i < sizeof presets; i++) {
    song_add(60, 0xC9, presets[i], 0);
    song_add(0, 0x99, 38, 90);
    song_add(30, 0x99, 40, 80);
    if (i == 1) song_add(0, 0xB9, 16, 30);
  }
  song_end_struck();
}

static uint8_t below(uint64_t *random, uint32_t end) {
  return (uint8_t)(midi_random(random) % end);
}

static void add_any(uint64_t *random) {
  static const uint8_t controllers[] = {120, 123, 20, 20, 7, 11, 16, 17, 1, 88};
  const uint32_t delta = below(random, 3) == 0 ? below(random, 30) : below(random, 3);
  const uint8_t channel = below(random, 16), kind = below(random, 10);
  if (kind < 4) {
    song_add(delta, 0x90 | channel, (uint8_t)(36 + below(random, 15)), below(random, 128));
  } else if (kind < 7) {
    song_add(delta, 0xB0 | channel, controllers[below(random, sizeof controllers)],
             below(random, 128));
  } else if (kind < 9) {
    song_add(delta, 0xC0 | channel, (uint8_t)(SNARE + below(random, 3)), 0);
  } else {
    song_add(delta, 0xD0 | channel, (uint8_t)(100 * below(random, 2)), 0);
  }
}

void song_write_random(uint64_t seed) {
  song_begin_ringing();
  for (uint32_t i = 0; i < (brief ? 50 : 120); i++) add_any(&seed);
  song_add(1, 0x99, 38, 100);
  song_end();
}

/* ---- kits ----------------------------------------------------------------------------------- */

enum { FIRST_SOUND = 47 };

static double between(uint64_t *random, double least, double most) {
  return least + (most - least) * (double)(midi_random(random) % 1000) / 999;
}

/* Every third note from `first` on, of those that random songs play and that have no sound. */
static void write_notes(FILE *file, uint32_t first, uint32_t drums) {
  fprintf(file, "head = %u", 36u + first);
  for (uint32_t note = 36 + first + drums; note < FIRST_SOUND; note += drums)
    fprintf(file, ",%u", note);
  fprintf(file, "\n");
}

static void write_drum(FILE *file, uint32_t number, uint32_t drums, uint64_t *random) {
  const TaborPresetInfo *const preset =
    tabor_preset((uint32_t)(midi_random(random) % tabor_preset_count()));
  fprintf(file, "[drum.d%u]\npreset = %s\n", number, preset->name);
  fprintf(file, "x = %.3f\ny = %.3f\nheight = %.3f\n", between(random, -1, 1),
          between(random, -1, 1), between(random, 0.3, 0.9));
  fprintf(file, "tilt = %.0f\nfacing = %.0f\n", between(random, 0, 90), between(random, 0, 360));
  fprintf(file, "gain = %.2f\npan = %.3f\nwake = %.2f\nchoke = %u\n", between(random, -30, -12),
          between(random, -1, 1), between(random, 0.1, 2), below(random, 3));
  fprintf(file, "strike.velocity = %.3f\n", between(random, 1, 6));
  write_notes(file, number, drums);
}

/* Noise that falls, of `channels` channels at `rate`. */
static void write_sound(const char *name, int channels, int rate, uint64_t *random) {
  enum { SOUND_FRAMES = 6000 };
  char path[256];
  SF_INFO info = {
    .samplerate = rate, .channels = channels, .format = SF_FORMAT_WAV | SF_FORMAT_PCM_16};
  song_path(path, sizeof path, name);
  SNDFILE *const file = sf_open(path, SFM_WRITE, &info);
  assert_non_null(file);
  for (int i = 0; i < SOUND_FRAMES; i++) {
    float frame[2];
    for (int k = 0; k < 2; k++) {
      frame[k] = (float)(between(random, -0.05, 0.05) * (SOUND_FRAMES - i) / SOUND_FRAMES);
    }
    assert_int_equal(sf_writef_float(file, frame, 1), 1);
  }
  assert_int_equal(sf_close(file), 0);
}

/* The highest notes that random songs play: sounds beside the kit's file, of its own rate and of
 * another one. */
static void write_sounds(FILE *file, uint64_t *random) {
  static const char *const names[] = {"sound-one.wav", "sound-pair.wav"};
  write_sound(names[0], 1, 44100, random);
  write_sound(names[1], 2, 48000, random);
  for (uint32_t note = FIRST_SOUND; note <= 50; note++) {
    fprintf(file, "[note.%u]\nsample = %s\ngain = %.1f\nchoke = %u\n", note, names[note % 2],
            between(random, -12, 0), below(random, 2));
  }
}

/* So soft that play, which clips what is beyond full scale, has nothing to clip. */
void kit_write_random(uint64_t seed) {
  static const char *const rooms[] = {"none", "booth", "studio", "hall"};
  const uint32_t drums = 1u + below(&seed, brief ? 2 : 4);
  char path[256];
  song_path(path, sizeof path, "kit.ini");
  FILE *const file = fopen(path, "w");
  assert_non_null(file);
  fprintf(file, "[kit]\nname = random\noverheads = %.2f\n", between(&seed, -24, -6));
  if (below(&seed, 3) == 0) {
    fprintf(file, "coupling = off\n");
  } else {
    fprintf(file, "coupling = %.2f\n", between(&seed, -12, 12));
  }
  fprintf(file, "[room]\nkind = %s\n", rooms[below(&seed, 4)]);
  for (uint32_t i = 0; i < drums; i++) write_drum(file, i, drums, &seed);
  write_sounds(file, &seed);
  assert_int_equal(fclose(file), 0);
}

/* ---- both ways ------------------------------------------------------------------------------ */

void take_open(Take *take, uint32_t channels) {
  *take = (Take){.frames = brief ? MOST_FRAMES / 2 : MOST_FRAMES, .channels = channels};
  for (uint32_t i = 0; i < channels; i++) {
    take->sound[i] = calloc(MOST_FRAMES, sizeof(float));
    assert_non_null(take->sound[i]);
  }
}

void take_close(Take *take) {
  for (uint32_t i = 0; i < take->channels; i++) free(take->sound[i]);
}

void take_read(const char *path, Take *take) {
  SF_INFO info = {0};
  SNDFILE *const file = sf_open(path, SFM_READ, &info);
  assert_non_null(file);
  assert_int_equal(info.channels, take->channels);
  assert_int_equal(info.frames, take->frames);
  float frame[TAKE_CHANNELS];
  for (uint32_t at = 0; at < take->frames; at++) {
    assert_int_equal(sf_readf_float(file, frame, 1), 1);
    for (uint32_t i = 0; i < take->channels; i++) take->sound[i][at] = frame[i];
  }
  sf_close(file);
}

/* What plugins and play do unless they are told otherwise, and render does not. */
static const char *scatter_of(const char *command_name, const char *options) {
  const bool is_asked = strncmp(command_name, "render", 6) == 0 && !strstr(options, "--humanize");
  return is_asked ? " --humanize " HUMANIZE_LIVE_TEXT : "";
}

/* As the program has it, by one of these commands. */
void take_from(const char *command_name, const char *options, const char *const *mics, Take *take) {
  char command[1024], path[256];
  size_t length =
    (size_t)snprintf(command, sizeof command,
                     QUOTED("%s") " %s " QUOTED("%s/song.wav") " -q --midi-file " QUOTED(
                       "%s/song.mid") " "
                                      "--format float --duration %s %s%s",
                     program, command_name, folder, folder, brief ? "0.5" : "1", options,
                     scatter_of(command_name, options));
  const bool chosen = strstr(options, "--stereo") || strstr(options, "--kit");
  for (uint32_t i = 0; i < take->channels && !chosen; i++) {
    length += (size_t)snprintf(command + length, sizeof command - length, " --mic %s", mics[i]);
  }
  if (take->channels == 2 && !chosen) {
    const char *const room = strstr(options, "room.kind") ? "" : " --set room.kind=none";
    (void)snprintf(command + length, sizeof command - length, " --gain %g%s", STEREO_GAIN_DB, room);
  }
  assert_int_equal(run_command(command), 0);
  song_path(path, sizeof path, "song.wav");
  if (!strstr(options, "--split")) take_read(path, take);
}

double take_peak(const Take *take) {
  double peak = 0;
  for (uint32_t i = 0; i < take->channels; i++) {
    for (uint32_t at = 0; at < take->frames; at++) {
      peak = fmax(peak, fabs((double)take->sound[i][at]));
    }
  }
  return peak;
}

void take_compare(const Take *expected, const Take *take, uint32_t block) {
  for (uint32_t i = 0; i < take->channels; i++) {
    for (uint32_t at = 0; at < take->frames; at++) {
      if (expected->sound[i][at] == take->sound[i][at]) continue;
      fail_msg("runs of %u, channel %u, frame %u: %.9g, not %.9g", (unsigned)block, (unsigned)i,
               (unsigned)at, (double)take->sound[i][at], (double)expected->sound[i][at]);
    }
  }
  assert_true(take_peak(take) > 1e-4); /* a cymbal that hums along is heard, too */
}

/* SPDX-License-Identifier: MIT */
/**
 * @file plugin_songs.h
 * MIDI files that a plugin is to play as the program does, to the bit, and what the program makes
 * of them. Any failure fails the test.
 */
#ifndef TABOR_TESTS_PLUGIN_SONGS_H
#define TABOR_TESTS_PLUGIN_SONGS_H

#include <stdbool.h>
#include <stddef.h>

#include "midi/midi_stream.h"
#include "midi_writer.h"

#define DIVISION 480 /**< ticks of a quarter, which is half a second */
#define MOST_FRAMES 48000
#define MOST_MESSAGES 512
#define TAKE_CHANNELS 18

/** A MIDI message at its frame. */
typedef struct HostMessage {
  uint64_t frame;
  MidiMessage message;
} HostMessage;

typedef struct Song {
  MidiWriter writer;
  HostMessage messages[MOST_MESSAGES];
  size_t count;
} Song;

/** The song that was written last. */
extern Song song;

/* Programs, as `tabor presets` lists them. */
enum { SNARE = 5, SNARE_OFF, LOOSE, PICCOLO, MARCHING, TOM };

/** Makes a folder for the songs. @p shorter: for builds that take ten times as long. */
bool songs_begin(const char *tabor, bool shorter);
/** Removes the folder. */
bool songs_end(void);
void song_path(char *path, size_t size, const char *name); /**< of a file in the folder */

void song_begin(void);
/** Adds a message @p delta ticks after the one before. */
void song_add(uint32_t delta, uint8_t status, uint8_t first, uint8_t second);
/** Writes the file, and reads from it what the plugin is to get at which frames. */
void song_end(void);
void song_begin_ringing(void); /**< with a stroke */
void song_end_struck(void);    /**< with another one */

void song_write_all(void);
void song_write_presets(void);
void song_write_other_mics(void);
void song_write_two_at_once(void);
void song_write_there_and_back(void);
void song_write_one_after_the_other(void);
void song_write_moved_before(void);
void song_write_silences(void);
void song_write_stacked_silences(void);
void song_write_panic(void);
void song_write_many_gains(void);
void song_write_within_a_frame(void);
void song_write_sizes(void);
void song_write_random(uint64_t seed);
/** Writes the file kit.ini: random drums, places, notes, levels, room. */
void kit_write_random(uint64_t seed);

typedef struct Take {
  uint32_t frames, channels;
  float *sound[TAKE_CHANNELS];
} Take;

void take_open(Take *take, uint32_t channels);
void take_close(Take *take);
/**
 * Lets `tabor COMMAND` with @p options play the song: with --stereo among them at the pair,
 * otherwise at these microphones, two of them at the level of the stereo plugin's pair and in free
 * air, if @p options have no room. With
 * --kit it is the kit's mix; with --split, too, nothing is read.
 */
void take_from(const char *command_name, const char *options, const char *const *mics, Take *take);
/** Reads a sound file of as many channels and frames. */
void take_read(const char *path, Take *take);
/** Largest absolute sample, over all channels. */
double take_peak(const Take *take);
/** Compares all samples; @p block is for the message. A silent take fails, too. */
void take_compare(const Take *expected, const Take *take, uint32_t block);

#endif

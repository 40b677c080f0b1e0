/* SPDX-License-Identifier: MIT */
/**
 * @file kit_take.h
 * A kit that is played into sound files: into its stereo mix, or into a stereo file for each drum.
 */
#ifndef TABOR_HOST_KIT_TAKE_H
#define TABOR_HOST_KIT_TAKE_H

#include "base/options.h"
#include "files/audio_file.h"
#include "kit/kit_sample_files.h"
#include "kit/kit_song.h"
#include "render/render_file.h"

/** How a kit's sound is written. */
typedef struct KitFormat {
  AudioFormat audio; /**< of two channels; the container is chosen by the name */
  double gain;       /**< factor */
  double gain_db;    /**< the same [dB] */
  uint32_t frames;   /**< length, or 0: until the kit has died away */
} KitFormat;

typedef struct KitTake {
  TaborKit *kit;       /**< the take's own */
  KitSong song;        /**< likewise; its events are used up */
  KitSamples *samples; /**< of notes that play no drum, or NULL */
  KitFormat format;
  bool split;                          /**< a file for each drum, without room and samples */
  OutputFile outputs[TABOR_KIT_DRUMS]; /**< planned: one, or one for each drum */
  uint32_t output_count;
  /* While it is played. */
  AudioFile files[TABOR_KIT_DRUMS];
  float sound[TABOR_KIT_DRUMS][2][AUDIO_BLOCK];
  size_t next_event;
  float block_peak;
  double loudest; /**< energy [J] */
  /* What came of it. */
  uint32_t position; /**< frames written */
  double peak;       /**< with the gain */
  double computing;  /**< processor time of all threads [s] */
  bool sounding;     /**< the kit still sounds at the end */
} KitTake;

/** Seconds after the last event for which a kit rings at most. */
#define KIT_TAKE_MOST_TIME 20.0

/** Reads --format, --gain, --duration, --rate and --quality for @p kit. */
Outcome kit_format_read(const Arguments *arguments, const TaborKitDef *kit,
                        TaborModelOptions *model, KitFormat *format);
/** Initialises without kit, song and outputs. */
void kit_take_begin(KitTake *take);
/** Writes the files, and gives them their names. @p played, which may be NULL, hears how far it is. */
Outcome kit_take_write(KitTake *take, PlayedFn *played, void *context);
/** What one drum has played and dropped. */
TaborStatistics kit_take_statistics(const KitTake *take, uint32_t drum);
/** Warns of saturation, with the gain that avoids it, and of dropped events. */
void kit_take_warn(const KitTake *take);
void kit_take_free(KitTake *take);

#endif

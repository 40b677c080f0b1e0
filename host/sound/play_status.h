/* SPDX-License-Identifier: MIT */
/**
 * @file play_status.h
 * A snapshot of a drum that is being played, for display: a copy, in plain numbers and text.
 */
#ifndef TABOR_HOST_PLAY_STATUS_H
#define TABOR_HOST_PLAY_STATUS_H

#include <stdbool.h>
#include <tabor/tabor.h>

typedef struct PlayStatus {
  /* source and device */
  char preset[TABOR_TEXT_SIZE];
  bool building;                /**< a new model is being built */
  uint32_t quality;             /**< a TaborQuality; 0 if unknown */
  char device[TABOR_TEXT_SIZE]; /**< "JACK: system" */
  double rate;                  /**< [Hz] */
  uint32_t buffer;              /**< frames that the device asks for at once */
  double latency;               /**< from an event to its sound [s] */
  double time;                  /**< played so far [s] */
  /* sound, since the last snapshot */
  uint32_t channels;
  double peak[TABOR_MAX_MICS]; /**< largest absolute sample, before clipping */
  double loudest;              /**< peak of all channels, since the start */
  double gain;                 /**< output gain, a factor */
  uint64_t clipped;            /**< samples clipped to full scale, since the start */
  /* load: computing time of a block divided by its duration */
  double load_median, load_worst; /**< since the last snapshot */
  uint64_t xruns;                 /**< dropouts of the device, since the start */
  /* the drum, since the start */
  bool sleeping;      /**< all sound has died away */
  uint32_t strikers;  /**< strikers and hands in play now */
  double newton_mean; /**< iterations per solve */
  uint32_t newton_max;
  uint64_t newton_capped; /**< solves stopped at the cap */
  uint64_t recovered;     /**< resets after a state that was not finite */
  uint64_t strokes;       /**< strokes begun */
  uint64_t late;          /**< events that arrived after their frame */
  uint64_t dropped;       /**< events lost: a queue was full, or the drum could not execute them */
  uint64_t ignored_notes; /**< live MIDI notes that are not in the map */
  TaborEvent last_event;  /**< the last one executed; type 0: none yet */
  double last_time;       /**< its time [s] */
  /* recording */
  bool recording;
  uint64_t lost_frames; /**< frames recorded as silence because the disk was too slow */
} PlayStatus;

#endif

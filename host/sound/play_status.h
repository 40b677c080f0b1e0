/* SPDX-License-Identifier: MIT */
/**
 * @file play_status.h
 * What there is to show of a drum that is being played: plain numbers and texts, a copy.
 */
#ifndef TABOR_HOST_PLAY_STATUS_H
#define TABOR_HOST_PLAY_STATUS_H

#include <stdbool.h>
#include <tabor/tabor.h>

typedef struct PlayStatus {
  /* what plays */
  char preset[TABOR_TEXT_SIZE];
  bool building;                /**< a changed drum is being computed */
  uint32_t quality;             /**< a TaborQuality; 0 if nobody says */
  char device[TABOR_TEXT_SIZE]; /**< "JACK: system" */
  double rate;                  /**< [Hz] */
  uint32_t buffer;              /**< frames that the device asks for at once */
  double latency;               /**< from an event to its sound [s] */
  double time;                  /**< played so far [s] */
  /* sound, since the last look */
  uint32_t channels;
  double peak[TABOR_MAX_MICS]; /**< largest sample in size, before clipping */
  double loudest;              /**< of all channels, since the beginning */
  double gain;                 /**< of the output, factor */
  uint64_t clipped;            /**< samples cut to full scale, since the beginning */
  /* computing; a block's load is its computing time by the time that it lasts */
  double load_median, load_worst; /**< since the last look */
  uint64_t xruns;                 /**< gaps that the device had, since the beginning */
  /* the drum, since the beginning */
  bool sleeping;      /**< everything has died away */
  uint32_t strikers;  /**< strikers and hands in play now */
  double newton_mean; /**< iterations a solve */
  uint32_t newton_max;
  uint64_t newton_capped; /**< solves stopped at the cap */
  uint64_t recovered;     /**< resets after a state that was not finite */
  uint64_t strokes;       /**< strokes begun */
  uint64_t late;          /**< events that came after their frame */
  uint64_t dropped;       /**< events that found no room, or that nothing could carry out */
  uint64_t ignored_notes; /**< live MIDI notes that are not in the map */
  TaborEvent last_event;  /**< the newest that was carried out; type 0: none yet */
  double last_time;       /**< when that was [s] */
  /* recording */
  bool recording;
  uint64_t lost_frames; /**< of the recording: what the disk was too slow for is silence there */
} PlayStatus;

#endif

/* SPDX-License-Identifier: MIT */
/**
 * @file kit_sounds.h
 * Sound files that stand for what a kit does not model: hi-hat, cymbals, hand percussion. A section
 * of a kit file,
 *
 *     [note.42]
 *     sample = hat.wav    ; beside the kit file; mono or stereo
 *     gain = -6           ; dB, -120 to 24
 *     choke = 1           ; 0 (none) to 15: a stroke fades others of the same group within 15 ms
 *
 * plays the file at each stroke on the note, (velocity/127)^2 as loud, and fades it when its key is
 * pressed.
 */
#ifndef TABOR_HOST_KIT_SOUNDS_H
#define TABOR_HOST_KIT_SOUNDS_H

#include <tabor/kit.h>

/** A sound file in memory. */
typedef struct KitSound {
  float
    *side[2]; /**< of malloc(): left, NULL if there is no sound, and right, NULL if it is mono */
  uint32_t frames;
  double rate; /**< [Hz] */
} KitSound;

/** Reads a file. False: nothing more is to be read, and what is wrong has been said. */
typedef bool KitSoundFn(void *context, const char *name, KitSound *sound);

/** Gives the kit, which does not play yet, the sounds of its definition. TABOR_ERROR_CANCELLED if
 * @p read returned false; errors of tabor_kit_set_sample(). */
TaborStatus kit_samples_load(TaborKit *kit, KitSoundFn *read, void *context, TaborError *error);

#endif

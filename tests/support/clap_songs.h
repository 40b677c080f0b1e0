/* SPDX-License-Identifier: MIT */
/**
 * @file clap_songs.h
 * The host for the CLAP plugins plays the songs that a plugin is to play as the program does.
 */
#ifndef TABOR_TESTS_CLAP_SONGS_H
#define TABOR_TESTS_CLAP_SONGS_H

#include "clap_host.h"
#include "plugin_songs.h"

/** Plays the song in blocks of @p block frames; 0: of random sizes. Takes channels from @p first
 * on. */
void clap_host_play(ClapHost *host, uint32_t block, uint32_t first, Take *take);

#endif
